// Setup, scenario and job: what the manual shows is read, and whatever is not understood is named
// with its place.
#include <gtest/gtest.h>

#include <cmath>

#include "ipc/model/files/job.hpp"
#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/scenario.hpp"
#include "ipc/model/files/setup.hpp"
#include "ipc/model/files/setup_text.hpp"

namespace polyturn::text {
namespace {

constexpr const char* kSetup = R"(clock = "2026-01-31T12:34:56"
[channel.1]
machine = { X = 200.0, Z = 100 }
pos = { "X" = 100.0, Z = 5.0 }
work = { G54 = { X = 0.0, Z = -150.0 }, "G54.1P3" = { Z = 2 }, shift = { X = 0.5 } }
variables = { "#100" = 12.5, R1 = 3, "#1000" = true, "#101" = nan, NAME = "A" }
keys = { block_skip = [1, 3], optional_stop = true, single_block = false, dry_run = 1 }
subprograms = ["O0200.nc", "/abs/PROFILE.SPF"]
[channel.1.offset.3]
geometry = { X = -12.3, Z = 4.5, R = 0.8, T = 3 }
wear = { X = 0.05 }
[channel.1.tool.1]
name = "ROUGH_80"
[channel.1.tool.1.edge.1]
DP1 = 500
DP6 = 0.8
[[channel.1.sensor]]
input = "XAE"
axis = "X"
at = 40.0
direction = "-"
[[channel.1.sensor]]
input = 3
axis = "Z"
at = 9.6
)";

void expect_manual_setup(const Setup& setup, const std::string& folder) {
    ASSERT_TRUE(setup.clock);
    EXPECT_EQ(setup.clock->second, 56);
    const ChannelSetup& one = setup.channel(1);
    EXPECT_EQ(one.machine.at("Z"), 100.0);
    EXPECT_EQ(one.pos.at("X"), 100.0);
    EXPECT_EQ(one.work.at("G54").at("Z"), -150.0);
    EXPECT_EQ(one.work.at("G54.1P3").at("Z"), 2.0);
    ASSERT_EQ(one.variables.size(), 5u);
    bool empty = false, text = false;
    for (const SetupVariable& variable : one.variables) {
        empty = empty || (variable.name == "#101" && std::isnan(variable.value));
        text = text || (variable.is_text && variable.text == "A");
    }
    EXPECT_TRUE(empty && text);
    EXPECT_EQ(one.keys.block_skip, (std::vector<int>{1, 3}));
    EXPECT_TRUE(one.keys.optional_stop && one.keys.dry_run);
    EXPECT_FALSE(one.keys.single_block);
    EXPECT_EQ(one.subprograms,
              (std::vector<std::string>{folder + "/O0200.nc", "/abs/PROFILE.SPF"}));
    EXPECT_EQ(one.offsets.at(3).geometry.t, 3.0);
    EXPECT_EQ(one.offsets.at(3).wear.x, 0.05);
    EXPECT_FALSE(one.offsets.at(3).wear.z);
    EXPECT_EQ(one.tools.at(1).name, "ROUGH_80");
    EXPECT_EQ(one.tools.at(1).edges.at(1).at("DP6"), 0.8);
    ASSERT_EQ(one.sensors.size(), 2u);
    EXPECT_EQ(one.sensors[0].direction, -1);
    EXPECT_EQ(one.sensors[1].input, "3");
    EXPECT_TRUE(setup.channel(7).machine.empty());
}

TEST(Setup, TheManualsExampleIsRead) {
    std::vector<Diagnosis> diagnoses;
    const text::Setup setup = parse_setup(kSetup, "/jobs/a.setup.toml", diagnoses);
    for (const Diagnosis& diagnosis : diagnoses)
        ADD_FAILURE() << render(diagnosis, Dialect::Polyturn, "");
    expect_manual_setup(setup, "/jobs");
}

TEST(Setup, WrittenAndReadAgainItIsTheSame) {
    std::vector<Diagnosis> diagnoses;
    const text::Setup setup = parse_setup(kSetup, "/jobs/a.setup.toml", diagnoses);
    const text::Setup again = parse_setup(setup_text(setup), "/elsewhere/b.toml", diagnoses);
    EXPECT_TRUE(diagnoses.empty());
    expect_manual_setup(again, "/jobs");
}

TEST(Setup, WholeTablesMayStandInOneLineWithQuotedKeys) {
    std::vector<Diagnosis> diagnoses;
    const text::Setup setup =
        parse_setup(R"("channel" = { "1" = { "pos" = { "X" = 100.0 }, )"
                    R"("offset" = { "5" = { "geometry" = { "X" = -12.4, "T" = 0 } } } } })",
                    "s.toml", diagnoses);
    EXPECT_TRUE(diagnoses.empty());
    EXPECT_EQ(setup.channel(1).offsets.at(5).geometry.x, -12.4);
}

// fanuc_lathe 10.4.2: an offset of the B axis, which stands in the Y column.
TEST(Setup, GivesTheBAxisItsOffsets) {
    std::vector<Diagnosis> diagnoses;
    const text::Setup setup =
        parse_setup("[channel.1.offset.1]\ngeometry = { B = 3.0 }\n", "s.toml", diagnoses);
    EXPECT_TRUE(diagnoses.empty());
    EXPECT_EQ(setup.channel(1).offsets.at(1).geometry.y, 3.0);
}

struct Bad {
    const char* text;
    Alarm alarm;
    std::uint32_t line, column;
};

TEST(Setup, WhatIsNotUnderstoodIsNamedWithItsPlace) {
    const Bad rows[] = {
        {"[channel.1]\ngeometrie = 5\n", Alarm::UnknownKey, 2, 1},
        {"[channel.1]\nmachine = \"left\"\n", Alarm::WrongType, 2, 11},
        {"[channel.1]\nmachine = { X = true }\n", Alarm::WrongType, 2, 17},
        {"[channel.17]\n", Alarm::UnknownKey, 1, 10},
        {"[channel.x]\n", Alarm::UnknownKey, 1, 10},
        {"[channel.1.offset.0]\n", Alarm::UnknownKey, 1, 19},
        {"[channel.1.offset.1]\ngeometry = { T = 10 }\n", Alarm::WrongType, 2, 18},
        {"[channel.1\n", Alarm::TextSyntax, 1, 11},
        {"clock = \"2026-02-30T00:00:00\"\n", Alarm::WrongType, 1, 9},
        {"clock = 5\n", Alarm::WrongType, 1, 9},
        {"[channel.1]\npos = { X = inf }\n", Alarm::WrongType, 2, 13},
        {"[channel.1.tool.1.edge.1]\nP1 = 5\n", Alarm::UnknownKey, 2, 1},
    };
    for (const Bad& row : rows) {
        SCOPED_TRACE(row.text);
        std::vector<Diagnosis> diagnoses;
        parse_setup(row.text, "bad.toml", diagnoses);
        ASSERT_FALSE(diagnoses.empty());
        EXPECT_EQ(diagnoses[0].alarm, row.alarm) << diagnoses[0].text();
        EXPECT_EQ(diagnoses[0].place.line, row.line);
        EXPECT_EQ(diagnoses[0].place.column, row.column);
        EXPECT_EQ(diagnoses[0].place.file, "bad.toml");
    }
}

TEST(Scenario, TimesAndEventsInTheFilesOrder) {
    std::vector<Diagnosis> diagnoses;
    const Scenario scenario = parse_scenario(R"([[at]]
t = 1.5
set = "AP_SYNCR A3=1"
[[at]]
when = { ev = "wait", ch = 1, pos = { X = 2.5 }, list = [1, true, "a\"b"] }
after = 0.2
press = "feed_hold L2"
[[at]]
t = 4
stop = "toolmgmt"
for = 0.5
[[at]]
t = 5
kill = "channel 2"
release = "AP_SYNCR A3"
)",
                                             "s.toml", diagnoses);
    for (const Diagnosis& diagnosis : diagnoses)
        ADD_FAILURE() << render(diagnosis, Dialect::Polyturn, "");
    ASSERT_EQ(scenario.stimuli.size(), 5u);
    EXPECT_EQ(scenario.stimuli[0].at_s, 1.5);
    EXPECT_EQ(scenario.stimuli[1].when,
              R"({"ch":1,"ev":"wait","list":[1,true,"a\"b"],"pos":{"X":2.5}})");
    EXPECT_EQ(scenario.stimuli[1].after_s, 0.2);
    EXPECT_FALSE(scenario.stimuli[1].at_s);
    EXPECT_EQ(scenario.stimuli[2].for_s, 0.5);
    EXPECT_EQ(scenario.stimuli[3].kind, StimulusKind::Kill);
    EXPECT_EQ(scenario.stimuli[4].kind, StimulusKind::Release);
    EXPECT_EQ(scenario.stimuli[4].place.line, 15u);
}

TEST(Scenario, WhatIsNotUnderstoodIsNamed) {
    for (const char* text :
         {"[[at]]\npress = \"reset\"\n", "[[at]]\nt = 1\n", "[[at]]\nt = -1\npress = \"reset\"\n",
          "[[at]]\nt = 1\nwhen = { ev = \"wait\" }\npress = \"reset\"\n",
          "[[at]]\nt = 1\npress = 5\n", "[[at]]\nt = 1\npush = \"reset\"\n", "[at]\nt = 1\n",
          "[[at]]\nt = 1\nfor = 2\npress = \"reset\"\n", "x = 1\n",
          "[[at]]\nwhen = { d = 2026-01-01 }\npress = \"reset\"\n"}) {
        SCOPED_TRACE(text);
        std::vector<Diagnosis> diagnoses;
        parse_scenario(text, "s.toml", diagnoses);
        ASSERT_FALSE(diagnoses.empty());
        EXPECT_GT(diagnoses[0].place.line, 0u);
    }
}

TEST(Job, TheManualsExampleIsRead) {
    std::vector<Diagnosis> diagnoses;
    const Job job = parse_job(R"(name = "shaft"
[programs]
1 = { file = "O1001.nc", language = "fanuc" }
2 = "O2001.nc"
[stock]
spindle = "S1"
diameter = 60.0
length = 150.0
face = 2.0
[zeros]
1 = { G54 = { Z = -150.0 } }
[[tools]]
channel = 1
station = 1
name = "roughing 80°"
[parts]
wanted = 100
)",
                              "/jobs/shaft.job.toml", diagnoses);
    for (const Diagnosis& diagnosis : diagnoses)
        ADD_FAILURE() << render(diagnosis, Dialect::Polyturn, "");
    EXPECT_EQ(job.programs.at(1).file, "/jobs/O1001.nc");
    EXPECT_EQ(job.programs.at(1).language, "fanuc");
    EXPECT_EQ(job.programs.at(2).file, "/jobs/O2001.nc");
    EXPECT_EQ(job.stock->face, 2.0);
    EXPECT_EQ(job.zeros.at(1).at("G54").at("Z"), -150.0);
    EXPECT_EQ(job.tools.at(0).name, "roughing 80°");
    EXPECT_EQ(job.parts_wanted, 100u);
    EXPECT_TRUE(is_job_file("a.job.toml"));
    EXPECT_FALSE(is_job_file("a.toml"));
}

TEST(Job, WhatIsNotUnderstoodIsNamed) {
    for (const char* text : {"name = \"a\"\n", "[programs]\n17 = \"a\"\n",
                             "[programs]\n1 = { language = \"fanuc\" }\n",
                             "[programs]\n1 = \"a\"\n[stock]\ndiameter = -1\n",
                             "[programs]\n1 = \"a\"\n[stock]\nspindle = \"main\"\n",
                             "[programs]\n1 = \"a\"\n[parts]\nwanted = 1.5\n", "nonsense"}) {
        SCOPED_TRACE(text);
        std::vector<Diagnosis> diagnoses;
        parse_job(text, "j.job.toml", diagnoses);
        EXPECT_FALSE(diagnoses.empty());
    }
}

TEST(ReadFile, RefusesWhatIsNoText) {
    EXPECT_EQ(read_text_file("/nowhere/at/all").diagnosis().alarm, Alarm::FileUnreadable);
    EXPECT_EQ(read_text_file("/tmp").diagnosis().alarm, Alarm::FileKind);
    EXPECT_EQ(read_text_file("/proc/self/exe").diagnosis().alarm, Alarm::FileBinary);
    EXPECT_EQ(line_of("a\r\nb\n\nd", 1), "a");
    EXPECT_EQ(line_of("a\r\nb\n\nd", 4), "d");
    EXPECT_EQ(line_of("a", 2), "");
}

}  // namespace
}  // namespace polyturn::text
