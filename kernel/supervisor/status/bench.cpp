#include "kernel/supervisor/status/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "ipc/model/files/machine_path.hpp"
#include "kernel/supervisor/base/child.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/status/latency.hpp"

namespace polyturn::supervisor {

namespace fs = std::filesystem;

int run_benchmarks(const std::vector<std::string>& arguments) {
    if (std::find(arguments.begin(), arguments.end(), "--help") != arguments.end()) {
        std::fputs(
            "polyturn bench [NAME ...] [options of Google Benchmark]\n"
            "  Runs the benchmark programs that lie beside polyturn, or those whose name holds "
            "NAME.\n"
            "polyturn bench latency [SECONDS]\n  How late this computer wakes a cyclic thread "
            "of 1 ms, and whether real time is permitted.\n",
            stdout);
        return 0;
    }
    if (!arguments.empty() && arguments.front() == "latency")
        return run_latency({arguments.begin() + 1, arguments.end()});
    std::vector<std::string> names, options;
    for (const std::string& word : arguments)
        (word.rfind("--", 0) == 0 ? options : names).push_back(word);
    std::vector<std::string> programs;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(text::program_folder(), none)) {
        const std::string name = entry.path().filename().string();
        const bool wanted =
            names.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& part) {
                return name.find(part) != std::string::npos;
            });
        if (name.size() > 6 && name.compare(name.size() - 6, 6, "_bench") == 0 && wanted)
            programs.push_back(name);
    }
    std::sort(programs.begin(), programs.end());
    if (programs.empty()) {
        fmt::print(stderr,
                   "polyturn: there are no benchmark programs{} in {}.\n"
                   "   Build them with cmake -DPOLYTURN_BENCH=ON; they lie beside polyturn then.\n",
                   names.empty() ? "" : " of this name", text::program_folder());
        return 2;
    }
    int worst = 0;
    for (const std::string& program : programs) {
        fmt::print("== {}\n", program);
        std::fflush(stdout);
        auto child = Child::start(program, options);
        if (!child) {
            print_diagnosis(child.diagnosis(), Dialect::Polyturn);
            return 2;
        }
        child->end_within(-1);
        if (child->status() != 0) {
            fmt::print(stderr, "polyturn: {} {}\n", program, describe_end(child->status()));
            worst = 1;
        }
    }
    return worst;
}

}  // namespace polyturn::supervisor
