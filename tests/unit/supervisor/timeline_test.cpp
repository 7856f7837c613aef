// Who waited for whom, and which cut to move.
#include "kernel/supervisor/run/timeline.hpp"

#include <gtest/gtest.h>

namespace polyturn::supervisor {
namespace {

// Channel 1 cuts for 4, 6 and 2 s with rapids between, channel 2 for 2 s; they meet at 501.
RunRecord example() {
    RunRecord record;
    const auto add = [&](unsigned channel, Doing doing, double t, double end, std::uint32_t line) {
        Activity activity;
        activity.channel = channel;
        activity.doing = doing;
        activity.t_s = t;
        activity.end_s = end;
        activity.line = line;
        activity.file = channel == 1 ? "O1" : "O2";
        if (doing == Doing::Wait) {
            activity.code = "M501";
            activity.partners = 3;
        }
        record.activities.push_back(activity);
    };
    add(1, Doing::Cut, 0, 3, 1);
    add(1, Doing::Cut, 3, 4, 2);
    add(1, Doing::Rapid, 4, 4.5, 3);
    add(1, Doing::Cut, 4.5, 10.5, 4);
    add(1, Doing::Rapid, 10.5, 11, 5);
    add(1, Doing::Thread, 11, 13, 6);
    add(1, Doing::Wait, 13, 13, 7);
    add(2, Doing::Cut, 0, 2, 1);
    add(2, Doing::Wait, 2, 13, 2);
    return record;
}

TEST(Timeline, WaitsNameWhoCameLast) {
    const auto waits = wait_spans(example());
    ASSERT_EQ(waits.size(), 1u);
    EXPECT_EQ(waits[0].channel, 2u);
    EXPECT_EQ(waits[0].last, 1u);
    EXPECT_DOUBLE_EQ(waits[0].seconds(), 11.0);
}

TEST(Timeline, CutsWithoutARapidBetweenAreOnePass) {
    const auto all = passes(example());
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].first_line, 1u);
    EXPECT_EQ(all[0].last_line, 2u);
    EXPECT_DOUBLE_EQ(all[0].seconds(), 4.0);
    EXPECT_TRUE(all[2].thread);
}

TEST(Timeline, TheBestCutToMoveHalvesTheWait) {
    const auto moves = advice(example(), 3);
    ASSERT_EQ(moves.size(), 1u);
    EXPECT_EQ(moves[0].pass.first_line, 4u);  // 6 s of a wait of 11 s: min(6, 5)
    EXPECT_DOUBLE_EQ(moves[0].gain_s, 5.0);
}

TEST(Timeline, MeetingsHaveTheirChannels) {
    const auto all = meetings(example());
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].channels, (std::vector<unsigned>{1, 2}));
    EXPECT_EQ(all[0].code, "M501");
}

}  // namespace
}  // namespace polyturn::supervisor
