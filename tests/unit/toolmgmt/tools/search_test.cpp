// Which tool a T means: nct part 2, 30.4 and 30.5; sinumerik part 1, 5.2.
#include "tool_rig.hpp"

namespace {

using namespace polyturn;
using polyturn::test::ToolRig;
constexpr auto kType = ToolCallBy::Type;
int minus(Alarm alarm) { return -static_cast<int>(alarm); }

TEST(TCall, TakesTheSisterWithTheLeastLifeLeftAndThenTheNext) {
    ToolRig rig;
    const int first =
        rig.add({{"type", 5}, {"life_kind", "minutes"}, {"life", 60}, {"counter", 10}}, 1, 3);
    const int second =
        rig.add({{"type", 5}, {"life_kind", "minutes"}, {"life", 60}, {"counter", 40}}, 1, 4);
    EXPECT_EQ(rig.found(kType, 5), second);  // 20 min left, 50 in the other
    std::vector<toolmgmt::Change> changes;
    toolmgmt::use_up(*rig.values, second, LifeKind::Minutes, 20, changes);
    EXPECT_EQ(rig.found(kType, 5), first);
    EXPECT_EQ(tool_number(*rig.values->tool(second), tool_field("worn")), 1);
    toolmgmt::use_up(*rig.values, first, LifeKind::Minutes, 50, changes);
    EXPECT_EQ(rig.found(kType, 5), minus(Alarm::ToolsUsedUp));
    EXPECT_EQ(rig.found(kType, 6), minus(Alarm::ToolNotFound));
    ASSERT_TRUE(rig.run({{"do", "life.reset"}, {"tool", first}})) << rig.said();
    EXPECT_EQ(rig.found(kType, 5), first);
}

// nct part 2, 30.3: "the sum of Life less the sum of Life counter over all tools with the same type
// number".
TEST(TCall, TellsWhatIsLeftOfAllSistersLockedBrokenOrWornOut) {
    ToolRig rig;
    rig.add({{"type", 5}, {"life_kind", "minutes"}, {"life", 60}, {"counter", 10}}, 1, 3);
    const int locked = rig.add(
        {{"type", 5}, {"life_kind", "minutes"}, {"life", 60}, {"counter", 40}, {"locked", 1}}, 1,
        4);
    rig.add({{"type", 5}, {"life_kind", "minutes"}, {"life", 30}, {"counter", 35}}, 1, 5);
    rig.add({{"type", 6}, {"life_kind", "minutes"}, {"life", 90}}, 1, 6);
    EXPECT_NE(rig.found(kType, 5), locked);
    EXPECT_DOUBLE_EQ(rig.call(kType, 5).group_left, 50 + 20 - 5);
    rig.add({{"type", 5}}, 1, 7);  // one that is not watched lasts for ever
    EXPECT_TRUE(std::isinf(rig.call(kType, 5).group_left));
}

TEST(TCall, GoesByTheCustomColumnWhereTcuSaysSo) {
    ToolRig rig;
    rig.set("N2904=2");
    rig.set("N2901 L1=00000101");  // NM1 and TCU
    rig.add({{"type", 5}, {"custom2", 7}}, 1, 3);
    const int least = rig.add({{"type", 5}, {"custom2", 3}}, 1, 4);
    EXPECT_EQ(rig.found(kType, 5), least);
}

TEST(TCall, SearchesTheMagazinesOfTheChannelOnly) {
    ToolRig rig;
    const int upper = rig.add({{"type", 5}}, 1, 3), lower = rig.add({{"type", 5}}, 2, 3);
    EXPECT_EQ(rig.found(kType, 5, {}, 1), upper);
    EXPECT_EQ(rig.found(kType, 5, {}, 2), lower);
    ASSERT_TRUE(rig.run({{"do", "tools.unload"}, {"tool", lower}}));
    // NM1 is on, but magazine 1 is the other channel's turret
    EXPECT_EQ(rig.found(kType, 5, {}, 2), minus(Alarm::ToolNotFound));
}

// Where nobody works with type numbers T is a station; one in which nothing stands is "no such
// tool", not a turret that comes round with nothing.
TEST(TCall, OfAnEmptyStationIsNoTool) {
    ToolRig rig;
    EXPECT_EQ(rig.found(kType, 5), minus(Alarm::ToolNotFound));
    const int tool = rig.add({{"name", "ROUGH"}}, 1, 5);
    EXPECT_EQ(rig.found(kType, 5), tool);
    EXPECT_EQ(rig.found(kType, 6), minus(Alarm::ToolNotFound));
    EXPECT_EQ(rig.found(kType, 0), 0) << "T0 puts the tool away";
}

TEST(TCall, OfAUnitSeesTheToolsOfThatUnitAndThoseOfAll) {
    ToolRig rig;
    rig.set("PT_TOOL_UNIT L1=2");
    rig.add({{"type", 5}, {"unit", 1}}, 1, 3);
    EXPECT_EQ(rig.found(kType, 5), minus(Alarm::ToolNotFound));
    const int own = rig.add({{"type", 5}, {"unit", 2}}, 1, 4);
    EXPECT_EQ(rig.found(kType, 5), own);
}

TEST(TCall, NamesAPlaceByFourAndFourDigits) {
    ToolRig rig;
    const int tool = rig.add({{"type", 5}}, 2, 11);
    const ToolAnswer there = rig.call(ToolCallBy::Place, 20011);
    EXPECT_EQ(there.tool, tool);
    EXPECT_EQ(there.magazine, 2);
    EXPECT_EQ(there.pot, 11);
    EXPECT_EQ(rig.found(ToolCallBy::Place, 20012), 0);  // empty: the place comes into position
    EXPECT_EQ(rig.found(ToolCallBy::Place, 20013), minus(Alarm::ToolPlaceUnknown));
}

TEST(TCall, NamesAnyPlaceWhereNoMagazineIsDescribed) {
    ToolRig rig;
    for (const char* line : {"PT_TURRET_MAGAZINE L1=0", "PT_TURRET_MAGAZINE L2=0"}) rig.set(line);
    const ToolAnswer there = rig.call(ToolCallBy::Place, 123456);
    EXPECT_LT(there.alarm, 0);
    EXPECT_EQ(there.magazine, 12);
    EXPECT_EQ(there.pot, 3456);
}

TEST(TCall, IsTheStationWhereNobodyUsesTypeNumbers) {
    ToolRig rig;
    const int tool = rig.add({{"name", "ROUGH"}}, 1, 7);
    EXPECT_EQ(rig.found(kType, 7), tool);
    EXPECT_EQ(rig.found(kType, 8), minus(Alarm::ToolNotFound)) << "nothing stands there";
    EXPECT_EQ(rig.found(kType, 13), minus(Alarm::ToolNotFound));
    EXPECT_EQ(rig.call(kType, 0).magazine, 0);
}

// sinumerik part 1, 5.2.1: ROUGH/1 at 5 worn, ROUGH/2 at 7 enabled, ROUGH/3 at 6 active.
TEST(TCall, ByLocationFindsTheNameThereAndSearchesByTheStrategy) {
    ToolRig rig;
    rig.add({{"name", "ROUGH"}, {"duplo", 1}, {"locked", 1}}, 1, 5);
    const int second = rig.add({{"name", "ROUGH"}, {"duplo", 2}}, 1, 7);
    const int third = rig.add({{"name", "ROUGH"}, {"duplo", 3}, {"active", 1}}, 1, 6);
    rig.set("PT_TOOL_SEARCH L1=1");
    EXPECT_EQ(rig.found(ToolCallBy::Location, 5), third);
    rig.set("PT_TOOL_SEARCH L1=2");
    EXPECT_EQ(rig.found(ToolCallBy::Location, 5), second);
    EXPECT_EQ(rig.found(ToolCallBy::Name, 0, "rough"), minus(Alarm::ToolNotFound));  // case counts
    // an empty place acts like T0
    EXPECT_EQ(rig.found(ToolCallBy::Location, 4), 0);
    // whatever its state
    EXPECT_EQ(rig.found(ToolCallBy::Forced, 1), 1);
}

TEST(TCall, TakesTheNextHigherDuploAfterTheActiveOne) {
    ToolRig rig;
    rig.set("PT_TOOL_SEARCH L1=1");
    const int one = rig.add({{"name", "R"}, {"duplo", 1}}, 1, 1);
    const int two = rig.add({{"name", "R"}, {"duplo", 2}, {"active", 1}}, 1, 2);
    const int three = rig.add({{"name", "R"}, {"duplo", 3}}, 1, 3);
    EXPECT_EQ(rig.found(ToolCallBy::Name, 0, "R"), two);
    rig.values->tool(two)->state |= kToolWorn;
    EXPECT_EQ(rig.found(ToolCallBy::Name, 0, "R"), three);
    rig.values->tool(three)->state |= kToolBroken;
    EXPECT_EQ(rig.found(ToolCallBy::Name, 0, "R"), one);
}

TEST(TCall, OfALifeGroupTakesItsToolsInOrder) {
    ToolRig rig;
    const int second = rig.add({{"group", 3}, {"duplo", 2}}, 1, 1),
              first =
                  rig.add({{"group", 3}, {"duplo", 1}, {"life_kind", "uses"}, {"life", 1}}, 1, 2);
    EXPECT_EQ(rig.found(ToolCallBy::Group, 3), first);
    std::vector<toolmgmt::Change> changes;
    toolmgmt::use_up(*rig.values, first, LifeKind::Uses, 1, changes);
    EXPECT_EQ(rig.found(ToolCallBy::Group, 3), second);
}

TEST(Places, AreBlockedByToolsThatNeedTheRoomBesideThem) {
    ToolRig rig;
    rig.add({{"size_right", 2}}, 1, 3);  // reaches over the left half of place 4
    const int normal = rig.add({{"name", "normal"}});
    EXPECT_FALSE(rig.run({{"do", "tools.load"}, {"tool", normal}, {"magazine", 1}, {"pot", 4}}));
    EXPECT_EQ(rig.faults[0].diagnosis.alarm, Alarm::ToolPlaceSmall);
    EXPECT_EQ(rig.values->tool(normal)->magazine, 0);
    EXPECT_TRUE(rig.run({{"do", "tools.load"}, {"tool", normal}, {"magazine", 1}, {"pot", 5}}))
        << rig.said();
    const int left = rig.add({{"size_left", 2}});  // 12 and 1 are neighbours: a ring
    rig.add({{"name", "last"}}, 1, 12);
    EXPECT_FALSE(rig.run({{"do", "tools.load"}, {"tool", left}, {"magazine", 1}, {"pot", 1}}));
}

TEST(Places, OfAMatrixHaveNeighboursAboveAndBelow) {
    ToolRig rig;
    // magazine 3: 3 rows of 4
    for (const char* line : {"N2905=00000100", "N2918=3", "N2919=4"}) rig.set(line);
    rig.add({{"size_down", 2}}, 3, 2);
    const int tool = rig.add({});
    // below it
    EXPECT_FALSE(rig.run({{"do", "tools.load"}, {"tool", tool}, {"magazine", 3}, {"pot", 6}}));
    EXPECT_TRUE(rig.run({{"do", "tools.load"}, {"tool", tool}, {"magazine", 3}, {"pot", 7}}))
        << rig.said();
    EXPECT_TRUE(rig.run({{"do", "tools.unload"}, {"tool", tool}}));
    EXPECT_FALSE(rig.run({{"do", "tools.load"}, {"tool", tool}, {"magazine", 3}, {"pot", 13}}));
    EXPECT_EQ(rig.faults[0].diagnosis.alarm, Alarm::ToolPlaceUnknown);
}

TEST(Places, OfHalfStationsLieBetweenTheOthers) {
    ToolRig rig;
    rig.set("PT_TURRET_HALF L1=1");
    rig.set("PT_TURRET_STATIONS L1=24");
    rig.add({}, 1, 3);
    const int slim = rig.add({{"size_left", 0.5}, {"size_right", 0.5}});
    // half station behind 3: 1 + 0.5 > 1
    EXPECT_FALSE(rig.run({{"do", "tools.load"}, {"tool", slim}, {"magazine", 1}, {"pot", 15}}));
    EXPECT_TRUE(rig.run({{"do", "tools.load"}, {"tool", slim}, {"magazine", 1}, {"pot", 16}}))
        << rig.said();
    toolmgmt::derive_places(*rig.values, *rig.places);
    EXPECT_EQ(toolmgmt::travel_between(*rig.places, *toolmgmt::find_place(*rig.places, 1, 3),
                                       *toolmgmt::find_place(*rig.places, 1, 15)),
              0.5);
    EXPECT_EQ(toolmgmt::travel_between(*rig.places, *toolmgmt::find_place(*rig.places, 1, 1),
                                       *toolmgmt::find_place(*rig.places, 1, 12)),
              -1.0);
}

TEST(Places, AreFoundNearestAndRefusedByKind) {
    ToolRig rig;
    rig.add({}, 1, 1);
    const int second = rig.add({});
    EXPECT_TRUE(rig.run({{"do", "tools.load"}, {"tool", second}})) << rig.said();
    EXPECT_EQ(rig.answer["pot"], 2);
    ASSERT_TRUE(rig.run({{"do", "tools.place"}, {"magazine", 1}, {"pot", 3}, {"place_type", 2}}));
    ASSERT_TRUE(rig.run({{"do", "tools.place"}, {"magazine", 1}, {"pot", 4}, {"locked", 1}}));
    const int third = rig.add({{"place_type", 1}});
    EXPECT_TRUE(rig.run({{"do", "tools.load"}, {"tool", third}})) << rig.said();
    EXPECT_EQ(rig.answer["pot"], 12);  // a ring: 12 is as near to 1 as 2
}

TEST(Spindle, TakesTheToolOnM06AndGivesTheOldOneItsPlaceBack) {
    ToolRig rig;
    for (const char* line :
         {"PT_TURRET_MAGAZINE L1=0", "PT_DRIVEN_SPINDLE L1=3", "N2910=8", "N2922 S3=00000001"})
        rig.set(line);
    const int first = rig.add({{"type", 5}}, 1, 2), second = rig.add({{"type", 6}}, 1, 4);
    const auto tell = [&](StoreRequestKind kind, int tool, int field) {
        StoreRequest request{};
        request.kind = static_cast<std::uint32_t>(kind);
        request.channel = 1;
        request.number = tool;
        request.field = field;
        ASSERT_TRUE(toolmgmt::apply_tool_request(request, *rig.values));
    };
    tell(StoreRequestKind::ToolInPlace, first, 0);
    EXPECT_EQ(rig.values->tools.in_channel[0], 0);  // called, not yet changed
    tell(StoreRequestKind::ToolChanged, first, 0);
    EXPECT_EQ(rig.values->tools.in_channel[0], first);
    EXPECT_EQ(rig.values->tool(first)->magazine, 30);
    tell(StoreRequestKind::ToolInPlace, second, 0);
    tell(StoreRequestKind::ToolChanged, second, 0);
    EXPECT_EQ(rig.values->tool(second)->magazine, 30);
    EXPECT_EQ(rig.values->tool(first)->magazine, 1);
    EXPECT_EQ(rig.values->tool(first)->pot, 2);
    EXPECT_FALSE(rig.run({{"do", "tools.unload"}, {"tool", second}}));  // it works
}

}  // namespace
