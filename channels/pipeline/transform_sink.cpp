#include "channels/pipeline/transform_sink.hpp"

#include <cmath>
#include <numbers>

#include "channels/state/tip_control.hpp"

namespace polyturn::channels {
namespace {

constexpr double kDeg = 180.0 / std::numbers::pi;
constexpr double kSameAngle = 1e-7;  // degrees that the rotary axis need not be turned by

void take(const Transformation& t, const AxisValues& values, RoleValues& roles) {
    for (std::size_t r = 0; r < role_count(kind_of(t.kinematics)); ++r)
        roles[r] = t.kinematics.axis[r] == kNoPlace ? t.kinematics.centre[r]
                                                    : values[t.kinematics.axis[r]];
}

void put(const Transformation& t, const RoleValues& roles, AxisValues& values) {
    for (std::size_t r = 0; r < role_count(kind_of(t.kinematics)); ++r)
        if (t.kinematics.axis[r] != kNoPlace) values[t.kinematics.axis[r]] = roles[r];
}

}  // namespace

void places_to_path(const Transformation& t, AxisValues& values) {
    RoleValues from{}, to{};
    take(t, values, from);
    to_path(t.kinematics, from, to);
    put(t, to, values);
}

bool places_to_axes(const Transformation& t, const Branch& branch, AxisValues& values) {
    RoleValues from{}, to{};
    take(t, values, from);
    if (!to_axes(t.kinematics, branch, from, to)) return false;
    put(t, to, values);
    return true;
}

bool TransformSink::fail(double distance) {
    failed_ = true;
    failed_at_ = distance;
    return false;
}

void TransformSink::move(const Move& m, const BlockContext& at) {
    if (failed_) return;  // nothing of the program is driven behind what cannot be
    const Transformation& t = *transformation_;
    if (m.beside) {  // an axis that the transformation leaves alone
        for (unsigned i = 0; i < view_->axis_count; ++i)
            if (m.moved >> i & 1u) axes_[i] = m.machine[i];
        return next_->move(m, at);
    }
    if (!t.active()) {
        for (unsigned i = 0; i < view_->axis_count; ++i) axes_[i] = m.machine[i];
        next_->move(m, at);
        return;
    }
    out_ = m;
    out_.kinematics = &t.kinematics;
    out_.path_start = m.machine_start;
    out_.path = m.machine;
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (!t.uses(i)) axes_[i] = m.machine_start[i];
    AxisSet roles = 0;
    for (std::size_t r = 0; r < role_count(kind_of(t.kinematics)); ++r)
        if (t.kinematics.axis[r] != kNoPlace) roles |= 1u << t.kinematics.axis[r];
    if (m.moved & roles) out_.moved |= roles;
    show_degrees();
    if (kind_of(t.kinematics) == KinematicsKind::Polar && (out_.moved & roles)) return polar(at);
    out_.machine_start = axes_;
    out_.machine = m.machine;
    if (!places_to_axes(t, {}, out_.machine)) {
        fail(0);
        return;
    }
    deliver(at);
}

// Constant surface speed looks at the turning axis' drive. One that is inclined reads 1 / cos a
// times the radius: its record has so much more speed, which the event does not show.
void TransformSink::spindle(const Spindle& s, const BlockContext& at) {
    next_->spindle(s, at);
    const Kinematics& k = transformation_->kinematics;
    if (kind_of(k) != KinematicsKind::Inclined || s.mode != SpindleModeCode::SurfaceSpeed ||
        s.css_axis != k.axis[0])
        return;
    Spindle inclined = s;
    inclined.silent = true;
    inclined.value = s.value / std::cos(k.value[0]);
    inclined.css_zero = k.centre[0] + (s.css_zero - k.centre[0]) / std::cos(k.value[0]);
    next_->spindle(inclined, at);
}

// On a cylinder that is programmed by the angle, events show the angle too.
void TransformSink::show_degrees() {
    const Transformation& t = *transformation_;
    if (!t.degrees) return;
    const std::uint8_t c = t.kinematics.axis[0];
    out_.pos[c] *= t.degrees_per_mm();
    if (is_arc(out_) && out_.plane_p == c) out_.pos_centre_p *= t.degrees_per_mm();
    if (is_arc(out_) && out_.plane_q == c) out_.pos_centre_q *= t.degrees_per_mm();
}

void TransformSink::deliver(const BlockContext& at) {
    next_->move(out_, at);
    axes_ = out_.machine;
}

bool TransformSink::may_stand(double from_pole) const {
    const Transformation& t = *transformation_;
    if (t.side == PoleSide::Positive && from_pole < -kThroughPole) return false;
    if (t.side == PoleSide::Negative && from_pole > kThroughPole) return false;
    const ChannelAxis& axis = view_->axes[t.kinematics.axis[0]];
    const double drive = axis.to_drive(t.kinematics.centre[0] + from_pole);
    return !axis.limited || (drive <= axis.limit_max + 1e-6 && drive >= axis.limit_min - 1e-6);
}

void TransformSink::polar(const BlockContext& at) {
    const Kinematics& k = transformation_->kinematics;
    const std::uint8_t x = k.axis[0], c = k.axis[1];
    const double d = std::fabs(k.value[0]);
    const PlanePoint a = plane_point(k, out_.path_start[x], out_.path_start[c]),
                     b = plane_point(k, out_.path[x], out_.path[c]);
    out_.machine_start = axes_;
    out_.machine = out_.path;
    double turned = 0;
    const bool in_plane =
        (out_.plane_p == x && out_.plane_q == c) || (out_.plane_p == c && out_.plane_q == x);
    // with one axis of the polar plane at the most: a line there, there and back
    if (is_arc(out_) && !in_plane) {
        const std::uint8_t role = out_.plane_p == x || out_.plane_q == x ? x : c;
        const double centre = out_.plane_p == role ? out_.centre_p : out_.centre_q;
        PlanePoint low = a, high = a;
        (role == x ? low.u : low.v) = centre - k.centre[role == x ? 0 : 1] - out_.radius;
        (role == x ? high.u : high.v) = centre - k.centre[role == x ? 0 : 1] + out_.radius;
        const double clear = nearest_to_pole(low, high).distance;
        if (clear < d + kThroughPole) {
            fail(clear);
            return;
        }
        turned = std::remainder(std::atan2(b.v, b.u) - std::atan2(a.v, a.u), 2 * std::numbers::pi);
    } else if (is_arc(out_)) {
        const bool xc = out_.plane_p == x;
        const PlanePoint centre = xc ? plane_point(k, out_.centre_p, out_.centre_q)
                                     : plane_point(k, out_.centre_q, out_.centre_p);
        const double sweep = xc ? out_.sweep : -out_.sweep,
                     start = std::atan2(a.v - centre.v, a.u - centre.u);
        const double clear = arc_to_pole(centre, out_.radius, start, sweep);
        if (clear < d + kThroughPole) {
            fail(clear);
            return;
        }
        turned = turned_about_pole(centre, out_.radius, out_.radius_end, start, sweep);
    } else {
        const NearestToPole near = nearest_to_pole(a, b);
        if (d > 0 && near.distance < d + kThroughPole) {
            fail(near.distance);
            return;
        }
        if (d == 0 && near.distance < kThroughPole) return through_pole(at, a, b, near.share);
        turned = std::remainder(std::atan2(b.v, b.u) - std::atan2(a.v, a.u), 2 * std::numbers::pi);
    }
    const double sense = k.value[1] < 0 ? -1.0 : 1.0;
    const SideOfPole side = axes_[x] < k.centre[0] ? SideOfPole::Negative : SideOfPole::Positive;
    if (!places_to_axes(*transformation_, {axes_[c] + sense * turned * kDeg, side}, out_.machine)) {
        fail(std::hypot(b.u, b.v));
        return;
    }
    deliver(at);
}

// The rotary axis is at an angle from which the linear axis reaches both ends: along the
// direction to the farther one.
void TransformSink::through_pole(const BlockContext& at, PlanePoint a, PlanePoint b,
                                 double pole_at) {
    const Kinematics& k = transformation_->kinematics;
    const std::uint8_t x = k.axis[0], c = k.axis[1];
    const double sense = k.value[1] < 0 ? -1.0 : 1.0;
    const Move whole = out_;
    const bool from_pole = std::hypot(a.u, a.v) < kThroughPole,
               to_pole = std::hypot(b.u, b.v) < kThroughPole;
    // of the linear axis, with the rotary one there
    const auto along = [&](double degrees, PlanePoint p) {
        const double angle = (degrees - k.centre[1]) * sense / kDeg;
        return p.u * std::cos(angle) + p.v * std::sin(angle);
    };
    const auto drive = [&](PlanePoint to, bool last) {
        out_.machine_start = axes_;
        out_.machine[c] =
            turn_through_pole(k, axes_[c], {k.centre[0] + to.u, k.centre[1] + to.v, 0, 0, 0});
        out_.machine[x] = k.centre[0] + along(out_.machine[c], to);
        out_.exact_stop = whole.exact_stop || !last;
        deliver(at);
    };
    if (from_pole) {  // in the shorter direction to where b lies on either side
        const double towards = k.centre[1] + sense * std::atan2(b.v, b.u) * kDeg;
        const double reach = std::hypot(b.u, b.v);
        double turn = std::remainder(towards - axes_[c], 360.0);
        const double other = std::remainder(turn + 180.0, 360.0);
        if (!may_stand(reach) || (std::fabs(other) < std::fabs(turn) && may_stand(-reach)))
            turn = other;
        if (!to_pole && std::fabs(turn) > kSameAngle) {
            for (unsigned i = 0; i < view_->axis_count; ++i)
                out_.pos[i] -= whole.path[i] - whole.path_start[i];
            turn_in_pole(at, axes_[c] + turn);
            out_ = whole;
        }
        return drive(b, true);
    }
    if (to_pole || may_stand(along(axes_[c], b))) return drive(b, true);
    // To the pole, half a turn, and back by the same travel.
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        if (transformation_->uses(i)) continue;
        out_.path[i] = out_.machine[i] =
            whole.path_start[i] + pole_at * (whole.path[i] - whole.path_start[i]);
        out_.pos[i] = whole.pos[i] - (whole.path[i] - out_.path[i]);
    }
    out_.path[x] = k.centre[0];
    out_.path[c] = k.centre[1];
    out_.pos[x] = whole.pos[x] - (whole.path[x] - out_.path[x]);
    out_.pos[c] = whole.pos[c] - (whole.path[c] - out_.path[c]);
    const Move pole = out_;
    drive({0, 0}, false);
    turn_in_pole(at, axes_[c] + 180.0);
    out_ = whole;
    out_.path_start = pole.path;
    drive(b, true);
}

// The tool is in the pole, so this is no travel of it: a move of the rotary axis alone.
void TransformSink::turn_in_pole(const BlockContext& at, double degrees) {
    const std::uint8_t c = transformation_->kinematics.axis[1];
    out_.kinematics = nullptr;
    out_.kind = out_.kind == MoveKind::Rapid ? MoveKind::Rapid : MoveKind::Linear;
    out_.machine_start = out_.machine = axes_;
    out_.machine[c] = degrees;
    out_.moved = 1u << c;
    out_.exact_stop = true;
    if (out_.kind == MoveKind::Linear) {
        out_.feed_mode = FeedMode::PerMinute;
        out_.feed = view_->axes[c].max_feed_mm_min;
        out_.feed_scale = 1.0;
    }
    out_.speed_limit = 0.0;
    deliver(at);
}

}  // namespace polyturn::channels
