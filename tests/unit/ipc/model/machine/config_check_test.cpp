#include "ipc/model/machine/check/config_check.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "ipc/model/machine/machine_config.hpp"
#include "ipc/params/param_file.hpp"
#include "tests/places.hpp"

namespace {

using namespace polyturn;

std::string read(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

params::Table twin_turret_with(const std::vector<const char*>& lines) {
    params::Table table = params::defaults();
    const std::string path =
        std::string(kSourceFolder) + "/examples/machines/twin-turret/machine.params";
    const auto file = params::parse_param_file(read(path), path);
    EXPECT_TRUE(file.ok());
    EXPECT_TRUE(params::apply(table, file));
    for (const char* line : lines) {
        const auto assignment = params::parse_assignment(line);
        EXPECT_TRUE(assignment && params::apply(table, {&*assignment, 1})) << line;
    }
    return table;
}

// Each set of lines makes the twin-turret lathe contradict itself in exactly one way.
struct Row {
    std::vector<const char*> lines;
    Alarm alarm;
    const char* names;  // what the operator must read: the parameter with scope and value
};
const Row kRows[] = {
    {{"N0002 A7=5"}, Alarm::ConfigAxisChannel, "N0002 A7=5"},
    {{"N0002 A7=50"}, Alarm::ConfigAxisChannel, "N0002 A7=50"},
    {{"N0002 A7=1", "N0100 A7=88"}, Alarm::ConfigAxisNameTwice, "A1 (X) and A7 (X)"},
    {{"N0100 A5=68"}, Alarm::ConfigAxisName, "N0100 A5=68"},
    {{"N0101 A5=40"}, Alarm::ConfigAxisName, "N0101 A5=40"},
    {{"N0101 A5=65", "N0102 A5=40"}, Alarm::ConfigAxisName, "N0102 A5=40"},
    {{"N0103 A5=3"}, Alarm::ConfigPlaneRole, "N0103 A5=3"},
    {{"N0103 A5=4"}, Alarm::ConfigPlaneRole, "N0103 A5=4"},
    {{"N0005=50"}, Alarm::ConfigTick, "N0005=50"},
    // Auto, 1000, 2000, 5000: part 1, 2; part 2, 9
    {{"N0005=500"}, Alarm::ConfigTick, "N0005=500"},
    {{"N0005=4000"}, Alarm::ConfigTick, "N0005=4000"},
    // a column of those that N2903 adds: part 2, 30.4
    {{"N2901#0 L2=1", "N2903=2", "N2904=3"}, Alarm::ParamRange, "N2904=3"},
    {{"N3106 L2=0.01", "N3107 L2=0.03"}, Alarm::ParamRange, "N3107 L2=0.03"},
    {{"N3205 L1=1", "N3206 L1=20"}, Alarm::ParamRange, "N3206 L1=20"},
    {{"N3209 L1=3", "N3210 L1=-20"}, Alarm::ParamRange, "N3210 L1=-20"},
    {{"N1413 L1=2", "N2923 L1=5"}, Alarm::ParamRange, "N2923 L1=5"},
    {{"N1413 L1=2", "N1414#1 L1=1", "N2923 L1=55"}, Alarm::ParamRange, "N2923 L1=55"},
    {{"N0682 S1=9.5"}, Alarm::ParamRange, "N0682 S1=9.5"},
    {{"N1747 L1=71", "N1751 L1=3000"}, Alarm::ParamRange, "N1747 L1=71"},  // G: part 2, 18.4
    {{"N1750 L2=80"}, Alarm::ParamRange, "N1750 L2=80"},                   // P
    {{"N1702 L1=400", "N1703 L1=410"}, Alarm::ParamRange, "N1702 L1=400"},
    {{"N1702 L1=510", "N1703 L1=505"}, Alarm::ParamRange, "N1702 L1=510"},
    {{"N5000=Simulation"}, Alarm::ParamRange, "N5000=Simulation"},
    {{"N0304 A1=0"}, Alarm::ConfigMotionLimit, "N0304 A1=0"},
    {{"N0305 A1=0"}, Alarm::ConfigMotionLimit, "N0305 A1=0"},
    {{"N0400 A4=0"}, Alarm::ConfigMotionLimit, "N0400 A4=0"},
    {{"N0504 A4=0"}, Alarm::ConfigMotionLimit, "N0504 A4=0"},
    {{"N1002 A2=-900"}, Alarm::ConfigStroke, "N1002 A2=-900"},
    {{"N1004 A2=-900"}, Alarm::ConfigStroke, "N1004 A2=-900"},
    {{"N1000 A2=00000101", "N1008 A2=1", "N1009 A2=2"}, Alarm::ConfigStroke, "N1008 A2=1"},
    {{"N1000 A2=00000011", "N1001#1 L1=1", "N1006 A2=1", "N1007 A2=2"},
     Alarm::ConfigStroke,
     "N1006 A2=1"},
    {{"N0604 L2=7"}, Alarm::ConfigSpindleMissing, "N0604 L2=7"},
    {{"N0687 L2=1"}, Alarm::ConfigSurfaceAxis, "N0687 L2=1"},
    {{"N0687 L1=5"}, Alarm::ConfigSurfaceAxis, "N0687 L1=5"},
    {{"N2201=700"}, Alarm::ConfigWaitCodes, "N2201=700"},
    {{"N2201=30"}, Alarm::ConfigWaitCodes, "N2201=30"},
    {{"N2201=0"}, Alarm::ConfigWaitCodes, "N2201=0"},
    {{"N0503 A2=1"}, Alarm::ConfigOutputShared, "N0503 A1=1 and N0503 A2=1"},
    {{"N0603 S3=41"}, Alarm::ConfigOutputShared, "N0603 S1=41 and N0603 S3=41"},
    {{"N0108 A5=0"}, Alarm::ConfigRollover, "N0108 A5=0"},
    {{"N0642 S1=4600"}, Alarm::ConfigSpindleSpeed, "N0642 S1=4600"},
    {{"N0650 S1=5100"}, Alarm::ConfigSpindleSpeed, "N0650 S1=5100"},
    {{"N2101 A2=9"}, Alarm::ConfigAxisReference, "N2101 A2=9"},
    {{"N2104 A2=2"}, Alarm::ConfigAxisReference, "N2104 A2=2"},
    // Recomposition: part 2, section 22.
    {{"N2101 A2=4", "N2101 A4=1"}, Alarm::ConfigCoupling, "N2102#2 A4=0"},
    {{"N2101 A2=5"}, Alarm::ConfigCoupling, "N2101 A2=5"},
    {{"N2104 A2=5"}, Alarm::ConfigCoupling, "N2104 A2=5"},
    {{"PT_BALANCE L1=2"}, Alarm::ConfigCoupling, "PT_BALANCE L1=2"},
    {{"N0534 A2=12"}, Alarm::ConfigAxisReference, "N0534 A2=12"},
    {{"N1400 L1=990"}, Alarm::ConfigOffsets, "N1400 L1=990"},
    {{"N1333 L1=67"}, Alarm::ConfigAuxAddress, "N1333 L1=67"},
    {{"N1341 L1=55", "N1357 L1=51"}, Alarm::ConfigCodes, "N1341 L1=55"},
    {{"N1341 L1=51", "N1357 L1=55", "N1342 L1=54", "N1358 L1=58"},
     Alarm::ConfigCodes,
     "N1342 L1=54"},
    {{"N1317 L2=69", "N1325 L2=40"}, Alarm::ConfigCodes, "N1317 L2=69"},
    {{"N0689 S1=25", "N0690 S1=20"}, Alarm::ConfigCodes, "N0689 S1=25"},
    {{"N1333 L1=65", "N1334 L1=65"}, Alarm::ConfigAuxAddress, "N1334 L1=65"},
    {{"N1101=20", "N1165=1"}, Alarm::ConfigSwitch, "N1101=20"},
    {{"N1102=2", "N1134=10", "N1166=-10"}, Alarm::ConfigSwitch, "N1134=10"},
    {{"N0106#3 A5=1", "N0110 A5=0"}, Alarm::ConfigIndex, "N0110 A5=0"},
    {{"N0900 A2=1", "N0901 A2=0"}, Alarm::ConfigHoming, "N0901 A2=0"},
    {{"N2101 A2=1", "N2102#4 A2=1", "PT_REF_ORDER A1=0"}, Alarm::ConfigHoming, "PT_REF_ORDER A1=0"},
    {{"N0605 S3=50"}, Alarm::ConfigSpindleName, "N0605 S2=50 and N0605 S3=50"},
    {{"N0900 A2=2", "N0904 A2=0"}, Alarm::ConfigHoming, "N0904 A2=0"},
    {{"N0900 A2=4", "N0904 A2=20", "N0905 A2=0"}, Alarm::ConfigHoming, "N0905 A2=0"},
    {{"N0533 A3=1"}, Alarm::ConfigLoop, "N0533 A3=1"},
    {{"N0534 A1=3"}, Alarm::ConfigLoop, "N0534 A1=3"},
    {{"N0817 S3=67"}, Alarm::ConfigSpindleName, "N0817 S3=67"},
    {{"N0817 S3=65", "N0817 S4=65"}, Alarm::ConfigSpindleName, "N0817 S4=65"},
    {{"N0421#0 L1=1", "N1337#0 L1=1"}, Alarm::ConfigRapidOverlap, "N0421 L1"},
    // Kinds of axes that exclude each other: part 1, 3.4 to 3.7, 4.4.
    {{"N0106 A2=10010000", "N0503 A2=0"}, Alarm::ConfigIndex, "N0106 A2"},
    {{"N0106 A2=00010000"}, Alarm::ConfigIndex, "N0503 A2=2"},
    {{"N0217 A2=0.5"}, Alarm::ConfigIndex, "N0217 A2=0.5"},
    {{"N0106#2 A2=1", "N0109 A2=0"}, Alarm::ConfigIndex, "N0109 A2=0"},
    {{"N0106#3 A5=1", "N0110 A5=5", "N0516 A5=2.5"}, Alarm::ConfigIndex, "N0516 A5=2.5"},
    // Referencing: part 1, 10.1 to 10.3.
    {{"N0900 A2=9", "N0901 A2=100"}, Alarm::ConfigHoming, "N0900 A2"},
    {{"N0900 A2=17", "N0901 A2=100"}, Alarm::ConfigHoming, "N0900 A2"},
    {{"N0900 A2=6", "N0904 A2=20", "N0905 A2=1000"}, Alarm::ConfigHoming, "N0900 A2"},
    {{"N0900 A2=129", "N0901 A2=100"}, Alarm::ConfigHoming, "N0900 A2"},
    {{"N0900 A5=64"}, Alarm::ConfigHoming, "N0900 A5"},
    {{"N0900 A5=72", "N0524 A5=0"}, Alarm::ConfigHoming, "N0524 A5=0"},
    {{"N0900 A2=72", "N0524 A2=25"}, Alarm::ConfigHoming, "N0106 A2"},
    {{"N0900 A2=2", "N0303 A2=0"}, Alarm::ConfigHoming, "N0303 A2=0"},
    {{"N0900 A2=1", "N0901 A2=100", "N0302 A2=0"}, Alarm::ConfigHoming, "N0302 A2=0"},
    {{"N0900 A2=1", "N0901 A2=100", "N0902 A2=0"}, Alarm::ConfigHoming, "N0902 A2=0"},
    // Loops and drives: part 1, 7.1, 7.9.
    {{"N0514#7 A3=1", "N0514#7 A4=1", "N0533 A3=4", "N0533 A4=2"}, Alarm::ConfigLoop, "N0533 A3=4"},
    {{"N0002 A11=99", "N0106 A11=00010000", "N0534 A1=11", "N0534 A3=11"},
     Alarm::ConfigLoop,
     "N0534 A1=11 and N0534 A3=11"},
    {{"N0002 A11=99", "N0106 A11=00010000", "N0534 A1=11", "N0537 A1=0.1", "N0538 A1=0.2"},
     Alarm::ConfigLoop,
     "N0538 A1=0.2"},
    {{"N0503 A2=43"}, Alarm::ConfigOutputShared, "N0503 A2=43 and N0603 S3=43"},
    // Strokes without room: part 1, 11.
    {{"N1000 A2=00000011", "N1001 L1=00000011", "N1006 A2=1200", "N1007 A2=1100"},
     Alarm::ConfigStroke,
     "N1006 A2=1200"},
    {{"N1000 A2=00000101", "N1008 A2=5000", "N1009 A2=-5000"},
     Alarm::ConfigStroke,
     "N1008 A2=5000"},
    // Spindles: part 1, 8 and 9.
    {{"N0605 S2=42"}, Alarm::ConfigSpindleName, "N0605 S2=42"},
    {{"N0605 S2=65", "N0606 S2=42"}, Alarm::ConfigSpindleName, "N0606 S2=42"},
    {{"N0817 S3=65", "N0818 S3=42"}, Alarm::ConfigSpindleName, "N0818 S3=42"},
    {{"N0817 S3=65", "N0818 S3=65", "N0819 S3=42"}, Alarm::ConfigSpindleName, "N0819 S3=42"},
    {{"N0609 S1=00011000"}, Alarm::ConfigSpindleSpeed, "N0609 S1"},
    {{"N0689 S1=18", "N0690 S1=24"}, Alarm::ConfigCodes, "N0689 S1=18"},
    {{"N0820 S1=201", "N0821 S1=19", "N0822 S1=18", "N0607#2 S1=0"},
     Alarm::ConfigCodes,
     "N0607 S1"},
    {{"N0820 S1=490", "N0821 S1=19", "N0822 S1=18"}, Alarm::ConfigCodes, "N0820 S1=490"},
    {{"N0820 S1=20", "N0821 S1=19", "N0822 S1=18"}, Alarm::ConfigCodes, "M30"},
    {{"N0688 L1=6000"}, Alarm::ConfigSpindleSpeed, "N0688 L1=6000"},
    // Codes: part 1, 14.3, 14.7, part 2, 24; probes: part 2, 31.
    {{"N1333 L1=70"}, Alarm::ConfigAuxAddress, "N1333 L1=70"},
    {{"N1333 L1=66", "N0817 S3=66"}, Alarm::ConfigAuxAddress, "N1333 L1=66 and N0817 S3=66"},
    {{"N1341 L1=490", "N1357 L1=510"}, Alarm::ConfigCodes, "N1341 L1=490"},
    {{"N2305 L1=555"}, Alarm::ConfigCodes, "N2305 L1=555"},
    {{"N3012 L1=3", "N3013 L1=3"}, Alarm::ConfigSwitch, "N3012 L1=3 and N3013 L1=3"},
    // Pitch tables: part 2, section 26.
    {{"N0106 A2=4", "N2500 A2=8", "N2507 A2=2", "N2508 A2=10500", "N2509 A2=10510", "N2510 A2=25"},
     Alarm::ConfigPitch,
     "N2510 A2=25"},
    {{"N2500 A2=8", "N2507 A2=2", "N2508 A2=10500", "N2509 A2=10510", "N2510 A2=20"},
     Alarm::ConfigPitch,
     "N2500 A2=8"},
    {{"N2500 A5=5", "N2501 A5=10", "N2502 A5=10000", "N2503 A5=10000", "N2504 A5=10030"},
     Alarm::ConfigPitch,
     "N2506 A5=360"},
    {{"N2500 A2=1", "N2501 A2=10", "N2502 A2=20000", "N2503 A2=10000", "N2504 A2=10030"},
     Alarm::ConfigPitch,
     "N2502 A2=20000"},
    {{"N2500 A2=1", "N2501 A2=0", "N2502 A2=10000", "N2503 A2=10000", "N2504 A2=10030"},
     Alarm::ConfigPitch,
     "N2501 A2=0"},
    // An inclined slide (fanuc_lathe 10.5): its angle; and what it cannot do.
    {{"F8200#0 L1=1"}, Alarm::ParameterContradicts, "F8210 L1=0"},
    {{"F8200#0 L1=1", "F8210 L1=90"}, Alarm::ParameterContradicts, "F8210 L1=90"},
    {{"F8200#0 L1=1", "F8210 L1=30", "PT_BALANCE L1=2", "PT_BALANCE L2=1"},
     Alarm::ParameterContradicts,
     "PT_BALANCE L1=2"},
    // measured only, but its loop could be closed
    {{"N0002 A7=99", "N0534 A1=7"}, Alarm::ConfigLoop, "is not virtual"},
    // Stored, and nothing acts on it.
    {{"N1402#1 L1=1"}, Alarm::ParamWithoutEffect, "N1402 L1="},
    {{"N1402#2 L2=1"}, Alarm::ParamWithoutEffect, "N1402 L2="},
    {{"N1755#4 L1=1"}, Alarm::ParamWithoutEffect, "N1755 L1="},
    {{"N1758#5 L1=1"}, Alarm::ParamWithoutEffect, "N1758 L1="},
    {{"N1800#2 L1=1"}, Alarm::ParamWithoutEffect, "N1800 L1="},
    {{"N3103 L1=0.01"}, Alarm::ParamWithoutEffect, "N3103 L1="},
    {{"MD20480 L1=1"}, Alarm::ParamWithoutEffect, "MD20480 L1="},
};

TEST(MachineCheck, NamesParameterScopeAndValueOfEachContradiction) {
    for (const Row& row : kRows) {
        SCOPED_TRACE(row.names);
        const auto found = check_machine_config(twin_turret_with(row.lines));
        EXPECT_EQ(found.size(), 1u)
            << (found.size() > 1 ? found[0].text() + "; " + found[1].text() : "nothing found");
        if (found.size() != 1) continue;
        EXPECT_EQ(found[0].alarm, row.alarm) << found[0].text();
        EXPECT_NE(found[0].detail.find(row.names), std::string::npos) << found[0].detail;
    }
}

// Each axis of a ring is named, whatever kinds of coupling close it.
TEST(MachineCheck, NamesTheAxesOfACycleOfCouplings) {
    for (const auto& lines : std::vector<std::vector<const char*>>{
             {"N2101 A2=4", "N2107 A4=2"},
             {"N2107 A2=4", "N2107 A4=2"},
             {"N2101 A2=4", "N2101 A4=2", "N2102 A2=4", "N2102 A4=4"}}) {
        const auto found = check_machine_config(twin_turret_with(lines));
        ASSERT_EQ(found.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(found[i].alarm, Alarm::ConfigCoupling);
            EXPECT_NE(found[i].detail.find(lines[i]), std::string::npos) << found[i].detail;
        }
    }
}

// What looks like a contradiction and is none.
TEST(MachineCheck, LetsPassWhatTheSpecificationAllows) {
    const std::vector<const char*> kGood[] = {
        // the machine as it is; C axes share their spindles' drives
        {},
        {"N2201=0", "N2202=0"},                             // no waiting codes
        {"N0002 A7=99"},                                    // measured only
        {"N0002 A7=1", "N0100 A7=88", "N0101 A7=50"},       // X2 beside X
        {"N0002 A7=2", "N0100 A7=89", "N0103 A7=5"},        // parallel to X
        {"N0106 A6=10000010", "N0400 A6=0", "N0503 A6=1"},  // hypothetical: no drive of its own
        {"N1000 A2=0", "N1002 A2=-900"},                    // a range that is not watched
        {"N0604 L2=0", "N0687 L2=0"},                       // none
        // of every axis: DIA counts for linear ones, REN for rotary ones (part 1, 3.4, 3.5)
        {"N0106#0=1", "N0107=1"},
        // at what they may be
        {"N3106 L1=1", "N3107 L1=2", "N3205 L1=4", "N3206 L1=20", "N1413 L1=3", "N2923 L1=555",
         "N0682 S1=10"},
        {"N2500 A5=5", "N2501 A5=10", "N2502 A5=10000", "N2503 A5=10000", "N2504 A5=10036",
         "N2506 A5=360"},
        // Auto, and what else the cycle may be
        {"N0005=0"},
        {"N0005=2000"},
        {"N0005=5000"},
        {"N2901#0 L2=1", "N2903=2", "N2904=2"},  // the last column
        {"N2903=2", "N2904=3"},                  // TCU 0: no column is asked
    };
    for (const auto& lines : kGood) {
        const auto found = check_machine_config(twin_turret_with(lines));
        EXPECT_TRUE(found.empty()) << (lines.empty() ? "plain" : lines[0]) << ": "
                                   << (found.empty() ? "" : found[0].text());
    }
}

TEST(MachineCheck, FindsAllContradictionsAtOnce) {
    const auto found = check_machine_config(
        twin_turret_with({"N0002 A7=5", "N0604 L2=7", "N2201=700", "N0304 A1=0"}));
    EXPECT_EQ(found.size(), 4u);
}

TEST(MachineCheck, CountsAxesOfAChannelButNotDirectMeasuringDevices) {
    params::Table table = twin_turret_with({});
    // with A1, A2, A5 sixteen axes of L1, named U0 to U9, V0 ...
    for (unsigned a = 7; a <= 19; ++a) {
        params::put(table, params::n0002_axis_assign, 1, a);
        params::put(table, params::n0100_axis_name1, a < 17 ? 'U' : 'V', a);
        params::put(table, params::n0101_axis_name2, '0' + (a - 7) % 10, a);
    }
    EXPECT_TRUE(check_machine_config(table).empty());
    params::put(table, params::n0002_axis_assign, 1, 20);
    auto found = check_machine_config(table);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].alarm, Alarm::ConfigAxisCount);
    // A20 carries the scale of A1, so it is virtual
    params::put(table, params::n0534_dual_position_axis_number, 20, 1);
    params::put(table, params::n0106_axis_properties, 1 << 4, 20);
    EXPECT_TRUE(check_machine_config(table).empty());
}

TEST(MachineCheck, MissesNothingWhenThereIsNoMachineAtAll) {
    const auto found = check_machine_config(params::defaults());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].alarm, Alarm::ConfigNoChannel);
}

}  // namespace
