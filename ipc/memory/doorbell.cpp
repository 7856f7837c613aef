#include "ipc/memory/doorbell.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <climits>

namespace polyturn {

// Tells the core that this is a spin loop; a plain no-op where there is no such instruction.
static inline void cpu_pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

void Doorbell::wake() const noexcept {
    // Shared futex (no FUTEX_PRIVATE_FLAG): the waiters are other processes.
    syscall(SYS_futex, reinterpret_cast<const std::uint32_t*>(&rings), FUTEX_WAKE, INT_MAX, nullptr,
            nullptr, 0);
}

void Doorbell::ring() noexcept {
    bump();
    wake();
}

void Doorbell::wait(std::uint32_t seen_value, std::int64_t timeout_us, int spins) const noexcept {
    for (int i = 0; i < spins; ++i) {
        // P6: what the ring announces is looked for behind this
        if (rings.load(std::memory_order_acquire) != seen_value) return;
        cpu_pause();
    }
    timespec limit{timeout_us / 1'000'000, static_cast<long>(timeout_us % 1'000'000) * 1000};
    syscall(SYS_futex, reinterpret_cast<const std::uint32_t*>(&rings), FUTEX_WAIT, seen_value,
            timeout_us < 0 ? nullptr : &limit, nullptr, 0);
}

}  // namespace polyturn
