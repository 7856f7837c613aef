// Absolute encoders, worked out from nct_parameters_part1 10.2 E, 10.3 and 10.4: encoders of few
// bits, counted rounds, axes that were moved while off.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

using params::Table;

// of 1e6 pulses a millimetre: 16.777216 mm a round
constexpr unsigned kBits = 24;
constexpr double kRange = 16.777216;
constexpr std::int64_t kAbs = 0x08, kAbsCir = 0x48;

struct Bench {
    // The machine was left at `left`, and stands at `at` now.
    Bench(std::int64_t type, double left, double at, const std::function<void(Table&)>& more = {})
        : rig(
              [&](Table& t, RunOptions& options) {
                  params::put(t, params::n0900_reference_type, type, 1);
                  params::put(t, params::n0524_endat_resolution, kBits, 1);
                  params::put(t, params::n0909_abs_position_alarm_distance, 1, 1);
                  options.start_known[0] = 1;
                  options.start_position[0] = at;
                  if (more) more(t);
              },
              [left](StoreSegment& store) {
                  store.totals.draft().last_position[0] = left;
                  store.totals.publish();
              }) {}
    TickRig rig;
    const AxisUnit& axis() { return rig.machine->core().axes[0]; }
    double truth() { return static_cast<SimulatedDrive*>(axis().drive())->true_position(); }
    // The last value that the control asked the store to write for N0908 A1.
    std::string kept() {
        std::string line;
        const auto& ring = rig.kernel->persist;
        for (std::uint64_t i = 0; i < ring.head.load(); ++i)
            if (const std::string text(ring.slot(i).name.data()); text.rfind("N0908 A1=", 0) == 0)
                line = text;
        return line;
    }
};

TEST(AbsoluteEncoder, OfFewBitsGoesOnWhereItRollsOver) {
    Bench b(kAbs, 0, 0);
    b.rig.push(1, b.rig.line(1, {40, 0}, 100));
    b.rig.push(1, b.rig.line(1, {-60, 0}, 100));
    b.rig.start(1);
    b.rig.run_until_idle();
    b.rig.run(200);
    EXPECT_NEAR(b.rig.position(1), -20, 1e-9);
    EXPECT_NEAR(b.axis().measured(), -20, 1e-3);  // three roll-overs on the way, no jump
    EXPECT_FALSE(b.axis().faulted());
    EXPECT_EQ(b.kept(), "");  // without CIR nobody counts
}

TEST(AbsoluteEncoder, WithoutCountedRoundsStandsInTheRoundNearestToN0907) {
    // 20 mm away from its zero point the encoder shows 20 - 16.777216.
    Bench far(kAbs, 20, 20,
              [](Table& t) { params::put(t, params::n0909_abs_position_alarm_distance, 0, 1); });
    far.rig.run(3);
    EXPECT_NEAR(far.axis().measured(), 20 - kRange, 1e-3);
    EXPECT_NEAR(far.rig.position(1), 20 - kRange, 1e-3);
    EXPECT_FALSE(far.axis().faulted());
    // N0907: the working room lies around 20; N0200 is what that place is called.
    Bench near(kAbs, 5, 5, [](Table& t) {
        params::put(t, params::n0909_abs_position_alarm_distance, 0, 1);
        params::put(t, params::n0907_endat_machine_reference, 20, 1);
        params::put(t, params::n0200_reference_position1, 7, 1);
    });
    near.rig.run(3);
    EXPECT_NEAR(near.axis().measured(), 5, 1e-3);
}

TEST(AbsoluteEncoder, CountedRoundsAreKeptInN0908AndTellThePositionAfterPowerOn) {
    Bench b(kAbsCir, 0, 0);
    b.rig.push(1, b.rig.line(1, {40, 0}, 100));
    b.rig.start(1);
    b.rig.run_until_idle();
    EXPECT_EQ(b.kept(), "N0908 A1=2");  // 40 / 16.777
    Bench after(kAbsCir, 40, 40,
                [](Table& t) { params::put(t, params::n0908_endat_round_number, 2, 1); });
    after.rig.run(3);
    EXPECT_NEAR(after.axis().measured(), 40, 1e-3);
    Bench back(kAbsCir, 40, 40,
               [](Table& t) { params::put(t, params::n0908_endat_round_number, 2, 1); });
    back.rig.place(1, 0, 40);
    back.rig.push(1, back.rig.line(1, {-60, 0}, 100));
    back.rig.start(1);
    back.rig.run_until_idle();
    EXPECT_EQ(back.kept(), "N0908 A1=-2");  // -20 lies in the second round below zero
}

TEST(AbsoluteEncoder, ThatWasMovedWhileOffIsNotReferencedUntilTheOperatorSaysSo) {
    TickRig* on_bench = nullptr;
    const auto with = [&](double left, double at, std::int64_t type, std::int64_t rounds) {
        auto rig = std::make_unique<TickRig>(
            [&](Table& t, RunOptions& options) {
                params::put(t, params::n0900_reference_type, type, 1);
                params::put(t, params::n0524_endat_resolution, type & 0x40 ? kBits : 0, 1);
                params::put(t, params::n0908_endat_round_number, rounds, 1);
                params::put(t, params::n0909_abs_position_alarm_distance, 1, 1);
                options.start_known[0] = 1;
                options.start_position[0] = at;
                options.ready = 0;
            },
            [&](StoreSegment& store) {
                store.totals.draft().last_position.fill(std::numeric_limits<double>::quiet_NaN());
                store.totals.draft().last_position[0] = left;
                store.totals.publish();
            });
        rig->run(3);
        on_bench = rig.get();
        return rig;
    };
    const auto same = with(40, 40.5, kAbs, 0);
    EXPECT_TRUE(on_bench->machine->core().axes[0].referenced);
    EXPECT_FALSE(on_bench->alarmed(Alarm::EncoderMoved));
    const auto moved = with(40, 43, kAbs, 0);
    EXPECT_FALSE(on_bench->machine->core().axes[0].referenced);
    EXPECT_TRUE(on_bench->alarmed(Alarm::EncoderMoved, 1));
    // Its battery is empty: what the encoder tells is another round than the kept one.
    const auto empty = with(40, 40, kAbsCir, 0);
    EXPECT_FALSE(on_bench->machine->core().axes[0].referenced);
    EXPECT_TRUE(on_bench->alarmed(Alarm::EncoderMoved, 1));
    // Cure b: reference mode, and the jog key of the axis.
    on_bench->command(CommandKind::MachineOn);
    on_bench->run(200);
    on_bench->command(CommandKind::Mode, 1, static_cast<double>(ChannelMode::Reference));
    on_bench->command(CommandKind::Jog, 0, 0.1, 0, 1);
    on_bench->run(5);
    EXPECT_TRUE(on_bench->machine->core().axes[0].referenced);
}

}  // namespace
}  // namespace polyturn::kernel
