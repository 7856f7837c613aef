// What a fagor program finds that the last one in its channel has left, section in brackets (part
// 1, part 2).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

namespace fs = std::filesystem;

// Runs both programs one after the other; the events of the second one.
Played behind(std::string_view first, std::string_view second, const fs::path& memory = {}) {
    const auto table = lathe({});
    text::Setup setup;
    Played played;
    std::any left;
    for (const std::string_view program : {first, second}) {
        MachineView view = make_machine_view(*table, 1);
        view.store->zeros[1 * kChannelAxes + 1] = 100;  // G54 Z
        ProgramFiles files;
        if (!memory.empty()) {
            files.add_folder(memory.string());
            files.keep_in(memory.string());
        }
        played.events.clear();
        EventSink sink({&view, &files, Dialect::Fagor}, played.events, true, '\n');
        CheckPort port(setup, 1, true);
        const auto main = files.open_text(program, "test.nc");
        const auto language = make_language("fagor", view, sink, port, files);
        EXPECT_TRUE(language->start(*main).ok());
        language->core().start_at_machine(view.start);
        if (left.has_value() && memory.empty()) language->take_carry(left, false);
        run_to_end(*language);
        played.errors = sink.errors();
        left = language->carry();
    }
    return played;
}

TEST(FagorProgramEnd, LeavesParametersTablesAndTheZeroOffset) {
    // 11.2.1
    EXPECT_TRUE(behind("(P150=7)\nM30\n", "(P100=P150)\nM30\n").has({"P100", ":7"}));
    // local ones end with their program
    EXPECT_TRUE(behind("(A=7)\nM30\n", "(P100=A)\nM30\n").has({"P100", ":0"}));
    // 11.2.2
    EXPECT_TRUE(
        behind("(TLFD5=9, NOSEW5=3)\nM30\n", "(P100=TLFD5*10+NOSEW5)\nM30\n").has({"P100", ":93"}));
    // 4.4.2: M30 keeps it
    EXPECT_TRUE(behind("G54\nM30\n", "(P100=ORGZ, P101=GS54)\nM30\n").has({"P100", ":100"}));
    EXPECT_TRUE(behind("G54\nM30\n", "G00 Z5\nM30\n").has({"\"Z\":105"}));
    // 9.1: scale and mirror end
    EXPECT_TRUE(behind("G72 S2\nG11\nM30\n", "G152 G00 X5\nM30\n").has({"\"X\":5,"}));
    // 3.8
    EXPECT_TRUE(behind("G20 K2 X1 Z-5\nM30\n", "(P100=SZLOZ)\nM30\n").has({"P100", ":-5"}));
    // 11.2.14
    EXPECT_TRUE(behind("M30\n", "(P100=PARTC)\nM30\n").has({"P100", ":1"}));
    EXPECT_TRUE(behind("M30\n", "(P100=FIRST)\nM30\n").has({"P100", ":0"}));
    EXPECT_TRUE(behind("T3 D2\nM30\n", "(P100=TOOL*10+TOD)\nM30\n").has({"P100", ":32"}));
    // 12.7
    EXPECT_TRUE(
        behind("(OPEN P9)\n(WRITE (P100=5))\nM30\n", "(EXEC P9)\nM30\n").has({"P100", ":5"}));
}

// 4.4.1: the limit stands until power-off; said again it is told again, for the spindle may turn
// without it.
TEST(FagorProgramEnd, G92SIsToldAlthoughTheLastProgramSaidTheSame) {
    const Played played = behind("G92 S1500\nM30\n", "S1400 M3\nG92 S1500\nM30\n");
    EXPECT_EQ(played.errors, 0u);
    EXPECT_TRUE(
        played.has({"\"ev\":\"spindle\"", "\"line\":2", "\"value\":1400", "\"limit\":1500"}))
        << played.events;
}

TEST(FagorProgramMemory, KeepsWhatProgramsWrite) {
    const fs::path memory = fs::temp_directory_path() / "polyturn_fagor_memory";
    fs::remove_all(memory);
    fs::create_directory(memory);
    EXPECT_TRUE(behind("(OPEN P9, \"COUNT\")\n(WRITE (P100=5))\nM30\n", "(EXEC P9)\nM30\n", memory)
                    .has({"P100", ":5"}));
    std::ifstream file(memory / "000009.PIT");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    EXPECT_EQ(text, "%COUNT,MX,\n(P100=5)\n");
    EXPECT_GT(behind("M30\n", "(OPEN P9)\nM30\n", memory).errors, 0u);  // it exists
    EXPECT_TRUE(behind("(OPEN P9, A)\n(WRITE (P101=6))\nM30\n", "(EXEC P9)\nM30\n", memory)
                    .has({"P101", ":6"}));
    fs::remove_all(memory);
}

}  // namespace
}  // namespace polyturn::channels::testing
