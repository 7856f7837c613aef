#include "kernel/plc/cycle_watch.hpp"

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>

namespace polyturn::plc::cycle_watch {

namespace {
// P3: numbers that announce nothing, for a handler in the same process
std::atomic<std::uint64_t> running{0};  // number of the running cycle; 0 none
std::atomic<std::uint64_t> last_seen{0};

// Async-signal-safe: lock-free atomics, write, _exit.
void check(int) {
    // P3: only the numbers count
    const std::uint64_t now = running.load(std::memory_order_relaxed);
    if (now != 0 && now == last_seen.load(std::memory_order_relaxed)) {
        static constexpr char kText[] =
            "polyturn-plc: a PLC cycle did not end; the PLC is stopped\n";
        [[maybe_unused]] const auto written = write(STDERR_FILENO, kText, sizeof kText - 1);
        _exit(3);
    }
    // P3: only the numbers count
    last_seen.store(now, std::memory_order_relaxed);
}
}  // namespace

void start() {
    struct sigaction action {};
    action.sa_handler = check;
    action.sa_flags = SA_RESTART;
    sigaction(SIGPROF, &action, nullptr);
    const itimerval every{{kCpuLimitMs / 1000, kCpuLimitMs % 1000 * 1000},
                          {kCpuLimitMs / 1000, kCpuLimitMs % 1000 * 1000}};
    setitimer(ITIMER_PROF, &every, nullptr);
}

// P3: only the numbers count
void begin(std::uint64_t cycle) noexcept { running.store(cycle, std::memory_order_relaxed); }
void end() noexcept { running.store(0, std::memory_order_relaxed); }

}  // namespace polyturn::plc::cycle_watch
