// A channel's process that sends invalid records (record_inbox.hpp), or leads an axis beyond its
// limits: its path comes to rest, the channel is out of work by name, and the others go on or stop
// as after its death (PT_PARTNER_DEATH).
#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {

// What is copied and judged; the path sees no more than that.
void ChannelRunner::take_records() noexcept {
    if (inbox_.taken() < limit_ || inbox_.taken() < cursor_)
        inbox_.take(cursor_, limit_, epoch_, core_, index_);
    if (inbox_.kinematics_changed()) forget_trail();
    const std::uint64_t end = std::min(limit_, inbox_.taken());
    visible_end_ = end;
    if (core_.config.channels[index_].reads_one_block_ahead) visible_end_ = end_of_few_blocks(end);
}

// Nothing of what the ring holds is wanted any more.
void ChannelRunner::begin_behind_all() noexcept {
    inbox_.look(cursor_);
    cursor_ = inbox_.head(cursor_);
    inbox_.begin_at(cursor_);
    plan_anew(cursor_);
}

void ChannelRunner::turn_away() noexcept {
    const RecordInbox::Refusal& why = inbox_.refusal();
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
    if (retract_.active() || (keys & kKeyMachineLock)) return;
    MovedAxes moved = placed_;
    moved.add(placed_before_);
    moved.each([&](std::size_t a) {
        const AxisUnit& axis = core_.axes[a];
        if (!axis.exists() || !axis.closed() || axis.bound() || axis.beside || axis.detached ||
            a == limited_axis_ || off_path_.any())
            return;
        if (!axis.can_reach(axis.own_target(), emergency_)) leave_off_path(a);
    });
}

void ChannelRunner::leave_off_path(std::size_t axis) noexcept {
    inbox_.refuse({axis < kMaxAxes ? "command" : "transform", cursor_, line_, axis});
    off_path_ = placed_;
    off_path_.add(placed_before_);
    (void)brake_axes();
}

bool ChannelRunner::brake_axes() noexcept {
    bool moves = false;
    off_path_.each([&](std::size_t a) {
        AxisUnit& axis = core_.axes[a];
        if (!axis.bound() && !axis.beside) moves = axis.brake(core_.config.tick_s) || moves;
    });
    return moves;
}

// The path is given up: the axes' position on it is unknown.
void ChannelRunner::brake_off_path() noexcept {
    planner_->clear(cursor_);
    thread_moving_ = thread_committed_ = false;
    retract_.clear();
    trail_.clear();
    step_ = {};
    step_.record = cursor_;
    if (!brake_axes()) off_path_ = placed_ = {};
    settle();
}

}  // namespace polyturn::kernel
