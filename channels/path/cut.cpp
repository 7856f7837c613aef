// Length of a programmed move, and parts of it.
#include <algorithm>

#include "channels/path/path_maker.hpp"
#include "channels/path/quintic.hpp"

namespace polyturn::channels {
namespace {

bool in_plane(const PathRecord& r, std::size_t slot) {
    return static_cast<RecordKind>(r.kind) == RecordKind::Arc &&
           (slot == r.plane[0] || slot == r.plane[1]);
}

}  // namespace

double path_length(const PathRecord& r, const PathLimits& limits) {
    double linear = 0, rotary = 0;
    for (std::size_t i = 0; i < r.axis_count; ++i) {
        if (in_plane(r, i)) continue;
        const double d = r.end[i] - r.start[i];
        (limits.axis[r.axis[i]].rotary ? rotary : linear) += d * d;
    }
    if (static_cast<RecordKind>(r.kind) == RecordKind::Arc) {
        const double last = r.shape[arc_shape::kRadiusEnd] > 0 ? r.shape[arc_shape::kRadiusEnd]
                                                               : r.shape[arc_shape::kRadius];
        const double mean = 0.5 * (r.shape[arc_shape::kRadius] + last),
                     turn = r.shape[arc_shape::kSweep] * mean;
        const double widening = last - r.shape[arc_shape::kRadius];
        return std::sqrt(turn * turn + widening * widening + linear);
    }
    return std::sqrt(linear > 0 ? linear : rotary);
}

void cut(const PathRecord& whole, double from, double to, PathRecord& part) {
    part = whole;
    part.length = to - from;
    SlotVector p{};
    position_at(whole, from, p);
    for (std::size_t i = 0; i < whole.axis_count; ++i) part.start[i] = p[i];
    position_at(whole, to, p);
    for (std::size_t i = 0; i < whole.axis_count; ++i) part.end[i] = p[i];
    if (static_cast<RecordKind>(whole.kind) == RecordKind::Line) return;
    // the same curve, its parameter counted from here
    if (static_cast<RecordKind>(whole.kind) == RecordKind::Curve) {
        const double* u = &whole.shape[curve_shape::kParameter];
        const Quintic shifted = part_of(Quintic{u[0], u[1], u[2], u[3], u[4], u[5]}, from, 1.0);
        for (std::size_t k = 0; k < 6; ++k) part.shape[curve_shape::kParameter + k] = shifted[k];
        return;
    }

    const double* c = &whole.shape[curve_shape::kParameter];
    Quintic fraction{c[0], c[1], c[2], c[3], c[4], c[5]};
    if (c[1] == 0) fraction = {0, 1 / whole.length};
    const double f0 = at(fraction, from), f1 = to >= whole.length ? 1.0 : at(fraction, to);
    const double radius = whole.shape[arc_shape::kRadius];
    const double widening =
        (whole.shape[arc_shape::kRadiusEnd] > 0 ? whole.shape[arc_shape::kRadiusEnd] : radius) -
        radius;
    part.shape[arc_shape::kStartAngle] =
        whole.shape[arc_shape::kStartAngle] + whole.shape[arc_shape::kSweep] * f0;
    part.shape[arc_shape::kSweep] = whole.shape[arc_shape::kSweep] * (f1 - f0);
    part.shape[arc_shape::kRadius] = radius + widening * f0;
    part.shape[arc_shape::kRadiusEnd] = radius + widening * f1;
    if (c[1] == 0) return;
    const Quintic shifted = part_of(fraction, from, 1.0);
    for (std::size_t k = 0; k < 6; ++k)
        part.shape[curve_shape::kParameter + k] =
            ((k == 0 ? shifted[0] - f0 : shifted[k])) / (f1 - f0);
}

}  // namespace polyturn::channels
