// Skip moves: where the signal came is known to a part of a tick, however far the axes brake behind
// it (architecture 5.6).
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

constexpr std::uint32_t kInput = 7;

PathRecord skip(TickRig& rig, double dz, double feed) {
    PathRecord r = rig.line(1, {0, dz}, feed, kSkipMove | kExactStop);
    r.code = kInput;
    return r;
}

struct Seen {
    bool skipped = false;
    double z = 0;
};
Seen seen(TickRig& rig) {
    MachineStatus status;
    EXPECT_TRUE(rig.kernel->status.read(status));
    return {status.channels[0].skipped != 0, status.axes[1].skip};
}

TEST(Skip, ASensorLatchesThePlaceAtEverySpeed) {
    for (const double feed : {1.0, 7.0, 33.0, 100.0}) {
        SCOPED_TRACE(feed);
        TickRig rig;
        rig.push(1, skip(rig, -50, feed));
        rig.push(1, rig.stop(1, StopReason::M30));
        rig.command(CommandKind::Sensor, 2, -20.0, 0, 2, kInput);  // negative travel
        rig.start(1);
        rig.run_until_idle();
        EXPECT_TRUE(seen(rig).skipped);
        EXPECT_NEAR(seen(rig).z, -20.0, 0.003);
        EXPECT_LE(rig.position(2), -20.0 + 1e-6);
        EXPECT_GT(rig.position(2), -20.0 - 0.1 - feed * feed / 1000.0);
    }
}

TEST(Skip, WithoutItsSignalItEndsAtItsTargetAndSaysSo) {
    TickRig rig;
    rig.push(1, skip(rig, -10, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.command(CommandKind::Sensor, 2, -20.0, 0, 2, kInput);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_FALSE(seen(rig).skipped);
    EXPECT_NEAR(rig.position(2), -10, 1e-9);
}

TEST(Skip, ASensorOfTheOtherDirectionIsSilent) {
    TickRig rig;
    rig.push(1, skip(rig, -30, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.command(CommandKind::Sensor, 1, -20.0, 0, 2, kInput);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_FALSE(seen(rig).skipped);
}

TEST(Skip, AnInputThatIsSetByHandLatchesTheMeasuredPlaceOfThatTick) {
    TickRig rig;
    rig.push(1, skip(rig, -60, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    while (rig.position(2) > -20) rig.tick();
    const double act = rig.machine->core().axes[1].measured();
    rig.command(CommandKind::SetInput, 0, 1, 0, kInput);
    rig.tick();
    rig.run_until_idle();
    EXPECT_TRUE(seen(rig).skipped);
    EXPECT_NEAR(seen(rig).z, act, 0.06);
    EXPECT_LT(rig.position(2), seen(rig).z);
}

TEST(Skip, ASignalThatIsThereAlreadyEndsItWhereItBegins) {
    TickRig rig;
    rig.command(CommandKind::SetInput, 0, 1, 0, kInput);
    rig.push(1, skip(rig, -60, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_TRUE(seen(rig).skipped);
    EXPECT_NEAR(rig.position(2), 0, 1e-9);
}

TEST(Sensors, AForcedInputGoesBackToItsSensor) {
    TickRig rig;
    rig.command(CommandKind::Sensor, 0, -5.0, 0, 2, kInput);
    rig.push(1, rig.line(1, {0, -10}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    const Signals& signals = rig.machine->core().signals;
    EXPECT_TRUE(signals.input(kInput));
    rig.command(CommandKind::SetInput, 0, 0, 0, kInput);
    rig.run(2);
    EXPECT_FALSE(signals.input(kInput));
    rig.command(CommandKind::SetInput, 0, 0, 0, kInput, 1);
    rig.run(2);
    EXPECT_TRUE(signals.input(kInput));
}

}  // namespace
}  // namespace polyturn::kernel
