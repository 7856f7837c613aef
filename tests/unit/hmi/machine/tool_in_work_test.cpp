// What stands in the cards after a reset and in a hold is what acts: the tool in the turret, zero,
// feed and codes of the last block that has begun. The channel has read far beyond it.
#include <QFile>
#include <QRegularExpression>

#include "ipc/model/machine/store/work_zeros.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class ToolAtWorkTasks : public Tasks {
protected:
    // Stands in the card of L1 as a word of its own.
    bool card(const QString& text) const {
        const QRegularExpression whole("(^|\\W)" + QRegularExpression::escape(text) + "(\\W|$)");
        for (const Item& item : window->screens()[0]->sheets()[0]->items())
            if (item.font.family() != lettering(13, false, Face::Program).family() &&
                whole.match(item.text).hasMatch())
                return true;
        return false;
    }
    void run(const char* lines, std::uint32_t until) {
        const QString path = g_controller->folder.filePath("O0091.nc");
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(lines);
        file.close();
        ASSERT_TRUE(g_controller->press("reference all"));
        ASSERT_TRUE(waitFor(
            [&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready; }));
        ASSERT_TRUE(g_controller->press("mode L1=auto"));
        ASSERT_TRUE(g_controller->press("select L1=" + path));
        ASSERT_TRUE(waitFor([&] { return live().channel(1).start_missing == 0; }));
        ASSERT_TRUE(g_controller->press("cycle_start L1"));
        ASSERT_TRUE(waitFor(
            [&] { return live().channel(1).line == until && state(1) == ChannelState::Running; }));
        frames(*window, 500);  // it is read to its end
        window->showScreen(0);
    }
    static constexpr const char* kReadAhead =
        "O91\nN10 T0101\nN20 G54 G0 X60. Z20.\nN30 G98 G1 Z-20. F60.\n"
        "N40 G55 G1 Z-30. F90.\nN50 T0303\nN60 G3 X62. Z-31. R1.\n"
        "N70 M30\n";
    static constexpr std::uint32_t kSlow = 4;  // line of N30
};

TEST_F(ToolAtWorkTasks, AResetShowsWhatActsAndNotWhatWasReadAhead) {
    run(kReadAhead, kSlow);
    ASSERT_FALSE(HasFatalFailure());
    ASSERT_TRUE(waitFor([&] { return card("T1"); }));
    EXPECT_EQ(live().view(1).picture.tool, 1);
    ASSERT_TRUE(g_controller->press("reset L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    frames(*window, 500);
    const BlockPicture& now = live().view(1).picture;
    EXPECT_EQ(live().plc(signals::cp_actt(1)), 1) << "where the turret stands";
    EXPECT_TRUE(card("T1"));
    EXPECT_FALSE(card("T3")) << "read ahead, never called";
    EXPECT_EQ(now.tool, 1);
    EXPECT_EQ(now.zero_row, static_cast<std::int32_t>(*work_zero_row("G54")));
    EXPECT_EQ(now.feed, 60);
    const QString codes = QString::fromUtf8(now.codes.data());
    EXPECT_FALSE(codes.contains("G55") || codes.contains("G3 ")) << codes.toStdString();
}

TEST_F(ToolAtWorkTasks, AHoldShowsWhatActs) {
    run(kReadAhead, kSlow);
    ASSERT_FALSE(HasFatalFailure());
    ASSERT_TRUE(g_controller->press("feed_hold L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Held; }));
    for (int look = 0; look < 20; ++look) {
        frames(*window, 20);
        EXPECT_TRUE(card("T1") && !card("T3"));
        EXPECT_EQ(live().view(1).picture.feed, 60);
    }
}

// A program that has called none leaves the one that stands there.
TEST_F(ToolAtWorkTasks, TheToolInTheTurretIsKnownWithoutAProgram) {
    run("O91\nN10 G4 X20.\nN20 T0505\nN30 M30\n", 2);
    ASSERT_FALSE(HasFatalFailure());
    const int station = live().plc(signals::cp_actt(1));
    ASSERT_GT(station, 0);
    const auto right = [&] {
        return card(QString("T%1").arg(station)) && !card("no tool known") &&
               (station == 5 || !card("T5"));
    };
    EXPECT_TRUE(right());
    ASSERT_TRUE(g_controller->press("reset L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    frames(*window, 500);
    EXPECT_TRUE(right());
    ASSERT_TRUE(g_controller->press("select L1=" + QString(kSourceFolder) +
                                    "/examples/jobs/shaft/O1001.nc"));
    frames(*window, 500);
    EXPECT_TRUE(right()) << "another selection moves no turret";
}

}  // namespace
}  // namespace polyturn::hmi
