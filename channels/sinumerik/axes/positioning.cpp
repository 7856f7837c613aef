// Positioning axes: POS, POSA, POSP, their feed FA and where it comes from, revolutional feeds of
// single axes (sinumerik_part1 8.2, 8.5). They move asynchronously to the path of their block, each
// with its own feed; POSP behind it, part by part.
#include "channels/sinumerik/axes/positioning.hpp"

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/travel_limits.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr unsigned kMostFeeds = 5;  // FA in a block

bool positions(std::string_view name) { return name == "POS" || name == "POSA" || name == "POSP"; }

// One straight move of one axis with its own feed; without FA that of MD32060, else in rapid.
bool drive_positioning_axis(Execution& x, std::size_t i, const AxisValues& target) {
    double feed = x.modal.axis_feed[i];
    if (x.core.meets_stop() >> i & 1u) {  // FXS: on the path, which waits for the stop
        const double fast = feed > 0 ? feed : x.core.view().axes[i].rapid_mm_min;
        return x.core.stop_alone(target, fast);
    }
    if (feed <= 0)
        feed = params::get(x.core.view().table(), params::md32060,
                           x.core.view().axes[i].machine_axis + 1u);
    const bool per_revolution = x.modal.per_revolution >> i & 1u;
    return x.core.beside(static_cast<unsigned>(i), target, feed, per_revolution,
                         per_revolution ? x.modal.axis_feed_spindle[i] : std::uint16_t{0});
}

// POSP[axis]=(end, part, mode): mode 0 full parts, the last two share the rest; mode 1 equal parts
// of at most that length.
bool drive_in_parts(Execution& x, const Word& word, AxisValues target) {
    const auto i = static_cast<std::size_t>(word.axis);
    const double start = x.core.path.programmed[i], way = std::fabs(target[i] - start),
                 sign = target[i] < start ? -1.0 : 1.0, end = target[i];
    const double length = word.further.empty() ? 0.0
                                               : word.further[0].number *
                                                     (x.core.view().axes[i].rotary ? 1.0 : unit(x));
    const double mode = word.further.size() > 1 ? word.further[1].number : 0.0;
    if (!(length > 0) || way / length > 10'000)
        return fail_word(x, Alarm::ValueOutOfRange, word, "POSP");
    if (mode != 0 && mode != 1) return fail_word(x, Alarm::ValueOutOfRange, word, "POSP");
    const double equal = way / std::fmax(1.0, std::ceil(way / length - 1e-9));
    for (double done = 0.0; way - done > 1e-9;) {
        const double rest = way - done;
        double step = mode == 1                  ? equal
                      : rest > 2 * length + 1e-9 ? length
                      : rest > length + 1e-9     ? rest / 2
                                                 : rest;
        if (mode == 0 && rest <= 2 * length + 1e-9 && rest > length + 1e-9) {  // the last two
            target[i] = start + sign * (done + step);
            if (!drive_positioning_axis(x, i, target)) return false;
            done += step;
            step = way - done;
        }
        done = way - done - step < 1e-9 ? way : done + step;
        target[i] = done >= way ? end : start + sign * done;
        if (!drive_positioning_axis(x, i, target)) return false;
    }
    return true;
}

bool position_axis(Execution& x, const Word& word) {
    // POSP0
    if (word.axis < 0)
        return fail_word(x, Alarm::AxisArgumentMissing, word, std::string(word.address->name));
    const auto i = static_cast<std::size_t>(word.axis);
    if (axis_words(x) >> i & 1u)
        return fail_word(x, Alarm::AddressTwice, word, axis_name(x, word.axis));
    for (const Word& other : x.block.words)
        if (&other != &word && positions(other.address->name) && other.axis == word.axis)
            return fail_word(x, Alarm::AddressTwice, word, axis_name(x, word.axis));
    if (!has_axis(x, word)) return false;
    AxisValues target = x.core.path.programmed;
    if (std::any_of(x.modal.trails.begin(), x.modal.trails.end(),
                    [&](const Trail& one) { return one.leads == i; }))
        return fail_word(x, Alarm::NotBuilt, word, "TRAILON: " + std::string(word.address->name));
    if (!axis_target(x, word, target) || !within_areas(x, target)) return false;
    const bool done = word.address->name == "POSP" ? drive_in_parts(x, word, target)
                                                   : drive_positioning_axis(x, i, target);
    if (!done) return false;
    x.modal.pending_zero[i] = x.modal.pending_tool[i] = 0.0;
    return true;
}

}  // namespace

// FA[axis], FA[S2]: feed of a positioning axis, mm/min or deg/min; with FPRAON mm/rev.
bool a_axis_feed(Execution& x, const Word& word) {
    unsigned count = 0;
    for (const Word& other : x.block.words) count += other.address == word.address;
    if (count > kMostFeeds) return fail_word(x, Alarm::FunctionsTooMany, word, "FA");
    if (word.number() <= 0) return fail_word(x, Alarm::ValueOutOfRange, word, "FA");
    // of the positions that follow, that of its own block included (8.4, 8.5)
    if (word.axis < 0) {
        const int n = word.index > 0 ? word.index : x.modal.master_spindle;
        if (n < 1 || n > static_cast<int>(kMaxSpindles) ||
            !x.core.view().machine.spindle(static_cast<std::size_t>(n)).exists())
            return fail_word(x, Alarm::SpindleNumberIllegal, word, {}, n);
        x.modal.spindle_feed[static_cast<std::size_t>(n)] = word.number();
        return true;
    }
    const bool rotary = x.core.view().axes[static_cast<std::size_t>(word.axis)].rotary;
    x.modal.axis_feed[static_cast<std::size_t>(word.axis)] =
        word.number() * (rotary ? 1.0 : feed_unit(x));
    return true;
}

// A spindle as FPR and FPRAON name it: S2, SPI(2); an axis that turns is none here.
bool feed_source(Execution& x, const Argument& argument, std::uint16_t& spindle) {
    const int place = argument.value.type == Type::Axis ? argument.value.place()
                      : argument.value.is_number()
                          ? kSpindleAxis + static_cast<int>(argument.value.number)
                          : -1;
    const int n = place - kSpindleAxis;
    if (place >= 0 && n < 1) return fail(x, Alarm::NotBuilt, "FPR, FPRAON: " + axis_name(x, place));
    if (n < 1 || n > static_cast<int>(kMaxSpindles) ||
        !x.core.view().machine.spindle(static_cast<std::size_t>(n)).exists())
        return fail(x, Alarm::SpindleNumberIllegal, {}, n);
    spindle = static_cast<std::uint16_t>(n);
    return true;
}

bool p_feed_per_revolution(Execution& x, Call& c) {  // FPR
    x.modal.feed_spindle = 0;
    return c.arguments.empty() || feed_source(x, c.arguments[0], x.modal.feed_spindle);
}

bool p_axis_per_revolution(Execution& x, Call& c) {  // FPRAON, FPRAOF
    const bool on = x.block.procedures.front().first->name == "FPRAON";
    for (std::size_t k = 0; k < (on ? 1 : c.arguments.size()); ++k) {
        if (!c.has(k) || c.value(k).type != Type::Axis)
            return fail(x, Alarm::AxisArgumentMissing, on ? "FPRAON" : "FPRAOF");
        const int place = c.value(k).place();
        if (place >= kSpindleAxis) return fail(x, Alarm::NotBuilt, "FPRAON(S)");
        const auto i = static_cast<std::size_t>(place);
        std::uint16_t spindle = x.modal.master_spindle;
        if (on && c.has(1) && !feed_source(x, c.arguments[1], spindle)) return false;
        x.modal.per_revolution =
            on ? x.modal.per_revolution | 1u << i : x.modal.per_revolution & ~(1u << i);
        x.modal.axis_feed_spindle[i] = spindle;
    }
    return true;
}

// POS and POSA begin with their block. `wait`: those that the block waits for.
bool start_positioning(Execution& x, AxisSet& wait) {
    for (const Word& word : x.block.words) {
        if (!positions(word.address->name) || word.address->name == "POSP") continue;
        if (!position_axis(x, word)) return false;
        if (word.address->name == "POS") wait |= 1u << word.axis;
    }
    return true;
}

bool position_in_parts(Execution& x) {
    for (const Word& word : x.block.words)
        if (word.address->name == "POSP" &&
            (!position_axis(x, word) || (x.core.arrive(1u << word.axis, 0), false)))
            return false;
    return true;
}

}  // namespace polyturn::channels::sinumerik
