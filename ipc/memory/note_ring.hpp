// Event notes on their way from a channel to the supervisor: for each block that is worth an event
// the text that describes it (a JSON object without its time), because only the channel knows the
// workpiece system, tool and cycle. The kernel later reports the note's number when the record
// begins and ends.
//
//   byte stream:  | size u32 | number u64 | text ... padded to 8 |  size 0: the rest up to the end
//   is skipped
//
// One producer, one consumer; head and bytes in the channel's segment, tail in the supervisor's.
// Same orders as SpscRing.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "ipc/capacities.hpp"

namespace polyturn {

struct NoteHead {
    alignas(64) std::atomic<std::uint64_t> head{0};
    alignas(64) std::array<char, kNoteRing> bytes;
};

class NoteWriter {
public:
    NoteWriter(NoteHead& half, const std::atomic<std::uint64_t>& tail)
        : half_(&half), tail_(&tail) {}
    // False when there is no room: wait for the reader. Texts up to a quarter of the ring.
    [[nodiscard]] bool push(std::uint64_t number, std::string_view text) noexcept {
        const std::uint64_t need = (16 + text.size() + 7) & ~std::uint64_t{7};
        // P4: own head
        auto head = half_->head.load(std::memory_order_relaxed);
        const std::uint64_t at = head & (kNoteRing - 1), to_end = kNoteRing - at;
        const std::uint64_t skip = to_end < need ? to_end : 0;
        // P2: the reader has copied what lay there
        if (head + skip + need - tail_->load(std::memory_order_acquire) > kNoteRing) return false;
        if (skip) {
            std::memset(&half_->bytes[at], 0, 8);
            head += skip;
        }
        char* to = &half_->bytes[head & (kNoteRing - 1)];
        const auto size = static_cast<std::uint32_t>(text.size() + 1);  // never 0
        std::memcpy(to, &size, 4);
        std::memcpy(to + 8, &number, 8);
        std::memcpy(to + 16, text.data(), text.size());
        // P1: the note is complete
        half_->head.store(head + need, std::memory_order_release);
        return true;
    }

private:
    NoteHead* half_;
    const std::atomic<std::uint64_t>* tail_;
};

class NoteReader {
public:
    NoteReader(const NoteHead& half, std::atomic<std::uint64_t>& tail)
        : half_(&half), tail_(&tail) {}
    // The oldest note, good until pop(). False when there is none.
    [[nodiscard]] bool front(std::uint64_t& number, std::string_view& text) noexcept {
        // P4: own tail. P1: the notes before head are complete
        auto tail = tail_->load(std::memory_order_relaxed);
        const auto head = half_->head.load(std::memory_order_acquire);
        while (tail < head) {
            const char* from = &half_->bytes[tail & (kNoteRing - 1)];
            std::uint32_t size = 0;
            std::memcpy(&size, from, 4);
            if (size == 0) {
                tail += kNoteRing - (tail & (kNoteRing - 1));
                continue;
            }
            std::memcpy(&number, from + 8, 8);
            text = {from + 16, size - 1};
            next_ = tail + ((16 + std::uint64_t{size} - 1 + 7) & ~std::uint64_t{7});
            return true;
        }
        return false;
    }
    // P2: the note was read
    void pop() noexcept { tail_->store(next_, std::memory_order_release); }

private:
    const NoteHead* half_;
    std::atomic<std::uint64_t>* tail_;
    std::uint64_t next_ = 0;
};

}  // namespace polyturn
