#include "channels/pipeline/inclined_sink.hpp"

#include <cmath>

namespace polyturn::channels {
namespace {

constexpr double kPlaneSagitta = 0.001;  // mm between a chord and its arc
constexpr double kStands = 1e-9;         // mm: no movement

}  // namespace

AxisValues InclinedSink::mapped(const Frame& by, const AxisValues& values) const {
    Point3 point{};
    for (std::size_t k = 0; k < 3; ++k) point[k] = values[static_cast<std::size_t>(geometry_[k])];
    point = by.map(point);
    AxisValues out = values;
    for (std::size_t k = 0; k < 3; ++k) out[static_cast<std::size_t>(geometry_[k])] = point[k];
    return out;
}

void InclinedSink::move(const Move& m, const BlockContext& at) {
    out_ = m;
    AxisValues added{};  // zeros, tool: outside as inside
    for (unsigned i = 0; i < view_->axis_count; ++i) added[i] = m.machine[i] - m.pos[i];
    const auto drive = [&](AxisValues inside) {
        for (unsigned i = 0; i < view_->axis_count; ++i) inside[i] -= added[i];
        inside = outside(inside);
        for (unsigned i = 0; i < view_->axis_count; ++i) inside[i] += added[i];
        return inside;
    };
    if (is_arc(m)) {
        draw_arc(m, added);
    } else if (m.through) {
        auto points = std::make_shared<std::vector<AxisValues>>();
        points->reserve(m.through->size());
        for (const AxisValues& point : *m.through) points->push_back(drive(point));
        out_.through = std::move(points);
    }
    out_.pos = outside(m.pos);
    out_.machine = drive(m.machine);
    Point3 nose{};
    for (std::size_t k = 0; k < 3; ++k) nose[k] = m.nose[static_cast<std::size_t>(geometry_[k])];
    nose = plane_.direction(nose);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(geometry_[k]);
        out_.nose[i] = nose[k];
        out_.machine_start[i] = axes_[i];
        const bool moves = out_.through || std::fabs(out_.machine[i] - axes_[i]) > kStands;
        if (!moves) out_.machine[i] = axes_[i];
        out_.moved = moves ? out_.moved | 1u << i : out_.moved & ~(1u << i);
    }
    axes_ = out_.machine;
    next_->move(out_, at);
}

void InclinedSink::draw_arc(const Move& m, const AxisValues& added) {
    const double radius = std::fmax(std::fmax(m.radius, m.radius_end), 2 * kPlaneSagitta);
    const int steps =
        1 + static_cast<int>(std::fabs(m.sweep) / (2 * std::acos(1 - kPlaneSagitta / radius)));
    const double first = std::atan2(m.machine_start[m.plane_q] - m.centre_q,
                                    m.machine_start[m.plane_p] - m.centre_p);
    auto points = std::make_shared<std::vector<AxisValues>>();
    points->reserve(static_cast<std::size_t>(steps));
    for (int k = 1; k < steps; ++k) {
        const double part = static_cast<double>(k) / steps, angle = first + m.sweep * part,
                     r = m.radius + part * (m.radius_end - m.radius);
        AxisValues point = m.machine;
        for (unsigned i = 0; i < view_->axis_count; ++i)
            point[i] = m.machine_start[i] + part * (m.machine[i] - m.machine_start[i]) - added[i];
        point[m.plane_p] = m.centre_p + r * std::cos(angle) - added[m.plane_p];
        point[m.plane_q] = m.centre_q + r * std::sin(angle) - added[m.plane_q];
        point = outside(point);
        for (unsigned i = 0; i < view_->axis_count; ++i) point[i] += added[i];
        points->push_back(point);
    }
    out_.kind = MoveKind::Linear;
    out_.sweep = 0.0;
    out_.through = std::move(points);
}

}  // namespace polyturn::channels
