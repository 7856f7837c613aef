// Behind the path maker while a transformation is on: adds to records in path coordinates what the
// kernel needs to compute the axes, and limits for the axes behind the transformation.
//
// Near the pole of a polar plane the axes' derivatives grow without bound (a line that passes it at
// the distance b: C' = 1/b, C'' ~ 1/b^2, C''' ~ 2/b^3), so a record is cut into pieces that are
// short against the distance from the pole:
//
//      pole   .--.---.-----.--------.-------------     length <= kPieceShare * distance: about 40
//       o  -'                                          pieces from 100 mm down to 1 um and as many
//                                                      away again
//
// Within a piece the derivatives change by some tens of per cent, so its limits, from samples,
// cost little; and each piece has its own: speed falls towards the pole as the axes demand it, and
// nothing stops (docs/design/transformations.md). A line through the pole itself needs the linear
// axis only (SideOfPole::Through) and stays one record.
//
// Right   The limits hold for every axis as those of record_limits.hpp do, with the derivatives of
//         the drives in place of the slots'. What the path maker asked for (corner rules, N0310)
//         stays: the lower of the two counts.
#pragma once
#include "channels/path/path_maker.hpp"

namespace polyturn::channels {

inline constexpr double kPieceShare = 0.25;

class TransformedOut : public RecordOut {
public:
    TransformedOut(RecordOut& next, const PathLimits& drives) : next_(&next), drives_(&drives) {}

    // From now on: the transformation by drives (axis: machine axes, route), the position of its
    // rotary axis before the route, and the side of the linear one. limits() are for the path maker
    // then.
    void begin(const Kinematics& kinematics, double turn, SideOfPole side);
    const PathLimits& limits();

    PathRecord& claim() override { return record_ = PathRecord{}; }
    void commit() override;

private:
    void put_pieces();
    void put(PathRecord& piece, bool first, bool last);
    bool through_pole(PathRecord& r);
    double piece_length(double from, double most) const;

    RecordOut* next_;
    const PathLimits* drives_;
    // the drives', with path coordinates in place of the roles' axes
    PathLimits path_;
    Kinematics kinematics_{};
    double turn_ = 0;
    SideOfPole side_ = SideOfPole::Positive;
    PathRecord record_, piece_;
};

}  // namespace polyturn::channels
