// What the offset in use takes from a channel's axes, as of the running block: read from the block
// snapshots that the channel writes for screens (ipc/image/block_pictures.hpp). A cursor advances
// through them as the blocks are executed, a few snapshots a tick.
//
// A channel that is ahead by more snapshots than the ring holds has overwritten the one under the
// cursor; then the cursor goes to the oldest that is left, which is newer than the running block.
// That takes 2047 changes of modal data within the path ahead.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/image/segments.hpp"

namespace polyturn::kernel {

class ToolInWork {
public:
    // True when it is known; a copy that the channel has overtaken meanwhile is not.
    bool look(const ChannelSegment& channel, std::uint64_t serial) noexcept;
    const std::array<double, kChannelAxes>& shift() const noexcept { return shift_; }

private:
    std::uint64_t at_ = 0;  // the next picture to look at
    std::array<double, kChannelAxes> shift_{};
};

}  // namespace polyturn::kernel
