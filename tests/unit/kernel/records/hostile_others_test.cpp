// A PLC that writes any words, and a command ring that holds any bytes: what they ask for is done
// or refused, and no memory is harmed. What an axis does meanwhile the PLC may stop in many ways;
// never does it jump.
#include <limits>
#include <random>

#include "tests/seeds.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

TEST(HostilePlc, WritesAnyWordsAndNoAxisIsCommandedToJump) {
    std::mt19937_64 draw(test_seed(5));
    TickRig rig;
    std::array<double, 4> before{};
    int jumps = 0;
    rig.plc_program = [&](const PlcInputs& in, PlcOutputs& out) {
        if (draw() % 4 == 0) TickRig::lathe(in, out);
        for (int n = 0; n < 40; ++n) {
            const std::int32_t words[] = {0,
                                          1,
                                          -1,
                                          3,
                                          4,
                                          17,
                                          33,
                                          97,
                                          std::numeric_limits<std::int32_t>::max(),
                                          std::numeric_limits<std::int32_t>::min(),
                                          static_cast<std::int32_t>(draw())};
            out.signal[draw() % kPlcSignals] = words[draw() % std::size(words)];
        }
    };
    rig.on_tick = [&] {
        for (unsigned a = 0; a < 4; ++a) {
            const double now = rig.position(a + 1);
            // AxisUnit::watch_command
            jumps += !(std::fabs(now - before[a]) <= TickRig::kVelocity * 0.001 * 4 + 0.05);
            before[a] = now;
        }
        if (rig.log.size() > 4096) rig.log.clear();
    };
    for (int round = 0; round < 60; ++round) {
        for (unsigned l = 1; l <= 2; ++l) {
            rig.place(l, 0, rig.machine->core().axes[l * 2 - 2].own());
            rig.place(l, 1, rig.machine->core().axes[l * 2 - 1].own());
            for (int n = 0; n < 3; ++n)
                rig.push(l, rig.line(l, {rig.position(1) > 0 ? -20.0 : 20.0, 10}, 100));
            rig.push(l, rig.spindle(l, 500));
            rig.push(l, rig.aux(l, 'M', 3));
            rig.push(l, rig.stop(l, StopReason::M30));
            rig.start(l);
        }
        rig.run(300);
        rig.command(CommandKind::ReleaseStop);
        rig.command(CommandKind::Reset);
        rig.command(CommandKind::MachineOn);
        rig.run(50);
    }
    EXPECT_EQ(jumps, 0);
}

TEST(HostileCommands, OfAnyBytesAreRefusedOrDoneAndHarmNoMemory) {
    std::mt19937_64 draw(test_seed(6));
    TickRig rig;
    const double wild[] = {0,
                           1,
                           -1,
                           1e300,
                           -1e300,
                           std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(),
                           4e9,
                           -4e9,
                           70'000};
    for (int round = 0; round < 4000; ++round) {
        auto& ring = rig.supervisor->commands;
        const auto head = ring.head.load();
        Command& c = ring.slot(head);
        auto* raw = reinterpret_cast<unsigned char*>(&c);
        for (std::size_t i = 0; i < sizeof c; ++i) raw[i] = static_cast<unsigned char>(draw());
        c.tick = 0;
        c.seq = head + 1;
        if (draw() % 8) {
            c.kind = static_cast<std::uint32_t>(draw() % 60);
            c.channel = static_cast<std::uint32_t>(draw() % 20);
            c.text.back() = 0;
        }
        if (draw() % 2) {
            c.object = static_cast<std::uint32_t>(draw() % 130);
            c.flags = static_cast<std::uint32_t>(draw() % 4);
        }
        if (draw() % 4) c.value = wild[draw() % std::size(wild)];
        if (draw() % 2) c.level = 0;
        if (c.kind == static_cast<std::uint32_t>(CommandKind::EndRun)) c.kind = 0;
        ring.head.store(head + 1);
        rig.run(2);
        if (rig.log.size() > 4096) rig.log.clear();
    }
    SUCCEED();
}

TEST(HostileCommands, WithANumberThatCannotBeAreSaidToBeBad) {
    TickRig rig;
    rig.command(CommandKind::Mode, 1, 9);
    rig.command(CommandKind::Step, 0, 1e308, 0, 1);
    rig.run(3);
    EXPECT_TRUE(rig.alarmed(Alarm::RequestBad));
    EXPECT_EQ(rig.machine->channel(0).mode(), ChannelMode::Auto);
    EXPECT_EQ(rig.position(1), 0);
}

}  // namespace
}  // namespace polyturn::kernel
