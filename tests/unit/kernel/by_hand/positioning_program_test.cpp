// The program that an axis runs by itself beside the path (kernel/by_hand/positioning_program.hpp).
#include <vector>

#include "ipc/image/positioning_step.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

constexpr std::uint32_t kAxis = 0;  // A1, by machine axis from 0

// The PLC has said that programs may move the axis (AP_PAXENA).
constexpr int kPlcHasAnswered = 60;  // ticks

// An axis B that several channels may command.
void shared(params::Table& t, RunOptions&) {
    params::put(t, params::n0100_axis_name1, 'B', 1);
    params::put(t, params::f8250, 3, 1);
}

PathRecord step(TickRig& rig, PositioningStep what, unsigned channel = 1) {
    PathRecord r = rig.blank(channel, RecordKind::PositioningAxis);
    r.code = static_cast<std::int32_t>(what);
    r.axis_count = 1;
    r.axis[0] = kAxis;
    return r;
}

PathRecord move(TickRig& rig, double end, double speed) {
    PathRecord r = step(rig, PositioningStep::Move);
    r.end[0] = end;
    r.v_max = speed;
    return r;
}

PathRecord move_by(TickRig& rig, double way, double speed) {
    PathRecord r = move(rig, way, speed);
    r.code = static_cast<std::int32_t>(PositioningStep::MoveBy);
    return r;
}

PathRecord dwell(TickRig& rig, double seconds) {
    PathRecord r = step(rig, PositioningStep::Dwell);
    r.feed = seconds;
    return r;
}

// The path moves the other axis only, from where it was left.
PathRecord path(TickRig& rig, double by, double feed) {
    PathRecord r = rig.line(1, {0, by}, feed);
    r.axis_count = 1;
    r.axis[0] = r.axis[1];
    r.start[0] = r.start[1];
    r.end[0] = r.end[1];
    return r;
}

void push_program(TickRig& rig, const std::vector<PathRecord>& steps, unsigned channel = 1) {
    rig.push(channel, step(rig, PositioningStep::Begin, channel));
    for (const PathRecord& r : steps) rig.push(channel, r);
    rig.push(channel, step(rig, PositioningStep::End, channel));
}

TEST(PositioningProgram, DoesItsStepsInOrderWhileThePathGoesOn) {
    TickRig rig;
    rig.run(kPlcHasAnswered);
    push_program(rig, {move(rig, 10, 10), dwell(rig, 0.5), move(rig, 4, 10)});
    rig.push(1, path(rig, 30, 10));
    rig.start(1);
    rig.run(1200);  // 1 s to 10, then it dwells
    EXPECT_NEAR(rig.position(1), 10, 1e-9);
    EXPECT_GT(rig.position(2), 10) << "the path does not wait";
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(1)), 1) << "its program is not over";
    rig.run(1200);
    EXPECT_NEAR(rig.position(1), 4, 1e-9);
    rig.run(100);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(1)), 0);
}

TEST(PositioningProgram, IsWaitedForWithItsDwells) {
    TickRig rig;
    rig.run(kPlcHasAnswered);
    push_program(rig, {move(rig, 5, 10), dwell(rig, 1.0)});
    PathRecord await = rig.blank(1, RecordKind::Await);
    await.axis_count = 1;
    await.axis[0] = kAxis;
    rig.push(1, await);
    rig.push(1, path(rig, 10, 20));
    rig.start(1);
    rig.run(1300);
    EXPECT_EQ(rig.position(2), 0);
    rig.run(1200);
    EXPECT_NEAR(rig.position(2), 10, 1e-9);
}

TEST(PositioningProgram, ItsCodesHaveSignalsOfTheirOwn) {
    TickRig rig;
    // a PLC that answers nothing
    rig.plc_program = [](const PlcInputs&, PlcOutputs& out) {
        out.signal[signals::ap_paxena(1)] = 1;
    };
    rig.run(kPlcHasAnswered);
    PathRecord code = step(rig, PositioningStep::Function);
    code.mask = 'M';
    code.value = 77;
    push_program(rig, {code, move(rig, 5, 10)});
    rig.push(1, path(rig, 10, 20));
    rig.start(1);
    rig.run(800);
    const auto& image = rig.machine->core().signals;
    EXPECT_EQ(image.nc(signals::an_paxfstr(1)), 1);
    EXPECT_EQ(image.nc(signals::an_paxflet(1)), 'M');
    EXPECT_EQ(image.nc(signals::an_paxfcode(1)), 77);
    EXPECT_NEAR(rig.position(2), 10, 1e-9) << "the path does not wait for it";
    EXPECT_EQ(rig.position(1), 0) << "the axis does";
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_paxffin(1), 1);
    rig.run(800);
    EXPECT_NEAR(rig.position(1), 5, 1e-9);
}

TEST(PositioningProgram, FiveMayBeStartedAndNotEnded) {
    TickRig rig;
    rig.run(kPlcHasAnswered);
    for (int n = 0; n < 5; ++n) push_program(rig, {dwell(rig, 1.0)});
    rig.start(1);
    rig.run(500);
    EXPECT_FALSE(rig.alarmed(Alarm::BStartsTooMany, 1));
    push_program(rig, {dwell(rig, 1.0)});
    rig.run(100);
    EXPECT_TRUE(rig.alarmed(Alarm::BStartsTooMany, 1));
}

// 3000 steps are more than the axis keeps: the path waits with the Room record until enough of them
// are done.
TEST(PositioningProgram, ThePathWaitsForRoomForALongOne) {
    TickRig rig;
    rig.run(kPlcHasAnswered);
    const auto some = [&](int count) {
        for (int n = 0; n < count; ++n) rig.push(1, dwell(rig, 0.001));
    };
    rig.push(1, step(rig, PositioningStep::Begin));
    rig.start(1);
    for (int n = 0; n < 5; ++n) {
        some(static_cast<int>(kStepsAtOnce) - 1);
        rig.push(1, step(rig, PositioningStep::Room));
        rig.run(50);
    }
    rig.push(1, step(rig, PositioningStep::End));
    rig.push(1, path(rig, 10, 20));
    rig.run(100);
    EXPECT_EQ(rig.position(2), 0);
    EXPECT_FALSE(rig.alarmed(Alarm::BMemoryFull, 1));
    rig.run(4000);
    EXPECT_NEAR(rig.position(2), 10, 1e-9);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(1)), 1) << "the rest of its steps";
    rig.run(3000);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(1)), 0);
}

// The path is broken off while steps are handed over: what is there is done, and the program counts
// as ended.
TEST(PositioningProgram, AProgramWithoutItsEndIsEndedWithItsPath) {
    PositioningProgram program;
    for (int n = 0; n < 20; ++n) {
        PositioningTask task;
        task.what = PositioningStep::Begin;
        ASSERT_TRUE(program.put(task));
        task.what = PositioningStep::Dwell;
        ASSERT_TRUE(program.put(task));
        EXPECT_EQ(program.started(), 1u);
        program.close();
        program.close();
        int steps = 0;
        for (; program.now(); program.next()) ++steps;
        EXPECT_EQ(steps, 3);
        EXPECT_EQ(program.started(), 0u);
    }
}

TEST(PositioningProgram, AResetEndsIt) {
    TickRig rig;
    rig.run(kPlcHasAnswered);
    push_program(rig, {move(rig, 50, 10), move(rig, 0, 10)});
    rig.push(1, rig.dwell(1, 20));
    rig.start(1);
    rig.run(1000);
    rig.command(CommandKind::Reset, 1);
    rig.run(500);
    const double where = rig.position(1);
    EXPECT_EQ(rig.speed_of(1), 0);
    rig.run(2000);
    EXPECT_EQ(rig.position(1), where);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(1)), 0);
}

// F8250 = 3 (fanuc_lathe 10.4.5): the axis of channel 1 obeys programs of channel 2 too. They share
// its coordinate, and whoever was started first goes first.
TEST(PositioningProgram, ProgramsOfTwoChannelsFollowEachOther) {
    TickRig rig(shared);
    rig.run(kPlcHasAnswered);
    push_program(rig, {move(rig, 10, 10), dwell(rig, 0.5), move(rig, 20, 10)});  // 0 to 2.5 s
    push_program(rig, {move_by(rig, 3, 10)}, 2);                                 // from 20
    rig.push(2, rig.dwell(2, 0.1));
    rig.push(2, rig.line(2, {0, 5}, 20));
    rig.start(1);
    rig.run(100);
    rig.start(2);
    rig.run(1200);
    EXPECT_NEAR(rig.position(1), 10, 1e-9)
        << "the other one's program waits, also while this one dwells";
    EXPECT_NEAR(rig.position(4), 5, 1e-9) << "its path does not";
    rig.run(1300);
    EXPECT_NEAR(rig.position(1), 20, 0.5);
    rig.run(600);
    EXPECT_NEAR(rig.position(1), 23, 1e-9);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(1)), 0);
}

// Of three starts, the one of the other channel lies between: it does not wait for both.
TEST(PositioningProgram, TurnsGoByTheOrderOfTheStarts) {
    TickRig rig(shared);
    rig.run(kPlcHasAnswered);
    push_program(rig, {move(rig, 10, 10)});
    rig.push(1, rig.dwell(1, 0.3));
    push_program(rig, {move(rig, 0, 10)});
    rig.push(1, rig.dwell(1, 10));
    push_program(rig, {move_by(rig, 5, 10)}, 2);
    rig.push(2, rig.dwell(2, 10));
    rig.start(1);
    rig.run(100);
    rig.start(2);
    double highest = 0;
    for (int n = 0; n < 4000; ++n) {
        rig.tick();
        highest = std::max(highest, rig.position(1));
    }
    EXPECT_NEAR(highest, 15, 1e-9);
    EXPECT_NEAR(rig.position(1), 0, 1e-9);
}

// A reset of the channel whose turn it is sets the axis free for the other one.
TEST(PositioningProgram, AResetPassesTheAxisOn) {
    TickRig rig(shared);
    rig.run(kPlcHasAnswered);
    push_program(rig, {move(rig, 50, 10)});
    rig.push(1, rig.dwell(1, 20));
    push_program(rig, {move(rig, 0, 10)}, 2);
    rig.push(2, rig.dwell(2, 20));
    rig.start(1);
    rig.run(100);
    rig.start(2);
    rig.run(900);
    EXPECT_GT(rig.position(1), 5);
    rig.command(CommandKind::Reset, 1);
    rig.run(2500);
    EXPECT_NEAR(rig.position(1), 0, 1e-9);
}

// AP_PAXRST: B alone is reset (fanuc_lathe 10.4.6). What the path still hands over of the program
// is dropped with it.
TEST(PositioningProgram, ThePlcEndsItAlone) {
    TickRig rig;
    rig.run(kPlcHasAnswered);
    rig.push(1, step(rig, PositioningStep::Begin));
    rig.push(1, move(rig, 50, 10));
    rig.push(1, rig.dwell(1, 1));  // the path is slow to hand over the rest
    rig.push(1, move(rig, 0, 10));
    rig.push(1, step(rig, PositioningStep::End));
    rig.push(1, path(rig, 30, 10));
    rig.start(1);
    rig.run(500);
    EXPECT_GT(rig.position(1), 1);
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_paxrst(1), 1);
    rig.run(300);
    rig.command(CommandKind::SetSignal, 0, 0, 0, signals::ap_paxrst(1), 1);
    const double where = rig.position(1);
    EXPECT_LT(where, 15);
    rig.run(4500);
    EXPECT_EQ(rig.position(1), where);
    EXPECT_NEAR(rig.position(2), 30, 1e-9) << "the path goes on";
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(1)), 0);
    push_program(rig, {move_by(rig, 2, 10)});
    rig.run(500);
    EXPECT_NEAR(rig.position(1), where + 2, 1e-9) << "the next program begins where it stands";
}

// The channel does not know where the PLC has stopped it: its path must not jump there.
TEST(PositioningProgram, ThePathDoesNotTakeAnAxisThatThePlcHasStopped) {
    TickRig rig;
    rig.run(kPlcHasAnswered);
    push_program(rig, {move(rig, 50, 10)});
    PathRecord await = rig.blank(1, RecordKind::Await);
    await.axis_count = 1;
    await.axis[0] = kAxis;
    rig.push(1, await);
    rig.place(1, 0, 50);
    rig.push(1, rig.line(1, {-10, 0}, 10));
    rig.start(1);
    rig.run(500);
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_paxrst(1), 1);
    rig.run(1000);
    EXPECT_TRUE(rig.alarmed(Alarm::PositioningRefused, 1));
    EXPECT_LT(rig.position(1), 15);
}

TEST(PositioningProgram, ThePlcMustAllowIt) {
    TickRig rig;
    rig.plc_program = [](const PlcInputs&, PlcOutputs&) {};
    rig.run(kPlcHasAnswered);
    push_program(rig, {move(rig, 5, 10)});
    rig.start(1);
    rig.run(500);
    EXPECT_TRUE(rig.alarmed(Alarm::BNotEnabled, 1));
    EXPECT_EQ(rig.position(1), 0);
}

}  // namespace
}  // namespace polyturn::kernel
