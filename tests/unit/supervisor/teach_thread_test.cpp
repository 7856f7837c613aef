// press teach_thread: from what the machine shows to the parameters that threads begin by.
#include "kernel/supervisor/start/teach_thread.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "ipc/params/param_file.hpp"

namespace polyturn::supervisor {
namespace {

struct Machine {
    std::unique_ptr<params::Table> table = std::make_unique<params::Table>(params::defaults());
    std::unique_ptr<MachineStatus> status = std::make_unique<MachineStatus>();
    Machine() {
        for (const char* line :
             {"N0000 L1=1", "N0000 L2=1", "N0604 L1=1", "N0604 L2=1", "N0002 A1=1", "N0103 A1=1",
              "N0002 A2=1", "N0103 A2=3", "N0002 A4=2", "N0103 A4=3"}) {
            const auto parsed = params::parse_assignment(line);
            EXPECT_TRUE(parsed && params::apply(*table, std::span(&*parsed, 1))) << line;
        }
    }
    Result<std::vector<std::string>> teach(std::string_view words) const {
        return teach_thread(words, *status, derive_machine_config(*table), *table);
    }
};

TEST(TeachThread, TakesAngleAndPlaceOfTheChannel) {
    Machine m;
    m.status->spindles[0].angle = 123.25;
    m.status->spindles[1].angle = 77.5;
    m.status->axes[1].act = -14.125;
    m.status->axes[3].act = 3.5;
    const auto first = m.teach("teach_thread L1");
    ASSERT_TRUE(first);
    EXPECT_EQ(*first,
              (std::vector<std::string>{"PT_THREAD_ANGLE L1=123.250000",
                                        "PT_THREAD_AT L1=-14.125000", "PT_THREAD_PICKUP L1=1"}));
    m.status->spindles[1].owner = 2;  // this channel commands the counter spindle
    const auto second = m.teach("teach_thread L2");
    ASSERT_TRUE(second);
    EXPECT_EQ(*second,
              (std::vector<std::string>{"PT_THREAD_ANGLE L2=77.500000", "PT_THREAD_AT L2=3.500000",
                                        "PT_THREAD_PICKUP L2=1"}));
}

TEST(TeachThread, IsSwitchedOffAndRefusesWhatItDoesNotUnderstand) {
    const Machine m;
    const auto off = m.teach("teach_thread L1=off");
    ASSERT_TRUE(off);
    EXPECT_EQ(*off, std::vector<std::string>{"PT_THREAD_PICKUP L1=0"});
    for (const char* words : {"teach_thread", "teach_thread L3", "teach_thread X",
                              "teach_thread L1 A2", "teach_thread L99"})
        EXPECT_FALSE(m.teach(words)) << words;
}

}  // namespace
}  // namespace polyturn::supervisor
