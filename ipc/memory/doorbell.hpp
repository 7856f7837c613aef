// Wake-up across processes: a word in the ringer's own segment that only grows. Who waits maps it
// read-only; a futex wait needs no more. Losing no wake-up: read the word, look for work, wait only
// while the word is still what was read.
#pragma once
#include <atomic>
#include <cstdint>

namespace polyturn {

struct Doorbell {
    alignas(64) std::atomic<std::uint32_t> rings{0};
    // Ringer. Costs a system call; the cyclic thread in real time uses bump() and leaves the wake
    // to wake().
    void ring() noexcept;
    // P6: whoever sees the new number sees the work it was rung for
    void bump() noexcept { rings.fetch_add(1, std::memory_order_release); }
    void wake() const noexcept;
    // Waiter. Returns when the word differs from `seen`, after `timeout_us`, or spuriously. Spins
    // `spins` times first.
    void wait(std::uint32_t seen, std::int64_t timeout_us, int spins = 0) const noexcept;
    // P6: read before looking for work
    std::uint32_t seen() const noexcept { return rings.load(std::memory_order_acquire); }
};

}  // namespace polyturn
