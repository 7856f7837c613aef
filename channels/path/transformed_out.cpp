#include "channels/path/transformed_out.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/path/pole_parameter.hpp"
#include "ipc/kinematics/polar.hpp"

namespace polyturn::channels {
namespace {

constexpr double kShortest = 1e-6;     // mm: no piece is cut shorter
constexpr double kTurnOfPiece = 10.0;  // degrees of a rotary axis of head or table within a piece

bool is_motion(const PathRecord& r) {
    return r.kind >= 1 && r.kind <= static_cast<std::uint8_t>(RecordKind::Curve);
}

void scale(PathAxis& axis, double factor) {
    for (double* value : {&axis.rapid, &axis.feed, &axis.accel, &axis.normal, &axis.jerk,
                          &axis.speed_step, &axis.accel_step, &axis.accel_step_arc})
        *value *= factor;
}

// Of both what allows less: the smaller limits, and the larger parts that speed takes of them.
void lower(const RecordLimits& c, PathRecord& r) {
    static_assert(sizeof(RecordLimits) == 7 * sizeof(double),
                  "whatever else limits a record must be taken over here as well");
    const double a = std::min(r.a_max, c.a), j = std::min(r.j_max, c.j);
    const auto part = [](double x, double of_x, double y, double of_y, double of) {
        const double most =
            std::max(std::isfinite(of_x) ? x / of_x : 0, std::isfinite(of_y) ? y / of_y : 0);
        return std::isfinite(of) ? most * of : 0;  // without a limit nothing is taken of it
    };
    r.bend = part(r.bend, r.a_max, c.bend, c.a, a);
    r.bend_turning = part(r.bend_turning, r.j_max, c.turning, c.j, j);
    r.bend_along = part(r.bend_along, r.j_max, c.along, c.j, j);
    r.bend_across = part(r.bend_across, r.j_max, c.across, c.j, j);
    r.v_max = std::min(r.v_max, c.v);
    r.a_max = a;
    r.j_max = j;
}

}  // namespace

void TransformedOut::begin(const Kinematics& kinematics, double turn, SideOfPole side) {
    kinematics_ = kinematics;
    turn_ = turn;
    side_ = side;
}

// The limits by which the path maker decides on corners. The limits that count in the end are those of the
// drives.
const PathLimits& TransformedOut::limits() {
    path_ = *drives_;
    const Kinematics& k = kinematics_;
    if (kind_of(k) == KinematicsKind::Polar) {  // its second coordinate is like the first
        path_.axis[k.axis[1]] = path_.axis[k.axis[0]];
    } else if (kind_of(k) == KinematicsKind::Cylinder) {
        scale(path_.axis[k.axis[0]], std::abs(k.value[0]) * std::numbers::pi / 180.0);
        path_.axis[k.axis[0]].rotary = false;
    }
    return path_;
}

void TransformedOut::commit() {
    if (is_motion(record_) && record_.transform != 0) {
        put_pieces();
        return;
    }
    next_->claim() = record_;
    next_->commit();
}

// A line that the linear axis drives alone, from one side of the pole to the other or up to it.
bool TransformedOut::through_pole(PathRecord& r) {
    const Kinematics& k = kinematics_;
    if (kind_of(k) != KinematicsKind::Polar || k.value[0] != 0 ||
        static_cast<RecordKind>(r.kind) != RecordKind::Line)
        return false;
    const auto slots = slots_of(r, k);
    if (slots[0] == kMaxPathAxes || slots[1] == kMaxPathAxes) return false;
    const PlanePoint a = plane_point(k, r.start[slots[0]], r.start[slots[1]]),
                     b = plane_point(k, r.end[slots[0]], r.end[slots[1]]);
    if (nearest_to_pole(a, b).distance >= kThroughPole) return false;
    r.side = static_cast<std::uint8_t>(SideOfPole::Through);
    r.turn = turn_;
    RoleValues axes{};
    SlotVector end{};
    std::copy(r.end.begin(), r.end.end(), end.begin());
    turn_ = turn_through_pole(k, turn_, role_values(r, k, end));
    (void)to_axes(k, {turn_, SideOfPole::Through}, role_values(r, k, end), axes);
    if (std::abs(axes[0] - k.centre[0]) > kThroughPole)
        side_ = axes[0] < k.centre[0] ? SideOfPole::Negative : SideOfPole::Positive;
    return true;
}

double TransformedOut::piece_length(double from, double most) const {
    double length = most;
    if (kind_of(kinematics_) == KinematicsKind::FiveAxis) {  // in proportion along the record
        const auto slots = slots_of(record_, kinematics_);
        double turn = 0;
        for (std::size_t r = 3; r < kMaxRoles; ++r)
            if (slots[r] < kMaxPathAxes)
                turn = std::max(turn, std::abs(record_.end[slots[r]] - record_.start[slots[r]]));
        while (length > kShortest && turn * length > kTurnOfPiece * record_.length) length *= 0.5;
        return length;
    }
    const auto reach_at = [&](double s) {
        SlotVector position;
        position_at(record_, s, position);
        return reach(kinematics_, role_values(record_, kinematics_, position));
    };
    const double here = reach_at(from);
    while (length > kShortest &&
           length > kPieceShare *
                        std::min({here, reach_at(from + 0.5 * length), reach_at(from + length)}))
        length *= 0.5;
    return length;  // a half, a quarter ... of what is left: no last crumb
}

void TransformedOut::put_pieces() {
    if (through_pole(record_)) {
        piece_ = record_;
        put(piece_, true, true);
        return;
    }
    const PoleParameter parameter = PoleParameter::of(record_, kinematics_, *drives_);
    double from = 0;
    for (bool first = true; first || from < record_.length; first = false) {
        const double length = piece_length(from, record_.length - from);
        const bool last = from + length >= record_.length;
        if (first && last)
            piece_ = record_;
        else
            cut(record_, from, last ? record_.length : from + length, piece_);
        parameter.apply(from, last ? record_.length : from + length, piece_);
        piece_.turn = turn_;
        piece_.side = static_cast<std::uint8_t>(side_);
        const Branch branch{turn_, side_};
        RoleValues axes{};
        SlotVector position;
        position_at(piece_, 0, position);
        if (kind_of(kinematics_) == KinematicsKind::Polar) {
            if (to_axes(kinematics_, branch, role_values(piece_, kinematics_, position), axes))
                piece_.turn = axes[1];
            position_at(piece_, piece_.length, position);
            if (to_axes(kinematics_, {piece_.turn, side_},
                        role_values(piece_, kinematics_, position), axes))
                turn_ = axes[1];
        }
        put(piece_, first, last);
        from = last ? record_.length : from + length;
    }
}

void TransformedOut::put(PathRecord& piece, bool first, bool last) {
    if (!first) piece.flags &= ~std::uint32_t{kBlockBegin};
    if (!last) piece.flags &= ~std::uint32_t{kBlockEnd | kExactStop | kInPosition};
    RecordLimits behind;
    if (record_limits_behind(piece, kinematics_, *drives_, behind))
        lower(behind, piece);
    else
        // cannot be: TransformSink has refused it; the kernel then stops rather than jumps
        piece.v_max = 0;
    next_->claim() = piece;
    next_->commit();
}

}  // namespace polyturn::channels
