// Programs whose events were worked out by hand from the specification: one folder each below tests/golden/<language>.
// A folder with scenario.toml is run on the simulated machine, the others are checked; times and the summary are left out.
// POLYTURN_BLESS=1 writes what comes out; read the difference before it is committed.
#include <gtest/gtest.h>

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
        for (const auto& entry : fs::directory_iterator(fs::path(kSourceFolder) / "tests/golden" / language, error))
            if (entry.is_directory()) found.push_back({entry.path(), language});
    }
    std::sort(found.begin(), found.end(), [](const GoldenCase& a, const GoldenCase& b) { return a.folder < b.folder; });
    return found;
}

// What check prints, with the path of the program cut down to its name.
std::string run(const GoldenCase& golden) {
    CheckOptions options;
    options.language = golden.language;
    options.machine.machine = (fs::path(kSourceFolder) / "examples/machines/twin-turret").string();
    options.program = (golden.folder / "program.nc").string();
    options.alone = options.variables = true;
    if (fs::exists(golden.folder / "setup.toml")) options.setup = (golden.folder / "setup.toml").string();
    std::istringstream sets(content(golden.folder / "sets"));
    for (std::string line; std::getline(sets, line);)
        if (!line.empty()) options.machine.sets.push_back(line);
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* out = ::open_memstream(&text, &size);
    run_check(options, out);
    std::fclose(out);
    std::string printed(text, size);
    std::free(text);
    const std::string folder = golden.folder.string() + "/";
    for (std::size_t at; (at = printed.find(folder)) != std::string::npos;) printed.erase(at, folder.size());
    return printed;
}

// What the simulated machine tells, on standard output.
std::string run_machine(const GoldenCase& golden) {
    std::string command = "cd '" + golden.folder.string() + "' && " + std::string(kProgramFolder) + "/polyturn run --virtual --variables --language " + golden.language + " --scenario scenario.toml";
    if (fs::exists(golden.folder / "setup.toml")) command += " --setup setup.toml";
    std::istringstream sets(content(golden.folder / "sets"));
    for (std::string line; std::getline(sets, line);)
        if (!line.empty()) command += " --set '" + line + "'";
    std::FILE* pipe = ::popen((command + " program.nc 2>/dev/null").c_str(), "r");
    std::string raw;
    char part[4096];
    for (std::size_t n; (n = std::fread(part, 1, sizeof part, pipe)) > 0;) raw.append(part, n);
    ::pclose(pipe);
    static const std::regex kTimes(R"re(,"(t|end)":[0-9.e+-]+)re");
    std::istringstream lines(raw);
    std::string printed;
    for (std::string line; std::getline(lines, line);)
        if (line.find("\"ev\":\"summary\"") == std::string::npos) printed += std::regex_replace(line, kTimes, "") + "\n";
    return printed;
}

std::string first_difference(const std::string& want, const std::string& got) {
    std::istringstream a(want), b(got);
    std::string left, right;
    for (int line = 1;; ++line) {
        const bool more_a = static_cast<bool>(std::getline(a, left)), more_b = static_cast<bool>(std::getline(b, right));
        if (!more_a && !more_b) return {};
        if (more_a != more_b || left != right)
            return "line " + std::to_string(line) + "\n  expected " + (more_a ? left : "the end") + "\n  printed  " + (more_b ? right : "the end");
    }
}

TEST(GoldenPrograms, PrintWhatWasReviewed) {
    const auto all = cases();
    ASSERT_FALSE(all.empty());
    for (const GoldenCase& golden : all) {
        SCOPED_TRACE(content(golden.folder / "README"));
        const bool machine = fs::exists(golden.folder / "scenario.toml");
        if (machine && !fs::exists(std::string(kProgramFolder) + "/polyturn")) continue;
        const std::string printed = machine ? run_machine(golden) : run(golden);
        if (std::getenv("POLYTURN_BLESS")) {
            std::ofstream(golden.folder / "expected.jsonl", std::ios::binary) << printed;
            continue;
        }
        EXPECT_EQ(first_difference(content(golden.folder / "expected.jsonl"), printed), "") << golden.folder;
    }
}

}  // namespace
}  // namespace polyturn::channels
