// Which alarms, warnings and messages stand: all that have stopped something, and what a program
// wants to be read.
#include <QFile>
#include <csignal>
#include <set>

#include "hmi/screens/machine/alarms.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class StandingAlarms : public Tasks {
protected:
    const AlarmLog& book() const { return window->context().alarms; }
    Plight now() const { return plight(live(), book(), 1); }
    bool stands(const QString& text) const {
        const auto& all = book().all();
        return std::any_of(all.begin(), all.end(), [&](const AlarmEntry& one) {
            return one.standing && (one.number == text || one.text.contains(text));
        });
    }
    std::string told() const {  // for a message: everything that was heard
        std::string out;
        for (const AlarmEntry& one : book().all())
            out += one.number.toStdString() + " " + one.text.toStdString() +
                   (one.standing ? " stands" : "") + (one.over ? " over" : "") + " ch " +
                   std::to_string(one.channel) + " resets " + std::to_string(one.resets) + "\n";
        return out + "resets now " + std::to_string(live().nc(signals::cn_reset(1))) + ", step " +
               std::to_string(live().status().step);
    }
    void run(const char* lines) {
        const QString file = g_controller->folder.filePath("standing.nc");
        QFile program(file);
        ASSERT_TRUE(program.open(QIODevice::WriteOnly));
        program.write(lines);
        program.close();
        ASSERT_TRUE(g_controller->press("reference all"));
        ASSERT_TRUE(waitFor(
            [&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready; }));
        ASSERT_TRUE(g_controller->press("mode L1=auto"));
        ASSERT_TRUE(g_controller->press("select L1=" + file));
        ASSERT_TRUE(g_controller->press("cycle_start L1"));
    }
    void stopAndOn(const std::function<void()>& look) {
        ASSERT_TRUE(g_controller->press("emergency_stop"));
        ASSERT_TRUE(waitFor(
            [&] { return live().status().machine_state == 0 && book().standing() != nullptr; }));
        look();
        ASSERT_TRUE(g_controller->press("machine_on"));
        ASSERT_TRUE(waitFor([&] { return live().status().machine_state == 2; }));
    }
};

TEST_F(StandingAlarms, AMessageOfTheProgramStandsUntilItGoesOn) {
    const QString file = g_controller->folder.filePath("message.nc");
    QFile program(file);
    ASSERT_TRUE(program.open(QIODevice::WriteOnly));
    program.write("O7777\n#3006=1(CHECK THE INSERT)\nG4 P30000\nM0\nM30\n");
    program.close();
    ASSERT_TRUE(g_controller->press("reference all"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready; }));
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
    ASSERT_TRUE(g_controller->press("select L1=" + file));
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] {
        return now().kind == Plight::Kind::Stands && now().text.contains("CHECK THE INSERT");
    })) << now().text.toStdString();
    EXPECT_EQ(state(1), ChannelState::ProgramStop);
    EXPECT_EQ(book().standing(1), nullptr) << "it is no alarm";
    Operator hand(*window);
    hand.screen("alarms");
    EXPECT_TRUE(waitFor([&] {
        const auto& rows = screenOf<Alarms>().rows();
        return std::any_of(rows.begin(), rows.end(), [](const AlarmEntry& one) {
            return one.text.contains("CHECK THE INSERT");
        });
    })) << "it is on the page of what stands";
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Running; }));
    EXPECT_TRUE(waitFor([&] { return now().kind == Plight::Kind::None; }))
        << now().text.toStdString();
    g_controller->press("reset");
}

// An alarm is over with its channel's reset: a stop that comes later has other causes.
TEST_F(StandingAlarms, WhatAResetHasEndedDoesNotComeBackWithAStop) {
    run("O7778\n#3000=7(INSERT BROKEN)\nM30\n");
    ASSERT_TRUE(waitFor([&] { return stands("INSERT BROKEN"); })) << told();
    stopAndOn([&] { EXPECT_TRUE(stands("INSERT BROKEN")) << "nobody has reset its channel"; });
    EXPECT_TRUE(stands("INSERT BROKEN"));
    ASSERT_TRUE(g_controller->press("reset L1"));
    ASSERT_TRUE(waitFor([&] { return !stands("INSERT BROKEN"); }));
    stopAndOn([&] {
        frames(*window, 500);
        EXPECT_FALSE(stands("INSERT BROKEN"));
    });
}

TEST_F(StandingAlarms, ARefusedKeyIsShownForAWhileOnly) {
    ASSERT_TRUE(g_controller->press("mode L1=mdi"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<ChannelMode>(live().channel(1).mode) == ChannelMode::Mdi; }));
    g_controller->press("cycle_start L1");
    ASSERT_TRUE(waitFor([&] { return stands("PT0535"); }));
    EXPECT_TRUE(waitFor([&] { return !stands("PT0535"); }));
    stopAndOn([&] {
        frames(*window, 500);
        EXPECT_FALSE(stands("PT0535"));
    });
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
}

// Somebody has to see it, when he comes back from his lunch too.
TEST_F(StandingAlarms, TheAlarmOfADeadChannelStaysUntilItsReset) {
    int pid = 0;
    for (const Live::Process& one : live().processes())
        if (one.name == "channel 2") pid = one.pid;
    ASSERT_GT(pid, 1);
    ASSERT_EQ(::kill(pid, SIGKILL), 0);
    ASSERT_TRUE(waitFor([&] { return stands("PT0500"); }));
    QTest::qWait(22'000);
    EXPECT_TRUE(stands("PT0500"));
    ASSERT_TRUE(g_controller->press("reset L2"));
    ASSERT_TRUE(waitFor([&] { return state(2) == ChannelState::Reset; }));
    ASSERT_TRUE(g_controller->press("reset L2"));  // of the one that has come for it
    EXPECT_TRUE(waitFor([&] { return !stands("PT0500"); }));
}

// What the program says at its stop is found by the line, whatever else has been told meanwhile.
TEST_F(StandingAlarms, TheMessageOfAStopIsFoundByItsLine) {
    run("O7779\nM0 (WAITS)\n#3006=1(TURN THE PART)\nM30\n");
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::ProgramStop; }));
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] { return now().text.contains("TURN THE PART"); }));
    const AlarmEntry* said = book().toldAt(1, live().channel(1).line);
    ASSERT_NE(said, nullptr);
    EXPECT_TRUE(said->text.contains("TURN THE PART"));
    EXPECT_EQ(book().toldAt(1, live().channel(1).line + 1), nullptr);
    g_controller->press("reset");
}

// What the machine's builder tells stands as long as his PLC program tells it, and stops nothing by
// itself.
TEST_F(StandingAlarms, ANoteOfTheBuilderStandsAsLongAsItIsTold) {
    ASSERT_TRUE(g_controller->set("PLC_NOTE=901"));
    ASSERT_TRUE(waitFor([&] { return stands("PT0811"); }));
    EXPECT_NE(book().told(0), nullptr);
    EXPECT_NE(live().status().machine_state, 0u);
    const auto inTopBar = [&] {  // it belongs to no channel, so no card shows it
        for (Sheet* sheet : window->ownSheets())
            for (const Item& one : sheet->items())
                if (one.text.contains("PT0811")) return true;
        return false;
    };
    EXPECT_TRUE(waitFor(inTopBar, 5));
    ASSERT_TRUE(g_controller->set("PLC_NOTE=0"));
    EXPECT_TRUE(waitFor([&] { return !stands("PT0811"); }));
    EXPECT_TRUE(waitFor([&] { return !inTopBar(); }));
    EXPECT_EQ(book().told(0), nullptr);
    g_controller->run({"release", "--instance", g_controller->name, "PLC_NOTE"});
}

// Screens that come into a stop that stands: the machine's alarms of this stop stand in them too,
// those of a stop before do not.
TEST_F(StandingAlarms, ScreensThatComeLaterShowTheMachinesAlarmsOfThisStop) {
    stopAndOn([] {});
    QTest::qWait(3'000);  // another stop, and not the same moment
    ASSERT_TRUE(g_controller->set("PLC_ESTOP=1"));
    ASSERT_TRUE(waitFor([&] { return live().status().machine_state == 0; }));
    // refused: the second alarm of the machine in this stop
    g_controller->press("machine_on");
    const auto ofMachine = [](const AlarmLog& of) {
        std::multiset<std::string> out;
        for (const AlarmEntry& one : of.all())
            if (one.standing && one.channel == 0) out.insert(one.number.toStdString());
        return out;
    };
    EXPECT_TRUE(waitFor([&] { return ofMachine(book()).size() == 2; }));
    const auto here = ofMachine(book());
    Choices choices;
    choices.instance = g_controller->name.toStdString();
    choices.language = "en";
    choices.theme = "dark";
    MainWindow later(choices);
    later.show();
    EXPECT_TRUE(waitFor([&] { return ofMachine(later.context().alarms) == here; }))
        << ofMachine(later.context().alarms).size() << " of " << here.size();
    ASSERT_TRUE(g_controller->set("PLC_ESTOP=0"));
    g_controller->run({"release", "--instance", g_controller->name, "PLC_ESTOP"});
    ASSERT_TRUE(waitFor([&] { return g_controller->press("machine_on"); }));
    ASSERT_TRUE(waitFor([&] { return live().status().machine_state == 2; }));
}

// Drives that fail one after the other: the first one is the cause, and does not disappear behind
// the others. Last: the machine stays off.
TEST_F(StandingAlarms, TheFirstCauseStaysAmongThoseThatFollow) {
    const auto stands = [&](const char* axis) {
        const auto& all = book().all();
        return std::any_of(all.begin(), all.end(), [&](const AlarmEntry& one) {
            return one.standing && one.number == "PT0532" && one.text.contains(axis);
        });
    };
    for (const char* axis : {"A1", "A2", "A3"}) {
        ASSERT_TRUE(g_controller->set(QString("drive %1=fault").arg(axis)));
        ASSERT_TRUE(waitFor([&] { return stands(axis); })) << axis;
    }
    EXPECT_TRUE(stands("A1") && stands("A2")) << told();
    EXPECT_GE(book().standingCount(), 3u);
    ASSERT_NE(book().standing(), nullptr);
}

}  // namespace
}  // namespace polyturn::hmi
