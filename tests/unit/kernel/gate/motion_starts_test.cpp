// Walks the table of doors through which motion can begin: shut, nothing moves, it is said, and
// nothing is kept; open, it moves.
#include <fstream>
#include <set>
#include <sstream>
#include <type_traits>

#include "kernel/gate/motion_gate.hpp"
#include "tests/places.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

using Adjust = std::function<void(params::Table&)>;
struct Doors : TickRig {
    explicit Doors(const Adjust& adjust = {})
        : TickRig([&](params::Table& t, RunOptions&) {
              // A4: by a switch; the others stand where they are
              params::put(t, params::n0900_reference_type, 1, 4);
              params::put(t, params::n0302_ref_rapid, 3000, 4);
              params::put(t, params::n0303_ref_feed, 240, 4);
              params::put(t, params::n0901_reference_distance, -200, 4);
              params::put(t, params::pt_retract, 5, 2);
              // an axis with an address must be attached
              for (unsigned a = 1; a <= 4; ++a)
                  params::put(t, params::n0100_axis_name1, a % 2 ? 'X' : 'Z', a);
              if (adjust) adjust(t);
          }) {
        on_tick = [this] {  // what the kernel has commanded: a loop that closes is no way
            const Core& core = machine->core();
            for (unsigned a = 0; a < 4; ++a) {
                way[a] += std::fabs(core.axes[a].velocity()) * core.config.tick_s;
                way[4 + a] = core.axes[a].overlay();
            }
            way[8] += std::fabs(core.spindles[0].command()) / 60.0 * core.config.tick_s;
        };
    }
    void mode(ChannelMode m, unsigned l = 1) {
        command(CommandKind::Mode, l, static_cast<double>(m));
    }
    void set(std::uint32_t slot, double value) {
        command(CommandKind::SetSignal, 0, value, 0, slot, 1);
    }
    PathRecord numbered(PathRecord r, std::uint64_t serial) {
        r.serial = serial;
        r.part = 1;
        return r;
    }
    void held() {
        push(1, numbered(line(1, {10, 0}, 50, kExactStop), 1));
        push(1, numbered(line(1, {20, 0}, 50, kExactStop), 2));
        push(1, numbered(stop(1, StopReason::M30), 3));
        start(1);
        run(450);
        command(CommandKind::FeedHold, 1);
        run(150);
        EXPECT_EQ(state(1), ChannelState::Held);
    }
    // The channel's answer to AskResume, and what it pushes for the block by hand.
    SpindleCouplings::Refusal couple(const SpindleCouplings::Wish& wish) {
        return machine->core().spindle_couplings->couple(machine->core(), wish);
    }
    void answer_for_block() {
        for (const ChannelEvent& e : heard[0])
            if (e.kind == static_cast<std::uint32_t>(ChannelEventKind::AskResume)) {
                channel[0]->answer.store(static_cast<std::uint32_t>(ResumeAnswer::GoesBack));
                channel[0]->answered.store(e.seq);
                run(3);
                channel[0]->epoch.store(1);
                PathRecord move = line(1, {0, 5}, 50, kExactStop);
                move.start[0] = move.end[0] = position(1);
                push(1, move);
                push(1, stop(1, StopReason::End));
                return;
            }
    }
    using Ways = std::array<double, 9>;  // axes; superposed wheels; revolutions of S1
    Ways way{};
    int refusals(Alarm which) const {
        int n = 0;
        for (const KernelEvent& e : log)
            n += e.code == static_cast<int>(which) &&
                 e.kind == static_cast<std::uint32_t>(KernelEventKind::Alarm);
        return n;
    }
};

double farthest(const Doors::Ways& a, const Doors::Ways& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::fmax(most, std::fabs(a[i] - b[i]));
    return most;
}
constexpr double kStands = 1e-3;  // mm

struct Walk {
    Door door;
    std::function<void(Doors&)> prepare;
    std::function<void(Doors&)> ask;
    // Besides the grounds of its row: states in which it is shut, brought about behind `prepare`.
    std::vector<std::pair<const char*, std::function<void(Doors&)>>> shut = {};
    bool program_moves = false;  // meanwhile: only what is added to it counts
    Adjust adjust = {};
    // Of a level: it asks as long as it stands, and is taken back before the ground comes back.
    std::function<void(Doors&)> take_back = {};
    // What is without this ground has lost its program: nobody asks any more, and what has ended
    // that was said.
    std::uint8_t over_without = 0;
};

const std::vector<Walk>& walks() {
    static const auto mode = [](ChannelMode m) {
        return [m](Doors& r) {
            r.mode(m);
            r.run(2);
        };
    };
    static const auto push_move = [](Doors& r) {
        r.push(1, r.line(1, {20, 0}, 50));
        r.push(1, r.stop(1, StopReason::End));
    };
    static const std::vector<Walk> all{
        {Door::Start,
         push_move,
         [](Doors& r) { r.start(1); },
         {{"jog", mode(ChannelMode::Jog)},
          {"MDI without a block", mode(ChannelMode::Mdi)},
          {"no program",
           [](Doors& r) {
               r.command(CommandKind::Select, 1);
               r.run(2);
           }}}},
        {Door::GoOn,
         [](Doors& r) { r.held(); },
         [](Doors& r) { r.start(1); },
         {{"axes away",
           [](Doors& r) {
               r.command(CommandKind::JogInHold, 1);
               r.run(2);
           }}}},
        {Door::EnteredLine,
         [](Doors& r) {
             r.mode(ChannelMode::Mdi);
             push_move(r);
             r.command(CommandKind::Mdi, 1, 1, 0, 0, 0, "G0 X20");
             r.run(2);
         },
         [](Doors& r) { r.start(1); },
         {{"taken back",
           [](Doors& r) {
               r.command(CommandKind::MdiClear, 1);
               r.run(2);
           }},
          {"another mode", mode(ChannelMode::Jog)}}},
        {Door::LineInHold,
         [](Doors& r) {
             r.held();
             r.command(CommandKind::Mdi, 1, 1, 0, 0, 0, "G0 Z5");
             r.run(2);
         },
         [](Doors& r) {
             r.start(1);
             r.run(3);
             r.answer_for_block();
         },
         {{"axes away",
           [](Doors& r) {
               r.command(CommandKind::JogInHold, 1);
               r.run(2);
           }}}},
        {Door::HandKey,
         [](Doors& r) {
             r.mode(ChannelMode::Jog);
             push_move(r);
             r.run(2);
         },
         [](Doors& r) { r.command(CommandKind::HandKey, 1, 1, 0, 0, 0, "T0101"); },
         {{"turret open",
           [](Doors& r) {
               r.set(signals::cp_turretopen(1), 1);
               r.run(12);
           }}}},
        {Door::DialogueKey,
         [](Doors& r) {
             r.push(1, r.stop(1, StopReason::Dialogue));
             push_move(r);
             r.start(1);
             r.run(20);
             EXPECT_EQ(r.state(1), ChannelState::ProgramStop);
         },
         [](Doors& r) { r.command(CommandKind::DialogueKey, 1, 1); }},
        {Door::ProgramStart,
         [](Doors& r) {
             r.push(2, r.line(2, {20, 0}, 50));
         },
         [](Doors& r) { r.machine->core().program_calls[1].started = true; },
         {{"MDI",
           [](Doors& r) {
               r.mode(ChannelMode::Mdi, 2);
               r.run(2);
           }},
          {"jog",
           [](Doors& r) {
               r.mode(ChannelMode::Jog, 2);
               r.run(2);
           }}}},
        {Door::Restart,
         [](Doors& r) {
             r.push(1, r.stop(1, StopReason::Restart));
             push_move(r);
         },
         [](Doors& r) {
             r.command(CommandKind::Restart, 1, 10, 0, 0, 1);
             r.run(5);
             r.start(1);
         }},
        {Door::Retrace, [](Doors& r) { r.held(); },
         [](Doors& r) {
             r.command(CommandKind::Retrace, 1);
             r.start(1);
         }},
        {Door::ProgramHandwheel,
         [](Doors& r) {
             r.command(CommandKind::ProgramHandwheel, 1);
             push_move(r);
             r.start(1);
             r.run(50);
         },
         [](Doors& r) { r.command(CommandKind::Handwheel, 1, 200); },
         {{"no wheel chosen",
           [](Doors& r) {
               r.command(CommandKind::FeedHold, 1);
               r.command(CommandKind::ProgramHandwheel, 1, 0);
               r.run(20);
           }}}},
        {Door::WaitRelease,
         [](Doors& r) {
             r.push(1, r.wait(1, 500, 3));
             push_move(r);
             r.push(2, r.wait(2, 500, 3));
             r.start(1);
             r.run(50);
         },
         [](Doors& r) { r.start(2); }},
        {Door::Jog,
         {},
         [](Doors& r) { r.command(CommandKind::Jog, 0, 1, 0, 1); },
         {{"a program runs",
           [](Doors& r) {
               r.push(1, r.dwell(1, 100));
               r.start(1);
               r.run(5);
           }}}},
        {Door::Step,
         {},
         [](Doors& r) { r.command(CommandKind::Step, 0, 1, 0, 1); },
         {{"a program is held", [](Doors& r) { r.held(); }}}},
        {Door::Handwheel,
         {},
         [](Doors& r) { r.command(CommandKind::Handwheel, 0, 100, 0, 1, 1); },
         {{"a program is held", [](Doors& r) { r.held(); }}}},
        {Door::Superpose,
         [](Doors& r) {
             r.command(CommandKind::Superpose, 1);
             r.push(1, r.line(1, {0, 200}, 10));
             r.start(1);
             r.run(100);
         },
         [](Doors& r) { r.command(CommandKind::Handwheel, 0, 100, 0, 1, 1); },
         {},
         true},
        {Door::Return,
         [](Doors& r) {
             r.held();
             r.command(CommandKind::JogInHold, 1);
             r.command(CommandKind::Step, 0, 5, 0, 1);
             r.run(1500);
         },
         [](Doors& r) { r.command(CommandKind::Return, 1); }},
        {Door::Reference,
         {},
         [](Doors& r) { r.command(CommandKind::Reference, 0, 1, 0, 4); },
         {{"a program runs",
           [](Doors& r) {
               r.push(2, r.dwell(2, 100));
               r.start(2);
               r.run(5);
           }}}},
        {Door::ReferenceKey,
         [](Doors& r) {
             r.mode(ChannelMode::Reference, 2);
             r.run(2);
         },
         [](Doors& r) { r.command(CommandKind::Jog, 0, 1, 0, 4); }},
        {Door::ReferenceByProgram, {}, [](Doors& r) { r.machine->core().home_request[3] = true; }},
        {Door::PlcAxis,
         [](Doors& r) {
             r.set(signals::ap_paxpos(3), 20'000);
             r.set(signals::ap_paxfeed(3), 1200);
             r.run(2);
         },
         [](Doors& r) { r.set(signals::ap_paxr(3), 1); }},
        {Door::Positioning,
         [](Doors& r) {
             r.push(1, r.dwell(1, 100));
             r.start(1);
             r.run(20);
         },
         [](Doors& r) {
             Core::PositioningRequest& wish = r.machine->core().beside[1];
             wish = {};
             wish.asked = true;
             wish.target = 10;
             wish.speed = 20;
             wish.channel = 1;
             wish.since = r.machine->core().tick;
         },
         {},
         false,
         {},
         {},
         kMachineOn | kNoStop},
        {Door::FollowUp,
         [](Doors& r) {
             r.command(CommandKind::Jog, 0, 1, 0, 1);
             r.run(300);
             r.set(signals::ap_flwu(1), 1);
             r.set(signals::ap_opnr(1), 1);
             r.run(1500);
         },
         [](Doors& r) { r.set(signals::ap_opnr(1), 0); },
         {},
         false,
         {},
         [](Doors& r) {
             r.set(signals::ap_flwu(1), 0);
             r.run(2);
         }},
        {Door::StopRelease,
         [](Doors& r) {
             r.set(signals::ap_torq(2), 100);
             r.run(20);
             PathRecord to_stop = r.line(1, {0, 40}, 10);
             to_stop.flags |= kSkipMove | kFixedStop | kDrains;
             to_stop.code = -1;
             r.push(1, to_stop);
             r.start(1);
             r.run(2500);
             EXPECT_EQ(r.machine->core().signals.nc(signals::an_fixed(2)), 1);
         },
         [](Doors& r) { r.set(signals::ap_torq(2), 0); },
         {},
         false,
         [](params::Table& t) {
             params::put(t, params::pt_drive_stop, 12.0, 2);
             params::put(t, params::pt_stop_error, 0.05, 2);
         }},
        {Door::GearRetract,
         [](Doors& r) {
             r.run(20);
             EXPECT_EQ(
                 r.couple({.master = 1, .follower = kMaxAxes + 1, .channel = 1, .gear = true}),
                 SpindleCouplings::Refusal::None);
             r.run(50);
         },
         [](Doors& r) { r.set(signals::cp_egbrrq(1), 1); },
         {},
         false,
         [](params::Table& t) {
             params::put(t, params::n1804_retr_dist, 15, 1);
             params::put(t, params::n1805_retr_feed, 1200, 1);
         }},
        {Door::PlcSpindle,
         [](Doors& r) {
             r.push(1, r.spindle(1, 600));
             r.push(1, r.dwell(1, 100));
             r.start(1);
             r.run(20);
         },
         [](Doors& r) { r.set(signals::sp_rot(1), 3); },
         {{"chuck open",
           [](Doors& r) {
               r.set(signals::sp_unclamped(1), 1);
               r.run(5);
           }}},
         false,
         {},
         {},
         kMachineOn | kNoStop},
        {Door::WorkRetract,
         [](Doors& r) {
             r.push(1, r.dwell(1, 100));
             r.start(1);
             r.run(5);
         },
         [](Doors& r) { r.set(signals::plc_power(), 1); }},
    };
    return all;
}
struct Shut {
    const char* name;
    std::uint8_t ground;
    std::function<void(Doors&)> bring, take_away;
};
const std::vector<Shut>& shuts() {
    static const auto on_again = [](Doors& r) {
        r.command(CommandKind::ReleaseStop);
        r.run(20);
        r.command(CommandKind::MachineOn);
        r.run(60);
        EXPECT_TRUE(r.machine->core().on());
    };
    static const std::vector<Shut> all{
        {"emergency stop", kMachineOn,
         [](Doors& r) {
             r.command(CommandKind::EmergencyStop);
             r.run(400);
         },
         on_again},
        {"off", kMachineOn,
         [](Doors& r) {
             r.command(CommandKind::EmergencyStop);
             r.run(400);
             r.command(CommandKind::ReleaseStop);
             r.run(50);
         },
         on_again},
        {"stopped", kNoStop,
         [](Doors& r) {
             r.machine->stop_all(Alarm::PlcLate);
             r.run(400);
         },
         [](Doors& r) { r.machine->core().all_stop = false; }},
        {"door", kDoorClosed,
         [](Doors& r) {
             r.set(signals::cp_dooropen(1), 1);
             r.set(signals::cp_dooropen(2), 1);
             r.run(400);
         },
         [](Doors& r) {
             r.set(signals::cp_dooropen(1), 0);
             r.set(signals::cp_dooropen(2), 0);
             r.run(2);
         }},
    };
    return all;
}

// Rows of start_conditions.cpp beside the grounds above, one by one. Channel 2 has axes of its own,
// and is who START starts.
const std::vector<std::pair<const char*, std::function<void(Doors&)>>>& start_rows() {
    static const auto both = [](std::uint32_t (*slot)(std::size_t)) {
        return [slot](Doors& r) {
            r.set(slot(1), 1);
            r.set(slot(2), 1);
            r.run(2);
        };
    };
    static const std::vector<std::pair<const char*, std::function<void(Doors&)>>> all{
        {"process",
         [](Doors& r) {
             for (unsigned l = 0; l < 2; ++l)
                 r.command(CommandKind::ProcessStopped, 0, 0, 0,
                           static_cast<std::uint32_t>(kProcessChannel) + l);
             r.run(2);
         }},
        {"store", [](Doors& r) { r.machine->core().store_dead = true; }},
        {"store_whole", [](Doors& r) { r.machine->core().store_unfit = true; }},
        {"lubrication", both([](std::size_t l) -> std::uint32_t { return signals::cp_nolube(l); })},
        {"bar", both([](std::size_t l) -> std::uint32_t { return signals::cp_barend(l); })},
        {"tailstock", both([](std::size_t l) -> std::uint32_t { return signals::cp_tailopen(l); })},
        {"tool", both([](std::size_t l) -> std::uint32_t { return signals::cp_turretopen(l); })},
        {"chuck",
         [](Doors& r) {
             r.set(signals::sp_unclamped(1), 1);
             r.run(2);
         }},
        {"referenced",
         [](Doors& r) {
             r.machine->core().axes[1].referenced = r.machine->core().axes[3].referenced = false;
         }},
        {"attached",
         [](Doors& r) {
             for (const unsigned a : {1u, 3u}) r.machine->core().config.axes[a].named = true;
             r.set(signals::ap_detchr(2), 1);
             r.set(signals::ap_detchr(4), 1);
             r.run(60);
         }},
    };
    return all;
}

void stands(const Walk& walk, const char* why, const std::function<void(Doors&)>& bring,
            const std::function<void(Doors&)>& take_away, bool told = true) {
    SCOPED_TRACE(std::string(row_of(walk.door).name) + ", shut by: " + why);
    Doors rig(walk.adjust);
    if (walk.prepare) walk.prepare(rig);
    bring(rig);
    const auto before = rig.way;
    const Alarm refusal = row_of(walk.door).refusal.value_or(Alarm::NotReady);
    const int said = rig.refusals(refusal) + rig.refusals(Alarm::MdiRefused);
    walk.ask(rig);
    rig.run(300);
    EXPECT_LT(farthest(rig.way, before), kStands);
    if (told && row_of(walk.door).refusal) {
        EXPECT_GT(rig.refusals(refusal) + rig.refusals(Alarm::MdiRefused), said)
            << "refused, and said";
    }
    if (!take_away) return;
    if (walk.take_back) walk.take_back(rig);
    take_away(rig);
    rig.run(500);
    EXPECT_LT(farthest(rig.way, before), kStands) << "nothing was kept (G3)";
}

TEST(MotionStarts, EachDoorOpensWhereItMay) {
    for (const Walk& walk : walks()) {
        SCOPED_TRACE(row_of(walk.door).name);
        Doors rig(walk.adjust);
        if (walk.prepare) walk.prepare(rig);
        const auto before = rig.way;
        walk.ask(rig);
        rig.run(300);
        bool moved = false;
        for (std::size_t i = walk.program_moves ? 4 : 0; i < before.size(); ++i)
            moved = moved || std::fabs(rig.way[i] - before[i]) > kStands;
        EXPECT_TRUE(moved);
    }
}

TEST(MotionStarts, EachDoorIsShutWithoutItsGrounds) {
    for (const Walk& walk : walks()) {
        const std::uint8_t grounds =
            row_of(walk.door).grounds & kStartRows ? kSafe : row_of(walk.door).grounds;
        for (const Shut& shut : shuts())
            if (grounds & shut.ground)
                stands(walk, shut.name, shut.bring, shut.take_away,
                       !(walk.over_without & shut.ground));
        for (const auto& [name, bring] : walk.shut) stands(walk, name, bring, {});
    }
}

TEST(MotionStarts, EachStartAsksEachRowOfTheStartConditions) {
    for (const Walk& walk : walks()) {
        if (!(row_of(walk.door).grounds & kStartRows)) continue;
        for (const auto& [name, bring] : start_rows()) stands(walk, name, bring, {});
    }
}

// The gate itself: each row with all its grounds, and without one after the other. A ground of
// others shuts nothing.
TEST(MotionStarts, TheGateAsksTheGroundsOfARowAndNoOthers) {
    for (const MotionStart& row : kMotionStarts) {
        const bool start = row.grounds & kStartRows;
        const auto opens = [&](Doors& r) {
            StartView view{1};
            return start ? MotionGate::ask(r.machine->core(), row.door, view).has_value()
                         : MotionGate::ask(r.machine->core(), row.door, 1).has_value();
        };
        SCOPED_TRACE(row.name);
        {
            Doors rig;
            rig.run(2);
            EXPECT_TRUE(opens(rig));
            EXPECT_EQ(MotionGate::ask(rig.machine->core(), row.door, 1).has_value(), !start)
                << "a start is not asked by a number alone";
            EXPECT_EQ(MotionGate::ask(rig.machine->core(), row.door, StartView{1}).has_value(),
                      start);
            StartView alarmed{1};
            alarmed.alarmed = true;
            EXPECT_FALSE(MotionGate::ask(rig.machine->core(), row.door, alarmed));
        }
        for (const Shut& shut : shuts()) {
            SCOPED_TRACE(shut.name);
            Doors rig;
            shut.bring(rig);
            // an emergency stop is one as well
            rig.machine->core().all_stop = shut.ground == kNoStop;
            EXPECT_EQ(opens(rig), !start && !(row.grounds & shut.ground));
        }
    }
}

std::string read(const std::string& path) {
    std::stringstream out;
    out << std::ifstream(std::string(kSourceFolder) + "/" + path).rdbuf();
    return out.str();
}

TEST(MotionStarts, EachRowIsWalked) {
    std::set<Door> walked;
    for (const Walk& walk : walks()) EXPECT_TRUE(walked.insert(walk.door).second);
    for (const MotionStart& row : kMotionStarts) EXPECT_TRUE(walked.count(row.door)) << row.name;
}

// A start that comes before a hold has come to rest takes the hold back: it is a start as any
// other.
TEST(MotionStarts, AHoldThatStillBrakesIsNotTakenBackBehindAnOpenDoor) {
    for (const bool open : {true, false}) {
        SCOPED_TRACE(open);
        Doors rig;
        rig.push(1, rig.line(1, {0, 100}, 150));
        rig.start(1);
        rig.run(200);
        if (open)
            rig.set(signals::cp_dooropen(1), 1);
        else
            rig.command(CommandKind::FeedHold, 1);
        rig.run(5);
        ASSERT_EQ(rig.state(1), ChannelState::Running) << "it brakes";
        rig.start(1);
        rig.run(400);
        EXPECT_EQ(rig.state(1), open ? ChannelState::Held : ChannelState::Running);
        EXPECT_EQ(rig.refusals(Alarm::NotReady), open ? 1 : 0);
    }
}

// The document has the same rows, in the same order, with the same words.
TEST(MotionStarts, TheDocumentSaysTheSame) {
    std::string expected;
    for (const MotionStart& row : kMotionStarts) {
        const auto words = [&] {
            std::string out;
            const auto add = [&](std::uint8_t bit, const char* word) {
                if (row.grounds & bit) out += (out.empty() ? "" : ", ") + std::string(word);
            };
            add(kStartRows, "all rows of a start");
            add(kMachineOn, "machine on");
            add(kNoStop, "no stop");
            add(kDoorClosed, "door closed");
            return out.empty() ? std::string("its run's start") : out;
        }();
        expected +=
            "| " + std::string(row.name) + " | " + std::string(row.asked_by) + " | `" +
            std::string(row.begins) + "` | " + words + " | " +
            (row.refusal ? std::string(alarm_row(*row.refusal).number[0]) : std::string("–")) +
            " |\n";
    }
    const std::string document = read("docs/design/motion-starts.md");
    EXPECT_NE(document.find(expected), std::string::npos) << "the table is to be:\n" << expected;
}

// Without AP_FLWU and N0514 #5.
TEST(MotionStarts, ALoopThatClosesMovesNothing) {
    Doors rig;
    rig.command(CommandKind::Jog, 0, 1, 0, 1);
    rig.run(300);
    rig.set(signals::ap_opnr(1), 1);
    rig.run(1500);
    rig.set(signals::ap_opnr(1), 0);
    rig.run(5);
    const auto there = rig.way;
    rig.run(500);
    EXPECT_LT(farthest(rig.way, there), kStands);
}

TEST(MotionStarts, TheWayBackFromAFixedStopIsDrivenOnlyWhileTheMachineIsOn) {
    for (const bool on : {true, false}) {
        TickRig rig([](params::Table& t, RunOptions&) {
            params::put(t, params::pt_drive_stop, 12.0, 2);
            params::put(t, params::pt_stop_error, 0.05, 2);
        });
        const auto torque = [&](double value) {
            rig.command(CommandKind::SetSignal, 0, value, 0, signals::ap_torq(2), 1);
        };
        torque(100);
        rig.run(20);
        PathRecord r = rig.line(1, {0, 40}, 10);
        r.flags |= kSkipMove | kFixedStop | kDrains;
        r.code = -1;
        rig.push(1, r);
        rig.start(1);
        rig.run(2500);
        ASSERT_EQ(rig.machine->core().signals.nc(signals::an_fixed(2)), 1);
        if (!on) {
            rig.machine->stop_all(Alarm::PlcLate);
            rig.run(100);
        }
        const double stands = rig.position(2);
        torque(0);
        rig.run(800);
        if (on) {
            EXPECT_NEAR(rig.position(2), 12, 1e-2);
        } else {
            EXPECT_EQ(rig.position(2), stands);
        }
        rig.machine->core().all_stop = false;
        const double still = rig.position(2);
        rig.run(500);
        EXPECT_EQ(rig.position(2), still) << "nothing was kept";
    }
}

// G1: what begins without asking does not compile, nor does a program that begins by the permit of
// a jog.
template <class P>
constexpr bool cannot_be_made =
    !std::is_default_constructible_v<P> && !std::is_constructible_v<P, Door>;
static_assert(cannot_be_made<Permit> && cannot_be_made<StartPermit>);
static_assert(!std::is_convertible_v<Permit, StartPermit> &&
              !std::is_constructible_v<StartPermit, Permit> &&
              !std::is_constructible_v<Permit, StartPermit>);

}  // namespace
}  // namespace polyturn::kernel
