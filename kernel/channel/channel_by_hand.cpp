// MDI blocks: the list of those entered, and the keys whose label is a start. Entering moves
// nothing; a start takes the blocks entered before it, line by line, in single block one line each.
// In a hold each start takes one line.
#include <utility>

#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {

void ChannelRunner::enter(std::string_view text) noexcept {
    const auto refuse = [&](std::string_view why) { core_.alarm(Alarm::MdiRefused, number_, why); };
    // of this very tick: it comes first, as it was pressed
    if (resetting_ && at_rest()) finish_reset();
    if (resetting_) return refuse("a reset is under way");
    if (mode_ != ChannelMode::Mdi && state_ != ChannelState::Held)
        return refuse(program_runs() ? "a program runs" : "the mode is not MDI");
    if (mode_ != ChannelMode::Mdi && (start_wanted_ || !may_leave_for_block()))
        return refuse("no block by hand can run where the program is held");
    if (!lines_.enter(text)) refuse("the list is full of blocks that have not run");
}

void ChannelRunner::clear_entered() noexcept {
    // it was about to be left for one of them
    if (hand_.wanted == HandBlock::Of::List) {
        hand_.wanted = HandBlock::Of::Nobody;
        start_wanted_ = false;
    }
    lines_.clear();
}

// A start takes a line, and not the program.
bool ChannelRunner::line_is_next() const noexcept {
    if (lines_.waiting() == 0) return false;
    if (mode_ != ChannelMode::Mdi) return state_ == ChannelState::Held && !held_mdi_;
    return state_ == ChannelState::Reset || state_ == ChannelState::Ended;
}

// Refused exactly as a start is, but that the modes for moving by hand are those in which such keys
// are pressed.
void ChannelRunner::hand_key(std::string_view text) noexcept {
    const auto refuse = [&](std::string_view why) { core_.alarm(Alarm::MdiRefused, number_, why); };
    const bool held = state_ == ChannelState::Held;
    if (program_runs() && !held) return refuse("a program runs");
    if (mode_ == ChannelMode::Auto && !held) return refuse("the mode is automatic");
    if (lines_.goes_on()) return refuse("the blocks entered before have not run");
    take_keys();
    if (resetting_ && at_rest()) finish_reset();
    StartView view = start_view();
    view.by_hand_mode = view.lacks_program = view.lacks_block = false;
    const auto permit = permit_of(Door::HandKey, view);
    if (!permit) return;
    if (held && (question_ || core_.store.value_open() || !may_leave_for_block()))
        return refuse("no block by hand can run where the program is held");
    copy_text(hand_.of_key, text);
    if (held) return begin_in_hold(*permit, HandBlock::Of::Key);
    hand_.runs = HandBlock::Of::Key;
    begin_program(*permit, ChannelEventKind::CycleStart, 1, cursor_,
                  std::string_view(hand_.of_key.data()));
}

void ChannelRunner::begin_line(StartPermit permit) noexcept {
    hand_.runs = HandBlock::Of::List;
    begin_program(permit, ChannelEventKind::CycleStart, 1, cursor_, lines_.run_next());
}

void ChannelRunner::begin_in_hold(StartPermit permit, HandBlock::Of what) noexcept {
    if (question_ || core_.store.value_open()) {  // what was set before counts
        start_wanted_ = true;
        return;
    }
    if (!may_leave_for_block()) {
        core_.alarm(Alarm::MdiRefused, number_,
                    "no block by hand can run where the program is held");
        return;
    }
    hand_.wanted = what;
    if (program_left_) return enter_by_hand(permit);
    ask_to_go_back(BackFor::ByHand);
    start_wanted_ = question_ != 0;
}

// The start that asked has been taken back by a hold, a reset, an emptied list; or something is
// missing by now.
void ChannelRunner::answered_for_block(bool goes_back) noexcept {
    const bool wanted = std::exchange(start_wanted_, false) &&
                        hand_.wanted != HandBlock::Of::Nobody && may_leave_for_block();
    StartView view = start_view();
    view.by_hand_mode = false;
    if (!wanted) {
        asked_for_ = BackFor::Change;
    } else if (!goes_back) {
        core_.alarm(Alarm::NotReady, number_, "the program cannot be left in this block");
    } else if (const auto permit = permit_of(Door::LineInHold, view)) {
        left_ = asked_;
        return enter_by_hand(*permit);
    }
    hand_.wanted = HandBlock::Of::Nobody;
}

// Without another start, as soon as its channel has heard that the line before is over.
void ChannelRunner::next_line() noexcept {
    // P1 (quiet): all that it pushed is visible
    if (state_ != ChannelState::Ended || resetting_ || outbox_count_ > 0 || !segment_ ||
        segment_->quiet.load(std::memory_order_acquire) < events_sent_)
        return;
    if (mode_ != ChannelMode::Mdi || (keys & kKeySingleBlock) || handwheel_) return lines_.stand();
    const auto permit = permit_of(Door::EnteredLine, start_view());
    if (!permit) return lines_.stand();
    begin_line(*permit);
}

void ChannelRunner::block_is_over() noexcept {
    lines_.ended();
    hand_.runs = HandBlock::Of::Nobody;
}

}  // namespace polyturn::kernel
