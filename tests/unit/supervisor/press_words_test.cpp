// What can be pressed and set: one row a sentence, with what it asks of the kernel or why it is
// refused.
#include "kernel/supervisor/press/press_words.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "ipc/image/commands.hpp"
#include "ipc/model/machine/load_machine.hpp"
#include "ipc/params/param_file.hpp"

namespace polyturn::supervisor {
namespace {

const MachineConfig& machine() {
    static const MachineConfig config = [] {
        auto table = std::make_unique<params::Table>();
        params::set_defaults(*table);
        for (const char* line : {"N0000 L1=1", "N0000 L2=1", "N0002 A1=1", "N0100 A1=88",
                                 "N0103 A1=1", "N0002 A2=1", "N0100 A2=90", "N0103 A2=3",
                                 "N0002 A3=2", "N0100 A3=88", "N0103 A3=1", "N0607#0 S1=1"}) {
            const auto assignment = params::parse_assignment(line);
            EXPECT_TRUE(assignment) << line;
            EXPECT_TRUE(params::apply(*table, {&*assignment, 1})) << line;
        }
        return derive_machine_config(*table);
    }();
    return config;
}

struct Row {
    const char* words;
    CommandKind kind;
    std::uint32_t channel, object;
    double value;
    std::uint32_t flags;
    const char* text;
};

constexpr Row kPress[] = {
    {"cycle_start", CommandKind::CycleStart, 0, 0, 1, 0, ""},
    {"cycle_start L2", CommandKind::CycleStart, 2, 0, 0, 0, ""},
    {"  feed_hold   2 ", CommandKind::FeedHold, 2, 0, 0, 0, ""},
    {"reset L1", CommandKind::Reset, 1, 0, 0, 0, ""},
    {"emergency_stop", CommandKind::EmergencyStop, 0, 0, 1, 0, ""},
    {"release_emergency_stop", CommandKind::ReleaseStop, 0, 0, 1, 0, ""},
    {"machine_on", CommandKind::MachineOn, 0, 0, 1, 0, ""},
    {"mode L1=handwheel", CommandKind::Mode, 1, 0, 3, 0, ""},
    {"select L2=prog/O1.nc", CommandKind::Select, 2, 0, 0, 0, "prog/O1.nc"},
    {"select L2=with blank.nc", CommandKind::Select, 2, 0, 0, 0, "with blank.nc"},
    {"mdi L1 G0 X50.", CommandKind::Mdi, 1, 0, 0, 0, "G0 X50."},
    {"mdi_clear L2", CommandKind::MdiClear, 2, 0, 0, 0, ""},
    {"hand_key L1 T0101", CommandKind::HandKey, 1, 0, 0, 0, "T0101"},
    {"jog A3+ 0.5s", CommandKind::Jog, 0, 3, 0.5, 0, ""},
    {"jog A1- 2", CommandKind::Jog, 0, 1, -2, 0, ""},
    {"step A3- 0.01", CommandKind::Step, 0, 3, -0.01, 0, ""},
    {"handwheel 1 A3 +120", CommandKind::Handwheel, 0, 3, 120, 1, ""},
    {"handwheel 2 A1 -7", CommandKind::Handwheel, 0, 1, -7, 2, ""},
    {"reference A3", CommandKind::Reference, 0, 3, 0, 0, ""},
    {"reference all", CommandKind::Reference, 0, 0, 0, 0, ""},
    {"home A1", CommandKind::Reference, 0, 1, 0, 0, ""},
    {"answer L2 #500=-12.5", CommandKind::DialogueValue, 2, 0, -12.5, 0, "#500"},
    {"answer L1 key=3", CommandKind::DialogueKey, 1, 0, 3, 0, ""},
    {"feed_override L1=50", CommandKind::FeedOverride, 1, 0, 0.5, 0, ""},
    {"feed_override all=120%", CommandKind::FeedOverride, 0, 0, 1.2, 0, ""},
    {"rapid_override L1=25", CommandKind::RapidOverride, 1, 0, 0.25, 0, ""},
    {"spindle_override S1=80", CommandKind::SpindleOverride, 0, 1, 0.8, 0, ""},
    {"single_block L1=on", CommandKind::SingleBlock, 1, 0, 1, 0, ""},
    {"optional_stop L1=off", CommandKind::OptionalStop, 1, 0, 0, 0, ""},
    {"block_skip L1=1", CommandKind::BlockSkip, 1, 0, 1, 1, ""},
    {"block_skip L1=3", CommandKind::BlockSkip, 1, 0, 1, 3, ""},
    {"block_skip L1=-3", CommandKind::BlockSkip, 1, 0, 0, 3, ""},
    {"block_skip L1=0", CommandKind::BlockSkip, 1, 0, 0, 0, ""},
    {"block_skip L1=10", CommandKind::BlockSkip, 1, 0, 1, 10, ""},
    {"block_skip L1=on", CommandKind::BlockSkip, 1, 0, 1, 1, ""},
    {"dry_run L1=1", CommandKind::DryRun, 1, 0, 1, 0, ""},
    {"machine_lock L2=on", CommandKind::MachineLock, 2, 0, 1, 0, ""},
    {"restart L1=N120", CommandKind::Restart, 1, 0, 120, 1, ""},
    {"retrace L1=on", CommandKind::Retrace, 1, 0, 1, 0, ""},
    {"first_part L2=on", CommandKind::FirstPart, 2, 0, 1, 0, ""},
    {"program_wheel L1=on", CommandKind::ProgramHandwheel, 1, 0, 1, 0, ""},
    {"handwheel 1 L2 -50", CommandKind::Handwheel, 2, 0, -50, 1, ""},
    {"jog_in_hold L1", CommandKind::JogInHold, 1, 0, 0, 0, ""},
    {"return L1", CommandKind::Return, 1, 0, 0, 0, ""},
    {"ignore_waits L2=on", CommandKind::IgnoreWaits, 2, 0, 1, 0, ""},
    {"rapid_key L1=on", CommandKind::RapidKey, 1, 0, 1, 0, ""},
    {"superpose L1=on", CommandKind::Superpose, 1, 0, 1, 0, ""},
    {"warm_up L1=600", CommandKind::WarmUp, 1, 0, 600, 0, ""},
    {"warm_up L2=90s", CommandKind::WarmUp, 2, 0, 90, 0, ""},
    {"stop_after_part", CommandKind::StopAfterPart, 0, 0, 1, 0, ""},
    {"stop_after_part off", CommandKind::StopAfterPart, 0, 0, 0, 0, ""},
};

void expect_command(const Command& command, const Row& row) {
    EXPECT_EQ(command.kind, static_cast<std::uint32_t>(row.kind));
    EXPECT_EQ(command.channel, row.channel);
    EXPECT_EQ(command.object, row.object);
    if (row.value != 0 || row.kind != CommandKind::CycleStart) {
        EXPECT_NEAR(command.value, row.value, 1e-12);
    }
    EXPECT_EQ(command.flags, row.flags);
    EXPECT_STREQ(command.text.data(), row.text);
    EXPECT_EQ(command.tick, 0);
}

TEST(Press, EverySentenceOfTheManualIsUnderstood) {
    std::set<std::string_view> seen;
    for (const Row& row : kPress) {
        SCOPED_TRACE(row.words);
        const auto commands = parse_press(row.words, machine());
        ASSERT_TRUE(commands) << commands.diagnosis().text();
        ASSERT_EQ(commands->size(), 1u);
        expect_command(commands->front(), row);
        std::string_view words = row.words;
        words.remove_prefix(words.find_first_not_of(' '));
        seen.insert(words.substr(0, words.find(' ')));
    }
    // the one is told by its object, the other has a test of its own below
    seen.insert("override");
    seen.insert("scope");
    for (const std::string_view name : press_names())
        EXPECT_TRUE(seen.count(name)) << name << " has no row here";
}

TEST(Press, AnAnswerTellsItsValuesBeforeItsKey) {
    const auto commands = parse_press("answer L1 #500=12.5 #501=3 key=1", machine());
    ASSERT_TRUE(commands);
    ASSERT_EQ(commands->size(), 3u);
    EXPECT_EQ((*commands)[0].kind, static_cast<std::uint32_t>(CommandKind::DialogueValue));
    EXPECT_EQ((*commands)[2].kind, static_cast<std::uint32_t>(CommandKind::DialogueKey));
    for (const char* words :
         {"answer", "answer L1", "answer L9 key=1", "answer L1 key=1 #500=2", "answer L1 key=0",
          "answer L1 key=1.5", "answer L1 #500", "answer L1 =3", "answer L1 #500=x"})
        EXPECT_FALSE(parse_press(words, machine())) << words;
}

TEST(Press, SeveralChannelsInOneSentence) {
    const auto commands = parse_press("restart L1=N120 L2=N340", machine());
    ASSERT_TRUE(commands);
    ASSERT_EQ(commands->size(), 2u);
    EXPECT_EQ((*commands)[1].channel, 2u);
    EXPECT_EQ((*commands)[1].value, 340.0);
    for (const Command& command : *commands)
        EXPECT_EQ(command.flags, 3u) << "both restart, so their waits are replayed";
}

// T: the channels of a machine group (N0000). A start is one command, so that the kernel begins
// them in one tick and passes over who has nothing to begin.
TEST(Press, AMachineGroupIsNamedByItsLetter) {
    const auto start = parse_press("cycle_start T1", machine());
    ASSERT_TRUE(start) << start.diagnosis().text();
    ASSERT_EQ(start->size(), 1u);
    EXPECT_EQ(start->front().channel, 0u);
    EXPECT_EQ(start->front().object, 1u);
    for (const char* words : {"feed_hold T1", "reset t1", "single_block T1=on", "dry_run T1=on"}) {
        const auto commands = parse_press(words, machine());
        ASSERT_TRUE(commands) << words << ": " << commands.diagnosis().text();
        ASSERT_EQ(commands->size(), 2u) << words;
        EXPECT_EQ(commands->front().channel, 1u);
        EXPECT_EQ(commands->back().channel, 2u);
    }
    for (const char* words : {"cycle_start T2", "reset T0", "feed_hold T", "single_block T2=on",
                              "single_block T1=maybe", "return T1", "cycle_start T1x"}) {
        const auto commands = parse_press(words, machine());
        ASSERT_FALSE(commands) << words;
        EXPECT_FALSE(commands.diagnosis().text().empty());
    }
    EXPECT_NE(parse_press("cycle_start T2", machine()).diagnosis().text().find("no group T2"),
              std::string::npos);
}

// A folder may lie deep; what is too deep is told with what to do, not with the form of the
// sentence.
TEST(Press, APathOfTwoHundredCharactersIsSelectedAndALongerOneSaysWhatToDo) {
    const std::string deep = "/" + std::string(120, 'a') + "/" + std::string(70, 'b') + "/O1.nc",
                      deeper = "/" + std::string(200, 'a') + deep;
    const auto commands = parse_press("select L1=" + deep, machine());
    ASSERT_TRUE(commands) << commands.diagnosis().text();
    EXPECT_EQ(std::string(commands->front().text.data()), deep);
    const auto refused = parse_press("select L1=" + deeper, machine());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.diagnosis().alarm, Alarm::PressArgument)
        << "the remedy of the form helps nobody here";
    EXPECT_LT(refused.diagnosis().text().size(), 120u) << "the remedy has no room behind it";
}

TEST(Press, NonsenseIsRefusedWithTheForm) {
    for (const char* words : {"",
                              "dance",
                              "cycle_start L3",
                              "cycle_start A1",
                              "mode L1=fast",
                              "mode L1",
                              "select",
                              "select L1",
                              "mdi L1",
                              "jog A3 0.5",
                              "jog A3+ soon",
                              "jog A9+ 1",
                              "step A3- -1",
                              "handwheel 9 A3 1",
                              "handwheel 1 A3",
                              "reference",
                              "reference A77",
                              "feed_override L1=201",
                              "feed_override L1=-1",
                              "feed_override 50",
                              "spindle_override L1=50",
                              "single_block L1=maybe",
                              "block_skip L1=11",
                              "block_skip L1=1.5",
                              "restart L1=X",
                              "restart all=N10",
                              "handwheel 1 L7 5",
                              "emergency_stop now",
                              "return",
                              "return L1 L2"}) {
        SCOPED_TRACE(words);
        const auto commands = parse_press(words, machine());
        ASSERT_FALSE(commands);
        EXPECT_FALSE(commands.diagnosis().text().empty());
    }
}

TEST(Set, SignalsInputsDrivesParametersAndKeys) {
    const auto one = [](const char* words) {
        const auto commands = parse_set(words, machine());
        EXPECT_TRUE(commands) << words;
        return commands ? commands->front() : Command{};
    };
    Command command = one("AP_SYNCR A3=1");
    EXPECT_EQ(command.kind, static_cast<std::uint32_t>(CommandKind::SetSignal));
    EXPECT_EQ(command.object, signals::ap_syncr(3));
    EXPECT_EQ(command.flags, kSlotOfPlc);
    EXPECT_EQ(command.value, 1.0);
    command = one("cp_nowt l2 = 1");
    EXPECT_EQ(command.object, signals::cp_nowt(2));
    command = one("SP_ROT S2=19");
    EXPECT_EQ(command.value, 19.0);
    command = one("CN_WTNG L1=1");
    EXPECT_EQ(command.flags, kSlotOfNc);
    command = one("drive A3=fault");
    EXPECT_EQ(command.kind, static_cast<std::uint32_t>(CommandKind::DriveFault));
    EXPECT_EQ(command.object, 3u);
    command = one("drive S1=ok");
    EXPECT_EQ(command.flags, 1u);
    EXPECT_EQ(command.value, 0.0);
    command = one("input 17=1");
    EXPECT_EQ(command.kind, static_cast<std::uint32_t>(CommandKind::SetInput));
    EXPECT_EQ(command.object, 17u);
    command = one("#1003 L2=1");  // one bit of the register: the others keep what the PLC writes
    EXPECT_EQ(command.kind, static_cast<std::uint32_t>(CommandKind::SetSignal));
    EXPECT_EQ(command.object, signals::cp_uin(2));
    EXPECT_EQ(command.channel, 4u);
    command = one("$A_IN[32] L2=1");  // as sinumerik names them
    EXPECT_EQ(command.object, signals::cp_uin(2));
    EXPECT_EQ(command.channel, 32u);
    command = one("N0304 A1=5000");
    EXPECT_EQ(command.kind, static_cast<std::uint32_t>(CommandKind::SetParameter));
    EXPECT_STREQ(command.text.data(), "N0304 A1=5000");
    command = one("override L1=40");
    EXPECT_EQ(command.kind, static_cast<std::uint32_t>(CommandKind::FeedOverride));
    EXPECT_NEAR(command.value, 0.4, 1e-12);
}

TEST(Set, WhatIsWrongIsSaid) {
    const std::pair<const char*, Alarm> rows[] = {
        {"AP_SYNCR=1", Alarm::SignalScope},        {"AP_SYNCR L1=1", Alarm::SignalScope},
        {"AP_SYNCR A97=1", Alarm::SignalScope},    {"#1000 L1=2", Alarm::PressArgument},
        {"$A_IN[1] L1=2", Alarm::PressArgument},   {"AP_SYNCR A3=2", Alarm::PressArgument},
        {"NO_SUCH L1=1", Alarm::SignalUnknown},    {"AP_SYNCR A3", Alarm::PressArgument},
        {"drive A77=fault", Alarm::PressArgument}, {"drive A3=hot", Alarm::PressArgument},
        {"input 3=5", Alarm::PressArgument},       {"N0304 A1=fast", Alarm::ParamValue},
    };
    for (const auto& [words, alarm] : rows) {
        SCOPED_TRACE(words);
        const auto commands = parse_set(words, machine());
        ASSERT_FALSE(commands);
        EXPECT_EQ(commands.diagnosis().alarm, alarm) << commands.diagnosis().text();
    }
}

TEST(Release, GivesASignalBack) {
    const auto commands = parse_release("AP_SYNCR A3", machine());
    ASSERT_TRUE(commands);
    EXPECT_EQ(commands->front().kind, static_cast<std::uint32_t>(CommandKind::ReleaseSignal));
    EXPECT_EQ(commands->front().object, signals::ap_syncr(3));
    EXPECT_FALSE(parse_release("NOTHING", machine()));
}

TEST(Press, ScopeNamesATraceAndWhatItRecords) {
    const auto commands = parse_press("scope 2 measured A3", machine());
    ASSERT_TRUE(commands) << commands.diagnosis().text();
    EXPECT_EQ(commands->front().kind, static_cast<std::uint32_t>(CommandKind::Scope));
    EXPECT_EQ(commands->front().flags, 1u);
    EXPECT_EQ(commands->front().object, 3u);
    EXPECT_EQ(commands->front().value, static_cast<double>(ScopeKind::AxisMeasured));
    const auto signal = parse_press("scope 8 signal CN_WTNG L1", machine());
    ASSERT_TRUE(signal) << signal.diagnosis().text();
    EXPECT_EQ(signal->front().value, static_cast<double>(ScopeKind::NcSignal));
    EXPECT_TRUE(parse_press("scope 1 off", machine()));
    EXPECT_TRUE(parse_press("scope 1 input 12", machine()));
    for (const char* words : {"scope", "scope 1", "scope 0 off", "scope 9 off", "scope 1 measured",
                              "scope 1 measured A95", "scope 1 measured L1", "scope 1 nothing A1",
                              "scope 1 off A1", "scope 1 input 256", "scope 1 signal NONSENSE"})
        EXPECT_FALSE(parse_press(words, machine())) << words;
}

TEST(Set, OffsetsAndZerosAsTheTablesShowThem) {
    auto commands = parse_set("offset L1 3 wear X=0.05", machine());
    ASSERT_TRUE(commands) << commands.diagnosis().text();
    EXPECT_EQ(commands->front().kind, static_cast<std::uint32_t>(CommandKind::StoreValue));
    EXPECT_EQ(commands->front().object, static_cast<std::uint32_t>(StoreRequestKind::OffsetValue));
    EXPECT_EQ(commands->front().flags, 3u << 16 | 256u);
    EXPECT_EQ(commands->front().value, 0.05);
    commands = parse_set("zero L1 G54 Z=-150", machine());
    ASSERT_TRUE(commands) << commands.diagnosis().text();
    EXPECT_EQ(commands->front().channel, 1u);
    EXPECT_STREQ(commands->front().text.data(), "G54 Z");
    for (const char* words :
         {"offset L1 0 wear X=1", "offset L1 3 wear Q=1", "offset L9 3 wear X=1",
          "offset L1 3 wear T=12", "zero L1 G99 X=1", "zero L1 G54 W=1", "offset L1 3 X=1"})
        EXPECT_FALSE(parse_set(words, machine())) << words;
}

}  // namespace
}  // namespace polyturn::supervisor
