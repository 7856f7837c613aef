// Which alarms, warnings and messages stand: all that have stopped something, and what a program wants to be read.
#include <QFile>

#include "hmi/screens/alarms.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class StandingAlarms : public Tasks {
protected:
    const AlarmBook& book() const { return window->desk().alarms; }
    Plight now() const { return plight(live(), book(), 1); }
};

TEST_F(StandingAlarms, AMessageOfTheProgramStandsUntilItGoesOn) {
    const QString file = g_controller->folder.filePath("message.nc");
    QFile program(file);
    ASSERT_TRUE(program.open(QIODevice::WriteOnly));
    program.write("O7777\n#3006=1(CHECK THE INSERT)\nG4 P30000\nM0\nM30\n");
    program.close();
    ASSERT_TRUE(g_controller->press("reference all"));
    ASSERT_TRUE(waitFor([&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready; }));
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
    ASSERT_TRUE(g_controller->press("select L1=" + file));
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] { return now().kind == Plight::Kind::Stands && now().text.contains("CHECK THE INSERT"); }, 20)) << now().text.toStdString();
    EXPECT_EQ(state(1), ChannelState::ProgramStop);
    EXPECT_EQ(book().standing(1), nullptr) << "it is no alarm";
    Operator hand(*window);
    hand.screen("alarms");
    EXPECT_TRUE(waitFor([&] {
        const auto& rows = screenOf<Alarms>().rows();
        return std::any_of(rows.begin(), rows.end(), [](const AlarmEntry& one) { return one.text.contains("CHECK THE INSERT"); });
    }, 5)) << "it is on the page of what stands";
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Running; }, 20));
    EXPECT_TRUE(waitFor([&] { return now().kind == Plight::Kind::None; }, 5)) << now().text.toStdString();
    g_controller->press("reset");
}

// Drives that fail one after the other: the first one is the cause, and does not disappear behind the others. Last: the machine stays off.
TEST_F(StandingAlarms, TheFirstCauseStaysAmongThoseThatFollow) {
    const auto stands = [&](const char* axis) {
        const auto& all = book().all();
        return std::any_of(all.begin(), all.end(), [&](const AlarmEntry& one) { return one.standing && one.number == "PT0532" && one.text.contains(axis); });
    };
    for (const char* axis : {"A1", "A2", "A3"}) {
        ASSERT_TRUE(g_controller->set(QString("drive %1=fault").arg(axis)));
        ASSERT_TRUE(waitFor([&] { return stands(axis); }, 20)) << axis;
    }
    EXPECT_TRUE(stands("A1") && stands("A2"));
    EXPECT_GE(book().standingCount(), 3u);
    ASSERT_NE(book().standing(), nullptr);
}

}  // namespace
}  // namespace polyturn::hmi
