#include "channels/fanuc/angular_axis.hpp"

#include <cmath>
#include <numbers>

namespace polyturn::channels::fanuc {

using namespace params;

AngularAxes angular_axes(const MachineView& view, bool& usable) {
    AngularAxes axes;
    usable = true;
    const Table& t = view.table();
    if (!bit(t, f8200, view.channel, 0)) return axes;
    const double degrees = static_cast<double>(get(t, f8210, view.channel));
    const auto place = [&](std::int64_t number, PlaneRole role) {
        return number >= 1 && number <= static_cast<std::int64_t>(view.axis_count) ? static_cast<int>(number - 1) : view.axis_by_role(role);
    };
    const int x = place(get(t, f8211, view.channel), PlaneRole::BasicX), z = place(get(t, f8212, view.channel), PlaneRole::BasicZ);
    const double away = std::fabs(std::remainder(degrees, 90.0));
    usable = x >= 0 && z >= 0 && x != z && away > 1e-9 && std::fabs(degrees) < 90.0;
    if (!usable) return axes;
    axes.on = true;
    axes.angular = static_cast<unsigned>(x);
    axes.square = static_cast<unsigned>(z);
    axes.radians = degrees * std::numbers::pi / 180.0;
    axes.cosine = std::cos(degrees * std::numbers::pi / 180.0);
    axes.tangent = std::tan(degrees * std::numbers::pi / 180.0);
    return axes;
}

void AngularSink::move(const Move& m, const BlockContext& at) {
    Move real = m;
    axes_.to_machine(real.machine);
    axes_.to_machine(real.machine_start);
    real.kinematics = &kinematics_;
    real.path_start = m.machine_start, real.path = m.machine;
    if (!begun_ && port_->axis_command(view_->axes[axes_.angular].machine_axis)) {   // the first move starts where the machine stands
        for (unsigned i = 0; i < view_->axis_count; ++i)
            if (const auto now = port_->axis_command(view_->axes[i].machine_axis)) real.machine_start[i] = *now;
        real.path_start = real.machine_start;
        real.path_start[axes_.angular] = axes_.x_of(real.machine_start[axes_.angular]);
        real.path_start[axes_.square] = axes_.z_of(real.machine_start[axes_.angular], real.machine_start[axes_.square]);
    }
    begun_ = true;
    for (const unsigned i : {axes_.angular, axes_.square})
        if (std::fabs(real.machine[i] - real.machine_start[i]) > 1e-9) real.moved |= 1u << i;
    if (real.moved & (1u << axes_.angular | 1u << axes_.square)) real.moved |= 1u << axes_.angular | 1u << axes_.square;
    next_->move(real, at);
}

}  // namespace polyturn::channels::fanuc
