// Procedures about single axes: places, roles, exchange between channels.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_preset(Execution& x, Call& c);
bool p_geometry_axes(Execution& x, Call& c);
bool p_soft_axes(Execution& x, Call& c);
bool p_axis_exchange(Execution& x, Call& c);
bool p_axis_to_channel(Execution& x, Call& c);
bool p_swivel(Execution& x, Call& c);
bool p_tool_of_spindle(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
