// Which axes F counts (FGROUP), at which radius (FGREF), which of them holds it back (FL), OVR.
#include "channels/sinumerik/axes/feeds.hpp"

#include <numbers>

#include "channels/sinumerik/act.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/spindles/speed_limits.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// How a command of group 15 counts the feed.
enum class FeedKind : std::uint8_t { Inverse, Linear, Revolution, Same };
FeedKind feed_kind(unsigned number) {
    switch (number) {
        case 1:
        case 6:
            return FeedKind::Inverse;  // G93 G931
        case 2:
        case 7:
        case 8:
        case 9:
            return FeedKind::Linear;  // G94 G961 G971 G942
        case 11:
        case 12:
            return FeedKind::Same;  // G962 G972
        // G95 G96 G97 G952 G973
        default:
            return FeedKind::Revolution;
    }
}
// G96 G961 G962
bool is_surface(unsigned number) { return number == 4 || number == 7 || number == 11; }

// FGREF: a degree counts as a millimetre
constexpr double kDefaultRadius = 360.0 / (2.0 * std::numbers::pi);

// Core's view of FGROUP, FGREF, FL: only when the program has said anything else than the delivery
// state.
void set_feed_path(Execution& x) {
    FeedPath& by = x.core.path.feed_path;
    const MachineView& view = x.core.view();
    const double degree_unit = by.degree_unit;
    by = {};
    by.degree_unit = degree_unit;
    by.scale = x.modal.path_override / 100.0;
    // never beyond the machine's own
    by.rapid_scale = std::fmin(1.0, x.modal.rapid_override / 100.0);
    by.limit_mm_min = x.modal.feed_limit;
    by.active = x.modal.feed_group_set;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const bool geometry = view.axes[i].role == PlaneRole::BasicX ||
                              view.axes[i].role == PlaneRole::BasicY ||
                              view.axes[i].role == PlaneRole::BasicZ;
        const bool counted =
            x.modal.feed_group_set ? (x.modal.feed_group >> i & 1u) != 0 : geometry;
        if (counted) by.counted |= 1u << i;
        if (view.axes[i].rotary &&
            std::fabs((x.modal.feed_radius[i] > 0 ? x.modal.feed_radius[i] : kDefaultRadius) -
                      kDefaultRadius) < 5e-4)
            by.degrees |= 1u << i;
        by.weight[i] = view.axes[i].rotary ? (x.modal.feed_radius[i] > 0 ? x.modal.feed_radius[i]
                                                                         : kDefaultRadius) *
                                                 std::numbers::pi / 180.0
                                           : 1.0;
        by.active = by.active || by.limit_mm_min[i] > 0 ||
                    (view.axes[i].rotary && x.modal.feed_radius[i] > 0);
    }
}

// The kernel has the product; events and $P_S say what the program has said.
bool spindle_share(Execution& x, const Word& word, double share) {
    return with_spindle(x, word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0, [&] {
        const SpindleState& now = x.core.path.spindle;
        if (now.spindle == 0) return fail_word(x, Alarm::SpindleMissing, word, "OVRA");
        x.core.signal("OVRS" + std::to_string(now.spindle), share);
        Spindle again;
        again.spindle = now.spindle;
        again.mode = now.mode;
        again.value = now.mode == SpindleModeCode::SurfaceSpeed ? now.surface_m_min : now.rpm;
        again.speed_changed = again.silent = true;
        if (now.mode == SpindleModeCode::Rpm && again.value > 0)
            x.core.sink().spindle(again, x.core.at);
        return true;
    });
}

}  // namespace

bool p_fgroup(Execution& x, Call& c) {
    AxisSet group = 0;
    for (const Argument& argument : c.arguments) {
        if (!argument.given || argument.value.type != Type::Axis || argument.value.place() < 0 ||
            argument.value.place() >= kSpindleAxis)
            return fail(x, Alarm::AxisArgumentMissing, "FGROUP");
        group |= 1u << argument.value.place();
    }
    x.modal.feed_group = group;
    x.modal.feed_group_set = !c.arguments.empty();
    set_feed_path(x);
    return true;
}

bool a_feed_radius(Execution& x, const Word& word) {  // FGREF[axis]
    if (!x.core.view().axes[static_cast<std::size_t>(word.axis)].rotary)
        return fail_word(x, Alarm::AxisKindWrong, word, axis_name(x, word.axis));
    if (word.number() <= 0) return fail_word(x, Alarm::ValueOutOfRange, word, "FGREF");
    x.modal.feed_radius[static_cast<std::size_t>(word.axis)] = word.number() * unit(x);
    set_feed_path(x);
    return true;
}

bool a_feed_limit(Execution& x, const Word& word) {  // FL[axis]
    x.modal.feed_limit[static_cast<std::size_t>(word.axis)] =
        word.number() *
        (x.core.view().axes[static_cast<std::size_t>(word.axis)].rotary ? 1.0 : feed_unit(x));
    set_feed_path(x);
    return true;
}

bool a_override(Execution& x, const Word& word) {
    if (word.number() < 1 || word.number() > 200)
        return fail_word(x, Alarm::ValueOutOfRange, word, std::string(word.address->name));
    (word.address->name == "OVRRAP" ? x.modal.rapid_override : x.modal.path_override) =
        word.number();
    set_feed_path(x);
    return true;
}

// --- diameters of single axes: DIAMONA[X] and the like

bool g_feed_type(Execution& x, const GCode& code) {
    const unsigned before = active(x, 15);
    const FeedKind old_kind = x.modal.feed_revolution                  ? FeedKind::Revolution
                              : feed_kind(before) == FeedKind::Inverse ? FeedKind::Inverse
                                                                       : FeedKind::Linear;
    FeedKind kind = feed_kind(code.number);
    if (kind == FeedKind::Same) kind = old_kind;
    if (kind != old_kind) {
        x.modal.feed = x.modal.feed_per_tooth = 0.0;  // another kind of feed wants a new F
        x.modal.corner_feed_stale = x.modal.geo.corner_feed > 0;  // and a new FRCM
    }
    x.modal.feed_revolution = kind == FeedKind::Revolution;
    // G942 G952 leave the spindle as it is
    if (code.number == 9 || code.number == 10) return true;
    activate(x, 15, code.number);  // which limits act
    SpindleState& spindle = x.core.path.spindle;
    if (is_surface(code.number)) {
        // SVC ends (7.2 rule 6)
        if (spindle.spindle) x.modal.cutting_speeds &= ~(1u << (spindle.spindle - 1));
        return x.core.surface_speed(true) && refresh_speed(x);
    }
    if (is_surface(before) && spindle.mode == SpindleModeCode::SurfaceSpeed) {
        if (!x.core.surface_speed(false)) return false;
        // G93 G94 G95: the last speed in revolutions
        if (code.number <= 3 || code.number == 6)
            spindle.rpm = limited_speed(x, x.modal.asked_rpm[spindle.spindle]);
        else
            x.modal.asked_rpm[spindle.spindle] = spindle.rpm;
    }
    return refresh_speed(x);
}
bool feed_word(Execution& x, const Word& word) {
    if (const GCode* code = x.block.coded[2]; code && takes(*code, *word.address)) return true;
    if (const GCode* code = motion_code(x); code && takes(*code, *word.address)) return true;
    if (word.index >= 0)  // F2 to F7 hold while an input is on; there is none
        return word.index >= 2 && word.index <= 7
                   ? a_without_effect(x, word)
                   : fail_word(x, Alarm::ArrayIndexIllegal, word, "F", word.index);
    if (word.number() <= 0) return fail_word(x, Alarm::FeedMissing, word);
    x.modal.feed_word_unit = feed_kind(active(x, 15)) == FeedKind::Inverse ? 1.0 : feed_unit(x);
    x.modal.feed = word.number() * x.modal.feed_word_unit;
    x.modal.feed_per_tooth = 0.0;
    return true;
}
bool a_feed(Execution& x, const Word& word) {  // FB
    if (word.number() <= 0) return fail_word(x, Alarm::ValueOutOfRange, word, "FB");
    if (has(x, "F") || has(x, "FD")) return fail_word(x, Alarm::CodesContradict, word, "FB, F");
    x.pass.feed =
        word.number() * (feed_kind(active(x, 15)) == FeedKind::Inverse ? 1.0 : feed_unit(x));
    return true;
}
bool a_feed_tooth(Execution& x, const Word& word) {
    if (!x.modal.feed_revolution) return true;  // outside G95 it has no effect
    x.modal.feed_per_tooth = word.number() * feed_unit(x);
    x.modal.feed = 0.0;
    return true;
}
bool update_feed(Execution& x) {
    PathState& path = x.core.path;
    path.feed_mode = x.modal.feed_revolution                         ? FeedMode::PerRevolution
                     : feed_kind(active(x, 15)) == FeedKind::Inverse ? FeedMode::InverseTime
                                                                     : FeedMode::PerMinute;
    double feed = x.pass.feed > 0              ? x.pass.feed
                  : x.modal.feed_per_tooth > 0 ? x.modal.feed_per_tooth
                                               : x.modal.feed;
    if (x.modal.feed_revolution && x.modal.feed_per_tooth > 0) feed *= x.modal.teeth;
    path.feed = feed;
    if (const double said_in = x.pass.feed > 0 ? feed_unit(x) : x.modal.feed_word_unit;
        path.feed_path.degree_unit != said_in) {
        path.feed_path.degree_unit = said_in;
        set_feed_path(x);
    }
    return true;
}
// G331 and G332 count S in revolutions whatever group 15 says; under G96 the S of the one is none
// for the other (7.1).
bool motion_changes(Execution& x, const GCode& to) {
    const auto taps = [](unsigned number) { return number == 11 || number == 12; };
    const bool before = taps(active(x, 1)), after = taps(to.number);
    if (before == after || !is_surface(active(x, 15))) return true;
    SpindleState& spindle = x.core.path.spindle;
    if (after) {
        if (!x.core.surface_speed(false)) return false;
        spindle.rpm = x.modal.asked_rpm[spindle.spindle] = 0.0;
        x.core.forget_pending();
        return true;
    }
    spindle.rpm = spindle.surface_m_min = x.modal.asked_rpm[spindle.spindle] = 0.0;
    // output with the S that must come before the spindle turns
    spindle.mode = SpindleModeCode::SurfaceSpeed;
    return true;
}
// FD: speed of the path that the handwheel changes; without its pulses the path is driven with it.
// FDA: of one axis.
bool a_handwheel_feed(Execution& x, const Word& word) {
    if (word.axis >= 0) {
        if (word.number() == 0) return fail_word(x, Alarm::NotBuilt, word, "FDA=0");
        x.modal.axis_feed[static_cast<std::size_t>(word.axis)] = word.number() * feed_unit(x);
        return a_without_effect(x, word);
    }
    if (word.number() <= 0) return fail_word(x, Alarm::ValueOutOfRange, word, "FD");
    if (has(x, "F") || has(x, "FB")) return fail_word(x, Alarm::CodesContradict, word, "FD, F");
    const GCode* motion = motion_code(x);
    const bool path = motion && motion->group == 1 && motion->number >= 2 && motion->number <= 4;
    if (!path || active(x, 10) != 1 || active(x, 15) != 2)
        return fail_word(x, Alarm::CodesContradict, word, "FD: G1 G2 G3, G60, G94");
    x.pass.feed = word.number() * feed_unit(x);
    return a_without_effect(x, word);
}
// Shares in percent: ACC, VELOLIM, JERKLIM of an axis' own limits, OVRA of a positioning axis' feed
// or a spindle's speed.
bool a_axis_share(Execution& x, const Word& word) {
    const std::string_view name = word.address->name;
    if (word.number() < 1 || word.number() > 200)
        return fail_word(x, Alarm::ValueOutOfRange, word, std::string(name), word.number());
    const double share = word.number() / 100.0;
    if (word.axis < 0 || word.axis >= kSpindleAxis)
        return name == "OVRA" ? spindle_share(x, word, share)
                              : share == 1.0 || a_without_effect(x, word);
    if (name == "ACC") x.modal.acceleration[static_cast<std::size_t>(word.axis)] = word.number();
    const std::string_view kind = name == "ACC"       ? "ACC"
                                  : name == "VELOLIM" ? "VELO"
                                  : name == "JERKLIM" ? "JERK"
                                                      : "OVRA";
    x.core.signal(std::string(kind) + std::to_string(word.axis), share);
    return true;
}

}  // namespace polyturn::channels::sinumerik
