#include "toolmgmt/operations/rectangular.hpp"

namespace polyturn::toolmgmt {

AngularAxes angular_of(const params::Table& table, const MachineConfig& machine, unsigned channel) {
    const auto place = [&](PlaneRole role) {
        const AxisConfig* axis = find_axis(machine, channel, role);
        return axis && axis->slot != kNoSlot ? static_cast<int>(axis->slot) : -1;
    };
    bool usable = true;  // said by the channel when a program begins
    return angular_axes(table, channel, machine.channel(channel).axis_count,
                        place(PlaneRole::BasicX), place(PlaneRole::BasicZ), usable);
}

std::optional<double> rectangular_position(const Work& work, unsigned channel,
                                           const AxisConfig& axis) {
    const auto own = work.position ? work.position(axis.number) : std::nullopt;
    const AngularAxes axes = angular_of(work.values.parameters, work.machine, channel);
    if (!own || !axes.on || (axis.slot != axes.angular && axis.slot != axes.square)) return own;
    if (axis.slot == axes.angular) return axes.x_of(*own);
    const auto slide = work.position(work.machine.channel(channel).axes[axes.angular]);
    return slide ? std::optional<double>(axes.z_of(*slide, *own)) : std::nullopt;
}

double rectangular_touch(const Work& work, unsigned channel, const AxisConfig& axis,
                         const Touch& touch) {
    const AngularAxes axes = angular_of(work.values.parameters, work.machine, channel);
    if (axes.on && axis.slot == axes.angular) return axes.x_of(touch.at);
    if (axes.on && axis.slot == axes.square) return axes.z_of(touch.slide_at, touch.at);
    return touch.at;
}

}  // namespace polyturn::toolmgmt
