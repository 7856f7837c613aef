// Values that change in a hold: the kernel asks the channel before it discards anything.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

struct Held : TickRig {
    PathRecord numbered(PathRecord r, std::uint64_t serial, std::uint32_t part) {
        r.serial = serial;
        r.part = part;
        return r;
    }
    void hold_in_second_block() {
        push(1, numbered(line(1, {10, 0}, 50, kExactStop), 1, 1));
        push(1, numbered(line(1, {20, 0}, 50, kExactStop), 2, 1));
        push(1, numbered(stop(1, StopReason::M30), 3, 1));
        start(1);
        run(450);
        command(CommandKind::FeedHold, 1);
        run(150);
        ASSERT_EQ(state(1), ChannelState::Held);
        ASSERT_GT(position(1), 10);
    }
    const ChannelEvent* asked() const {
        for (const ChannelEvent& e : heard[0])
            if (e.kind == static_cast<std::uint32_t>(ChannelEventKind::AskResume)) return &e;
        return nullptr;
    }
    const ChannelEvent* resumed() const {
        for (const ChannelEvent& e : heard[0])
            if (e.kind == static_cast<std::uint32_t>(ChannelEventKind::Resume)) return &e;
        return nullptr;
    }
    void answer(ResumeAnswer a) {
        channel[0]->answer.store(static_cast<std::uint32_t>(a));
        channel[0]->answered.store(asked()->seq);
    }
};

TEST(Hold, AsksWithThePlaceAndGoesBackWhenTheChannelCan) {
    Held rig;
    rig.hold_in_second_block();
    rig.machine->channel(0).store_changed();
    rig.run(3);
    ASSERT_TRUE(rig.asked());
    EXPECT_EQ(rig.asked()->value, 2);
    EXPECT_EQ(rig.asked()->record, (1ull << 32 | 1u));
    EXPECT_FALSE(rig.resumed());
    rig.answer(ResumeAnswer::GoesBack);
    rig.run(3);
    ASSERT_TRUE(rig.resumed());
    EXPECT_EQ(rig.resumed()->epoch, 1u);
    rig.channel[0]->epoch.store(1);
    const double here = rig.position(1);
    PathRecord rest = rig.numbered(rig.line(1, {0, 0.5}, 50), 2, 1);
    rest.start[0] = rest.end[0] = here;
    rig.push(1, rest);
    rig.push(1, rig.stop(1, StopReason::M30));
    EXPECT_EQ(rig.state(1), ChannelState::Held) << "it goes back, but it does not start";
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_EQ(rig.position(1), here) << "what was pushed before is void";
    EXPECT_NEAR(rig.position(2), 0.5, 1e-9);
}

// At the stop behind a block the next one is asked for, however long the stop lasts: the block
// before it is over.
TEST(Hold, AsksForTheNextBlockWhereSingleBlockStands) {
    Held rig;
    rig.push(1, rig.numbered(rig.line(1, {10, 0}, 50), 1, 1));
    rig.push(1, rig.numbered(rig.line(1, {20, 0}, 50), 2, 1));
    rig.push(1, rig.numbered(rig.stop(1, StopReason::M30), 3, 1));
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.start(1);
    rig.run_until_idle();
    rig.run(50);
    ASSERT_EQ(rig.state(1), ChannelState::ProgramStop);
    rig.machine->channel(0).store_changed();
    rig.run(3);
    ASSERT_TRUE(rig.asked());
    EXPECT_EQ(rig.asked()->value, 2) << "serial";
    EXPECT_EQ(rig.asked()->record, 1u) << "its first part, not begun";
}

TEST(Hold, StartsAfterTheAnswerWhenItWasPressedBefore) {
    Held rig;
    rig.hold_in_second_block();
    rig.machine->channel(0).store_changed();
    rig.run(2);
    rig.start(1);
    rig.run(5);
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    rig.answer(ResumeAnswer::Nothing);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
}

TEST(Hold, TellsTheOperatorWhenTheBlockCannotBeReadAgain) {
    Held rig;
    rig.hold_in_second_block();
    rig.machine->channel(0).store_changed();
    rig.run(2);
    rig.answer(ResumeAnswer::Cannot);
    rig.run(2);
    EXPECT_TRUE(rig.alarmed(Alarm::ChangeActsLater, 1));
    EXPECT_FALSE(rig.resumed());
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
}

TEST(Hold, RunsABlockByHandAndStaysHeld) {
    Held rig;
    rig.hold_in_second_block();
    const double left_at = rig.position(1);
    rig.command(CommandKind::Mdi, 1, 1, 0, 0, 0, "G0 Z5");
    rig.run(3);
    EXPECT_FALSE(rig.asked()) << "entering is not starting";
    rig.start(1);
    rig.run(3);
    ASSERT_TRUE(rig.asked());
    rig.answer(ResumeAnswer::GoesBack);
    rig.run(3);
    ASSERT_EQ(rig.heard[0].back().kind, static_cast<std::uint32_t>(ChannelEventKind::HeldMdi));
    EXPECT_STREQ(rig.heard[0].back().text.data(), "G0 Z5");
    rig.channel[0]->epoch.store(1);
    PathRecord move = rig.line(1, {0, 5}, 50, kExactStop);
    move.start[0] = move.end[0] = left_at;
    rig.push(1, move);
    rig.push(1, rig.stop(1, StopReason::End));
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    EXPECT_NEAR(rig.position(2), 5, 1e-9);
    rig.start(1);
    rig.run(3);
    ASSERT_TRUE(rig.resumed());
    EXPECT_EQ(rig.resumed()->value, 2);
    EXPECT_EQ(rig.state(1), ChannelState::Running);
}

// N1337 #5: what an axis was moved by in the hold reaches the channel; other languages want it back
// first.
TEST(Hold, StartsWhereItWasMovedToWhenTheLanguageKnowsHow) {
    for (const bool knows : {false, true}) {
        Held rig;
        rig.channel[0]->starts_away.store(knows);
        rig.hold_in_second_block();
        const double left_at = rig.position(1);
        rig.command(CommandKind::JogInHold, 1);
        rig.run(2);
        rig.command(CommandKind::Step, 0, 5, 0, 1);
        rig.run(1500);
        ASSERT_NEAR(rig.position(1), left_at + 5, 1e-9);
        EXPECT_EQ(rig.kernel->left_at[0].load(), left_at);
        rig.start(1);
        rig.run(3);
        if (!knows) {
            EXPECT_FALSE(rig.asked());
            EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
            EXPECT_EQ(rig.state(1), ChannelState::Held);
            continue;
        }
        ASSERT_TRUE(rig.asked());
        EXPECT_EQ(rig.asked()->record, kResumeAway | kResumeBegun | 1u);
        rig.answer(ResumeAnswer::GoesBack);
        rig.run(3);
        ASSERT_TRUE(rig.resumed());
        EXPECT_EQ(rig.resumed()->record, kResumeAway | kResumeBegun | 1u);
        EXPECT_EQ(rig.state(1), ChannelState::Running);
        rig.command(CommandKind::Step, 0, 1, 0, 1);  // no longer moved by hand
        rig.run(5);
        EXPECT_NEAR(rig.position(1), left_at + 5, 1e-9);
    }
}

TEST(Hold, AStartAwayThatTheBlockDoesNotAllowLeavesTheWayBack) {
    Held rig;
    rig.channel[0]->starts_away.store(1);
    rig.hold_in_second_block();
    const double left_at = rig.position(1);
    rig.command(CommandKind::JogInHold, 1);
    rig.run(2);
    rig.command(CommandKind::Step, 0, 5, 0, 1);
    rig.run(1500);
    rig.start(1);
    rig.run(2);
    rig.answer(ResumeAnswer::Cannot);
    rig.run(5);
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    rig.command(CommandKind::Return, 1);
    rig.run(1500);
    EXPECT_NEAR(rig.position(1), left_at, 1e-6);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
}

TEST(Hold, RestartOfAProgramTellsBlockAndSet) {
    TickRig rig;
    rig.command(CommandKind::Restart, 1, 120, 0, 0, 3);
    rig.command(CommandKind::Restart, 2, 340, 0, 0, 3);
    rig.run(3);
    ASSERT_FALSE(rig.heard[0].empty());
    const ChannelEvent& event = rig.heard[0].back();
    EXPECT_EQ(event.kind, static_cast<std::uint32_t>(ChannelEventKind::Restart));
    EXPECT_EQ(event.value, 120);
    EXPECT_EQ(event.record, 3u);
    rig.push(1, rig.stop(1, StopReason::Restart));
    rig.push(2, rig.stop(2, StopReason::Restart));
    rig.run(5);
    EXPECT_EQ(rig.state(1), ChannelState::ProgramStop);
    rig.push(1, rig.line(1, {10, 0}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
}

TEST(Hold, RestartBlocksThatDoNotFitAreAnAlarm) {
    TickRig rig;
    rig.command(CommandKind::Restart, 1, 10, 0, 0, 3);
    rig.command(CommandKind::Restart, 2, 20, 0, 0, 3);
    rig.push(1, rig.wait(1, 501, 3));
    rig.push(2, rig.stop(2, StopReason::Restart));
    rig.run(10);
    EXPECT_TRUE(rig.alarmed(Alarm::RestartMismatch, 1));
}

}  // namespace
}  // namespace polyturn::kernel
