// The scope records each tick of what was chosen, and since when a coupling is as it is.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

void choose(TickRig& rig, unsigned trace, ScopeKind kind, unsigned object) {
    rig.command(CommandKind::Scope, 0, static_cast<double>(kind), 0, object, trace);
}

TEST(Scope, WritesNothingWhileNoTraceIsChosen) {
    TickRig rig;
    rig.run(20);
    EXPECT_EQ(rig.kernel->scope.head.load(), 0u);
}

TEST(Scope, HasEachTickOfTheChosenSignals) {
    TickRig rig;
    choose(rig, 0, ScopeKind::AxisCommanded, 1);
    choose(rig, 7, ScopeKind::PathSpeed, 1);
    rig.run(3);
    const std::uint64_t first = rig.kernel->scope.head.load();
    ASSERT_GT(first, 0u);
    rig.push(1, rig.line(1, {10, 0}, 50));
    rig.start(1);
    std::vector<double> command;
    rig.on_tick = [&] { command.push_back(rig.position(1)); };
    rig.run(100);
    const std::uint64_t head = rig.kernel->scope.head.load();
    ASSERT_EQ(head - first, command.size());
    double fastest = 0;
    for (std::uint64_t i = first; i < head; ++i) {
        const ScopeSample& sample = rig.kernel->scope.slot(i);
        EXPECT_DOUBLE_EQ(sample.value[0], command[i - first]);
        if (i > first) { EXPECT_EQ(sample.tick, rig.kernel->scope.slot(i - 1).tick + 1); }
        fastest = std::max(fastest, sample.value[7]);
    }
    EXPECT_NEAR(fastest, 50, 1e-6);
    choose(rig, 0, ScopeKind::Off, 0);
    choose(rig, 7, ScopeKind::Off, 0);
    rig.run(3);
    const std::uint64_t end = rig.kernel->scope.head.load();
    rig.run(10);
    EXPECT_EQ(rig.kernel->scope.head.load(), end);
}

TEST(Scope, ATraceThatDoesNotExistOrOfNothingIsHarmless) {
    TickRig rig;
    choose(rig, 8, ScopeKind::AxisCommanded, 1);
    choose(rig, 1, ScopeKind::AxisCommanded, 5000);
    choose(rig, 2, ScopeKind::PlcSignal, 4'000'000);
    choose(rig, 3, static_cast<ScopeKind>(77), 1);
    rig.run(5);
    const ScopeSample& last = rig.kernel->scope.slot(rig.kernel->scope.head.load() - 1);
    for (const double value : last.value) EXPECT_EQ(value, 0.0);
}

TEST(CoupledSince, SaysWhenAndByWhichMCode) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n2101_synchronous_master, 2, 4);
    });
    rig.run(10);
    const auto status = [&] { return rig.kernel->status.published(); };
    EXPECT_EQ(status().axes[3].since_code, -1);
    PathRecord m{};
    m.kind = static_cast<std::uint8_t>(RecordKind::Aux);
    m.code = 'M';
    m.value = 62;
    m.flags = kDrains;
    rig.push(1, m);
    rig.start(1);
    rig.run(5);  // the code is given, the PLC works on it
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_syncr(4), 1);
    rig.run(5);
    ASSERT_EQ(status().axes[3].master, 2u);
    EXPECT_EQ(status().axes[3].since_code, 62);
    EXPECT_EQ(status().axes[3].since_channel, 1u);
    EXPECT_GT(status().axes[3].since, 0);
}

}  // namespace
}  // namespace polyturn::kernel
