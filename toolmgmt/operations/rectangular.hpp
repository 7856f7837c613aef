// The position of a tool as offsets and zeros count it: rectangular, also where the X slide is
// inclined and its axes are elsewhere (fanuc_lathe 10.5: relative and absolute positions are
// rectangular). X as a radius.
#pragma once
#include "ipc/model/machine/angular_axes.hpp"
#include "toolmgmt/operations/operation.hpp"

namespace polyturn::toolmgmt {

AngularAxes angular_of(const params::Table& table, const MachineConfig& machine, unsigned channel);
// Nothing: the kernel does not report the position of the axis.
std::optional<double> rectangular_position(const Work& work, unsigned channel,
                                           const AxisConfig& axis);
double rectangular_touch(const Work& work, unsigned channel, const AxisConfig& axis,
                         const Touch& touch);

}  // namespace polyturn::toolmgmt
