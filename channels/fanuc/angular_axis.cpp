#include "channels/fanuc/angular_axis.hpp"

#include <algorithm>
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
    axes.cosine = std::cos(degrees * std::numbers::pi / 180.0);
    axes.tangent = std::tan(degrees * std::numbers::pi / 180.0);
    return axes;
}

void AngularSink::move(const Move& m, const BlockContext& at) {
    const bool arc = m.kind == MoveKind::ArcCw || m.kind == MoveKind::ArcCcw;
    const bool driven = port_->axis_command(view_->axes[axes_.angular].machine_axis).has_value();
    if (arc && driven) return chords(m, at);
    Move real = m;
    axes_.to_machine(real.machine);
    axes_.to_machine(real.machine_start);
    if (!begun_ && driven)   // the first move starts where the machine stands
        for (unsigned i = 0; i < view_->axis_count; ++i)
            if (const auto now = port_->axis_command(view_->axes[i].machine_axis)) real.machine_start[i] = *now;
    begun_ = true;
    for (const unsigned i : {axes_.angular, axes_.square})
        if (std::fabs(real.machine[i] - real.machine_start[i]) > 1e-9) real.moved |= 1u << i;
    next_->move(real, at);
}

//   sagitta of a chord over the angle d: r (1 - cos(d/2)) = 0.001 mm
void AngularSink::chords(const Move& m, const BlockContext& at) {
    const double step = 2.0 * std::acos(std::max(0.0, 1.0 - 0.001 / std::max(m.radius, 0.01)));
    const int count = std::max(1, static_cast<int>(std::ceil(std::fabs(m.sweep) / std::max(step, 1e-3))));
    const double a0 = std::atan2(m.machine_start[m.plane_q] - m.centre_q, m.machine_start[m.plane_p] - m.centre_p);
    Move piece = m;
    piece.kind = MoveKind::Linear;
    for (int k = 1; k <= count; ++k) {
        const double share = static_cast<double>(k) / count, angle = a0 + m.sweep * share, radius = m.radius + (m.radius_end - m.radius) * share;
        AxisValues next = m.machine;
        if (k < count) {
            for (unsigned i = 0; i < view_->axis_count; ++i) next[i] = m.machine_start[i] + (m.machine[i] - m.machine_start[i]) * share;
            next[m.plane_p] = m.centre_p + radius * std::cos(angle);
            next[m.plane_q] = m.centre_q + radius * std::sin(angle);
        }
        for (unsigned i = 0; i < view_->axis_count; ++i) piece.pos[i] = m.pos[i] + next[i] - m.machine[i];
        piece.machine = next;
        piece.exact_stop = piece.in_position = k == count && m.exact_stop;
        move(piece, at);
        piece.machine_start = next;
    }
}

}  // namespace polyturn::channels::fanuc
