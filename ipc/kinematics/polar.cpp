#include "ipc/kinematics/polar.hpp"

#include <algorithm>
#include <numbers>

namespace polyturn {

PlanePoint plane_point(const Kinematics& k, double linear, double rotary) noexcept {
    return {linear - k.centre[0], rotary - k.centre[1]};
}

double turn_through_pole(const Kinematics& k, double turn, const RoleValues& end) noexcept {
    const PlanePoint p = plane_point(k, end[0], end[1]);
    if (std::hypot(p.u, p.v) < kThroughPole) return turn;
    const double towards = k.centre[1] + (k.value[1] < 0 ? -1.0 : 1.0) * std::atan2(p.v, p.u) *
                                             180.0 / std::numbers::pi;
    return turn + std::remainder(towards - turn, 180.0);
}

NearestToPole nearest_to_pole(PlanePoint a, PlanePoint b) noexcept {
    const double du = b.u - a.u, dv = b.v - a.v, square = du * du + dv * dv;
    const double share = square > 0 ? std::clamp(-(a.u * du + a.v * dv) / square, 0.0, 1.0) : 0.0;
    return {std::hypot(a.u + share * du, a.v + share * dv), share};
}

double arc_to_pole(PlanePoint c, double radius, double start_angle, double sweep) noexcept {
    const auto at = [&](double angle) {
        return std::hypot(c.u + radius * std::cos(angle), c.v + radius * std::sin(angle));
    };
    double least = std::min(at(start_angle), at(start_angle + sweep));
    // The point of the circle that is nearest lies in the direction from its centre to the pole.
    const double low = std::min(start_angle, start_angle + sweep), towards = std::atan2(-c.v, -c.u);
    const double turn = 2 * std::numbers::pi,
                 nearest = towards + std::ceil((low - towards) / turn) * turn;
    if (nearest <= low + std::abs(sweep))
        least = std::min(least, std::abs(std::hypot(c.u, c.v) - radius));
    return least;
}

// Cut at the directions from the centre to the pole, away from it and across: within each such
// quarter the direction from the pole turns by less than half a turn, whether the pole lies inside
// or outside.
double turned_about_pole(PlanePoint c, double radius, double radius_end, double start_angle,
                         double sweep) noexcept {
    const double quarter = std::numbers::pi / 2, sense = sweep < 0 ? -1.0 : 1.0,
                 whole = std::abs(sweep);
    const double towards = std::atan2(-c.v, -c.u);
    // a border, counted along the line
    const double first = std::remainder((towards - start_angle) * sense, quarter);
    const auto direction = [&](double way) {
        const double angle = start_angle + sense * way,
                     r = radius + (whole > 0 ? way / whole : 0.0) * (radius_end - radius);
        return std::atan2(c.v + r * std::sin(angle), c.u + r * std::cos(angle));
    };
    double turned = 0, before = direction(0);
    const auto step = [&](double way) {
        const double now = direction(way);
        turned += std::remainder(now - before, 2 * std::numbers::pi);
        before = now;
    };
    for (double way = first > 0 ? first : first + quarter; way < whole; way += quarter) step(way);
    step(whole);
    return turned;
}

}  // namespace polyturn
