// The smooth transition from one move into the next: it replaces a corner, so that velocity and
// acceleration stay continuous.
//
//     A ------------.  C            d   trim: the blend begins d before the corner and ends d
//        begins ^    '. ^               behind it
//                  w   \            w   deviation: from the corner to the blend's middle,
//                       |               <= tolerance
//                       v B         l   length of each half
//
// At both ends position, tangent and curvature are those of the neighbours (a line has curvature
// 0), in the middle the two halves meet likewise; each half is a quintic per axis.
//
// Between two lines with the turn T each half is a clothoid: driven at constant speed the direction
// turns with constant angular acceleration, the least jerk for a given deviation. With h = T/2, for
// l = 1:
//     X = sum (-h^2)^n / ((2n)! (4n+1))            along A                                      (1)
//     Y = sum h (-h^2)^n / ((2n+1)! (4n+3))        across
//     d = X + Y tan h,   w = Y / cos h,   curvature in the middle T
// A quintic through the ends of a half with their tangents and curvatures differs from the clothoid
// by less than 1e-3 of the speed up to 90 degrees; the parameter u(s) takes that away, a half that
// needs it is cut in two. Neighbours that are curved add what one quintic over the whole blend
// would have in the middle (it is linear in them).
//
// Right     Ends and middle meet by construction (Hermite); the deviation is measured against the
//           programmed path at the same distance from the corner, which is never less than the
//           distance to the path. Tested in blend_test.cpp.
// Cost      closed form between lines; with arcs up to six trials for the trim.
// Weakness  both trims are equal, so a short neighbour makes a small blend; the jerk at a
//           tangential line-arc junction is 2.25 times that of a transition curve that may shift
//           the arc.
#pragma once
#include "channels/path/record_limits.hpp"

namespace polyturn::channels {

// records of one blend, first half and second half together
inline constexpr std::size_t kMostPieces = 8;
// rad: 160 degrees; more is a reversal and stops
inline constexpr double kSharpestTurn = 2.8;
inline constexpr double kShortestTrim = 1e-5;  // mm: what is smaller stops
inline constexpr double kSpeedError = 1e-4;    // of |dp/ds|

struct BlendPiece {
    std::array<std::array<double, 6>, kMaxCurveAxes> position{};  // coefficients over u in 0..1
    std::array<double, 6> parameter{};                            // u(s)
    double length = 0;
};

// u(s) for a piece whose position is given: |dp/ds| over the `measured` axes is 1, exactly at both
// ends, where u(s) also leaves position without a second derivative along the path. False when it
// is off by more than kSpeedError in between.
bool fit_parameter(std::size_t axes, const std::array<bool, kMaxCurveAxes>& measured,
                   BlendPiece& piece);

struct Blend {
    std::uint8_t axis_count = 0;
    std::array<std::uint8_t, kMaxCurveAxes> axis{};
    std::array<BlendPiece, kMostPieces> piece;
    // pieces [0, first_half) belong to the earlier block, the rest to the later
    std::size_t first_half = 0, count = 0;
    double trim = 0;
    double angle = 0;  // of the corner, rad
    JunctionSides sides;
};

enum class Junction : std::uint8_t {
    Smooth,  // the two meet without a step: nothing is needed
    Blended,
    Stop,
};

// How `before` goes over into `after`; at most `room_before`, `room_after` of them may be used.
// `speed`: it is not driven faster there, so a longer blend would gain nothing.
Junction make_blend(const PathRecord& before, double room_before, const PathRecord& after,
                    double room_after, double speed, const PathLimits& limits, Blend& blend);

// Whether s of the record counts millimetres (some linear axis moves) or degrees.
bool linear_metric(const PathRecord& record, const PathLimits& limits);

}  // namespace polyturn::channels
