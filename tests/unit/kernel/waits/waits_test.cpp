// Waits against a model of twenty plain lines, and what the kernel makes of them.
#include "kernel/waits/waits.hpp"

#include <map>
#include <random>

#include "tests/seeds.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

// The rule as one would say it: a meeting (code, set) is open when every channel of the set is
// there or not waited for.
struct Model {
    std::map<unsigned, std::pair<int, ChannelSet>> there;
    ChannelSet release(ChannelSet no_wait) {
        ChannelSet out = 0;
        for (const auto& [channel, at] : there) {
            bool open = true;
            for (unsigned k = 0; k < kMaxChannels; ++k) {
                if (!(at.second >> k & 1u) || k == channel || (no_wait >> k & 1u)) continue;
                open = open && there.count(k) && there[k] == at;
            }
            if (open || (no_wait >> channel & 1u)) out |= 1u << channel;
        }
        for (unsigned k = 0; k < kMaxChannels; ++k)
            if (out >> k & 1u) there.erase(k);
        return out;
    }
};

TEST(Waits, ForTheEndOfAProgramOpensWhenTheOtherRestsWhateverItWaitsFor) {
    WaitBoard board;
    board.arrive(0, WaitBoard::kProgramEnd, 0b011);
    board.arrive(2, WaitBoard::kProgramEnd, 0b110);  // two channels may wait for the same one
    EXPECT_EQ(board.judge(2, 0).fault, WaitBoard::Fault::None);
    EXPECT_EQ(board.release(0), 0u);
    board.arrive(1, 5, 0b010);  // the other's own wait is no arrival here
    EXPECT_EQ(board.release(0), 0b010u);
    board.tell(0, {.live = true});
    board.tell(2, {.live = true});
    board.tell(1, {.ended = true});
    EXPECT_EQ(board.release(0), 0b101u);
    EXPECT_EQ(board.release(0), 0u);
}

// A wait M code may be any number (N2201 to N2202); M100 to M199 are common ones.
TEST(Waits, NoMCodeOfAWaitIsTheEndOfAProgram) {
    for (std::int32_t code = 0; code < 10'000; ++code) {
        WaitBoard board;
        board.tell(2, {.ended = true});
        board.arrive(0, code, 0b111);
        EXPECT_EQ(board.missing(0, 0), 0b110u) << "M" << code;
        board.arrive(1, code, 0b111);
        board.arrive(2, code, 0b111);
        ASSERT_EQ(board.release(0), 0b111u) << "M" << code;
    }
}

TEST(Waits, ReleaseWhomThePlainModelReleases) {
    std::mt19937 random(test_seed(4711));
    for (int round = 0; round < 200; ++round) {
        WaitBoard board;
        Model model;
        for (int tick = 0; tick < 200; ++tick) {
            const unsigned channel = random() % 5;
            if (random() % 3 && !model.there.count(channel)) {
                const int code = 500 + static_cast<int>(random() % 2);
                const ChannelSet set = (random() % 31 + 1) | 1u << channel;
                board.arrive(channel, code, set);
                model.there[channel] = {code, set};
            } else if (random() % 10 == 0) {
                board.leave(channel);
                model.there.erase(channel);
            }
            const ChannelSet no_wait = random() % 4 == 0 ? random() % 32 : 0;
            ASSERT_EQ(board.release(no_wait), model.release(no_wait))
                << "round " << round << ", tick " << tick;
        }
    }
}

TEST(Waits, TellACircleFromAWaitThatAThirdChannelCanOpen) {
    WaitBoard board;
    board.arrive(0, 501, 0b011);
    board.arrive(1, 502, 0b110);
    EXPECT_EQ(board.judge(1, 0).fault, WaitBoard::Fault::None);  // channel 3 may still come to 502
    board.leave(1);
    // but now 2 needs 1, and 1 needs 2
    board.arrive(1, 502, 0b111);
    const auto verdict = board.judge(1, 0);
    EXPECT_EQ(verdict.fault, WaitBoard::Fault::Circle);
    EXPECT_EQ(verdict.with, 0b001u);
    EXPECT_EQ(board.judge(1, 0b001).fault, WaitBoard::Fault::None);  // nobody waits for 1
}

TEST(Waits, SeeACircleOfThree) {
    WaitBoard board;
    board.arrive(0, 501, 0b011);
    board.arrive(1, 502, 0b110);
    board.arrive(2, 503, 0b101);
    const auto verdict = board.judge(2, 0);
    EXPECT_EQ(verdict.fault, WaitBoard::Fault::Circle);
    EXPECT_EQ(verdict.with, 0b011u);
}

TEST(Waits, LetBothChannelsGoInTheSameTick) {
    TickRig rig;
    rig.push(1, rig.line(1, {10, 0}, 20, kExactStop));
    const PathRecord first = rig.wait(1, 500, 0b11), second = rig.wait(2, 500, 0b11);
    rig.push(1, first);
    const PathRecord after = rig.line(1, {5, 0}, 20), other = rig.line(2, {5, 0}, 20);
    rig.push(1, after);
    rig.push(2, second);
    rig.push(2, other);
    rig.start(1);
    rig.start(2);
    rig.run(50);
    EXPECT_EQ(rig.state(2), ChannelState::Waiting);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::cn_wtng(2)), 1);
    rig.run_until_idle();
    const auto* one = rig.find(KernelEventKind::RecordBegin, 1, after.note);
    const auto* two = rig.find(KernelEventKind::RecordBegin, 2, other.note);
    ASSERT_TRUE(one && two);
    EXPECT_EQ(one->tick, two->tick);
    EXPECT_DOUBLE_EQ(one->offset_s, two->offset_s);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::cn_wtng(2)), 0);
}

TEST(Waits, NameAPartnerThatDoesNotRunAndStayOpenForNoWait) {
    TickRig rig;
    rig.push(1, rig.wait(1, 500, 0b11));
    rig.push(1, rig.line(1, {5, 0}, 20));
    rig.start(1);
    rig.run(20);
    EXPECT_EQ(rig.state(1), ChannelState::Waiting);
    EXPECT_TRUE(rig.alarmed(Alarm::WaitPartnerAbsent, 1));
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_nowt(2), 1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 5, 1e-9);
}

TEST(Waits, AlarmInTheLaterChannelWhenTheSetsDiffer) {
    TickRig rig;
    rig.push(1, rig.wait(1, 500, 0b11));
    rig.start(1);
    rig.run(10);
    rig.push(2, rig.wait(2, 500, 0b111));
    rig.start(2);
    rig.run_until_idle();
    EXPECT_TRUE(rig.alarmed(Alarm::WaitOtherSet, 2));
    EXPECT_EQ(rig.state(2), ChannelState::Interrupted);
    EXPECT_EQ(rig.state(1), ChannelState::Waiting);
}

TEST(Waits, AlarmInTheLaterChannelOfACircle) {
    TickRig rig;
    rig.push(1, rig.wait(1, 500, 0b11));
    rig.push(2, rig.wait(2, 501, 0b11));
    rig.start(1);
    rig.run(5);
    rig.start(2);
    rig.run_until_idle();
    EXPECT_TRUE(rig.alarmed(Alarm::WaitDeadlock, 2));
    EXPECT_FALSE(rig.alarmed(Alarm::WaitDeadlock, 1));
}

TEST(Waits, TimeOutByParameter) {
    TickRig rig(
        [](params::Table& t, RunOptions&) { params::put(t, params::pt_wait_timeout, 0.1, 1); });
    rig.push(1, rig.wait(1, 500, 0b11));
    rig.start(1);
    rig.run(90);
    EXPECT_FALSE(rig.alarmed(Alarm::WaitTimeout));
    rig.run(20);
    EXPECT_TRUE(rig.alarmed(Alarm::WaitTimeout, 1));
}

TEST(Waits, StayHeldAfterTheMeetingUntilStart) {
    TickRig rig;
    rig.push(1, rig.wait(1, 500, 0b11));
    rig.push(1, rig.line(1, {5, 0}, 20));
    rig.start(1);
    rig.run(5);
    rig.command(CommandKind::FeedHold, 1);
    rig.push(2, rig.wait(2, 500, 0b11));
    rig.start(2);
    rig.run(50);
    EXPECT_EQ(rig.position(1), 0);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 5, 1e-9);
}

TEST(Waits, AMarkerStandsForAnArrivalUntilItIsClearedOrItsChannelWaitsThere) {
    WaitBoard board;
    board.mark(0, 7, true);
    EXPECT_TRUE(board.open_for(1, 7, 0b11, 0));
    for (int twice = 0; twice < 2; ++twice) {  // it is not used up by others
        board.arrive(1, 7, 0b11);
        EXPECT_EQ(board.release(0), 0b10u);
    }
    board.arrive(0, 7, 0b11);  // its own wait clears it
    EXPECT_EQ(board.release(0), 0u);
    board.arrive(1, 7, 0b11);
    EXPECT_EQ(board.release(0), 0b11u);
    EXPECT_FALSE(board.open_for(1, 7, 0b11, 0));
    board.mark(0, 8, true);
    board.mark(0, 9, true);
    board.mark(0, 8, false);
    EXPECT_FALSE(board.marked(0, 8));
    EXPECT_TRUE(board.marked(0, 9));
    board.mark(0, -1, false);
    EXPECT_FALSE(board.marked(0, 9));
    board.mark(0, 500, true);  // M codes are no markers
    EXPECT_FALSE(board.marked(0, 500));
}

TEST(Waits, FlyDoesNotBrakeWhenThePartnerIsThere) {
    for (const bool partner_first : {true, false}) {
        SCOPED_TRACE(partner_first);
        TickRig rig;
        rig.push(1, rig.line(1, {20, 0}, 50));
        rig.push(1, rig.wait(1, 500, 0b11, kFlying));
        rig.push(1, rig.line(1, {20, 0}, 50));
        const PathRecord other = rig.wait(2, 500, 0b11, kFlying);
        rig.push(2, other);
        rig.start(1);
        if (partner_first) rig.start(2);
        double slowest = 1e9;
        bool fast = false;
        rig.on_tick = [&] {
            const double v = rig.speed_of(1);
            fast = fast || v > 49.99;
            if (fast && rig.position(1) < 35) slowest = std::min(slowest, v);
            if (rig.position(1) > 19.99 && !partner_first) rig.start(2);
        };
        rig.run(2000);
        EXPECT_NEAR(rig.position(1), 40, 1e-9);
        EXPECT_TRUE(rig.find(KernelEventKind::RecordEnd, 2, other.note));
        if (partner_first)
            EXPECT_GT(slowest, 49.9);
        else
            EXPECT_LT(slowest, 1.0);
    }
}

}  // namespace
}  // namespace polyturn::kernel
