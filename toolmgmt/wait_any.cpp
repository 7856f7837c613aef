#include "toolmgmt/wait_any.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace polyturn::toolmgmt {
namespace {

constexpr std::int64_t kPollUs = 2000;

// False when the system has no such call.
bool wait_together([[maybe_unused]] std::span<const Watched> bells,
                   [[maybe_unused]] std::int64_t timeout_us) {
#ifdef SYS_futex_waitv
    static bool missing = false;
    if (missing) return false;
    std::array<futex_waitv, 8> waits{};
    const std::size_t count = std::min(bells.size(), waits.size());
    for (std::size_t i = 0; i < count; ++i) {
        waits[i].val = bells[i].seen;
        waits[i].uaddr = reinterpret_cast<std::uint64_t>(&bells[i].bell->rings);
        waits[i].flags = FUTEX_32;  // shared: the ringers are other processes
    }
    timespec until{};
    clock_gettime(CLOCK_MONOTONIC, &until);
    const std::int64_t ns = until.tv_nsec + timeout_us % 1'000'000 * 1000;
    until.tv_sec += timeout_us / 1'000'000 + ns / 1'000'000'000;
    until.tv_nsec = ns % 1'000'000'000;
    if (syscall(SYS_futex_waitv, waits.data(), static_cast<unsigned>(count), 0u, &until,
                CLOCK_MONOTONIC) >= 0)
        return true;
    // rung before we slept, timeout, signal
    if (errno != ENOSYS && errno != EINVAL && errno != EPERM) return true;
    missing = true;
#endif
    return false;
}

}  // namespace

void wait_any(std::span<const Watched> bells, std::int64_t timeout_us) {
    for (const Watched& watched : bells)
        if (watched.bell->seen() != watched.seen) return;
    if (bells.empty() || wait_together(bells, timeout_us)) return;
    // The last bell is the busiest: sleep on it, briefly enough for the others.
    bells.back().bell->wait(bells.back().seen, std::min(timeout_us, kPollUs));
}

}  // namespace polyturn::toolmgmt
