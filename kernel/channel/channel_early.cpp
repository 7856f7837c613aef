// How much the path knows of what is prepared, and a function that begins before the rapid move in
// front of it has come to rest.
#include <algorithm>
#include <array>
#include <cmath>

#include "ipc/image/compensated_flag.hpp"
#include "kernel/channel/channel_runner.hpp"
#include "kernel/protection/guard.hpp"

namespace polyturn::kernel {

// N1301 MBM 0: of what is prepared the path knows the running block and the next one, three with
// nose-radius compensation. A thread counts as one block: it starts when all of it is known.
std::uint64_t ChannelRunner::end_of_few_blocks(std::uint64_t most) const noexcept {
    std::uint64_t end = path_.cursor;
    unsigned left = path_.cursor < most && (record(path_.cursor).flags & kCompensated) ? 4 : 2;
    for (; end < most && left > 0; ++end) {
        const std::uint32_t flags = record(end).flags;
        if ((flags & kBlockEnd) && !((flags & kThread) && !(flags & kThreadEnd))) --left;
    }
    return end;
}

bool ChannelRunner::holds_surface_speed() const noexcept {
    return speaks() == Dialect::Sinumerik && process_.segment && path_.rapid && !thread_.moving() &&
           program_.runs();
}

std::optional<double> ChannelRunner::cut_begins_at(std::uint32_t axis) const noexcept {
    if (path_.at_boundary || path_.cursor >= path_.visible_end ||
        !is_motion(record(path_.cursor)) || !(record(path_.cursor).flags & kRapid))
        return std::nullopt;
    // A look per tick: bounded, also where a program puts more between the two (then the speed
    // comes with the cut).
    constexpr std::uint64_t kFar = 32;
    const std::uint64_t end = std::min(path_.visible_end, path_.cursor + kFar);
    std::uint64_t last = path_.cursor;  // of the block under way
    while (!(record(last).flags & kBlockEnd) && last + 1 < end && is_motion(record(last + 1)))
        ++last;
    std::uint64_t next = last + 1;
    // what is only reported
    while (next < end && !is_motion(record(next)) && !stops_path(record(next))) ++next;
    if (next >= end || !is_motion(record(next)) || (record(next).flags & kRapid))
        return std::nullopt;
    const PathRecord& r = record(last);
    SlotVector position;
    if (!drives_at(r, kinematics_of(r), r.length, position)) return std::nullopt;
    for (std::uint32_t i = 0; i < r.axis_count; ++i)
        if (r.axis[i] == axis) return position[i];
    return std::nullopt;
}

// What may begin while the rapid move before it is still driven: a code of its own block that comes
// after that block's end.
bool ChannelRunner::starts_in_rapid() noexcept {
    constexpr std::uint32_t kWhole = kRapid | kBlockEnd,
                            kNever = kInPosition | kSkipMove | kFixedStop | kReference | kThread;
    constexpr std::uint32_t kStandsBetween = kKeySingleBlock | kKeyFirstPart;
    if (path_.cursor + 1 >= path_.visible_end || standing_.handshake.early == path_.cursor + 1)
        return false;
    const PathRecord &r = record(path_.cursor), &next = record(path_.cursor + 1);
    if ((r.flags & kWhole) != kWhole || (r.flags & kNever) || next.serial == r.serial) return false;
    if (static_cast<RecordKind>(next.kind) != RecordKind::Aux || (next.flags & kPositioning) ||
        (panel_.keys & kStandsBetween) || standing_.handshake.unfinished || interrupts_.due)
        return false;
    return program_.is(ChannelState::Running) && !retrace_.wheel.on && !path_input().hold &&
           path_.step.speed > 0;
}

// N0421 ROL (nct_parameters_part1 6.4): a block without movement behind a rapid move begins when
// that is braking to its end and each of its axes has fallen below its share of rapid (N0422).
void ChannelRunner::begin_function_early() noexcept {
    if (!core_.config.channels[index_].rapid_overlaps || !starts_in_rapid()) return;
    const PathRecord &r = record(path_.cursor), &next = record(path_.cursor + 1);
    const double v = path_.step.speed, left = r.length - path_.step.s;
    const double braking = 0.5 * v * (v / r.a_max + (r.j_max > 0 ? r.a_max / r.j_max : 0.0));
    constexpr double kNearly = 1.05, kTicks = 2.0;
    const double begins = kNearly * braking + kTicks * v * core_.config.tick_s;
    if (next.code == 'T' && !tool_may_begin(r, next, left - begins)) return;
    if (left > begins) return;
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        const AxisConfig& axis = core_.config.axes[r.axis[i]];
        if (r.end[i] != r.start[i] &&
            v * std::fabs(r.end[i] - r.start[i]) / r.length >= axis.rapid * axis.rapid_share)
            return;
    }
    standing_.handshake.early = path_.cursor + 1;
    begin_record(next, 0);
    strobe(next);
}

// A T turns the turret while the axes still move. With protection on, the whole circle of the
// turret's tools must be free from here to the end of the move, because the turret may be held
// anywhere on it. Without protection, ROL is the setter's confirmation that it is free. If the
// store must be asked which tool is meant, it is asked early enough for the answer to be there in
// time; a refusal is reported when the path has come to the T.
bool ChannelRunner::tool_may_begin(const PathRecord& r, const PathRecord& tool,
                                   double until) noexcept {
    if (ToolClient::managed(core_)) {
        const double soon = path_.step.speed * core_.config.tick_s *
                            static_cast<double>(2 * core_.config.answer_ticks);
        if (until <= soon && core_.tools.call(index_) == ToolClient::Call::None)
            (void)core_.tools.ask(core_, index_, tool);
        if (core_.tools.call(index_) != ToolClient::Call::Answered) return false;
    }
    if (until > 0 || !core_.guard || !core_.guard->protects(number_)) return true;
    if (r.transform != 0 || static_cast<RecordKind>(r.kind) != RecordKind::Line) return false;
    // protection saw the last tick
    const double share =
        (r.length - path_.step.s + path_.step.speed * core_.config.tick_s) / r.length;
    std::array<double, kMaxAxes> way{};
    for (std::uint32_t i = 0; i < r.axis_count; ++i)
        way[r.axis[i]] = share * (r.end[i] - r.start[i]);
    return core_.guard->circle_is_free(number_, way);
}

}  // namespace polyturn::kernel
