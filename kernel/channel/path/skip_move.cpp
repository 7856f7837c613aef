#include "kernel/channel/path/skip_move.hpp"

#include "kernel/channel/path/place_axes.hpp"
#include "kernel/records/record_executor.hpp"

namespace polyturn::kernel {
namespace {

constexpr std::uint16_t kFullTorque = 1000;

}  // namespace

bool skip_signal(Channel& c) noexcept {
    if (c.path.cursor >= c.path.planner->next_record()) {
        allow_torque(c, nullptr);
        return false;
    }
    const PathRecord& r = c.path.here();
    const bool by_stop = (r.flags & kFixedStop) != 0;  // ended by what the drives feel
    allow_torque(c, by_stop ? &r : nullptr);
    const bool by_input = r.code >= 0 && static_cast<std::size_t>(r.code) < kInputs;
    // never with all that a drive can give
    for (std::uint32_t i = 0; by_stop && !by_input && !c.program.interrupted() && i < r.axis_count;
         ++i) {
        if (r.axis[i] >= kMaxAxes || r.end[i] == r.start[i]) continue;
        if (const std::uint16_t limit = c.core.torque_limit(r.axis[i]);
            r.value > 0 || (limit != 0 && limit < kFullTorque))
            continue;
        c.raise(Alarm::FixedStopNoLimit, name_of('A', r.axis[i]).view());
        break;
    }
    if (!(r.flags & kSkipMove) || (!by_stop && !by_input)) return c.standing.skip.ending = false;
    if (by_stop && !c.standing.skip.ending) {
        for (std::uint32_t i = 0; i < r.axis_count; ++i)
            if (r.axis[i] < kMaxAxes && r.end[i] != r.start[i] && c.core.axes[r.axis[i]].pressing)
                c.standing.skip.ending = c.standing.skip.came = true;
        if (c.standing.skip.ending)
            for (std::uint32_t a = 0; a < c.core.config.axis_count; ++a)
                c.core.axes[a].skip = c.core.axes[a].measured();
    }
    if (!by_input) return c.standing.skip.ending;
    const bool release = (r.flags & kSkipRelease) != 0;
    // measured in motion: the path goes on to its end
    const bool passes = (r.flags & kFlying) != 0;
    if (!c.standing.skip.ending && !(passes && c.standing.skip.came) &&
        c.core.signals.input(static_cast<std::size_t>(r.code)) != release) {
        c.standing.skip.came = true;
        c.standing.skip.ending = !passes;
        // The drives latch their encoders the moment the signal comes: a part of a tick ago, if a
        // sensor says so.
        const double part =
            release ? 0.0
                    : c.core.sensors.risen_part(static_cast<std::size_t>(r.code), c.core.tick);
        for (std::uint32_t a = 0; a < c.core.config.axis_count; ++a)
            c.core.axes[a].skip = c.core.sensors.position(c.core.axes[a], a, part);
    }
    return c.standing.skip.ending;
}

void allow_torque(Channel& c, const PathRecord* r) noexcept {
    if (!r && !c.standing.skip.torque_given) return;
    for (std::uint32_t a = 0; a < c.core.config.axis_count; ++a)
        if (c.core.config.axes[a].channel == c.number) c.core.move_torque[a] = 0;
    c.standing.skip.torque_given = r != nullptr;
    for (std::uint32_t i = 0; r && i < r->axis_count; ++i)
        // or what AP_TORQ says
        if (r->axis[i] < kMaxAxes && r->end[i] != r->start[i])
            c.core.move_torque[r->axis[i]] =
                r->value > 0 ? static_cast<std::uint16_t>(r->value) : std::uint16_t{1000};
}

bool leaves_stop(const Core& core, std::uint32_t number) noexcept {
    for (std::uint32_t a = 0; a < core.config.axis_count; ++a)
        if (core.config.axes[a].channel == number && core.axes[a].leaves_stop) return true;
    return false;
}

void end_skipped_move(Channel& c) noexcept {
    c.standing.skip.ending = false;
    if (c.path.step.over) return;  // it came to its end all the same
    const PathRecord& r = c.record(c.path.step.record);
    if (!(r.flags & kSkipMove)) return;
    if (c.path.step.s ==
        0) {  // the signal was on before: nothing is driven, but the block has been
        begin_record(c, r, 0);
        c.standing.skip.came = true;
    }
    place_axes(c, r, c.path.step.s);
    end_record(c, r, c.path.step.record, c.core.config.tick_s);
    c.path.planner->skip(c.path.step.record + 1);
    c.path.step.ended_from = c.path.step.record;
    c.path.step.ended_to = c.path.step.record + 1;
    c.path.step.over = true;
    c.path.step.stands = Stands::Moving;
}

}  // namespace polyturn::kernel
