// A simulation says what it does: that it is being computed, why there is nothing to play; and it
// can be stopped.
#include <QFile>

#include "hmi/screens/graphics/graphics.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class SimulationTasks : public Tasks {
protected:
    QString write(const char* name, const char* text) {
        const QString path = g_controller->folder.filePath(name);
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return path;
    }
    void select(const QString& path) {
        ASSERT_TRUE(g_controller->press("select L1=" + path));
        ASSERT_TRUE(waitFor([&] {
            return !live().view(1).programs.empty() &&
                   QString::fromStdString(live().view(1).programs[0]) == path;
        }));
        frames(*window, 300);  // the job beside it is looked for
    }
    bool offered(const QString& key) const {
        const auto keys = window->screen()->keys();
        return std::any_of(keys.begin(), keys.end(),
                           [&](const SoftKey& one) { return one.text == key && one.enabled; });
    }
    bool says(const QString& text) const {
        window->screen()->refresh();
        return standsOn(window->screen()->sheets(), text);
    }
    static constexpr const char* kEndless = "O96\nN10 G0 X50.\nG0 X60.\nGOTO 10\n";
};

TEST_F(SimulationTasks, WithoutAResultItSaysWhy) {
    select(write("O0095.nc", "O95\nN10 G4 X(\nN20 M30\n"));
    Operator hand(*window);
    hand.screen("graphics");
    hand.soft("Simulation");
    EXPECT_TRUE(waitFor([&] { return says("Nothing to simulate: O0095.nc:2"); }, 30));
    EXPECT_FALSE(says("0:00 of 0:00"));
    hand.soft("Simulation");
    select(write("O0094.nc", "O94\nM30\n"));
    hand.soft("Simulation");
    EXPECT_TRUE(
        waitFor([&] { return says("Nothing to simulate: the program takes no time"); }, 30));
    hand.soft("Simulation");
}

TEST_F(SimulationTasks, IsStoppedWhileItComputes) {
    select(write("O0096.nc", kEndless));
    Operator hand(*window);
    hand.screen("graphics");
    hand.soft("Simulation");
    EXPECT_TRUE(waitFor([&] { return says("The simulation is being computed"); }, 10));
    ASSERT_TRUE(offered("Stop"));
    hand.soft("Stop");
    EXPECT_TRUE(waitFor([&] { return !offered("Stop") && offered("Play"); }, 10));
    EXPECT_FALSE(says("is being computed"));
    hand.soft("Simulation");
    // The same beside the list of programs.
    hand.screen("programs");
    Programs& programs = screenOf<Programs>();
    programs.restore("0|" + g_controller->folder.filePath("O0096.nc"));
    ASSERT_TRUE(waitFor([&] { return offered("Simulation, timeline"); }));
    hand.soft("Simulation, timeline");
    ASSERT_TRUE(waitFor([&] { return programs.dryRun().running(); }, 10));
    ASSERT_TRUE(offered("Stop"));
    hand.soft("Stop");
    EXPECT_FALSE(programs.dryRun().running());
    EXPECT_EQ(programs.dryRun().failure(), "It was stopped.");
    EXPECT_TRUE(says("It was stopped."));
}

}  // namespace
}  // namespace polyturn::hmi
