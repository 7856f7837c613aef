// The latest complete value of something that one process writes and many read.
//
//   slot 0 | value of version 6 |      version: 7, so slot 7 mod 2 = 1 is the published one
//   slot 1 | value of version 7 |      the writer fills slot 0 next, then stores version 8
//
// Invariants
//   S1  Only the writer stores version_ and the slots.
//   S2  The published slot is not written before another one is published. A writer killed at any
//       store therefore leaves the last complete value readable.
//
// A reader that is overtaken twice while it copies sees it by the version and copies again; it
// waits for nobody, and the bound on its tries only matters to a reader that is slower than two
// publications, each time.
// Memory order (docs/design/memory-orders.md): slot written, version_ released (P1) -> version_
// acquired, slot copied, fence, version_ checked (P5).
#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace polyturn {

template <class T>
class Snapshot {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    // Writer: the slot to fill (it holds an older value), then publish().
    // P4: own version (S1)
    T& draft() noexcept { return slots_[(version_.load(std::memory_order_relaxed) + 1) & 1]; }
    // P4: own version (S1); for the writer only
    const T& published() const noexcept {
        return slots_[version_.load(std::memory_order_relaxed) & 1];
    }
    void publish() noexcept {
        // P4, P1: the slot is complete
        version_.store(version_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
        // P5: stores into the next draft stay behind this one: else a reader could miss that its
        // slot is being filled.
        std::atomic_thread_fence(std::memory_order_release);
    }
    void write(const T& value) noexcept {
        draft() = value;
        publish();
    }

    // P1: who then reads the value gets this version or a newer
    std::uint64_t version() const noexcept { return version_.load(std::memory_order_acquire); }
    // Reader: false only if the writer published twice during each of 64 copies.
    [[nodiscard]] bool read(T& out) const noexcept {
        for (int attempt = 0; attempt < 64; ++attempt) {
            // P5: the slot is copied between two looks at the version
            const auto before = version_.load(std::memory_order_acquire);
            std::memcpy(static_cast<void*>(&out), &slots_[before & 1], sizeof(T));
            std::atomic_thread_fence(std::memory_order_acquire);
            if (version_.load(std::memory_order_relaxed) - before < 1) return true;
            // One publication later the copied slot is still untouched (S2), unless the next draft
            // has begun: copy again.
        }
        return false;
    }

private:
    alignas(64) std::atomic<std::uint64_t> version_{0};
    alignas(64) std::array<T, 2> slots_{};
};

}  // namespace polyturn
