// What happens to a program while its path is held: its block is taken back to act with other
// offsets, another block is executed by hand in between, or it is to begin in its middle.
//
//   kernel                                   channel
//   AskResume (block, part) ------------>    are there new values, and can the block be read again?
//           <----------- answer ---------
//   epoch raised, Resume (block, part) -->   state before the block, offsets as they are now;
//                                            ResumeSink leaves out what is done
#include <cstring>

#include "channels/process/channel_process.hpp"

namespace polyturn::channels {
namespace {

std::string_view text_of(const ChannelEvent& event) {
    return {event.text.data(), ::strnlen(event.text.data(), event.text.size())};
}

}  // namespace

void ChannelProcess::restart(const ChannelEvent& event) {
    if (state_ != State::Idle) return;  // the kernel starts only what rests
    restart_to_ = static_cast<std::int64_t>(event.value);
    restart_set_ = static_cast<std::uint32_t>(event.record);
    parts_left_ = 1;
    running_ = choice_;
    running_.mdi.clear();
    begin_program();
}

// Drives of the channel's axes, by axis index.
AxisValues ChannelProcess::axes_now() {
    AxisValues out{};
    for (unsigned i = 0; i < view_->axis_count; ++i)
        out[i] = *port_.axis_command(view_->axes[i].machine_axis);
    return out;
}

// Without touching what the program has: it goes on with its own values until it is taken back.
void ChannelProcess::look_for_changes() {
    if (!looked_at_) looked_at_ = std::make_unique<ChannelStore>();
    while (!store_->channels[channel_ - 1].read(*looked_at_)) {}
    if (changes_.look(*looked_at_)) {
        operator_changed_ = true;
        store_changed_ = true;
    }
}

// At a barrier, or where a block is read again.
void ChannelProcess::take_changes() {
    if (!operator_changed_ || restart_sink_->searching() || !run_->offsets_changed()) return;
    operator_changed_ = false;
    const AxisValues now = axes_now();
    resume_sink_->go_back(0, 0, false, now, now);
}

void ChannelProcess::ask_resume(const ChannelEvent& event) {
    auto answer = ResumeAnswer::Nothing;
    if (run_ && !held_run_ && !ahead_) {
        look_for_changes();
        const bool away = (event.record & kResumeAway) != 0,
                   wanted = operator_changed_ || away || (event.record & kResumeByHand) != 0;
        const auto serial = static_cast<std::uint64_t>(event.value);
        if (wanted)
            answer = !restart_sink_->searching() && (!away || run_->starts_away()) &&
                             run_->may_resume_at(serial)
                         ? ResumeAnswer::GoesBack
                         : ResumeAnswer::Cannot;
    }
    // P1: the answer, then the number that announces it
    own_->answer.store(static_cast<std::uint32_t>(answer), std::memory_order_relaxed);
    own_->answered.store(event.seq, std::memory_order_release);
    own_->bell.ring();
}

// What was pushed and not executed does not exist.
void ChannelProcess::void_pushed(const ChannelEvent& event) {
    maker_->discard();
    ring_->resume();
    // P3: a number; each record carries its own (the order is stronger than needed)
    own_->epoch.store(event.epoch, std::memory_order_release);
    port_.look();
    sink_->forget();
}

void ChannelProcess::resume(const ChannelEvent& event) {
    void_pushed(event);
    const bool was_left = held_run_ != nullptr;
    if (was_left) {
        run_ = std::move(held_run_);
        run_->shown();
        names_published_ = 0;
    }
    if (!run_) return;
    const auto serial = static_cast<std::uint64_t>(event.value);
    if (!run_->resume_at(serial)) return fail({Alarm::InterruptPlace, {}, {}, {}});
    if (!take_store()) return;
    if (operator_changed_) operator_changed_ = !run_->offsets_changed();
    const AxisValues now = axes_now();
    if (event.record & kResumeAway) {
        AxisValues by{};
        for (unsigned i = 0; i < view_->axis_count; ++i)
            // P1: it was stored before the event that was read
            by[i] = now[i] -
                    kernel_->left_at[view_->axes[i].machine_axis].load(std::memory_order_acquire);
        run_->start_away(by);
    }
    resume_sink_->go_back(serial, static_cast<std::uint32_t>(event.record),
                          (event.record & kResumeBegun) != 0, now, was_left ? left_at_ : now);
    state_ = State::Reading;
}

void ChannelProcess::held_mdi(const ChannelEvent& event) {
    void_pushed(event);
    left_at_ = axes_now();
    view_->start = left_at_;
    if (!held_run_) held_run_ = std::move(run_);
    run_ =
        services_.make_run(*view_, *sink_, port_, {{}, std::string(text_of(event)), choice_.path});
    names_published_ = 0;
    if (const auto started = run_->start(); !started) return fail(started.diagnosis());
    state_ = State::Reading;
}

}  // namespace polyturn::channels
