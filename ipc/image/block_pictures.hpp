// What holds at a block that runs now: active codes, tool, feed, how far the workpiece system lies
// from the machine's. The channel reads far ahead of the machine, so it keeps what has changed,
// block by block; screens look up the block that is executed.
//
// Invariants
//   B1  Snapshots from picture_first to head belong to the running program; the newest with a
//       serial up to the block's holds. A program that was taken back has smaller serials behind
//       larger ones: the newest still holds.
//   B2  The channel writes slot head while head - kPictures is thereby lost: a copy counts when its
//       index was not lost afterwards.
//   B3  picture_serials holds the serial of each slot from before head grows. One that is lost may
//       be seen there: B2 finds out.
#pragma once
#include <cstring>

#include "ipc/image/segments.hpp"

namespace polyturn {

// Writer: the draft holds from its serial on.
inline void push_picture(ChannelSegment& channel, const BlockPicture& picture) noexcept {
    // P4: own head. P5: a serial seen too early is found out (B3)
    const std::uint64_t head = channel.pictures.head.load(std::memory_order_relaxed);
    // P5: what follows stays behind the head of before: else B2 could miss that a picture is lost
    std::atomic_thread_fence(std::memory_order_release);
    channel.picture_serials[head % kPictures].store(picture.serial, std::memory_order_relaxed);
    channel.pictures.slot(head) = picture;
    // P1: the picture is complete
    channel.pictures.head.store(head + 1, std::memory_order_release);
}

// Reader: false when nothing is known about that block; `out` is then as it was.
[[nodiscard]] inline bool find_picture(const ChannelSegment& channel, std::uint64_t serial,
                                       BlockPicture& out) noexcept {
    // P1: from first to head all pictures are complete
    const std::uint64_t first = channel.picture_first.load(std::memory_order_acquire),
                        head = channel.pictures.head.load(std::memory_order_acquire);
    for (std::uint64_t at = head; at > first && head - at < kPictures - 1; --at) {
        // P5, B3: too new a serial is passed over, whenever it is seen
        if (channel.picture_serials[(at - 1) % kPictures].load(std::memory_order_relaxed) > serial)
            continue;
        BlockPicture copy;
        std::memcpy(static_cast<void*>(&copy), &channel.pictures.slot(at - 1), sizeof copy);
        // P5, B2: not lost while it was copied
        std::atomic_thread_fence(std::memory_order_acquire);
        if (channel.pictures.head.load(std::memory_order_relaxed) - (at - 1) >= kPictures ||
            copy.serial > serial)
            return false;
        std::memcpy(static_cast<void*>(&out), &copy, sizeof out);
        return true;
    }
    return false;
}

}  // namespace polyturn
