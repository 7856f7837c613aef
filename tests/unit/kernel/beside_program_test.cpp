// The program that an axis runs by itself beside the path (kernel/cyclic/beside_program.hpp).
#include <vector>

#include "ipc/image/beside_step.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

constexpr std::uint32_t kAxis = 0;   // A1, by machine axis from 0

PathRecord step(TickRig& rig, BesideStep what) {
    PathRecord r = rig.blank(1, RecordKind::Beside);
    r.code = static_cast<std::int32_t>(what);
    r.axis_count = 1;
    r.axis[0] = kAxis;
    return r;
}

PathRecord move(TickRig& rig, double end, double speed) {
    PathRecord r = step(rig, BesideStep::Move);
    r.end[0] = end;
    r.v_max = speed;
    return r;
}

PathRecord dwell(TickRig& rig, double seconds) {
    PathRecord r = step(rig, BesideStep::Dwell);
    r.feed = seconds;
    return r;
}

// The path moves the other axis only, from where it was left.
PathRecord path(TickRig& rig, double by, double feed) {
    PathRecord r = rig.line(1, {0, by}, feed);
    r.axis_count = 1;
    r.axis[0] = r.axis[1], r.start[0] = r.start[1], r.end[0] = r.end[1];
    return r;
}

void push_program(TickRig& rig, const std::vector<PathRecord>& steps) {
    rig.push(1, step(rig, BesideStep::Begin));
    for (const PathRecord& r : steps) rig.push(1, r);
    rig.push(1, step(rig, BesideStep::End));
}

TEST(BesideProgram, DoesItsStepsInOrderWhileThePathGoesOn) {
    TickRig rig;
    push_program(rig, {move(rig, 10, 10), dwell(rig, 0.5), move(rig, 4, 10)});
    rig.push(1, path(rig, 30, 10));
    rig.start(1);
    rig.run(1200);   // 1 s to 10, then it dwells
    EXPECT_NEAR(rig.position(1), 10, 1e-9);
    EXPECT_GT(rig.position(2), 10) << "the path does not wait";
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(1)), 1) << "its program is not over";
    rig.run(1200);
    EXPECT_NEAR(rig.position(1), 4, 1e-9);
    rig.run(100);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(1)), 0);
}

TEST(BesideProgram, IsWaitedForWithItsDwells) {
    TickRig rig;
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

TEST(BesideProgram, ItsCodesHaveSignalsOfTheirOwn) {
    TickRig rig;
    rig.plc_program = [](const PlcInputs&, PlcOutputs&) {};   // a PLC that answers nothing
    PathRecord code = step(rig, BesideStep::Function);
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

TEST(BesideProgram, FiveMayBeStartedAndNotEnded) {
    TickRig rig;
    for (int n = 0; n < 5; ++n) push_program(rig, {dwell(rig, 1.0)});
    rig.start(1);
    rig.run(500);
    EXPECT_FALSE(rig.alarmed(Alarm::BStartsTooMany, 1));
    push_program(rig, {dwell(rig, 1.0)});
    rig.run(100);
    EXPECT_TRUE(rig.alarmed(Alarm::BStartsTooMany, 1));
}

// 3000 steps are more than the axis keeps: the path waits with the Room record until enough of them are done.
TEST(BesideProgram, ThePathWaitsForRoomForALongOne) {
    TickRig rig;
    const auto some = [&](int count) {
        for (int n = 0; n < count; ++n) rig.push(1, dwell(rig, 0.001));
    };
    rig.push(1, step(rig, BesideStep::Begin));
    rig.start(1);
    for (int n = 0; n < 5; ++n) {
        some(static_cast<int>(kStepsAtOnce) - 1);
        rig.push(1, step(rig, BesideStep::Room));
        rig.run(50);
    }
    rig.push(1, step(rig, BesideStep::End));
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

// The path is broken off while steps are handed over: what is there is done, and the program counts as ended.
TEST(BesideProgram, AProgramWithoutItsEndIsEndedWithItsPath) {
    BesideProgram program;
    for (int n = 0; n < 20; ++n) {
        BesideTask task;
        task.what = BesideStep::Begin;
        ASSERT_TRUE(program.put(task));
        task.what = BesideStep::Dwell;
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

TEST(BesideProgram, AResetEndsIt) {
    TickRig rig;
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

}  // namespace
}  // namespace polyturn::kernel
