// polyturn-kernel: the cyclic process of one controller. Started by the supervisor; ends with it.
#include <signal.h>

#include <atomic>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "ipc/model/bodies/room.hpp"
#include "ipc/model/machine/drive_sources.hpp"
#include "ipc/model/compensation/compensation_tables.hpp"
#include "ipc/memory/life_line.hpp"
#include "ipc/memory/segment.hpp"
#include "kernel/tick/attach.hpp"
#include "kernel/tick/clock_real.hpp"
#include "kernel/tick/clock_virtual.hpp"
#include "kernel/tick/table_watch.hpp"

namespace {
using namespace polyturn;

constexpr auto kTimeout = std::chrono::seconds(30);
// the supervisor has died, or this process was asked to end: the machine stops in order, then it
// ends. P3: a flag, announces nothing
std::atomic<bool> alone{false};

// Of nobody else's business any more: what the supervisor has started and cannot end. Ours end by
// themselves (life_line.hpp), unless somebody has stopped them; drives of a machine builder's own
// do not.
void end_the_others(const SupervisorSegment& supervisor) {
    for (std::size_t slot = 0; slot < kProcesses; ++slot) {
        const int pid = supervisor.processes[slot].pid;
        if (pid <= 0 || slot == kProcessKernel) continue;
        if (slot == kProcessDrives) kill(pid, SIGTERM);
        kill(pid, SIGCONT);
    }
}

int fail(const Diagnosis& diagnosis) {
    std::fprintf(stderr, "polyturn-kernel: %s\n", render(diagnosis, Dialect::Polyturn, {}).c_str());
    return 2;
}

// What PT_DRIVE and PT_SPINDLE_DRIVE ask for beside the simulated drives.
Result<void> take_drives(kernel::Machine& machine, const std::string& instance,
                         const SupervisorSegment& supervisor) {
    const params::Table& table = machine.core().table;
    const DriveSources wanted = wanted_drives(table);
    const PolyturnDriveApi* library = nullptr;
    std::unique_ptr<kernel::SegmentDrives> process;
    if (wanted.library) {
        std::string reason;
        const std::filesystem::path base = supervisor.options.machine_folder.data();
        library = kernel::load_drive_library((base.parent_path() / "drive.so").string(), reason);
        if (!library) machine.core().alarm(Alarm::DriveMissing, 0, "PT_DRIVE 1: " + reason);
    }
    if (wanted.process) {
        auto made = kernel::SegmentDrives::create(instance, supervisor.options.virtual_time != 0);
        if (!made) return made.diagnosis();
        process = std::move(*made);
    }
    machine.take_drives(library, std::move(process));
    return {};
}

int run(const std::string& instance) {
    auto supervisor = PeerSegment<SupervisorSegment>::attach(instance, 0, kTimeout);
    if (!supervisor) return fail(supervisor.diagnosis());
    auto store = PeerSegment<StoreSegment>::attach(instance, 0, kTimeout);
    if (!store) return fail(store.diagnosis());
    auto own = OwnSegment<KernelSegment>::create(instance, (*supervisor)->header.generation);
    if (!own) return fail(own.diagnosis());

    const auto machine = std::make_unique<kernel::Machine>(**own, **supervisor, **store);
    while (!(*store)->parameters.read(machine->core().table)) {}
    if (const std::string base = (*supervisor)->options.machine_folder.data(); !base.empty()) {
        std::vector<Diagnosis> diagnoses;  // said by whoever read the machine before us
        machine->take_tables(load_compensation(base + ".compensation", diagnoses));
        const MachineConfig derived = derive_machine_config(machine->core().table);
        std::error_code none;
        const std::string room = base + ".toml";
        machine->take_room(load_room(std::filesystem::exists(room, none) ? room : std::string(),
                                     derived, diagnoses),
                           derived);
    }
    if (auto taken = take_drives(*machine, instance, **supervisor); !taken)
        return fail(taken.diagnosis());
    if (const auto shapes = std::make_unique<kernel::ToolShapes>();
        kernel::read_tool_shapes(**store, *shapes))
        machine->take_tool_shapes(*shapes);
    machine->start();
    own->publish();
    when_supervisor_dies([] { alone = true; });
    struct sigaction told {};
    told.sa_handler = [](int) { alone = true; };
    sigaction(SIGTERM, &told, nullptr);
    kernel::Peers peers(instance, **supervisor);
    peers.attach_all(*machine, alone);
    if (kernel::SegmentDrives* drives = machine->segment_drives();
        drives && !drives->attach(machine->core().config.tick_ns, kTimeout))
        machine->core().alarm(Alarm::DriveMissing, 0, "the process of the drives");

    if ((*supervisor)->options.virtual_time) {
        kernel::VirtualClock clock(*machine, &peers, &alone);
        clock.run();
    } else {
        std::atomic<bool> stop{false};
        kernel::TableWatch tables(
            std::string((*supervisor)->options.machine_folder.data()) + ".compensation", **store,
            machine->core());
        std::thread table_watcher([&] {
            if ((*supervisor)->options.machine_folder[0]) tables.run(stop);
        });
        // before the priority is raised: it keeps the ordinary one
        std::thread watcher([&] { peers.watch(*machine, stop); });
        kernel::RealClock clock(*machine, alone);
        if (const std::string refused = clock.claim_real_time(); !refused.empty()) {
            std::fprintf(
                stderr,
                "polyturn-kernel: no real-time priority or locked memory (%s): the computer may be "
                "late\n",
                refused.c_str());
            machine->core().alarm(Alarm::NoRealTime, 0, refused);
        }
        clock.run();
        // P3: a flag (the order is stronger than needed: join() follows)
        stop.store(true, std::memory_order_release);
        watcher.join();
        table_watcher.join();
    }
    if (alone) end_the_others(**supervisor);
    return 0;
}
}  // namespace

int main(int argc, char** argv) {
    if (argc != 3 || std::strcmp(argv[1], "--instance") != 0 || !valid_instance(argv[2])) {
        std::fprintf(
            stderr,
            "usage: polyturn-kernel --instance NAME\n"
            "  The cyclic process of a controller; polyturn start and polyturn run start it.\n");
        return argc == 2 && std::strcmp(argv[1], "--help") == 0 ? 0 : 2;
    }
    return run(argv[2]);
}
