// The page that the channel's program asks, in the channel's segment (ChannelSegment::dialogue):
// one writer, this process. Screens show it while the channel is stopped with StopReason::Dialogue;
// what the operator enters meanwhile is shown to all of them.
#pragma once
#include "channels/dialogue.hpp"
#include "ipc/image/segments.hpp"

namespace polyturn::channels {

class DialogueOut {
public:
    explicit DialogueOut(ChannelSegment& own) : own_(&own) {}
    void show(const DialoguePage& page);
    void entered(std::string_view variable, double value);
    void clear();  // nothing is asked any more

private:
    ChannelSegment* own_;
    std::uint64_t serial_ = 0;
    bool shown_ = false;
};

}  // namespace polyturn::channels
