// Blocks by hand: entering one moves nothing, a start takes it; keys that are a start by their
// label; who changes the mode.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

struct ByHand : TickRig {
    using TickRig::TickRig;
    void mode(ChannelMode m, unsigned l = 1) {
        command(CommandKind::Mode, l, static_cast<double>(m));
    }
    void enter(std::string_view text, unsigned l = 1) {
        command(CommandKind::Mdi, l, 1, 0, 0, 0, text);
    }
    void key(std::string_view text, unsigned l = 1) {
        command(CommandKind::HandKey, l, 1, 0, 0, 0, text);
    }
    ChannelMode mode_of(unsigned l = 1) { return machine->channel(l - 1).mode(); }
    ChannelStatus told(unsigned l = 1) const {
        const auto status = std::make_unique<MachineStatus>();
        EXPECT_TRUE(kernel->status.read(*status));
        return status->channels[l - 1];
    }
    MdiList list(unsigned l = 1) const {
        MdiList out{};
        EXPECT_TRUE(kernel->mdi[l - 1].read(out));
        return out;
    }
    // "G0 X1=done G0 X2=entered"
    std::string shown(unsigned l = 1) const {
        static constexpr const char* kStates[] = {"entered", "runs", "done", "broken"};
        std::string out;
        const MdiList its = list(l);
        for (std::uint32_t i = 0; i < its.count; ++i)
            out += (i ? "; " : "") + std::string(its.lines[i].text.data()) + "=" +
                   kStates[its.lines[i].state];
        return out;
    }
    std::vector<std::string> started(unsigned l = 1) const {
        std::vector<std::string> out;
        for (const ChannelEvent& e : heard[l - 1])
            // without a text: the selected program
            if (e.text[0] != 0 &&
                (e.kind == static_cast<std::uint32_t>(ChannelEventKind::CycleStart) ||
                 e.kind == static_cast<std::uint32_t>(ChannelEventKind::HeldMdi)))
                out.emplace_back(e.text.data());
        return out;
    }
    // What the channel pushes for a block: a move, and the end of what it has read.
    void block(double x) {
        push(1, line(1, {x, 0}, 50, kExactStop));
        push(1, stop(1, StopReason::End));
    }
    int alarms() const {
        int n = 0;
        for (const KernelEvent& e : log)
            n += e.kind == static_cast<std::uint32_t>(KernelEventKind::Alarm);
        return n;
    }
};
using Texts = std::vector<std::string>;

// H2: `G0 X120.` and Enter drove the axes, out of automatic mode.
TEST(Mdi, EnteringMovesNothingAndChangesNoMode) {
    ByHand rig;
    rig.mode(ChannelMode::Mdi);
    rig.enter("G0 X120.");
    rig.block(10);
    rig.run(500);
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
    EXPECT_EQ(rig.position(1), 0);
    EXPECT_EQ(rig.shown(), "G0 X120.=entered");
    EXPECT_EQ(rig.told().mdi_waiting, 1u);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.started(), Texts{"G0 X120."});
    EXPECT_NEAR(rig.position(1), 10, 1e-9);
    EXPECT_EQ(rig.shown(), "G0 X120.=done");
    EXPECT_EQ(rig.alarms(), 0);
}

TEST(Mdi, IsRefusedInEachOtherMode) {
    for (const ChannelMode mode :
         {ChannelMode::Auto, ChannelMode::Jog, ChannelMode::Handwheel, ChannelMode::Reference}) {
        ByHand rig;
        rig.mode(mode);
        rig.enter("G0 X120.");
        rig.block(10);
        rig.run(200);
        EXPECT_TRUE(rig.alarmed(Alarm::MdiRefused, 1)) << static_cast<int>(mode);
        EXPECT_EQ(rig.mode_of(), mode);
        EXPECT_EQ(rig.state(1), ChannelState::Reset);
        EXPECT_EQ(rig.list().count, 0u);
        EXPECT_EQ(rig.position(1), 0);
    }
}

// `G0 X120.G97 S500 M3` ran: the second block had been appended to the first.
TEST(Mdi, EachBlockIsALineOfItsOwnAndNoneRunsTwice) {
    ByHand rig;
    rig.mode(ChannelMode::Mdi);
    rig.enter("G0 X120.");
    rig.start(1);
    rig.run(2);
    rig.block(10);
    rig.run_until_idle();
    rig.enter("G97 S500 M3");
    rig.run(5);
    EXPECT_EQ(rig.shown(), "G0 X120.=done; G97 S500 M3=entered");
    rig.start(1);
    rig.run(2);
    rig.block(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.started(), (Texts{"G0 X120.", "G97 S500 M3"}));
    rig.start(1);
    rig.run(50);
    EXPECT_EQ(rig.started().size(), 2u) << "what has run does not run again";
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
}

TEST(Mdi, OneStartTakesWhatWasEnteredBeforeItLineByLine) {
    ByHand rig;
    rig.mode(ChannelMode::Mdi);
    for (const char* text : {"A", "B", "C"}) rig.enter(text);
    rig.start(1);
    rig.run(3);
    EXPECT_EQ(rig.shown(), "A=runs; B=entered; C=entered");
    EXPECT_EQ(rig.told().by_hand, 1u);
    rig.enter("D");  // after the start: it waits for the next one
    rig.block(5);
    rig.run_until_idle();
    EXPECT_EQ(rig.shown(), "A=done; B=runs; C=entered; D=entered");
    rig.block(5);
    rig.run_until_idle();
    rig.block(5);
    rig.run_until_idle();
    EXPECT_EQ(rig.shown(), "A=done; B=done; C=done; D=entered");
    rig.run(500);
    EXPECT_EQ(rig.started(), (Texts{"A", "B", "C"}));
    EXPECT_NEAR(rig.position(1), 15, 1e-9);
    EXPECT_EQ(rig.told().by_hand, 0u);
}

TEST(Mdi, InSingleBlockEachLineHasAStartOfItsOwn) {
    ByHand rig;
    rig.mode(ChannelMode::Mdi);
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.enter("A");
    rig.enter("B");
    for (const char* after : {"A=done; B=entered", "A=done; B=done"}) {
        rig.start(1);
        rig.run(3);
        rig.block(5);
        rig.run_until_idle();
        // behind the block, before its end
        if (rig.state(1) == ChannelState::ProgramStop) {
            rig.start(1);
            rig.run_until_idle();
        }
        rig.run(300);
        EXPECT_EQ(rig.shown(), after);
    }
    EXPECT_NEAR(rig.position(1), 10, 1e-9);
}

// What was to come before the other lines has not happened.
TEST(Mdi, AResetTakesBackWhatHasNotRun) {
    ByHand rig;
    rig.mode(ChannelMode::Mdi);
    rig.enter("A");
    rig.enter("B");
    rig.start(1);
    rig.run(3);
    rig.block(20);
    rig.run(100);
    rig.command(CommandKind::Reset, 1);
    rig.run_until_idle();
    EXPECT_EQ(rig.shown(), "A=broken");
    rig.start(1);
    rig.run(50);
    EXPECT_EQ(rig.started(), Texts{"A"});
}

TEST(Mdi, AFeedHoldOrALostMachineBetweenTwoLinesEndsTheRun) {
    for (const bool hold : {true, false}) {
        ByHand rig;
        rig.mode(ChannelMode::Mdi);
        rig.enter("A");
        rig.enter("B");
        rig.start(1);
        rig.run(3);
        rig.channel[0]->quiet.store(0);  // it is still busy with the end of A
        rig.block(5);
        for (int i = 0; i < 2000 && rig.state(1) != ChannelState::Ended; ++i) rig.tick();
        ASSERT_EQ(rig.state(1), ChannelState::Ended);
        rig.command(hold ? CommandKind::FeedHold : CommandKind::EmergencyStop, 1);
        rig.run(3);
        rig.channel[0]->quiet.store(1'000'000);
        rig.run(100);
        EXPECT_EQ(rig.started(), Texts{"A"});
    }
}

TEST(Mdi, TheListHoldsSixteenAndForgetsWhatHasRun) {
    ByHand rig;
    rig.mode(ChannelMode::Mdi);
    for (std::size_t i = 0; i < kMdiLines; ++i) rig.enter("L" + std::to_string(i));
    rig.run(2);
    EXPECT_EQ(rig.list().count, kMdiLines);
    EXPECT_FALSE(rig.alarmed(Alarm::MdiRefused));
    rig.enter("one too many");
    rig.run(2);
    EXPECT_TRUE(rig.alarmed(Alarm::MdiRefused, 1));
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.start(1);
    rig.run(3);
    rig.push(1, rig.stop(1, StopReason::End));
    rig.run_until_idle();
    rig.enter("room again");
    rig.run(2);
    EXPECT_EQ(std::string(rig.list().lines[0].text.data()), "L1");
    EXPECT_EQ(std::string(rig.list().lines[kMdiLines - 1].text.data()), "room again");
}

TEST(Mdi, IsClearedByItsKeyAndByAnotherMode) {
    for (const bool key : {true, false}) {
        ByHand rig;
        rig.mode(ChannelMode::Mdi);
        rig.enter("A");
        if (key)
            rig.command(CommandKind::MdiClear, 1);
        else {
            rig.mode(ChannelMode::Auto);
            rig.mode(ChannelMode::Mdi);
        }
        rig.run(2);
        EXPECT_EQ(rig.list().count, 0u);
        rig.start(1);
        rig.run(10);
        EXPECT_TRUE(rig.started().empty());
        EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
    }
}

// An M99 of MDI said «the wanted parts are made: 1/1».
TEST(Mdi, ABlockByHandMakesNoPart) {
    ByHand rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n2308_no_of_parts_reqrd, 1, 1);
    });
    rig.mode(ChannelMode::Mdi);
    rig.enter("M99");
    rig.start(1);
    rig.run(3);
    rig.push(1, rig.blank(1, RecordKind::Part));
    rig.push(1, rig.stop(1, StopReason::End));
    rig.run_until_idle();
    EXPECT_EQ(rig.told().parts, 0u);
    EXPECT_EQ(rig.told().cycles, 0u);
    EXPECT_FALSE(rig.alarmed(Alarm::PartsDone));
    EXPECT_EQ(rig.machine->core().totals.machined(0), 0);
}

// A scenario's «mdi» must not end a feed hold of a program that runs.
TEST(Mdi, AStartByHandStartsNothingElse) {
    for (const bool runs : {true, false}) {
        ByHand rig;
        if (runs) {
            rig.push(1, rig.line(1, {50, 0}, 50));
            rig.start(1);
            rig.run(100);
            rig.command(CommandKind::FeedHold, 1);
        }
        rig.command(CommandKind::CycleStart, 1, 1, 0, 0, kStartByHand);
        rig.run(300);
        EXPECT_EQ(rig.state(1), runs ? ChannelState::Held : ChannelState::Reset);
        EXPECT_TRUE(rig.started().empty());
    }
}

// --- keys that are a start by their label ---

TEST(HandKeys, RunOneBlockAtOnceWithoutTheList) {
    for (const ChannelMode mode : {ChannelMode::Mdi, ChannelMode::Jog, ChannelMode::Handwheel}) {
        ByHand rig;
        rig.mode(mode);
        if (mode == ChannelMode::Mdi) rig.enter("G0 X5");
        rig.key("T0101");
        rig.run(3);
        EXPECT_EQ(rig.told().by_hand, 1u);
        rig.block(3);
        rig.run_until_idle();
        EXPECT_EQ(rig.started(), Texts{"T0101"}) << static_cast<int>(mode);
        EXPECT_EQ(rig.mode_of(), mode);
        EXPECT_EQ(rig.told().by_hand, 0u);
        if (mode == ChannelMode::Mdi) {
            EXPECT_EQ(rig.shown(), "G0 X5=entered") << "the line waits for its own start";
        }
        rig.run(200);
        EXPECT_NEAR(rig.position(1), 3, 1e-9);
    }
}

TEST(HandKeys, AreRefusedAsAStartIs) {
    struct Case {
        const char* what;
        std::function<void(ByHand&)> bring;
        Alarm says;
    };
    const Case cases[] = {
        {"automatic", [](ByHand& r) { r.mode(ChannelMode::Auto); }, Alarm::MdiRefused},
        {"door",
         [](ByHand& r) { r.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_dooropen(1), 1); },
         Alarm::NotReady},
        {"emergency stop", [](ByHand& r) { r.command(CommandKind::EmergencyStop); },
         Alarm::NotReady},
        {"chuck",
         [](ByHand& r) { r.command(CommandKind::SetSignal, 0, 1, 0, signals::sp_unclamped(1), 1); },
         Alarm::NotReady},
        {"axis moved by hand",
         [](ByHand& r) {
             r.command(CommandKind::Jog, 0, 1, 0, 1);
             r.run(3);
         },
         Alarm::NotReady},
    };
    for (const Case& one : cases) {
        ByHand rig;
        rig.mode(ChannelMode::Jog);
        one.bring(rig);
        rig.run(2);
        const int before = rig.alarms();
        rig.key("T0101");
        rig.run(20);
        EXPECT_TRUE(rig.started().empty()) << one.what;
        EXPECT_TRUE(rig.alarmed(one.says, 1)) << one.what;
        EXPECT_GT(rig.alarms(), before) << one.what;
    }
}

// --- a block by hand in a hold ---

struct Held : ByHand {
    Held() {
        push(1, numbered(line(1, {10, 0}, 50, kExactStop), 1));
        push(1, numbered(line(1, {20, 0}, 50, kExactStop), 2));
        push(1, numbered(stop(1, StopReason::M30), 3));
        start(1);
        run(450);
        command(CommandKind::FeedHold, 1);
        run(150);
        EXPECT_EQ(state(1), ChannelState::Held);
    }
    PathRecord numbered(PathRecord r, std::uint64_t serial) {
        r.serial = serial;
        r.part = 1;
        return r;
    }
    bool asked() const {
        for (const ChannelEvent& e : heard[0])
            if (e.kind == static_cast<std::uint32_t>(ChannelEventKind::AskResume)) return true;
        return false;
    }
};

TEST(MdiInAHold, WaitsForAStartAndIsTakenBackByItsKey) {
    Held rig;
    rig.enter("G0 Z5");
    rig.run(50);
    EXPECT_EQ(rig.shown(), "G0 Z5=entered");
    EXPECT_EQ(rig.mode_of(), ChannelMode::Auto);
    EXPECT_FALSE(rig.asked());
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    rig.command(CommandKind::MdiClear, 1);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended) << "the program goes on";
    EXPECT_EQ(rig.started().size(), 0u);
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
}

TEST(MdiInAHold, AFeedHoldBeforeTheAnswerTakesTheStartBack) {
    Held rig;
    rig.enter("G0 Z5");
    rig.start(1);
    rig.run(2);
    ASSERT_TRUE(rig.asked());
    rig.command(CommandKind::FeedHold, 1);
    rig.run(2);
    rig.channel[0]->answer.store(static_cast<std::uint32_t>(ResumeAnswer::GoesBack));
    rig.channel[0]->answered.store(rig.heard[0].back().seq);
    rig.run(50);
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    EXPECT_TRUE(rig.started().empty());
    EXPECT_EQ(rig.shown(), "G0 Z5=entered");
}

TEST(MdiInAHold, IsRefusedWhereNoBlockByHandCanRun) {
    Held rig;
    rig.command(CommandKind::JogInHold, 1);
    rig.enter("G0 Z5");
    rig.run(3);
    EXPECT_TRUE(rig.alarmed(Alarm::MdiRefused, 1));
    EXPECT_EQ(rig.list().count, 0u);
}

// --- the mode is the operator's ---

TEST(Modes, ARestartInMdiIsRefusedAndLeavesTheMode) {
    ByHand rig;
    rig.mode(ChannelMode::Mdi);
    rig.command(CommandKind::Restart, 1, 120, 0, 0, 1);
    rig.run(5);
    EXPECT_EQ(rig.mode_of(), ChannelMode::Mdi);
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
}

TEST(Modes, AStartFromAnotherProgramLeavesTheModeAndIsRefused) {
    ByHand rig;
    rig.mode(ChannelMode::Mdi, 2);
    rig.enter("G0 X5", 2);
    rig.run(2);
    rig.machine->core().program_calls[1].started = true;
    rig.run(5);
    EXPECT_EQ(rig.mode_of(2), ChannelMode::Mdi);
    EXPECT_EQ(rig.state(2), ChannelState::Reset);
    EXPECT_TRUE(rig.started(2).empty());
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 2));
    EXPECT_EQ(rig.shown(2), "G0 X5=entered");
}

// --- what is refused is not kept (docs/design/motion-starts.md) ---

TEST(MotionStarts, AReturnThatWasPressedInAnEmergencyStopIsNotMadeAfterIt) {
    Held rig;
    rig.command(CommandKind::JogInHold, 1);
    rig.command(CommandKind::Step, 0, 5, 0, 1);
    rig.run(1500);
    rig.command(CommandKind::EmergencyStop);
    rig.run(500);
    const double at = rig.position(1);
    rig.command(CommandKind::Return, 1);
    rig.run(20);
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
    rig.command(CommandKind::ReleaseStop);
    rig.run(20);
    rig.command(CommandKind::MachineOn);
    rig.run(2000);
    ASSERT_TRUE(rig.machine->core().on());
    EXPECT_NEAR(rig.position(1), at, 1e-3);  // where the drive has stood when its loop closed
}

TEST(MotionStarts, NoReferenceRunBehindAnOpenDoor) {
    ByHand rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n0900_reference_type, 1, 1);
        params::put(t, params::n0302_ref_rapid, 3000, 1);
        params::put(t, params::n0303_ref_feed, 240, 1);
        params::put(t, params::n0901_reference_distance, -200, 1);
    });
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_dooropen(1), 1);
    rig.run(5);
    rig.command(CommandKind::Reference, 0, 1, 0, 1);
    rig.run(500);
    EXPECT_EQ(rig.position(1), 0);
    EXPECT_TRUE(rig.alarmed(Alarm::ReferenceRefused, 1));
}

}  // namespace
}  // namespace polyturn::kernel
