// A window on a real controller with a two-channel job, for tests that act as an operator does. One
// controller serves all of them.
#pragma once
#include "hmi/machine/live/channel_words.hpp"
#include "tests/places.hpp"
#include "tests/unit/hmi/controller.hpp"
#include "tests/unit/hmi/screen_checks.hpp"

namespace polyturn::hmi {

class Tasks : public ::testing::Test {
protected:
    static void SetUpTestSuite() { g_controller = new Controller; }
    static void TearDownTestSuite() { delete g_controller, g_controller = nullptr; }
    void SetUp() override {
        Choices choices;
        choices.instance = g_controller->name.toStdString();
        choices.language = "en";
        choices.theme = "dark";
        window = std::make_unique<MainWindow>(choices);
        window->resize(1280, 800);
        window->show();
        ASSERT_TRUE(waitFor([&] { return live().connected() && live().channels().size() == 2; }));
        g_controller->press("reset");
        ASSERT_TRUE(waitFor([&] {
            return state(1) != ChannelState::Running && state(2) != ChannelState::Running &&
                   state(1) != ChannelState::Held;
        }));
        ASSERT_TRUE(live().status().machine_state == 2 || g_controller->press("machine_on"));
        ASSERT_TRUE(waitFor([&] {
            return static_cast<MachineStep>(live().status().step) == MachineStep::Ready ||
                   static_cast<MachineStep>(live().status().step) == MachineStep::NotReferenced;
        }));
    }
    const Live& live() const { return window->context().live; }
    ChannelState state(unsigned channel) const {
        return static_cast<ChannelState>(live().channel(channel).state);
    }
    template <class Kind>
    Kind& screenOf() const {
        for (Screen* one : window->screens())
            if (auto* found = dynamic_cast<Kind*>(one)) return *found;
        throw std::runtime_error("no such screen");
    }
    void startJob() {
        const QString job = QString(kSourceFolder) + "/examples/jobs/shaft/shaft.job.toml";
        ASSERT_TRUE(g_controller->press("select " + job));
        ASSERT_TRUE(g_controller->press("cycle_start"));
        ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Running; }))
            << waitWords(live(), 1).toStdString();
    }

    // The same, held with its axes at rest: where something is measured by where they stand.
    void startAndHoldJob() {
        startJob();
        frames(*window, 300);
        ASSERT_TRUE(g_controller->press("feed_hold"));
        ASSERT_TRUE(waitFor([&] {
            const auto stands = [&](unsigned axis) {
                return !(live().status().axes[axis - 1].flags & kMoving);
            };
            return state(1) == ChannelState::Held && stands(1) && stands(2) && stands(3) &&
                   stands(4);
        }));
    }

    std::unique_ptr<MainWindow> window;
    inline static Controller* g_controller = nullptr;
};

}  // namespace polyturn::hmi
