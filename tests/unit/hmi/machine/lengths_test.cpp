// A machine whose measuring devices count inches (N0104 #0; nct_parameters_part1 1.3, 3.3): the
// screens show and take inches, the store keeps millimetres.
#include "hmi/machine/live/lengths.hpp"

#include "hmi/machine/programs/program_unit.hpp"
#include "hmi/screens/tools/offsets.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

using Kind = LengthUnit::Kind;

TEST(Lengths, AreShownInTheUnitOfTheMachine) {
    struct {
        Kind kind;
        unsigned decimals;
        double held;
        const char *text, *name, *perMinute, *perRevolution;
    } facts[] = {
        {Kind::Millimetre, 3, 25.4, "25.400", "mm", "mm/min", "mm/rev"},
        {Kind::Inch, 4, 25.4, "1.0000", "inch", "inch/min", "inch/rev"},
        {Kind::Inch, 4, -0.0508, "-0.0020", "inch", "inch/min", "inch/rev"},
        {Kind::Inch, 5, 0.000254, "0.00001", "inch", "inch/min", "inch/rev"},
        {Kind::Inch, 4, -0.0001, "0.0000", "inch", "inch/min", "inch/rev"},
        {Kind::Degree, 3, 25.4, "25.400", "°", "°/min", "mm/rev"},
    };
    for (const auto& one : facts) {
        const LengthUnit unit{one.kind, one.decimals};
        EXPECT_EQ(unit.text(one.held), one.text) << one.held;
        EXPECT_EQ(unit.name(), QString::fromUtf8(one.name));
        EXPECT_EQ(unit.perMinute(), QString::fromUtf8(one.perMinute));
        EXPECT_EQ(unit.perRevolution(), one.perRevolution);
        EXPECT_DOUBLE_EQ(unit.held(unit.of(one.held)), one.held);
    }
    const LengthUnit inch{Kind::Inch, 4}, mm{};
    EXPECT_EQ(inch.speed(2540), "100.0");
    EXPECT_EQ(mm.speed(2540), "2540");
    EXPECT_NEAR(inch.surface(100), 328.084, 1e-3);
    EXPECT_EQ(inch.surfaceName(), "ft/min");
    EXPECT_EQ(inch.text(12.7, 0), "1") << "whole numbers have no decimals in any unit";
}

// 3.3: decimals = value + 1 of millimetres and degrees, value + 2 of inches; turning axes count
// degrees whatever the channel's unit is.
TEST(Lengths, HaveTheDecimalsOfTheIncrementSystem) {
    MachineConfig machine{};
    machine.last_channel = 1;
    AxisConfig slide{}, table{};
    slide.channel = table.channel = 1;
    table.rotary = true;
    struct {
        bool inch;
        std::uint32_t system;
        unsigned linear, rotary;
    } facts[] = {
        {false, 1, 2, 2}, {false, 2, 3, 3}, {true, 1, 3, 2}, {true, 2, 4, 3}, {true, 3, 5, 4}};
    for (const auto& one : facts) {
        machine.channels[0].inch = one.inch;
        machine.channels[0].increment_system =
            static_cast<decltype(machine.channels[0].increment_system)>(one.system);
        EXPECT_EQ(lengthUnit(machine, 1).decimals, one.linear) << one.system;
        EXPECT_EQ(lengthUnit(machine, slide).decimals, one.linear) << one.system;
        EXPECT_EQ(lengthUnit(machine, table).decimals, one.rotary) << one.system;
        EXPECT_EQ(lengthUnit(machine, slide).inch(), one.inch);
        EXPECT_EQ(lengthUnit(machine, table).kind, Kind::Degree);
    }
}

TEST(Lengths, AreTypedInTheUnitOfTheField) {
    NumberPad pad(nullptr);
    double present = 25.4, entered = 0;
    pad.field = [&]() -> std::optional<NumberPad::Field> {
        return NumberPad::Field{"X", "inch", present, 4, false, 25.4};
    };
    pad.onInput = [&](double held) { entered = held; };
    struct {
        const char* typed;
        bool added;
        double held;
    } facts[] = {{"2", false, 50.8},
                 {"1/2", false, 12.7},
                 {"+0.001", false, 25.4254},
                 {"0.001", true, 25.4254},
                 {"-0.002", true, 25.3492}};
    for (const auto& one : facts) {
        pad.type(one.typed);
        if (!one.added) {
            EXPECT_NEAR(pad.held().value_or(0), one.typed[0] == '+' ? 0.0254 : one.held, 1e-9)
                << one.typed;
        }
        pad.enter(one.added);
        EXPECT_NEAR(entered, one.held, 1e-9) << one.typed;
    }
}

// What the controller refuses in millimetres, and an outline, in the unit that is shown and taken.
TEST(Lengths, InTextsAreToldInTheUnitOfTheScreens) {
    const LengthUnit inch{Kind::Inch, 4}, mm{};
    EXPECT_EQ(retoldLengths("wear is 0.5 mm at the most (N1415)", inch),
              "wear is 0.0197 inch at the most (N1415)");
    EXPECT_EQ(retoldLengths("wear is 0.5 mm at the most (N1415)", mm),
              "wear is 0.5 mm at the most (N1415)");
    EXPECT_EQ(retoldLengths(QString::fromUtf8("износ не больше 25.4 мм (N1415)"), inch),
              QString::fromUtf8("износ не больше 1 inch (N1415)"));
    EXPECT_EQ(retoldLengths("100 mm/min", inch), "100 mm/min");
    EXPECT_EQ(scaledNumbers("X -60:0 Z -25.4:5.08", 1 / 25.4), "X -2.3622:0 Z -1:0.2");
    EXPECT_EQ(scaledNumbers("X -2.5:0 Z -1:.2", 25.4), "X -63.5:0 Z -25.4:5.08");
}

TEST(Lengths, OfAProgramAreThoseOfItsLastUnitCode) {
    Live nobody("hmi-test-nobody");
    const auto inches = [&](const char* language, QStringList lines) {
        return countsInches(nobody, 1, language, lines, static_cast<int>(lines.size()) - 1);
    };
    struct {
        const char *language, *text;
        bool inch;
    } facts[] = {{"fanuc", "G20\nX1.", true},        {"fanuc", "G20\nN5G21X1.", false},
                 {"fanuc", "(G20)\nX1.", false},     {"fanuc", "G71 U2.\nG70 P1 Q2", false},
                 {"nct", "G020 G0", true},           {"fagor", "G70\nX1", true},
                 {"fagor", "G70\nG71", false},       {"fagor", "G20", false},
                 {"sinumerik", "G700\nX1", true},    {"sinumerik", "G70\nG710 X1", false},
                 {"sinumerik", "X1 ;G70", false},    {"sinumerik", "MSG(\"G70\")", false},
                 {"fanuc", "G200", false},           {"fanuc", "G20.1", false},
                 {"fanuc", "G21 (x)\nG20 G99", true}};
    for (const auto& one : facts)
        EXPECT_EQ(inches(one.language, QString(one.text).split('\n')), one.inch)
            << one.language << ": " << one.text;
}

class InchTasks : public Tasks {
protected:
    static void SetUpTestSuite() { g_controller = new Controller({}, {"N0104=00000001"}); }
};

TEST_F(InchTasks, AWearEnteredInInchesIsMillimetresInTheStore) {
    ASSERT_TRUE(g_controller->set("offset L1 3 wear X=0"));
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    hand.soft("Tool offsets");
    const auto wear = [&] { return live().store(1).offsets[3].wear[0]; };
    ASSERT_TRUE(waitFor([&] { return wear() == 0; }));
    hand.touchCell(offsets.table(), 2, 5);  // offset 3: X Z R T, then wear X
    frames(*window);
    EXPECT_TRUE(standsOn({&offsets.pad()}, "inch"));
    hand.type("-0.002");
    hand.soft("+ Input");
    ASSERT_TRUE(waitFor([&] { return std::abs(wear() + 0.0508) < 1e-9; })) << wear();
    frames(*window);
    EXPECT_EQ(offsets.table().cell(2, 5).text, "-0.0020");
    hand.type("-0.001");
    hand.soft("+ Input");
    ASSERT_TRUE(waitFor([&] { return std::abs(wear() + 0.0762) < 1e-9; })) << wear();
    hand.soft("Undo");
    ASSERT_TRUE(waitFor([&] { return std::abs(wear() + 0.0508) < 1e-9; })) << wear();
    ASSERT_TRUE(g_controller->set("offset L1 3 wear X=0"));
    // A zero too, with the same figures on the screen as on the pad.
    hand.soft("Work zeros");
    frames(*window);
    const int row = [&] {
        for (int i = 0; i < offsets.table().rows(); ++i)
            if (offsets.table().cell(i, 0).text == "G55") return i;
        return -1;
    }();
    ASSERT_GE(row, 0);
    hand.touchCell(offsets.table(), row, 2);
    hand.type("5");
    hand.soft("Input");
    EXPECT_TRUE(waitFor([&] {
        return std::abs(live().store(1).zeros[2 * kChannelAxes + 1] - 127) < 1e-9;
    })) << live().store(1).zeros[2 * kChannelAxes + 1];
    frames(*window);
    EXPECT_EQ(offsets.table().cell(row, 2).text, "5.0000");
}

// No screen says millimetres any more.
TEST_F(InchTasks, NoScreenSaysMillimetres) {
    for (const char* name : {"overview", "offsets", "manual", "diagnosis"}) {
        Operator(*window).screen(name);
        for (int page = 0; page < std::min(window->screen()->pages(), 3); ++page) {
            window->screen()->turnTo(page);
            frames(*window, 150);
            EXPECT_FALSE(standsOn(window->screen()->sheets(), "mm/min")) << name << ' ' << page;
            EXPECT_FALSE(standsOn(window->screen()->sheets(), " mm")) << name << ' ' << page;
        }
    }
    Operator(*window).screen("overview");
    frames(*window);
    EXPECT_TRUE(standsOn(window->screen()->sheets(), "inch/min"));
    noWordIsShortened(*window);  // longer names of units, one digit more
}

}  // namespace
}  // namespace polyturn::hmi
