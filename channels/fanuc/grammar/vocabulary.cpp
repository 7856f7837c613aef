#include "channels/fanuc/grammar/vocabulary.hpp"

#include <algorithm>
#include <string_view>

#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

Vocabulary::Vocabulary(const MachineView& view, const Settings& settings) : table(settings.system) {
    absolute_axis.fill(-1);
    incremental_axis.fill(-1);
    for (unsigned i = 0; i < view.axis_count; ++i)
        if (const std::string_view name = view.axes[i].name; name.size() == 1)
            absolute_axis[static_cast<std::size_t>(name[0] - 'A')] = static_cast<std::int8_t>(i);
    static constexpr char kIncrements[][2] = {{'U', 'X'}, {'V', 'Y'}, {'W', 'Z'}, {'H', 'C'}};
    for (const auto& [increment, axis] : kIncrements) {
        if (!settings.policy.words.increment_letters) break;
        const std::int8_t place = absolute_axis[static_cast<std::size_t>(axis - 'A')];
        if (place >= 0 &&
            std::ranges::find(settings.aux_letters, increment) == settings.aux_letters.end() &&
            absolute_axis[static_cast<std::size_t>(increment - 'A')] < 0)
            incremental_axis[static_cast<std::size_t>(increment - 'A')] = place;
    }
    for (std::size_t i = 0; i < 26; ++i)
        if (absolute_axis[i] >= 0 || incremental_axis[i] >= 0) axis_letters |= 1u << i;
    for (const GCode& row : g_codes()) {
        std::uint32_t mask = 0;
        for (const char letter : row.takes)
            mask |= letter == 'x' ? axis_letters : letter_bit(letter);
        takes.push_back(mask);
    }
}

}  // namespace polyturn::channels::fanuc
