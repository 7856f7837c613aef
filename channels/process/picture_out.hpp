// Tells screens what holds at each block: pictures of tool, feed, spindle, workpiece system and codes, one for each block behind
// which something of it is different (ipc/image/block_pictures.hpp).
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
    // A program begins: what was told of another one is void.
    void begin();
    // Behind a block; codes as Language::active_codes() writes them.
    void look(const Core& core, const std::string& codes);
    // A reset has cancelled the tool offset while the block `serial` ran: what is shown from here on is counted without it. So has
    // the program's end, which is that block: then not before it.
    void offset_lost(std::uint64_t serial, bool at_end = false);

private:
    ChannelSegment* own_;
    BlockPicture last_{};
    bool any_ = false;
};

}  // namespace polyturn::channels
