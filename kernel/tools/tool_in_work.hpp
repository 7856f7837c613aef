// What the offset in use takes from a channel's axes, as the block that runs has it: read from the
// pictures that the channel draws for screens (ipc/image/block_pictures.hpp). A cursor goes forward
// through them as the blocks are executed, a few pictures a tick.
//
// A channel that is ahead by more pictures than the ring holds has written over what the cursor
// stands on; then it goes on from the oldest that is left, which is newer than the running block.
// That takes 2047 changes of what holds within the path ahead.
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
