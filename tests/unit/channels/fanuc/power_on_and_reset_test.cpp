// What holds when an nct control is switched on (N1300, N1301; nct part 1 14.1), bit by bit, and
// which G groups outlive a reset (N1301 CLR with N1302 to N1306; 14.2): one row for each bit, seen
// with it and without it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

// C would make H its increment.
const std::vector<std::string> kMill{"N0001 L1=1", "N0002 A5=0"};

struct PowerOn {
    const char* bit;
    const char* program;
    std::vector<std::string> with, without;  // parts of an event that is there then
    std::vector<std::string> sets;
};

Played first_blocks(const PowerOn& row, bool on) {
    Play how;
    how.language = "nct";
    how.sets = row.sets;
    how.sets.insert(how.sets.begin(), {"N1300 L1=2", "N1301 L1=0", "N0300 L1=100", "N0301 L1=0.2"});
    const std::string name(row.bit);
    how.sets.push_back(name + "=" + (on ? "1" : "0"));
    return play(std::string(row.program) + "\nM30\n", how, [](MachineView& view) {
        view.store->offsets[3].geometry = {0, 0, 7};
    });
}

TEST(NctPowerOn, EachBitOfN1300AndN1301Chooses) {
    const std::vector<std::string> y{"N0002 A7=1", "N0100 A7=89", "N0103 A7=2"};
    std::vector<std::string> y_only = y, lathe_with_g43{"N1414 L1=01000001", "N0002 A5=0"};
    y_only.push_back("N1300#1 L1=0");
    const PowerOn rows[] = {
        {"N1300#0 L1", "Z5.", {"\"kind\":\"linear\""}, {"\"kind\":\"rapid\""}, {}},
        {"N1300#1 L1", "G2 X20. Z-10. R10.", {"\"kind\":\"cw\""}, {"\"ev\":\"alarm\""}, {}},
        {"N1300#2 L1", "G2 Y10. Z-10. J0 K-10.", {"\"kind\":\"cw\""}, {"\"ev\":\"alarm\""}, y_only},
        {"N1300#3 L1", "Z1.", {"\"Z\":25.4"}, {"\"Z\":1,"}, {}},
        {"N1300#5 L1",
         "Z10. H3",
         {"\"machine\":{\"X\":0,\"Z\":17"},
         {"\"ev\":\"alarm\""},
         lathe_with_g43},
        {"N1300#6 L1",
         "Z10. H3",
         {"\"machine\":{\"X\":0,\"Z\":3"},
         {"\"ev\":\"alarm\""},
         lathe_with_g43},
        {"N1300#5 L1", "Z10. H3", {"\"Z\":17"}, {"\"ev\":\"alarm\""}, kMill},
        {"N1300#6 L1", "Z10. H3", {"\"Z\":3"}, {"\"ev\":\"alarm\""}, kMill},
        {"N1300#7 L1", "Z5.\nZ5.", {"\"Z\":10"}, {"\"Z\":5"}, {}},
        {"N1301#0 L1", "G97 S500 M3\nG1 Z5.", {"\"per_rev\"", "0.2"}, {"\"per_min\"", "100"}, {}},
    };
    for (const PowerOn& row : rows) {
        const Played on = first_blocks(row, true), off = first_blocks(row, false);
        EXPECT_TRUE(on.has(row.with)) << row.bit << " on: " << on.events;
        EXPECT_FALSE(off.has(row.with)) << row.bit << " off: " << off.events;
        EXPECT_TRUE(off.has(row.without)) << row.bit << " off: " << off.events;
    }
    // G43 wins where both are on.
    Play both;
    both.language = "nct";
    both.sets = {"N1300 L1=01100010", "N1414 L1=01000001", "N0002 A5=0"};
    EXPECT_TRUE(play("Z10. H3\nM30\n", both, [](MachineView& view) {
                    view.store->offsets[3].geometry = {0, 0, 7};
                }).has({"\"Z\":17"}));
}

// Runs both programs one after the other in one channel; a reset between them. Events of the second
// one.
Played behind_reset(const std::string& first, const std::string& second,
                    const std::vector<std::string>& sets) {
    const auto table = lathe(sets);
    text::Setup setup;
    Played played;
    std::any left;
    for (const std::string& program : {first, second}) {
        MachineView view = make_machine_view(*table, 1);
        view.store->zeros[2 * kChannelAxes + 1] = 100;  // G55 Z
        view.store->offsets[3].geometry = {0, 0, 7};
        ProgramFiles files;
        played.events.clear();
        EventSink sink({&view, &files, Dialect::Nct}, played.events, true, '\n');
        CheckPort port(setup, 1, true);
        const auto main = files.open_text(program, "test.nc");
        const auto language = make_language("nct", view, sink, port, files);
        EXPECT_TRUE(language->start(*main).ok());
        language->core().start_at_machine(view.start);
        preset(*language, setup.channels[1]);
        if (left.has_value()) language->take_carry(left, true);
        run_to_end(*language);
        played.errors = sink.errors();
        left = language->carry();
    }
    return played;
}

TEST(NctReset, EachBitOfN1302ToN1306KeepsItsGroup) {
    struct Row {
        const char* bit;
        const char* first;
        const char* second;
        // parts of an event that is there when the group is kept, and only then
        std::vector<std::string> kept;
        std::vector<std::string> sets;
    };
    const Row rows[] = {
        {"N1302#1 L1", "G1 Z5.", "Z3.", {"\"kind\":\"linear\""}, {}},
        {"N1302#2 L1", "G17", "G2 X20. Z-10. R10. F100", {"\"ev\":\"alarm\""}, {}},
        {"N1302#3 L1", "G91 Z1.", "Z2.\nZ2.", {"\"Z\":4"}, {}},
        {"N1302#4 L1",
         "G23",
         "G0 Z-60.",
         {"\"Z\":-60"},
         {"N1001 L1=00000111", "N1000 A2=00000010", "N1006 A2=100", "N1007 A2=-50"}},
        {"N1302#5 L1", "G95 S500 M3", "S500 M3\nG1 Z5. F0.3", {"\"per_rev\""}, {}},
        {"N1302#6 L1", "G20", "Z1.", {"\"Z\":25.4"}, {}},
        {"N1302#7 L1",
         "G41 G1 X20. F100",
         "G1 Z-5. F100\nZ-10.\nG40 X50.",
         {"\"comp\":\"left\""},
         {}},
        {"N1303#0 L1",
         "G43 Z10. H3",
         "Z20.",
         {"\"machine\":{\"X\":0,\"Z\":27"},
         {"N1414 L1=01000001", "N0002 A5=0"}},
        {"N1303#1 L1", "G81 X0 Z-5. R2. F100", "X20.", {"\"Z\":-5"}, {"N1414 L1=01000001"}},
        {"N1303#2 L1",
         "G99",
         "G81 X0 Z-5. R2. F100\nG80\nG91 G0 Z10.",
         {"\"Z\":12"},
         {"N1414 L1=01000001"}},
        {"N1303#3 L1", "G51 X0 Z0 P2.", "Z10.", {"\"Z\":20"}, {}},
        {"N1303#5 L1", "G96 S100 M3", "M3\nG4 P1.", {"\"css\""}, {}},
        {"N1303#6 L1", "G55", "Z5.", {"\"Z\":105"}, {}},
        {"N1304#1 L1", "G16", "G1 Z10. X90. F100", {"\"pos\":{\"X\":20,\"Z\":0"}, {}},
        {"N1304#6 L1", "G51.1 X10.", "G1 X20. Z5. F100", {"\"pos\":{\"X\":0,\"Z\":5"}, {}},
        {"N1304#5 L1",
         "G0 X100. Z5.\nG12.1",
         "G1 X40. C10. F100",
         {"\"machine\":{\"X\":22.36"},
         {}},
    };
    for (const Row& row : rows) {
        const auto run = [&](bool clr, bool bit) {
            std::vector<std::string> sets{"N1300 L1=2",
                                          std::string("N1301 L1=") + (clr ? "10000000" : "0"),
                                          "N0300 L1=100", "N0301 L1=0.2"};
            sets.insert(sets.end(), row.sets.begin(), row.sets.end());
            sets.push_back(std::string(row.bit) + "=" + (bit ? "1" : "0"));
            return behind_reset(std::string(row.first) + "\nM30\n",
                                std::string(row.second) + "\nM30\n", sets);
        };
        const Played kept = run(true, true);
        EXPECT_TRUE(kept.has(row.kept)) << row.bit << " keeps: " << kept.events;
        EXPECT_FALSE(run(true, false).has(row.kept))
            << row.bit << " off: " << run(true, false).events;
        EXPECT_FALSE(run(false, true).has(row.kept))
            << row.bit << " without CLR: " << run(false, true).events;
    }
}

// fanuc_lathe 1.6: the reset cancels the offset, and M30 does (it resets and rewinds); a T entered
// by hand ends with its text and stays.
TEST(ToolOffset, IsInUseBehindATextThatEndsWithoutM30) {
    struct Row {
        const char* first;
        bool reset, kept;
    };
    for (const Row& row : {Row{"T0303\n", false, true}, Row{"T0303\n", true, false},
                           Row{"T0303\nM30\n", false, false}, Row{"T0303\nM2\n", false, false},
                           Row{"T0303\nM99\n", false, true}}) {
        SCOPED_TRACE(row.first);
        const auto table = lathe({});
        text::Setup setup;
        Played played;
        std::any left;
        for (const char* program : {row.first, "G0 Z5.\nM30\n"}) {
            MachineView view = make_machine_view(*table, 1);
            view.store->offsets[3].geometry = {0, 0, 7};
            ProgramFiles files;
            played.events.clear();
            EventSink sink({&view, &files, Dialect::Fanuc}, played.events, true, '\n');
            CheckPort port(setup, 1, true);
            const auto main = files.open_text(program, "test.nc");
            const auto language = make_language("fanuc", view, sink, port, files);
            EXPECT_TRUE(language->start(*main).ok());
            language->core().start_at_machine(view.start);
            if (left.has_value()) language->take_carry(left, row.reset);
            run_to_end(*language);
            left = language->carry();
            EXPECT_EQ(language->loses_offset(false),
                      std::string_view(program).find("M30") != std::string_view::npos ||
                          std::string_view(program).find("M2\n") != std::string_view::npos);
            EXPECT_TRUE(language->loses_offset(true));
        }
        EXPECT_TRUE(played.has(
            {row.kept ? "\"machine\":{\"X\":0,\"Z\":12" : "\"machine\":{\"X\":0,\"Z\":5"}))
            << played.events;
    }
}

// Exact stop tells no event: seen in the state. Macros are seen by their call.
TEST(NctReset, C15KeepsExactStopAndC12ModalCalls) {
    for (const bool keeps : {false, true}) {
        const auto table = lathe({"N1300 L1=2", "N1301 L1=10000000",
                                  std::string("N1303#7 L1=") + (keeps ? "1" : "0"),
                                  std::string("N1303#4 L1=") + (keeps ? "1" : "0")});
        std::any left;
        Played played;
        bool exact = false;
        for (const char* program : {"G61\nG66 P9010\nM30\n", "Z5.\nM30\n"}) {
            MachineView view = make_machine_view(*table, 1);
            text::Setup setup;
            ProgramFiles files;
            const auto library = files.open_text("O9010\nM77\nM99\n", "O9010.nc");
            EXPECT_TRUE(library.ok());
            played.events.clear();
            EventSink sink({&view, &files, Dialect::Nct}, played.events, true, '\n');
            CheckPort port(setup, 1, true);
            const auto main = files.open_text(program, "test.nc");
            const auto language = make_language("nct", view, sink, port, files);
            EXPECT_TRUE(language->start(*main).ok());
            language->core().start_at_machine(view.start);
            if (left.has_value()) language->take_carry(left, true);
            exact = language->core().path.exact_stop_mode;
            run_to_end(*language);
            left = language->carry();
        }
        EXPECT_EQ(exact, keeps);
        // The macro is looked for behind the move, and only then: it is no file here, so its call
        // is an alarm that names it.
        EXPECT_EQ(played.has({"9010"}) || played.has({"M77"}), keeps) << played.events;
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
