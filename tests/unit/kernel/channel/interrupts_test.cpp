// The inputs that interrupt a program (SETINT of sinumerik, INT1 to INT4 of fagor): which of them
// are heard, and that one that stays on hides no other.
#include "ipc/image/interrupt_inputs.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

// A long move with interrupts on, and a PLC whose signals a test sets.
struct Watched {
    Watched(std::uint32_t inputs, std::uint32_t how, std::function<void(PlcOutputs&)> before = {})
        : told(std::move(before)) {
        rig.plc_program = [this](const PlcInputs& in, PlcOutputs& out) {
            TickRig::lathe(in, out);
            if (told) told(out);
        };
        rig.run(50);  // the PLC has said what is on before the program begins
        PathRecord r = rig.blank(1, RecordKind::Interrupts);
        r.code = 1;
        r.mask = how;
        r.value = inputs;
        rig.push(1, r);
        rig.push(1, rig.line(1, {0, -60}, 10));
        rig.push(1, rig.stop(1, StopReason::M30));
        rig.start(1);
        rig.run(100);
    }
    // The number of the input that has broken the path off; 0: none has.
    unsigned came() {
        rig.run(400);
        for (const ChannelEvent& e : rig.heard[0])
            if (e.kind == static_cast<std::uint32_t>(ChannelEventKind::Interrupt))
                return static_cast<unsigned>(e.record >> 1);
        return 0;
    }
    std::function<void(PlcOutputs&)> told;
    TickRig rig;
};

TEST(InterruptInputs, AreAllInputsOfTheProgram) {
    for (const unsigned n : {1u, 3u, 5u, 8u, 17u, 32u}) {
        Watched by_plc(1u << (n - 1), kInterruptByWires);
        by_plc.told = [n](PlcOutputs& out) {
            out.signal[signals::cp_uin(1)] = static_cast<std::int32_t>(1u << (n - 1));
        };
        EXPECT_EQ(by_plc.came(), n);
        Watched by_wire(1u << (n - 1), kInterruptByWires);
        by_wire.rig.machine->core().signals.set_input(n - 1, true);
        EXPECT_EQ(by_wire.came(), n);
    }
    Watched other(1u << 4, kInterruptByWires);
    other.told = [](PlcOutputs& out) {
        out.signal[signals::cp_uin(1)] = 1 << 5;
        out.signal[signals::int2(1)] = 1;
    };
    EXPECT_EQ(other.came(), 0u) << "nobody watches input 6 and INT2";
}

TEST(InterruptInputs, OfFagorAreTheSignalsOnly) {
    Watched wire(0xf, 0);
    wire.told = [](PlcOutputs& out) { out.signal[signals::cp_uin(1)] = 0xf; };
    wire.rig.machine->core().signals.set_input(1, true);
    EXPECT_EQ(wire.came(), 0u);
    Watched signal(0xf, 0);
    signal.told = [](PlcOutputs& out) { out.signal[signals::int3(1)] = 1; };
    EXPECT_EQ(signal.came(), 3u);
}

TEST(InterruptInputs, OneThatStaysOnHidesNoOther) {
    Watched two(0b110, kInterruptByWires,
                [](PlcOutputs& out) { out.signal[signals::int2(1)] = 1; });
    EXPECT_TRUE(two.rig.heard[0].empty() ||
                two.rig.heard[0].back().kind !=
                    static_cast<std::uint32_t>(ChannelEventKind::Interrupt));
    two.told = [](PlcOutputs& out) {
        out.signal[signals::int2(1)] = out.signal[signals::int3(1)] = 1;
    };
    EXPECT_EQ(two.came(), 3u);
}

}  // namespace
}  // namespace polyturn::kernel
