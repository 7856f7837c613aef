// Strobes and codes, what a code waits for, and the outputs. Spindles and devices have files of
// their own.
#include "kernel/plc/lathe/lathe_plc.hpp"

#include <cmath>
#include <cstddef>
#include <type_traits>

namespace polyturn::plc {
namespace {
// A PLC that starts with its machine may find the first code already waiting; one that comes later
// must not repeat old ones.
constexpr double kFreshMachineS = 1.0;
}  // namespace

std::int64_t LathePlc::ticks(double seconds) const {
    return static_cast<std::int64_t>(std::ceil(seconds / tick_s_ - 1e-9));
}

void LathePlc::cycle(const PolyturnPlcInputs& in, PolyturnPlcOutputs& out) {
    const View view{in, out};
    const bool late_start = first_ && static_cast<double>(in.tick) * tick_s_ > kFreshMachineS;
    if (first_ && kept_.used != 0)
        for (std::size_t c = 0; c < kChannels; ++c)
            channels_[c].turret.station = channels_[c].turret.target = kept_.station[c];
    first_ = false;
    const bool live = in.signal[machine_on_slot_] != 0 && in.signal[emergency_slot_] == 0;
    if (!live) stop_everything();
    for (std::uint32_t c = 1; c <= kChannels; ++c) {
        Channel& me = at(c);
        const ChannelSlots& slot = slots(c);
        const bool was_reset = in.signal[slot.reset] != me.reset_seen;
        if (late_start || was_reset) {
            me.reset_seen = in.signal[slot.reset];
            if (was_reset && !late_start) end_of_channel(c);
            // What the channel had asked for, or asked a predecessor for, is void; the counts are
            // answered so that its next code is a new one.
            me.pending = {};
            me.t_pending = false;
            me.message = kNoMessage;
            out.signal[slot.m_fin] = me.m_seen = in.signal[slot.m_strobe];
            out.signal[slot.s_fin] = me.s_seen = in.signal[slot.s_strobe];
            out.signal[slot.t_fin] = me.t_seen = in.signal[slot.t_strobe];
            out.signal[slot.b_fin] = me.b_seen = in.signal[slot.b_strobe];
            for (std::size_t a = 0; a < kAxes; ++a)
                if (axis_channel_[a] == c)
                    out.signal[axis_codes_[a].fin] = in.signal[axis_codes_[a].strobe];
        }
        if (!live) continue;
        take_codes(view, c);
        watch_pending(view, c);
        move_turret(view, c);
        lubricate(view, c);
    }
    kept_.used = 1;
    for (std::size_t c = 0; c < kChannels; ++c) kept_.station[c] = channels_[c].turret.station;
    if (live) take_axis_codes(view);
    end_follow(view);
    write_outputs(view);
}

void LathePlc::take_codes(View view, std::uint32_t channel) {
    Channel& me = at(channel);
    const auto& slot = slots(channel);
    if (const std::int32_t count = view.in.signal[slot.s_strobe]; count != me.s_seen) {
        me.s_seen = view.out.signal[slot.s_fin] = count;
        ++me.finished;
        if (const std::uint32_t selected = selected_of(view, channel))
            choose_range(view, selected, view.in.signal[slot.s_code]);
    }
    if (const std::int32_t count = view.in.signal[slot.b_strobe]; count != me.b_seen) {
        me.b_seen = view.out.signal[slot.b_fin] = count;
        ++me.finished;
    }
    if (const std::int32_t count = view.in.signal[slot.t_strobe]; count != me.t_seen) {
        me.t_seen = count;
        start_t(view, channel, view.in.signal[slot.t_code]);
    }
    if (const std::int32_t count = view.in.signal[slot.m_strobe]; count != me.m_seen) {
        me.m_seen = count;
        start_m(view, channel, view.in.signal[slot.m_code]);
    }
}

// A chuck's code may come before the program has named a spindle: then it is that of N0604. 0:
// none.
std::uint32_t LathePlc::selected_of(View view, std::uint32_t channel) {
    const std::int32_t named = view.in.signal[slots(channel).selected],
                       number = named ? named : channel_settings_[channel - 1].default_spindle;
    return number > 0 && number <= static_cast<std::int32_t>(kSpindles)
               ? static_cast<std::uint32_t>(number)
               : 0;
}

void LathePlc::start_m(View view, std::uint32_t channel, std::int32_t code) {
    Channel& me = at(channel);
    const std::uint32_t selected = selected_of(view, channel);
    me.pending = {};
    me.m_code = code;
    // The helpers come first: their codes are chosen for this machine.
    if (coupling_code(view, channel, code) || follow_code(view, channel, code) ||
        torque_code(view, channel, code) || helper_code(view, channel, selected, code) ||
        spindle_code(view, channel, selected, code))
        return;
    if (code == 8 || code == 9) me.coolant = code == 8;
    if (code == 2 || code == 30) end_of_channel(channel);
    finish_m(view, channel);
}

// A program of a positioning axis turns the spindle of its channel (tapping and boring on it); a
// refusal holds until the channel's reset, as one of its own codes would.
void LathePlc::take_axis_codes(View view) {
    for (std::size_t a = 0; a < kAxes; ++a) {
        const AxisCodes& slot = axis_codes_[a];
        const std::int32_t count = view.in.signal[slot.strobe];
        if (count == view.out.signal[slot.fin]) continue;
        const std::uint32_t channel = axis_channel_[a];
        const std::int32_t code = view.in.signal[slot.code];
        const bool turns = view.in.signal[slot.letter] == 'M' && code >= kRight && code <= kStop &&
                           channel >= 1 && channel <= kChannels;
        if (const std::uint32_t spindle = turns ? selected_of(view, channel) : 0) {
            const Message why = code == kStop ? kNoMessage : why_not_turn(view, channel, spindle);
            if (why != kNoMessage) {
                at(channel).message = why;
                continue;
            }
            spindles_[spindle - 1].rotation = code;
            spindles_[spindle - 1].closes = false;
            spindles_[spindle - 1].started_by = code == kStop ? 0 : channel;
        }
        view.out.signal[slot.fin] = count;
    }
}

void LathePlc::refuse(std::uint32_t channel, Message message) {
    at(channel).pending = {Task::Refused, 0, 0, 0, 0};
    at(channel).message = message;
}

void LathePlc::finish_m(View view, std::uint32_t channel) {
    Channel& me = at(channel);
    me.pending = {};
    view.out.signal[slots(channel).m_fin] = me.m_seen;
    ++me.finished;
    // The code that is valid now in its group of exclusive ones (N1341 to N1372).
    const ChannelSettings& set = settings(channel);
    for (std::size_t n = 0; n < kMGroups; ++n) {
        const bool used = set.group_low[n] != 0 || set.group_high[n] != 0;
        if (used && me.m_code >= set.group_low[n] && me.m_code <= set.group_high[n])
            view.out.signal[slots(channel).group + group_stride_ * static_cast<std::int32_t>(n)] =
                me.m_code;
    }
}

void LathePlc::watch_pending(View view, std::uint32_t channel) {
    Pending& pending = at(channel).pending;
    switch (pending.task) {
        case Task::None:
        case Task::Refused:
            return;
        case Task::Chuck:
        case Task::Helper:
            if (view.in.tick >= pending.due_tick) finish_m(view, channel);
            return;
        case Task::Reversed:
            if (view.in.cycle >= pending.believe_cycle) finish_m(view, channel);
            return;
        case Task::Coupled:
            if (coupling_step(view, pending.slot, false)) return finish_m(view, channel);
            if (view.in.tick < pending.due_tick) return;
            (void)coupling_step(view, pending.slot, true);
            return refuse(channel, kNotCoupled);
        case Task::Torque:
            if (view.in.cycle >= pending.believe_cycle && torque_step(view, pending))
                finish_m(view, channel);
            else if (view.in.tick >= pending.due_tick)
                refuse(channel, kStillPressed);
            return;
        case Task::BarOpen:
        case Task::BarFeed:
        case Task::BarClamp:
            if (bar_step(view, channel)) finish_m(view, channel);
            return;
        default:
            break;
    }
    if (view.in.cycle < pending.believe_cycle) return;
    const std::uint32_t spindle = pending.spindle;
    const auto& flags = spindle_slots_[spindle - 1];
    if (pending.task == Task::Follow) {
        const bool there = pending.range != 0 ? view.in.signal[flags.synchronous] != 0
                                              : view.in.signal[flags.follows] == 0;
        if (there)
            finish_m(view, channel);
        else if (view.in.tick >= pending.due_tick)
            refuse(channel, kNotSynchronous);
        return;
    }
    if (pending.task == Task::Gear) {
        Spindle& s = spindles_[spindle - 1];
        if (pending.due_tick == 0) {  // creeping yet?
            if (view.in.signal[flags.reached] != 0)
                pending.due_tick = view.in.tick + ticks(spindle_settings_[spindle - 1].gear_time_s);
            return;
        }
        if (view.in.tick < pending.due_tick) return;
        s.range = pending.range;
        s.creeps = false;
        return finish_m(view, channel);
    }
    const bool done =
        view.in.signal[pending.task == Task::InPosition ? flags.in_position : flags.stands] != 0;
    if (!done) {
        if (view.in.tick >= pending.due_tick) refuse(channel, kSpindleTooSlow);
        return;
    }
    if (pending.task == Task::InPosition || pending.range == kThenNothing)
        return finish_m(view, channel);
    // Actions that wait for the spindle's standstill.
    if (pending.range == kThenHelper) {
        (void)helper_code(view, channel, spindle, pending.slot);
        return;
    }
    const bool bar = pending.range == kThenBar;
    chuck(view, channel, spindle, true);
    if (bar && pending.task == Task::Chuck) pending.task = Task::BarOpen;
}

PolyturnPlcRetained LathePlc::retained() {
    static_assert(std::is_standard_layout_v<LathePlc>);
    return {offsetof(LathePlc, kept_), sizeof(Kept)};
}

void LathePlc::end_of_channel(std::uint32_t channel) {
    for (Spindle& s : spindles_)
        if (s.started_by == channel) {
            s.rotation = kStop;
            s.closes = s.creeps = false;
            s.started_by = 0;
            s.ends_follow = s.follow != 0;
        }
    at(channel).coolant = false;
    at(channel).out[kBar] = false;
}

void LathePlc::stop_everything() {
    for (Spindle& s : spindles_) {
        s.rotation = kStop;
        s.closes = s.creeps = s.ends_follow = false;
        s.started_by = 0;
        s.follow = 0;
    }
    for (AxisTorque& axis : torque_) axis.on = false;
    for (Channel& c : channels_) {
        c.coolant = c.out[kBar] = false;
        c.turret.step = 0;  // halts; the channel's T stays unanswered until its reset
        if (c.turret.target != c.turret.station) {
            c.turret.target = c.turret.station;
            c.t_pending = false;
        }
    }
}

void LathePlc::write_outputs(View view) const {
    Message message = kNoMessage;
    for (const AxisCodes& slot : axis_codes_) view.out.signal[slot.enabled] = 1;
    for (std::size_t c = 0; c < kChannels; ++c) {
        const Channel& me = channels_[c];
        const ChannelSlots& slot = channel_slots_[c];
        const ChannelSettings& set = channel_settings_[c];
        view.out.signal[slot.fin] = me.finished;
        view.out.signal[slot.active_tool] = me.turret.station;
        if (set.driven_spindle > 0)
            view.out.signal[spindle_slots_[set.driven_spindle - 1].active_tool] = me.turret.station;
        view.out.signal[slot.door_open] = missing(view, set.in_door) || me.out[kDoor];
        view.out.signal[slot.jog_feed] = kJogStep;
        view.out.signal[slot.setup] = in_setup(view, static_cast<std::uint32_t>(c + 1));
        view.out.signal[slot.turret_open] = me.turret.step != 0;
        view.out.signal[slot.tail_open] =
            me.pending.task == Task::Helper && set.code[kTailstock] > 0 &&
            (me.m_code == set.code[kTailstock] || me.m_code == set.code[kTailstock] + 1);
        view.out.signal[slot.no_lube] = missing(view, set.in_lube);
        view.out.signal[slot.bar_end] = missing(view, set.in_bar);
        view.out.signal[slot.inputs] = program_inputs(view, static_cast<std::uint32_t>(c + 1));
        view.out.signal[slot.select] = static_cast<std::int32_t>(me.selected);
        std::uint8_t* const output = view.out.output + c * kOutputsPerChannel;
        output[kCoolant] = me.coolant;
        output[kTurretTurns] = me.turret.step != 0;
        output[kTurretLocked] = me.turret.step == 0;
        output[kTailstockOut] = me.out[kTailstock];
        output[kCatcherOut] = me.out[kCatcher];
        output[kDoorUnlocked] = me.out[kDoor];
        output[kBarFeeds] = me.out[kBar];
        output[kLubricates] = view.in.tick < me.lubricates_until;
        if (message == kNoMessage) message = me.message;
    }
    for (std::size_t s = 0; s < kSpindles; ++s) {
        const Spindle& me = spindles_[s];
        const SpindleSlots& slot = spindle_slots_[s];
        view.out.signal[slot.rotation] = me.rotation;
        view.out.signal[slot.close_loop] = me.closes;
        view.out.signal[slot.creep] = me.creeps;
        view.out.signal[slot.range] = me.range;
        view.out.signal[slot.detach] = me.is_axis;
        view.out.signal[slot.follow] = me.follow != 0;
        view.out.signal[slot.phase] = me.follow == 2;
        view.out.signal[slot.unclamped] =
            me.chuck_open || missing(view, spindle_settings_[s].in_chuck);
        std::uint8_t* const output = view.out.output + kFirstSpindleOutput + s * kOutputsPerSpindle;
        output[kChuckClamp] = !me.chuck_open;
        output[kChuckOpen] = me.chuck_open;
    }
    for (const AxisTorque& axis : torque_)
        if (axis.code > 0) view.out.signal[axis.request] = axis.on ? axis.limit : 0;
    view.out.signal[message_slot_] = message;
    std::int32_t key = 0;  // the highest position whose input is on
    for (std::int32_t n = 1; n <= 3 && in_key_ > 0; ++n)
        if (view.in.input[in_key_ + n - 2]) key = n;
    view.out.signal[key_slot_] = key;
    view.out.signal[stop_slot_] = missing(view, in_stop_);
    view.out.signal[power_slot_] = missing(view, in_power_);
}

}  // namespace polyturn::plc
