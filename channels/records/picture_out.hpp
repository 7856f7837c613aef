// Block snapshots for the screens: tool, feed, spindle, workpiece system and codes that hold at
// each block, one for each block behind which any of it changes (ipc/image/block_pictures.hpp).
#pragma once
#include <string>

#include "channels/state/core.hpp"
#include "ipc/image/block_pictures.hpp"

namespace polyturn::channels {

// What `core` shows, without codes.
void describe(const Core& core, BlockPicture& picture);

class PictureOut {
public:
    explicit PictureOut(ChannelSegment& own) : own_(&own) {}
    // A program begins: snapshots of another one are void.
    void begin();
    // Behind a block; codes as Language::active_codes() writes them.
    void look(const Core& core, const std::string& codes);
    // The end of the program, which is the block `serial`, has cancelled the tool offset: from it
    // on what is shown is counted without it.
    void offset_lost(std::uint64_t serial);
    // A reset: what was only read ahead of it, from the block `not_begun` on (0: nothing was), has
    // not happened. The last block that had begun is output anew, as the newest; without the tool
    // offset where the language cancels it.
    void reset(std::uint64_t newest, std::uint64_t not_begun, bool offset_lost);

private:
    void tell(BlockPicture now, bool offset_lost);
    ChannelSegment* own_;
    BlockPicture last_{};
    bool any_ = false;
};

}  // namespace polyturn::channels
