// Speed, acceleration and jerk limits of a record, so that no axis exceeds a limit.
//
// With t, k, p the first three derivatives of an axis' position over the path, its motion is
//     velocity      t v
//     acceleration  t a + k v^2
//     jerk          t j + 3 k v a + p v^3
// For a line k = p = 0 and the three are independent: v_max, a_max, j_max. Where the path bends
// they compete, and what is left for changing speed falls as the speed grows. A record says how, as
// two inequalities that hold for every axis:
//     a^2 + (bend v^2)^2                                      <= a_max^2                  (1)
//     (|j| + along v^3)^2 + (turning v |a| + across v^3)^2    <= j_max^2                  (2)
// Why      Divide each axis by its limit: t, k, p become vectors, and the motion keeps all limits
//          where what it makes of them is no longer than 1. With T, K, X the largest |t|, |k|,
//          |t k| of the record and c = X / (T K),
//              |t a + k v^2|^2 <= (1 + c) ((T a)^2 + (K v^2)^2)
//          With equal axes c = 0: a unit tangent and its derivative are orthogonal. (2) likewise, p
//          split along t and across.
//          Longer than 1 can still be within limits (at 45 degrees an axis sees 0.7 of it);
//          tests/bench/motion_bench: 4 % of time.
// v_max    is where (1) and (2) leave enough to slow down: kBendShare of (1), kAlongLeft and
//          kAcrossLeft of (2), and all of N0402. On an arc the bend never lowers v_max below N0310:
//          where it would, it is given as much more than N0400 as that takes (N0400 is what an axis
//          may change its speed with; what lies across the path is N0402's). The jerk limits it all
//          the same.
// A thread follows the spindle, at one speed: its record has all four 0, a_max and j_max are what
// is left at v_max, of which kThreadBend and kThreadTwist of acceleration and jerk go to the bend.
// Curves are sampled; arcs also at each point where an axis turns back. kSampling covers what lies
// between samples.
#pragma once
#include "channels/path/path_limits.hpp"
#include "ipc/kinematics/kinematics.hpp"

namespace polyturn::channels {

inline constexpr double kBendShare = 0.95, kAlongLeft = 0.1, kAcrossLeft = 0.08, kSampling = 0.995;
inline constexpr double kThreadBend = 0.9, kThreadTwist = 0.9;

struct RecordLimits {
    double v = 0, a = 0, j = 0;
    double bend = 0, turning = 0, along = 0, across = 0;
    // A rule that is none of the axes' limits: a_max falls, but not what the bend may take of it.
    void soften(double most) {
        if (!(most < a)) return;
        bend *= most / a;
        a = most;
    }
};

// For the record as it is: Line, Arc (whole, or part of one) or Curve. kRapid in its flags
// chooses N0304.
RecordLimits record_limits_of(const PathRecord& record, const PathLimits& limits);
// Of a record that lies in path coordinates; `drives` are the limits of the axes behind the
// transformation. The piece must be short against reach() (transformed_out.hpp). False: an axis
// cannot follow at any speed.
bool record_limits_behind(const PathRecord& record, const Kinematics& kinematics,
                          const PathLimits& drives, RecordLimits& record_limits);
void store(const RecordLimits& record_limits, PathRecord& record);

// What N0307 to N0309, N0403, N0404 allow where `before` (end tangent, by slot of the axis list)
// and `after` meet.
// `arc`: at least one of the two is no line. Curvatures are those of the neighbours at the
// junction.
struct JunctionSides {
    std::uint8_t count = 0;
    std::array<std::uint8_t, 2 * kMaxPathAxes> axis{};
    std::array<double, 2 * kMaxPathAxes> before{}, after{}, bend_before{}, bend_after{};
    bool arc = false;
};
void apply_junction_rules(const JunctionSides& sides, double angle, const PathLimits& limits,
                          RecordLimits& record_limits);
// The same where only the turn is known, in a run of short lines: no axis can step by more than the
// turn.
void apply_turn_rules(const PathRecord& record, double turn, const PathLimits& limits,
                      RecordLimits& record_limits);

}  // namespace polyturn::channels
