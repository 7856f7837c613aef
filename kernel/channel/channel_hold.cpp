// What a hold is good for: offsets that change in it act when the program goes on, because the
// channel takes back what it has pushed (architecture 5.6); a block can be entered and executed by
// hand. The channel is asked before anything is discarded: not every block can be read again.
#include <utility>

#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {

ResumePlace ChannelRunner::place_now() const noexcept {
    if (path_.cursor >= path_.inbox.head(path_.cursor) || record(path_.cursor).epoch != path_.epoch)
        return {};
    const PathRecord& r = record(path_.cursor);
    if (is_at_late_stop()) return {r.serial + 1, 1, false};
    const bool within = standing_.begun ||
                        (!path_.step.over && path_.step.s > 0 && path_.step.record == path_.cursor);
    return {r.serial, r.part,
            within || (shown_.ended_serial == r.serial && shown_.ended_part == r.part)};
}

// At an M01 whose key was set after the block was read: the blocks behind it have been read ahead,
// and the program continues there.
bool ChannelRunner::is_at_late_stop() const noexcept {
    return program_.stopped_by(StopReason::M01) && standing_.phase == Phase::Stopped &&
           path_.cursor < path_.visible_end && !(record(path_.cursor).flags & kDrains);
}

// The first block of which nothing has begun: it and what follows was only read ahead. 0: nothing
// was.
std::uint64_t ChannelRunner::first_not_begun() const noexcept {
    // then the path is that of a block entered by hand
    const bool by_hand = resume_.off_program();
    const ResumePlace at = by_hand ? resume_.left : place_now();
    if (at.serial == 0) return 0;
    const bool begun = at.begun || at.part > 1 || (!by_hand && shown_.ended_serial == at.serial);
    return begun ? at.serial + 1 : at.serial;
}

// At a position from which pushed records may be taken back: no function, wait or thread is under
// way.
bool ChannelRunner::rests_in_hold() const noexcept {
    if (!process_.segment || process_.dead() || process_.frozen() || program_.resets() ||
        program_.interrupted() || resume_.runs_by_hand() || standing_.wait.owed || !at_rest() ||
        thread_.retract.active() || retrace_.trail.active())
        return false;
    const bool held =
        program_.is(ChannelState::Held) || (program_.stopped_by(StopReason::SingleBlock));
    return (held ? standing_.phase == Phase::None || standing_.phase == Phase::Dwell
                 : is_at_late_stop()) &&
           (resume_.program_left() || place_now().serial != 0);
}

// Axes were moved in the hold, and the language knows how to go on without going back first (N1337
// #5 REL).
bool ChannelRunner::resumes_elsewhere() const noexcept {
    // P3: a flag, its program is known from the ring (the order is stronger than needed)
    return program_.is(ChannelState::Held) && retrace_.way != Retrace::Way::Back &&
           !resume_.program_left() && rests_in_hold() &&
           process_.segment->starts_away.load(std::memory_order_acquire) != 0;
}

void ChannelRunner::settle_hold() noexcept {
    if (resume_.question) {
        // P1: the answer, and all that was pushed before it, is visible
        if (process_.dead() || !process_.segment)
            resume_.question = 0;
        else if (process_.segment->answered.load(std::memory_order_acquire) >= resume_.question)
            take_answer();
    } else if (resume_.change_due && !resume_.program_left() && stands_in_hold()) {
        ask_to_go_back(Resume::BackFor::Change);
    } else if (resume_.start_wanted && !core_.store.value_open()) {
        resume_.start_wanted = false;
        cycle_start();
    }
}

void ChannelRunner::ask_to_go_back(Resume::BackFor why) noexcept {
    if (outbox_.full()) return;
    if (why != Resume::BackFor::ByHand) resume_.change_due = false;
    resume_.asked = place_now();
    resume_.asked_for = why;
    tell(ChannelEventKind::AskResume,
         resume_.asked.part | (resume_.asked.begun ? kResumeBegun : 0) |
             (why == Resume::BackFor::ByHand ? kResumeByHand : 0) |
             (why == Resume::BackFor::Away ? kResumeAway : 0),
         static_cast<double>(resume_.asked.serial));
    resume_.question = outbox_.newest();
}

void ChannelRunner::take_answer() noexcept {
    resume_.question = 0;
    // P1: announced by `answered`
    const auto answer =
        static_cast<ResumeAnswer>(process_.segment->answer.load(std::memory_order_relaxed));
    const bool goes_back = answer == ResumeAnswer::GoesBack;
    if (resume_.asked_for == Resume::BackFor::Away) {
        if (goes_back) {
            resume_.aside = false;
            go_back_to(resume_.asked, true);
        } else {
            resume_.start_wanted = false;
            core_.alarm(
                Alarm::NotReady, number_,
                "axes were moved in the hold, and this block cannot go on from elsewhere (press return)",
                0, shown_.line);
        }
    } else if (resume_.asked_for == Resume::BackFor::ByHand) {
        answered_for_block(goes_back);
    } else if (goes_back) {
        go_back_to(resume_.asked);
    } else if (answer == ResumeAnswer::Cannot) {
        core_.alarm(Alarm::ChangeActsLater, number_,
                    "the block in which the program is held cannot be read again", 0, shown_.line);
    }
    if (resume_.start_wanted) {
        resume_.start_wanted = false;
        cycle_start();
    }
}

// What was pushed and is not executed is void.
void ChannelRunner::discard() noexcept {
    if (path_.cursor < path_.visible_end && is_motion(record(path_.cursor)) && !path_.step.over &&
        path_.step.s > 0 && path_.step.record == path_.cursor)
        retrace_.trail.add(record(path_.cursor), path_.step.s, 0);
    ++path_.epoch;
    begin_behind_all();
    path_.step = {};
    path_.step.record = path_.cursor;
    path_.flying = path_.let_pass = standing_.handshake.early = kNoRecord;
    positioning_.close();
    // a T that was asked about in front of its place may be another one now
    core_.tools.forget(index_);
    standing_.phase = Phase::None;
    path_.at_boundary = true;
    thread_.empty();
    standing_.begun = standing_.wait.released = standing_.wait.passing = standing_.skip.ending =
        false;
}

void ChannelRunner::go_back_to(const ResumePlace& place, bool away) noexcept {
    const bool stopped = standing_.phase == Phase::Stopped;  // at an M01
    if ((place.begun || stopped) && path_.cursor < path_.visible_end)
        report(KernelEventKind::RecordEnd, record(path_.cursor), 0);
    // not retraceable
    if (stopped && path_.cursor < path_.visible_end) retrace_.trail.add(record(path_.cursor), 0, 0);
    // nothing moves before a start
    if (stopped) {
        program_.enter(ChannelState::Held, StopReason::Held);
        program_.brake_for(Brake::Hold);
    }
    discard();
    // it stays begun, however often it is read again
    if (place.begun) {
        shown_.ended_serial = place.serial;
        shown_.ended_part = place.part;
    }
    if (away) retrace_.trail.clear();  // between its end and here there is a gap
    know_positions();
    tell(ChannelEventKind::Resume,
         place.part | (place.begun ? kResumeBegun : 0) | (away ? kResumeAway : 0),
         static_cast<double>(place.serial));
}

// The block that a start has asked for; the program is still held behind it.
void ChannelRunner::enter_by_hand(StartPermit) noexcept {
    if (resume_.asked_for == Resume::BackFor::ByHand && resume_.left.begun &&
        path_.cursor < path_.visible_end)
        report(KernelEventKind::RecordEnd, record(path_.cursor), 0);
    resume_.asked_for = Resume::BackFor::Change;
    discard();
    know_positions();
    hand_.block.runs = std::exchange(hand_.block.wanted, HandBlock::Of::Nobody);
    tell(ChannelEventKind::HeldMdi, path_.cursor, 0,
         hand_.block.runs == HandBlock::Of::List ? hand_.lines.run_next()
                                                 : std::string_view(hand_.block.of_key.data()));
    resume_.by_hand = Resume::ByHand::Runs;
    program_.release(Brake::Hold);
    program_.enter(ChannelState::Running, StopReason::None);
}

// Cycle start in a hold. False: an answer must come first, or the program is being taken back.
bool ChannelRunner::ready_to_continue() noexcept {
    // what was set before counts
    if (resume_.question || core_.store.value_open()) {
        resume_.start_wanted = true;
        return false;
    }
    if (resume_.program_left() && !resume_.runs_by_hand()) {
        resume_.by_hand = Resume::ByHand::Program;
        go_back_to(resume_.left);
        return true;
    }
    if (resume_.aside) {
        ask_to_go_back(Resume::BackFor::Away);
        resume_.start_wanted = resume_.question != 0;
        return false;
    }
    if (resume_.change_due && stands_in_hold()) {
        ask_to_go_back(Resume::BackFor::Change);
        resume_.start_wanted = resume_.question != 0;
        return false;
    }
    return true;
}

}  // namespace polyturn::kernel
