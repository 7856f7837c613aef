// Expressions, functions and texts: one row, one fact (sinumerik_part3 9).
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

Play sinumerik() {
    Play how;
    how.language = "sinumerik";
    return how;
}

struct Row {
    const char* expression;
    const char* value;  // as the event prints it
};
constexpr Row kRows[] = {
    {"2+3*4", "14"},
    {"(2+3)*4", "20"},
    {"-2*-3", "6"},
    {"7/2", "3.5"},
    {"17 DIV 5", "3"},
    {"-17 DIV 5", "-3"},
    {"17 MOD 5", "2"},
    {"1.5EX2", "150"},
    {"-.1EX-3", "-0.0001"},
    {"'HA5' B_AND 'B1111'", "5"},
    {"'H0F' B_OR 'HF0'", "255"},
    {"'B1100' B_XOR 'B1010'", "6"},
    {"B_NOT 0", "-1"},
    {"NOT TRUE", "0"},
    {"1<2", "1"},
    {"3>=4", "0"},
    {"\"abc\"==\"abc\"", "1"},
    {"\"a\"<\"b\"", "1"},
    {"(1==1) AND (2<>2)", "0"},
    {"TRUE XOR TRUE", "0"},
    {"SIN(30)", "0.5"},
    {"COS(90)", "0"},
    {"TAN(45)", "1"},
    {"ATAN2(3,-3)", "135"},
    {"ATAN2(-1,0)", "-90"},
    {"ROUND(-2.5)", "-3"},
    {"ROUNDUP(2.1)", "3"},
    {"ROUNDUP(-2.1)", "-3"},
    {"TRUNC(-2.9)", "-2"},
    {"BOUND(-5,5,7.2)", "5"},
    {"BOUND(-5,5,-7)", "-5"},
    {"MINVAL(POT(-3),10)", "9"},
    {"MAXVAL(2,3)", "3"},
    {"LN(EXP(2))", "2"},
    {"SQRT(2)*SQRT(2)", "2"},
    {"ABS(-4.5)", "4.5"},
    {"STRLEN(\"POLY\"<<12)", "6"},
    {"INDEX(\"POLYTURN\",\"Y\")", "3"},
    {"RINDEX(\"POLYTURN TU\",\"T\")", "9"},
    {"MINDEX(\"POLYTURN\",\"XTN\")", "4"},
    {"INDEX(\"POLYTURN\",\"Q\")", "-1"},
    {"MATCH(\"POLYTURN\",\"TURN\")", "4"},
    {"NUMBER(\" -12.5EX1 \")", "-125"},
    {"ISNUMBER(\"12a\")", "0"},
    {"ISNUMBER(\"1EX3\")", "1"},
    {"SUBSTR(\"POLYTURN\",4)==\"TURN\"", "1"},
    {"TOLOWER(\"AbC\")==\"abc\"", "1"},
    {"SPRINT(\"%D|%.2F|%S\",5,1.005*2,\"x\")==\"5|2.01|x\"", "1"},
    {"MODAXVAL(X,370)", "370"},
    {"AXTOSPI(SPI(1))", "1"},
    {"AXNAME(\"Z\")==Z", "1"},
    {"ISAXIS(2)", "0"},
    {"ISVAR(\"R5\")", "1"},
    {"GETVARTYP(\"R1\")", "4"},
    {"STRINGIS(\"G1\")", "200"},
    {"STRINGIS(\"TRACON\")", "100"},
    {"STRINGIS(\"NOBODY\")", "0"},
    {"$P_UIFRNUM", "0"},
};

TEST(SinumerikExpression, HasTheValueOfTheTable) {
    for (const Row& row : kRows) {
        SCOPED_TRACE(row.expression);
        const Played played = play("R9=" + std::string(row.expression) + "\nM30\n", sinumerik());
        EXPECT_EQ(played.errors, 0u) << played.events;
        EXPECT_TRUE(played.has({"\"name\":\"R9\",\"value\":" + std::string(row.value) + "}"}))
            << played.events;
    }
}

struct Wrong {
    const char* block;
    const char* number;
    unsigned column;  // 0: the whole block
};
constexpr Wrong kWrong[] = {
    {"R1=1/0", "17001", 5},
    {"R1=SQRT(-1)", "14020", 4},
    {"R1=(1+2", "12080", 8},
    {"R1=\"a\"+1", "12150", 7},
    {"R900=1", "12290", 1},
    {"NOBODY=3", "12550", 1},
    {"R1=$P_NOBODY", "12550", 4},
    {"$P_GG[1]=3", "12490", 1},
    {"G0 X1.2.3", "12080", 8},
    {"G0 X5 X6", "12010", 7},
    {"G0 Q5", "12050", 4},
    {"G0 G1", "12070", 4},
    {"G999", "12470", 1},
    {"TRAORI(1)", "14401", 0},
    {"WHEN TRUE DO DELDTG(X)", "12140", 14},
    {"WHEN $A_IN[1]==1 DO DELDTG", "12140", 7},
    {"GOTOF NOWHERE", "14080", 0},
    // the condition does not hold: the mistake is one nevertheless
    {"IF R1==5 GOTOF", "12080", 15},
    {"SIN(5)", "12080", 1},  // its value goes nowhere
    {"MODAXVAL(C,5)", "12080", 1},
    // an address of several letters needs its = (part 1, 3.2.3)
    {"G1 X10 F100 RND 2", "12080", 17},
    {"G1 X10 F100 RND -2", "12080", 17},
    {"G1 X10 F100 RND2", "12550", 13},
    {"G25 Z-10 G0 X5", "12080", 0},  // limits have a block of their own (part 2, 15.3.1)
    {"G4 F1 G0 X5", "12080", 0},     // and a dwell (15.7)
    {"G0 X5 G111 Z0", "12080", 0},   // the pole has a block of its own (part 1, 10.3)
    {"TCARR=2", "12140", 1},
    {"IP[C]=2 G2 X5", "14092", 1},
    {"ENDIF", "12640", 0},
    {"DEF INT AB, AB", "12170", 13},
    {"DEF REAL N", "12170", 10},
    {"SETMTH(2)", "12560", 0},
    {"DEF BOOL AB=X", "12240", 13},
    {"T77", "17190", 1},
    {"S1=1 S2=1 S3=1 S4=1", "14750", 16},
    {"SETAL(65001,\"mine\")", "65001", 0},
    {"MSG(\"a)", "12080", 5},
    {"WAITM(1,9)", "14092", 0},
    {"WAITM(100,2)", "14010", 0},
    {"L77", "14011", 0},
};

TEST(SinumerikFault, HasItsNumberAndColumnAndMovesNothing) {
    for (const Wrong& row : kWrong) {
        SCOPED_TRACE(row.block);
        const Played played = play(std::string(row.block) + "\nM30\n", sinumerik());
        const std::string alarm = played.find({"\"ev\":\"alarm\"", "\"severity\":\"error\""});
        EXPECT_NE(alarm.find("\"number\":" + std::string(row.number) + ","), std::string::npos)
            << played.events;
        if (row.column) {
            EXPECT_NE(alarm.find("\"column\":" + std::to_string(row.column) + ","),
                      std::string::npos)
                << alarm;
        }
        EXPECT_FALSE(played.has({"\"ev\":\"move\""}));
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
