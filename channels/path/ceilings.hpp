// How fast, how hard and how suddenly a record may be driven so that no axis exceeds a limit.
//
// With t, k, p the first three derivatives of an axis' position over the path, its motion is
//     velocity      t v
//     acceleration  t a + k v^2
//     jerk          t j + 3 k v a + p v^3
// A record promises: at any state with speed <= v_max, |acceleration| <= a_max, |jerk| <= j_max no axis exceeds a limit.
// For a line k = p = 0 and the three are independent. Where the path bends they compete, so we decide
//     v_max    uses at most kBendShare of the acceleration and kTwistShare of the jerk that the axis has, all of N0402;
//     a_max    takes what is left of the acceleration, and at most half of the jerk that is left;
//     j_max    takes the rest.
// Speed that nobody can ask for would take from braking for nothing: with feed per minute v_max is at most twice the
// programmed feed (override 200 %). A dry run is held to it on bends; feed per revolution has no such bound.
// Cost of it: v_max loses 5 % on arcs (square root of kBendShare), a_max is 0.44 of the axis' acceleration at v_max on a
// full circle (there a and v^2/r act on different axes), more below.
// Curves are sampled; arcs also at each point where an axis turns back. kSampling covers what lies between samples.
#pragma once
#include "channels/path/path_limits.hpp"
#include "ipc/kinematics/kinematics.hpp"

namespace polyturn::channels {

inline constexpr double kBendShare = 0.9, kTwistShare = 0.9, kSampling = 0.995;
inline constexpr double kMostOverride = 2.0;   // feed override 200 %

struct Ceilings {
    double v = 0, a = 0, j = 0;
};

// For the record as it stands: Line, Arc (whole, or part of one) or Curve. kRapid in its flags chooses N0304.
Ceilings ceilings_of(const PathRecord& record, const PathLimits& limits);
// Of a record that lies in path coordinates; `drives` are the limits of the axes behind the transformation. The piece must be short
// against reach() (transformed_out.hpp). False: an axis cannot follow at any speed.
bool ceilings_behind(const PathRecord& record, const Kinematics& kinematics, const PathLimits& drives, Ceilings& ceilings);
void store(const Ceilings& ceilings, PathRecord& record);

// What N0307 to N0309, N0403, N0404 allow where `before` (end tangent, by slot of the axis list) and `after` meet.
// `arc`: at least one of the two is no line. Curvatures are those of the neighbours at the junction.
struct JunctionSides {
    std::uint8_t count = 0;
    std::array<std::uint8_t, 2 * kMaxPathAxes> axis{};
    std::array<double, 2 * kMaxPathAxes> before{}, after{}, bend_before{}, bend_after{};
    bool arc = false;
};
void apply_junction_rules(const JunctionSides& sides, double angle, const PathLimits& limits, Ceilings& ceilings);
// The same where only the turn is known, in a run of short lines: no axis can step by more than the turn.
void apply_turn_rules(const PathRecord& record, double turn, const PathLimits& limits, Ceilings& ceilings);

}  // namespace polyturn::channels
