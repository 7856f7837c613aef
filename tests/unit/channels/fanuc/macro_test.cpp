// Custom macro B: values, empty variables, flow, faults.
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

struct Row {
    std::string_view expression;
    std::string_view value;  // as the event writes it
};

TEST(MacroExpression, HasThisValue) {
    const Row rows[] = {
        {"2+3*4", "14"},    {"[2+3]*4", "20"},   {"-3+1", "-2"},          {"10-4-3", "3"},
        {"7 MOD 4", "3"},   {"12 AND 10", "8"},  {"12 OR 3", "15"},       {"SIN[30]", "0.5"},
        {"COS[90]", "0"},   {"TAN[45]", "1"},    {"ATAN[1]/[-1]", "135"}, {"ATAN[-1]/[1]", "315"},
        {"SQRT[9]", "3"},   {"ROUND[2.5]", "3"}, {"FIX[-7.9]", "-7"},     {"FUP[-7.1]", "-8"},
        {"BIN[37]", "25"},  {"BCD[25]", "37"},   {"RO[1.6]", "2"},        {"ABS[-4]", "4"},
        {"#0", "null"},     {"#0+1", "1"},       {"#0*5", "0"},           {"[1 EQ 1]", "1"},
        {"[#0 EQ 0]", "0"}, {"[#0 EQ #0]", "1"}, {"[#0 GE #0]", "1"},     {"[#0 NE 0]", "1"},
        {"1.5E", ""},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(std::string(row.expression));
        const Played played = play("#100=" + std::string(row.expression) + "\nM30\n");
        if (row.value.empty()) {
            EXPECT_EQ(played.errors, 1u) << played.events;
        } else {
            EXPECT_TRUE(played.has({R"("name":"#100","value":)" + std::string(row.value) + "}"}))
                << played.events;
        }
    }
}

struct FaultRow {
    std::string_view program, number;
    unsigned line, column;
};

TEST(MacroStatement, IsDiagnosedAtItsPlace) {
    const FaultRow rows[] = {
        {"#1=5/0", "112", 1, 7},
        {"#1=SQRT[-1]", "111", 1, 4},
        {"#1=.0000001*.0000001*.0000001*.0000001*.0000001", "111", 1, 0},  // 1E-35
        {"#1=EXP[-100]", "111", 1, 4},
        {"SETVN 1[A]", "115", 1, 7},
        {"SETVN 500[A", "", 1, 12},
        {"SETVN 500[1A]", "114", 1, 11},
        {"[#NONAME]=1", "115", 1, 3},
        {"#1=[1+2", "", 1, 8},
        {"#1=[[[[[[1]]]]]]", "118", 1, 9},
        {"#0=1", "116", 1, 1},
        {"#300=1", "115", 1, 1},
        {"#3000=7(CHUCK OPEN)", "3007", 1, 1},
        // offsets have the range of G10 (fanuc_lathe 1.1, 1.8)
        {"#2301=10", "32", 1, 1},
        {"#2701=1000", "32", 1, 1},
        {"END1", "124", 1, 1},
        {"DO4", "126", 1, 3},
        {"WHILE[1 EQ 0]DO1\nM30", "124", 1, 1},
        {"IF[1 EQ 1]", "114", 1, 11},
        {"FOO 1", "9", 1, 1},
        {"G65 P1 G1", "129", 1, 8},
        {"A5. G65 P1", "129", 1, 1},               // arguments stand behind G65
        {"G0 X1.\nGOTO 55\nM30", "128", 2, 6},     // 128 also when the block is not there
        {"N#1 G0 X1.", "114", 1, 1},               // no variable in N, not even an empty one
        {"G10 L50\nN6241 R200.\nG11", "7", 2, 7},  // whole numbers (fanuc_lathe 7)
    };
    for (const FaultRow& row : rows) {
        SCOPED_TRACE(std::string(row.program));
        const Played played = play(row.program);
        const std::string alarm = played.find({R"("ev":"alarm")", R"("severity":"error")"});
        ASSERT_FALSE(alarm.empty()) << played.events;
        if (!row.number.empty()) {
            EXPECT_NE(alarm.find("\"number\":" + std::string(row.number) + ","), std::string::npos)
                << alarm;
        }
        if (row.line) {
            EXPECT_NE(alarm.find("\"line\":" + std::to_string(row.line) + ","), std::string::npos)
                << alarm;
        }
        if (row.column) {
            EXPECT_NE(alarm.find("\"column\":" + std::to_string(row.column) + ","),
                      std::string::npos)
                << alarm;
        }
    }
}

TEST(MacroFlow, LoopsJumpsAndConditions) {
    const Played played = play(
        "#100=0\n#1=1\nWHILE[#1 LE 3]DO1\n#100=#100+#1\n#1=#1+1\nEND1\n"
        "N10 IF[#100 EQ 6]GOTO 30\n#101=9\nN30 IF[#100 EQ 6]THEN #102=4\n"
        "GOTO 50\n#103=1\nN50 M30\n");
    EXPECT_TRUE(played.has({R"("name":"#100","value":6)"})) << played.events;
    EXPECT_FALSE(played.has({"#101"})) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#102","value":4)"})) << played.events;
    EXPECT_FALSE(played.has({"#103"})) << played.events;
    EXPECT_EQ(played.errors, 0u);
    // the END of a loop that is left out may have a skip sign
    const Played skip = play("WHILE[1 EQ 0]DO1\n#101=1\n/N5 END1\n#102=2\nM30\n");
    EXPECT_EQ(skip.errors, 0u) << skip.events;
    EXPECT_TRUE(skip.has({"#102"}));
}

// Round brackets are comments (fanuc_lathe 6.4), wherever a blank may stand.
TEST(MacroComment, MayStandAnywhereInAStatement) {
    const std::pair<std::string_view, std::string_view> rows[] = {
        {"#100=2+3(ABC)+4", "9"},
        {"#100(DEPTH)=5", "5"},
        {"#(NUMBER)100=5", "5"},
        {"#100=(A)5", "5"},
        {"#100=-(A)5", "-5"},
        {"#100=SIN(HALF)[30]", "0.5"},
        {"#100=[(A)2(B)+(C)3(D)](E)*(F)2 (G)", "10"},
        {"#100=ATAN[1](A)/(B)[1]", "45"},
        {"#1=3\n#100=#(A)1(B)(C)+1", "4"},
        {"#100=7(LAST)", "7"},
        {"IF [1 EQ (ONE) 1] THEN #100=1", "1"},
        {"IF (A) [1 EQ 1] THEN (ABC) #100=2", "2"},
        {"#100=1\nIF [1 EQ 1] (ABC) GOTO (LABEL) 5\n#100=2\nN5", "1"},
        {"#1=0\nWHILE [#1 LT 2] (LOOP) DO (ONE) 1\n#1=#1+1\n#100=#1\nEND (ONE) 1", "2"},
        {"#100=1\nWHILE (A]) [1 EQ 0] (LOOP) DO 1\n#100=2\nEND1", "1"},
        {"(A) N10 (B) #100=5", "5"},
    };
    for (const auto& [program, value] : rows) {
        SCOPED_TRACE(std::string(program));
        const Played played = play(std::string(program) + "\nM30\n");
        EXPECT_EQ(played.errors, 0u) << played.events;
        std::string last;
        for (const std::string& line : played.lines())
            if (line.find(R"("name":"#100")") != std::string::npos) last = line;
        EXPECT_NE(last.find(R"("value":)" + std::string(value) + "}"), std::string::npos) << last;
    }
    for (const char* x :
         {"G0 X[10+(A)5]", "G0 X(A)15.", "G0 X(A)[15]", "G0 X-(A)[-15]", "G0 X - (A) -15."}) {
        const Played played = play(std::string(x) + "\nM30\n");
        EXPECT_EQ(played.has({R"("pos":{"X":15,)"}), std::string_view(x) != "G0 X - (A) -15.")
            << x << played.events;
    }
    const Played text = play("#3006=1(A)(B)\n#3000(NUMBER)=7(CHUCK OPEN)\nM30\n");
    EXPECT_TRUE(text.has({R"("number":"3007")", "CHUCK OPEN"}) ||
                text.has({R"("number":3007)", "CHUCK OPEN"}))
        << text.events;
    EXPECT_TRUE(text.has({R"("ev":"message")", R"("A")"})) << text.events;
    EXPECT_EQ(play("#100=2+(ABC\nM30\n").errors, 1u);  // a comment that does not end
}

TEST(MacroValue, MayBeAsSmallAsTheControlCounts) {  // fanuc_lathe 6.1: 0 and 1E-29 to 1E47
    const Played played =
        play("#1=.0000001*.0000001*.0000001*.0000001\n#100=#1*10\n#101=#1-#1\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#101","value":0)"})) << played.events;
}

TEST(MacroNames, StandForTheirVariables) {  // the field's standard for SETVN
    const Played played = play(
        "SETVN 510[TOOL_NO,COUNT]\n[#COUNT]=3\n[#TOOL_NO]=[#COUNT]*[#COUNT]+1\n"
        "#100=#[510]\nG0 X[#COUNT] Z[[#COUNT]+1]\n"
        "IF[[#COUNT]EQ 3]THEN [#COUNT]=4\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#511","value":3)"})) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#510","value":10)"})) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#100","value":10)"})) << played.events;
    EXPECT_TRUE(played.has({R"("pos":{"X":3,"Z":4,)"})) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#511","value":4)"})) << played.events;
}

TEST(MacroWord, IsRoundedToTheIncrementWithAHalfAwayFromZero) {  // fanuc_lathe 6.1, 6.4
    const Played lengths = play("#1=1.2345\n#2=1.0005\nG0 W#1\nZ-#1\nZ#2\nZ[ROUND[#2]]\nM30\n");
    for (const char* z : {R"("Z":1.235)", R"("Z":-1.235)", R"("Z":1.001)"})
        EXPECT_TRUE(lengths.has({z})) << z << lengths.events;
    const Played codes = play("#1=2.5\n#2=80.5\nM[#2]\nG[#1]\nM30\n");
    EXPECT_TRUE(codes.has({R"("code":"M81")"})) << codes.events;
}

TEST(MacroWord, OfAnEmptyVariableDoesNotExist) {
    const Played played = play("G0 X5. Z5.\nX#1 Z7.\nM30\n");
    EXPECT_TRUE(played.has({R"("pos":{"X":5,"Z":7,)"})) << played.events;
}

TEST(MacroValue, OfTheMachineIsReadAtABarrier) {
    const Played played = play("G0 X8. Z3.\n#100=#5042\n#101=#5021\nM30\n");
    EXPECT_TRUE(played.has({R"("name":"#100","value":3)"})) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#101","value":8)"})) << played.events;
}

}  // namespace
}  // namespace polyturn::channels::testing
