// Moves that end before their target: at a skip signal, or where a fixed stop is met.
#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {
namespace {
constexpr std::uint16_t kFullTorque = 1000;
}  // namespace

// A skip move (G31; with kFlying it only stores the position) ends where its signal comes: the path
// brakes, the rest of the record is dropped, and the channel, which waits at the barrier behind it,
// continues from the axes' position.
bool ChannelRunner::skip_signal() noexcept {
    if (path_.cursor >= path_.planner->next_record()) {
        allow_torque(nullptr);
        return false;
    }
    const PathRecord& r = record(path_.cursor);
    const bool by_stop = (r.flags & kFixedStop) != 0;  // ended by what the drives feel
    allow_torque(by_stop ? &r : nullptr);
    const bool by_input = r.code >= 0 && static_cast<std::size_t>(r.code) < kInputs;
    // never with all that a drive can give
    for (std::uint32_t i = 0; by_stop && !by_input && !program_.interrupted() && i < r.axis_count;
         ++i) {
        if (r.axis[i] >= kMaxAxes || r.end[i] == r.start[i]) continue;
        if (const std::uint16_t limit = core_.torque_limit(r.axis[i]);
            r.value > 0 || (limit != 0 && limit < kFullTorque))
            continue;
        raise(Alarm::FixedStopNoLimit, name_of('A', r.axis[i]).view());
        break;
    }
    if (!(r.flags & kSkipMove) || (!by_stop && !by_input)) return standing_.skip.ending = false;
    if (by_stop && !standing_.skip.ending) {
        for (std::uint32_t i = 0; i < r.axis_count; ++i)
            if (r.axis[i] < kMaxAxes && r.end[i] != r.start[i] && core_.axes[r.axis[i]].pressing)
                standing_.skip.ending = standing_.skip.came = true;
        if (standing_.skip.ending)
            for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
                core_.axes[a].skip = core_.axes[a].measured();
    }
    if (!by_input) return standing_.skip.ending;
    const bool release = (r.flags & kSkipRelease) != 0;
    // measured in motion: the path goes on to its end
    const bool passes = (r.flags & kFlying) != 0;
    if (!standing_.skip.ending && !(passes && standing_.skip.came) &&
        core_.signals.input(static_cast<std::size_t>(r.code)) != release) {
        standing_.skip.came = true;
        standing_.skip.ending = !passes;
        // The drives latch their encoders the moment the signal comes: a part of a tick ago, if a
        // sensor says so.
        const double part =
            release ? 0.0 : core_.sensors.risen_part(static_cast<std::size_t>(r.code), core_.tick);
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
            core_.axes[a].skip = core_.sensors.position(core_.axes[a], a, part);
    }
    return standing_.skip.ending;
}

// The drives of a move that ends at a torque give no more than that, and as much as ever when it is
// over.
void ChannelRunner::allow_torque(const PathRecord* r) noexcept {
    if (!r && !standing_.skip.torque_given) return;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.config.axes[a].channel == number_) core_.move_torque[a] = 0;
    standing_.skip.torque_given = r != nullptr;
    for (std::uint32_t i = 0; r && i < r->axis_count; ++i)
        // or what AP_TORQ says
        if (r->axis[i] < kMaxAxes && r->end[i] != r->start[i])
            core_.move_torque[r->axis[i]] =
                r->value > 0 ? static_cast<std::uint16_t>(r->value) : std::uint16_t{1000};
}

// The slide goes back from its fixed stop to where it is: what is read at the barrier must be that
// place.
bool ChannelRunner::leaves_stop() const noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.config.axes[a].channel == number_ && core_.axes[a].leaves_stop) return true;
    return false;
}

void ChannelRunner::end_skipped_move() noexcept {
    standing_.skip.ending = false;
    if (path_.step.over) return;  // it came to its end all the same
    const PathRecord& r = record(path_.step.record);
    if (!(r.flags & kSkipMove)) return;
    if (path_.step.s == 0) {  // the signal was on before: nothing is driven, but the block has been
        begin_record(r, 0);
        standing_.skip.came = true;
    }
    place_axes(r, path_.step.s);
    finished(r, path_.step.record, core_.config.tick_s);
    path_.planner->skip(path_.step.record + 1);
    path_.step.ended_from = path_.step.record;
    path_.step.ended_to = path_.step.record + 1;
    path_.step.over = true;
    path_.step.stands = Stands::Moving;
}

}  // namespace polyturn::kernel
