#include "kernel/channel/program/blocks_by_hand.hpp"

#include <utility>

#include "kernel/channel/program/hold.hpp"
#include "kernel/channel/program/start.hpp"

namespace polyturn::kernel {

bool may_leave_for_block(const Channel& c) noexcept {
    return c.program.is(ChannelState::Held) && !c.resume.runs_by_hand() &&
           (c.resume.program_left() || stands_in_hold(c));
}

bool line_is_next(const Channel& c) noexcept {
    if (c.hand.lines.waiting() == 0) return false;
    if (c.program.mode != ChannelMode::Mdi)
        return c.program.is(ChannelState::Held) && !c.resume.runs_by_hand();
    return c.program.begins();
}

void begin_line(Channel& c, StartPermit permit) noexcept {
    c.hand.block.runs = HandBlock::Of::List;
    begin_program(c, permit, ChannelEventKind::CycleStart, 1, c.path.cursor,
                  c.hand.lines.run_next());
}

void begin_in_hold(Channel& c, StartPermit permit, HandBlock::Of what) noexcept {
    if (c.resume.question || c.core.store.value_open()) {  // what was set before counts
        c.resume.start_wanted = true;
        return;
    }
    if (!may_leave_for_block(c)) {
        c.core.alarm(Alarm::MdiRefused, c.number,
                     "no block by hand can run where the program is held");
        return;
    }
    c.hand.block.wanted = what;
    if (c.resume.program_left()) return enter_by_hand(c, permit);
    ask_to_go_back(c, Resume::BackFor::ByHand);
    c.resume.start_wanted = c.resume.question != 0;
}

void answered_for_block(Channel& c, bool goes_back) noexcept {
    const bool wanted = std::exchange(c.resume.start_wanted, false) &&
                        c.hand.block.wanted != HandBlock::Of::Nobody && may_leave_for_block(c);
    StartView view = start_view(c);
    view.by_hand_mode = false;
    if (!wanted) {
        c.resume.asked_for = Resume::BackFor::Change;
    } else if (!goes_back) {
        c.core.alarm(Alarm::NotReady, c.number, "the program cannot be left in this block");
    } else if (const auto permit = permit_of(c, Door::LineInHold, view)) {
        c.resume.left = c.resume.asked;
        return enter_by_hand(c, *permit);
    }
    c.hand.block.wanted = HandBlock::Of::Nobody;
}

void next_line(Channel& c) noexcept {
    // P1 (quiet): all that it pushed is visible
    if (!c.program.is(ChannelState::Ended) || c.program.resets() || !c.outbox.empty() ||
        !c.process.segment ||
        c.process.segment->quiet.load(std::memory_order_acquire) < c.outbox.sent())
        return;
    if (c.program.mode != ChannelMode::Mdi || c.panel.has(kKeySingleBlock) || c.retrace.wheel.on)
        return c.hand.lines.stand();
    const auto permit = permit_of(c, Door::EnteredLine, start_view(c));
    if (!permit) return c.hand.lines.stand();
    begin_line(c, *permit);
}

}  // namespace polyturn::kernel
