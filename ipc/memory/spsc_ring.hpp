// A ring between exactly one producing and one consuming process, in two halves, because every byte
// of shared memory has one writer: head and slots lie in the producer's segment, the tail in the
// consumer's.
//
//        tail: next to take               head: next to fill
//         v                                v
//   | . | 41 | 42 | 43 | 44 | 45 | 46 | 47 | . | . |      slot = index mod kCapacity
//         '---- final: nobody writes ----'
//
// Invariants
//   I1  tail <= head <= tail + kCapacity. Both are 64 bit and only grow: full never looks empty.
//   I2  Only the producer stores head, only the consumer stores tail.
//   I3  Slots in [tail, head) are final. If the producer is killed, the consumer can take them all.
//   I4  Plain bytes: no pointer, virtual or lock. They mean the same wherever the image is mapped.
// Memory order (all rules: docs/design/memory-orders.md)
//   P1  push: slot written, head released   ->  take: head acquired, slot read.
//   P2  pop:  slot read, tail released      ->  push: tail acquired, slot reused.
//   P4  Each side reads its own index relaxed, for nobody else stores it (I2).
// A push that is killed before P1 has sent nothing; the next one overwrites its slot.
#pragma once
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "ipc/diagnosis/assert.hpp"

namespace polyturn {

// Producer's half.
template <class Record, std::uint64_t kCapacity>
struct RingHead {
    static_assert(std::has_single_bit(kCapacity), "slot = index & mask");
    static_assert(std::is_trivially_copyable_v<Record>, "I4");
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "I4");
    using value_type = Record;
    static constexpr std::uint64_t capacity = kCapacity;
    alignas(64) std::atomic<std::uint64_t> head{0};
    alignas(64) std::array<Record, kCapacity> slots;
    Record& slot(std::uint64_t index) { return slots[index & (kCapacity - 1)]; }
    const Record& slot(std::uint64_t index) const { return slots[index & (kCapacity - 1)]; }
};

// Consumer's half.
struct RingTail {
    alignas(64) std::atomic<std::uint64_t> tail{0};
};

// What the producing process holds: not in shared memory.
template <class Half>
class RingProducer {
public:
    RingProducer(Half& half, const RingTail& tail)
        // P2: the consumer has read the slots before its tail
        : half_(&half), tail_(&tail), seen_(tail.tail.load(std::memory_order_acquire)) {}
    // The slot to fill next, nullptr when the ring is full. Nothing is sent before commit().
    [[nodiscard]] typename Half::value_type* claim() noexcept {
        // P4: own head
        const auto head = half_->head.load(std::memory_order_relaxed);
        if (head - seen_ >= Half::capacity) {
            seen_ = tail_->tail.load(std::memory_order_acquire);  // P2
            if (head - seen_ >= Half::capacity) return nullptr;
        }
        return &half_->slot(head);
    }
    // P1. Behind a claim() that gave a slot.
    void commit() noexcept {
        PT_ASSERT(half_->head.load(std::memory_order_relaxed) - seen_ < Half::capacity,
                  "I1 head <= tail + kCapacity");
        // P4: own head. P1: the slot is complete
        half_->head.store(half_->head.load(std::memory_order_relaxed) + 1,
                          std::memory_order_release);
    }
    [[nodiscard]] bool push(const typename Half::value_type& record) noexcept {
        auto* slot = claim();
        if (!slot) return false;
        *slot = record;
        commit();
        return true;
    }
    // P4: own head
    std::uint64_t head() const noexcept { return half_->head.load(std::memory_order_relaxed); }

private:
    Half* half_;
    const RingTail* tail_;
    std::uint64_t seen_;
};

// What the consuming process holds.
template <class Half>
class RingConsumer {
public:
    // A successor goes on at `tail`.
    RingConsumer(const Half& half, RingTail& tail)
        // P4: own tail
        : half_(&half), tail_(&tail), seen_(tail.tail.load(std::memory_order_relaxed)) {}
    // The oldest record, good until pop(); nullptr when there is none.
    [[nodiscard]] const typename Half::value_type* front() noexcept {
        // P4: own tail
        const auto tail = tail_->tail.load(std::memory_order_relaxed);
        if (tail == seen_) {
            seen_ = half_->head.load(std::memory_order_acquire);  // P1
            if (tail >= seen_) {
                seen_ = tail;
                return nullptr;
            }
        }
        return &half_->slot(tail);
    }
    // P2. Behind a front() that gave a record.
    void pop() noexcept {
        PT_ASSERT(tail_->tail.load(std::memory_order_relaxed) < seen_, "I1 tail <= head");
        tail_->tail.store(tail_->tail.load(std::memory_order_relaxed) + 1,
                          std::memory_order_release);
    }
    // P4: own tail
    std::uint64_t tail() const noexcept { return tail_->tail.load(std::memory_order_relaxed); }

private:
    const Half* half_;
    RingTail* tail_;
    std::uint64_t seen_;
};

}  // namespace polyturn
