// polyturn-drives: CiA 402 slaves for all axes and spindles of an instance that have PT_DRIVE or
// PT_SPINDLE_DRIVE 2, in a process of its own behind drive_segment.h. What `polyturn` starts when
// the machine's folder has no program `drives`.
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernel/drives/drive_segment.h"
#include "kernel/drives/emulator/cia402.hpp"

namespace {
using polyturn::drives::Cia402;

constexpr int kTimeoutMs = 20'000;
constexpr std::int64_t kSleepUs = 5'000;
constexpr unsigned kMostDelay = 64;  // cycles that an answer may be late
constexpr unsigned kHeartbeatCycles = 100;

void* map(const std::string& name, std::size_t size, bool writable) {
    const int fd = shm_open(name.c_str(), writable ? O_RDWR | O_CREAT | O_EXCL : O_RDONLY, 0660);
    if (fd < 0) return nullptr;
    if (writable && ftruncate(fd, static_cast<off_t>(size)) != 0) {
        close(fd);
        return nullptr;
    }
    void* at =
        mmap(nullptr, size, writable ? PROT_READ | PROT_WRITE : PROT_READ, MAP_SHARED, fd, 0);
    close(fd);
    return at == MAP_FAILED ? nullptr : at;
}

const PolyturnDriveCommands* attach(const std::string& instance) {
    for (int waited = 0; waited < kTimeoutMs; ++waited, usleep(1000)) {
        const auto* found = static_cast<const PolyturnDriveCommands*>(
            map("/polyturn." + instance + ".drives", sizeof(PolyturnDriveCommands), false));
        if (!found) continue;
        // P1: setups and header are complete
        if (__atomic_load_n(&found->ready, __ATOMIC_ACQUIRE) == 1 &&
            found->magic == POLYTURN_DRIVES_MAGIC && kill(found->writer_pid, 0) == 0) {
            if (found->version == POLYTURN_DRIVE_VERSION && found->size == sizeof *found)
                return found;
            std::fprintf(stderr,
                         "polyturn-drives: the kernel speaks version %u of the drive interface, "
                         "this is %u\n",
                         found->version, POLYTURN_DRIVE_VERSION);
            return nullptr;
        }
        munmap(const_cast<PolyturnDriveCommands*>(found), sizeof *found);
    }
    std::fprintf(stderr, "polyturn-drives: there is no instance %s that wants drives\n",
                 instance.c_str());
    return nullptr;
}

// The statuses of the last cycles, for answers that are late.
struct Answers {
    std::vector<PolyturnStatusFrame> last = std::vector<PolyturnStatusFrame>(kMostDelay);
    PolyturnStatusFrame& of(std::uint64_t cycle) { return last[cycle % kMostDelay]; }
};

int serve(const std::string& instance) {
    const PolyturnDriveCommands* in = attach(instance);
    if (!in) return 2;
    const std::string name = "/polyturn." + instance + ".slaves";
    shm_unlink(name.c_str());  // a dead predecessor's
    auto* out = static_cast<PolyturnDriveStatuses*>(map(name, sizeof(PolyturnDriveStatuses), true));
    if (!out) {
        std::fprintf(stderr, "polyturn-drives: %s: %s\n", name.c_str(), std::strerror(errno));
        return 2;
    }
    out->magic = POLYTURN_DRIVES_MAGIC;
    out->version = POLYTURN_DRIVE_VERSION;
    out->size = sizeof *out;
    out->writer_pid = getpid();
    // P1: the header is complete
    __atomic_store_n(&out->ready, 1u, __ATOMIC_RELEASE);

    std::vector<std::optional<Cia402>> slaves(POLYTURN_DRIVE_SLOTS);
    for (unsigned i = 0; i < POLYTURN_DRIVE_SLOTS; ++i)
        if (in->setup[i].version == POLYTURN_DRIVE_VERSION) slaves[i].emplace(in->setup[i]);
    auto answers = std::make_unique<Answers>();
    auto frame = std::make_unique<PolyturnStatusFrame>();  // what leaves
    auto commands = std::make_unique<PolyturnCommandFrame>();
    std::uint64_t seen = 0;
    unsigned silent = 0;
    for (;;) {
        // in real time a cycle may be missed: its drives keep their last command
        const std::uint64_t before = seen;
        // P6: the bell is read before the look for commands
        const std::uint32_t bell = __atomic_load_n(&in->bell, __ATOMIC_ACQUIRE);
        if (!polyturn_take_commands(in, &seen, commands.get())) {
            polyturn_bell_wait(&in->bell, bell, kSleepUs);
            // P6: it has rung since
            if (__atomic_load_n(&in->bell, __ATOMIC_ACQUIRE) != bell) continue;
            if (++silent < kHeartbeatCycles) continue;
            silent = 0;
            if (kill(in->writer_pid, 0) != 0) return 0;  // the kernel is gone
            if (!in->is_virtual)
                for (auto& slave : slaves)
                    if (slave) slave->lost_master();
            continue;
        }
        silent = 0;
        PolyturnStatusFrame& now = answers->of(seen);
        for (unsigned i = 0; i < POLYTURN_DRIVE_SLOTS; ++i) {
            if (!slaves[i]) {
                frame->answers[i] = seen;
                continue;
            }
            bool leaves = slaves[i]->cycle(commands->command[i], now.status[i]);
            for (std::uint64_t missed = before + 1; before && missed < seen; ++missed)
                leaves = slaves[i]->cycle(commands->command[i], now.status[i]);
            now.answers[i] = seen;
            if (!leaves) continue;
            const std::uint64_t from =
                seen - std::min<std::uint64_t>(slaves[i]->delay(),
                                               std::min<std::uint64_t>(seen - 1, kMostDelay - 1));
            if (answers->of(from).answers[i] != from || from < frame->answers[i]) continue;
            frame->answers[i] = from;
            frame->status[i] = answers->of(from).status[i];
        }
        frame->cycle = seen;
        polyturn_put_statuses(out, frame.get());
    }
}
}  // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::strcmp(argv[1], "--instance") == 0) return serve(argv[2]);
    std::fprintf(
        stderr,
        "usage: polyturn-drives --instance NAME\n"
        "  CiA 402 drives in a process of their own; polyturn start and polyturn run start it.\n");
    return argc == 2 && std::strcmp(argv[1], "--help") == 0 ? 0 : 2;
}
