#include "channels/fanuc/functions/waits.hpp"

#include <fmt/format.h>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"

namespace polyturn::channels::fanuc {

// A waiting code: digits of P name channels 1 to 9, P=1.12.16 any.
bool wait_code(Execution& x, const Word& word) {
    const MachineConfig& machine = x.core.view().machine;
    const unsigned own = x.core.view().channel;
    std::uint32_t channels = 0;
    if (x.block.has('P')) {
        const Word& p = x.block.word('P');
        std::string digits = p.from_expression ? fmt::format("{:.0f}", p.value)
                                               : std::string(text_of(x, p).substr(1));
        for (std::size_t open; (open = digits.find('(')) != std::string::npos;)
            digits.erase(open, digits.find(')', open) - open + 1);
        const bool list = digits.find('.') != std::string::npos;
        const auto add = [&](unsigned channel) {
            if (channel < 1 || channel > kMaxChannels || !machine.channel(channel).exists())
                return x.core.fail(Alarm::WaitSetIllegal, 'P', std::to_string(channel), word.value);
            channels |= 1u << (channel - 1);
            return true;
        };
        if (digits.find('-') != std::string::npos)
            return x.core.fail(Alarm::WaitSetIllegal, 'P', digits, word.value);
        unsigned number = 0;
        bool any = false;
        for (const char c : digits) {
            if (c >= '0' && c <= '9') {
                number = list ? number * 10 + static_cast<unsigned>(c - '0')
                              : static_cast<unsigned>(c - '0');
                if (number > 1000) number = 1000;
                any = true;
                if (list) continue;
            } else if (c != '.') {
                continue;
            }
            if (any && !add(number)) return false;
            number = 0;
            any = false;
        }
        if (any && !add(number)) return false;
        if (!(channels >> (own - 1) & 1u))
            return x.core.fail(Alarm::WaitSetWithoutSelf, 'P', {}, word.value);
    } else {
        channels = machine.channels_of_group(machine.channel(own).group);
        if (__builtin_popcount(channels) != 2)
            return x.core.fail(Alarm::WaitSetMissing, 'M', {}, word.value);
    }
    x.core.mark_emitted();
    x.core.sink().wait({static_cast<std::int64_t>(word.value), {}, channels, false}, x.core.at);
    x.run.wants_barrier = true;
    return true;
}

}  // namespace polyturn::channels::fanuc
