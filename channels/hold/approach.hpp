// Approach of a channel's axes to a point where its program goes on: a restart at a block, or the
// return from a block that was entered by hand in a hold. Axis after axis in the order of
// PT_RESTART_ORDER, in rapid.
#pragma once
#include <string>
#include <vector>

#include "channels/machine_view.hpp"
#include "channels/sink.hpp"

namespace polyturn::channels {

// Axes of the channel that move together, in their order; only axes whose coordinate
// changes.
std::vector<AxisSet> approach_order(const MachineView& view, const AxisValues& from,
                                    const AxisValues& to);

// From `from` to `to` in machine coordinates. `pos`: the point `to` in the workpiece system, for
// the events.
void approach(const MachineView& view, const AxisValues& from, const AxisValues& to,
              const AxisValues& pos, const BlockContext& at, Sink& sink);

// "Z 5 -> -20, then X 60 -> 30": as the machine shows the axes.
std::string approach_text(const MachineView& view, const AxisValues& from, const AxisValues& to);

}  // namespace polyturn::channels
