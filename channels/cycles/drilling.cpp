#include "channels/cycles/drilling.hpp"

#include <cmath>
#include <string>

namespace polyturn::channels::cycles {
namespace {

bool to(Core& core, const Drilling& hole, double level, bool rapid) {
    AxisValues target = core.path.programmed;
    target[hole.axis] = level;
    return rapid ? core.rapid(target) : core.linear(target);
}

bool turn(Core& core, SpindleTurn direction) {
    if (!core.spindle_turn(direction) || !core.commit_spindle()) return false;
    static constexpr std::string_view kText[] = {"M4", "M5", "M3"};
    static constexpr double kCode[] = {4, 5, 3};
    const auto which = static_cast<std::size_t>(static_cast<int>(direction) + 1);
    core.aux('M', kCode[which], kText[which], false);
    return true;
}

// A rigid tap is turned by the moves themselves: the PLC hears nothing of it.
bool turn_for(Core& core, const Drilling& hole, SpindleTurn direction) {
    if (!hole.rigid) return turn(core, direction);
    return core.spindle_turn(direction) && core.commit_spindle();
}

SpindleTurn forward_of(const Drilling& hole) {
    return hole.left_hand ? SpindleTurn::Ccw : SpindleTurn::Cw;
}

// The spindle turns back and the axis follows it to `level`.
bool out_of_thread(Core& core, const Drilling& hole, double level, double factor) {
    const double feed = core.path.feed;
    if (!turn_for(core, hole, hole.left_hand ? SpindleTurn::Cw : SpindleTurn::Ccw)) return false;
    core.path.feed = feed * factor;
    const bool good = to(core, hole, level, false);
    core.path.feed = feed;
    return good;
}

// Tapping in pecks: a short retract (chip break), or out of the hole and back to shortly above the
// last depth.
bool tap_in_pecks(Core& core, const Drilling& hole) {
    const double step = std::copysign(hole.peck, hole.bottom - hole.r_level),
                 up = std::copysign(hole.clearance, hole.r_level - hole.bottom);
    double depth = hole.r_level;
    for (;;) {  // drill() has counted them
        const bool last = std::fabs(hole.bottom - depth) <= hole.peck * (1 + 1e-9);
        depth = last ? hole.bottom : depth + step;
        if (!to(core, hole, depth, false)) return false;
        if (last) return true;
        if (!out_of_thread(core, hole, hole.chip_break ? depth + up : hole.r_level,
                           hole.out_factor) ||
            !turn_for(core, hole, forward_of(hole)))
            return false;
        if (hole.chip_break) continue;
        const double feed = core.path.feed;
        core.path.feed = feed * hole.return_factor;
        const bool good = to(core, hole, depth + up, false);
        core.path.feed = feed;
        if (!good) return false;
    }
}

// Down in pecks; the last one ends exactly on the bottom.
bool peck(Core& core, const Drilling& hole) {
    const double step = std::copysign(hole.peck, hole.bottom - hole.r_level);
    const double up = std::copysign(hole.clearance, hole.r_level - hole.bottom);
    double depth = hole.r_level;
    for (;;) {  // drill() has counted them
        const bool last = std::fabs(hole.bottom - depth) <= hole.peck * (1 + 1e-9);
        depth = last ? hole.bottom : depth + step;
        if (!to(core, hole, depth, false)) return false;
        if (last) return true;
        if (hole.chip_break) {
            if (!to(core, hole, depth + up, true)) return false;
        } else {
            if (!to(core, hole, hole.r_level, true) || !to(core, hole, depth + up, true))
                return false;
        }
    }
}

}  // namespace

namespace {

bool level(Core& core, const AxialHole& hole, double to, bool rapid) {
    AxisValues target = core.path.programmed;
    target[hole.axis] = to;
    return rapid ? core.rapid(target) : core.linear(target);
}

}  // namespace

bool drill_axial(Core& core, const AxialHole& hole) {
    constexpr int kMostPecks = 100'000;
    const double away = hole.bottom < hole.surface ? 1.0 : -1.0,
                 total = std::fabs(hole.bottom - hole.surface);
    const double approach = hole.approach[hole.axis];
    if (!core.rapid(hole.approach)) return false;
    double depth = std::fmin(hole.peck, total), peck = hole.peck;
    if (!level(core, hole, hole.surface - away * depth, false)) return false;
    for (int count = 0; depth < total - 1e-9; ++count) {
        const double last = hole.surface - away * depth;
        peck = std::fmax(peck * hole.factor, hole.least);
        if (count == kMostPecks || !(peck > 0))
            return core.fail(Alarm::CycleValueIllegal, 'B', "B", hole.peck);
        // as far as it says, beyond the approach point too
        const double back = hole.retract > 0 ? last + away * hole.retract : approach;
        if (!level(core, hole, back, true)) return false;
        const double near = last + away * hole.clearance;
        if (away * near < away * back - 1e-9 && !level(core, hole, near, true)) return false;
        depth = std::fmin(depth + peck, total);
        if (!level(core, hole, hole.surface - away * depth, false)) return false;
    }
    if (hole.dwell > 0 && !core.dwell(hole.dwell, false)) return false;
    return level(core, hole, approach, true);
}

// The spindle is led by the axis, into the hole and out of it: oriented, or from where its loop has
// closed.
static bool tap_led(Core& core, const AxialHole& hole, SpindleTurn in) {
    PathState& path = core.path;
    Core::TapLoop loop;
    if (!core.rigid_loop(loop, hole.tap == AxialHole::Tap::Oriented)) return false;
    const double rpm = path.spindle.rpm;
    const double pitch = path.feed_mode == FeedMode::PerRevolution ? path.feed
                         : rpm > 0                                 ? path.feed / rpm
                                                                   : 0.0;
    if (!(pitch > 0)) return core.fail(Alarm::LeadMissing, 'F');
    if (loop.orients) {
        if (!turn(core, SpindleTurn::Stop) || !core.spindle_position(0.0)) return false;
        // the PLC closes the loop and answers when it is in position
        core.aux('M', 19, "M19", false);
    } else {  // never turned free of the loop in between: it brakes as the loop closes
        core.aux('M', loop.code, "M" + std::to_string(static_cast<long>(loop.code)), false);
    }
    path.spindle.turn = in;  // the moves know its speed, though it is stopped
    const bool locked = path.override_locked;
    path.override_locked = true;
    path.tap_pitch = in == SpindleTurn::Cw ? pitch : -pitch;
    path.tap_axis = static_cast<std::uint8_t>(hole.axis);
    path.tap_depth_sign = hole.bottom < hole.approach[hole.axis] ? -1.0 : 1.0;
    const bool good = level(core, hole, hole.bottom, false) &&
                      (hole.dwell <= 0 || core.dwell(hole.dwell, false)) &&
                      level(core, hole, hole.approach[hole.axis], false);
    path.tap_pitch = 0.0;
    path.override_locked = locked;
    path.spindle.turn = SpindleTurn::Stop;
    return good && turn(core, SpindleTurn::Stop);
}

static bool tap_hole(Core& core, const AxialHole& hole, SpindleTurn in) {
    const SpindleTurn back = in == SpindleTurn::Cw ? SpindleTurn::Ccw : SpindleTurn::Cw;
    if (hole.tap != AxialHole::Tap::Floating) return tap_led(core, hole, in);
    const bool locked = core.path.override_locked;
    core.path.override_locked = true;
    const bool good =
        level(core, hole, hole.bottom, false) &&
        (hole.dwell <= 0 || (turn(core, SpindleTurn::Stop) && core.dwell(hole.dwell, false))) &&
        turn(core, back) && level(core, hole, hole.approach[hole.axis], false);
    core.path.override_locked = locked;
    return good && turn(core, in);
}

bool tap_axial(Core& core, const AxialHole& hole) {
    if (!core.rapid(hole.approach)) return false;
    const SpindleTurn in = core.path.spindle.turn;
    if (in == SpindleTurn::Stop) return core.fail(Alarm::ThreadSpindleStopped);
    const bool floating = hole.tap == AxialHole::Tap::Floating;
    if (floating) core.taps(true);
    const bool good = tap_hole(core, hole, in);
    if (floating) core.taps(false);
    return good;
}

namespace {

bool aside(Core& core, const Drilling& hole, double way) {
    AxisValues target = core.path.programmed;
    for (std::size_t i = 0; i < target.size(); ++i) target[i] += way * hole.aside[i];
    return core.rapid(target);
}

// From here on the spindle is led by the axis.
bool close_loop(Core& core, const Drilling& hole) {
    if (hole.orients) {
        if (!core.spindle_position(0.0) || !core.commit_spindle()) return false;
        core.aux('M', 19, "M19", false);
    } else {
        core.aux('M', hole.closing_code, "M" + std::to_string(static_cast<long>(hole.closing_code)),
                 false);
    }
    if (!core.spindle_turn(forward_of(hole)) || !core.commit_spindle()) return false;
    PathState& path = core.path;
    path.tap_pitch = hole.left_hand ? -hole.pitch : hole.pitch;
    path.tap_axis = static_cast<std::uint8_t>(hole.axis);
    path.tap_depth_sign = hole.bottom < hole.r_level ? -1.0 : 1.0;
    path.tap_feedforward = hole.feedforward;
    path.tap_own_acceleration_out = hole.own_acceleration_out;
    return true;
}

bool open_loop(Core& core) {
    core.path.tap_pitch = 0;
    return turn(core, SpindleTurn::Stop);
}

// The edge points away from the wall that it leaves.
bool orient_asynchronously(Core& core, const Drilling& hole) {
    if (!core.spindle_position(0.0) || !core.commit_spindle()) return false;
    core.aux('M', 19, "M19", false);
    return aside(core, hole, 1.0);
}

bool bore_back(Core& core, const Drilling& hole) {
    const SpindleTurn in = core.path.spindle.turn;
    if (!orient_asynchronously(core, hole) || !to(core, hole, hole.r_level, true) ||
        !aside(core, hole, -1.0) || !turn(core, in))
        return false;
    if (!to(core, hole, hole.bottom, false) ||
        (hole.dwells && !core.dwell(hole.dwell, hole.dwell_revolutions)))
        return false;
    return orient_asynchronously(core, hole) && to(core, hole, hole.initial, true) &&
           aside(core, hole, -1.0) && turn(core, in);
}

bool drill_hole(Core& core, const Drilling& hole) {
    if (hole.travel_out == Drilling::Way::Back) return bore_back(core, hole);
    if (!to(core, hole, hole.r_level, true)) return false;
    if (hole.rigid && !close_loop(core, hole)) return false;
    const SpindleTurn in = core.path.spindle.turn;
    const bool taps = hole.travel_out == Drilling::Way::Tap;
    if (hole.peck > 0 ? !(taps ? tap_in_pecks(core, hole) : peck(core, hole))
                      : !to(core, hole, hole.bottom, false))
        return false;
    if (hole.dwells && !core.dwell(hole.dwell, hole.dwell_revolutions)) return false;
    const double feed = core.path.feed;
    switch (hole.travel_out) {
        case Drilling::Way::Rapid:
            return to(core, hole, hole.to_r_level ? hole.r_level : hole.initial, true);
        case Drilling::Way::Feed:
            core.path.feed = feed * hole.travel_out_factor;
            if (!to(core, hole, hole.r_level, false)) return false;
            core.path.feed = feed;
            break;
        case Drilling::Way::StopRapid:
            if (!turn(core, SpindleTurn::Stop)) return false;
            if (!to(core, hole, hole.to_r_level ? hole.r_level : hole.initial, true)) return false;
            return turn(core, in);
        case Drilling::Way::Fine:
            return orient_asynchronously(core, hole) &&
                   to(core, hole, hole.to_r_level ? hole.r_level : hole.initial, true) &&
                   aside(core, hole, -1.0) && turn(core, in);
        case Drilling::Way::Back:
            break;  // bore_back()
        case Drilling::Way::Tap:
            if (!out_of_thread(core, hole, hole.r_level, hole.out_factor)) return false;
            if (hole.dwells && hole.dwells_at_r && !core.dwell(hole.dwell, hole.dwell_revolutions))
                return false;
            if (hole.rigid ? !open_loop(core) : !turn(core, forward_of(hole))) return false;
            break;
    }
    return hole.to_r_level ? true : to(core, hole, hole.initial, true);
}

}  // namespace

bool drill(Core& core, const Drilling& hole) {
    constexpr double kMostPecks = 100'000;
    if (hole.peck > 0 && std::fabs(hole.bottom - hole.r_level) / hole.peck > kMostPecks)
        return core.fail(Alarm::CycleValueIllegal, 'Q', "Q", hole.peck);
    // nothing ties the feed to the spindle but their two numbers
    const bool floating = hole.travel_out == Drilling::Way::Tap && !hole.rigid;
    if (!hole.rigid && !floating) return drill_hole(core, hole);
    PathState& path = core.path;
    const bool locked = path.override_locked;
    path.override_locked = true;
    if (floating) core.taps(true);
    const bool good = drill_hole(core, hole);
    if (floating) core.taps(false);
    path.tap_pitch = 0;
    path.override_locked = locked;
    return good;
}

}  // namespace polyturn::channels::cycles
