// What a hold is good for: offsets that change in it act when the program goes on, because the
// channel takes back what it has pushed (architecture 5.6); a block can be entered and executed by
// hand. The channel is asked before anything is discarded: not every block can be read again.
#include <utility>

#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {

ChannelRunner::Place ChannelRunner::place_now() const noexcept {
    if (cursor_ >= inbox_.head(cursor_) || record(cursor_).epoch != epoch_) return {};
    const PathRecord& r = record(cursor_);
    if (is_at_late_stop()) return {r.serial + 1, 1, false};
    const bool within = begun_ || (!step_.over && step_.s > 0 && step_.record == cursor_);
    return {r.serial, r.part, within || (last_serial_ == r.serial && last_part_ == r.part)};
}

// At an M01 whose key was set after the block was read: the blocks behind it have been read ahead,
// and the program continues there.
bool ChannelRunner::is_at_late_stop() const noexcept {
    return state_ == ChannelState::ProgramStop && stop_reason_ == StopReason::M01 &&
           phase_ == Phase::Stopped && cursor_ < visible_end_ && !(record(cursor_).flags & kDrains);
}

// The first block of which nothing has begun: it and what follows was only read ahead. 0: nothing
// was.
std::uint64_t ChannelRunner::first_not_begun() const noexcept {
    // then the path is that of a block entered by hand
    const bool by_hand = program_left_ || held_mdi_;
    const Place at = by_hand ? left_ : place_now();
    if (at.serial == 0) return 0;
    const bool begun = at.begun || at.part > 1 || (!by_hand && last_serial_ == at.serial);
    return begun ? at.serial + 1 : at.serial;
}

// At a position from which pushed records may be taken back: no function, wait or thread is under
// way.
bool ChannelRunner::rests_in_hold() const noexcept {
    if (!segment_ || dead_ || stopped_ || resetting_ || interrupted_ || held_mdi_ ||
        owes_rendezvous_ || !at_rest() || retract_.active() || trail_.active())
        return false;
    const bool held = state_ == ChannelState::Held || (state_ == ChannelState::ProgramStop &&
                                                       stop_reason_ == StopReason::SingleBlock);
    return (held ? phase_ == Phase::None || phase_ == Phase::Dwell : is_at_late_stop()) &&
           (program_left_ || place_now().serial != 0);
}

// Axes were moved in the hold, and the language knows how to go on without going back first (N1337
// #5 REL).
bool ChannelRunner::resumes_elsewhere() const noexcept {
    // P3: a flag, its program is known from the ring (the order is stronger than needed)
    return state_ == ChannelState::Held && retrace_ >= 0 && !program_left_ && rests_in_hold() &&
           segment_->starts_away.load(std::memory_order_acquire) != 0;
}

void ChannelRunner::settle_hold() noexcept {
    if (question_) {
        // P1: the answer, and all that was pushed before it, is visible
        if (dead_ || !segment_)
            question_ = 0;
        else if (segment_->answered.load(std::memory_order_acquire) >= question_)
            take_answer();
    } else if (change_due_ && !program_left_ && stands_in_hold()) {
        ask_to_go_back(BackFor::Change);
    } else if (start_wanted_ && !core_.store.value_open()) {
        start_wanted_ = false;
        cycle_start();
    }
}

void ChannelRunner::ask_to_go_back(BackFor why) noexcept {
    if (outbox_count_ == outbox_.size()) return;
    if (why != BackFor::ByHand) change_due_ = false;
    asked_ = place_now();
    asked_for_ = why;
    tell(ChannelEventKind::AskResume,
         asked_.part | (asked_.begun ? kResumeBegun : 0) |
             (why == BackFor::ByHand ? kResumeByHand : 0) |
             (why == BackFor::Away ? kResumeAway : 0),
         static_cast<double>(asked_.serial));
    question_ = events_sent_ + outbox_count_;
}

void ChannelRunner::take_answer() noexcept {
    question_ = 0;
    // P1: announced by `answered`
    const auto answer = static_cast<ResumeAnswer>(segment_->answer.load(std::memory_order_relaxed));
    const bool goes_back = answer == ResumeAnswer::GoesBack;
    if (asked_for_ == BackFor::Away) {
        if (goes_back) {
            jog_in_hold_ = false;
            go_back_to(asked_, true);
        } else {
            start_wanted_ = false;
            core_.alarm(
                Alarm::NotReady, number_,
                "axes were moved in the hold, and this block cannot go on from elsewhere (press return)",
                0, line_);
        }
    } else if (asked_for_ == BackFor::ByHand) {
        answered_for_block(goes_back);
    } else if (goes_back) {
        go_back_to(asked_);
    } else if (answer == ResumeAnswer::Cannot) {
        core_.alarm(Alarm::ChangeActsLater, number_,
                    "the block in which the program is held cannot be read again", 0, line_);
    }
    if (start_wanted_) {
        start_wanted_ = false;
        cycle_start();
    }
}

// What was pushed and is not executed is void.
void ChannelRunner::discard() noexcept {
    if (cursor_ < visible_end_ && is_motion(record(cursor_)) && !step_.over && step_.s > 0 &&
        step_.record == cursor_)
        trail_.add(record(cursor_), step_.s, 0);
    ++epoch_;
    begin_behind_all();
    step_ = {};
    step_.record = cursor_;
    flying_ = let_pass_ = early_ = kNoRecord;
    positioning_program_.close();
    // a T that was asked about in front of its place may be another one now
    core_.tools.forget(index_);
    phase_ = Phase::None;
    at_boundary_ = true;
    thread_moving_ = thread_committed_ = false;
    begun_ = released_ = passing_ = skipping_ = false;
}

void ChannelRunner::go_back_to(const Place& place, bool away) noexcept {
    const bool stopped = phase_ == Phase::Stopped;  // at an M01
    if ((place.begun || stopped) && cursor_ < visible_end_)
        report(KernelEventKind::RecordEnd, record(cursor_), 0);
    // not retraceable
    if (stopped && cursor_ < visible_end_) trail_.add(record(cursor_), 0, 0);
    // nothing moves before a start
    if (stopped) {
        state_ = ChannelState::Held;
        stop_reason_ = StopReason::Held;
        hold_ = true;
    }
    discard();
    // it stays begun, however often it is read again
    if (place.begun) {
        last_serial_ = place.serial;
        last_part_ = place.part;
    }
    if (away) trail_.clear();  // between its end and here there is a gap
    know_positions();
    tell(ChannelEventKind::Resume,
         place.part | (place.begun ? kResumeBegun : 0) | (away ? kResumeAway : 0),
         static_cast<double>(place.serial));
}

// The block that a start has asked for; the program is still held behind it.
void ChannelRunner::enter_by_hand(StartPermit) noexcept {
    if (asked_for_ == BackFor::ByHand && left_.begun && cursor_ < visible_end_)
        report(KernelEventKind::RecordEnd, record(cursor_), 0);
    asked_for_ = BackFor::Change;
    discard();
    know_positions();
    hand_.runs = std::exchange(hand_.wanted, HandBlock::Of::Nobody);
    tell(ChannelEventKind::HeldMdi, cursor_, 0,
         hand_.runs == HandBlock::Of::List ? lines_.run_next()
                                           : std::string_view(hand_.of_key.data()));
    held_mdi_ = true;
    hold_ = false;
    state_ = ChannelState::Running;
    stop_reason_ = StopReason::None;
}

// Cycle start in a hold. False: an answer must come first, or the program is being taken back.
bool ChannelRunner::ready_to_continue() noexcept {
    // what was set before counts
    if (question_ || core_.store.value_open()) {
        start_wanted_ = true;
        return false;
    }
    if (program_left_ && !held_mdi_) {
        program_left_ = false;
        go_back_to(left_);
        return true;
    }
    if (jog_in_hold_) {
        ask_to_go_back(BackFor::Away);
        start_wanted_ = question_ != 0;
        return false;
    }
    if (change_due_ && stands_in_hold()) {
        ask_to_go_back(BackFor::Change);
        start_wanted_ = question_ != 0;
        return false;
    }
    return true;
}

}  // namespace polyturn::kernel
