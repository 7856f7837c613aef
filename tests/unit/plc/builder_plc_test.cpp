// A PLC in a library of its own: what is wrong with a file, and what a PLC does that begins beside
// a machine.
#include "kernel/plc/builder_plc.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/places.hpp"

namespace polyturn::plc {
namespace {

TEST(LathePlcStart, DoesNotRepeatWhatAPredecessorWasAsked) {
    // The machine has run for a while when this PLC comes; an M3 of before stands in the inputs.
    const auto table = std::make_unique<params::Table>(params::defaults());
    auto plc = BuilderPlc::load(std::string(kProgramFolder) + "/liblathe_plc.so");
    ASSERT_TRUE(plc) << plc.diagnosis().text();
    PlcMemory memory;
    ASSERT_TRUE(plc->init(*table, 0.001, memory));
    auto in = std::make_unique<PlcInputs>();
    auto out = std::make_unique<PlcOutputs>();
    in->cycle = 1;
    in->tick = 5'000;
    in->signal[signals::n_machine_on()] = 1;
    in->signal[signals::cn_ssel(1)] = 1;
    in->signal[signals::cn_mstr(1)] = 4;
    in->signal[signals::cn_mcode(1)] = 3;
    plc->cycle(*in, *out);
    EXPECT_EQ(out->signal[signals::cp_mfin(1)], 4);
    EXPECT_EQ(out->signal[signals::sp_rot(1)], 5);
}

TEST(LathePlcStart, TakesTheFirstCodeOfAFreshMachine) {
    const auto table = std::make_unique<params::Table>(params::defaults());
    auto plc = BuilderPlc::load(std::string(kProgramFolder) + "/liblathe_plc.so");
    PlcMemory memory;
    ASSERT_TRUE(plc && plc->init(*table, 0.001, memory));
    auto in = std::make_unique<PlcInputs>();
    auto out = std::make_unique<PlcOutputs>();
    in->cycle = 1;
    in->tick = 10;
    in->signal[signals::n_machine_on()] = 1;
    in->signal[signals::cn_ssel(1)] = 1;
    in->signal[signals::cn_mstr(1)] = 1;
    in->signal[signals::cn_mcode(1)] = 3;
    plc->cycle(*in, *out);
    EXPECT_EQ(out->signal[signals::sp_rot(1)], 3);
}

TEST(BuilderPlcLoad, SaysWhatIsWrongWithAFile) {
    struct Row {
        std::string library;
        Alarm alarm;
    };
    for (const Row& row : {Row{"/nowhere/plc.so", Alarm::PlcLoad},
                           Row{std::string(kSourceFolder) + "/LICENSE", Alarm::PlcLoad},
                           Row{"libm.so.6", Alarm::PlcLoad}}) {
        SCOPED_TRACE(row.library);
        const auto plc = BuilderPlc::load(row.library);
        ASSERT_FALSE(plc);
        EXPECT_EQ(plc.diagnosis().alarm, row.alarm);
    }
}

}  // namespace
}  // namespace polyturn::plc
