// A panel that is being wiped: it goes on telling what the machine does, an alarm that comes ends
// the lock, and hold and emergency stop are reached by a finger that rests on their keys.
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class CleaningTasks : public Tasks {
protected:
    void TearDown() override {
        window->lock(false);
        g_controller->press("reset");
        g_controller->press("release_emergency_stop");
        g_controller->press("machine_on");
    }
    // The job runs, and what the test before has left is heard and over.
    void lockAtWork() {
        startJob();
        frames(*window, 1'000);
        window->lock(true);
    }
    std::string told() const {
        std::string out;
        for (const AlarmEntry& one : window->context().alarms.all())
            out += one.number.toStdString() + (one.standing ? " stands, " : ", ");
        return out;
    }
    // Where a finger meets what lies uppermost at the place of a soft key.
    std::pair<QWidget*, QPoint> atKey(int key) const {
        const QPoint place = window->softKeys().mapTo(
            window.get(), window->softKeys().boxOf(key).center().toPoint());
        QWidget* const widget = window->childAt(place);
        return {widget, widget->mapFrom(window.get(), place)};
    }
    void rest(int key, int ms) {
        const auto [widget, place] = atKey(key);
        QTest::mousePress(widget, Qt::LeftButton, {}, place);
        frames(*window, ms);
        QTest::mouseRelease(widget, Qt::LeftButton, {}, place);
        frames(*window, 100);
    }
    bool stopped() const {
        return static_cast<MachineStep>(live().status().step) == MachineStep::EmergencyStop;
    }
};

TEST_F(CleaningTasks, AnEmergencyStopEndsTheLockAndIsSeen) {
    lockAtWork();
    ASSERT_TRUE(window->locked());
    ASSERT_TRUE(g_controller->press("emergency_stop"));
    ASSERT_TRUE(waitFor([&] { return stopped(); }));
    EXPECT_TRUE(waitFor([&] { return !window->locked(); }, 5))
        << "the lock hides an emergency stop";
    EXPECT_TRUE(waitFor([&] { return standsOn(window->ownSheets(), "PT"); }, 5))
        << "its alarm stands in the bar";
    window->lock(true);  // of an alarm that is known the panel may be wiped
    frames(*window, 1'000);
    EXPECT_TRUE(window->locked());
}

TEST_F(CleaningTasks, AnAlarmOfAChannelEndsTheLock) {
    lockAtWork();
    ASSERT_TRUE(g_controller->press("reset L2"));
    ASSERT_TRUE(g_controller->press("select L2=/nowhere/at/all.nc"));
    g_controller->press("cycle_start L2");
    ASSERT_TRUE(waitFor([&] { return window->context().alarms.standing(2) != nullptr; }));
    EXPECT_TRUE(waitFor([&] { return !window->locked(); }, 5));
    EXPECT_NE(state(1), ChannelState::Held);
}

TEST_F(CleaningTasks, TheBarGoesOnTelling) {
    lockAtWork();
    frames(*window, 100);
    EXPECT_EQ(window->childAt(200, 20), window->ownSheets()[0])
        << "the state bar lies under the lock";
    EXPECT_TRUE(standsOn({window->ownSheets()[0]}, "Programs run"));
    // another theme
    QTest::mouseClick(window->ownSheets()[0], Qt::LeftButton, {},
                      window->ownSheets()[0]->boxOf(2).center().toPoint());
    EXPECT_TRUE(window->locked()) << "a touch on the bar does nothing; " << told();
    EXPECT_FALSE(standsOn(window->overSheets(), "machine goes on")) << "nobody knows that";
}

TEST_F(CleaningTasks, AFingerThatRestsHoldsAClothDoesNot) {
    constexpr int kHold = 1, kUnlock = 5;
    lockAtWork();
    frames(*window, 100);
    for (const int key : {0, 2, 4, kHold}) rest(key, 60);  // wiped over
    frames(*window, 600);
    EXPECT_TRUE(window->locked()) << told();
    EXPECT_NE(state(1), ChannelState::Held);
    rest(kHold, 700);
    EXPECT_TRUE(waitFor([&] { return state(1) == ChannelState::Held; }, 5))
        << "hold is not reached";
    EXPECT_TRUE(window->locked());
    rest(kUnlock, 700);
    EXPECT_FALSE(window->locked());
    window->lock(true);
    QTest::keyPress(window.get(), Qt::Key_F10);  // by keys too
    frames(*window, 700);
    QTest::keyRelease(window.get(), Qt::Key_F10);
    EXPECT_TRUE(waitFor([&] { return stopped(); }, 5)) << "emergency stop is not reached";
    EXPECT_TRUE(waitFor([&] { return !window->locked(); }, 5));
}

}  // namespace
}  // namespace polyturn::hmi
