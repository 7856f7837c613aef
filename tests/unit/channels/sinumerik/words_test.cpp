// Every word of the language acts, asks for what the machine does anyway, warns, or is refused:
// what the tables say (fate.hpp) is what happens. Of each word that acts words_that_act.txt has a
// program in which it does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "../play.hpp"
#include "../quiet_sink.hpp"
#include "channels/forwarding_sink.hpp"
#include "channels/sinumerik/grammar/fate.hpp"
#include "tests/places.hpp"

namespace polyturn::channels::testing {
namespace {

using namespace sinumerik;

constexpr const char* kHead = "G18 G90 G94 DIAMOF F100 S500 M3\nG0 X20 Z5\n";

// Events, and behind them what the machine is told that no event shows: feeds and limits of a move,
// its way out, signals, waits, barriers.
class Everything final : public ForwardingSink {
public:
    Everything(Sink& events, std::string& out) : ForwardingSink(&events), out_(&out) {}
    void move(const Move& m, const BlockContext& at) override {
        ForwardingSink::move(m, at);
        say(fmt::format(
            "move {} {} {} of {} scale {} limit {} slow {} {} {} sweep {} angle {} out {} {} {} {} "
            "{} {} beside {} nose {} {}",
            m.exact_stop, m.in_position, m.override_locked, m.spindle, m.feed_scale, m.speed_limit,
            m.slow_head, m.slow_tail, m.slow_share, m.sweep, m.start_angle, m.withdraw_axis[0],
            m.withdraw_axis[1], m.withdraw_axis[2], m.withdraw[0], m.withdraw[1], m.withdraw[2],
            m.beside, m.nose[0], m.nose[1]));
    }
    void wait(const Wait& w, const BlockContext& at) override {
        ForwardingSink::wait(w, at);
        say(fmt::format("wait {} {} {}", static_cast<int>(w.act), w.axes, w.spindles));
    }
    void signal(std::string_view name, double value, const BlockContext& at) override {
        ForwardingSink::signal(name, value, at);
        say(fmt::format("signal {} {}", name, value));
    }
    void barrier(const BlockContext& at) override {
        ForwardingSink::barrier(at);
        say("barrier");
    }
    void interrupts(const Interrupts& i, const BlockContext& at) override {
        ForwardingSink::interrupts(i, at);
        say(fmt::format("interrupts {} {}", i.on, i.inputs));
    }

private:
    void say(const std::string& text) { *out_ += text + '\n'; }
    std::string* out_;
};

struct Heard : Played {
    std::string all;  // of Everything
};

Heard run(const std::string& program, const std::vector<std::string>& sets = {},
          bool everything = false) {
    const auto table = lathe(sets);
    MachineView view = make_machine_view(*table, 1);
    const text::Setup setup;
    ProgramFiles files;
    Heard heard;
    EventSink events({&view, &files, Dialect::Sinumerik}, heard.events, true, '\n');
    Everything all(events, everything ? heard.events : heard.all);
    CheckPort port(setup, 1, true);
    const auto main = files.open_text(program, "test.nc");
    const auto interpreter = make_language("sinumerik", view, all, port, files);
    EXPECT_TRUE(interpreter->start(*main).ok());
    interpreter->core().start_at_machine(view.start);
    run_to_end(*interpreter);
    heard.errors = events.errors();
    return heard;
}

// What happens, without the places in the text where it stands.
std::string happenings(const Played& played) {
    std::string out;
    for (std::string line : played.lines()) {
        for (const std::string_view key : {"\"line\":", "\"column\":"})
            if (const auto at = line.find(key); at != std::string::npos) {
                const auto end = line.find_first_of(",}", at);
                line.erase(at, end - at);
            }
        out += line + '\n';
    }
    return out;
}

std::size_t warnings_of(const Played& played, const std::string& word) {
    std::size_t found = 0;
    for (const std::string& line : played.lines())
        found += line.find("\"PT1576\"") != std::string::npos &&
                 line.find("\"" + word + " has no effect") != std::string::npos;
    return found;
}

struct Proof {
    std::string program;
    std::vector<std::string> sets;
    // what it does ends in an alarm here: there is no such file, tool or transformation
    bool alarms = false;
};

std::string trimmed(const std::string& text) {
    const auto from = text.find_first_not_of(' '), to = text.find_last_not_of(' ');
    return from == std::string::npos ? std::string() : text.substr(from, to - from + 1);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

std::multimap<std::string, Proof> proofs() {
    std::multimap<std::string, Proof> out;
    std::ifstream file(std::string(kSourceFolder) +
                       "/tests/unit/channels/sinumerik/words_that_act.txt");
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        const auto bar = line.find(" | ");
        if (bar == std::string::npos) {
            ADD_FAILURE() << line;
            continue;
        }
        std::string words = line.substr(0, bar), sets;
        Proof proof;
        if (words.ends_with(" !")) {
            proof.alarms = true;
            words.resize(words.size() - 2);
        }
        if (const auto at = words.find("#set "); at != std::string::npos) {
            sets = words.substr(at + 5);
            words.resize(at);
        }
        proof.program = line.substr(bar + 3);
        std::istringstream parts(sets);
        for (std::string one; std::getline(parts, one, ',');) proof.sets.push_back(trimmed(one));
        std::istringstream names(words);
        for (std::string word; names >> word;) {
            Proof own = proof;
            own.program = replaced(replaced(own.program, "@", word), " \\ ", "\n");
            out.emplace(word, own);
        }
    }
    return out;
}

// The program with the word, or what stands in its place without it.
std::string with_or_without(const std::string& program, bool with) {
    std::string out;
    for (std::size_t at = 0;;) {
        const auto open = program.find("<<", at), close = program.find(">>", at);
        if (open == std::string::npos || close == std::string::npos)
            return out + program.substr(at);
        std::string inner = program.substr(open + 2, close - open - 2), other;
        if (const auto mark = inner.find('~'); mark != std::string::npos) {
            other = inner.substr(mark + 1);
            inner.resize(mark);
        }
        out += program.substr(at, open - at) + (with ? inner : other);
        at = close + 2;
    }
}

TEST(SinumerikWords, ThatActChangeWhatHappens) {
    for (const auto& [word, proof] : proofs()) {
        if (proof.program.starts_with("in ")) {
            std::ifstream file(std::string(kSourceFolder) + "/" + proof.program.substr(3));
            const std::string text{std::istreambuf_iterator<char>(file), {}};
            EXPECT_NE(text.find(word), std::string::npos)
                << word << " does not stand " << proof.program;
            continue;
        }
        const Heard with = run(kHead + with_or_without(proof.program, true) + "\nM30\n", proof.sets,
                               true),
                    without = run(kHead + with_or_without(proof.program, false) + "\nM30\n",
                                  proof.sets, true);
        EXPECT_EQ(with.errors != 0, proof.alarms) << word << ": " << proof.program << '\n'
                                                  << with.events;
        EXPECT_TRUE(happenings(with) != happenings(without))
            << word << ": " << proof.program << '\n'
            << with.events;
        EXPECT_EQ(warnings_of(with, word), 0u) << word << with.events;
    }
}

// Several G commands of one kind have a row for the first of them only.
bool is_expanded(std::string_view name) {
    return (name.starts_with("G5") && name.size() == 4 && name != "G505") ||
           (name.starts_with("GFRAME") && name != "GFRAME0");
}

TEST(SinumerikWords, ThatActHaveAProof) {
    const auto all = proofs();
    std::string missing;
    const auto look = [&](std::string_view name, Fate fate) {
        if (is_expanded(name)) return;
        if (fate == Fate::Acts && !all.count(std::string(name))) missing += " " + std::string(name);
        if (fate != Fate::Acts) {
            EXPECT_FALSE(all.count(std::string(name))) << name << " does not act";
        }
    };
    for (const GCode& row : g_codes()) look(row.name, fate_of(row));
    for (const Address& row : addresses()) look(row.name, fate_of(row));
    for (const auto rows : {geometry_commands(), program_commands()})
        for (const Command& row : rows) look(row.name, fate_of(row));
    for (const Statement& row : statements()) look(row.name, fate_of(row));
    // where a short last element has two meetings with the way out (short_elements.cpp): no program
    // here shows it
    EXPECT_EQ(missing, " CDOF CDON CDOF2");
}

// One warning a word and program, however often it stands there; and it changes nothing else.
TEST(SinumerikWords, WithoutEffectWarnOnce) {
    const std::string body = "G0 X30 Z0\nG1 X40 F200\n";
    const std::string plain = happenings(run(kHead + body + "M30\n"));
    const auto check = [&](const std::string& name, const std::string& block) {
        const Played played = run(kHead + block + "\n" + body + block + "\nM30\n");
        EXPECT_EQ(played.errors, 0u) << name << played.events;
        EXPECT_EQ(warnings_of(played, name), 1u) << name << played.events;
        const std::string warning = played.find({"PT1576"});
        EXPECT_NE(warning.find("\"line\":3,"), std::string::npos) << name << warning;
        EXPECT_NE(warning.find("\"column\":1,"), std::string::npos) << name << warning;
    };
    std::size_t codes = 0;
    for (const GCode& row : g_codes())
        if (fate_of(row) == Fate::Warns) {
            ++codes;
            check(std::string(row.name), std::string(row.name));
        }
    EXPECT_GE(codes, 97u);
    const std::map<std::string, std::string> own = {
        {"MMC", "MMC(\"A\",\"N\")"}, {"IPOBRKA", "IPOBRKA(X)"}, {"BRISKA", "BRISKA(X)"},
        {"DRIVEA", "DRIVEA(X)"},     {"FMA", "FMA[2,X]=5"},     {"FD", "FD=5 G60 G1 X20"},
        {"FDA", "FDA[Z]=5"}};
    for (const Address& row : addresses()) {
        if (fate_of(row) != Fate::Warns) continue;
        const std::string name(row.name);
        const auto found = own.find(name);
        const std::string index =
            row.index == Address::Index::Axis || row.index == Address::Index::Spindle ? "[X]" : "";
        check(name,
              found != own.end() ? found->second : name + index + (row.valueless ? "" : "=1"));
    }
    for (const Command& row : program_commands()) {
        const std::string name(row.name);
        if (fate_of(row) != Fate::Warns) continue;
        // in synchronized actions only
        if (name == "RESET" || name == "ICYCON" || name == "ICYCOF") {
            EXPECT_EQ(warnings_of(run(kHead + std::string("ID=1 DO ") + name +
                                      (name == "RESET" ? "(1)" : "") + "\n" + body + "M30\n"),
                                  name),
                      1u)
                << name;
            continue;
        }
        const auto found = own.find(name);
        check(name, found != own.end() ? found->second : name);
    }
    EXPECT_EQ(plain.find("PT1576"), std::string::npos);
}

// What the corners of a program ask for beyond G64; a rounding of 0 is none.
TEST(SinumerikWords, OfRoundingCutAsG64AndSaySo) {
    for (const char* code : {"G641", "G642", "G643", "G644", "G645"}) {
        const std::string text = happenings(run(kHead + std::string(code) + " G1 X30\nM30\n")),
                          g64 = happenings(run(kHead + std::string("G64 G1 X30\nM30\n")));
        EXPECT_EQ(text.substr(text.find("\"move\"", text.find("PT1576"))),
                  g64.substr(g64.find("\"move\"", g64.find("\"move\"") + 1)))
            << text;
    }
    EXPECT_EQ(warnings_of(run("ADIS=0 ADISPOS=0\nM30\n"), "ADIS"), 0u);
    EXPECT_EQ(warnings_of(run("ADIS=0.5\nM30\n"), "ADIS"), 1u);
}

// A return that restores the caller's modes has not programmed them.
TEST(SinumerikWords, ThatAReturnRestoresAreNotWarnedOf) {
    const Played played = run("SOFT G1 F100 X1\nM30\n");
    EXPECT_FALSE(played.has({"PT1576"})) << played.events;
}

TEST(SinumerikWords, AsTheMachineDoesAnywayChangeNothing) {
    const std::string body = "G0 X30 Z0\nG1 X40 F200\nM30\n";
    const std::string plain = happenings(run(kHead + body));
    const std::map<std::string, std::string> own = {
        {"TCARR", "TCARR=0"},       {"CUTMOD", "CUTMOD=0"},
        {"FINEA", "FINEA[X]"},      {"GEOAX", "GEOAX(1,X)"},
        {"SOFTA", "SOFTA(X)"},      {"JERKA", "JERKA(X)"},
        {"CYCLE800", "CYCLE800()"}, {"TLIFT", "TANG(C,X,Z)\nTLIFT(C)"}};
    const auto check = [&](const std::string& name) {
        const auto found = own.find(name);
        const Played played =
            run(kHead + (found == own.end() ? name : found->second) + "\n" + body);
        EXPECT_EQ(happenings(played), plain) << name;
    };
    for (const GCode& row : g_codes())
        if (fate_of(row) == Fate::AsMachine) check(std::string(row.name));
    for (const Address& row : addresses())
        if (fate_of(row) == Fate::AsMachine) check(std::string(row.name));
    for (const Command& row : program_commands())
        if (fate_of(row) == Fate::AsMachine) check(std::string(row.name));
    EXPECT_EQ(run("TCARR=2\nM30\n").errors, 1u);
    EXPECT_EQ(run("CUTMOD=1\nM30\n").errors, 1u);
}

// All other names of sinumerik_part3 3: as a word of a block each of them stops the program.
TEST(SinumerikWords, ThatAreRefusedStopTheProgram) {
    const std::string number(alarm_number(Alarm::NotBuilt, Dialect::Sinumerik));
    const auto check = [&](const std::string& name, const std::string& block) {
        const Played played = run(block + "\nM30\n");
        EXPECT_EQ(played.errors, 1u) << name << played.events;
        EXPECT_TRUE(played.has({"\"number\":" + number, name})) << name << played.events;
    };
    for (const GCode& row : g_codes())
        if (fate_of(row) == Fate::Refused && !row.name.starts_with("CUT3D"))
            check(std::string(row.name), std::string(row.name) + " X5");
    for (const Command& row : program_commands())
        if (fate_of(row) == Fate::Refused) check(std::string(row.name), std::string(row.name));
    for (const Statement& row : statements())
        if (fate_of(row) == Fate::Refused) check(std::string(row.name), std::string(row.name));
    for (const std::string_view name : reserved_words()) {
        if (find_symbol(name).kind != Symbol::Kind::Reserved) continue;
        if (name == "D0") continue;  // D with its number
        EXPECT_EQ(run(std::string(name) + "\nM30\n").errors, 1u) << name;
    }
}

// SBLOF until SBLON, or in a subprogram whose PROC says so: the machine is told, each time that it
// changes.
TEST(SinumerikWords, OfSingleBlockReachTheMachine) {
    struct Told final : QuietSink {
        std::vector<double> bits;
        void signal(std::string_view name, double value, const BlockContext&) override {
            if (name == "CONTROL") bits.push_back(value);
        }
    };
    const auto told = [](std::string_view program) {
        const auto table = lathe({});
        MachineView view = make_machine_view(*table, 1);
        ProgramFiles files;
        Told sink;
        const text::Setup setup;
        CheckPort port(setup, 1, true);
        const auto main = files.open_text(program, "test.nc");
        const auto language = make_language("sinumerik", view, sink, port, files);
        EXPECT_TRUE(language->start(*main).ok());
        run_to_end(*language);
        return sink.bits;
    };
    EXPECT_EQ(told("G4 F1\nSBLOF\nG4 F1\nSBLOF\nSBLON\nG4 F1\nM30\n"), (std::vector<double>{1, 0}));
    EXPECT_EQ(told("SBLON\nM30\n"), std::vector<double>{});
}

TEST(SinumerikWords, SynchronizedActionsSayOnceWhenTheyAct) {
    const Played played =
        run("ID=1 WHENEVER $AA_IM[Z]>5 DO M8\nWHEN $AA_IM[Z]>7 DO M9\n"
            "G0 X5\nEVERY TRUE DO M8\nG0 X6\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    std::size_t told = 0;
    for (const std::string& line : played.lines())
        told += line.find("\"PT1625\"") != std::string::npos;
    EXPECT_EQ(told, 1u) << played.events;
    EXPECT_TRUE(played.has({"\"PT1625\"", "\"line\":1,", "\"column\":", "WHENEVER"}))
        << played.events;
    for (const char* action : {"DO M8", "WHEN TRUE DO M8", "WHENEVER TRUE DO M8",
                               "EVERY TRUE DO M8", "FROM TRUE DO M8", "ID=1 DO M8", "IDS=1 DO M8"})
        EXPECT_TRUE(run(std::string(action) + "\nG0 X5\nM30\n")
                        .has({"\"PT1625\"", "\"severity\":\"warning\""}))
            << action;
    EXPECT_FALSE(run("G0 X5\nM30\n").has({"PT1625"}));
}

}  // namespace
}  // namespace polyturn::channels::testing
