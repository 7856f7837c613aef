// A command that does nothing says so: for every kind, where it is refused, and that it is said; or
// why it is never refused.
#include <map>

#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

struct Commands : TickRig {
    std::size_t said() const {
        std::size_t n = 0;
        for (const KernelEvent& e : log)
            n += e.kind == static_cast<std::uint32_t>(KernelEventKind::Alarm) ||
                 e.kind == static_cast<std::uint32_t>(KernelEventKind::Message);
        return n;
    }
};
using Step = std::function<void(Commands&)>;
struct Refused {
    const char* where;
    Step prepare, press;
};
struct Row {
    std::vector<Refused> refused;
    const char* never = nullptr;  // why nothing can refuse it
};

void runs(Commands& r) {
    r.push(1, r.line(1, {0, 50}, 10));
    r.start(1);
    r.run(50);
}
void held(Commands& r) {
    runs(r);
    r.command(CommandKind::FeedHold, 1);
    r.run(200);
}

const std::map<CommandKind, Row>& rows() {
    using K = CommandKind;
    constexpr unsigned kNobody = 9;  // no process of that channel
    static const auto press = [](K kind, unsigned l = 1, double value = 1, std::uint32_t object = 0,
                                 std::uint32_t flags = 0, const char* text = "") {
        return [=](Commands& r) { r.command(kind, l, value, 0, object, flags, text); };
    };
    static const auto without_process = [](K kind, const char* text = "") {
        return Refused{"a channel without a process", {}, press(kind, kNobody, 1, 0, 0, text)};
    };
    static const char* const kSwitch = "a switch, that acts when something runs";
    static const char* const kOwn = "the supervisor's own, about what has happened";
    static const std::map<K, Row> all{
        {K::CycleStart,
         {{{"nothing selected", press(K::Select, 1, 0, 0, 0, ""), press(K::CycleStart)},
           without_process(K::CycleStart)}}},
        {K::FeedHold, {{}, "where nothing runs, nothing has to stop"}},
        {K::Reset, {{}, "always"}},
        {K::EmergencyStop, {{}, "always"}},
        {K::MachineOn,
         {{{"stop circuit open",
            [](Commands& r) {
                r.command(K::SetSignal, 0, 1, 0, signals::plc_estop(), 1);
                r.run(50);
            },
            press(K::MachineOn, 0)}}}},
        {K::ReleaseStop,
         {{{"stop circuit open",
            [](Commands& r) {
                r.command(K::SetSignal, 0, 1, 0, signals::plc_estop(), 1);
                r.run(50);
            },
            press(K::ReleaseStop, 0)}}}},
        {K::Mode,
         {{{"a program runs", runs, press(K::Mode, 1, static_cast<double>(ChannelMode::Jog))},
           {"a program is held", held, press(K::Mode, 1, static_cast<double>(ChannelMode::Mdi))},
           {"no such mode", {}, press(K::Mode, 1, 9)},
           without_process(K::Mode)}}},
        {K::Select, {{{"a program runs", runs, press(K::Select, 1, 0, 0, 0, "O2.nc")}}}},
        {K::Mdi,
         {{{"a program runs", runs, press(K::Mdi, 1, 0, 0, 0, "G0 X1")},
           {"automatic", {}, press(K::Mdi, 1, 0, 0, 0, "G0 X1")},
           without_process(K::Mdi, "G0 X1")}}},
        {K::MdiClear, {{without_process(K::MdiClear)}}},
        {K::HandKey,
         {{{"a program runs", runs, press(K::HandKey, 1, 1, 0, 0, "T1")},
           {"automatic", {}, press(K::HandKey, 1, 1, 0, 0, "T1")},
           without_process(K::HandKey, "T1")}}},
        {K::Jog,
         {{{"a program runs", runs, press(K::Jog, 0, 1, 1)},
           {"no axis", {}, press(K::Jog, 0, 1, 0)},
           {"an axis of nobody", {}, press(K::Jog, 0, 1, 20)}}}},
        {K::Step,
         {{{"a program runs", runs, press(K::Step, 0, 1, 1)},
           {"no axis", {}, press(K::Step, 0, 1, kMaxAxes + 1)},
           {"an axis of nobody", {}, press(K::Step, 0, 1, 20)}}}},
        {K::Handwheel,
         {{{"a program runs", runs, press(K::Handwheel, 0, 1, 1, 1)},
           {"of no program", {}, press(K::Handwheel, 1, 1)},
           {"neither axis nor channel", {}, press(K::Handwheel, 0, 1)},
           {"an axis of nobody", {}, press(K::Handwheel, 0, 1, 20, 1)}}}},
        {K::Reference,
         {{{"its program runs", runs, press(K::Reference, 0, 1, 2)},
           {"no drive", {}, press(K::Reference, 0, 1, 20)},
           {"no axis", {}, press(K::Reference, 0, 1, kMaxAxes + 1)}}}},
        {K::FeedOverride, {{{"no number", {}, press(K::FeedOverride, 1, std::nan(""))}}}},
        {K::RapidOverride, {{{"no number", {}, press(K::RapidOverride, 1, std::nan(""))}}}},
        {K::SpindleOverride,
         {{{"no spindle", {}, press(K::SpindleOverride, 0, 1, kMaxSpindles + 1)}}}},
        {K::SingleBlock, {{}, kSwitch}},
        {K::OptionalStop, {{}, kSwitch}},
        {K::BlockSkip, {{}, kSwitch}},
        {K::DryRun, {{}, kSwitch}},
        {K::MachineLock, {{}, kSwitch}},
        {K::FirstPart, {{}, kSwitch}},
        {K::RapidKey, {{}, kSwitch}},
        {K::IgnoreWaits, {{}, kSwitch}},
        {K::ProgramHandwheel, {{}, kSwitch}},
        {K::SetSignal, {{{"no slot", {}, press(K::SetSignal, 0, 1, kPlcSignals, 1)}}}},
        {K::ReleaseSignal, {{{"no slot", {}, press(K::ReleaseSignal, 0, 1, kNcSignals)}}}},
        {K::SetInput, {{{"no input", {}, press(K::SetInput, 0, 1, kInputs)}}}},
        {K::DriveFault,
         {{{"no axis", {}, press(K::DriveFault, 0, 1, kMaxAxes + 1)},
           {"no spindle", {}, press(K::DriveFault, 0, 1, 0, 1)}}}},
        {K::Sensor,
         {{{"no axis", {}, press(K::Sensor, 0, 1, 0)},
           {"no input", {}, press(K::Sensor, 0, 1, 1, kInputs)}}}},
        {K::Watch, {{{"no slot", {}, press(K::Watch, 0, 1, kNcSignals)}}}},
        {K::SetParameter, {{}, "answered by the store"}},
        {K::StoreValue, {{}, "answered by the store"}},
        {K::StopAfterPart, {{without_process(K::StopAfterPart)}}},
        {K::WarmUp, {{without_process(K::WarmUp)}}},
        {K::Superpose, {{without_process(K::Superpose)}}},
        {K::Retrace, {{{"not held", runs, press(K::Retrace)}, without_process(K::Retrace)}}},
        {K::Restart,
         {{{"a program runs", runs, press(K::Restart, 1, 10, 0, 1)},
           {"a channel without a process",
            {},
            press(K::Restart, kNobody, 10, 0, 3u | 1u << (kNobody - 1))}}}},
        {K::JogInHold, {{{"not held", runs, press(K::JogInHold)}, without_process(K::JogInHold)}}},
        {K::Return,
         {{{"nothing was moved", held, press(K::Return)},
           {"no channel", {}, press(K::Return, 0)}}}},
        {K::DialogueValue,
         {{{"no dialogue", runs, press(K::DialogueValue, 1, 1, 0, 0, "A")},
           without_process(K::DialogueValue)}}},
        {K::DialogueKey,
         {{{"no dialogue", runs, press(K::DialogueKey)}, without_process(K::DialogueKey)}}},
        {K::Scope, {{{"no such kind", {}, press(K::Scope, 0, 99)}}}},
        {K::Action, {{}, kOwn}},
        {K::ProcessDied, {{}, kOwn}},
        {K::ProcessStopped, {{}, kOwn}},
        {K::ProcessContinued, {{}, kOwn}},
        {K::EndRun, {{}, "always"}},
    };
    return all;
}

TEST(Commands, WhatIsRefusedIsSaid) {
    for (const auto& [kind, row] : rows())
        for (const Refused& refused : row.refused) {
            SCOPED_TRACE(std::to_string(static_cast<int>(kind)) + ", " + refused.where);
            Commands rig;
            rig.run(5);
            if (refused.prepare) {
                refused.prepare(rig);
                rig.run(5);
            }
            const std::size_t before = rig.said();
            refused.press(rig);
            rig.run(5);
            EXPECT_EQ(rig.said(), before + 1);
        }
}

// HandKey is the last one of the list.
TEST(Commands, EachKindHasItsRow) {
    for (std::uint32_t kind = 1; kind <= static_cast<std::uint32_t>(CommandKind::HandKey); ++kind) {
        const auto row = rows().find(static_cast<CommandKind>(kind));
        ASSERT_NE(row, rows().end()) << kind;
        EXPECT_TRUE(row->second.refused.empty() == (row->second.never != nullptr)) << kind;
    }
}

TEST(Commands, TheModeThatHoldsAlreadyIsNoRefusal) {
    Commands rig;
    runs(rig);
    const std::size_t before = rig.said();
    rig.command(CommandKind::Mode, 1, static_cast<double>(ChannelMode::Auto));
    rig.run(5);
    EXPECT_EQ(rig.said(), before);
    // Behind a reset of the same tick it is obeyed.
    rig.command(CommandKind::FeedHold, 1);
    rig.run(300);
    rig.command(CommandKind::Reset, 1);
    rig.command(CommandKind::Mode, 1, static_cast<double>(ChannelMode::Jog));
    rig.run(5);
    EXPECT_EQ(rig.said(), before);
    EXPECT_EQ(rig.machine->channel(0).mode(), ChannelMode::Jog);
}

}  // namespace
}  // namespace polyturn::kernel
