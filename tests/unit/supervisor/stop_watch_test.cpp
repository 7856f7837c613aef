// The log of stops: a shift of one channel, played look by look.
#include "kernel/supervisor/start/stop_watch.hpp"

#include <gtest/gtest.h>

#include "ipc/model/languages/wait_name.hpp"

#include <algorithm>
#include <memory>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/image/enums.hpp"
#include "ipc/model/machine/stop_causes.hpp"

namespace polyturn::supervisor {
namespace {

class Shift {
public:
    Shift() { is->step = static_cast<std::uint32_t>(MachineStep::Ready); }
    // So many seconds in this state, ten looks a second.
    void pass(double seconds, ChannelState state, StopReason reason = StopReason::None,
              bool alarm = false) {
        ChannelStatus& one = is->channels[1];
        one.state = static_cast<std::uint32_t>(state);
        one.stop_reason = static_cast<std::int32_t>(reason);
        one.line = 30;
        for (int look = 0; look < static_cast<int>(seconds * 10); ++look, now += 100)
            for (Stop& stop : watch.look(now, *is, alarm ? 2u : 0u, [](unsigned channel) {
                     return "O" + std::to_string(channel);
                 }))
                told.push_back(std::move(stop));
    }
    std::unique_ptr<MachineStatus> is = std::make_unique<MachineStatus>();
    StopWatch watch;
    std::vector<Stop> told;
    std::int64_t now = 1'000'000;
};

TEST(StopWatch, TellsAStopWhenItHasLastedAndAgainWhenItIsOver) {
    Shift shift;
    shift.pass(20, ChannelState::Reset);  // nothing has run yet
    shift.pass(10, ChannelState::Running);
    EXPECT_TRUE(shift.told.empty());
    shift.pass(12.5, ChannelState::Held, StopReason::Held);
    ASSERT_EQ(shift.told.size(), 1u);
    EXPECT_EQ(shift.told[0].cause, "hold");
    EXPECT_LT(shift.told[0].seconds, 0) << "it still stands";
    EXPECT_EQ(shift.told[0].channel, 2u);
    EXPECT_EQ(shift.told[0].program, "O2");
    EXPECT_EQ(shift.told[0].line, 30u);
    shift.pass(1, ChannelState::Running);
    ASSERT_EQ(shift.told.size(), 2u);
    EXPECT_DOUBLE_EQ(shift.told[1].seconds, 12.5);
    EXPECT_EQ(shift.told[1].begin_ms, shift.told[0].begin_ms) << "the same stop";
}

TEST(StopWatch, LeavesOutWhatBelongsToEveryProgram) {
    Shift shift;
    shift.pass(5, ChannelState::Running);
    shift.is->channels[1].wait_code = 503;
    shift.is->channels[1].wait_missing = 0b101;
    shift.pass(4.5, ChannelState::Waiting);
    shift.pass(1, ChannelState::Running);
    shift.pass(0.9, ChannelState::Held, StopReason::SingleBlock);
    shift.pass(1, ChannelState::Running);
    EXPECT_TRUE(shift.told.empty());
    shift.pass(60, ChannelState::Waiting);
    shift.pass(1, ChannelState::Running);
    ASSERT_EQ(shift.told.size(), 2u);
    EXPECT_EQ(shift.told[1].cause, "wait");
    EXPECT_EQ(shift.told[1].detail, "M503 L1 L3");
    EXPECT_DOUBLE_EQ(shift.told[1].seconds, 60);
}

// Marker 3 is no M3, and WAITE no marker at all.
TEST(StopWatch, NamesAWaitAsTheLanguageOfTheProgramWritesIt) {
    Shift shift;
    shift.pass(5, ChannelState::Running);
    shift.is->channels[1].speaks = static_cast<std::uint32_t>(Dialect::Sinumerik);
    shift.is->channels[1].wait_code = 3;
    shift.is->channels[1].wait_missing = 1;
    shift.pass(60, ChannelState::Waiting);
    shift.is->channels[1].wait_code = kWaitAtProgramEnd;
    shift.pass(60, ChannelState::Waiting);
    shift.pass(1, ChannelState::Running);
    ASSERT_EQ(shift.told.size(), 4u);
    EXPECT_EQ(shift.told[0].detail, "WAITM(3) L1");
    EXPECT_EQ(shift.told[2].detail, "WAITE L1");
}

TEST(StopWatch, TellsTheNextWaitAsAnotherStop) {
    Shift shift;
    shift.pass(2, ChannelState::Running);
    shift.is->channels[1].wait_code = 500;
    shift.is->channels[1].wait_missing = 1;
    shift.pass(7, ChannelState::Waiting);
    shift.is->channels[1].wait_code = 501;  // what was between them was shorter than a look
    shift.pass(9, ChannelState::Waiting);
    ASSERT_EQ(shift.told.size(), 3u);
    EXPECT_EQ(shift.told[1].detail, "M500 L1");
    EXPECT_DOUBLE_EQ(shift.told[1].seconds, 7);
    EXPECT_EQ(shift.told[2].detail, "M501 L1");
}

TEST(StopWatch, NamesTheAlarmOfTheChannelOrOfTheMachine) {
    Shift shift;
    shift.pass(2, ChannelState::Running);
    shift.watch.alarm(2, "020", "radius differs");
    shift.pass(3, ChannelState::Interrupted, StopReason::Alarm, true);
    shift.pass(2, ChannelState::Reset);  // somebody has looked
    shift.pass(2, ChannelState::Running);
    ASSERT_EQ(shift.told.size(), 4u);
    EXPECT_EQ(shift.told[1].cause, "alarm");
    EXPECT_EQ(shift.told[1].number, "020");
    EXPECT_EQ(shift.told[1].detail, "radius differs");
    EXPECT_EQ(shift.told[3].cause, "reset");
    shift.watch.alarm(0, "4", "a drive has failed");
    shift.is->step = static_cast<std::uint32_t>(MachineStep::Stopped);
    shift.pass(3, ChannelState::Held, StopReason::Held);
    ASSERT_EQ(shift.told.size(), 5u);
    EXPECT_EQ(shift.told[4].number, "4") << "the old alarm of the channel is over";
}

TEST(StopWatch, EachStateHasItsCauseAndEachCauseItsName) {
    struct Row {
        ChannelState state;
        StopReason reason;
        MachineStep step;
        const char* cause;
    };
    constexpr Row kRows[] = {
        {ChannelState::Held, StopReason::Held, MachineStep::Ready, "hold"},
        {ChannelState::Held, StopReason::SingleBlock, MachineStep::Ready, "single"},
        {ChannelState::ProgramStop, StopReason::SingleBlock, MachineStep::Ready, "single"},
        {ChannelState::ProgramStop, StopReason::M00, MachineStep::Ready, "program"},
        {ChannelState::ProgramStop, StopReason::M01, MachineStep::Ready, "program"},
        {ChannelState::Held, StopReason::Restart, MachineStep::Ready, "operator"},
        {ChannelState::Held, StopReason::Retrace, MachineStep::Ready, "operator"},
        {ChannelState::ProgramStop, StopReason::Dialogue, MachineStep::Ready, "program"},
        {ChannelState::Waiting, StopReason::Waiting, MachineStep::Ready, "wait"},
        {ChannelState::Interrupted, StopReason::Alarm, MachineStep::Ready, "alarm"},
        {ChannelState::Dead, StopReason::Death, MachineStep::Ready, "dead"},
        {ChannelState::Ended, StopReason::M30, MachineStep::Ready, "ended"},
        {ChannelState::Reset, StopReason::Reset, MachineStep::Ready, "reset"},
        {ChannelState::Held, StopReason::Held, MachineStep::EmergencyStop, "emergency"},
        {ChannelState::Held, StopReason::Held, MachineStep::Off, "off"},
    };
    for (const Row& row : kRows) {
        Shift shift;
        shift.pass(2, ChannelState::Running);
        shift.is->step = static_cast<std::uint32_t>(row.step);
        shift.pass(7, row.state, row.reason);
        ASSERT_EQ(shift.told.size(), 1u) << row.cause;
        EXPECT_EQ(shift.told[0].cause, row.cause);
        EXPECT_NE(std::find(kStopCauses.begin(), kStopCauses.end(), shift.told[0].cause),
                  kStopCauses.end())
            << "the store would refuse it";
    }
}

TEST(StopWatch, EndsWithTheController) {
    Shift shift;
    shift.pass(2, ChannelState::Running);
    shift.pass(10, ChannelState::Ended, StopReason::M30);
    // a reset behind the end changes nothing
    shift.pass(5, ChannelState::Reset);
    EXPECT_EQ(shift.told.size(), 1u);
    const auto last = shift.watch.close(shift.now);
    ASSERT_EQ(last.size(), 1u);
    EXPECT_EQ(last[0].cause, "ended");
    EXPECT_DOUBLE_EQ(last[0].seconds, 15);
}

}  // namespace
}  // namespace polyturn::supervisor
