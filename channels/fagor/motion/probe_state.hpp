// How the program comes to know where the axes really are: a probe move (G75, G76, or G52 against a
// hard stop) that waits for its barrier, the point that was touched, which counts as the position
// until something moves, and the wait for quiet axes before POS and APOS are read.
#pragma once
#include <cstdint>

#include "channels/sink.hpp"

namespace polyturn::channels::fagor {

struct ProbeState {
    bool under_way = false;  // a probe move is before its barrier
    std::uint16_t code = 75;
    std::uint64_t moves_at_touch = 0;  // no move since: the axes stand behind the touched point by
    AxisValues braked_mm{};
    std::uint64_t settled_moves = 0;  // no move since: the axes are quiet
    unsigned quiet_looks = 0, settle_looks = 0;
};

}  // namespace polyturn::channels::fagor
