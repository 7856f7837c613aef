// Programmable frames: TRANS, ROT, SCALE, MIRROR, tool frames, partial shifts.
#pragma once
#include <array>
#include <optional>

#include "channels/sinumerik/frames/frame_value.hpp"
#include "channels/state/frame.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct GCode;

Frame frame_of(const Execution& x, const FrameValue& value);
FrameValue components_of(const Execution& x, const Frame& frame, const FrameValue& like);
bool set_programmable_frame(Execution& x, const FrameValue& value);
bool solid_angles(Execution& x, const std::array<std::optional<double>, 3>& of, Frame& frame);
bool solid_angles(Execution& x, Frame& frame);
bool geo_frame(Execution& x, const GCode& code);
bool g_tool_frame(Execution& x, const GCode& code);
bool geo_partial_shift(Execution& x, const GCode& code);

}  // namespace polyturn::channels::sinumerik
