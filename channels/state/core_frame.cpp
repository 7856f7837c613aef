// The programmable frame between what is programmed and the system of the zeros.
#include <cmath>

#include "channels/state/core.hpp"

namespace polyturn::channels {
namespace {

constexpr double kSmall = 1e-9;  // mm, or a share of a direction
constexpr char kAxisNames[3] = {'X', 'Y', 'Z'};

}  // namespace

Point3 Core::geo_of(const AxisValues& values) const {
    Point3 point{};
    for (std::size_t k = 0; k < 3; ++k)
        if (geo_[k] >= 0) point[k] = values[static_cast<std::size_t>(geo_[k])];
    return point;
}

void Core::put_geo(AxisValues& values, const Point3& point) const {
    for (std::size_t k = 0; k < 3; ++k)
        if (geo_[k] >= 0) values[static_cast<std::size_t>(geo_[k])] = point[k];
}

AxisValues Core::framed(const AxisValues& programmed) const {
    if (!path.framed) return programmed;
    AxisValues out = programmed;
    for (unsigned i = 0; i < view_->axis_count; ++i)
        out[i] = programmed[i] * path.frame.scale[i] + path.frame.offset[i];
    put_geo(out, path.frame.map(geo_of(programmed)));
    return out;
}

AxisValues Core::unframed(const AxisValues& point) const {
    if (!path.framed) return point;
    AxisValues out = point;
    for (unsigned i = 0; i < view_->axis_count; ++i)
        out[i] = point[i] * path.inverse.scale[i] + path.inverse.offset[i];
    Point3 geo = geo_of(point);
    for (std::size_t k = 0; k < 3; ++k)
        // a missing axis is at standstill outside
        if (geo_[k] < 0) geo[k] = path.frame.shift[k];
    put_geo(out, path.inverse.map(geo));
    return out;
}

AxisValues Core::framed_now() const {
    AxisValues point{};
    for (unsigned i = 0; i < view_->axis_count; ++i)
        point[i] =
            path.machine[i] - path.turns_deg[i] - path.zero[i] - path.shift[i] - path.vector[i];
    return point;
}

void Core::rebase_all() {
    if (!path.framed) {
        for (unsigned i = 0; i < view_->axis_count; ++i) rebase(i);
        return;
    }
    settle_turns();
    path.programmed = unframed(framed_now());
}

// Whole turns are taken off outside the frame.
void Core::settle_turns() {
    bool changed = false;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const ChannelAxis& axis = view_->axes[i];
        if (!axis.rollover) continue;
        const double value = path.machine[i] - path.zero[i] - path.shift[i] - path.vector[i];
        const double turns = std::floor(value / axis.rollover_deg) * axis.rollover_deg;
        changed |= turns != path.turns_deg[i];
        path.turns_deg[i] = turns;
    }
    if (!changed) return;
    const AxisValues now = unframed(framed_now());
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (view_->axes[i].rollover) path.programmed[i] = now[i];
}

void Core::set_frame(const Frame& frame) {
    const bool mirrored = frame_mirrors_plane();
    path.frame = frame;
    path.framed = !frame.is_identity();
    path.inverse = path.framed ? frame.inverse() : Frame{};
    rebase_all();
    if (compensating_ && comp_side_ != CompSide::Off && mirrored != frame_mirrors_plane())
        select_side();
}

void Core::set_zeros(const Zeros& zeros) {
    path.external = zeros.external;
    path.work = zeros.work;
    path.preset = zeros.preset;
    path.local = zeros.local;
    for (unsigned i = 0; i < view_->axis_count; ++i)
        path.zero[i] = path.external[i] + path.work[i] + path.preset[i] + path.local[i];
    set_frame(zeros.frame);
    refresh_surface_zero();
}

bool Core::frame_mirrors_plane() const {
    // inside an inclined plane its axes run as the program's do
    if (!path.framed || inclined_) return false;
    static constexpr std::size_t kPlane[3][2] = {{0, 1}, {2, 0}, {1, 2}};  // XY ZX YZ
    const auto [p, q] = kPlane[static_cast<std::size_t>(path.plane)];
    const auto& m = path.frame.linear;
    return m[p][p] * m[q][q] - m[p][q] * m[q][p] < 0;
}

// A point whose image needs an axis that the channel does not have is not reachable.
bool Core::frame_reachable(const AxisValues& target) {
    const Point3 point = path.frame.map(geo_of(target));
    for (std::size_t k = 0; k < 3; ++k)
        if (geo_[k] < 0 && std::fabs(point[k] - path.frame.shift[k]) > 1e-6)
            return fail(Alarm::FrameAxisMissing, 0, std::string(1, kAxisNames[k]));
    return true;
}

// The arc as it is outside the frame: radius, centre, tolerance, sense, and the places of its
// plane's axes.
bool Core::frame_arc(ArcCall& call, const AxisValues& target, unsigned& p, unsigned& q) {
    // a plane of any two axes: only frames that leave their directions alone are programmed with it
    if (path.plane_p >= 0) {
        AxisValues centre = target;
        centre[p] = call.centre_p;
        centre[q] = call.centre_q;
        AxisValues ahead = centre;
        ahead[p] += 1.0;
        ahead[q] += 1.0;
        const AxisValues outside = before_factors(framed(centre)),
                         there = before_factors(framed(ahead));
        const double sp = there[p] - outside[p], sq = there[q] - outside[q], scale = std::fabs(sp);
        if (std::fabs(scale - std::fabs(sq)) > kSmall * scale)
            return fail(Alarm::FrameArcDistorted);
        call.centre_p = outside[p];
        call.centre_q = outside[q];
        call.radius *= scale;
        call.tolerance *= scale;
        if (sp * sq < 0) call.clockwise = !call.clockwise;
        return true;
    }
    static constexpr std::size_t kPlane[3][2] = {{0, 1}, {2, 0}, {1, 2}};
    const auto [gp, gq] = kPlane[static_cast<std::size_t>(path.plane)];
    const Frame frame = frame_before_factors();
    const Point3 ep = frame.axis(static_cast<GeoAxis>(gp)),
                 eq = frame.axis(static_cast<GeoAxis>(gq));
    const auto dot = [](const Point3& a, const Point3& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const double scale = std::sqrt(dot(ep, ep)), other = std::sqrt(dot(eq, eq));
    if (std::fabs(scale - other) > kSmall * scale ||
        std::fabs(dot(ep, eq)) > kSmall * scale * scale)
        return fail(Alarm::FrameArcDistorted);
    const Point3 normal{ep[1] * eq[2] - ep[2] * eq[1], ep[2] * eq[0] - ep[0] * eq[2],
                        ep[0] * eq[1] - ep[1] * eq[0]};
    std::size_t upright = 3;
    for (std::size_t k = 0; k < 3; ++k)
        if (std::fabs(normal[k]) > (1 - kSmall) * scale * scale) upright = k;
    if (upright == 3) return fail(Alarm::FrameArcInclined);
    AxisValues centre = target;
    centre[p] = call.centre_p;
    centre[q] = call.centre_q;
    const Point3 outside = frame.map(geo_of(centre));
    // right-handed: Y Z, Z X, X Y
    const std::size_t np = (upright + 1) % 3, nq = (upright + 2) % 3;
    if (geo_[np] < 0 || geo_[nq] < 0) return fail(Alarm::PlaneAxisMissing);
    p = static_cast<unsigned>(geo_[np]);
    q = static_cast<unsigned>(geo_[nq]);
    call.centre_p = outside[np];
    call.centre_q = outside[nq];
    call.radius *= scale;
    call.tolerance *= scale;
    if (normal[upright] < 0) call.clockwise = !call.clockwise;
    return true;
}

}  // namespace polyturn::channels
