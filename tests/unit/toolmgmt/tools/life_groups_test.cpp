// Tool life groups that a program registers (G10 L3 ... G11), and calls of a group.
#include "tool_rig.hpp"

namespace {

using namespace polyturn;
using polyturn::test::ToolRig;

struct Groups : ToolRig {
    Result<toolmgmt::Applied> step(LifeGroupStep what, int group, double value = 0,
                                   LifeKind kind = LifeKind::Uses, const char* text = "",
                                   unsigned channel = 1) {
        StoreRequest request{};
        request.kind = static_cast<std::uint32_t>(StoreRequestKind::LifeGroup);
        request.channel = channel;
        request.number = group;
        request.value = value;
        request.field = static_cast<int>(what) + 16 * static_cast<int>(kind);
        put_name(request, text);
        return toolmgmt::apply_tool_request(request, *values);
    }
    const ToolRow& row(int tool) { return *values->tool(tool); }
};

TEST(LifeGroups, TakeTheirToolsInTheOrderOfTheProgram) {
    Groups g;
    const int standing = g.add({{"name", "ROUGH"}, {"counter", 7}, {"worn", 1}}, 1, 4);
    ASSERT_TRUE(g.step(LifeGroupStep::ForgetAll, 0));
    ASSERT_TRUE(g.step(LifeGroupStep::Open, 5, 20));
    // station 6 is empty: the tool is entered
    ASSERT_TRUE(g.step(LifeGroupStep::Tool, 5, 6, LifeKind::Uses, "16 1 20"));
    ASSERT_TRUE(g.step(LifeGroupStep::Tool, 5, 4, LifeKind::Uses, "14 2 20"));
    const ToolAnswer first = g.call(ToolCallBy::Group, 5);
    ASSERT_EQ(first.alarm, -1);
    EXPECT_EQ(first.pot, 6);
    EXPECT_EQ(first.offset, 16);
    EXPECT_EQ(first.left, 20);
    EXPECT_EQ(first.group, 5);
    std::vector<toolmgmt::Change> changes;
    toolmgmt::use_up(*g.values, first.tool, LifeKind::Uses, 20, changes);
    EXPECT_EQ(g.found(ToolCallBy::Group, 5), standing);
    EXPECT_EQ(g.row(standing).counter, 0);  // registered again: its life begins anew
    toolmgmt::use_up(*g.values, standing, LifeKind::Uses, 20, changes);
    EXPECT_EQ(g.found(ToolCallBy::Group, 5), -static_cast<int>(Alarm::ToolsUsedUp));
    EXPECT_EQ(g.found(ToolCallBy::Group, 6), -static_cast<int>(Alarm::ToolNotFound));
}

TEST(LifeGroups, OfAnotherChannelStayWhenAllAreForgotten) {
    Groups g;
    g.set("PT_TOOL_UNIT L2=2");
    ASSERT_TRUE(g.step(LifeGroupStep::Open, 1, 10, LifeKind::Minutes, "", 2));
    ASSERT_TRUE(g.step(LifeGroupStep::Tool, 1, 3, LifeKind::Minutes, "3 1 10", 2));
    ASSERT_TRUE(g.step(LifeGroupStep::ForgetAll, 0));
    EXPECT_EQ(g.call(ToolCallBy::Group, 1, {}, 2).alarm, -1);
    ASSERT_TRUE(g.step(LifeGroupStep::Forget, 1, 0, LifeKind::None, "", 2));
    EXPECT_EQ(g.found(ToolCallBy::Group, 1, {}, 2), -static_cast<int>(Alarm::ToolNotFound));
}

TEST(LifeGroups, WhatCannotBeIsRefused) {
    Groups g;
    EXPECT_FALSE(g.step(LifeGroupStep::Open, 0));
    EXPECT_FALSE(g.step(LifeGroupStep::Tool, 3, 13, LifeKind::Uses, "3 1 10"));  // twelve stations
    EXPECT_FALSE(g.step(LifeGroupStep::Tool, 3, 2, LifeKind::Uses, "x"));
    EXPECT_FALSE(g.step(LifeGroupStep::Tool, 3, 2, LifeKind::Uses, "3 1 -1"));
    EXPECT_FALSE(g.step(LifeGroupStep::Open, 3, 1, LifeKind::Uses, "", 99));
    g.set("PT_TURRET_MAGAZINE L1=0");
    EXPECT_FALSE(g.step(LifeGroupStep::Tool, 3, 2, LifeKind::Uses, "3 1 10"));
}

TEST(TCall, OfAFamilyTakesTheToolItselfUntilItsLifeIsOver) {
    ToolRig rig;
    const int first = rig.add({{"type", 5}, {"life_kind", "uses"}, {"life", 2}}, 1, 3),
              second = rig.add({{"type", 5}}, 1, 4);
    EXPECT_EQ(rig.found(ToolCallBy::Substitute, first), first);
    EXPECT_EQ(rig.found(ToolCallBy::Substitute, second), second);
    std::vector<toolmgmt::Change> changes;
    toolmgmt::use_up(*rig.values, first, LifeKind::Uses, 2, changes);
    EXPECT_EQ(rig.found(ToolCallBy::Substitute, first), second);
    ASSERT_TRUE(rig.run({{"do", "tools.set"}, {"tool", second}, {"fields", {{"locked", "1"}}}}))
        << rig.said();
    EXPECT_EQ(rig.found(ToolCallBy::Substitute, first), -static_cast<int>(Alarm::ToolsUsedUp));
}

// The setter on the machine: what is shown, and what is written (nct part 1 4.3, part 2 31).
struct Touching : ToolRig {
    toolmgmt::Touch at{1, true, 1, 60.125, 0};  // A1 is X of L1, a diameter axis
    Touching() {
        set("N3012 L1=3");
        set("N0205 L1=100");  // the face that a tool touches in -X
        set("N0212 L1=55");   // at the counter spindle, in +X
        machine = derive_machine_config(values->parameters);
        touch = [this](unsigned) { return std::optional(at); };
    }
    double geometry(int n, std::size_t field) {
        return values->channels[0].offsets[static_cast<std::size_t>(n)].geometry[field];
    }
};

TEST(ToolSetter, WritesTheOffsetThatPutsTheTipOnTheContactFace) {
    Touching t;
    t.values->channels[0].offsets[7].wear[0] = 0.05;
    t.values->channels[0].offsets[7].geometry[0] = 20;
    ASSERT_TRUE(t.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 7}})) << t.said();
    EXPECT_NEAR(t.answer.value("new", 0.0), 2 * 60.125 - 100 - 0.05, 1e-9);
    EXPECT_EQ(t.answer.value("old", 0.0), 20);
    EXPECT_NEAR(t.answer.value("difference", 0.0), t.answer.value("new", 0.0) - 20, 1e-9);
    EXPECT_NEAR(t.geometry(7, 0), 20.2, 1e-9);
    t.at = {1, false, 2, 60.125, 0};
    ASSERT_TRUE(t.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 8}})) << t.said();
    EXPECT_NEAR(t.geometry(8, 0), 65.25, 1e-9);
}

TEST(ToolSetter, TheOffsetIsThePlcsWhereOnsSaysSo) {
    Touching t;
    t.set("N3016 L1=00000001");
    t.at.plc_offset = 9;
    ASSERT_TRUE(t.run({{"do", "offsets.touch"}, {"channel", 1}})) << t.said();
    EXPECT_NEAR(t.geometry(9, 0), 20.25, 1e-9);
    EXPECT_FALSE(t.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 8}}));
}

TEST(ToolSetter, SaysWhatIsMissing) {
    Touching t;
    t.at.axis = 0;
    EXPECT_FALSE(t.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 7}}));
    EXPECT_EQ(t.faults[0].diagnosis.alarm, Alarm::SetterNoTouch);
    t.set("N3012 L1=0");
    EXPECT_FALSE(t.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 7}}));
    EXPECT_EQ(t.faults[0].diagnosis.alarm, Alarm::SetterUnset);
    Touching operator_only;
    // geometry is the setter's
    EXPECT_FALSE(operator_only.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 7}},
                                   UserLevel::Operator));
    EXPECT_EQ(operator_only.faults[0].diagnosis.alarm, Alarm::LevelTooLow);
}

}  // namespace
