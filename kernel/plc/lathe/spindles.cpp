// Codes that concern a spindle: turning, orienting, gear ranges, its chuck, C axis.
#include "kernel/plc/lathe/lathe_plc.hpp"

namespace polyturn::plc {
namespace {
constexpr std::int32_t kAutomaticRange = 40;
}  // namespace

// True: it was one of them, finished, pending or refused.
bool LathePlc::spindle_code(View view, std::uint32_t channel, std::uint32_t selected,
                            std::int32_t code) {
    const std::uint32_t driven = settings(channel).driven_spindle;
    switch (code) {
        case 3:
            turn(view, channel, selected, kRight);
            return true;
        case 4:
            turn(view, channel, selected, kLeft);
            return true;
        case 5:
            turn(view, channel, selected, kStop);
            return true;
        case 19:
            turn(view, channel, selected, kOrient, true);
            return true;
        case 13:
            turn(view, channel, driven, kRight);
            return true;
        case 14:
            turn(view, channel, driven, kLeft);
            return true;
        case 15:
            turn(view, channel, driven, kStop);
            return true;
        case 10:
        case 11:
            chuck(view, channel, selected, code == 11);
            return true;
        default:
            break;
    }
    if (selected == 0) return false;
    const SpindleSettings& set = spindle_settings_[selected - 1];
    Spindle& s = spindles_[selected - 1];
    if (set.closing_code > 0 && code == set.closing_code) {
        turn(view, channel, selected, code, true);
        return true;
    }
    if (set.c_axis_code > 0 && (code == set.c_axis_code || code == set.c_axis_code + 1)) {
        s.is_axis = code == set.c_axis_code;
        s.rotation = kStop;
        s.closes = false;
        at(channel).pending = {Task::Standstill, selected, view.in.cycle + kCyclesUntilAnswer,
                               view.in.tick + ticks(kSpindleTimeS), 0};
        return true;
    }
    if (set.state_high > 0 && code >= set.state_low && code <= set.state_high) {
        s.rotation = code;
        finish_m(view, channel);
        return true;
    }
    if (set.ranges > 1 && code >= kAutomaticRange && code <= kAutomaticRange + set.ranges) {
        s.automatic_range = code == kAutomaticRange;
        if (s.automatic_range)
            finish_m(view, channel);
        else
            change_gear(view, channel, selected, code - kAutomaticRange);
        return true;
    }
    return false;
}

Message LathePlc::why_not_turn(View view, std::uint32_t channel, std::uint32_t spindle) const {
    const Spindle& s = spindles_[spindle - 1];
    if (s.chuck_open) return kTurningWhileOpen;
    if (s.is_axis) return kSpindleIsAxis;
    if (missing(view, spindle_settings_[spindle - 1].in_chuck)) return kNoPressure;
    if (missing(view, settings(channel).in_door) && !in_setup(view, channel)) return kDoorOpen;
    return kNoMessage;
}

void LathePlc::turn(View view, std::uint32_t channel, std::uint32_t spindle, std::int32_t rotation,
                    bool closes) {
    if (spindle == 0) return refuse(channel, kNoSpindle);
    Spindle& s = spindles_[spindle - 1];
    if (rotation != kStop)
        if (const Message why = why_not_turn(view, channel, spindle); why != kNoMessage)
            return refuse(channel, why);
    // Turned in the other direction without a stop: a cut that follows must not begin before the
    // kernel has been notified, else it would see its spindle taken away from under the cut.
    const bool reversed =
        (s.rotation == kRight && rotation == kLeft) || (s.rotation == kLeft && rotation == kRight);
    s.rotation = rotation;
    s.closes = closes;
    s.started_by = rotation == kStop ? 0 : channel;
    if (reversed && !closes) {
        at(channel).pending = {Task::Reversed, spindle, view.in.cycle + kCyclesUntilAnswer, 0, 0};
        return;
    }
    if (!closes) return finish_m(view, channel);
    at(channel).pending = {Task::InPosition, spindle, view.in.cycle + kCyclesUntilAnswer,
                           view.in.tick + ticks(kSpindleTimeS), 0};
}

void LathePlc::chuck(View view, std::uint32_t channel, std::uint32_t spindle, bool open) {
    if (spindle == 0) return refuse(channel, kNoSpindle);
    const Spindle& s = spindles_[spindle - 1];
    if (const bool stands = view.in.signal[spindle_slots_[spindle - 1].stands] != 0;
        !stands && (s.rotation != kStop || s.follow != 0 || partner(view, spindle))) {
        if (s.chuck_open != open && !partner(view, spindle))
            return refuse(channel, open ? kChuckWhileTurning : kClampsTurning);
        // both hold the part, or both have let go of each other's
        spindles_[spindle - 1].chuck_open = open;
        at(channel).pending = {Task::Chuck, spindle, 0,
                               view.in.tick + ticks(spindle_settings_[spindle - 1].chuck_time_s),
                               0};
        return;
    }
    if (open && s.rotation != kStop) return refuse(channel, kChuckWhileTurning);
    // on a part that may turn: its spindle must run with it
    if (!open && s.chuck_open && presses(view, channel) && !partner(view, spindle)) {
        const std::int32_t master = spindle_settings_[spindle - 1].master;
        if (master > 0 && view.in.signal[spindle_slots_[master - 1].stands] == 0)
            return refuse(channel, kClampsTurning);
    }
    Pending& pending = at(channel).pending;
    pending = {Task::Standstill, spindle, view.in.cycle + kCyclesUntilAnswer,
               view.in.tick + ticks(kSpindleTimeS), open ? kThenChuck : kThenNothing};
    // M5 has only just been given
    if (open && view.in.signal[spindle_slots_[spindle - 1].stands] == 0) return;
    spindles_[spindle - 1].chuck_open = open;
    pending.task = Task::Chuck;
    pending.due_tick = view.in.tick + ticks(spindle_settings_[spindle - 1].chuck_time_s);
}

// An axis of the channel is at its fixed stop.
bool LathePlc::presses(View view, std::uint32_t channel) const {
    for (std::size_t a = 0; a < kAxes; ++a)
        if (axis_channel_[a] == channel && view.in.signal[torque_[a].fixed] != 0) return true;
    return false;
}

std::uint32_t LathePlc::partner(View view, std::uint32_t spindle) const {
    for (std::uint32_t other = 1; other <= kSpindles; ++other) {
        if (other == spindle || spindles_[other - 1].chuck_open) continue;
        const auto leads = [&](std::uint32_t master, std::uint32_t follower) {
            const SpindleSlots& slot = spindle_slots_[follower - 1];
            return view.in.signal[slot.follows] == static_cast<std::int32_t>(master) &&
                   view.in.signal[slot.synchronous] != 0;
        };
        if (leads(spindle, other) || leads(other, spindle)) return other;
    }
    return 0;
}

bool LathePlc::follow_code(View view, std::uint32_t channel, std::int32_t code) {
    for (std::uint32_t n = 1; n <= kSpindles; ++n) {
        const std::int32_t first = spindle_settings_[n - 1].follow_code;
        if (first <= 0 || code < first || code > first + 2) continue;
        Spindle& s = spindles_[n - 1];
        s.follow = static_cast<std::uint8_t>(code == first + 2 ? 0 : code - first + 1);
        s.ends_follow = false;
        if (s.follow != 0) s.started_by = channel;
        at(channel).pending = {Task::Follow,
                               n,
                               view.in.cycle + kCyclesUntilAnswer,
                               view.in.tick + ticks(kSpindleTimeS),
                               s.follow,
                               0};
        return true;
    }
    return false;
}

// A program that has ended leaves two spindles with one part between them: they run down together
// and are uncoupled at standstill.
void LathePlc::end_follow(View view) {
    for (std::uint32_t n = 1; n <= kSpindles; ++n) {
        Spindle& s = spindles_[n - 1];
        if (s.ends_follow && view.in.signal[spindle_slots_[n - 1].stands] != 0) {
            s.ends_follow = false;
            s.follow = 0;
        }
    }
}

void LathePlc::change_gear(View view, std::uint32_t channel, std::uint32_t spindle,
                           std::int32_t range) {
    Spindle& s = spindles_[spindle - 1];
    if (s.range == range) return finish_m(view, channel);
    s.creeps = true;
    at(channel).pending = {Task::Gear, spindle, view.in.cycle + kCyclesUntilAnswer, 0, range};
}

// M40: the lowest range that can give the speed, engaged while the spindle is stopped.
void LathePlc::choose_range(View view, std::uint32_t spindle, double rpm) {
    Spindle& s = spindles_[spindle - 1];
    if (!s.automatic_range || view.in.signal[spindle_slots_[spindle - 1].stands] == 0) return;
    const SpindleSettings& set = spindle_settings_[spindle - 1];
    std::int32_t range = 1;
    while (range < set.ranges && set.range_max[static_cast<std::size_t>(range - 1)] < rpm) ++range;
    s.range = range;
}

}  // namespace polyturn::plc
