// polyturn-plc: the process that runs the machine builder's PLC. Started by polyturn together with
// the kernel.
#include <fmt/format.h>
#include <getopt.h>
#include <signal.h>

#include <atomic>
#include <cstdio>
#include <filesystem>

#include "ipc/memory/life_line.hpp"
#include "ipc/memory/segment.hpp"
#include "kernel/plc/cycle_watch.hpp"
#include "kernel/plc/session.hpp"

namespace {

// P3: a flag, announces nothing
std::atomic<bool> stop{false};

constexpr char kHelp[] =
    "polyturn-plc: the PLC process of a Polyturn controller; loads the machine builder's PLC "
    "and runs it every PT_PLC_CYCLE\n"
    "  --instance NAME   name of the controller\n"
    "  --library FILE    the PLC: a shared object with the interface of plc_api.h (default: "
    "the built-in lathe)\n"
    "  --retained FILE   keeps what the PLC wants kept over power-off (N1274 #1)\n";

std::string beside_this_program(const char* name) {
    std::error_code none;
    return (std::filesystem::read_symlink("/proc/self/exe", none).parent_path() / name).string();
}

int complain(const polyturn::Diagnosis& diagnosis) {
    fmt::print(stderr, "polyturn-plc: {}",
               polyturn::render(diagnosis, polyturn::Dialect::Polyturn, ""));
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    std::string instance, retained, library = beside_this_program("liblathe_plc.so");
    static const option kOptions[] = {{"instance", required_argument, nullptr, 'i'},
                                      {"library", required_argument, nullptr, 'l'},
                                      {"retained", required_argument, nullptr, 'r'},
                                      {"help", no_argument, nullptr, 'h'},
                                      {}};
    for (int letter; (letter = getopt_long(argc, argv, "", kOptions, nullptr)) != -1;) {
        switch (letter) {
            case 'i':
                instance = optarg;
                break;
            case 'l':
                library = optarg;
                break;
            case 'r':
                retained = optarg;
                break;
            case 'h':
                fmt::print("{}", kHelp);
                return 0;
            default:
                fmt::print(stderr, "{}", kHelp);
                return 2;
        }
    }
    if (instance.empty() || optind != argc) {
        fmt::print(stderr, "{}", kHelp);
        return 2;
    }
    if (!polyturn::valid_instance(instance))
        return complain({polyturn::Alarm::SegmentMissing, {}, {}, instance});

    struct sigaction action {};
    action.sa_handler = [](int) { stop = true; };
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGINT, &action, nullptr);

    polyturn::end_with_kernel(instance);
    auto plc = polyturn::plc::BuilderPlc::load(library);
    if (!plc) return complain(plc.diagnosis());
    polyturn::plc::cycle_watch::start();
    for (;;) {
        const auto end = polyturn::plc::run_session(instance, *plc, stop, retained);
        if (!end) return complain(end.diagnosis());
        if (*end == polyturn::plc::SessionEnd::Asked) return 0;
    }
}
