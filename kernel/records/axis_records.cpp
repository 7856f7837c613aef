#include "kernel/records/axis_records.hpp"

#include <algorithm>

#include "kernel/channel/path/skip_move.hpp"
#include "kernel/channel/path/standstill.hpp"
#include "kernel/channel/program/positioning_steps.hpp"

namespace polyturn::kernel {

bool begin_positioning(Channel& c, const PathRecord& r) noexcept {
    if (r.axis_count == 0 || r.axis[0] >= kMaxAxes) return true;
    const auto step = static_cast<PositioningStep>(r.code);
    if ((step == PositioningStep::Begin || step == PositioningStep::Room) &&
        !c.positioning.has_room())
        return false;
    if (step == PositioningStep::Room) return true;
    if (step != PositioningStep::Plain) {
        take_step(c, r);
        return true;
    }
    c.core.axes[r.axis[0]].beside = true;
    Core::PositioningRequest wish;
    wish.asked = true;
    wish.target = r.end[0];
    wish.per_turn = static_cast<FeedMode>(r.feed_mode) == FeedMode::PerRevolution;
    wish.speed = wish.per_turn ? r.feed : r.v_max;
    wish.channel = c.number;
    wish.spindle = r.spindle;
    wish.note = r.note;
    wish.line = r.line;
    wish.since = c.core.tick;
    c.core.beside[r.axis[0]] = wish;
    return true;
}

bool await_axes(Channel& c, const PathRecord& r) noexcept {
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        if (r.axis[i] < kMaxAxes) {
            if (runs_positioning(c, r.axis[i])) return false;
            continue;
        }
        const std::uint32_t s = r.axis[i] - static_cast<std::uint32_t>(kMaxAxes);
        if (s >= kMaxSpindles || !c.core.spindles[s].exists()) continue;
        // The PLC may still be at the code that positions it, and what it said acts with the next
        // tick.
        if (c.standing.handshake.unfinished && c.core.signals.plc(signals::cp_mfin(c.number)) !=
                                                   c.core.signals.nc(signals::cn_mstr(c.number)))
            return false;
        if (c.core.tick < c.standing.since + 2) return false;
        const SpindleUnit& spindle = c.core.spindles[s];
        const std::int32_t rotation = c.core.signals.plc(signals::sp_rot(s + 1));
        if (refuses_detached(c, s + 1)) return false;
        if (spindle.loop() == SpindleUnit::Loop::Approach ||
            spindle.loop() == SpindleUnit::Loop::Searching)
            return false;
        if (spindle.closed()                 ? !spindle.in_position()
            : rotation == 3 || rotation == 4 ? !spindle.at_speed(rotation)
                                             : !spindle.standing())
            return false;
    }
    return true;
}

bool limit_torque(Channel& c, const PathRecord& r) noexcept {
    if (r.axis_count == 0 || r.axis[0] >= kMaxAxes) return true;
    const std::uint32_t a = r.axis[0];
    if (c.standing.phase != RecordPhase::Released) {
        c.core.program_torque[a] = static_cast<std::uint16_t>(std::clamp(r.value, 0.0, 1000.0));
        c.core.program_window[a] = r.value > 0 ? r.shape[0] : 0.0;
        // a new window is around its position
        if (c.core.axes[a].pressing && r.shape[0] > 0)
            c.core.axes[a].pressed_at = c.core.axes[a].measured();
        if (r.value > 0) return true;
        allow_torque(c, nullptr);  // the move that ended here is over
        c.standing.phase = RecordPhase::Released;
        return false;
    }
    return c.core.tick > c.standing.since + 1 && !c.core.axes[a].pressing &&
           !c.core.axes[a].beside && !c.core.axes[a].moving();
}

void release_stops(Core& core, std::uint32_t number) noexcept {
    for (std::uint32_t a = 0; a < core.config.axis_count; ++a)
        if (core.config.axes[a].channel == number) {
            core.program_torque[a] = 0;
            core.program_window[a] = 0;
        }
}

bool find_reference(Channel& c, const PathRecord& r) noexcept {
    const bool begins = c.standing.phase != RecordPhase::Home;
    c.standing.phase = RecordPhase::Home;
    bool all = true;
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        const std::uint32_t a = r.axis[i];
        if (a >= kMaxAxes || !c.core.axes[a].exists()) continue;
        if (begins) {
            c.core.home_failed[a] = false;
            c.core.home_request[a] = !c.core.axes[a].referenced;
        }
        if (c.core.home_failed[a]) {
            c.raise(Alarm::ReferenceRefused, name_of('A', a).view());
            return false;
        }
        all = all && c.core.axes[a].referenced && !c.core.home_request[a] && !c.core.home_busy[a] &&
              !c.core.axes[a].moving();
    }
    return all;
}

}  // namespace polyturn::kernel
