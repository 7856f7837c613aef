// Programs whose events were worked out by hand from the specification: one folder each below
// tests/golden/<language>. A folder with scenario.toml is run on the simulated machine, the others
// are checked; times and the summary are left out. POLYTURN_BLESS=1 writes what comes out, and
// fails; read the difference before it is committed.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "channels/check/check_mode.hpp"
#include "tests/places.hpp"
#include "tests/unit/channels/file_content.hpp"

namespace polyturn::channels {
namespace {

namespace fs = std::filesystem;

struct GoldenCase {
    fs::path folder;
    std::string language;
};

std::vector<GoldenCase> cases() {
    std::vector<GoldenCase> found;
    for (const char* language : {"fagor", "fanuc", "mefi", "nct", "sinumerik"}) {
        std::error_code error;
        for (const auto& entry :
             fs::directory_iterator(fs::path(kSourceFolder) / "tests/golden" / language, error))
            if (entry.is_directory()) found.push_back({entry.path(), language});
    }
    std::sort(found.begin(), found.end(),
              [](const GoldenCase& a, const GoldenCase& b) { return a.folder < b.folder; });
    return found;
}

// What a program said in all, and how it ended.
struct Said {
    std::string events, errors;
    int status = 0;
};

// What check prints, with the path of the program cut down to its name.
Said run(const GoldenCase& golden) {
    CheckOptions options;
    options.language = golden.language;
    options.machine.machine = (fs::path(kSourceFolder) / "examples/machines/twin-turret").string();
    options.program = (golden.folder / "program.nc").string();
    options.alone = options.variables = true;
    if (fs::exists(golden.folder / "setup.toml"))
        options.setup = (golden.folder / "setup.toml").string();
    std::istringstream sets(content(golden.folder / "sets"));
    for (std::string line; std::getline(sets, line);)
        if (!line.empty()) options.machine.sets.push_back(line);
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* out = ::open_memstream(&text, &size);
    Said said;
    said.status = run_check(options, out);
    std::fclose(out);
    said.events.assign(text, size);
    std::free(text);
    const std::string folder = golden.folder.string() + "/";
    for (std::size_t at; (at = said.events.find(folder)) != std::string::npos;)
        said.events.erase(at, folder.size());
    return said;
}

// What the simulated machine tells, without times and summary.
Said run_machine(const GoldenCase& golden) {
    std::string command = "cd '" + golden.folder.string() + "' && " + std::string(kProgramFolder) +
                          "/polyturn run --virtual --variables --language " + golden.language +
                          " --scenario scenario.toml";
    if (fs::exists(golden.folder / "setup.toml")) command += " --setup setup.toml";
    std::istringstream sets(content(golden.folder / "sets"));
    for (std::string line; std::getline(sets, line);)
        if (!line.empty()) command += " --set '" + line + "'";
    const fs::path errors =
        fs::temp_directory_path() / ("polyturn-golden-" + std::to_string(::getpid()));
    std::FILE* pipe = ::popen((command + " program.nc 2>'" + errors.string() + "'").c_str(), "r");
    std::string raw;
    char part[4096];
    for (std::size_t n; (n = std::fread(part, 1, sizeof part, pipe)) > 0;) raw.append(part, n);
    Said said;
    const int ended = ::pclose(pipe);
    said.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    said.errors = content(errors);
    fs::remove(errors);
    static const std::regex kTimes(R"re(,"(t|end)":[0-9.e+-]+)re");
    std::istringstream lines(raw);
    for (std::string line; std::getline(lines, line);)
        if (line.find("\"ev\":\"summary\"") == std::string::npos)
            said.events += std::regex_replace(line, kTimes, "") + "\n";
    return said;
}

std::string word_of(const std::string& line, const std::string& name) {
    const std::string key = "\"" + name + "\":\"";
    const std::size_t at = line.find(key);
    return at == std::string::npos
               ? std::string()
               : line.substr(at + key.size(), line.find('"', at + key.size()) - at - key.size());
}

// The exit status says whether there was an error (2: the input could not be read), and a run
// writes each alarm for people too, and nothing else.
void expect_status_and_errors(const Said& said, bool machine) {
    bool error = false, alarm = false, unreadable = false;
    std::istringstream lines(said.events);
    for (std::string line; std::getline(lines, line);) {
        if (word_of(line, "ev") != "alarm") continue;
        alarm = true;
        const std::string severity = word_of(line, "severity"), number = word_of(line, "number");
        const bool is_error = severity.empty() || severity == "error";
        error = error || is_error;
        // nothing else was said, and no block is named
        unreadable =
            is_error && said.events == line + "\n" && line.find("\"line\":") == std::string::npos;
        if (machine) {
            EXPECT_NE(said.errors.find(number), std::string::npos)
                << "alarm " << number << " is not told on standard error:\n"
                << said.errors;
        }
    }
    EXPECT_EQ(said.status, unreadable ? 2 : error ? 1 : 0) << said.errors;
    if (!alarm) { EXPECT_EQ(said.errors, ""); }
}

std::string first_difference(const std::string& want, const std::string& got) {
    std::istringstream a(want), b(got);
    std::string left, right;
    for (int line = 1;; ++line) {
        const bool more_a = static_cast<bool>(std::getline(a, left)),
                   more_b = static_cast<bool>(std::getline(b, right));
        if (!more_a && !more_b) return {};
        if (more_a != more_b || left != right)
            return "line " + std::to_string(line) + "\n  expected " + (more_a ? left : "the end") +
                   "\n  printed  " + (more_b ? right : "the end");
    }
}

// POLYTURN_BLESS=1 writes and fails: a run that writes its own measure has judged nothing.
TEST(GoldenPrograms, PrintWhatWasReviewed) {
    const auto all = cases();
    ASSERT_FALSE(all.empty());
    const bool bless = std::getenv("POLYTURN_BLESS") != nullptr;
    for (const GoldenCase& golden : all) {
        SCOPED_TRACE(content(golden.folder / "README"));
        const bool machine = fs::exists(golden.folder / "scenario.toml");
        const Said said = machine ? run_machine(golden) : run(golden);
        expect_status_and_errors(said, machine);
        const std::string expected = content(golden.folder / "expected.jsonl");
        if (bless && expected != said.events) {
            std::ofstream(golden.folder / "expected.jsonl", std::ios::binary) << said.events;
            ADD_FAILURE() << golden.folder << ": written anew; read the difference";
            continue;
        }
        EXPECT_FALSE(expected.empty())
            << golden.folder
            << " has no expected.jsonl: it would agree with a program that says nothing";
        EXPECT_EQ(first_difference(expected, said.events), "") << golden.folder;
    }
    EXPECT_FALSE(bless) << "POLYTURN_BLESS is set: run again without it";
}

}  // namespace
}  // namespace polyturn::channels
