// What a sinumerik program finds that the last one in its channel has left, section in brackets
// (part 3).
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

// Runs both programs one after the other; the events of the second one.
Played behind(std::string_view first, std::string_view second,
              const std::vector<std::string>& sets = {}) {
    const auto table = lathe(sets);
    text::Setup setup;
    Played played;
    std::any left;
    for (const std::string_view program : {first, second}) {
        MachineView view = make_machine_view(*table, 1);
        view.store->zeros[1 * kChannelAxes + 1] = 100;  // G54 Z
        ProgramFiles files;
        played.events.clear();
        EventSink sink({&view, &files, Dialect::Sinumerik}, played.events, true, '\n');
        CheckPort port(setup, 1, true);
        const auto main = files.open_text(program, "test.nc");
        const auto language = make_language("sinumerik", view, sink, port, files);
        EXPECT_TRUE(language->start(*main).ok());
        language->core().start_at_machine(view.start);
        if (left.has_value()) language->take_carry(left, false);
        run_to_end(*language);
        played.errors = sink.errors();
        left = language->carry();
    }
    return played;
}

bool sets(const Played& played, const std::string& name, const std::string& value) {
    return played.has({"\"name\":\"" + name + "\",\"value\":" + value + "}"});
}

TEST(SinumerikProgramEnd, LeavesVariablesTextsAndTables) {
    // 11.5
    EXPECT_TRUE(sets(behind("R5=7\nM30\n", "R6=R5\nM30\n"), "R6", "7"));
    // 7.16
    EXPECT_TRUE(
        sets(behind("DEF INT ERR\nWRITE(ERR,\"LOG\",\"A\")\nM30\n", "R1=ISFILE(\"LOG\")\nM30\n"),
             "R1", "1"));
    // 9.3
    EXPECT_TRUE(
        sets(behind("CTABDEF(X,Z,3,0)\nZ0 X0\nZ10 X5\nCTABEND\nM30\n", "R1=CTABEXISTS(3)\nM30\n"),
             "R1", "1"));
    EXPECT_TRUE(
        sets(behind("$P_UIFR[2]=CTRANS(Z,5):CFINE(Z,1)\nM30\n", "R1=$P_UIFR[2,Z,FI]\nM30\n"), "R1",
             "1"));
    EXPECT_TRUE(behind("M30\n", "M30\n").has({"\"ev\":\"part\"", "\"count\":2"}));
    EXPECT_EQ(behind("DEF INT OWN=3\nM30\n", "R1=OWN\nM30\n").errors, 1u)
        << "its own names end with a program";
}

TEST(SinumerikProgramEnd, KeepsGCommandsWhereMd20152SaysSo) {  // 2
    const char* const ask = "R1=$P_GG[14] R2=$P_GG[6] R3=$P_GG[8]\nG0 Z5\nM30\n";
    const Played begun = behind("G91 G18 G54\nM30\n", ask);
    EXPECT_TRUE(sets(begun, "R1", "1") && sets(begun, "R2", "1") && sets(begun, "R3", "1"))
        << begun.events;
    EXPECT_TRUE(begun.has({"\"ev\":\"move\"", "\"machine\":{\"X\":0,\"Z\":5"})) << begun.events;
    const Played kept = behind("G18 G54\nM30\n", ask, {"MD20152[5]=1", "MD20152[7]=1"});
    EXPECT_TRUE(sets(kept, "R1", "1") && sets(kept, "R2", "2") && sets(kept, "R3", "2"))
        << kept.events;
    EXPECT_TRUE(kept.has({"\"ev\":\"move\"", "\"machine\":{\"X\":0,\"Z\":105"})) << kept.events;
    EXPECT_TRUE(sets(behind("G91\nM30\n", ask, {"MD20152[13]=1"}), "R1", "2"));
}

TEST(SinumerikProgramEnd, LeavesStaticActionsOnly) {  // 8
    const char* const next = "R1=1\nG0 X5\nM30\n";
    EXPECT_TRUE(behind("IDS=1 EVERY R1==1 DO M8\nM30\n", next).has({"\"code\":\"M8\""}));
    EXPECT_FALSE(behind("ID=1 EVERY R1==1 DO M8\nM30\n", next).has({"\"code\":\"M8\""}));
}

}  // namespace
}  // namespace polyturn::channels::testing
