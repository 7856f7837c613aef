// Int0: what the PLC's fast task answers acts one tick later, for signals that only it writes;
// without an answer for a whole PLC cycle the machine stops (nct part 1 8.4,
// docs/design/plc-interface.md).
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

struct FastTask : TickRig {
    FastTask() {
        plc->fast_plan.reads = 1;
        plc->fast_plan.writes = 1;
        plc->fast_plan.read[0] = kFastInput + 7;
        plc->fast_plan.write[0] = signals::sp_osw(1);
        machine->attach_plc(*plc);
        plc_program = [](const PlcInputs& in, PlcOutputs& out) {
            lathe(in, out);
            out.signal[signals::sp_osw(1)] = 5;  // not its own: does not count
        };
    }
    void answer() {
        PlcFastInputs in;
        if (!kernel->plc_fast.read(in) || in.count == plc->fast_count.load()) return;
        PlcFastOutputs out{};
        out.count = in.count;
        out.value[0] = in.value[0];
        plc->fast.write(out);
        plc->fast_count.store(in.count);
    }
    std::int32_t acts() const { return machine->core().signals.plc(signals::sp_osw(1)); }
};

TEST(FastTask, ActsATickAfterTheInputThatItSaw) {
    FastTask rig;
    for (int n = 0; n < 30; ++n) {
        rig.run(1);
        rig.answer();
    }
    EXPECT_EQ(rig.acts(), 0);
    rig.machine->core().signals.set_input(7, true);
    rig.run(1);  // asked at the end of this tick
    EXPECT_EQ(rig.acts(), 0);
    rig.answer();
    rig.run(1);
    EXPECT_EQ(rig.acts(), 1);
    for (int n = 0; n < 30; ++n) {
        rig.answer();
        rig.run(1);
        ASSERT_EQ(rig.acts(), 1) << "whatever the cycle says of it";
    }
    rig.machine->core().signals.set_input(7, false);
    rig.answer();
    rig.run(1);
    rig.answer();
    rig.run(1);
    EXPECT_EQ(rig.acts(), 0);
    EXPECT_FALSE(rig.alarmed(Alarm::PlcLate));
}

TEST(FastTask, IsMissedWhenItIsSilentForAWholeCycle) {
    FastTask rig;
    for (int n = 0; n < 25; ++n) {
        rig.run(1);
        rig.answer();
    }
    rig.run(rig.machine->core().config.plc_cycle_ticks);
    EXPECT_FALSE(rig.alarmed(Alarm::PlcLate));
    rig.run(3);
    EXPECT_TRUE(rig.alarmed(Alarm::PlcLate));
}

TEST(FastTask, ASlotThatIsNoSignalIsNotBelieved) {
    TickRig rig;
    rig.plc->fast_plan.writes = 40'000;
    rig.plc->fast_plan.write.fill(4'000'000'000u);
    rig.machine->attach_plc(*rig.plc);
    rig.run(50);
    EXPECT_FALSE(rig.alarmed(Alarm::PlcLate)) << "no task: nothing is waited for";
}

}  // namespace
}  // namespace polyturn::kernel
