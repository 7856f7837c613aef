// A channel's process that sends invalid records (record_inbox.hpp), or leads an axis beyond its
// limits: its path comes to rest, the channel is out of work by name, and the others go on or stop
// as after its death (PT_PARTNER_DEATH).
#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {

// What is copied and judged; the path sees no more than that.
void ChannelRunner::take_records() noexcept {
    if (path_.inbox.taken() < path_.limit || path_.inbox.taken() < path_.cursor)
        path_.inbox.take(path_.cursor, path_.limit, path_.epoch, core_, index_);
    if (path_.inbox.kinematics_changed()) forget_trail();
    const std::uint64_t end = std::min(path_.limit, path_.inbox.taken());
    path_.visible_end = end;
    if (core_.config.channels[index_].reads_one_block_ahead)
        path_.visible_end = end_of_few_blocks(end);
}

// Nothing of what the ring holds is wanted any more.
void ChannelRunner::begin_behind_all() noexcept {
    path_.inbox.look(path_.cursor);
    path_.cursor = path_.inbox.head(path_.cursor);
    path_.inbox.begin_at(path_.cursor);
    plan_anew(path_.cursor);
}

void ChannelRunner::turn_away() noexcept {
    const RecordInbox::Refusal& why = path_.inbox.refusal();
    ShortText text = name_of('L', index_);
    text << ": record " << static_cast<std::int64_t>(why.record);
    if (why.line != 0) text << ", line " << why.line;
    text << ": " << why.field;
    if (why.axis < kMaxAxes) text << " " << name_of('A', why.axis).view();
    process_died(Alarm::ChannelHostile, text.view());
}

// Whatever speed the records ask for, no axis is commanded beyond its limits. An axis that would be
// brakes, with all that the path moves. An open loop has no command; a withdrawal from a thread
// adds its own travel, within limits of its own.
void ChannelRunner::watch_commands() noexcept {
    if (thread_.retract.active() || (panel_.keys & kKeyMachineLock)) return;
    MovedAxes moved = axes_.placed;
    moved.add(axes_.placed_before);
    moved.each([&](std::size_t a) {
        const AxisUnit& axis = core_.axes[a];
        if (!axis.exists() || !axis.closed() || axis.bound() || axis.beside || axis.detached ||
            a == axes_.limited || axes_.off_path.any())
            return;
        if (!axis.can_reach(axis.own_target(), program_.emergency())) leave_off_path(a);
    });
}

void ChannelRunner::leave_off_path(std::size_t axis) noexcept {
    path_.inbox.refuse(
        {axis < kMaxAxes ? "command" : "transform", path_.cursor, shown_.line, axis});
    axes_.off_path = axes_.placed;
    axes_.off_path.add(axes_.placed_before);
    (void)brake_axes();
}

bool ChannelRunner::brake_axes() noexcept {
    bool moves = false;
    axes_.off_path.each([&](std::size_t a) {
        AxisUnit& axis = core_.axes[a];
        if (!axis.bound() && !axis.beside) moves = axis.brake(core_.config.tick_s) || moves;
    });
    return moves;
}

// The path is given up: the axes' position on it is unknown.
void ChannelRunner::brake_off_path() noexcept {
    path_.planner->clear(path_.cursor);
    thread_.empty();
    thread_.retract.clear();
    retrace_.trail.clear();
    path_.step = {};
    path_.step.record = path_.cursor;
    if (!brake_axes()) axes_.off_path = axes_.placed = {};
    settle();
}

}  // namespace polyturn::kernel
