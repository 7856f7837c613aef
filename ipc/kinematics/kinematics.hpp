// Transformations: path coordinates, in which a record lies, to the axes that drive it; one
// function for channel and kernel.
//
//   path coordinates --transformation--> axes --route (exchanged axes: sign, mirror)--> drives
//
// A coordinate has a role; each role has an axis, which the record names as a slot like any other.
// Slots without a role pass. Where the transformation has its zero (`centre`), path coordinate and
// axis of a role both read `centre`: that way zero offsets and tool lengths, which are in it, mean
// the same on either side.
//
//   Polar      roles: linear axis X, rotary axis C. With u = x - centre, v = c - centre (mm), d =
//              value[0] the distance of the rotary centre from the line of X (nct N0217, part 1
//              4.4)
//                  X = +-sqrt(u^2 + v^2 - d^2)      C = sense (atan2(v, u) - atan2(d, X))      (1)
//              sense = value[1]: 1 or -1. The sign is the record's side; whole turns of C by its
//              `turn`. A line through the pole (Through) has C = turn and X = u cos C + v sin C;
//              where it passes the pole by less than kThroughPole (polar.hpp), C goes the little
//              way from one direction to the opposite one evenly along it.
//   Cylinder   role: rotary axis. r = value[0] (mm; negative: the other sense), v the distance
//              along the surface
//                  C = v / r                                                             (2)
//   Inclined   roles: inclined axis X, square axis Z, angle a = value[0] (rad) between X and the
//              perpendicular of Z (fagor part 2 13, fanuc 10.5)
//                  X' = X / cos a      Z' = Z - X tan a                                   (3)
//              value[1] not 0: X does not move Z: Z' = Z - value[2]
//   FiveAxis   roles: X Y Z and two rotary axes: five_axis.hpp                           (4)
#pragma once
#include "ipc/kinematics/jet.hpp"
#include "ipc/path/path_geometry.hpp"

namespace polyturn {

inline constexpr std::size_t kMaxRoles = 5;
using RoleValues = std::array<double, kMaxRoles>;
using RoleJets = std::array<Jet, kMaxRoles>;

inline KinematicsKind kind_of(const Kinematics& k) noexcept {
    return static_cast<KinematicsKind>(k.kind);
}
std::size_t role_count(KinematicsKind kind) noexcept;
bool same(const Kinematics& a, const Kinematics& b) noexcept;

// What (1) leaves open. turn: rotary axis near which it is to be found, before the route.
struct Branch {
    double turn = 0;
    SideOfPole side = SideOfPole::Positive;
    double rate = 0;  // Through: of the rotary axis, degrees a millimetre of the path
};

// Before the route. False: no position of the axes belongs to it (polar: nearer to the centre than
// value[0]); out is untouched.
bool to_axes(const Kinematics& k, const Branch& branch, const RoleValues& path,
             RoleValues& axes) noexcept;
bool to_axes(const Kinematics& k, const Branch& branch, const RoleJets& path,
             RoleJets& axes) noexcept;
void to_path(const Kinematics& k, const RoleValues& axes, RoleValues& path) noexcept;
inline double routed(const Kinematics& k, std::size_t role, double axis) noexcept {
    return k.sign[role] * axis + k.shift[role];
}
inline double unrouted(const Kinematics& k, std::size_t role, double drive) noexcept {
    return (drive - k.shift[role]) * k.sign[role];
}

// Over which distance the map changes its character, mm: a piece of the path that is much shorter
// is harmless to sample.
double reach(const Kinematics& k, const RoleValues& path) noexcept;

// A record and what it does to its drives, by slot. Without a transformation its slots are drives;
// with one, k must be there.
bool drives_at(const PathRecord& record, const Kinematics* k, double s,
               SlotVector& drives) noexcept;
bool drive_derivatives_at(const PathRecord& record, const Kinematics* k, double s,
                          PathDerivatives& out) noexcept;
// Slot of each role; kMaxPathAxes: the record does not have it.
std::array<std::size_t, kMaxRoles> slots_of(const PathRecord& record, const Kinematics& k) noexcept;
RoleValues role_values(const PathRecord& record, const Kinematics& k,
                       const SlotVector& position) noexcept;

}  // namespace polyturn
