// The polar plane's own questions: how near a way comes to the pole, and where the rotary axis is
// behind it.
#pragma once
#include "ipc/kinematics/kinematics.hpp"

namespace polyturn {

// A line that passes the pole nearer than this is driven through it, mm.
inline constexpr double kThroughPole = 0.0005;

struct PlanePoint {
    double u = 0, v = 0;
};
PlanePoint plane_point(const Kinematics& k, double linear, double rotary) noexcept;

// Where the rotary axis ends that drove a line through the pole from `turn` on: the direction of
// the end, or opposite to it, whichever is nearer. An end in the pole leaves it where it is.
double turn_through_pole(const Kinematics& k, double turn, const RoleValues& end) noexcept;

struct NearestToPole {
    double distance = 0;
    double share = 0;  // of the line from a to b, 0 to 1
};
NearestToPole nearest_to_pole(PlanePoint a, PlanePoint b) noexcept;
// Of an arc about c: its least distance from the pole.
double arc_to_pole(PlanePoint c, double radius, double start_angle, double sweep) noexcept;

// How far (rad) the direction from the pole turns along an arc that does not touch the pole; more
// than a turn is possible.
double turned_about_pole(PlanePoint c, double radius, double radius_end, double start_angle,
                         double sweep) noexcept;

}  // namespace polyturn
