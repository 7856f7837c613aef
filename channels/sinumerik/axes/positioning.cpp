// Positioning axes: POS, POSA, POSP, their feed FA and where it comes from, revolutional feeds of
// single axes (sinumerik_part1 8.2, 8.5). They move asynchronously to the path of their block, each
// with its own feed; POSP behind it, part by part.
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr unsigned kMostFeeds = 5;  // FA in a block

bool positions(std::string_view name) { return name == "POS" || name == "POSA" || name == "POSP"; }

}  // namespace

// FA[axis], FA[S2]: feed of a positioning axis, mm/min or deg/min; with FPRAON mm/rev.
bool Interpreter::a_axis_feed(const Word& word) {
    unsigned count = 0;
    for (const Word& other : block_.words) count += other.address == word.address;
    if (count > kMostFeeds) return fail_word(Alarm::FunctionsTooMany, word, "FA");
    if (word.number() <= 0) return fail_word(Alarm::ValueOutOfRange, word, "FA");
    // of the positions that follow, that of its own block included (8.4, 8.5)
    if (word.axis < 0) {
        const int n = word.index > 0 ? word.index : modal_.master_spindle;
        if (n < 1 || n > static_cast<int>(kMaxSpindles) ||
            !core_.view().machine.spindle(static_cast<std::size_t>(n)).exists())
            return fail_word(Alarm::SpindleNumberIllegal, word, {}, n);
        modal_.spindle_feed[static_cast<std::size_t>(n)] = word.number();
        return true;
    }
    const bool rotary = core_.view().axes[static_cast<std::size_t>(word.axis)].rotary;
    modal_.axis_feed[static_cast<std::size_t>(word.axis)] =
        word.number() * (rotary ? 1.0 : feed_unit());
    return true;
}

// A spindle as FPR and FPRAON name it: S2, SPI(2); an axis that turns is none here.
bool Interpreter::feed_source(const Argument& argument, std::uint16_t& spindle) {
    const int place = argument.value.type == Type::Axis ? argument.value.place()
                      : argument.value.is_number()
                          ? kSpindleAxis + static_cast<int>(argument.value.number)
                          : -1;
    const int n = place - kSpindleAxis;
    if (place >= 0 && n < 1) return fail(Alarm::NotBuilt, "FPR, FPRAON: " + axis_name(place));
    if (n < 1 || n > static_cast<int>(kMaxSpindles) ||
        !core_.view().machine.spindle(static_cast<std::size_t>(n)).exists())
        return fail(Alarm::SpindleNumberIllegal, {}, n);
    spindle = static_cast<std::uint16_t>(n);
    return true;
}

bool Interpreter::p_feed_per_revolution(Call& c) {  // FPR
    modal_.feed_spindle = 0;
    return c.arguments.empty() || feed_source(c.arguments[0], modal_.feed_spindle);
}

bool Interpreter::p_axis_per_revolution(Call& c) {  // FPRAON, FPRAOF
    const bool on = block_.procedures.front().first->name == "FPRAON";
    for (std::size_t k = 0; k < (on ? 1 : c.arguments.size()); ++k) {
        if (!c.has(k) || c.value(k).type != Type::Axis)
            return fail(Alarm::AxisArgumentMissing, on ? "FPRAON" : "FPRAOF");
        const int place = c.value(k).place();
        if (place >= kSpindleAxis) return fail(Alarm::NotBuilt, "FPRAON(S)");
        const auto i = static_cast<std::size_t>(place);
        std::uint16_t spindle = modal_.master_spindle;
        if (on && c.has(1) && !feed_source(c.arguments[1], spindle)) return false;
        modal_.per_revolution =
            on ? modal_.per_revolution | 1u << i : modal_.per_revolution & ~(1u << i);
        modal_.axis_feed_spindle[i] = spindle;
    }
    return true;
}

// One straight move of one axis with its own feed; without FA that of MD32060, else in rapid.
bool Interpreter::drive_positioning_axis(std::size_t i, const AxisValues& target) {
    double feed = modal_.axis_feed[i];
    if (core_.meets_stop() >> i & 1u) {  // FXS: on the path, which waits for the stop
        const double fast = feed > 0 ? feed : core_.view().axes[i].rapid_mm_min;
        return core_.stop_alone(target, fast);
    }
    if (feed <= 0)
        feed = params::get(core_.view().table(), params::md32060,
                           core_.view().axes[i].machine_axis + 1u);
    const bool per_revolution = modal_.per_revolution >> i & 1u;
    return core_.beside(static_cast<unsigned>(i), target, feed, per_revolution,
                        per_revolution ? modal_.axis_feed_spindle[i] : std::uint16_t{0});
}

// POSP[axis]=(end, part, mode): mode 0 full parts, the last two share the rest; mode 1 equal parts
// of at most that length.
bool Interpreter::drive_in_parts(const Word& word, AxisValues target) {
    const auto i = static_cast<std::size_t>(word.axis);
    const double start = core_.path.programmed[i], way = std::fabs(target[i] - start),
                 sign = target[i] < start ? -1.0 : 1.0, end = target[i];
    const double length = word.further.empty() ? 0.0
                                               : word.further[0].number *
                                                     (core_.view().axes[i].rotary ? 1.0 : unit());
    const double mode = word.further.size() > 1 ? word.further[1].number : 0.0;
    if (!(length > 0) || way / length > 10'000)
        return fail_word(Alarm::ValueOutOfRange, word, "POSP");
    if (mode != 0 && mode != 1) return fail_word(Alarm::ValueOutOfRange, word, "POSP");
    const double equal = way / std::fmax(1.0, std::ceil(way / length - 1e-9));
    for (double done = 0.0; way - done > 1e-9;) {
        const double rest = way - done;
        double step = mode == 1                  ? equal
                      : rest > 2 * length + 1e-9 ? length
                      : rest > length + 1e-9     ? rest / 2
                                                 : rest;
        if (mode == 0 && rest <= 2 * length + 1e-9 && rest > length + 1e-9) {  // the last two
            target[i] = start + sign * (done + step);
            if (!drive_positioning_axis(i, target)) return false;
            done += step;
            step = way - done;
        }
        done = way - done - step < 1e-9 ? way : done + step;
        target[i] = done >= way ? end : start + sign * done;
        if (!drive_positioning_axis(i, target)) return false;
    }
    return true;
}

// POS and POSA begin with their block. `wait`: those that the block waits for.
bool Interpreter::start_positioning(AxisSet& wait) {
    for (const Word& word : block_.words) {
        if (!positions(word.address->name) || word.address->name == "POSP") continue;
        if (!position_axis(word)) return false;
        if (word.address->name == "POS") wait |= 1u << word.axis;
    }
    return true;
}

bool Interpreter::position_in_parts() {
    for (const Word& word : block_.words)
        if (word.address->name == "POSP" &&
            (!position_axis(word) || (core_.arrive(1u << word.axis, 0), false)))
            return false;
    return true;
}

bool Interpreter::position_axis(const Word& word) {
    // POSP0
    if (word.axis < 0)
        return fail_word(Alarm::AxisArgumentMissing, word, std::string(word.address->name));
    const auto i = static_cast<std::size_t>(word.axis);
    if (axis_words() >> i & 1u) return fail_word(Alarm::AddressTwice, word, axis_name(word.axis));
    for (const Word& other : block_.words)
        if (&other != &word && positions(other.address->name) && other.axis == word.axis)
            return fail_word(Alarm::AddressTwice, word, axis_name(word.axis));
    if (!has_axis(word)) return false;
    AxisValues target = core_.path.programmed;
    if (std::any_of(modal_.trails.begin(), modal_.trails.end(),
                    [&](const Trail& one) { return one.leads == i; }))
        return fail_word(Alarm::NotBuilt, word, "TRAILON: " + std::string(word.address->name));
    if (!axis_target(word, target) || !within_areas(target)) return false;
    const bool done = word.address->name == "POSP" ? drive_in_parts(word, target)
                                                   : drive_positioning_axis(i, target);
    if (!done) return false;
    modal_.pending_zero[i] = modal_.pending_tool[i] = 0.0;
    return true;
}

}  // namespace polyturn::channels::sinumerik
