// Programmable frames: TRANS, ROT, SCALE, MIRROR, tool frames, partial shifts.
#pragma once
#include <array>
#include <optional>

#include "channels/machine_view.hpp"
#include "channels/sinumerik/frames/frame_value.hpp"
#include "channels/state/frame.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct GCode;

// Places of X, Y, Z in the channel; -1 missing.
inline std::array<int, 3> geometry(const MachineView& view) {
    return {view.axis_by_role(PlaneRole::BasicX), view.axis_by_role(PlaneRole::BasicY),
            view.axis_by_role(PlaneRole::BasicZ)};
}

// Rotation about X, Y or Z, whether the channel has that axis or not.
inline double& turn_about(FrameValue& value, const std::array<int, 3>& geo, std::size_t k) {
    return geo[k] < 0 ? value.absent_deg[k] : value.rotation_deg[static_cast<std::size_t>(geo[k])];
}

Frame frame_of(const Execution& x, const FrameValue& value);
FrameValue components_of(const Execution& x, const Frame& frame, const FrameValue& like);
bool set_programmable_frame(Execution& x, const FrameValue& value);
bool solid_angles(Execution& x, const std::array<std::optional<double>, 3>& of, Frame& frame);
bool solid_angles(Execution& x, Frame& frame);
bool geo_frame(Execution& x, const GCode& code);
bool g_tool_frame(Execution& x, const GCode& code);
bool geo_partial_shift(Execution& x, const GCode& code);

}  // namespace polyturn::channels::sinumerik
