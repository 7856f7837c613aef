#include "kernel/channel/program/hold.hpp"

#include <utility>

#include "kernel/channel/path/standstill.hpp"
#include "kernel/channel/program/blocks_by_hand.hpp"
#include "kernel/channel/program/start.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {
namespace {

// At an M01 whose key was set after the block was read: the blocks behind it have been read ahead,
// and the program continues there.
bool is_at_late_stop(const Channel& c) noexcept {
    return c.program.stopped_by(StopReason::M01) && c.standing.phase == RecordPhase::Stopped &&
           c.path.cursor < c.path.visible_end && !(c.path.here().flags & kDrains);
}

ResumePlace place_now(const Channel& c) noexcept {
    if (c.path.cursor >= c.path.inbox.head(c.path.cursor) || c.path.here().epoch != c.path.epoch)
        return {};
    const PathRecord& r = c.path.here();
    if (is_at_late_stop(c)) return {r.serial + 1, 1, false};
    const bool within = c.standing.begun || c.path.within();
    return {r.serial, r.part,
            within || (c.shown.ended_serial == r.serial && c.shown.ended_part == r.part)};
}

// At a position from which pushed records may be taken back: no function, wait or thread is under
// way.
bool rests_in_hold(const Channel& c) noexcept {
    if (!c.process.segment || c.process.dead() || c.process.frozen() || c.program.resets() ||
        c.program.interrupted() || c.resume.runs_by_hand() || c.standing.wait.owed ||
        !c.at_rest() || c.thread.retract.active() || c.retrace.trail.active())
        return false;
    const bool held =
        c.program.is(ChannelState::Held) || (c.program.stopped_by(StopReason::SingleBlock));
    return (held ? c.standing.phase == RecordPhase::None || c.standing.phase == RecordPhase::Dwell
                 : is_at_late_stop(c)) &&
           (c.resume.program_left() || place_now(c).serial != 0);
}

void go_back_to(Channel& c, const ResumePlace& place, bool away = false) noexcept {
    const bool stopped = c.standing.phase == RecordPhase::Stopped;  // at an M01
    if ((place.begun || stopped) && c.path.cursor < c.path.visible_end)
        c.report(KernelEventKind::RecordEnd, c.path.here(), 0);
    // not retraceable
    if (stopped && c.path.cursor < c.path.visible_end) c.retrace.trail.add(c.path.here(), 0, 0);
    // nothing moves before a start
    if (stopped) {
        c.program.enter(ChannelState::Held, StopReason::Held);
        c.program.brake_for(Brake::Hold);
    }
    discard_ahead(c);
    // it stays begun, however often it is read again
    if (place.begun) c.shown.ended(place.serial, place.part);
    if (away) c.retrace.trail.clear();  // between its end and here there is a gap
    know_positions(c.core, c.number);
    c.tell(ChannelEventKind::Resume,
           place.part | (place.begun ? kResumeBegun : 0) | (away ? kResumeAway : 0),
           static_cast<double>(place.serial));
}

void take_answer(Channel& c) noexcept {
    c.resume.question = 0;
    // P1: announced by `answered`
    const auto answer =
        static_cast<ResumeAnswer>(c.process.segment->answer.load(std::memory_order_relaxed));
    const bool goes_back = answer == ResumeAnswer::GoesBack;
    if (c.resume.asked_for == Resume::BackFor::Away) {
        if (goes_back) {
            c.resume.aside = false;
            go_back_to(c, c.resume.asked, true);
        } else {
            c.resume.start_wanted = false;
            c.core.alarm(
                Alarm::NotReady, c.number,
                "axes were moved in the hold, and this block cannot go on from elsewhere (press return)",
                0, c.shown.line);
        }
    } else if (c.resume.asked_for == Resume::BackFor::ByHand) {
        answered_for_block(c, goes_back);
    } else if (goes_back) {
        go_back_to(c, c.resume.asked);
    } else if (answer == ResumeAnswer::Cannot) {
        c.core.alarm(Alarm::ChangeActsLater, c.number,
                     "the block in which the program is held cannot be read again", 0,
                     c.shown.line);
    }
    if (c.resume.start_wanted) {
        c.resume.start_wanted = false;
        start_by(c, {});
    }
}

}  // namespace

std::uint64_t first_not_begun(const Channel& c) noexcept {
    // then the path is that of a block entered by hand
    const bool by_hand = c.resume.off_program();
    const ResumePlace at = by_hand ? c.resume.left : place_now(c);
    if (at.serial == 0) return 0;
    const bool begun = at.begun || at.part > 1 || (!by_hand && c.shown.ended_serial == at.serial);
    return begun ? at.serial + 1 : at.serial;
}

bool stands_in_hold(const Channel& c) noexcept { return !c.resume.aside && rests_in_hold(c); }

bool resumes_elsewhere(const Channel& c) noexcept {
    // P3: a flag, its program is known from the ring (the order is stronger than needed)
    return c.program.is(ChannelState::Held) && c.retrace.way != Retrace::Way::Back &&
           !c.resume.program_left() && rests_in_hold(c) &&
           c.process.segment->starts_away.load(std::memory_order_acquire) != 0;
}

void settle_hold(Channel& c) noexcept {
    if (c.resume.question) {
        // P1: the answer, and all that was pushed before it, is visible
        if (c.process.dead() || !c.process.segment)
            c.resume.question = 0;
        else if (c.process.segment->answered.load(std::memory_order_acquire) >= c.resume.question)
            take_answer(c);
    } else if (c.resume.change_due && !c.resume.program_left() && stands_in_hold(c)) {
        ask_to_go_back(c, Resume::BackFor::Change);
    } else if (c.resume.start_wanted && !c.core.store.value_open()) {
        c.resume.start_wanted = false;
        start_by(c, {});
    }
}

void ask_to_go_back(Channel& c, Resume::BackFor why) noexcept {
    if (c.outbox.full()) return;
    if (why != Resume::BackFor::ByHand) c.resume.change_due = false;
    c.resume.asked = place_now(c);
    c.resume.asked_for = why;
    c.tell(ChannelEventKind::AskResume,
           c.resume.asked.part | (c.resume.asked.begun ? kResumeBegun : 0) |
               (why == Resume::BackFor::ByHand ? kResumeByHand : 0) |
               (why == Resume::BackFor::Away ? kResumeAway : 0),
           static_cast<double>(c.resume.asked.serial));
    c.resume.question = c.outbox.newest();
}

void discard_ahead(Channel& c) noexcept {
    if (c.path.cursor < c.path.visible_end && is_motion(c.path.here()) && c.path.within())
        c.retrace.trail.add(c.path.here(), c.path.step.s, 0);
    ++c.path.epoch;
    c.path.begin_behind_all();
    c.path.stand_here();
    c.positioning.close();
    // a T that was asked about in front of its place may be another one now
    c.core.tools.forget(c.index);
    c.standing.forget();
    c.thread.empty();
}

void enter_by_hand(Channel& c, StartPermit) noexcept {
    if (c.resume.asked_for == Resume::BackFor::ByHand && c.resume.left.begun &&
        c.path.cursor < c.path.visible_end)
        c.report(KernelEventKind::RecordEnd, c.path.here(), 0);
    c.resume.asked_for = Resume::BackFor::Change;
    discard_ahead(c);
    know_positions(c.core, c.number);
    c.hand.block.runs = std::exchange(c.hand.block.wanted, HandBlock::Of::Nobody);
    c.tell(ChannelEventKind::HeldMdi, c.path.cursor, 0,
           c.hand.block.runs == HandBlock::Of::List ? c.hand.lines.run_next()
                                                    : std::string_view(c.hand.block.of_key.data()));
    c.resume.by_hand = Resume::ByHand::Runs;
    c.program.release(Brake::Hold);
    c.program.enter(ChannelState::Running, StopReason::None);
}

bool ready_to_continue(Channel& c) noexcept {
    // what was set before counts
    if (c.resume.question || c.core.store.value_open()) {
        c.resume.start_wanted = true;
        return false;
    }
    if (c.resume.program_left() && !c.resume.runs_by_hand()) {
        c.resume.by_hand = Resume::ByHand::Program;
        go_back_to(c, c.resume.left);
        return true;
    }
    if (c.resume.aside) {
        ask_to_go_back(c, Resume::BackFor::Away);
        c.resume.start_wanted = c.resume.question != 0;
        return false;
    }
    if (c.resume.change_due && stands_in_hold(c)) {
        ask_to_go_back(c, Resume::BackFor::Change);
        c.resume.start_wanted = c.resume.question != 0;
        return false;
    }
    return true;
}

}  // namespace polyturn::kernel
