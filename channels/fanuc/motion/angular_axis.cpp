#include "channels/fanuc/motion/angular_axis.hpp"

#include <cmath>

namespace polyturn::channels::fanuc {

AngularAxes angular_axes(const MachineView& view, bool& usable) {
    return polyturn::angular_axes(view.table(), view.channel, view.axis_count,
                                  view.axis_by_role(PlaneRole::BasicX),
                                  view.axis_by_role(PlaneRole::BasicZ), usable);
}

void AngularSink::move(const Move& m, const BlockContext& at) {
    Move real = m;
    axes_.to_machine(real.machine);
    axes_.to_machine(real.machine_start);
    real.kinematics = &kinematics_;
    real.path_start = m.machine_start;
    real.path = m.machine;
    // the first move starts at the machine's position
    if (!begun_ && port_->axis_command(view_->axes[axes_.angular].machine_axis)) {
        for (unsigned i = 0; i < view_->axis_count; ++i)
            if (const auto now = port_->axis_command(view_->axes[i].machine_axis))
                real.machine_start[i] = *now;
        real.path_start = real.machine_start;
        real.path_start[axes_.angular] = axes_.x_of(real.machine_start[axes_.angular]);
        real.path_start[axes_.square] =
            axes_.z_of(real.machine_start[axes_.angular], real.machine_start[axes_.square]);
    }
    begun_ = true;
    for (const unsigned i : {axes_.angular, axes_.square})
        if (std::fabs(real.machine[i] - real.machine_start[i]) > 1e-9) real.moved |= 1u << i;
    if (real.moved & (1u << axes_.angular | 1u << axes_.square))
        real.moved |= 1u << axes_.angular | 1u << axes_.square;
    next_->move(real, at);
}

void AngularSink::follow(const AngularAxes& axes) {
    axes_ = axes;
    kinematics_.value[1] = axes.uncorrected ? 1.0 : 0.0;
    kinematics_.value[2] = axes.kept;
}

}  // namespace polyturn::channels::fanuc
