#include "kernel/tools/tool_in_work.hpp"

#include <algorithm>
#include <atomic>

namespace polyturn::kernel {
namespace {
constexpr int kEachTick = 16;
}

bool ToolInWork::look(const ChannelSegment& channel, std::uint64_t serial) noexcept {
    // P1: from first to head all pictures are complete
    const std::uint64_t first = channel.picture_first.load(std::memory_order_acquire),
                        head = channel.pictures.head.load(std::memory_order_acquire);
    at_ = std::min(std::max(at_, first), head);
    if (head - at_ >= kPictures - 1) at_ = head - (kPictures - 2);
    bool taken = false;
    for (int n = 0; n < kEachTick && at_ < head; ++n, ++at_) {
        const BlockPicture& slot = channel.pictures.slot(at_);
        if (slot.serial > serial) break;
        const auto shift = slot.tool_shift;
        // P5: counts when it was not lost while it was copied (block_pictures.hpp, B2)
        std::atomic_thread_fence(std::memory_order_acquire);
        // written over while it was read
        if (channel.pictures.head.load(std::memory_order_relaxed) - at_ >= kPictures) continue;
        shift_ = shift;
        taken = true;
    }
    return taken;
}

}  // namespace polyturn::kernel
