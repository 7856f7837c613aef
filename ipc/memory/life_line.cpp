#include "ipc/memory/life_line.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <thread>

#include "ipc/memory/segment.hpp"

namespace polyturn {
namespace {

constexpr int kKernelMostMs = 180'000;  // more than it takes itself (Machine::kLeftAloneMostS)
constexpr int kGraceMs = 5'000;         // for what brings something to the disk
constexpr auto kTimeout = std::chrono::seconds(30);

int open_process(int pid) { return static_cast<int>(syscall(SYS_pidfd_open, pid, 0)); }

// 0: none is.
int supervisor_of_this() {
    const char* const word = std::getenv(kSupervisorWord);
    return word ? std::atoi(word) : 0;
}

// False: it lives on.
bool wait_for_end(int pid, int milliseconds) {
    const int process = open_process(pid);
    if (process < 0) return errno == ESRCH;
    pollfd end{process, POLLIN, 0};
    int got = 0;
    while ((got = poll(&end, 1, milliseconds)) < 0 && errno == EINTR) {}
    close(process);
    return got > 0;
}

// A process number is given again some day: one that is not our parent any more has died.
void wait_for_parent(int pid) {
    while (getppid() == pid && !wait_for_end(pid, -1)) sleep_ms(20);
}

}  // namespace

void when_supervisor_dies(std::function<void()> died) {
    const int supervisor = supervisor_of_this();
    if (supervisor <= 0) return;
    std::thread([supervisor, died = std::move(died)] {
        wait_for_parent(supervisor);
        died();
    }).detach();
}

void end_with_kernel(const std::string& instance) {
    const int supervisor = supervisor_of_this();
    if (supervisor <= 0) return;
    std::thread([supervisor, instance] {
        // Held before it dies: a successor of the supervisor takes the name for a segment of its
        // own.
        auto table = PeerSegment<SupervisorSegment>::attach(instance, 0, kTimeout);
        wait_for_parent(supervisor);
        const int kernel = table && (*table)->header.writer_pid == supervisor
                               ? (*table)->processes[kProcessKernel].pid
                               : 0;
        // it hangs: the drives' watchdogs stop what moves
        if (kernel > 0 && !wait_for_end(kernel, kKernelMostMs)) kill(kernel, SIGKILL);
        kill(getpid(), SIGTERM);
        sleep_ms(kGraceMs);
        _exit(0);
    }).detach();
}

}  // namespace polyturn
