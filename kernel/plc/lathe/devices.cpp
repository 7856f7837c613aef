// Turret, tailstock, bar feeder, parts catcher, door, lubrication.
#include <limits>

#include "kernel/plc/lathe/lathe_plc.hpp"

namespace polyturn::plc {

// The position of a station on the turret, in steps: with half stations the second half of
// the numbers lies between the first.
std::int32_t LathePlc::step_of(const ChannelSettings& set, std::int32_t station) const {
    if (!set.half) return station - 1;
    const std::int32_t full = (set.stations + 1) / 2;
    return station <= full ? 2 * (station - 1) : 2 * (station - full - 1) + 1;
}

std::int32_t LathePlc::station_at(const ChannelSettings& set, std::int32_t step) const {
    if (!set.half) return step + 1;
    const std::int32_t full = (set.stations + 1) / 2;
    return step % 2 == 0 ? step / 2 + 1 : full + step / 2 + 1;
}

void LathePlc::start_t(View view, std::uint32_t channel, std::int32_t code) {
    Channel& me = at(channel);
    Turret& turret = me.turret;
    const ChannelSettings& set = settings(channel);
    // Tool management has found the place: the pot is the station, and another magazine than the
    // turret's does not turn it.
    const std::int32_t magazine = view.in.signal[slots(channel).magazine];
    if (magazine != 0 && magazine != set.magazine)
        code = 0;
    else if (magazine != 0)
        code = view.in.signal[slots(channel).pot] - set.first_pot + 1;
    const std::int32_t count = set.stations;
    me.t_pending = true;
    if (code < 0 || (count > 0 && code > count)) {
        // t_pending stays until the reset: a refused code is not finished
        me.message = kNoSuchStation;
        return;
    }
    turret.target = code == 0 || count == 0 ? turret.station : code;
    // move_turret finishes it in this cycle
    if (turret.target == turret.station && turret.step == 0) return;
    const std::int32_t steps = set.half ? 2 * ((count + 1) / 2) : count;
    const std::int32_t forward =
        (step_of(set, turret.target) - step_of(set, turret.station) + steps) % steps;
    turret.step = set.forward_only || 2 * forward <= steps ? 1 : -1;
    turret.clamping = false;
    turret.due_tick = view.in.tick + ticks(step_time(set));
}

void LathePlc::move_turret(View view, std::uint32_t channel) {
    Channel& me = at(channel);
    Turret& turret = me.turret;
    const ChannelSettings& set = settings(channel);
    while (turret.step != 0 && view.in.tick >= turret.due_tick) {
        if (turret.clamping) {
            turret.step = 0;
            turret.clamping = false;
            break;
        }
        const std::int32_t steps = set.half ? 2 * ((set.stations + 1) / 2) : set.stations;
        turret.station =
            station_at(set, (step_of(set, turret.station) + turret.step + steps) % steps);
        turret.clamping = turret.station == turret.target;
        turret.due_tick += ticks(turret.clamping ? set.turret_clamp_s : step_time(set));
    }
    if (!me.t_pending || turret.step != 0 || me.message == kNoSuchStation) return;
    me.t_pending = false;
    view.out.signal[slots(channel).t_fin] = me.t_seen;
    ++me.finished;
}

bool LathePlc::helper_code(View view, std::uint32_t channel, std::uint32_t selected,
                           std::int32_t code) {
    Channel& me = at(channel);
    const ChannelSettings& set = settings(channel);
    if (set.first_spindle_code > 0 && code >= set.first_spindle_code &&
        code < set.first_spindle_code + static_cast<std::int32_t>(kSpindles)) {
        me.selected = static_cast<std::uint32_t>(code - set.first_spindle_code) + 1;
        finish_m(view, channel);
        return true;
    }
    for (std::size_t h = 0; h < kHelpers; ++h) {
        const std::int32_t first = set.code[h];
        if (first <= 0 || (code != first && (code != first + 1 || h == kBar))) continue;
        const bool out = code == first;
        if (h == kBar) {
            if (selected == 0) {
                refuse(channel, kNoSpindle);
                return true;
            }
            if (missing(view, set.in_bar)) {
                refuse(channel, kBarEnd);
                return true;
            }
            chuck(view, channel, selected, true);
            if (me.pending.task == Task::Chuck)
                me.pending.task = Task::BarOpen;
            else if (me.pending.task == Task::Standstill)
                me.pending.range = kThenBar;
            return true;
        }
        const bool turns =
            selected != 0 && view.in.signal[spindle_slots_[selected - 1].stands] == 0;
        if (h == kTailstock && !out && turns) {
            if (spindles_[selected - 1].rotation != kStop) {
                refuse(channel, kTailstockTurning);
                return true;
            }
            // M5 has only just been given
            me.pending = {Task::Standstill, selected, 0, view.in.tick + ticks(kSpindleTimeS),
                          kThenHelper,      code};
            return true;
        }
        me.out[h] = out;
        me.pending = {Task::Helper, 0, 0, view.in.tick + ticks(set.time_s[h]), 0};
        return true;
    }
    return false;
}

// One code may couple several axes; it is done when the NC has acknowledged the last of them.
bool LathePlc::coupling_code(View view, std::uint32_t channel, std::int32_t code) {
    bool any = false;
    for (const AxisCouplings& axis : couplings_)
        for (std::size_t k = 0; k < kCouplings; ++k) {
            const std::int32_t first = axis.code[k];
            if (first <= 0 || (code != first && code != first + 1)) continue;
            any = true;
            view.out.signal[axis.request[k]] = code == first;
        }
    if (any)
        at(channel).pending = {Task::Coupled,
                               0,
                               0,
                               couple_time_s_ > 0
                                   ? view.in.tick + ticks(couple_time_s_ + kCoupleAnswerS)
                                   : std::numeric_limits<std::int64_t>::max(),
                               0,
                               code};
    return any;
}

// All axes of the code have switched. What is refused is asked for no longer: requests go back to
// what is.
bool LathePlc::coupling_step(View view, std::int32_t code, bool give_up) {
    bool all = true;
    for (const AxisCouplings& axis : couplings_)
        for (std::size_t k = 0; k < kCouplings; ++k) {
            const std::int32_t first = axis.code[k];
            if (first <= 0 || (code != first && code != first + 1)) continue;
            const bool is = view.in.signal[axis.answer[k]] != 0;
            all = all && is == (code == first);
            if (give_up) view.out.signal[axis.request[k]] = is;
        }
    return all;
}

// A limit is there at once; it is gone when nothing presses any more and the slide rests where it
// was met.
bool LathePlc::torque_code(View view, std::uint32_t channel, std::int32_t code) {
    for (std::size_t a = 0; a < kAxes; ++a) {
        AxisTorque& axis = torque_[a];
        if (axis.code <= 0 || (code != axis.code && code != axis.code + 1)) continue;
        axis.on = code == axis.code;
        at(channel).pending = {Task::Torque,
                               0,
                               view.in.cycle + kCyclesUntilAnswer,
                               view.in.tick + ticks(kSpindleTimeS),
                               axis.on,
                               static_cast<std::int32_t>(a)};
        return true;
    }
    return false;
}

bool LathePlc::torque_step(View view, Pending& pending) const {
    const AxisTorque& axis = torque_[static_cast<std::size_t>(pending.slot)];
    return pending.range != 0 ||
           (view.in.signal[axis.fixed] == 0 && view.in.signal[axis.moves] == 0);
}

std::int32_t LathePlc::program_inputs(View view, std::uint32_t channel) const {
    constexpr std::size_t kShown = 8;  // spindles, and behind them axes
    std::uint32_t bits = 0;
    for (std::size_t s = 0; s < kShown; ++s)
        bits |= view.in.signal[spindle_slots_[s].synchronous] != 0 ? 1u << s : 0u;
    std::size_t place = kShown;
    for (std::size_t a = 0; a < kAxes && place < 2 * kShown; ++a) {
        if (axis_channel_[a] != channel) continue;
        bits |= view.in.signal[torque_[a].fixed] != 0 ? 1u << place : 0u;
        ++place;
    }
    const Channel& me = channels_[channel - 1];
    // it is forwards, and at its end
    const bool supports = me.out[kTailstock] && me.pending.task != Task::Helper;
    bits |= supports ? 0u : 1u << 2 * kShown;
    return static_cast<std::int32_t>(bits);
}

// Chuck open, bar forwards, chuck closed. True: done.
bool LathePlc::bar_step(View view, std::uint32_t channel) {
    Channel& me = at(channel);
    Pending& pending = me.pending;
    if (view.in.tick < pending.due_tick) return false;
    const ChannelSettings& set = settings(channel);
    const double chuck_s = spindle_settings_[pending.spindle - 1].chuck_time_s;
    switch (pending.task) {
        case Task::BarOpen:
            me.out[kBar] = true;
            pending.task = Task::BarFeed;
            pending.due_tick = view.in.tick + ticks(set.time_s[kBar]);
            return false;
        case Task::BarFeed:
            me.out[kBar] = false;
            spindles_[pending.spindle - 1].chuck_open = false;
            pending.task = Task::BarClamp;
            pending.due_tick = view.in.tick + ticks(chuck_s);
            return false;
        default:
            return true;
    }
}

void LathePlc::lubricate(View view, std::uint32_t channel) {
    const double time_s = settings(channel).lube_time_s;
    if (time_s <= 0) return;
    for (std::size_t a = 0; a < kAxes; ++a)
        if (axis_channel_[a] == channel && view.in.signal[lube_slot_[a]] != 0)
            at(channel).lubricates_until = view.in.tick + ticks(time_s);
}

}  // namespace polyturn::plc
