// Compensation and corner elements in the plane of a frame that inclines it: what Core delivers is
// turned into that plane, InclinedSink turns it back.
#include <cmath>

#include "channels/pipeline/inclined_sink.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels {
namespace {

constexpr double kAlike = 1e-9;                                     // share of a direction
constexpr double kStandsInside = 1e-9;                              // mm: no movement
constexpr std::size_t kPlaneAxes[3][2] = {{0, 1}, {2, 0}, {1, 2}};  // XY ZX YZ

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point3 cross(const Point3& a, const Point3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

// The plane as it lies in the system of the zeros: its axes where the frame's point, without
// factors.
bool Core::inclined_plane(Frame& plane) const {
    if (!path.framed || path.plane_p >= 0 || geo_[0] < 0 || geo_[1] < 0 || geo_[2] < 0)
        return false;
    const auto [gp, gq] = kPlaneAxes[static_cast<std::size_t>(path.plane)];
    Point3 p = path.frame.axis(static_cast<GeoAxis>(gp)),
           q = path.frame.axis(static_cast<GeoAxis>(gq));
    const double size = std::sqrt(dot(p, p)), other = std::sqrt(dot(q, q));
    if (std::fabs(size - other) > kAlike * size || std::fabs(dot(p, q)) > kAlike * size * size)
        return false;
    for (std::size_t k = 0; k < 3; ++k) {
        p[k] /= size;
        q[k] /= size;
    }
    const Point3 up = cross(p, q);
    for (const double share : up)
        if (std::fabs(share) > 1 - kAlike) return false;
    const std::size_t gw = 3 - gp - gq;
    for (std::size_t row = 0; row < 3; ++row) {
        plane.linear[row][gp] = p[row];
        plane.linear[row][gq] = q[row];
        plane.linear[row][gw] = up[row];
    }
    plane.shift = path.frame.shift;
    return true;
}

bool Core::frame_inclines() const {
    Frame plane;
    return inclined_plane(plane);
}

// The stages in the chain work in that plane from now on.
Sink& Core::incline(bool wanted) {
    Frame plane;
    inclined_ = wanted && inclined_plane(plane);
    if (!inclined_) return *out_;
    if (!incline_) incline_ = std::make_unique<InclinedSink>(*view_, geo_);
    incline_->open(*out_, plane, path.machine);
    return *incline_;
}

// move_ as it is inside the plane; where it really ends stays in real_end_.
void Core::take_incline_off() {
    if (!inclined_ || factors_off_) return;
    factors_off_ = true;
    real_end_ = move_.machine;
    AxisValues from{};
    for (unsigned i = 0; i < view_->axis_count; ++i)
        from[i] = move_.machine_start[i] - path.turns_deg[i] - path.zero[i] - path.shift[i] -
                  path.vector[i];
    const AxisValues start = incline_->inside(from), end = incline_->inside(move_.pos);
    for (const int place : geo_) {
        const auto i = static_cast<std::size_t>(place);
        move_.machine_start[i] += start[i] - from[i];
        move_.machine[i] += end[i] - move_.pos[i];
        move_.pos[i] = end[i];
        const bool moves = std::fabs(move_.machine[i] - move_.machine_start[i]) > kStandsInside;
        if (!moves) {
            move_.pos[i] += move_.machine_start[i] - move_.machine[i];
            move_.machine[i] = move_.machine_start[i];
        }
        move_.moved = moves ? move_.moved | 1u << i : move_.moved & ~(1u << i);
    }
}

// The arc as it is inside the plane.
void Core::incline_arc(ArcCall& call, const AxisValues& target, unsigned p, unsigned q) const {
    AxisValues centre = target;
    centre[p] = call.centre_p;
    centre[q] = call.centre_q;
    AxisValues ahead = centre, across = centre;
    ahead[p] += 1.0;
    across[q] += 1.0;
    const AxisValues inside = incline_->inside(framed(centre)),
                     along = incline_->inside(framed(ahead)),
                     beside = incline_->inside(framed(across));
    const double pp = along[p] - inside[p], pq = along[q] - inside[q], qp = beside[p] - inside[p],
                 qq = beside[q] - inside[q];
    const double scale = std::hypot(pp, pq);
    call.centre_p = inside[p];
    call.centre_q = inside[q];
    call.radius *= scale;
    call.tolerance *= scale;
    if (pp * qq - pq * qp < 0) call.clockwise = !call.clockwise;
}

// Machine coordinates of a point that is meant inside the plane.
AxisValues Core::behind_incline(AxisValues machine) const {
    AxisValues added{};
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        added[i] = path.turns_deg[i] + path.zero[i] + path.shift[i] + path.wanted[i];
        machine[i] -= added[i];
    }
    machine = incline_->outside(machine);
    for (unsigned i = 0; i < view_->axis_count; ++i) machine[i] += added[i];
    return machine;
}

double Core::displaced_along(unsigned place, double p, double q) const {
    const auto [gp, gq] = kPlaneAxes[static_cast<std::size_t>(path.plane)];
    Point3 inside{};
    inside[gp] = p;
    inside[gq] = q;
    const Point3 real = incline_->direction(inside);
    for (std::size_t k = 0; k < 3; ++k)
        if (geo_[k] == static_cast<int>(place)) return real[k];
    return 0.0;
}

}  // namespace polyturn::channels
