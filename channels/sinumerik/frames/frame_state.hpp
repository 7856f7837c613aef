// What the store does not keep of settable and grinding frames (it has translations only), by their
// number, and the zeros that the block has written and still has to report.
#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "channels/sinumerik/frames/frame_value.hpp"

namespace polyturn::channels::sinumerik {

struct WrittenZero {
    int number;
    std::int32_t row;
    unsigned place;
    double value;
};

struct FrameState {
    std::map<int, FrameValue> settable, grinding;
    std::vector<WrittenZero> written;
};

}  // namespace polyturn::channels::sinumerik
