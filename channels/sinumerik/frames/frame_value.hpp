// The components of one frame: coarse and fine translation, rotation, scale, mirror, by the axes'
// places in the channel.
#pragma once
#include <array>

#include "channels/sink.hpp"

namespace polyturn::channels::sinumerik {

struct FrameValue {
    AxisValues coarse_mm{}, fine_mm{};  // X as a radius
    AxisValues rotation_deg{};          // about the geometry axis at that place
    AxisValues scale{};                 // 0 means 1: a frame of zeros is the neutral one
    AxisSet mirrored = 0;
    // Rotation about X, Y, Z where the channel has no such axis: a lathe turns its plane about Y.
    std::array<double, 3> absent_deg{};
};

}  // namespace polyturn::channels::sinumerik
