// What letters and codes mean on this machine, known before the first block: the rows of the G code
// system, the words that each row takes, and the axes behind the letters.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "channels/fanuc/g_codes.hpp"
#include "channels/fanuc/settings.hpp"
#include "channels/machine_view.hpp"

namespace polyturn::channels::fanuc {

struct Vocabulary {
    Vocabulary(const MachineView& view, const Settings& settings);

    bool is_axis(char letter) const { return axis_letters >> (letter - 'A') & 1u; }
    // letters that a row consumes
    std::uint32_t taken_by(const GCode* row) const {
        return takes[static_cast<std::size_t>(row - g_codes().data())];
    }

    GTable table;
    std::vector<std::uint32_t> takes;  // by row of g_codes()
    // letters -> axes, by place; -1 none
    std::array<std::int8_t, 26> absolute_axis{}, incremental_axis{};
    std::uint32_t axis_letters = 0;
};

}  // namespace polyturn::channels::fanuc
