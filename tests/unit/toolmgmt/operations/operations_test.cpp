#include <random>
// Operations of the store: all of it or nothing, every fault named.
#include <set>

#include "../tools/tool_rig.hpp"
#include "ipc/requests/store_requests.hpp"
#include "polyturn/parameter_handles.hpp"
#include "tests/seeds.hpp"
#include "toolmgmt/apply_request.hpp"
#include "toolmgmt/operations/restore_diff.hpp"

namespace {

using namespace polyturn;
using polyturn::test::Json;
using polyturn::test::ToolRig;

std::string forty_rows() {
    std::string text = "tool,name,type,life_kind,life,magazine,pot,D1.DP3\n";
    for (int n = 1; n <= 40; ++n)
        text += std::to_string(n) + ",TOOL" + std::to_string(n) + "," + std::to_string(n) +
                ",minutes,60," + (n <= 12 ? "1," + std::to_string(n) : "0,0") + ",12.5\n";
    return text;
}

TEST(Import, OfAnErrorInRow37ChangesNothingAndNamesRowAndColumn) {
    ToolRig rig;
    std::string text = forty_rows();
    // the heading is row 1
    const std::string good = "\n36,TOOL36,36,minutes,60,", bad = "\n36,TOOL36,36,minutes,-60,";
    text.replace(text.find(good), good.size(), bad);
    EXPECT_FALSE(rig.run({{"do", "tools.import"}, {"text", text}}));
    ASSERT_EQ(rig.faults.size(), 1u) << rig.said();
    EXPECT_EQ(rig.faults[0].row, 37);
    EXPECT_EQ(rig.faults[0].column, "life");
    for (const ToolRow& row : rig.values->tools.rows) ASSERT_FALSE(row.used);
    EXPECT_TRUE(rig.run({{"do", "tools.import"}, {"text", forty_rows()}})) << rig.said();
    EXPECT_EQ(rig.values->tool(36)->life, 60);
    EXPECT_EQ(rig.values->tool(12)->pot, 12);
    EXPECT_EQ(toolmgmt::find_edge(*rig.values, 7, 1)->dp[3], 12.5);
}

TEST(Import, NamesEveryFaultAtOnce) {
    ToolRig rig;
    EXPECT_FALSE(rig.run({{"do", "tools.import"},
                          {"text",
                           "tool,name,life,magazine,pot,weight\n"
                           "1,A,ten,1,1,2\n"  // row 2: life
                           // row 3: the place of tool 1
                           "2,B,10,1,1,1\n"
                           // row 4: tool twice
                           "2,C,10,1,2,1\n"
                           // row 5: no such magazine
                           "4,D,10,9,1,1\n"
                           // row 6: weight in grams?
                           "5,E,10,1,3,5000\n"
                           // row 7: fields missing
                           "6,F,10,1\n"}}));
    std::set<int> rows;
    for (const auto& fault : rig.faults) rows.insert(fault.row);
    EXPECT_EQ(rows, (std::set<int>{2, 3, 4, 5, 6, 7})) << rig.said();
    for (const ToolRow& row : rig.values->tools.rows) ASSERT_FALSE(row.used);
}

TEST(Export, AsCsvReadsInAgainToTheSameTools) {
    ToolRig rig;
    ASSERT_TRUE(rig.run({{"do", "tools.import"}, {"text", forty_rows()}})) << rig.said();
    ASSERT_TRUE(
        rig.run({{"do", "tools.set"},
                 {"tool", 3},
                 {"fields", {{"outline", "X -60:0 Z -20:5"}, {"custom2", 4.25}, {"D2.DP6", 0.8}}}}))
        << rig.said();
    ASSERT_TRUE(rig.run({{"do", "tools.export"}}));
    const std::string text = rig.answer["text"];
    ToolRig other;
    ASSERT_TRUE(other.run({{"do", "tools.import"}, {"text", text}})) << other.said();
    std::vector<toolmgmt::Change> left = toolmgmt::changes_between(*other.values, *rig.values);
    for (const auto& change : left) ADD_FAILURE() << toolmgmt::describe(change.key);
}

TEST(Export, AsSinumerikProgramReadsInAgain) {
    ToolRig rig;
    rig.add({{"name", "ROUGH_80"},
             {"duplo", 2},
             {"life_kind", "minutes"},
             {"life", 60},
             {"counter", 12.5},
             {"warning", 5},
             {"locked", 1},
             {"D1.DP1", 500},
             {"D1.DP2", 3},
             {"D1.DP6", 0.8}},
            1, 3);
    ASSERT_TRUE(rig.run({{"do", "tools.export"}, {"format", "sinumerik"}}));
    const std::string text = rig.answer["text"];
    EXPECT_NE(text.find("$TC_TP2[1]=\"ROUGH_80\""), std::string::npos) << text;
    EXPECT_NE(text.find("$TC_MPP6[1,3]=1"), std::string::npos) << text;
    ToolRig other;
    ASSERT_TRUE(other.run({{"do", "tools.import"}, {"format", "sinumerik"}, {"text", text}}))
        << other.said();
    for (const auto& change : toolmgmt::changes_between(*other.values, *rig.values))
        ADD_FAILURE() << toolmgmt::describe(change.key);
    EXPECT_FALSE(other.run({{"do", "tools.import"},
                            {"format", "sinumerik"},
                            {"text", "$TC_TP1[1]=1\n$TC_XX9[1]=3\n"}}));
    EXPECT_EQ(other.faults[0].row, 2);
    EXPECT_EQ(other.faults[0].column, "$TC_XX9[1]");
}

TEST(Export, AsFanucProgramCarriesOffsetsAndLifeGroups) {
    ToolRig rig;
    ASSERT_TRUE(rig.run(
        {{"do", "offsets.set"}, {"channel", 1}, {"number", 3}, {"field", "X"}, {"value", -12.3}}))
        << rig.said();
    ASSERT_TRUE(rig.run({{"do", "offsets.set"},
                         {"channel", 1},
                         {"number", 3},
                         {"table", "wear"},
                         {"field", "X"},
                         {"value", 0.02}}))
        << rig.said();
    rig.add(Json(
        {{"type", 1}, {"group", 2}, {"h", 3}, {"d", 3}, {"life_kind", "minutes"}, {"life", 45}}));
    ASSERT_TRUE(rig.run({{"do", "tools.export"}, {"format", "fanuc"}, {"channel", 1}}))
        << rig.said();
    const std::string text = rig.answer["text"];
    EXPECT_NE(text.find("G10 P10003 X-12.3"), std::string::npos) << text;
    EXPECT_NE(text.find("G10 P3 X0.02"), std::string::npos) << text;
    EXPECT_NE(text.find("P2 L45 Q2\nT0103"), std::string::npos) << text;
    ToolRig other;
    ASSERT_TRUE(
        other.run({{"do", "tools.import"}, {"format", "fanuc"}, {"channel", 1}, {"text", text}}))
        << other.said();
    EXPECT_EQ(other.values->channels[0].offsets[3].geometry[0], -12.3);
    EXPECT_EQ(other.values->tool(1)->group, 2);
    EXPECT_EQ(other.values->tool(1)->life, 45);
    EXPECT_FALSE(other.run({{"do", "tools.import"},
                            {"format", "fanuc"},
                            {"channel", 1},
                            {"text", "%\nG10 P3 X1.5\nG10 P3 K2.\nG1 X5.\n"}}));
    EXPECT_EQ(other.faults.size(), 2u) << other.said();
}

TEST(Offsets, KeepToTheLimitsOfWear) {
    ToolRig rig;
    const Json set = {{"do", "offsets.set"}, {"channel", 1}, {"number", 3},
                      {"table", "wear"},     {"field", "X"}, {"value", 1.2}};
    EXPECT_FALSE(rig.run(set));  // N1415 = 0: one millimetre
    rig.set("N1415 L1=2");
    EXPECT_TRUE(rig.run(set)) << rig.said();
    rig.set("PT_WEAR_STEP L1=0.1");
    Json step = set;
    step["value"] = 0.2;
    step["incremental"] = true;
    EXPECT_FALSE(rig.run(step));
    step["value"] = -0.1;
    EXPECT_TRUE(rig.run(step)) << rig.said();
    EXPECT_NEAR(rig.values->channels[0].offsets[3].wear[0], 1.1, 1e-12);
    Json geometry = set;
    geometry["table"] = "geometry";
    EXPECT_FALSE(rig.run(geometry, UserLevel::Operator));
    EXPECT_EQ(rig.faults[0].diagnosis.alarm, Alarm::LevelTooLow);
}

TEST(MeasuredParts, ProposeALimitedCorrectionWithTrendAndWriteItOnlyWhenAccepted) {
    ToolRig rig;
    const int tool = rig.add({{"name", "FINISH"}, {"h", 3}}, 1, 3);
    ASSERT_TRUE(rig.run({{"do", "parts.add"},
                         {"fields",
                          {{"name", "bearing seat"},
                           {"nominal", 40},
                           {"upper", 0.02},
                           {"lower", -0.02},
                           {"tool", tool},
                           {"axis", "X"},
                           {"limit", 0.03}}}}))
        << rig.said();
    for (const double value : {40.004, 40.008, 40.012})
        ASSERT_TRUE(rig.run({{"do", "parts.measure"}, {"dimension", 1}, {"value", value}}))
            << rig.said();
    EXPECT_NEAR(rig.answer["proposal"].get<double>(), -0.012, 1e-9);
    EXPECT_NEAR(rig.answer["trend"].get<double>(), 0.004, 1e-9);
    EXPECT_EQ(rig.answer["parts_to_limit"], 2);
    EXPECT_EQ(rig.values->channels[0].offsets[3].wear[0], 0);  // it proposes only
    ASSERT_TRUE(rig.run({{"do", "parts.accept"}, {"dimension", 1}})) << rig.said();
    EXPECT_NEAR(rig.values->channels[0].offsets[3].wear[0], -0.012, 1e-9);
    EXPECT_FALSE(rig.run({{"do", "parts.accept"}, {"dimension", 1}}));  // the next part first
    ASSERT_TRUE(rig.run({{"do", "parts.measure"}, {"dimension", 1}, {"value", 39.5}}));
    EXPECT_NEAR(rig.answer["proposal"].get<double>(), 0.03, 1e-9);
    EXPECT_TRUE(rig.answer["limited"]);
    EXPECT_EQ(rig.answer["verdict"], "too small");
    EXPECT_FALSE(rig.run({{"do", "parts.measure"}, {"dimension", 1}, {"value", 400}}));
}

TEST(MeasuredParts, AreBroughtToTheMiddleOfTheirTolerance) {  // 30 h6: 0 to -0.013
    ToolRig rig;
    const int tool = rig.add({{"name", "FINISH"}, {"h", 3}}, 1, 3);
    ASSERT_TRUE(rig.run({{"do", "parts.add"},
                         {"fields",
                          {{"name", "seat"},
                           {"nominal", 30},
                           {"upper", 0},
                           {"lower", -0.013},
                           {"tool", tool},
                           {"axis", "X"}}}}))
        << rig.said();
    for (const auto& [value, proposal] :
         {std::pair{30.001, -0.0075}, {30.0, -0.0065}, {29.9935, 0.0}, {29.985, 0.0085}}) {
        ASSERT_TRUE(rig.run({{"do", "parts.measure"}, {"dimension", 1}, {"value", value}}))
            << rig.said();
        EXPECT_NEAR(rig.answer["proposal"].get<double>(), proposal, 1e-9) << value;
    }
}

TEST(Users, AreLockedOutAfterWrongPasswordsAndKeepOneMaker) {
    ToolRig rig;
    // the first must be a maker
    EXPECT_FALSE(rig.run(
        {{"do", "users.add"}, {"name", "anna"}, {"level", "setter"}, {"password", "secret1"}}));
    ASSERT_TRUE(rig.run(
        {{"do", "users.add"}, {"name", "boss"}, {"level", "maker"}, {"password", "topsecret"}}))
        << rig.said();
    ASSERT_TRUE(rig.run(
        {{"do", "users.add"}, {"name", "anna"}, {"level", "setter"}, {"password", "secret1"}}))
        << rig.said();
    EXPECT_FALSE(rig.run({{"do", "users.delete"}, {"name", "boss"}}));
    ASSERT_TRUE(rig.run({{"do", "users.login"}, {"name", "anna"}, {"password", "secret1"}}));
    EXPECT_EQ(rig.answer["level"], 2);
    rig.set("PT_LOGIN_TRIES=3");
    for (int i = 0; i < 3; ++i)
        EXPECT_FALSE(rig.run(
            {{"do", "users.login"}, {"name", "anna"}, {"password", "guess" + std::to_string(i)}}));
    EXPECT_FALSE(rig.run({{"do", "users.login"}, {"name", "anna"}, {"password", "secret1"}}));
    EXPECT_EQ(rig.faults[0].diagnosis.alarm, Alarm::LoginLocked);
    // by a maker
    ASSERT_TRUE(rig.run({{"do", "users.password"}, {"name", "anna"}, {"new", "another1"}}))
        << rig.said();
    EXPECT_TRUE(rig.run({{"do", "users.login"}, {"name", "anna"}, {"password", "another1"}}));
    for (const auto& [key, cell] : rig.values->cells)
        EXPECT_EQ(cell.text.find("another1"), std::string::npos) << key.name;
    EXPECT_FALSE(rig.run({{"do", "users.list"}}, UserLevel::Setter));
}

// nct part 1 15.1: numbers up to N1412 mean one cell in all turning channels, whichever channel it
// is entered in.
TEST(Offsets, OfCommonNumbersAreOneCellForAllTurningChannels) {
    ToolRig rig;
    rig.set("N1412=3");
    ASSERT_TRUE(rig.run({{"do", "offsets.set"},
                         {"channel", 2},
                         {"number", 3},
                         {"table", "geometry"},
                         {"field", "Z"},
                         {"value", 7}}))
        << rig.said();
    ASSERT_TRUE(rig.run({{"do", "offsets.set"},
                         {"channel", 2},
                         {"number", 4},
                         {"table", "geometry"},
                         {"field", "Z"},
                         {"value", 8}}))
        << rig.said();
    EXPECT_EQ(rig.values->channels[0].offsets[3].geometry[2], 7);
    EXPECT_EQ(rig.values->channels[1].offsets[3].geometry[2], 0);
    EXPECT_EQ(rig.values->channels[1].offsets[4].geometry[2], 8);
    ASSERT_TRUE(rig.run({{"do", "offsets.set"},
                         {"channel", 2},
                         {"number", 3},
                         {"table", "wear"},
                         {"field", "X"},
                         {"value", 0.01}}));
    ASSERT_TRUE(rig.run({{"do", "offsets.set"},
                         {"channel", 1},
                         {"number", 3},
                         {"table", "wear"},
                         {"field", "X"},
                         {"value", 0.02},
                         {"incremental", true}}));
    EXPECT_DOUBLE_EQ(rig.answer["new"], 0.03);
    for (const int channel : {1, 2}) {
        ASSERT_TRUE(rig.run({{"do", "offsets.list"}, {"channel", channel}}));
        EXPECT_DOUBLE_EQ(rig.answer["offsets"][2]["wear"]["X"], 0.03);
        EXPECT_EQ(rig.answer["offsets"][2]["geometry"]["Z"], 7);
    }
    // as a program or a screen writes it
    const auto request = offset_request(2, 2, OffsetTable::Geometry, OffsetField::X, 5.0);
    const auto applied =
        toolmgmt::apply_request(request, toolmgmt::Origin::Operator, rig.machine, *rig.values);
    ASSERT_TRUE(applied);
    EXPECT_EQ(rig.values->channels[0].offsets[2].geometry[0], 5);
}

// nct part 2 30.1: N2903 free columns, the first always binary.
TEST(Tools, HaveAsManyFreeColumnsAsN2903SaysAndTheFirstHoldsBits) {
    ToolRig rig;
    const int tool = rig.add({{"custom1", "00000101"}, {"custom5", -2.5}});
    EXPECT_EQ(rig.values->tool(tool)->custom[0], 5);
    ASSERT_TRUE(rig.run({{"do", "tools.show"}, {"tool", tool}}));
    EXPECT_EQ(rig.answer["custom1"], "00000101");
    ASSERT_TRUE(rig.run({{"do", "tools.set"}, {"tool", tool}, {"fields", {{"custom1", 130}}}}));
    EXPECT_EQ(rig.answer["custom1"], "10000010");
    for (const Json& wrong : {Json(300), Json("2.5"), Json("00000102"), Json("-1")})
        EXPECT_FALSE(
            rig.run({{"do", "tools.set"}, {"tool", tool}, {"fields", {{"custom1", wrong}}}}))
            << wrong;
    EXPECT_FALSE(rig.run({{"do", "tools.set"}, {"tool", tool}, {"fields", {{"custom6", 1}}}}));
    EXPECT_NE(rig.said().find("N2903"), std::string::npos) << rig.said();
    ASSERT_TRUE(rig.run({{"do", "tools.fields"}}));
    EXPECT_EQ(rig.answer["fields"].back()["name"], "custom5");
}

TEST(Pallets, StandInOnePlaceAndExchangeWithTheirPrograms) {
    ToolRig rig;
    EXPECT_FALSE(rig.run({{"do", "pallets.list"}}));
    for (const char* line : {"N3300=00000011", "N3301=2", "N3302=2"}) rig.set(line);
    ASSERT_TRUE(rig.run({{"do", "pallets.set"},
                         {"row", 1},
                         {"fields", {{"pallet", 7}, {"program", "1234"}, {"custom1", 5}}}}))
        << rig.said();
    EXPECT_EQ(rig.answer["custom1"], "00000101");
    EXPECT_FALSE(rig.run({{"do", "pallets.set"}, {"row", 2}, {"fields", {{"pallet", 7}}}}));
    EXPECT_FALSE(rig.run({{"do", "pallets.set"}, {"row", 2}, {"fields", {{"program", "12"}}}}));
    EXPECT_FALSE(rig.run({{"do", "pallets.set"}, {"row", 5}, {"fields", {{"pallet", 8}}}}));
    ASSERT_TRUE(rig.run({{"do", "pallets.exchange"}, {"row", 1}, {"with", 4}})) << rig.said();
    ASSERT_TRUE(rig.run({{"do", "pallets.list"}}));
    EXPECT_EQ(rig.answer["pallets"][3]["program"], "1234");
    EXPECT_EQ(rig.answer["pallets"][3]["station"], "pool 2");
    EXPECT_EQ(rig.answer["pallets"][0]["pallet"], 0);
}

TEST(Life, ForecastsWhatStopsTheMachineFirst) {
    ToolRig rig;
    const int slow = rig.add({{"type", 5}, {"life_kind", "minutes"}, {"life", 100}}, 1, 3);
    const int fast =
        rig.add({{"type", 6}, {"life_kind", "pieces"}, {"life", 12}, {"counter", 2}}, 1, 4);
    ASSERT_TRUE(rig.run({{"do", "life.reset"}, {"tools", {slow}}}));
    rig.values->counters[0] = 20;          // total parts of L1
    rig.values->tool(slow)->counter = 40;  // two minutes a part: 30 parts left
    ASSERT_TRUE(rig.run({{"do", "life.report"}})) << rig.said();
    EXPECT_EQ(rig.answer["stops_first"]["group"], "T6");
    for (const auto& group : rig.answer["groups"])
        EXPECT_EQ(group["parts_left"], group["group"] == "T5" ? 30 : fast ? 10 : 0) << group.dump();

    // Sisters that take turns use up one piece a part between them, also after a new insert.
    const int sister = rig.add({{"type", 6}, {"life_kind", "pieces"}, {"life", 12}}, 1, 5);
    rig.values->counters[0] = 32;
    // twelve parts: ten by the first
    rig.values->tool(fast)->counter = 12;
    rig.values->tool(sister)->counter = 2;
    ASSERT_TRUE(rig.run({{"do", "life.reset"}, {"tools", {fast}}}));
    rig.values->counters[0] = 34;
    rig.values->tool(sister)->counter = 4;
    ASSERT_TRUE(rig.run({{"do", "life.report"}})) << rig.said();
    for (const auto& group : rig.answer["groups"])
        // 14 pieces in the 34 parts since it was entered
        if (group["group"] == "T6") {
            EXPECT_EQ(group["parts_left"], 20 * 34 / 14) << group.dump();
        }
}

// Minutes and pieces are never added: such a group tells the parts that are left, and no amount.
TEST(Life, OfSistersInDifferentUnitsIsForecastInPartsOnly) {
    ToolRig rig;
    const int timed = rig.add({{"type", 5}, {"life_kind", "minutes"}, {"life", 10}}, 1, 3);
    rig.add({{"type", 5}, {"duplo", 2}, {"life_kind", "pieces"}, {"life", 7}}, 1, 4);
    ASSERT_TRUE(rig.run({{"do", "life.reset"}, {"tools", {timed}}}));
    rig.values->counters[0] = 4;
    // half a minute a part: 16 parts are left of it, and 7 of the other
    rig.values->tool(timed)->counter = 2;
    ASSERT_TRUE(rig.run({{"do", "life.report"}})) << rig.said();
    const Json& group = rig.answer["groups"][0];
    EXPECT_FALSE(group.contains("left")) << group;
    EXPECT_EQ(group["unit"], "mixed");
    EXPECT_EQ(group["parts_left"], 23);
}

// sinumerik part 1, 5.2.1: what stands at a station need not be what its call finds. Magazine 3 is
// a matrix that L1 reaches and L2 does not.
TEST(Answers, OfAChannelAreThoseOfItsCalls) {
    ToolRig rig;
    for (const char* line :
         {"N2905=00000100", "N2918=3", "N2919=4", "N2901 L1=00010000", "PT_TOOL_SEARCH L1=1"})
        rig.set(line);
    rig.add({{"name", "ROUGH"}, {"duplo", 1}, {"locked", 1}}, 1, 5);
    rig.add({{"name", "ROUGH"}, {"duplo", 2}}, 1, 7);
    const int active = rig.add({{"name", "ROUGH"}, {"duplo", 3}, {"active", 1}}, 1, 6);
    rig.add({{"name", "DRILL"}, {"locked", 1}}, 1, 2);
    const int groove = rig.add({{"name", "GROOVE"}, {"duplo", 1}, {"active", 1}}, 3, 1);
    rig.add({{"name", "GROOVE"}, {"duplo", 2}}, 3, 2);
    rig.add({{"name", "LOOSE"}});
    const int other = rig.add({{"name", "OTHER"}}, 2, 1);
    const auto at = [&](int pot) {
        for (const Json& one : rig.answer["stations"])
            if (one["pot"] == pot) return one["tool"].get<int>();
        return -1;
    };
    ASSERT_TRUE(rig.run({{"do", "tools.answers"}, {"channel", 1}}, UserLevel::None)) << rig.said();
    for (const int pot : {5, 6, 7}) EXPECT_EQ(at(pot), active) << pot;
    EXPECT_EQ(at(2), 0) << "used up, and no sister";
    EXPECT_EQ(at(1), 0) << "empty";
    EXPECT_EQ(rig.answer["stations"].size(), 12u);
    EXPECT_EQ(rig.answer["others"], Json::array({groove}))
        << "not its sister, which no call finds; not what stands nowhere or in the other turret";
    ASSERT_TRUE(rig.run({{"do", "tools.answers"}, {"channel", 2}}, UserLevel::None)) << rig.said();
    EXPECT_EQ(at(1), other);
    EXPECT_EQ(rig.answer["others"], Json::array());
    EXPECT_FALSE(rig.run({{"do", "tools.answers"}, {"channel", 9}}, UserLevel::None));
    EXPECT_EQ(rig.faults[0].column, "channel");
}

// What a program, a measured part and the operator add to one wear in any order is all in it: the
// store adds, nobody's old value comes back.
TEST(Offsets, AddUpWhoeverWritesInBetween) {
    ToolRig rig;
    std::mt19937 random(test_seed(12));
    double sum = 0;
    const Json wear{
        {"do", "offsets.set"}, {"channel", 1}, {"number", 3}, {"table", "wear"}, {"field", "X"}};
    for (int i = 0; i < 1000; ++i) {
        double step = static_cast<double>(static_cast<int>(random() % 21) - 10) / 1000;
        if (std::abs(sum + step) > 0.9) step = -step;
        if (random() % 2) {  // a program's G10, which writes the value that it has computed
            rig.values->channels[0].offsets[3].wear[0] =
                std::round((rig.values->channels[0].offsets[3].wear[0] + step) * 1e9) / 1e9;
        } else {
            Json added = wear;
            added["delta"] = step;
            ASSERT_TRUE(rig.run(added)) << rig.said();
            EXPECT_NEAR(rig.answer["new"].get<double>() - rig.answer["old"].get<double>(), step,
                        1e-12);
        }
        sum += step;
        ASSERT_NEAR(rig.values->channels[0].offsets[3].wear[0], sum, 1e-9);
    }
    Json expects = wear;
    expects["value"] = 0.1;
    expects["expected"] = sum + 0.01;
    EXPECT_FALSE(rig.run(expects)) << "something else stands there by now";
    expects["expected"] = rig.values->channels[0].offsets[3].wear[0];
    EXPECT_TRUE(rig.run(expects)) << rig.said();
    Json both = wear;
    both["value"] = 0.1;
    both["delta"] = 0.1;
    EXPECT_FALSE(rig.run(both));
}

// The same of every other number that a screen adds to: between its picture and its key the machine
// counts, a cycle measures, another panel enters.
TEST(ToolColumns, AddUpWhoeverWritesInBetween) {
    ToolRig rig;
    const int tool = rig.add({{"life_kind", "minutes"},
                              {"life", 60},
                              {"counter", 12.5},
                              {"D1.DP1", 500},
                              {"D1.DP6", 0.4}});
    std::mt19937 random(3);
    double sum = 12.5;
    for (int i = 0; i < 200; ++i) {
        const double step = static_cast<double>(random() % 100) / 64;
        if (random() % 2) {  // the kernel counts minutes of cutting
            rig.values->tools.rows[static_cast<std::size_t>(tool - 1)].counter += step;
        } else {
            ASSERT_TRUE(rig.run({{"do", "tools.set"},
                                 {"tool", tool},
                                 {"fields", {{"counter", {{"delta", step}}}}}}))
                << rig.said();
            EXPECT_NEAR(rig.answer["entries"][0]["new"].get<double>() -
                            rig.answer["entries"][0]["old"].get<double>(),
                        step, 1e-8);
        }
        sum += step;
        ASSERT_NEAR(rig.values->tool(tool)->counter, sum, 1e-6);
    }
    ASSERT_TRUE(rig.run({{"do", "tools.set"},
                         {"tool", tool},
                         {"fields", {{"D1.DP6", {{"delta", 0.4}}}, {"life", 90}}}}))
        << rig.said();
    EXPECT_EQ(toolmgmt::find_edge(*rig.values, tool, 1)->dp[6], 0.8);
    EXPECT_EQ(rig.values->tool(tool)->life, 90);
    EXPECT_FALSE(rig.run({{"do", "tools.set"},
                          {"tool", tool},
                          {"fields", {{"life", {{"value", 30}, {"expected", 60}}}}}}))
        << "it is 90 by now";
    EXPECT_FALSE(
        rig.run({{"do", "tools.set"}, {"tool", tool}, {"fields", {{"name", {{"delta", 1}}}}}}));
    EXPECT_FALSE(
        rig.run({{"do", "tools.set"}, {"tool", tool}, {"fields", {{"locked", {{"delta", 1}}}}}}));
    EXPECT_FALSE(
        rig.run({{"do", "tools.set"}, {"tool", tool}, {"fields", {{"life", {{"delta", -1000}}}}}}))
        << "its limits hold";
    EXPECT_EQ(rig.values->tool(tool)->life, 90);
}

TEST(Parts, AddUpWhoeverWritesInBetween) {
    ToolRig rig;
    const int tool = rig.add({{"h", 3}});
    ASSERT_TRUE(rig.run({{"do", "parts.add"},
                         {"fields",
                          {{"nominal", 30},
                           {"upper", 0.02},
                           {"lower", -0.02},
                           {"tool", tool},
                           {"channel", 1},
                           {"axis", "X"},
                           {"limit", 0.5}}}}))
        << rig.said();
    EXPECT_EQ(rig.answer["dimension"], 1) << "the store knows which number is free";
    const auto set = [&](const char* field, const Json& value) {
        return rig.run({{"do", "parts.set"}, {"dimension", 1}, {"fields", {{field, value}}}});
    };
    ASSERT_TRUE(set("upper", 0.05));  // another panel
    ASSERT_TRUE(set("upper", {{"delta", 0.01}})) << rig.said();
    EXPECT_EQ(rig.answer["upper"], 0.06);
    EXPECT_FALSE(set("upper", {{"delta", -0.09}})) << "below lower";
    // Between the proposal that is shown and the key a part was measured.
    ASSERT_TRUE(rig.run({{"do", "parts.measure"}, {"dimension", 1}, {"value", 30.06}}));
    const double seen = rig.answer["proposal"];
    ASSERT_TRUE(rig.run({{"do", "parts.measure"}, {"dimension", 1}, {"value", 30.10}}));
    const double now = rig.answer["proposal"];
    ASSERT_NE(seen, now);
    EXPECT_FALSE(rig.run({{"do", "parts.accept"}, {"dimension", 1}, {"expected", seen}}))
        << "not the one that was agreed to";
    ASSERT_TRUE(rig.run({{"do", "parts.accept"}, {"dimension", 1}, {"delta", 0.005}}))
        << rig.said();
    EXPECT_NEAR(rig.answer["new"].get<double>(), now + 0.005, 1e-9);
}

TEST(Parameters, AddUpWhoeverWritesInBetween) {
    ToolRig rig;
    const Json target{{"do", "parameters.set"}, {"target", "N1600 L1"}};
    const auto with = [&](std::initializer_list<std::pair<const char*, Json>> more) {
        Json out = target;
        for (const auto& [key, value] : more) out[key] = value;
        return out;
    };
    rig.set("N1600 L1=2");
    ASSERT_TRUE(rig.run(with({{"delta", 0.5}}))) << rig.said();
    EXPECT_EQ(rig.answer["old"], 2);
    EXPECT_EQ(rig.answer["new"], 2.5);
    rig.set("N1600 L1=4");  // somebody else
    ASSERT_TRUE(rig.run(with({{"delta", 0.5}}))) << rig.said();
    EXPECT_EQ(rig.answer["new"], 4.5);
    EXPECT_FALSE(rig.run(with({{"value", 2}, {"expected", 2.5}})))
        << "nothing is taken back that does not stand there any more";
    EXPECT_TRUE(rig.run(with({{"value", 2}, {"expected", 4.5}}))) << rig.said();
    EXPECT_FALSE(rig.run(with({{"delta", -1e3}}))) << "its limits hold";
    EXPECT_FALSE(rig.run(with({{"delta", 0.5}}), UserLevel::None)) << "its level holds";
    for (const char* wrong :
         {"N1600", "N1600 L99", "N0104#2 L1", "nothing", "PT_PROGRAM_FOLDERS L1", ""})
        EXPECT_FALSE(rig.run({{"do", "parameters.set"}, {"target", wrong}, {"delta", 1}})) << wrong;
    EXPECT_FALSE(rig.run({{"do", "parameters.set"}, {"target", "N0104 L1"}, {"delta", 1}}))
        << "bits are no number";
    EXPECT_TRUE(
        rig.run({{"do", "parameters.set"}, {"target", "N2900"}, {"value", 3}, {"expected", 1}}))
        << rig.said();
    EXPECT_EQ(params::get(rig.values->parameters, params::n2900_tool_m_config), 3);
}

TEST(Users, WrongLoginsCostTheStoreNoTime) {
    ToolRig rig;
    toolmgmt::LoginLimit limit;
    auto now = toolmgmt::LoginLimit::Clock::now();
    int looked = 0;
    // ten seconds, a thousand log-ins a second of twenty users
    for (int i = 0; i < 10'000; ++i, now += std::chrono::milliseconds(1))
        if (limit.wait(i % 20, now) == 0) {
            limit.wrong(i % 20, now);
            ++looked;
        }
    EXPECT_LE(looked, 50);
    EXPECT_GT(limit.wait(1, now), 0);
    EXPECT_EQ(limit.wait(1, now + std::chrono::seconds(60)), 0);
}

}  // namespace
