#include "kernel/plc/lathe/lathe_plc.hpp"

#include <cmath>
#include <cstdlib>

namespace polyturn::plc {

namespace {
// An output acts one PLC cycle later, and the flags that answer it come with the inputs after that.
constexpr std::uint64_t kCyclesUntilAnswer = 3;
constexpr double kMeantToStandS = 1.0;
// A PLC that starts with its machine may find the first code already waiting; one that comes later must not repeat old ones.
constexpr double kFreshMachineS = 1.0;
}  // namespace

const char* LathePlc::resolve(const PolyturnPlcHost& host) {
    const char* missing = nullptr;
    const auto nc = [&](const char* name, std::uint32_t instance) {
        const std::int32_t slot = host.nc_slot(name, instance);
        if (slot < 0) missing = name;
        return slot;
    };
    const auto plc = [&](const char* name, std::uint32_t instance) {
        const std::int32_t slot = host.plc_slot(name, instance);
        if (slot < 0) missing = name;
        return slot;
    };
    const auto parameter = [&](const char* number, std::uint32_t instance) {
        double value = 0.0;
        if (!host.parameter(number, instance, &value)) missing = number;
        return value;
    };
    if (host.channels < kChannels || host.spindles < kSpindles) return "the capacities of the image";
    for (std::uint32_t c = 1; c <= kChannels; ++c) {
        channel_slots_[c - 1] = {nc("CN_RESET", c), nc("CN_MSTR", c), nc("CN_MCODE", c), nc("CN_SSTR", c), nc("CN_TSTR", c),
                                 nc("CN_TCODE", c), nc("CN_SSEL", c), plc("CP_MFIN", c), plc("CP_SFIN", c), plc("CP_TFIN", c),
                                 plc("CP_FIN", c), plc("CP_ACTT", c)};
        turret_time_s_[c - 1] = parameter("PT_TURRET_TIME", c);
        stations_[c - 1] = static_cast<std::int32_t>(parameter("PT_TURRET_STATIONS", c));
        driven_spindle_[c - 1] = static_cast<std::uint32_t>(parameter("PT_DRIVEN_SPINDLE", c));
        if (driven_spindle_[c - 1] > kSpindles) driven_spindle_[c - 1] = 0;
    }
    for (std::uint32_t s = 1; s <= kSpindles; ++s) {
        chuck_time_s_[s - 1] = parameter("PT_CHUCK_TIME", s);
        spindle_slots_[s - 1] = {nc("SN_NS", s), nc("SN_N0", s), nc("SN_INPOS", s), plc("SP_ROT", s), plc("SP_OREQ", s)};
    }
    machine_on_slot_ = nc("N_MACHINE_ON", 1);
    emergency_slot_ = nc("N_ESTOP", 1);
    message_slot_ = plc("PLC_ALARM", 1);
    tick_s_ = host.tick_s;
    return missing;
}

std::int64_t LathePlc::ticks(double seconds) const { return static_cast<std::int64_t>(std::ceil(seconds / tick_s_ - 1e-9)); }

void LathePlc::cycle(const PolyturnPlcInputs& in, PolyturnPlcOutputs& out) {
    const View view{in, out};
    if (first_ && static_cast<double>(in.tick) * tick_s_ > kFreshMachineS) {
        // Started into a machine that has run before: what was asked of a predecessor is not done a second time.
        for (std::uint32_t c = 1; c <= kChannels; ++c)
            at(c).reset_seen = in.signal[slots(c).reset], at(c).m_seen = in.signal[slots(c).m_strobe], at(c).s_seen = in.signal[slots(c).s_strobe],
            at(c).t_seen = in.signal[slots(c).t_strobe];
        for (std::uint32_t c = 1; c <= kChannels; ++c)
            out.signal[slots(c).m_fin] = at(c).m_seen, out.signal[slots(c).s_fin] = at(c).s_seen, out.signal[slots(c).t_fin] = at(c).t_seen;
    }
    first_ = false;
    const bool live = in.signal[machine_on_slot_] != 0 && in.signal[emergency_slot_] == 0;
    if (!live) stop_everything();
    for (std::uint32_t c = 1; c <= kChannels; ++c) {
        if (const std::int32_t count = in.signal[slots(c).reset]; count != at(c).reset_seen) {
            at(c).reset_seen = count;
            end_of_channel(c);
            // What the channel had asked for is void; the counts are answered so that its next code is a new one.
            at(c).pending = {};
            at(c).t_pending = false;
            at(c).message = kNoMessage;
            out.signal[slots(c).m_fin] = at(c).m_seen = in.signal[slots(c).m_strobe];
            out.signal[slots(c).s_fin] = at(c).s_seen = in.signal[slots(c).s_strobe];
            out.signal[slots(c).t_fin] = at(c).t_seen = in.signal[slots(c).t_strobe];
        }
        if (live) {
            take_codes(view, c);
            watch_pending(view, c);
            move_turret(view, c);
        }
    }
    write_outputs(view);
}

void LathePlc::take_codes(View view, std::uint32_t channel) {
    Channel& me = at(channel);
    const auto& slot = slots(channel);
    if (const std::int32_t count = view.in.signal[slot.s_strobe]; count != me.s_seen) {
        me.s_seen = view.out.signal[slot.s_fin] = count;
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

void LathePlc::start_m(View view, std::uint32_t channel, std::int32_t code) {
    Channel& me = at(channel);
    const std::int32_t selected_raw = view.in.signal[slots(channel).selected];
    const std::uint32_t selected = selected_raw > 0 && selected_raw <= static_cast<std::int32_t>(kSpindles) ? static_cast<std::uint32_t>(selected_raw) : 0;
    const std::uint32_t driven = driven_spindle_[channel - 1];
    me.pending = {};
    switch (code) {
        case 3: return turn(view, channel, selected, Rotation::Right);
        case 4: return turn(view, channel, selected, Rotation::Left);
        case 5: return turn(view, channel, selected, Rotation::Stop);
        case 19: return turn(view, channel, selected, Rotation::Orient);
        case 13: return turn(view, channel, driven, Rotation::Right);
        case 14: return turn(view, channel, driven, Rotation::Left);
        case 15: return turn(view, channel, driven, Rotation::Stop);
        case 8: me.coolant = true; break;
        case 9: me.coolant = false; break;
        case 10:
        case 11: {
            if (selected == 0) return refuse(channel, kNoSpindle);
            const bool open = code == 11;
            const bool stands = view.in.signal[spindle_slots_[selected - 1].stands] != 0 && spindles_[selected - 1].rotation == Rotation::Stop;
            if (open && !stands) return refuse(channel, kChuckWhileTurning);
            spindles_[selected - 1].chuck_open = open;
            me.pending = {Task::Chuck, selected, 0, view.in.tick + ticks(chuck_time_s_[selected - 1]), 0};
            return;
        }
        case 2:
        case 30: end_of_channel(channel); break;
        default: break;
    }
    finish_m(view, channel);
}

void LathePlc::turn(View view, std::uint32_t channel, std::uint32_t spindle, Rotation rotation) {
    if (spindle == 0) return refuse(channel, kNoSpindle);
    Spindle& s = spindles_[spindle - 1];
    if (rotation != Rotation::Stop && s.chuck_open) return refuse(channel, kTurningWhileOpen);
    s.rotation = rotation;
    s.started_by = rotation == Rotation::Stop ? 0 : channel;
    const Task task = rotation == Rotation::Stop ? Task::Standstill : rotation == Rotation::Orient ? Task::InPosition : Task::Speed;
    at(channel).pending = {task, spindle, view.in.cycle + kCyclesUntilAnswer, view.in.tick + ticks(kSpindleTimeS), view.in.tick};
}

void LathePlc::refuse(std::uint32_t channel, Message message) {
    at(channel).pending = {Task::Refused, 0, 0, 0, 0};
    at(channel).message = message;
}

void LathePlc::finish_m(View view, std::uint32_t channel) {
    at(channel).pending = {};
    view.out.signal[slots(channel).m_fin] = at(channel).m_seen;
    ++at(channel).finished;
}

void LathePlc::watch_pending(View view, std::uint32_t channel) {
    Pending& pending = at(channel).pending;
    if (pending.task == Task::None || pending.task == Task::Refused) return;
    if (pending.task == Task::Chuck) {
        if (view.in.tick >= pending.due_tick) finish_m(view, channel);
        return;
    }
    const auto& flags = spindle_slots_[pending.spindle - 1];
    const bool stands = view.in.signal[flags.stands] != 0;
    if (!stands) pending.stood_tick = view.in.tick;
    bool done = false;
    switch (pending.task) {
        // At standstill both flags are 1, also in the first moments of a start. A spindle that stays there is meant to.
        case Task::Speed: done = view.in.signal[flags.reached] != 0 && (!stands || view.in.tick - pending.stood_tick >= ticks(kMeantToStandS)); break;
        case Task::Standstill: done = stands; break;
        default: done = view.in.signal[flags.in_position] != 0; break;
    }
    if (view.in.cycle < pending.believe_cycle) return;
    if (!done && view.in.tick >= pending.due_tick) return refuse(channel, kSpindleTooSlow);
    if (done) finish_m(view, channel);
}

void LathePlc::start_t(View view, std::uint32_t channel, std::int32_t code) {
    Channel& me = at(channel);
    Turret& turret = me.turret;
    const std::int32_t count = stations_[channel - 1];
    me.t_pending = true;
    if (code < 0 || (count > 0 && code > count)) {
        me.message = kNoSuchStation;  // t_pending stays until the reset: a refused code is not finished
        return;
    }
    turret.target = code == 0 || count == 0 ? turret.station : code;
    if (turret.target == turret.station && turret.step == 0) return;  // move_turret finishes it in this cycle
    const std::int32_t forward = (turret.target - turret.station + count) % count;
    turret.step = 2 * forward <= count ? 1 : -1;
    turret.due_tick = view.in.tick + ticks(turret_time_s_[channel - 1]);
}

void LathePlc::move_turret(View view, std::uint32_t channel) {
    Channel& me = at(channel);
    Turret& turret = me.turret;
    const std::int32_t count = stations_[channel - 1];
    const std::int64_t step_ticks = ticks(turret_time_s_[channel - 1]);
    while (turret.step != 0 && view.in.tick >= turret.due_tick) {
        turret.station = (turret.station - 1 + turret.step + count) % count + 1;
        turret.due_tick += step_ticks;
        if (turret.station == turret.target) turret.step = 0;
    }
    if (!me.t_pending || turret.step != 0 || me.message == kNoSuchStation) return;
    me.t_pending = false;
    view.out.signal[slots(channel).t_fin] = me.t_seen;
    ++me.finished;
}

void LathePlc::end_of_channel(std::uint32_t channel) {
    for (Spindle& s : spindles_)
        if (s.started_by == channel) s.rotation = Rotation::Stop, s.started_by = 0;
    at(channel).coolant = false;
}

void LathePlc::stop_everything() {
    for (Spindle& s : spindles_) s.rotation = Rotation::Stop, s.started_by = 0;
    for (Channel& c : channels_) {
        c.coolant = false;
        c.turret.step = 0;  // halts; the channel's T stays unanswered until its reset
        if (c.turret.target != c.turret.station) c.turret.target = c.turret.station, c.t_pending = false;
    }
}

void LathePlc::write_outputs(View view) const {
    Message message = kNoMessage;
    for (std::size_t c = 0; c < kChannels; ++c) {
        const Channel& me = channels_[c];
        view.out.signal[channel_slots_[c].fin] = me.finished;
        view.out.signal[channel_slots_[c].active_tool] = me.turret.station;
        std::uint8_t* const output = view.out.output + c * kOutputsPerChannel;
        output[kCoolant] = me.coolant;
        output[kTurretTurns] = me.turret.step != 0;
        output[kTurretLocked] = me.turret.step == 0;
        if (message == kNoMessage) message = me.message;
    }
    for (std::size_t s = 0; s < kSpindles; ++s) {
        view.out.signal[spindle_slots_[s].rotation] = static_cast<std::int32_t>(spindles_[s].rotation);
        view.out.signal[spindle_slots_[s].close_loop] = spindles_[s].rotation == Rotation::Orient;
        std::uint8_t* const output = view.out.output + kFirstSpindleOutput + s * kOutputsPerSpindle;
        output[kChuckClamp] = !spindles_[s].chuck_open;
        output[kChuckOpen] = spindles_[s].chuck_open;
    }
    view.out.signal[message_slot_] = message;
}

}  // namespace polyturn::plc
