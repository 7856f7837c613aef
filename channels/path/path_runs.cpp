// How the path maker drives a run of short lines through one spline (spline_run.hpp).
//
//   chain_     [ line 0 | line 1 | line 2 | ... | newest ]
//   corners          v0       v1       v2                     all of a smooth curve
//   out               M~~~~~~~~~~~~~~~                        line 0 up to M as a line, then pieces
//                                                             of the spline
#include <algorithm>

#include "channels/path/path_maker.hpp"
#include "channels/path/quintic.hpp"

namespace polyturn::channels {
namespace {

constexpr std::uint32_t kNoRun = kExactStop | kInPosition | kRapid | kThread | kSkipMove;

// How much of the outer lines the curve may take: half of them, and about as much as its own lines
// are long, for an even pace over the parameter.
double outer_share(const PathRecord& outer, const PathRecord& inner) {
    return std::min(0.5 * outer.length, 2 * inner.length);
}

SplinePoint point_at(const PathRecord& line, double s) {
    SlotVector p{};
    position_at(line, s, p);
    SplinePoint point{};
    for (std::size_t k = 0; k < line.axis_count; ++k) point[k] = p[k];
    return point;
}

}  // namespace

bool PathMaker::may_run(const PathRecord& a, PathRecord& b) {
    if (!(run_tolerance(a, *limits_, smoothing_) > 0) || ((a.flags | b.flags) & kNoRun) != 0)
        return false;
    if (static_cast<RecordKind>(a.kind) != RecordKind::Line ||
        static_cast<RecordKind>(b.kind) != RecordKind::Line)
        return false;
    if (linear_metric(a, *limits_) != linear_metric(b, *limits_)) return false;
    if (chain_.size() == 1 ? !agree_on_axes(chain_.back().move, b)
                           : !agree_on_axes(scratch_ = a, b))
        return false;
    // the run has its axes already
    if (chain_.size() > 1 && scratch_.axis_count != a.axis_count) return false;
    return is_short_corner(a, b, chain_.size() == 1, *limits_, smoothing_);
}

// Both get the axes of both in the order of the earlier one: a line that leaves an axis where it is
// still has its place on the curve. False when those are too many.
bool PathMaker::agree_on_axes(PathRecord& a, PathRecord& b) const {
    PathRecord whole = b;
    const auto find = [](const PathRecord& r, std::uint8_t axis) {
        std::size_t i = 0;
        while (i < r.axis_count && r.axis[i] != axis) ++i;
        return i;
    };
    std::size_t count = a.axis_count;
    for (std::size_t i = 0; i < b.axis_count; ++i) count += find(a, b.axis[i]) == a.axis_count;
    if (count > kMaxCurveAxes) return false;
    for (std::size_t i = 0; i < b.axis_count; ++i)
        if (find(a, b.axis[i]) == a.axis_count) {
            a.axis[a.axis_count] = b.axis[i];
            a.start[a.axis_count] = a.end[a.axis_count] = b.start[i];
            a.nose[a.axis_count] = nose_of(a, b.axis[i]);
            ++a.axis_count;
        }
    for (std::size_t i = 0; i < a.axis_count; ++i) {
        const std::size_t from = find(b, a.axis[i]);
        whole.axis[i] = a.axis[i];
        whole.start[i] = from < b.axis_count ? b.start[from] : a.end[i];
        whole.end[i] = from < b.axis_count ? b.end[from] : a.end[i];
        whole.nose[i] = from < b.axis_count ? b.nose[from] : a.nose[i];
    }
    whole.axis_count = a.axis_count;
    b = whole;
    return true;
}

// A line has been added to the chain: its corner with the one before belongs to the curve.
void PathMaker::run_on() {
    if (chain_.size() < 3) return;  // two corners at least, otherwise a blend does
    if (!running_) begin_run();
    spline_.add_vertex(
        point_at(chain_[chain_.size() - 2].move, chain_[chain_.size() - 2].move.length));
    put_run();
}

void PathMaker::begin_run() {
    Kept& first = chain_.front();
    const double share = outer_share(first.move, chain_[1].move);
    std::array<bool, kMaxCurveAxes> measured{};
    const bool linear = linear_metric(first.move, *limits_);
    for (std::size_t k = 0; k < first.move.axis_count; ++k)
        measured[k] = limits_->axis[first.move.axis[k]].rotary != linear;
    spline_.begin(point_at(first.move, first.move.length - share), first.move.axis_count, measured,
                  run_tolerance(first.move, *limits_, smoothing_));
    spline_.add_vertex(point_at(first.move, first.move.length));
    put_part(first, first.move.length - share, false, false);
    run_number_ = first.number;
    running_ = true;
}

void PathMaker::end_run() {
    Kept& last = chain_.back();
    const double share =
        outer_share(last.move, chain_.size() > 1 ? chain_[chain_.size() - 2].move : last.move);
    spline_.end(point_at(last.move, share));
    put_run();
    last.from = share;
    while (chain_.size() > 1) chain_.pop_front();
    running_ = false;
}

void PathMaker::put_run() {
    for (const SplineRun::Piece& piece : spline_.ready()) {
        const std::uint64_t number = run_number_ + piece.line;
        while (chain_.front().number < number) chain_.pop_front();
        Kept& of = chain_.front();
        PathRecord& r = out_->claim();
        r = of.move;
        if (!of.begun) r.flags |= begin_flag(r);
        of.begun = true;
        if (piece.last_of_line) r.flags |= end_flag(r);
        r.kind = static_cast<std::uint8_t>(RecordKind::Curve);
        r.length = piece.curve.length;
        r.shape = {};
        for (std::size_t k = 0; k < r.axis_count; ++k) {
            for (std::size_t c = 0; c < 6; ++c) r.shape[6 * k + c] = piece.curve.position[k][c];
            r.start[k] = piece.curve.position[k][0];
            r.end[k] = at(piece.curve.position[k], 1);
        }
        for (std::size_t c = 0; c < 6; ++c)
            r.shape[curve_shape::kParameter + c] = piece.curve.parameter[c];
        RecordLimits record_limits = record_limits_of(r, *limits_);
        apply_turn_rules(r, piece.turn, *limits_, record_limits);
        store(record_limits, r);
        out_->commit();
        if (piece.last_of_line) put_between(number);
    }
    spline_.ready().clear();
}

}  // namespace polyturn::channels
