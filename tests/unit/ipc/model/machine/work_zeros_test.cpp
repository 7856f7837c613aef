#include "ipc/model/machine/store/work_zeros.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "ipc/image/segments.hpp"
#include "ipc/model/machine/load_machine.hpp"
#include "ipc/model/machine/store/apply_setup.hpp"
#include "ipc/requests/store_requests.hpp"
#include "tests/places.hpp"

namespace {

using namespace polyturn;

TEST(WorkZeroNames, AreRowsOfTheStore) {
    struct Row {
        const char* name;
        std::optional<std::size_t> row;
    };
    const Row rows[] = {
        {"G54", kZeroG54},
        {"g59", kZeroG54 + 5},
        {"shift", kZeroShift},
        {"external", kZeroExternal},
        {"EXT", kZeroExternal},
        {"G54.1P1", kZeroG541 + 1},
        {"G54.1 P300", kZeroG541 + 300},
        {"G54.1P0", {}},
        {"G54.1P301", {}},
        {"G54.1P", {}},
        {"G54.1P1x", {}},
        {"G159N1", kZeroG54},
        {"G159N6", kZeroG54 + 5},
        {"G159N7", kZeroG541 + 1},
        {"G159N20", kZeroG541 + 14},
        {"G159N21", {}},
        {"G159N0", {}},
        {"G505", kZeroG54 + 4},
        {"G507", kZeroG541 + 1},
        {"G599", kZeroG541 + 93},
        {"G504", {}},
        {"G600", {}},
        {"G53", 311},
        {"G500", 312},
        {"G54.2P1", 313},
        {"G54.2 P7", 319},
        {"G54.2P8", 9},
        {"G54.2P9", {}},
        {"G54.2P0", {}},
        {"G60", {}},
        {"", {}},
        {"G", {}},
        {"G5 4", kZeroG54},
        {"G99999999999", {}},
        {"X", {}},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        EXPECT_EQ(work_zero_row(row.name), row.row);
    }
}

TEST(WorkZeroNames, LeadBackToTheirRows) {
    for (std::size_t row = 0; row < kWorkZeros; ++row) {
        const std::string name = work_zero_name(row);
        if (name.empty()) continue;
        EXPECT_EQ(work_zero_row(name), row) << name;
    }
}

TEST(KeptVariables, AreTheLastFiveHundredOfTheHash) {
    EXPECT_EQ(kept_variable("#500"), 0u);
    EXPECT_EQ(kept_variable("#999"), 499u);
    for (const char* name : {"#499", "#1000", "#50", "R500", "#5O0", "", "#"})
        EXPECT_EQ(kept_variable(name), std::nullopt) << name;
}

TEST(ApplySetup, DiagnosesWhatTheMachineDoesNotHaveAndEntersTheRest) {
    const LoadedMachine loaded =
        load_machine_file(std::string(kSourceFolder) + "/examples/machines/twin-turret");
    const MachineConfig machine = derive_machine_config(*loaded.table);
    std::vector<Diagnosis> diagnoses;
    const text::Setup setup = text::parse_setup(R"(
[channel.1]
work = { G54 = { X = 1.0, Q = 2.0 }, G77 = { X = 1.0 } }
[channel.1.offset.31]
geometry = { X = 5.0 }
)",
                                                "setup.toml", diagnoses);
    ASSERT_TRUE(diagnoses.empty());
    auto store = std::make_unique<ChannelStore>();
    clear_channel_store(*store);
    apply_setup(setup, machine, 1, *store, diagnoses);
    ASSERT_EQ(diagnoses.size(), 2u);
    EXPECT_EQ(diagnoses[0].alarm, Alarm::SetupEntry);
    EXPECT_EQ(store->zeros[kZeroG54 * kChannelAxes], 1.0);
    EXPECT_EQ(store->offsets[31].geometry[0], 5.0);
}

}  // namespace
