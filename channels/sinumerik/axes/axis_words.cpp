// Where the axis words of a block want their axes: modifiers, diameters, units.
#include "channels/sinumerik/axes/axis_words.hpp"

#include <cmath>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/text/number.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {

bool is_incremental(const Execution& x, const Word& word) {
    switch (word.mode) {
        case Mode::IC:
        case Mode::DIC:
        case Mode::RIC:
        case Mode::CIC:
            return true;
        case Mode::Plain:
        case Mode::GP:
        case Mode::QU:
            return !absolute(x);
        default:
            return false;
    }
}
bool counts_diameter(const Execution& x, unsigned place, bool incremental) {
    // of an axis without one the channel means its transverse axis
    const unsigned own = place < kChannelAxes ? x.modal.axis_diameter[place] : 0u;
    const bool as_channel =
        own == kAsChannel || (own == 0 && static_cast<int>(place) == x.settings.diameter_axis);
    const unsigned status = as_channel ? x.modal.active[29] : own ? own : 1u;
    return status == 2 || (status == 3 && !incremental);
}
AxisSet display_swapped(const Execution& x) {
    const MachineView& view = x.core.view();
    AxisSet set = 0;
    for (unsigned i = 0; i < view.axis_count; ++i)
        if (counts_diameter(x, i, false) != view.axes[i].diameter) set |= 1u << i;
    return set;
}
double length_mm(const Execution& x, const Word& word, int place, bool incremental) {
    const MachineView& view = x.core.view();
    double value = word.number();
    if (place < 0) return value * unit(x);
    const auto i = static_cast<unsigned>(place);
    if (view.axes[i].rotary) return value;
    bool diameter = counts_diameter(x, i, incremental);
    if (word.mode == Mode::DAC || word.mode == Mode::DIC) diameter = true;
    if (word.mode == Mode::RAC || word.mode == Mode::RIC) diameter = false;
    return value * unit(x) * (diameter ? 0.5 : 1.0);
}
bool axis_target(Execution& x, const Word& word, AxisValues& target) {
    const auto i = static_cast<std::size_t>(word.axis);
    const ChannelAxis& axis = x.core.view().axes[i];
    const bool incremental = is_incremental(x, word);
    const double value = length_mm(x, word, word.axis, incremental),
                 now = x.core.path.programmed[i];
    if (word.mode >= Mode::CAC && word.mode <= Mode::CACN)
        return fail_word(x, Alarm::NotBuilt, word, "CAC, CIC, CDC");
    if (word.mode == Mode::DC || word.mode == Mode::ACP || word.mode == Mode::ACN) {
        if (!axis.rotary) return fail_word(x, Alarm::AxisKindWrong, word, axis.name);
        if (word.mode != Mode::DC && !axis.rollover)
            return fail_word(x, Alarm::AxisKindWrong, word, axis.name);
        if (!(value >= 0 && value <= 360))
            return fail_word(x, Alarm::ValueOutOfRange, word, axis.name);
        const double period = axis.rollover ? axis.rollover_deg : 360.0;
        double way = std::fmod(value - now, period);
        if (way < 0) way += period;  // the positive way
        if (word.mode == Mode::ACN && way > 0) way -= period;
        if (word.mode == Mode::DC && way > period / 2) way -= period;
        target[i] = now + way;
        return true;
    }
    if (axis.rollover && !x.modal.curve) {  // a curve table has its values as they are written
        target[i] = x.core.rollover_target(static_cast<unsigned>(word.axis), value, !incremental);
        return true;
    }
    if (!incremental) {
        target[i] = value;
        return true;
    }
    target[i] = now + value + (x.settings.zero_travels ? x.modal.pending_zero[i] : 0.0) +
                (x.settings.tool_travels ? x.modal.pending_tool[i] : 0.0);
    return true;
}
// An axis that has been released is taken by naming it where MD30552 says so, as GET takes it
// (sinumerik_part3 7.14): the block is read again behind a barrier, where it is known to which
// place somebody else has driven it.
bool take_back_released_axes(Execution& x) {
    if (!x.modal.released || x.block.coded[3]) return true;  // TRANS Z moves nothing
    AxisSet back = 0;
    for (const Word& w : x.block.words) {
        if (!names_moved_axis(w) || !(x.modal.released >> w.axis & 1u)) continue;
        // has_axis() refuses it
        if (params::get(x.core.view().table(), params::md30552,
                        x.core.view().axes[static_cast<std::size_t>(w.axis)].machine_axis + 1u) ==
            0)
            continue;
        if (x.core.compensating())
            return fail_word(x, Alarm::AxisExchangeIllegal, w, axis_name(x, w.axis));
        back |= 1u << w.axis;
    }
    x.modal.released &= ~back;
    if (back) x.pass.needs_barrier = true;
    return back == 0;
}
bool has_axis(Execution& x, const Word& word) {
    return !(x.modal.released >> word.axis & 1u) ||
           fail_word(x, Alarm::AxisReleased, word, axis_name(x, word.axis));
}
bool read_axis_words(Execution& x, AxisValues& target, AxisSet& named) {
    target = x.core.path.programmed;
    named = 0;
    for (const Word& word : x.block.words) {
        if (word.axis < 0 || word.address->name != "axis") continue;
        if (!has_axis(x, word)) return false;
        if (!axis_target(x, word, target)) return false;
        named |= 1u << word.axis;
    }
    return true;
}
bool names_moved_axis(const Word& word) {
    return word.axis >= 0 && word.axis < kSpindleAxis &&
           (word.address->name == "axis" || word.address->name.starts_with("POS"));
}
AxisSet axis_words(const Execution& x) {
    AxisSet set = 0;
    for (const Word& word : x.block.words)
        if (word.address == &kAxisAddress) set |= 1u << word.axis;
    return set;
}
}  // namespace polyturn::channels::sinumerik
