// The language fagor: statements in round brackets. Every row follows from spec fagor_8037t part 2,
// section in brackets.
#include <gtest/gtest.h>

#include "../play.hpp"
#include "channels/fagor/grammar/g_codes.hpp"
#include "channels/fagor/grammar/variable_names.hpp"

namespace polyturn::channels::testing {
namespace {

Played run(std::string_view program) {
    Play how;
    how.language = "fagor";
    return play(program, how);
}

// The value that P100 was given last, as the event shows it.
std::string value_of(std::string_view expression) {
    const Played played = run("(P100=" + std::string(expression) + ")\nM30\n");
    const std::string line = played.find({"\"name\":\"P100\""});
    const std::size_t at = line.find("\"value\":");
    return at == std::string::npos ? played.events
                                   : line.substr(at + 8, line.find('}', at) - at - 8);
}

TEST(FagorExpression, HasTheValueOfItsOperators) {
    const std::pair<std::string_view, std::string_view> rows[] = {
        // [11.5]
        {"2+3*4 EXP 2", "50"},
        {"2 EXP 3 EXP 2", "64"},
        {"100 MOD 30/5", "2"},
        {"-2 EXP 2", "4"},
        {"12-2-3", "7"},
        // [11.4]
        {"SIN 30+COS 60", "1"},
        {"ARG(-3,3)", "135"},
        {"ARG(-1,-1)", "225"},
        {"ATAN(-1)", "-45"},
        {"SIN 180", "0"},
        {"FIX 7.9", "7"},
        {"FUP 7.1", "8"},
        {"FUP 7", "7"},
        {"ROUND 7.5", "8"},
        {"BCD 234", "564"},
        {"BIN $234", "234"},
        {"BIN $AB", "171"},
        {"$1F AND $F0", "16"},
        {"$F XOR $3C", "51"},
        {"$10 OR 3", "19"},
        {"NOT $FFFFFFF0", "15"},
        {"(1 LT 2) AND (2 LT 1)", "0"},
        {"NOT (1 EQ 2)", "1"},
        {"P(100+5)+0", "0"},
        {"ABS(-3.5)+SQRT 9", "6.5"},
        {"LOG 1000", "3"},
    };
    for (const auto& [expression, value] : rows)
        EXPECT_EQ(value_of(expression), value) << expression;
}

TEST(FagorStatement, RunsWhatItNames) {
    // [12.5]
    EXPECT_TRUE(
        run("(A=4)\n(CALL 1)\n(P100=A)\nM30\n(SUB 1)\n(A=A+1)\n(RET)\n").has({"P100", ":5"}));
    EXPECT_TRUE(
        run("(A=4)\n(PCALL 1, A7)\n(P100=A)\nM30\n(SUB 1)\n(A=A+1)\n(RET)\n").has({"P100", ":4"}));
    // [11.2.12]
    EXPECT_TRUE(run("(PCALL 1, B2, D1)\nM30\n(SUB 1)\n(P100=CALLP)\n(RET)\n").has({"P100", ":10"}));
    // [12.4]
    EXPECT_TRUE(run("(P101=1)\nN5 (P101=P101*2)\n(IF (P101 LT 30) GOTO N5)\n(P100=P101)\nM30\n")
                    .has({"P100", ":32"}));
    EXPECT_TRUE(
        run("N1 (P101=P101+1)\nN2 (P102=P102+2)\n(RPT N1, N2) N3\n(P100=P101*10+P102)\nM30\n")
            .has({"P100", ":48"}));
    // its count stands behind the bracket
    EXPECT_TRUE(run("N1 (P100=P100+1)\nN2 (P102=0)\n(IF (P100 EQ 1) RPT N1, N2) N3\nM30\n")
                    .has({"P100", ":4"}));
    // [12.7]
    EXPECT_TRUE(
        run("(P101=2.5)\n(OPEN P7)\n(WRITE (P100=?P101))\n(EXEC P7)\nM30\n").has({"P100", ":2.5"}));
    // its M30 leads back
    EXPECT_TRUE(run("(OPEN P7)\n(WRITE (P101=5))\n(WRITE M30)\n"
                    "(WRITE (P101=6))\n(EXEC P7)\n(P100=P101)\n"
                    "M30\n")
                    .has({"P100", ":5"}));
    // A labelled or skippable block is a statement too: only what stands behind ? is replaced.
    EXPECT_TRUE(run("(P100=4)\n(OPEN P7)\n(WRITE N10 (P100=P100+1))\n(EXEC P7)\nM30\n")
                    .has({"P100", ":5"}));
    EXPECT_TRUE(
        run("(P100=4)\n(P101=2)\n(OPEN P7)\n(WRITE /2 N10 (P100=P100+?P101))\n(EXEC P7)\nM30\n")
            .has({"P100", ":6"}));
    EXPECT_TRUE(
        run("(P101=7)\n(OPEN P7)\n(WRITE N10 G00 XP101 ;(KEPT))\n(P101=8)\n(EXEC P7)\nM30\n")
            .has({"\"ev\":\"move\"", "\"X\":7"}));
    // one sign
    EXPECT_TRUE(run("(P101=-3)\n(OPEN P7)\n(WRITE G00 X+P101 Z-P101)\n(EXEC P7)\nM30\n")
                    .has({"\"ev\":\"move\"", "\"X\":-3,\"Z\":3"}));
    // [12.5] a number or an expression
    EXPECT_TRUE(run("(P101=3)\n(CALL 1+2)\n(CALL P101)\nM30\n(SUB 3)\n(P100=P100+1)\n(RET)\n")
                    .has({"P100", ":2"}));
    // [12.2]
    EXPECT_TRUE(run("(P101=2)\n(MSG \"N ?P101 OK\")\nM30\n").has({"message", "N 2 OK"}));
    EXPECT_TRUE(run("(ERROR 77, \"NO BAR\")\nM30\n").has({"alarm", ":77", "NO BAR"}));
    // once, though it waits
    EXPECT_TRUE(run("(P101=1, P102=POSX)\n(P101=P101+1, P102=POSX)\n(P100=P101)\nM30\n")
                    .has({"P100", ":2"}));
}

TEST(FagorStatement, RefusesByName) {
    const std::pair<std::string_view, Alarm> rows[] = {
        {"(FOO=1)", Alarm::FagorStatement},
        {"(P100=SIN P1)", Alarm::FagorBracket},
        {"(TOOL=1)", Alarm::VariableReadOnly},
        {"(P30=1)", Alarm::VariableUnknown},
        {"(P2000=1)", Alarm::FagorMakerParameter},
        {"(P100=1/0)", Alarm::DivisionByZero},
        {"(P100=(1)", Alarm::FagorBracket},
        {"(GOTO N9)", Alarm::SequenceNumberMissing},
        {"(CALL 9)", Alarm::SubprogramMissing},
        {"(RET)", Alarm::FagorReturn},
        {"(WRITE G0)", Alarm::FagorWriteClosed},
        {"(REPOS X)", Alarm::FagorRepos},
        {"(PAGE 1)", Alarm::FagorUserChannel},
        {"(SUB 10001)\n(RET)", Alarm::FagorMakerSubroutine},
        {"(SUB 1)\n(RET)\n(SUB 1)\n(RET)", Alarm::FagorSubroutineTwice},
        {"(OPEN P5)\n(OPEN P5)", Alarm::FagorProgramExists},
        {"(CALL 1)\nM30\n(SUB 1)\n(CALL 1)\n(RET)", Alarm::CallTooDeep},
        {"(P100=P2000)", Alarm::FagorMakerParameter},
        {"(TLFN3=65536)", Alarm::FagorValueRange},
        {"(TMZT1=-2)", Alarm::FagorValueRange},
        {"(NOSEW1=-1)", Alarm::FagorValueRange},
        {"(IF (1 EQ 2))", Alarm::FagorStatement},
        {"(IF (1 EQ 1) ELSE P100=1)", Alarm::FagorStatement},
        {"(IF (1 EQ 1) GOTO N5) N2\nN5 X1", Alarm::FagorRepeat},
        {"(PCALL 1)\nM30\n(SUB 1)\n(PCALL 1)\n(RET)", Alarm::FagorLevels},
        {"(P100=GPOSX N5 P9)", Alarm::FagorBlockUnknown},
    };
    for (const auto& [program, alarm] : rows) {
        const Played played = run(program);
        EXPECT_TRUE(
            played.has({"\"ev\":\"alarm\"", std::string(alarm_number(alarm, Dialect::Fagor))}))
            << program << "\n"
            << played.events;
    }
}

// One statement in a block, and nothing else in it [12]; of what cannot be read nothing is done.
TEST(FagorStatement, RefusesWordsBehindAJumpOrCall) {
    std::string arguments = "(PCALL 5";
    for (int i = 0; i < 27; ++i) arguments += ",A1";
    const std::pair<std::string, Alarm> rows[] = {
        {"(CALL 5,A1)", Alarm::FagorStatement},
        {"(PCALL 5 A1)", Alarm::FagorStatement},
        {"(PCALL 5,A1 B2)", Alarm::FagorStatement},
        {"(MCALL 5 A1)", Alarm::FagorStatement},
        {"(RPT N5,N6 N3)", Alarm::FagorStatement},
        {"(GOTO N5,N6)", Alarm::FagorStatement},
        {"(GOTO N5 P1=3)", Alarm::FagorStatement},
        {"(CALL 5 X)", Alarm::FagorStatement},
        {"(IF (1 EQ 1) CALL 5 FOO ELSE CALL 6)", Alarm::FagorStatement},
        {"(IF (1 EQ 1) CALL 5 ELSE CALL 6 ELSE CALL 5)", Alarm::FagorStatement},
        {"(IF (1 EQ 0) CALL 5 ELSE CALL 6 ELSE CALL 5)", Alarm::FagorStatement},
        {"(IF (1 EQ 1) P1=1 ELSE P1=2 ELSE P1=3)", Alarm::FagorStatement},
        {"(CALL 5.5)", Alarm::FagorValueRange},
        {"(GOTO N5.5)", Alarm::FagorValueRange},
        {arguments + ")", Alarm::WordsTooMany},
        {"(EXEC P7 X)", Alarm::FagorStatement},
        {"(MDOFF 5)", Alarm::FagorStatement},
    };
    for (const auto& [statement, alarm] : rows) {
        const Played played = run("(OPEN P7)\n" + statement +
                                  "\nN5 (P100=1)\nN6 (P100=2)\nM30\n(SUB 5)\n"
                                  "(P100=3)\n(RET)\n(SUB 6)\n(P100=4)\n(RET)\n");
        EXPECT_TRUE(played.has(
            {"\"ev\":\"alarm\"", std::string(alarm_number(alarm, Dialect::Fagor)), "\"line\":2"}))
            << statement << "\n"
            << played.events;
        EXPECT_FALSE(played.has({"P100"})) << statement << "\n" << played.events;
    }
    EXPECT_TRUE(
        run("(CALL 1)\nM30\n(SUB 1)\n(RET 5)\n")
            .has({"\"ev\":\"alarm\"",
                  std::string(alarm_number(Alarm::FagorStatement, Dialect::Fagor)), "\"line\":4"}));
}

// [11.2.14] axis numbers: 1 = X, 2 = Y, 3 = Z, whether the machine has the axis or not.
TEST(FagorVariable, PlaneNamesItsAxesByNumber) {
    const std::pair<std::string_view, std::string_view> rows[] = {
        {"G17", ":18"}, {"G18", ":49"}, {"G19", ":35"}};
    for (const auto& [plane, value] : rows) {
        const Played played = run(std::string(plane) + "\n(P100=PLANE)\nM30\n");
        EXPECT_TRUE(played.has({"P100", std::string(value)})) << plane << "\n" << played.events;
    }
}

// [11.2.4] limits of an axis are coordinates: they come in the unit that is active.
TEST(FagorVariable, LimitsOfAnAxisAreInTheActiveUnit) {
    for (const std::string limit : {"MPZ5", "MPZ6"}) {
        Play how;
        how.language = "fagor";
        const Played played = play("(P101=" + limit + ")\nG70\n(P100=P101/" + limit + ")\nM30\n",
                                   how, [](MachineView& view) {
                                       view.axes[1].limit_max = 500;
                                       view.axes[1].limit_min = -300;
                                   });
        EXPECT_TRUE(played.has({"\"name\":\"P100\"", ":25.4}"})) << played.events;
    }
}

// [11.2.13] automatic execution, or block by block.
TEST(FagorVariable, TheModeTellsSingleBlock) {
    Play how;
    how.language = "fagor";
    EXPECT_TRUE(play("(P100=OPMODE)\nM30\n", how).has({"P100", ":10}"}));
    how.setup.keys.single_block = true;
    EXPECT_TRUE(play("(P100=OPMODE)\nM30\n", how).has({"P100", ":11}"}));
}

// [11.2.14, 11.2] SELPRO is one of the values that wait for the blocks before: compensation breaks
// off there.
TEST(FagorVariable, SelproInterruptsCompensation) {
    const auto path = [](std::string_view between) {
        Play how;
        how.language = "fagor";
        const std::string program =
            "G18 G71 G90 G94 G152\nT1 D1\nG0 X60 Z40\nG42 G1 X30 Z10 F100\nZ-20\n" +
            std::string(between) + "\nX60\nG40 X80\nM30\n";
        const Played played =
            play(program, how, [](MachineView& view) { view.store->offsets[1].geometry_r = 2; });
        EXPECT_EQ(played.errors, 0u) << between;
        return played.has({"\"line\":5", "\"Z\":-20"});  // the block before ends perpendicular
    };
    EXPECT_TRUE(path("(SELPRO=1)"));
    EXPECT_TRUE(path("(P100=SELPRO)"));
    EXPECT_FALSE(path("(PRBMOD=0)"));
}

// [11.2.14] eight analogue inputs and as many outputs.
TEST(FagorVariable, AnalogueInputsAreEight) {
    EXPECT_FALSE(run("(P100=ANAI8)\nM30\n").has({"\"ev\":\"alarm\""}));
    for (const char* number : {"0", "9"}) {
        EXPECT_TRUE(run("(P100=ANAI" + std::string(number) + ")\nM30\n").has({"\"ev\":\"alarm\""}))
            << number;
        EXPECT_TRUE(run("(P100=ANAO" + std::string(number) + ")\nM30\n").has({"\"ev\":\"alarm\""}))
            << number;
    }
}

TEST(FagorTables, NameEachCodeAndVariableOnce) {
    for (std::size_t i = 0; i < fagor::variable_count(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const auto& a = fagor::variable_row(i);
            const auto& b = fagor::variable_row(k);
            EXPECT_FALSE(a.name == b.name && a.shape == b.shape) << a.name;
        }
    for (const fagor::GCode& row : fagor::g_codes()) {
        EXPECT_EQ(fagor::find_g_code(row.number), &row);
        EXPECT_FALSE(row.text.empty());
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
