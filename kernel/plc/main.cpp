// polyturn-plc: the process that runs the machine builder's PLC. Started by polyturn beside the kernel.
#include <fmt/format.h>
#include <limits.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <filesystem>

#include "ipc/memory/segment.hpp"
#include "kernel/plc/cycle_watch.hpp"
#include "kernel/plc/session.hpp"

namespace {

std::atomic<bool> stop{false};

std::string beside_this_program(const char* name) {
    std::error_code none;
    return (std::filesystem::read_symlink("/proc/self/exe", none).parent_path() / name).string();
}

int complain(const polyturn::Diagnosis& diagnosis) {
    fmt::print(stderr, "polyturn-plc: {}", polyturn::render(diagnosis, polyturn::Dialect::Polyturn, ""));
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"The PLC process of a Polyturn controller: loads the machine builder's PLC and runs it every PT_PLC_CYCLE.", "polyturn-plc"};
    std::string instance, library = beside_this_program("liblathe_plc.so");
    app.add_option("--instance", instance, "name of the controller")->required();
    app.add_option("--library", library, "the PLC: a shared object with the interface of plc_api.h (default: the built-in lathe)");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    if (!polyturn::valid_instance(instance)) return complain({polyturn::Alarm::SegmentMissing, {}, {}, instance});

    struct sigaction action {};
    action.sa_handler = [](int) { stop = true; };
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGINT, &action, nullptr);

    auto plc = polyturn::plc::BuilderPlc::load(library);
    if (!plc) return complain(plc.diagnosis());
    polyturn::plc::cycle_watch::start();
    for (;;) {
        const auto end = polyturn::plc::run_session(instance, *plc, stop);
        if (!end) return complain(end.diagnosis());
        if (*end == polyturn::plc::SessionEnd::Asked) return 0;
    }
}
