// Blocks by hand as an operator gives them: Enter takes a block, Start runs it, and no key changes
// the mode.
#include "hmi/screens/overview/manual.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class MdiTasks : public Tasks {
protected:
    MdiList list() const {
        MdiList out{};
        (void)live().mdi(1, out);
        return out;
    }
    bool shows(std::initializer_list<MdiState> states) const {
        const MdiList its = list();
        std::uint32_t i = 0;
        for (const MdiState one : states)
            if (i >= its.count || static_cast<MdiState>(its.lines[i++].state) != one) return false;
        return its.count == states.size();
    }
    double x() const { return live().status().axes[0].cmd; }
    ChannelMode mode() const { return static_cast<ChannelMode>(live().channel(1).mode); }
    QString said() const {
        return window->context().alarms.all().empty() ? QString()
                                                      : window->context().alarms.all().back().text;
    }
};

// H2: Enter drove the axes, out of automatic mode; the text stayed, and the next block was appended
// to it.
TEST_F(MdiTasks, EnterTakesTheBlockAndStartRunsIt) {
    ASSERT_TRUE(g_controller->press("mode L1=mdi"));
    ASSERT_TRUE(waitFor([&] { return mode() == ChannelMode::Mdi; }));
    Manual& manual = screenOf<Manual>();
    Operator hand(*window);
    hand.screen("manual");
    hand.soft("MDI");
    const double from = x();
    hand.type("G98 G0 U4.");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return shows({MdiState::Entered}); }));
    hand.type("G0 U6.");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] {
        return shows({MdiState::Entered, MdiState::Entered});
    })) << "a line of its own";
    EXPECT_TRUE(manual.state().endsWith(' '))
        << "the field is empty: " << manual.state().toStdString();
    frames(*window, 500);
    EXPECT_EQ(x(), from) << "nothing has moved";
    EXPECT_EQ(state(1), ChannelState::Reset);
    EXPECT_TRUE(standsOn({&manual.side()}, "G98 G0 U4.") && standsOn({&manual.side()}, "G0 U6."));
    hand.soft("Start L1");
    EXPECT_TRUE(waitFor([&] {
        return shows({MdiState::Done, MdiState::Done});
    })) << said().toStdString();
    EXPECT_TRUE(waitFor([&] { return std::abs(x() - from - 5) < 1e-6; })) << x() - from;
    frames(*window, 100);
    hand.soft("Start L1");
    frames(*window, 500);
    EXPECT_NEAR(x(), from + 5, 1e-6) << "what has run does not run again";
    EXPECT_EQ(live().channel(1).parts, 0u);
    // in all languages, with the list on the page; makes the screens anew
    noWordIsShortened(*window);
    hand.screen("manual");
    hand.touch(&screenOf<Manual>().side(), Manual::kMdiClearHit);
    EXPECT_TRUE(waitFor([&] { return list().count == 0; }));
    hand.key(Qt::Key_Escape);
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
}

TEST_F(MdiTasks, InAutomaticModeTheFieldTakesNothingAndTheModeStays) {
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
    ASSERT_TRUE(waitFor([&] { return mode() == ChannelMode::Auto; }));
    Manual& manual = screenOf<Manual>();
    Operator hand(*window);
    hand.screen("manual");
    hand.touch(&manual.side(), Manual::kMdiHit);
    hand.type("G0 X1.");
    hand.key(Qt::Key_Return);
    frames(*window, 500);
    EXPECT_EQ(mode(), ChannelMode::Auto);
    EXPECT_EQ(list().count, 0u);
    EXPECT_TRUE(standsOn(window->ownSheets(), "Blocks are entered in MDI"));
    EXPECT_TRUE(manual.state().endsWith("G0 X1.")) << "what was typed stays";
    manual.typeMdi({});
    hand.key(Qt::Key_Escape);
}

TEST_F(MdiTasks, InAHoldTheStartRunsTheBlockAndSaysSoBefore) {
    startAndHoldJob();
    Manual& manual = screenOf<Manual>();
    Operator hand(*window);
    hand.screen("manual");
    hand.touch(&manual.side(), Manual::kMdiHit);
    const double from = x();
    hand.type("G98 G0 U2.");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return list().count == 1 || !said().isEmpty(); }))
        << said().toStdString();
    frames(*window, 500);
    EXPECT_EQ(x(), from);
    if (list().count == 1) {
        EXPECT_TRUE(standsOn({&manual.side()}, "A block entered by hand waits"));
    }
    ASSERT_TRUE(g_controller->press("mdi_clear L1"));
    EXPECT_TRUE(waitFor([&] { return list().count == 0; }));
    hand.key(Qt::Key_Escape);
}

}  // namespace
}  // namespace polyturn::hmi
