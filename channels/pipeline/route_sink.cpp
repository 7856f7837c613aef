#include "channels/pipeline/route_sink.hpp"

#include "ipc/kinematics/kinematics.hpp"

namespace polyturn::channels {

namespace {
bool has_role(const Kinematics& k, unsigned place) {
    for (std::size_t r = 0; r < role_count(kind_of(k)); ++r)
        if (k.axis[r] == place) return true;
    return false;
}
}  // namespace

void RouteSink::move(const Move& m, const BlockContext& at) {
    routed_ = m;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const ChannelAxis& axis = view_->axes[i];
        if (!axis.turned_round()) continue;
        routed_.machine_start[i] = axis.to_drive(m.machine_start[i]);
        routed_.machine[i] = axis.to_drive(m.machine[i]);
        routed_.nose[i] = axis.reversed() ? -m.nose[i] : m.nose[i];
        // a role's route is in the transformation
        if (!m.kinematics || has_role(*m.kinematics, i)) continue;
        routed_.path_start[i] = axis.to_drive(m.path_start[i]);
        routed_.path[i] = axis.to_drive(m.path[i]);
    }
    if (m.through) {
        auto through = std::make_shared<std::vector<AxisValues>>(*m.through);
        for (AxisValues& point : *through)
            for (unsigned i = 0; i < view_->axis_count; ++i)
                if (view_->axes[i].turned_round()) point[i] = view_->axes[i].to_drive(point[i]);
        routed_.through = std::move(through);
    }
    if (m.kind == MoveKind::ArcCw || m.kind == MoveKind::ArcCcw) {
        const ChannelAxis &p = view_->axes[m.plane_p], &q = view_->axes[m.plane_q];
        const bool p_here = !m.kinematics || !has_role(*m.kinematics, m.plane_p),
                   q_here = !m.kinematics || !has_role(*m.kinematics, m.plane_q);
        if (p.turned_round() && p_here) routed_.centre_p = p.to_drive(m.centre_p);
        if (q.turned_round() && q_here) routed_.centre_q = q.to_drive(m.centre_q);
        if ((p.reversed() && p_here) != (q.reversed() && q_here)) routed_.sweep = -m.sweep;
    }
    next_->move(routed_, at);
}

void RouteSink::spindle(const Spindle& s, const BlockContext& at) {
    if (s.css_axis < 0 || !view_->axes[static_cast<std::size_t>(s.css_axis)].turned_round())
        return next_->spindle(s, at);
    Spindle routed = s;
    routed.css_zero = view_->axes[static_cast<std::size_t>(s.css_axis)].to_drive(s.css_zero);
    next_->spindle(routed, at);
}

}  // namespace polyturn::channels
