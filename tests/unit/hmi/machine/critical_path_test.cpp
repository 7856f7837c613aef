// The chain that a cycle's length hangs on, against runs whose chain can be seen.
#include "hmi/machine/programs/critical_path.hpp"

#include <gtest/gtest.h>

namespace polyturn::hmi {
namespace {

RunWait wait(int code, double from, double to) {
    RunWait out;
    out.code = code;
    out.channels = {1, 2};
    out.from = from;
    out.to = to;
    return out;
}
std::string told(const std::map<unsigned, RunChannel>& channels) {
    std::string out;
    for (const RunStretch& one : criticalPath(channels))
        out += "L" + std::to_string(one.channel) + " " + std::to_string(std::lround(one.from)) +
               "-" + std::to_string(std::lround(one.to)) + " ";
    return out;
}

TEST(CriticalPath, GoesOverToWhoeverCameLastAtEachMeeting) {
    std::map<unsigned, RunChannel> run;
    // comes last to M501, stands at M505
    run[1].waits = {wait(501, 40, 40.001), wait(505, 60, 90)};
    run[1].end = 100;
    run[2].waits = {wait(501, 5, 40), wait(505, 90, 90.002)};
    run[2].end = 95;
    EXPECT_EQ(told(run), "L1 0-40 L2 40-90 L1 90-100 ");
    // The end of the other one counts when it is later.
    run[2].end = 130;
    EXPECT_EQ(told(run), "L1 0-40 L2 40-130 ");
}

TEST(CriticalPath, IsOneChannelWhereNobodyStands) {
    std::map<unsigned, RunChannel> run;
    run[1].end = 10;
    run[2].end = 30;
    run[2].waits = {wait(500, 12, 12)};
    run[1].waits = {wait(500, 12, 12)};
    EXPECT_EQ(told(run), "L2 0-30 ");
    EXPECT_EQ(told({}), "");
}

// for the PLC, say: its time belongs to the path
TEST(CriticalPath, GoesThroughAWaitThatNoChannelEnded) {
    std::map<unsigned, RunChannel> run;
    run[1].waits = {wait(500, 10, 25)};
    run[1].end = 40;
    run[2].end = 5;
    EXPECT_EQ(told(run), "L1 0-40 ");
}

// meetings that overlap, ends before their beginnings
TEST(CriticalPath, EndsWhateverTheEventsSay) {
    std::map<unsigned, RunChannel> run;
    run[1].waits = {wait(500, 30, 20), wait(500, 1, 50), wait(500, 1, 50)};
    run[1].end = 60;
    run[2].waits = {wait(500, 2, 50), wait(500, 49.99, 50), wait(501, 0, 70)};
    run[2].end = 70;
    const auto path = criticalPath(run);
    ASSERT_FALSE(path.empty());
    EXPECT_EQ(path.back().to, 70);
    for (std::size_t i = 1; i < path.size(); ++i) EXPECT_LE(path[i - 1].from, path[i].from);
}

}  // namespace
}  // namespace polyturn::hmi
