// Which channel says what when a part is passed to the counter spindle by hand, on the machines of
// examples/machines.
#include "hmi/machine/programs/transfer_steps.hpp"

#include <gtest/gtest.h>

#include "ipc/model/machine/load_machine.hpp"
#include "tests/places.hpp"

namespace polyturn::hmi {
namespace {

// «L2 M72» and so on; «L2 jog» for a way.
std::vector<std::string> said(const char* machine, const std::vector<std::string>& lines = {}) {
    const LoadedMachine loaded =
        load_machine({std::string(kSourceFolder) + "/examples/machines/" + machine, {}, lines});
    EXPECT_TRUE(loaded.table) << machine;
    if (!loaded.table) return {};
    const MachineConfig config = derive_machine_config(*loaded.table);
    std::vector<unsigned> channels;
    for (unsigned c = 1; c <= config.last_channel; ++c)
        if (config.channel(c).exists()) channels.push_back(c);
    std::vector<std::string> out;
    for (const TransferStep& step : transferSteps(config, *loaded.table, channels)) {
        std::string text = "L" + std::to_string(step.channel) +
                           (step.code < 0 ? " jog" : " M" + std::to_string(step.code));
        if (step.spindle) text += " S" + std::to_string(step.spindle);
        out.push_back(text);
    }
    return out;
}

using Said = std::vector<std::string>;

// examples/jobs/transfer does the same as two programs.
TEST(TransferSteps, TheSlideOfTheCounterSpindleReceives) {
    EXPECT_EQ(said("transfer"),
              (Said{"L2 M72", "L2 M11 S2", "L2 M61", "L2 M66", "L2 jog", "L2 M10 S2", "L2 M67",
                    "L1 M11 S1", "L2 jog", "L1 M10 S1", "L2 M62", "L2 M71"}));
}

TEST(TransferSteps, CodesAreThoseOfTheParameters) {
    EXPECT_EQ(said("transfer", {"PT_M_SPINDLE L2=171", "PT_M_FOLLOW S2=260", "PT_M_TORQUE A5=366"}),
              (Said{"L2 M172", "L2 M11 S2", "L2 M261", "L2 M366", "L2 jog", "L2 M10 S2", "L2 M367",
                    "L1 M11 S1", "L2 jog", "L1 M10 S1", "L2 M262", "L2 M171"}));
}

TEST(TransferSteps, AMachineThatDoesNotCoupleItsSpindlesPassesThePartStanding) {
    EXPECT_EQ(said("counter-spindle"), (Said{"L2 M72", "L2 M11 S2", "L2 jog", "L2 M10 S2",
                                             "L1 M11 S1", "L2 jog", "L1 M10 S1", "L2 M71"}));
}

// N0604 gives channel 2 its spindle: nothing has to be chosen.
TEST(TransferSteps, ASpindleThatIsTheChannelsOwnIsNotChosen) {
    EXPECT_EQ(said("swiss"),
              (Said{"L2 M11 S2", "L2 jog", "L2 M10 S2", "L1 M11 S1", "L2 jog", "L1 M10 S1"}));
}

TEST(TransferSteps, OneTurretChoosesBeforeEachChuck) {
    EXPECT_EQ(said("counter-spindle", {"N0000 L2=0", "N0002 A3=1", "N0002 A4=1"}),
              (Said{"L1 M72", "L1 M11 S2", "L1 jog", "L1 M10 S2", "L1 M71", "L1 M11 S1", "L1 jog",
                    "L1 M10 S1"}));
}

TEST(TransferSteps, WithoutACounterSpindleThereIsNothingToPass) {
    EXPECT_EQ(said("twin-turret"), Said{});
    EXPECT_EQ(said("twin-turret-y"), Said{});  // its second spindle drives tools
    EXPECT_EQ(said("one-turret"), Said{});
}

}  // namespace
}  // namespace polyturn::hmi
