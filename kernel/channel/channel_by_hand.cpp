// MDI blocks: the list of those entered, and the keys whose label is a start. Entering moves
// nothing; a start takes the blocks entered before it, line by line, in single block one line each.
// In a hold each start takes one line.
#include <utility>

#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {

void ChannelRunner::enter(std::string_view text) noexcept {
    const auto refuse = [&](std::string_view why) { core_.alarm(Alarm::MdiRefused, number_, why); };
    // of this very tick: it comes first, as it was pressed
    if (program_.resets() && at_rest()) finish_reset();
    if (program_.resets()) return refuse("a reset is under way");
    if (program_.mode != ChannelMode::Mdi && !program_.is(ChannelState::Held))
        return refuse(program_.runs() ? "a program runs" : "the mode is not MDI");
    if (program_.mode != ChannelMode::Mdi && (resume_.start_wanted || !may_leave_for_block()))
        return refuse("no block by hand can run where the program is held");
    if (!hand_.lines.enter(text)) refuse("the list is full of blocks that have not run");
}

void ChannelRunner::clear_entered() noexcept {
    // it was about to be left for one of them
    if (hand_.block.wanted == HandBlock::Of::List) {
        hand_.block.wanted = HandBlock::Of::Nobody;
        resume_.start_wanted = false;
    }
    hand_.lines.clear();
}

// A start takes a line, and not the program.
bool ChannelRunner::line_is_next() const noexcept {
    if (hand_.lines.waiting() == 0) return false;
    if (program_.mode != ChannelMode::Mdi)
        return program_.is(ChannelState::Held) && !resume_.runs_by_hand();
    return program_.begins();
}

// Refused exactly as a start is, but that the modes for moving by hand are those in which such keys
// are pressed.
void ChannelRunner::hand_key(std::string_view text) noexcept {
    const auto refuse = [&](std::string_view why) { core_.alarm(Alarm::MdiRefused, number_, why); };
    const bool held = program_.is(ChannelState::Held);
    if (program_.runs() && !held) return refuse("a program runs");
    if (program_.mode == ChannelMode::Auto && !held) return refuse("the mode is automatic");
    if (hand_.lines.goes_on()) return refuse("the blocks entered before have not run");
    take_keys();
    if (program_.resets() && at_rest()) finish_reset();
    StartView view = start_view();
    view.by_hand_mode = view.lacks_program = view.lacks_block = false;
    const auto permit = permit_of(Door::HandKey, view);
    if (!permit) return;
    if (held && (resume_.question || core_.store.value_open() || !may_leave_for_block()))
        return refuse("no block by hand can run where the program is held");
    copy_text(hand_.block.of_key, text);
    if (held) return begin_in_hold(*permit, HandBlock::Of::Key);
    hand_.block.runs = HandBlock::Of::Key;
    begin_program(*permit, ChannelEventKind::CycleStart, 1, path_.cursor,
                  std::string_view(hand_.block.of_key.data()));
}

void ChannelRunner::begin_line(StartPermit permit) noexcept {
    hand_.block.runs = HandBlock::Of::List;
    begin_program(permit, ChannelEventKind::CycleStart, 1, path_.cursor, hand_.lines.run_next());
}

void ChannelRunner::begin_in_hold(StartPermit permit, HandBlock::Of what) noexcept {
    if (resume_.question || core_.store.value_open()) {  // what was set before counts
        resume_.start_wanted = true;
        return;
    }
    if (!may_leave_for_block()) {
        core_.alarm(Alarm::MdiRefused, number_,
                    "no block by hand can run where the program is held");
        return;
    }
    hand_.block.wanted = what;
    if (resume_.program_left()) return enter_by_hand(permit);
    ask_to_go_back(Resume::BackFor::ByHand);
    resume_.start_wanted = resume_.question != 0;
}

// The start that asked has been taken back by a hold, a reset, an emptied list; or something is
// missing by now.
void ChannelRunner::answered_for_block(bool goes_back) noexcept {
    const bool wanted = std::exchange(resume_.start_wanted, false) &&
                        hand_.block.wanted != HandBlock::Of::Nobody && may_leave_for_block();
    StartView view = start_view();
    view.by_hand_mode = false;
    if (!wanted) {
        resume_.asked_for = Resume::BackFor::Change;
    } else if (!goes_back) {
        core_.alarm(Alarm::NotReady, number_, "the program cannot be left in this block");
    } else if (const auto permit = permit_of(Door::LineInHold, view)) {
        resume_.left = resume_.asked;
        return enter_by_hand(*permit);
    }
    hand_.block.wanted = HandBlock::Of::Nobody;
}

// Without another start, as soon as its channel has heard that the line before is over.
void ChannelRunner::next_line() noexcept {
    // P1 (quiet): all that it pushed is visible
    if (!program_.is(ChannelState::Ended) || program_.resets() || !outbox_.empty() ||
        !process_.segment ||
        process_.segment->quiet.load(std::memory_order_acquire) < outbox_.sent())
        return;
    if (program_.mode != ChannelMode::Mdi || (panel_.keys & kKeySingleBlock) || retrace_.wheel.on)
        return hand_.lines.stand();
    const auto permit = permit_of(Door::EnteredLine, start_view());
    if (!permit) return hand_.lines.stand();
    begin_line(*permit);
}

void ChannelRunner::block_is_over() noexcept {
    hand_.lines.ended();
    hand_.block.runs = HandBlock::Of::Nobody;
}

}  // namespace polyturn::kernel
