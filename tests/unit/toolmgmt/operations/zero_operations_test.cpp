// Zeros by hand: typed in, from a surface the tool stands at, from the workpiece setter (nct part
// 2, 31: N3014 to N3018).
#include "ipc/image/segments.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "tests/unit/toolmgmt/tools/tool_rig.hpp"

namespace polyturn {
namespace {

using test::ToolRig;
using toolmgmt::Json;
using toolmgmt::Touch;

// L1 of the demonstration machine: A1 X (a diameter), A2 Z. Offset 9 is the probe: lengths 40
// (diameter) and 30 to the middle of a ball of 2 mm.
struct Probe : ToolRig {
    Touch contact{2, true, 3, 12.5, 0};  // A2 moving in -Z, workpiece setter of S1, at Z 12.5
    Probe() {
        set("N3014 L1=6");
        auto& cell = values->channels[0].offsets[9];
        cell.geometry = {40, 0, 30};
        cell.wear = {0, 0, 0.1};
        cell.geometry_r = 1;
        cell.tip = 9;
        touch = [this](unsigned) { return std::optional(contact); };
    }
    bool touched(Json more = Json::object()) {
        Json request = {{"do", "zeros.touch"}, {"channel", 1}};
        request.update(more);
        return run(request);
    }
    double zero(const char* name, int place) {
        return values->channels[0]
            .zeros[*work_zero_row(name) * kChannelAxes + static_cast<std::size_t>(place)];
    }
};

TEST(Zeros, AreTypedInAbsoluteAndIncremental) {
    ToolRig rig;
    ASSERT_TRUE(rig.run(
        {{"do", "zeros.set"}, {"channel", 1}, {"zero", "G55"}, {"field", "Z"}, {"value", -150}}))
        << rig.said();
    ASSERT_TRUE(rig.run({{"do", "zeros.set"},
                         {"channel", 1},
                         {"zero", "G55"},
                         {"field", "Z"},
                         {"value", "0.5"},
                         {"incremental", true}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], -149.5);
    ASSERT_TRUE(rig.run({{"do", "zeros.list"}, {"channel", 1}}));
    EXPECT_EQ(rig.answer["zeros"][2]["zero"], "G55");
    EXPECT_EQ(rig.answer["zeros"][2]["Z"], -149.5);
    for (const Json& wrong : {Json{{"zero", "G60"}, {"field", "Z"}, {"value", 1}},
                              Json{{"zero", "G54"}, {"field", "Q"}, {"value", 1}},
                              Json{{"zero", "G54"}, {"field", "Z"}, {"value", "far"}},
                              Json{{"zero", "G54"}, {"field", "Z"}},
                              Json{{"zero", "G54"}, {"field", "Z"}, {"value", 1e9}}}) {
        Json request = {{"do", "zeros.set"}, {"channel", 1}};
        request.update(wrong);
        EXPECT_FALSE(rig.run(request)) << wrong;
    }
    EXPECT_FALSE(rig.run(
        {{"do", "zeros.set"}, {"channel", 1}, {"zero", "G54"}, {"field", "Z"}, {"value", 1}},
        UserLevel::Operator));
    EXPECT_TRUE(rig.run({{"do", "zeros.list"}, {"channel", 1}}, UserLevel::None));
}

TEST(Zeros, FollowFromASurfaceTheTipStandsAt) {
    Probe rig;
    rig.position = [](unsigned axis) { return std::optional(axis == 1 ? 60.0 : 200.0); };
    // X as diameters: 120 - 40 - 50.
    ASSERT_TRUE(rig.run({{"do", "zeros.measure"},
                         {"channel", 1},
                         {"zero", "G54"},
                         {"field", "X"},
                         {"value", 50},
                         {"offset", 9}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], 30);
    rig.values->channels[0].zeros[kZeroExternal * kChannelAxes + 1] = 2;
    ASSERT_TRUE(rig.run(
        {{"do", "zeros.measure"}, {"channel", 1}, {"zero", "G54"}, {"field", "Z"}, {"value", 0}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], 198);  // no offset; the external zero counts with it
    // G10 P0 acts with every zero, too
    rig.values->channels[0].zeros[kZeroShift * kChannelAxes + 1] = 5;
    ASSERT_TRUE(rig.run(
        {{"do", "zeros.measure"}, {"channel", 1}, {"zero", "G55"}, {"field", "Z"}, {"value", 0}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], 193);
    ASSERT_TRUE(rig.run({{"do", "zeros.measure"},
                         {"channel", 1},
                         {"zero", "external"},
                         {"field", "Z"},
                         {"value", 0}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], 195);
    rig.values->channels[0].zeros[kZeroExternal * kChannelAxes + 1] = 2;
    ASSERT_TRUE(rig.run({{"do", "offsets.measure"},
                         {"channel", 1},
                         {"number", 5},
                         {"field", "Z"},
                         {"value", 7},
                         {"zero", "G55"}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], 200 - 193 - 2 - 5 - 7);
    EXPECT_FALSE(rig.run(
        {{"do", "zeros.measure"}, {"channel", 1}, {"field", "Z"}, {"value", 0}, {"offset", 99}}));
}

// fanuc_lathe 1.1: 5004#1 ORC = 1, the tables hold radii of X while positions and zeros are
// diameters.
TEST(OffsetsInRadii, AreMeasuredSoAndCountAsDiametersInZeros) {
    Probe rig;
    rig.set("F5004#1 L1=1");
    rig.machine = derive_machine_config(rig.values->parameters);
    rig.position = [](unsigned axis) { return std::optional(axis == 1 ? 60.0 : 200.0); };
    // The probe's 40 are a radius now: 120 - 80 - 50.
    ASSERT_TRUE(rig.run({{"do", "zeros.measure"},
                         {"channel", 1},
                         {"zero", "G54"},
                         {"field", "X"},
                         {"value", 50},
                         {"offset", 9}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], -10);
    // Offset 5 has 0.25 of wear: (120 - 30) / 2 - 0.25; and Z is what it is.
    rig.values->channels[0].offsets[5].wear[0] = 0.25;
    ASSERT_TRUE(rig.run({{"do", "offsets.measure"},
                         {"channel", 1},
                         {"number", 5},
                         {"field", "X"},
                         {"value", 30},
                         {"zero", "G55"}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], 44.75);
    ASSERT_TRUE(rig.run({{"do", "offsets.measure"},
                         {"channel", 1},
                         {"number", 5},
                         {"field", "Z"},
                         {"value", 30},
                         {"zero", "G55"}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], 170);
    ASSERT_TRUE(rig.run({{"do", "offsets.origin"}, {"channel", 1}})) << rig.said();
    rig.position = [](unsigned axis) { return std::optional(axis == 1 ? 63.0 : 200.0); };
    ASSERT_TRUE(
        rig.run({{"do", "offsets.relative"}, {"channel", 1}, {"number", 6}, {"field", "X"}}))
        << rig.said();
    EXPECT_EQ(rig.answer["new"], 3);
    // a radius, as presetters measure
    ASSERT_TRUE(
        rig.run({{"do", "offsets.preset"}, {"channel", 1}, {"number", 7}, {"X", 12.5}, {"Z", 3}}))
        << rig.said();
    EXPECT_EQ(rig.values->channels[0].offsets[7].geometry[0], 12.5);
    // the setter's side, met in -X: a diameter, as all positions
    rig.set("N3012 L1=5");
    rig.set("N0205 L1=20");
    rig.contact = {1, true, 1, 35.0, 0};
    ASSERT_TRUE(rig.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 8}})) << rig.said();
    EXPECT_EQ(rig.answer["new"], 25);  // (70 - 20) / 2
}

TEST(WorkpieceSetter, GivesTheZeroOfTheSurfaceThatWasTouched) {
    Probe rig;
    // The ball's middle was at 12.5 - 30.1 from the zero's view and its side is 1 mm further on:
    // the surface, which is to be 0.
    ASSERT_TRUE(rig.touched({{"zero", "G56"}, {"offset", 9}})) << rig.said();
    EXPECT_DOUBLE_EQ(rig.answer["new"], 12.5 - 1 - 30.1);
    EXPECT_DOUBLE_EQ(rig.zero("G56", 1), -18.6);
    EXPECT_EQ(rig.answer["setter"], 1);
    ASSERT_TRUE(rig.touched({{"zero", "G56"}, {"offset", 9}, {"field", "Z"}, {"value", 2}}));
    EXPECT_DOUBLE_EQ(rig.answer["difference"], -2);
    // X, travelling to the middle: 60 - 2 (two radii) - 40, and the diameter is 16
    rig.contact = {1, true, 3, 30, 0};
    ASSERT_TRUE(rig.touched({{"zero", "G54"}, {"offset", 9}, {"value", 16}})) << rig.said();
    EXPECT_DOUBLE_EQ(rig.answer["new"], 60 - 2 - 40 - 16);
    rig.contact = {2, false, 3, 12.5, 0};  // in +Z: the other side of the ball
    ASSERT_TRUE(rig.touched({{"offset", 9}}));
    EXPECT_DOUBLE_EQ(rig.answer["new"], 12.5 + 1 - 30.1);
    rig.values->channels[0].offsets[9].tip = 3;  // lengths of a tip: no ball
    ASSERT_TRUE(rig.touched({{"offset", 9}}));
    EXPECT_DOUBLE_EQ(rig.answer["new"], 12.5 - 30.1);
}

TEST(WorkpieceSetter, LetsParametersAndPlcChooseSystemAndOffset) {
    Probe rig;
    rig.set("N3016#1 L1=1");  // WPS
    rig.set("N3017 L1=57");
    rig.set("N3018 L1=59");
    ASSERT_TRUE(rig.touched({{"offset", 0}})) << rig.said();
    EXPECT_EQ(rig.zero("G57", 1), 12.5);
    rig.contact.setter = 4;  // at the counter spindle
    ASSERT_TRUE(rig.touched({{"offset", 0}}));
    EXPECT_EQ(rig.zero("G59", 1), 12.5);
    EXPECT_EQ(rig.answer["setter"], 2);
    EXPECT_FALSE(rig.touched({{"offset", 0}, {"zero", "G54"}}));
    EXPECT_NE(rig.said().find("WPS"), std::string::npos);
    rig.set("N3016#0 L1=1");  // ONS
    rig.contact.plc_offset = 9;
    ASSERT_TRUE(rig.touched());
    EXPECT_DOUBLE_EQ(rig.zero("G59", 1), 12.5 - 1 - 30.1);
    EXPECT_FALSE(rig.touched({{"offset", 3}}));
    EXPECT_NE(rig.said().find("CP_OFFSNO"), std::string::npos);
}

TEST(WorkpieceSetter, RefusesWhatWasNotTouchedOrIsNotSaid) {
    Probe rig;
    EXPECT_FALSE(rig.touched({{"zero", "G54"}}));                // whose length?
    EXPECT_FALSE(rig.touched({{"offset", 9}, {"field", "X"}}));  // it was Z
    rig.contact.setter = 1;                                      // the tool setter it was
    EXPECT_FALSE(rig.touched({{"offset", 9}}));
    EXPECT_EQ(rig.faults.at(0).diagnosis.alarm, Alarm::SetterNoTouch);
    // and there is none
    EXPECT_FALSE(rig.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 3}}));
    EXPECT_EQ(rig.faults.at(0).diagnosis.alarm, Alarm::SetterUnset);
    rig.set("N3012 L1=5");
    rig.contact.setter = 3;
    // the workpiece was touched, no tool
    EXPECT_FALSE(rig.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 3}}));
    EXPECT_EQ(rig.faults.at(0).diagnosis.alarm, Alarm::SetterNoTouch);
    rig.set("N3014 L1=0");
    EXPECT_FALSE(rig.touched({{"offset", 9}}));
    EXPECT_EQ(rig.faults.at(0).diagnosis.alarm, Alarm::SetterUnset);
    rig.contact.axis = 0;
    rig.set("N3014 L1=6");
    EXPECT_FALSE(rig.touched({{"offset", 9}}));
}

// fanuc_lathe 10.5, X slide inclined by 30 degrees: it stands at 34.641 of its own and Z at
// -7.3205, which is X 30 (a radius), Z 10 at right angles.
struct Inclined : Probe {
    static constexpr double kSlide = 34.641016151377546, kRail = -7.320508075688772;
    Inclined() {
        set("F8210 L1=30");
        set("F8200 L1=00000001");
        position = [](unsigned axis) {
            return std::optional(axis == 1 ? kSlide : axis == 2 ? kRail : 0.0);
        };
        values->channels[0].offsets[9] = {};
    }
};

TEST(InclinedSlide, ZerosAndOffsetsAreMeasuredAtRightAngles) {
    Inclined rig;
    ASSERT_TRUE(rig.run(
        {{"do", "zeros.measure"}, {"channel", 1}, {"zero", "G54"}, {"field", "X"}, {"value", 0}}))
        << rig.said();
    EXPECT_NEAR(rig.answer["new"], 60, 1e-6);
    ASSERT_TRUE(rig.run(
        {{"do", "zeros.measure"}, {"channel", 1}, {"zero", "G54"}, {"field", "Z"}, {"value", 0}}))
        << rig.said();
    EXPECT_NEAR(rig.answer["new"], 10, 1e-6);
    ASSERT_TRUE(rig.run({{"do", "offsets.measure"},
                         {"channel", 1},
                         {"number", 5},
                         {"field", "Z"},
                         {"value", 2},
                         {"zero", "G55"}}))
        << rig.said();
    EXPECT_NEAR(rig.answer["new"], 8, 1e-6);
    ASSERT_TRUE(rig.run({{"do", "offsets.origin"}, {"channel", 1}})) << rig.said();
    // The slide alone goes on by 10 of its own: 8.66025 in X (a radius) and 5 in Z.
    rig.position = [](unsigned axis) {
        return std::optional(axis == 1 ? Inclined::kSlide + 10 : Inclined::kRail);
    };
    ASSERT_TRUE(
        rig.run({{"do", "offsets.relative"}, {"channel", 1}, {"number", 6}, {"field", "X"}}))
        << rig.said();
    EXPECT_NEAR(rig.answer["new"], 17.320508, 1e-5);
    ASSERT_TRUE(
        rig.run({{"do", "offsets.relative"}, {"channel", 1}, {"number", 6}, {"field", "Z"}}))
        << rig.said();
    EXPECT_NEAR(rig.answer["new"], 5, 1e-5);
}

TEST(InclinedSlide, SettersTellWhereTheTipWasAtRightAngles) {
    Inclined rig;
    // Z has met the part; the slide stood
    rig.contact = {2, true, 3, Inclined::kRail, 0, Inclined::kSlide};
    ASSERT_TRUE(rig.touched({{"zero", "G56"}, {"offset", 0}})) << rig.said();
    EXPECT_NEAR(rig.zero("G56", 1), 10, 1e-6);
    rig.contact = {1, true, 3, Inclined::kSlide, 0, Inclined::kSlide};
    ASSERT_TRUE(rig.touched({{"zero", "G56"}, {"offset", 0}})) << rig.said();
    EXPECT_NEAR(rig.zero("G56", 0), 60, 1e-6);
    // the setter's face, met in -Z
    rig.set("N3012 L1=5");
    rig.set("N0209 L1=4");
    rig.contact = {2, true, 1, Inclined::kRail, 0, Inclined::kSlide};
    ASSERT_TRUE(rig.run({{"do", "offsets.touch"}, {"channel", 1}, {"number", 7}})) << rig.said();
    EXPECT_NEAR(rig.answer["new"], 6, 1e-6);
}

}  // namespace
}  // namespace polyturn
