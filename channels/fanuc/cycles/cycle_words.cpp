#include "channels/fanuc/cycles/cycle_words.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"

namespace polyturn::channels::fanuc {

bool first_of_two(const Execution& x) { return !x.block.has('P') && !x.block.has('Q'); }

// A milling channel uses some of these numbers for drilling (N1611#0).
bool turning_cycles_available(Execution& x, const GCode& row) {
    const bool milling =
        x.core.view().machine.channel(x.core.view().channel).kind == ChannelKind::Mill;
    if (milling && !params::bit(x.core.view().table(), params::n1611_turning_cyc_config,
                                x.core.view().channel, 0))
        return x.core.fail(Alarm::NotBuilt, 'G', std::string(row.name));
    return true;
}

// A length of the first block. Fanuc: it replaces the parameter from now on; nct: for the cycle
// that follows.
void keep_length(Execution& x, std::optional<double>& kept, char letter) {
    if (x.block.has(letter))
        kept = radius_length_of(x, letter);
    else if (x.settings.policy.cycles.first_block_once)
        kept.reset();
}

// U, W of the cycle block: a length along an axis, X as a diameter where the axis is one.
double shift_word(const Execution& x, char letter, PlaneRole role) {
    if (!x.block.has(letter)) return 0.0;
    const MachineView& view = x.core.view();
    const int place = view.axis_by_role(role);
    const bool diameter = place >= 0 && view.axes[static_cast<std::size_t>(place)].diameter;
    return length_of(x, x.block.word(letter), place) * (diameter ? 0.5 : 1.0);
}

// D of series 15 counts the least increment and takes no point (fanuc_lathe 8.4).
bool series15_count(Execution& x, char letter, double& value) {
    const Word& word = x.block.word(letter);
    if (word.has_point && !word.from_expression)
        return x.core.fail(Alarm::PointForbidden, letter, std::string(1, letter));
    value = word.value;
    return true;
}

}  // namespace polyturn::channels::fanuc
