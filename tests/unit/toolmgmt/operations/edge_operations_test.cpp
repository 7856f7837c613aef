// Cutting edges of tools ($TC_DPx, sinumerik_part1 6.4 to 6.7) as a setter enters them: the same
// services as the offset table has.
#include "../tools/tool_rig.hpp"

namespace {

using namespace polyturn;
using polyturn::test::Json;
using polyturn::test::ToolRig;

double dp(const ToolRig& rig, int tool, int edge, int parameter) {
    const ToolEdge* found = toolmgmt::find_edge(*rig.values, tool, edge);
    return found ? found->dp[static_cast<std::size_t>(parameter)] : 0.0;
}

struct EdgeRig : ToolRig {
    int tool = 0;
    EdgeRig() {
        set("PT_LANGUAGE L1=sinumerik");
        tool = add({{"name", "ROUGH_80"},
                    {"D1.DP1", 500},
                    {"D1.DP2", 3},
                    {"D1.DP3", 120},
                    {"D1.DP4", 40},
                    {"D1.DP6", 0.8},
                    {"D2.DP1", 200},
                    {"D2.DP3", 90}});
    }
    Json request(const char* what, Json more) const {
        Json out = {{"do", what}, {"channel", 1}, {"tool", tool}, {"edge", 1}};
        out.update(more);
        return out;
    }
};

TEST(Edges, AreEnteredAsTheOffsetsAre) {
    EdgeRig rig;
    ASSERT_TRUE(rig.run(rig.request("offsets.set", {{"dp", 12}, {"value", -0.02}}))) << rig.said();
    EXPECT_EQ(dp(rig, rig.tool, 1, 12), -0.02);
    EXPECT_EQ(rig.answer["what"], "tool 1 D1 DP12");  // by which the history finds it
    EXPECT_EQ(rig.answer["old"], 0);
    EXPECT_EQ(rig.answer["new"], -0.02);
    ASSERT_TRUE(
        rig.run(rig.request("offsets.set", {{"dp", 12}, {"value", 0.05}, {"incremental", true}})))
        << rig.said();
    EXPECT_NEAR(dp(rig, rig.tool, 1, 12), 0.03, 1e-12);
    // By table and axis: L1 of a turning tool lies along X in G18, L2 along Z (6.5).
    ASSERT_TRUE(
        rig.run(rig.request("offsets.set", {{"table", "wear"}, {"field", "Z"}, {"value", 0.1}})))
        << rig.said();
    EXPECT_EQ(dp(rig, rig.tool, 1, 13), 0.1);
    // G19: L1 Z, L2 Y, L3 X
    ASSERT_TRUE(rig.run(rig.request(
        "offsets.set", {{"table", "geometry"}, {"field", "X"}, {"plane", 19}, {"value", 7}})))
        << rig.said();
    EXPECT_EQ(dp(rig, rig.tool, 1, 5), 7);
    // A drill has one length, in G18 along Y: there is nothing for X, unless SD42950 says turning.
    Json drill = rig.request("offsets.set", {{"field", "X"}, {"value", 91}});
    drill["edge"] = 2;
    EXPECT_FALSE(rig.run(drill));
    rig.set("SD42950 L1=2");
    ASSERT_TRUE(rig.run(drill)) << rig.said();
    EXPECT_EQ(dp(rig, rig.tool, 2, 3), 91);
}

TEST(Edges, KeepToTheRulesOfOffsets) {
    EdgeRig rig;
    const auto enter = [&](int parameter, double value, UserLevel level = UserLevel::Maker,
                           int edge = 1) {
        Json request = rig.request("offsets.set", {{"dp", parameter}, {"value", value}});
        request["edge"] = edge;
        return rig.run(request, level);
    };
    EXPECT_TRUE(enter(12, 0.9));
    EXPECT_FALSE(enter(12, 1.2));  // N1415 = 0: one millimetre
    EXPECT_FALSE(enter(15, -1.2));
    EXPECT_TRUE(enter(3, 121.2));  // geometry has no such limit
    rig.set("PT_WEAR_STEP L1=0.1");
    EXPECT_FALSE(enter(12, 0.7));
    EXPECT_TRUE(enter(12, 0.8));
    EXPECT_FALSE(enter(3, 121, UserLevel::Operator));
    EXPECT_EQ(rig.faults[0].diagnosis.alarm, Alarm::LevelTooLow);
    EXPECT_TRUE(enter(12, 0.75, UserLevel::Operator)) << rig.said();
    EXPECT_FALSE(enter(2, 9.5));  // tips are 0 to 9
    EXPECT_FALSE(enter(36, 1));
    EXPECT_FALSE(enter(3, 1, UserLevel::Maker, 13));
    Json other = rig.request("offsets.set", {{"dp", 12}, {"value", 0}});
    other["tool"] = 7;
    EXPECT_FALSE(rig.run(other));
    EXPECT_EQ(rig.faults[0].diagnosis.alarm, Alarm::ToolMissing);
}

// machine = zero + value + length, along X in true lengths: standing at diameter 220 where the part
// measures 40, L1 is 90 with its wear and base.
TEST(Edges, AreMeasuredWithWearAndBase) {
    EdgeRig rig;
    ASSERT_TRUE(rig.run(rig.request("offsets.set", {{"dp", 12}, {"value", -0.5}})));
    ASSERT_TRUE(rig.run(rig.request("offsets.set", {{"dp", 21}, {"value", 10}})));
    // X as a radius
    rig.position = [](unsigned) { return std::optional<double>(110.0); };
    ASSERT_TRUE(rig.run(rig.request("offsets.measure", {{"field", "X"}, {"value", 40}})))
        << rig.said();
    EXPECT_NEAR(dp(rig, rig.tool, 1, 3), 90 + 0.5 - 10, 1e-9);
    rig.position = [](unsigned) { return std::optional<double>(-30.0); };
    ASSERT_TRUE(rig.run(rig.request("offsets.measure", {{"field", "Z"}, {"value", 5}})))
        << rig.said();
    EXPECT_NEAR(dp(rig, rig.tool, 1, 4), -35, 1e-9);
}

TEST(Edges, AreTouchedByTheToolSetter) {
    EdgeRig rig;
    rig.set("N3012 L1=1");
    rig.set("N0205 L1=60");  // X, negative direction
    rig.set("N0206 L1=60");
    const unsigned x = find_axis(rig.machine, 1, PlaneRole::BasicX)->number;
    rig.touch = [&](unsigned) {
        toolmgmt::Touch touch;
        touch.axis = x;
        touch.negative = true;
        touch.at = 80;
        return std::optional(touch);
    };
    ASSERT_TRUE(rig.run(rig.request("offsets.touch", Json::object()))) << rig.said();
    EXPECT_NEAR(dp(rig, rig.tool, 1, 3), 50, 1e-9);  // (160 - 60) / 2
    rig.touch = [&](unsigned) {
        toolmgmt::Touch touch;
        touch.axis = x;
        touch.negative = true;
        touch.at = 80.01;
        return std::optional(touch);
    };
    ASSERT_TRUE(rig.run(rig.request("offsets.touch", {{"table", "wear"}}))) << rig.said();
    EXPECT_NEAR(dp(rig, rig.tool, 1, 12), 0.01, 1e-9);
    EXPECT_NEAR(dp(rig, rig.tool, 1, 3), 50, 1e-9);
}

TEST(Edges, TakeTheRelativeCounterAndThePresetter) {
    EdgeRig rig;
    double at = 100;
    rig.position = [&](unsigned) { return std::optional(at); };
    ASSERT_TRUE(rig.run({{"do", "offsets.origin"}, {"channel", 1}})) << rig.said();
    at = 112.5;
    ASSERT_TRUE(rig.run(rig.request("offsets.relative", {{"field", "X"}}))) << rig.said();
    // a true length, although the counter shows 25
    EXPECT_NEAR(dp(rig, rig.tool, 1, 3), 12.5, 1e-9);
    ASSERT_TRUE(
        rig.run(rig.request("offsets.preset", {{"X", 55.5}, {"Z", 31.25}, {"R", 0.4}, {"T", 3}})))
        << rig.said();
    EXPECT_EQ(dp(rig, rig.tool, 1, 3), 55.5);
    EXPECT_EQ(dp(rig, rig.tool, 1, 4), 31.25);
    EXPECT_EQ(dp(rig, rig.tool, 1, 6), 0.4);
    EXPECT_EQ(dp(rig, rig.tool, 1, 2), 3);
    EXPECT_EQ(rig.answer["entries"].size(), 4u);
}

// Measured parts: the deviation of a diameter goes into L1 by half, of a length into L2 whole.
TEST(Edges, TakeTheCorrectionOfAMeasuredPart) {
    EdgeRig rig;
    ASSERT_TRUE(rig.run({{"do", "parts.add"},
                         {"fields",
                          {{"name", "seat"},
                           {"nominal", 40},
                           {"upper", 0.02},
                           {"lower", -0.02},
                           {"tool", rig.tool},
                           {"axis", "X"}}}}))
        << rig.said();
    ASSERT_TRUE(rig.run({{"do", "parts.measure"}, {"dimension", 1}, {"value", 40.012}}))
        << rig.said();
    EXPECT_EQ(rig.answer["edge"], 1);
    EXPECT_NEAR(rig.answer["proposal"].get<double>(), -0.006, 1e-9);
    ASSERT_TRUE(rig.run({{"do", "parts.accept"}, {"dimension", 1}}, UserLevel::Operator))
        << rig.said();
    EXPECT_NEAR(dp(rig, rig.tool, 1, 12), -0.006, 1e-9);
    EXPECT_EQ(rig.answer["what"], "tool 1 D1 DP12");
    ASSERT_TRUE(
        rig.run({{"do", "parts.set"}, {"dimension", 1}, {"fields", {{"axis", "Z"}, {"edge", 1}}}}))
        << rig.said();
    ASSERT_TRUE(rig.run({{"do", "parts.measure"}, {"dimension", 1}, {"value", 40.012}}))
        << rig.said();
    ASSERT_TRUE(rig.run({{"do", "parts.accept"}, {"dimension", 1}})) << rig.said();
    EXPECT_NEAR(dp(rig, rig.tool, 1, 13), -0.012, 1e-9);
}

// A new insert has no wear, and a life that is wear looks at the edges.
TEST(Edges, LoseTheirWearWithANewInsert) {
    EdgeRig rig;
    ASSERT_TRUE(rig.run({{"do", "tools.set"},
                         {"tool", rig.tool},
                         {"fields", {{"life_kind", "wear"}, {"life", 0.5}, {"warning", 0.1}}}}))
        << rig.said();
    ASSERT_TRUE(rig.run(rig.request("offsets.set", {{"dp", 13}, {"value", -0.3}}))) << rig.said();
    EXPECT_NEAR(rig.values->tool(rig.tool)->counter, 0.3, 1e-12);
    ASSERT_TRUE(rig.run(rig.request("offsets.set", {{"dp", 15}, {"value", 0.1}}))) << rig.said();
    ASSERT_TRUE(rig.run({{"do", "life.reset"}, {"tool", rig.tool}, {"channel", 1}})) << rig.said();
    EXPECT_EQ(dp(rig, rig.tool, 1, 13), 0);
    EXPECT_EQ(dp(rig, rig.tool, 1, 15), 0);
    EXPECT_EQ(dp(rig, rig.tool, 1, 3), 120);
    EXPECT_EQ(rig.values->tool(rig.tool)->counter, 0);
}

}  // namespace
