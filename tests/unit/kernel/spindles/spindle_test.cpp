#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

TEST(Spindle, FollowsItsRampAndSaysWhenItIsThere) {
    TickRig rig;
    rig.push(1, rig.spindle(1, 1500));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.start(1);
    rig.run(100);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_ns(1)), 0);
    rig.run(400);  // ramp of 1500 1/min in a second: about half way
    EXPECT_NEAR(rig.machine->core().spindles[0].speed(), 1500 * 0.46, 60);
    rig.run(700);
    EXPECT_NEAR(rig.machine->core().spindles[0].speed(), 1500, 2);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_ns(1)), 1);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_n0(1)), 0);
}

TEST(Spindle, TurnsTheOtherWayWithM4AndKeepsItsLimits) {
    TickRig rig;
    rig.push(1, rig.spindle(1, 9000));
    rig.push(1, rig.aux(1, 'M', 4));
    rig.start(1);
    rig.run(4000);
    EXPECT_NEAR(rig.machine->core().spindles[0].speed(), -4000, 5);
    rig.command(CommandKind::SpindleOverride, 0, 0.5, 0, 1);
    rig.run(10);
    // 9000 x 0.5 is still above the range
    EXPECT_EQ(rig.machine->core().spindles[0].command(), -4000);
}

TEST(Spindle, KeepsTheSurfaceSpeedWithinItsLimit) {
    TickRig rig([](params::Table&, RunOptions& o) {
        o.start_known[0] = 1;
        o.start_position[0] = 50;
    });
    PathRecord css = rig.blank(1, RecordKind::SpindleMode);
    css.spindle = 1;
    css.code = static_cast<std::int32_t>(SpindleModeCode::SurfaceSpeed);
    css.value = 150;      // m/min
    css.shape[0] = 1200;  // limit
    css.shape[1] = 0;
    css.axis[0] = 0;
    rig.push(1, css);
    rig.push(1, rig.aux(1, 'M', 3));
    rig.start(1);
    rig.run(1500);
    EXPECT_NEAR(rig.machine->core().spindles[0].command(), 1000 * 150 / (3.14159265 * 100), 0.1);
    PathRecord in = rig.line(1, {-50, 0}, 50);
    in.start[0] = 50;
    in.end[0] = 0;
    rig.push(1, in);
    rig.run(2500);
    EXPECT_NEAR(rig.machine->core().spindles[0].command(), 1200, 1e-9);
}

// sinumerik_part1 7.3: rapid moves change no speed; the one right in front of a cut brings the
// speed for it.
TEST(Spindle, KeepsItsSurfaceSpeedInRapidMovesOfSinumerik) {
    TickRig rig([](params::Table& t, RunOptions& o) {
        params::put_text(t, params::pt_language, "sinumerik", 1);
        o.start_known[0] = 1;
        o.start_position[0] = 50;
    });
    rig.place(1, 0, 50);
    PathRecord css = rig.blank(1, RecordKind::SpindleMode);
    css.spindle = 1;
    css.code = static_cast<std::int32_t>(SpindleModeCode::SurfaceSpeed);
    css.value = 150;
    css.axis[0] = 0;
    rig.push(1, css);
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.dwell(1, 1.5));
    rig.push(1, rig.line(1, {-20, 0}, 0, kRapid | kInPosition));
    rig.push(1, rig.line(1, {0, -20}, 0, kRapid));
    rig.start(1);
    const auto rpm = [](double radius) { return 1000 * 150 / (2 * 3.14159265 * radius); };
    double most = 0, least = 1e9;
    rig.on_tick = [&] {
        if (rig.speed_of(1) == 0 && rig.speed_of(2) == 0) return;
        most = std::max(most, rig.machine->core().spindles[0].command());
        least = std::min(least, rig.machine->core().spindles[0].command());
    };
    rig.run_until_idle();
    EXPECT_NEAR(least, rpm(50), 0.1);
    EXPECT_NEAR(most, rpm(50), 0.1) << "the first rapid move ends at a radius of 30";
    most = 0;
    least = 1e9;
    rig.push(1, rig.line(1, {-10, 0}, 0, kRapid));
    rig.push(1, rig.line(1, {0, 10}, 50));
    rig.run(20);
    EXPECT_NEAR(rig.machine->core().spindles[0].command(), rpm(20), 0.1)
        << "the cut begins at a radius of 20";
    rig.run_until_idle();
    EXPECT_NEAR(most, rpm(20), 0.1);
}

TEST(Spindle, IsOwnedByTheChannelThatNeedsItsSurfaceSpeed) {
    TickRig rig;
    PathRecord css = rig.blank(1, RecordKind::SpindleMode);
    css.spindle = 1;
    css.code = static_cast<std::int32_t>(SpindleModeCode::SurfaceSpeed);
    css.value = 150;
    rig.push(1, css);
    rig.start(1);
    rig.run(5);
    rig.push(2, rig.spindle(2, 500));
    rig.start(2);
    rig.run(10);
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleOwned, 2));
    EXPECT_EQ(rig.state(2), ChannelState::Interrupted);
}

TEST(Spindle, StandingAtFeedPerRevolutionIsAnAlarmAndNoHang) {
    TickRig rig;
    PathRecord cut = rig.line(1, {0, -10}, 0.2);
    cut.feed_mode = static_cast<std::uint8_t>(FeedMode::PerRevolution);
    rig.push(1, cut);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleStands, 1));
    EXPECT_EQ(rig.state(1), ChannelState::Interrupted);
    EXPECT_EQ(rig.position(2), 0);
}

// Its measured speed ends in a filter's tail, never at 0.
// The PLC has detached it (SP_SDETCHR): it will never turn, and nobody may wait for it without a
// word.
TEST(Spindle, ThatIsDetachedIsAnAlarmForWhoeverWaitsForIt) {
    struct Row {
        const char* what;
        PathRecord (*record)(TickRig&);
    };
    const Row rows[] = {
        {"a cut in mm/min",
         [](TickRig& rig) {
             return rig.line(1, {10, 0}, 20);
         }},
        {"a cut in mm/rev",
         [](TickRig& rig) {
             PathRecord r = rig.line(1, {10, 0}, 0.2);
             r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerRevolution);
             return r;
         }},
        {"a dwell in turns",
         [](TickRig& rig) {
             PathRecord r = rig.dwell(1, 3);
             r.feed_mode = static_cast<std::uint8_t>(FeedMode::Revolutions);
             r.spindle = 1;
             return r;
         }},
        {"a thread",
         [](TickRig& rig) {
             PathRecord r = rig.line(1, {0, -20}, 0, kThread | kThreadEnd);
             r.lead = 1;
             return r;
         }},
    };
    for (const Row& row : rows)
        for (const bool turned : {false, true}) {
            SCOPED_TRACE(testing::Message() << row.what << (turned ? ", it had turned" : ""));
            TickRig rig;
            rig.push(1, rig.spindle(1, 1000));
            rig.push(1, rig.aux(1, 'M', 3));
            rig.push(1, rig.dwell(1, 3));
            rig.push(1, row.record(rig));
            rig.push(1, rig.stop(1, StopReason::M30));
            if (!turned) rig.command(CommandKind::SetSignal, 0, 1, 0, signals::sp_sdetchr(1), 1);
            rig.start(1);
            if (turned) {
                rig.run(2900);
                rig.command(CommandKind::SetSignal, 0, 1, 0, signals::sp_sdetchr(1), 1);
            }
            rig.run_until_idle(60'000);
            EXPECT_TRUE(rig.alarmed(Alarm::SpindleDetached, 1));
            EXPECT_EQ(rig.state(1), ChannelState::Interrupted);
        }
}

// One that the PLC has let go while nobody needs it keeps nobody.
TEST(Spindle, ThatIsDetachedKeepsNoRapidMoveAndNoProgramThatDoesNotNeedIt) {
    TickRig rig;
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::sp_sdetchr(1), 1);
    rig.push(1, rig.line(1, {10, 0}, 0, kRapid));
    rig.push(1, rig.line(1, {10, 0}, 20));  // no M3: it is meant to stand
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_FALSE(rig.alarmed(Alarm::SpindleDetached));
}

TEST(Spindle, ThatHasBeenStoppedFeedsNothingEither) {
    TickRig rig;
    rig.push(1, rig.spindle(1, 600));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.line(1, {0, -2}, 10));
    rig.push(1, rig.aux(1, 'M', 5));
    rig.push(1, rig.line(1, {0, -4}, 2));
    rig.push(1, rig.aux(1, 'M', 9));  // the path rests
    PathRecord cut = rig.line(1, {0, -10}, 0.2);
    cut.feed_mode = static_cast<std::uint8_t>(FeedMode::PerRevolution);
    rig.push(1, cut);
    rig.start(1);
    rig.run(20'000);
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleStands, 1));
    EXPECT_EQ(rig.state(1), ChannelState::Interrupted);
    EXPECT_EQ(rig.position(2), -6);
}

TEST(Spindle, ThatIsJustStartedIsWaitedForHoweverLongTheMachineWasOn) {
    TickRig rig;
    rig.run(500);
    rig.push(1, rig.spindle(1, 600));
    rig.push(1, rig.aux(1, 'M', 3));
    PathRecord cut = rig.line(1, {0, -2}, 0.5);
    cut.feed_mode = static_cast<std::uint8_t>(FeedMode::PerRevolution);
    rig.push(1, cut);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_FALSE(rig.alarmed(Alarm::SpindleStands, 1));
    EXPECT_NEAR(rig.position(2), -2.0, 1e-3);
}

TEST(Spindle, SetsThePaceOfFeedPerRevolution) {
    TickRig rig;
    rig.push(1, rig.spindle(1, 600));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.dwell(1, 1.0));
    PathRecord cut = rig.line(1, {0, -20}, 0.5);
    cut.feed_mode = static_cast<std::uint8_t>(FeedMode::PerRevolution);
    rig.push(1, cut);
    rig.start(1);
    rig.run(3000);
    EXPECT_NEAR(rig.speed_of(2), -5.0, 0.05);
}

// nct_parameters_part1 8.1, N0604: «at such a reference» its number goes to CN_SSEL. Before, none
// is selected.
TEST(SelectedSpindle, IsThatOfN0604FromTheFirstPlainSOrSpindleCodeOn) {
    for (const bool by_code : {false, true}) {
        TickRig rig;
        const auto selected = [&](unsigned l) {
            return rig.machine->core().signals.nc(signals::cn_ssel(l));
        };
        rig.run(30);
        EXPECT_EQ(selected(1), 0);
        rig.push(1, rig.aux(1, 'M', 8));
        rig.push(1, rig.dwell(1, 0.1));
        rig.push(1, by_code ? rig.aux(1, 'M', 3) : rig.spindle(1, 500));
        rig.push(1, rig.dwell(1, 0.1));
        rig.start(1);
        rig.run(80);
        EXPECT_EQ(selected(1), 0) << "M8 means no spindle";
        rig.run_until_idle();
        EXPECT_EQ(selected(1), 1);
        EXPECT_EQ(selected(2), 0) << "its program has not said so";
    }
}

}  // namespace
}  // namespace polyturn::kernel
