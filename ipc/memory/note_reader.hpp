// The supervisor's half of a note ring (note_ring.hpp). The bytes are another process's, and
// nothing of them is trusted: a head that is out of range or a size that leads out of the ring ends
// the reading for good, and what is added meanwhile waits for the next reader, so that no writer
// can keep this one busy.
#pragma once
#include <cstdint>
#include <cstring>
#include <string>

#include "ipc/memory/note_ring.hpp"

namespace polyturn {

class ForeignNotes {
public:
    enum class Taken : std::uint8_t { One, None, Broken };

    // What stands in the ring now, and no more.
    ForeignNotes(const NoteHead& half, std::atomic<std::uint64_t>& tail)
        : half_(&half), tail_(&tail), head_(half.head.load(std::memory_order_acquire)) {}

    // The oldest note, copied: its writer may go on writing.
    [[nodiscard]] Taken take(std::uint64_t& number, std::string& text) {
        std::uint64_t tail = tail_->load(std::memory_order_relaxed);
        if (head_ < tail || head_ - tail > kNoteRing || head_ % 8 != 0 || tail % 8 != 0)
            return Taken::Broken;
        if (tail == head_) return Taken::None;
        std::uint64_t at = tail & (kNoteRing - 1);
        std::uint32_t size = size_at(at);
        if (size == 0) {  // the rest up to the end is skipped
            tail += kNoteRing - at;
            at = 0;
            if (tail > head_) return Taken::Broken;
            if (tail == head_) {
                // P2: nothing of the rest is read any more
                tail_->store(tail, std::memory_order_release);
                return Taken::None;
            }
            size = size_at(at);
        }
        const std::uint64_t need = (16 + std::uint64_t{size} - 1 + 7) & ~std::uint64_t{7};
        if (size == 0 || size - 1 > kLongest || need > kNoteRing - at || need > head_ - tail)
            return Taken::Broken;
        std::memcpy(&number, &half_->bytes[at + 8], 8);
        text.assign(&half_->bytes[at + 16], size - 1);
        // P2: number and text are copied
        tail_->store(tail + need, std::memory_order_release);
        return Taken::One;
    }

    static constexpr std::uint32_t kLongest = kNoteRing / 4;

private:
    std::uint32_t size_at(std::uint64_t at) const {
        std::uint32_t size = 0;
        std::memcpy(&size, &half_->bytes[at], 4);
        return size;
    }
    const NoteHead* half_;
    std::atomic<std::uint64_t>* tail_;
    std::uint64_t head_;
};

}  // namespace polyturn
