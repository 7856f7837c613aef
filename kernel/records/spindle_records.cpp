#include "kernel/records/spindle_records.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/channel/path/standstill.hpp"
#include "kernel/spindles/spindle_couplings.hpp"

namespace polyturn::kernel {
namespace {

// Ownership (architecture 5.9): the last commanding channel owns the spindle, unless the PLC
// decides; a channel that needs the spindle's speed just now keeps it.
bool take_spindle(Channel& c, const PathRecord& r, std::uint32_t number, bool lock) noexcept {
    if (number == 0 || number > kMaxSpindles || !c.core.spindles[number - 1].exists()) {
        c.raise(Alarm::SpindleUnknown, name_of('S', number ? number - 1 : 0).view());
        return false;
    }
    SpindleUnit& spindle = c.core.spindles[number - 1];
    const bool for_release = static_cast<RecordKind>(r.kind) == RecordKind::SpindleMode &&
                             static_cast<SpindleModeCode>(r.code) == SpindleModeCode::Rpm &&
                             (r.mask & 1u);
    if (spindle.coupled() && !for_release) {
        c.raise(Alarm::SpindleFollows, name_of('S', number - 1).view());
        return false;
    }
    const auto assigned = static_cast<std::uint32_t>(c.core.signals.plc(signals::sp_chan(number)));
    const std::uint32_t owner = assigned ? assigned : spindle.locked_by;
    if (owner != 0 && owner != c.number) {
        ShortText text = name_of('S', number - 1);
        text << " belongs to L" << owner;
        // the refused block, not the one before it
        c.shown.show(r);
        c.raise(Alarm::SpindleOwned, text.view());
        return false;
    }
    spindle.owner = c.number;
    spindle.locked_by = lock ? c.number : 0;
    c.core.signals.set_nc(signals::sn_chan(number), static_cast<std::int32_t>(c.number));
    c.core.signals.set_nc(signals::cn_ssel(c.number), static_cast<std::int32_t>(number));
    return true;
}

// Another channel that machines with the follower keeps it: it cuts a thread, taps or turns with
// constant surface speed (locked_by), or its program drives the C axis on that drive. A program in
// hold or at a barrier has it still, one that an alarm has broken off does until its reset: in its
// tool the workpiece is clamped and would turn.
bool needed_elsewhere(const Core& core, std::uint32_t number, std::uint32_t follower) noexcept {
    if (follower < kMaxAxes || follower >= kMaxAxes + kMaxSpindles) return false;
    const std::uint32_t s = follower - static_cast<std::uint32_t>(kMaxAxes);
    if (core.spindles[s].locked_by != 0 && core.spindles[s].locked_by != number) return true;
    for (std::uint32_t a = 0; a < core.config.axis_count; ++a) {
        const std::uint32_t owner = core.axes[a].owner;
        if (core.config.axes[a].on_spindle != s + 1 || !core.shared_axes[a].has_drive ||
            owner == 0 || owner == number)
            continue;
        const auto state = static_cast<ChannelState>(core.signals.nc(signals::cn_state(owner)));
        if (state != ChannelState::Reset && state != ChannelState::Ended) return true;
    }
    return false;
}

// The drive of a spindle that is to follow may be that of a C axis which rests: then it is the
// spindle's as long as it follows. An axis that moves, or that the PLC keeps, is none of this and
// the coupling is refused.
bool calls_follower(Channel& c, std::uint32_t follower) noexcept {
    constexpr int kHandOverTicks = 10;
    if (follower < kMaxAxes || follower >= kMaxAxes + kMaxSpindles ||
        c.core.tick >= c.standing.since + kHandOverTicks)
        return false;
    const std::uint32_t s = follower - static_cast<std::uint32_t>(kMaxAxes);
    for (std::uint32_t a = 0; a < c.core.config.axis_count; ++a) {
        if (c.core.config.axes[a].on_spindle != s + 1 || c.core.axes[a].moving()) continue;
        c.core.spindle_called_until[s] = c.core.tick + 3;
        return c.core.shared_axes[a].has_drive || !c.core.spindles[s].may_follow();
    }
    return false;
}

}  // namespace

bool position_spindle(Channel& c, const PathRecord& r) noexcept {
    const std::uint32_t number =
        r.spindle ? r.spindle : c.core.config.channels[c.index].default_spindle;
    if (c.standing.phase != RecordPhase::Spindle) {
        if (!take_spindle(c, r, number, false)) return false;
        const auto how = static_cast<SpindleApproach>(r.plane[0]);
        // the angle would wait for an M19 that never comes
        const bool open =
            r.mask != 0 && c.core.spindles[number - 1].loop() == SpindleUnit::Loop::Turning;
        if (open || !c.core.spindles[number - 1].demand_position(
                        how == SpindleApproach::Incremental ? r.shape[2] : r.value, how, r.feed)) {
            c.raise(Alarm::SpindleNotClosed, name_of('S', number - 1).view());
            return false;
        }
        // The PLC may have let it go with this very tick.
        if (!c.core.spindles[number - 1].closed() || !c.core.signals.plc(signals::sp_oreq(number)))
            return true;
        c.standing.phase = RecordPhase::Spindle;
        return false;
    }
    if (refuses_detached(c, number)) return false;
    if (c.core.spindles[number - 1].loop() == SpindleUnit::Loop::Turning)
        c.raise(Alarm::SpindleNotClosed, name_of('S', number - 1).view());
    return c.core.spindles[number - 1].in_position();
}

bool couple_spindle(Channel& c, const PathRecord& r) noexcept {
    SpindleCouplings& couplings = *c.core.spindle_couplings;
    const std::uint32_t follower = r.axis[0];
    const bool on = static_cast<SpindleModeCode>(r.code) == SpindleModeCode::Couple;
    if (c.standing.phase == RecordPhase::Spindle) {
        if (!on) return !couplings.follows(follower);
        if (refuses_detached(c, r.spindle) ||
            (follower >= kMaxAxes &&
             refuses_detached(c, follower - static_cast<std::uint32_t>(kMaxAxes) + 1)))
            return false;
        if (!couplings.follows(follower))
            c.raise(Alarm::SpindleCoupleRefused,
                    SpindleCouplings::name_of_follower(follower).view());
        return couplings.synchronous(follower);
    }
    if (on && needed_elsewhere(c.core, c.number, follower)) {
        ShortText detail = SpindleCouplings::name_of_follower(follower);
        detail << ": " << SpindleCouplings::text(SpindleCouplings::Refusal::Busy);
        c.raise(Alarm::SpindleCoupleRefused, detail.view());
        return false;
    }
    if (on && calls_follower(c, follower)) return false;
    c.standing.phase = RecordPhase::Spindle;
    if (!on) {
        // M3 was the follower's
        if ((r.mask & 4u) && r.spindle)
            c.core.signals.set_nc(signals::cn_ssel(c.number), r.spindle);
        couplings.uncouple(follower);
        return !couplings.follows(follower);
    }
    SpindleCouplings::Wish wish;
    wish.master = r.spindle;
    wish.follower = follower;
    wish.turns = r.shape[0];
    wish.master_turns = r.shape[1];
    wish.phased = !std::isnan(r.shape[2]);
    wish.phase = wish.phased ? r.shape[2] / 360.0 : 0.0;
    wish.gear = (r.mask & 1u) != 0;
    // The cutter's direction is that of the program's sign, whichever way the workpiece turns.
    if ((r.mask & 2u) && wish.master >= 1 && wish.master <= kMaxSpindles &&
        c.core.spindles[wish.master - 1].speed() < 0)
        wish.turns = -wish.turns;
    wish.own_rev_s = r.value / 60.0;
    wish.helix = r.axis[1];
    wish.helix_deg_mm = r.shape[3];
    wish.channel = c.number;
    const auto why = couplings.couple(c.core, wish);
    if (why == SpindleCouplings::Refusal::None) return false;
    ShortText detail = SpindleCouplings::name_of_follower(follower);
    detail << ": " << SpindleCouplings::text(why);
    c.raise(Alarm::SpindleCoupleRefused, detail.view());
    return false;
}

void spindle_mode(Channel& c, const PathRecord& r) noexcept {
    const std::uint32_t number =
        r.spindle ? r.spindle : c.core.config.channels[c.index].default_spindle;
    const auto mode = static_cast<RecordKind>(r.kind) == RecordKind::SpindleSpeed
                          ? SpindleModeCode::Rpm
                          : static_cast<SpindleModeCode>(r.code);
    // commands nothing
    const bool watches = mode == SpindleModeCode::Watch || mode == SpindleModeCode::WatchOff;
    if (!(watches && number >= 1 && number <= kMaxSpindles) &&
        !take_spindle(c, r, number, mode == SpindleModeCode::SurfaceSpeed))
        return;
    SpindleUnit& spindle = c.core.spindles[number - 1];
    switch (mode) {
        case SpindleModeCode::Rpm:
            // G92 S: the keys do not go beyond (part 1, 4.4.1)
            if (c.traits().speed_limit_caps_override && r.shape[0] > 0)
                spindle.demand_speed(std::fabs(r.value), r.shape[0]);
            else
                spindle.demand_speed(std::fabs(r.value));
            // The PLC is notified (a gear range may have to be chosen); the path does not wait for
            // its answer.
            c.core.signals.set_nc(signals::cn_scode(c.number),
                                  static_cast<std::int32_t>(std::lround(std::fabs(r.value))));
            c.core.signals.set_nc(signals::cn_sstr(c.number),
                                  c.core.signals.nc(signals::cn_sstr(c.number)) + 1);
            break;
        case SpindleModeCode::Off:
            spindle.demand_speed(0.0);
            break;
        case SpindleModeCode::Limit:
            spindle.limit_surface_speed(r.shape[0] > 0 ? r.shape[0] : r.value);
            break;
        case SpindleModeCode::SurfaceSpeed:
            spindle.demand_surface_speed(
                r.value, r.shape[0],
                std::max(c.core.config.channels[c.index].surface_speed_min_rpm, r.shape[2]),
                r.axis[0], r.shape[1]);
            break;
        case SpindleModeCode::Couple:
        case SpindleModeCode::Uncouple:
        case SpindleModeCode::Position:
            break;  // stationary: position_spindle(), couple_spindle()
        case SpindleModeCode::Watch:
            spindle.watch_fluctuation(true, r.value, r.shape[0], r.shape[2], r.shape[3]);
            break;
        case SpindleModeCode::WatchOff:
            spindle.watch_fluctuation(false, 0, 0, 0, 0);
            break;
    }
}

void spindle_record(Channel& c, const PathRecord& r) noexcept {
    if (static_cast<RecordKind>(r.kind) == RecordKind::SpindleMode &&
        static_cast<SpindleModeCode>(r.code) == SpindleModeCode::Position) {
        (void)position_spindle(c, r);
        c.standing.phase = RecordPhase::None;
        return;
    }
    spindle_mode(c, r);
}

bool standing_spindle_record(Channel& c, const PathRecord& r) noexcept {
    return static_cast<SpindleModeCode>(r.code) == SpindleModeCode::Position
               ? position_spindle(c, r)
               : couple_spindle(c, r);
}

}  // namespace polyturn::kernel
