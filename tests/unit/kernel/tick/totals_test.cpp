// Part counters, hours and last positions on their way to the store (nct_parameters_part2 24).
#include "ipc/requests/counters.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

// The last request of this kind and number; NaN: none.
double sent(TickRig& rig, StoreRequestKind kind, std::int32_t number) {
    double value = std::numeric_limits<double>::quiet_NaN();
    const auto& ring = rig.kernel->persist;
    for (std::uint64_t i = 0; i < ring.head.load(); ++i) {
        const StoreRequest& request = ring.slot(i);
        if (request.kind == static_cast<std::uint32_t>(kind) && request.number == number)
            value = request.value;
    }
    return value;
}

TEST(Totals, APartCountsFromWhereTheStoreLeftOff) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n2306_no_of_total_parts, 41, 1);
    });
    rig.push(1, rig.line(1, {0, -1}, 50));
    rig.push(1, rig.blank(1, RecordKind::Part));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(sent(rig, StoreRequestKind::Counter, counter_number(Counter::TotalParts, 1)), 42);
    EXPECT_EQ(sent(rig, StoreRequestKind::Counter, counter_number(Counter::MachinedParts, 1)), 1);
    EXPECT_TRUE(
        std::isnan(sent(rig, StoreRequestKind::Counter, counter_number(Counter::TotalParts, 2))));
}

TEST(Totals, TimesAreThoseOfTheProgramAndOfCutting) {
    TickRig rig;
    rig.push(1, rig.line(1, {0, -50}, 50));
    rig.push(1, rig.dwell(1, 1.0));
    rig.push(1, rig.line(1, {0, 100}, 0, kRapid));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    const double operation =
        sent(rig, StoreRequestKind::Counter, counter_number(Counter::OperationTime, 1));
    const double cutting =
        sent(rig, StoreRequestKind::Counter, counter_number(Counter::CuttingTime, 1));
    EXPECT_NEAR(cutting, 1050, 60);  // 50 mm at 50 mm/s and its ramps
    EXPECT_GT(operation, cutting + 1000 + 500);
    EXPECT_NEAR(sent(rig, StoreRequestKind::Counter, counter_number(Counter::PartTime, 1)),
                operation, 1e-6);
}

TEST(Totals, WhereTheAxesComeToRestIsKeptOnceNotWhileTheyMove) {
    TickRig rig;
    rig.push(1, rig.line(1, {3, -50}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run(200);
    EXPECT_FALSE(sent(rig, StoreRequestKind::LastPosition, 2) < -1e-6);
    rig.run_until_idle();
    rig.run(20);
    EXPECT_NEAR(sent(rig, StoreRequestKind::LastPosition, 1), 3, 1e-9);
    EXPECT_NEAR(sent(rig, StoreRequestKind::LastPosition, 2), -50, 1e-9);
    const auto count = rig.kernel->persist.head.load();
    rig.run(500);
    EXPECT_EQ(rig.kernel->persist.head.load(), count);
}

TEST(Totals, AMachineStandsWhereItWasLeft) {
    TickRig first;
    auto store = std::make_unique<StoreSegment>();
    StoreTotals& totals = store->totals.draft();
    totals.last_position.fill(std::numeric_limits<double>::quiet_NaN());
    totals.last_position[1] = -77.5;
    store->totals.publish();
    store->parameters.write(first.store->parameters.published());
    Machine machine(*first.kernel, *first.supervisor, *store);
    ASSERT_TRUE(store->parameters.read(machine.core().table));
    machine.start();
    EXPECT_EQ(machine.core().axes[1].command(), -77.5);
    EXPECT_EQ(machine.core().axes[0].command(), 0.0);
}

}  // namespace
}  // namespace polyturn::kernel
