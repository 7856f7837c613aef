#include "channels/path/spline_run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/path/quintic.hpp"

namespace polyturn::channels {

double run_tolerance(const PathRecord& line, const PathLimits& limits, const Smoothing& smoothing) {
    if (!smoothing.on) return limits.tolerance;
    double tolerance = smoothing.tolerance;
    for (std::size_t i = 0; smoothing.rotary > 0 && i < line.axis_count; ++i)
        if (limits.axis[line.axis[i]].rotary) tolerance = std::min(tolerance, smoothing.rotary);
    return tolerance;
}

bool is_short_corner(const PathRecord& a, const PathRecord& b, bool begins,
                     const PathLimits& limits, const Smoothing& smoothing) {
    if (static_cast<RecordKind>(a.kind) != RecordKind::Line ||
        static_cast<RecordKind>(b.kind) != RecordKind::Line)
        return false;
    if (a.axis_count != b.axis_count || a.axis_count > kMaxCurveAxes) return false;
    double step = 0;
    for (std::size_t i = 0; i < a.axis_count; ++i) {
        if (a.axis[i] != b.axis[i]) return false;
        const double d = (b.end[i] - b.start[i]) / b.length - (a.end[i] - a.start[i]) / a.length;
        step += d * d;
    }
    // rotary axes count as if degrees were millimetres: only ever too careful
    step = std::sqrt(step);
    constexpr double kStraightOn = 1e-9;  // of a unit tangent
    if (begins && step < kStraightOn) return false;
    if (step > 2 * std::sin(std::min(limits.square_turn, std::numbers::pi) / 2)) return false;
    const double shorter = std::min(a.length, b.length);
    const double longer = std::max(a.length, b.length);
    if (smoothing.on) {
        // rad: beyond it no curve within a tolerance is worth having
        constexpr double kSharpest = 1.0;
        const bool always = longer < smoothing.always_below;
        const double bend = shorter * step / 3;
        if (longer > smoothing.longest || shorter < smoothing.shortest || bend < smoothing.least)
            return false;
        if (step > (always ? kSharpest : std::min(kSharpest, 2 * std::sin(smoothing.turn / 2))))
            return false;
        return longer <= kMostGrowth * shorter &&
               bend <= kCornerShare * run_tolerance(a, limits, smoothing);
    }
    return longer <= kMostGrowth * shorter && shorter <= kLongestShort && step <= kMostTurn &&
           shorter * step / 3 <= kCornerShare * limits.tolerance;
}

double SplineRun::distance(const SplinePoint& a, const SplinePoint& b) const {
    double sum = 0;
    for (std::size_t k = 0; k < axes_; ++k)
        if (measured_[k]) sum += (b[k] - a[k]) * (b[k] - a[k]);
    return std::sqrt(sum);
}

// Change of the unit direction at b; the angle for small ones.
double SplineRun::turn_at(const SplinePoint& a, const SplinePoint& b, const SplinePoint& c) const {
    const double before = distance(a, b), behind = distance(b, c);
    double sum = 0;
    for (std::size_t k = 0; k < axes_; ++k) {
        const double d = (c[k] - b[k]) / behind - (b[k] - a[k]) / before;
        sum += d * d;
    }
    return std::sqrt(sum);
}

void SplineRun::begin(const SplinePoint& from, std::size_t axes,
                      const std::array<bool, kMaxCurveAxes>& measured, double tolerance) {
    axes_ = axes;
    measured_ = measured;
    tolerance_ = tolerance;
    path_.assign(1, from);
    dropped_ = 0;
    control_.clear();
    interval_.clear();
    next_span_ = 1;
    next_used_ = 2;
    ready_.clear();
}

void SplineRun::add_vertex(const SplinePoint& vertex) {
    path_.push_back(vertex);
    const std::size_t newest = dropped_ + path_.size() - 1;
    if (newest == 1) {  // the mirrored point, M, the first vertex
        SplinePoint mirror{};
        for (std::size_t k = 0; k < axes_; ++k) mirror[k] = 2 * path(0)[k] - vertex[k];
        control_ = {
            {mirror, 0, mirror, true}, {path(0), 0, path(0), true}, {vertex, 1, vertex, true}};
        interval_ = {distance(path(0), vertex), distance(path(0), vertex)};
        return;
    }
    if (!chord_fits(newest) && newest - 1 > control_.back().vertex) add_control(newest - 1);
}

bool SplineRun::chord_fits(std::size_t to) const {
    const Control& last = control_.back();
    const SplinePoint &a = last.point, &b = path(to);
    if (to - last.vertex > kMostSkipped) return false;
    const double before = interval_.back(), behind = distance(a, b);
    if (!(behind > 0) || behind > kMostGrowth * before) return false;
    const SplinePoint& p = control_[control_.size() - 2].point;
    if (turn_at(p, a, b) > kMostTurn) return false;
    // (2), the next one not known: as if the curve went straight on behind `to`.
    const SplinePoint earlier = beside(control_.size() - 2);
    const double sum = before + behind,
                 share_before = behind * behind / (sum * (interval_[interval_.size() - 2] + sum)),
                 share_behind = before * before / (sum * (sum + behind));
    double left = 0;
    for (std::size_t k = 0; k < axes_; ++k) {
        const double d =
            ((b[k] - a[k]) / behind - (a[k] - p[k]) / before) / sum * before * behind / 3;
        const double rest =
            last.fixed ? d : share_before * earlier[k] - (share_before + share_behind) * d;
        left += rest * rest;
    }
    if (left > kTurnShare * tolerance_ * kTurnShare * tolerance_) return false;
    return skips_well(last.vertex, to);
}

// The vertices between lie near the chord. The curve bulges as they do, but next to an end it
// cannot: so the chord counts.
bool SplineRun::skips_well(std::size_t from, std::size_t to) const {
    const SplinePoint &a = path(from), &b = path(to);
    const double most = kSkipShare * tolerance_;
    double length2 = 0;
    for (std::size_t k = 0; k < axes_; ++k) length2 += (b[k] - a[k]) * (b[k] - a[k]);
    for (std::size_t v = from + 1; v < to; ++v) {
        const SplinePoint& p = path(v);
        double f = 0, off2 = 0;
        for (std::size_t k = 0; k < axes_; ++k) f += (p[k] - a[k]) * (b[k] - a[k]) / length2;
        f = std::clamp(f, 0.0, 1.0);
        for (std::size_t k = 0; k < axes_; ++k) {
            const double d = p[k] - a[k] - f * (b[k] - a[k]);
            off2 += d * d;
        }
        if (off2 > most * most) return false;
    }
    return true;
}

// Second part of (1): a third of the parabola's bend times both intervals.
SplinePoint SplineRun::beside(std::size_t control) const {
    SplinePoint d{};
    if (control_[control].fixed || control == 0 || control + 1 >= control_.size()) return d;
    const double a = interval_[control - 1], b = interval_[control];
    for (std::size_t k = 0; k < axes_; ++k) {
        const double p = control_[control].point[k];
        d[k] =
            ((control_[control + 1].point[k] - p) / b - (p - control_[control - 1].point[k]) / a) /
            (a + b) * a * b / 3;
    }
    return d;
}

void SplineRun::place_used(std::size_t i) {
    Control& c = control_[i];
    // on the outer line, at most at its vertex: tangent and curvature at M come from these points
    // alone
    if (c.fixed) {
        const bool first = c.vertex == 1;
        const SplinePoint& end = control_[first ? i - 1 : i + 1].point;
        const double own = first ? interval_[i - 1] : interval_[i],
                     next = first ? interval(static_cast<std::ptrdiff_t>(i)) : interval_[i - 1];
        const double part = std::min(1.0, (2 * own + next) / (3 * own));
        for (std::size_t k = 0; k < axes_; ++k) c.used[k] = end[k] + part * (c.point[k] - end[k]);
        Control& mirror = control_[first ? i - 2 : i + 2];
        for (std::size_t k = 0; k < axes_; ++k) mirror.used[k] = 2 * end[k] - c.used[k];
        return;
    }
    const double a = interval_[i - 1], b = interval_[i];
    const SplinePoint d = beside(i);
    for (std::size_t k = 0; k < axes_; ++k) {
        const double before = (c.point[k] - control_[i - 1].point[k]) / a,
                     behind = (control_[i + 1].point[k] - c.point[k]) / b;
        c.used[k] = c.point[k] + (a * behind + b * before) / (a + b) * (b - a) / 3 - d[k];
    }
}

void SplineRun::add_control(std::size_t vertex) {
    interval_.push_back(distance(control_.back().point, path(vertex)));
    control_.push_back({path(vertex), vertex, path(vertex), false});
    make_spans(false);
}

void SplineRun::end(const SplinePoint& to) {
    const std::size_t last = dropped_ + path_.size() - 1;
    // Towards the end the intervals shrink as they grew at the beginning, as far as there are
    // vertices for it.
    std::vector<std::size_t> knots{last};
    double most = kMostGrowth * distance(path(last), to);
    while (knots.back() > control_.back().vertex + 1 &&
           distance(control_.back().point, path(knots.back())) > most) {
        std::size_t v = knots.back() - 1;
        while (v > control_.back().vertex + 1 && distance(path(v - 1), path(knots.back())) <= most)
            --v;
        most = kMostGrowth * distance(path(v), path(knots.back()));
        knots.push_back(v);
    }
    for (; !knots.empty(); knots.pop_back())
        if (knots.back() > control_.back().vertex) add_control(knots.back());
    control_.back().fixed = true;
    path_.push_back(to);
    interval_.push_back(distance(control_.back().point, to));
    control_.push_back({to, last + 1, to, true});
    SplinePoint mirror{};
    const SplinePoint before = control_[control_.size() - 2].point;
    for (std::size_t k = 0; k < axes_; ++k) mirror[k] = 2 * to[k] - before[k];
    interval_.push_back(interval_.back());
    control_.push_back({mirror, last + 1, mirror, true});
    make_spans(true);
}

// Beyond the mirrored points the intervals are mirrored too, so that the curve passes M and M' (see
// end of make_span).
double SplineRun::interval(std::ptrdiff_t i) const {
    const auto count = static_cast<std::ptrdiff_t>(interval_.size());
    if (i < 0) i = std::min<std::ptrdiff_t>(2, count - 1);
    if (i >= count) i = std::max<std::ptrdiff_t>(0, count - 3);
    return interval_[static_cast<std::size_t>(i)];
}

// How many spans are kept before what is behind is dropped: seldom, for it moves what remains.
static constexpr std::size_t kDropAt = 64;
// Halvings of a piece whose parameter does not fit: 32 pieces.
static constexpr int kDeepestCut = 5;

void SplineRun::make_spans(bool all) {
    const std::size_t known = control_.size();
    // when all are known: up to the last vertex
    for (; next_used_ + 2 < known; ++next_used_) place_used(next_used_);
    // a span is made of the controls from one before to two behind it, and the place of each of
    // those asks for its neighbours
    while (next_span_ + (all ? 2 : 4) < known) {
        make_span(next_span_, all && next_span_ + 3 == known);
        ++next_span_;
    }
    // Two controls before the next span are still needed, and no vertex before its own.
    if (next_span_ > kDropAt) {
        const std::size_t drop = next_span_ - 3;
        const std::size_t vertices = control_[next_span_ - 1].vertex - dropped_;
        control_.erase(control_.begin(), control_.begin() + static_cast<std::ptrdiff_t>(drop));
        interval_.erase(interval_.begin(), interval_.begin() + static_cast<std::ptrdiff_t>(drop));
        path_.erase(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(vertices));
        dropped_ += vertices;
        next_span_ -= drop;
        next_used_ -= drop;
    }
}

void SplineRun::make_span(std::size_t i, bool last_span) {
    const auto at_i = static_cast<std::ptrdiff_t>(i);
    const double z = interval(at_i - 2), a = interval(at_i - 1), b = interval(at_i),
                 c = interval(at_i + 1), e = interval(at_i + 2);
    const SplinePoint &p0 = control_[i - 1].used, &p1 = control_[i].used,
                      &p2 = control_[i + 1].used, &p3 = control_[i + 2].used;
    // The span of a cubic B-spline over the knot intervals z a b c e as a Bezier curve: b1, b2 lie
    // on the leg p1 p2 at its thirds by intervals, b0 and b3 where the legs before and behind join.
    Cubic cubic{};
    for (std::size_t k = 0; k < axes_; ++k) {
        const double b1 = ((b + c) * p1[k] + a * p2[k]) / (a + b + c),
                     b2 = (c * p1[k] + (a + b) * p2[k]) / (a + b + c);
        const double before = (b * p0[k] + (z + a) * p1[k]) / (z + a + b),
                     behind = ((c + e) * p2[k] + b * p3[k]) / (b + c + e);
        const double b0 = (b * before + a * b1) / (a + b), b3 = (c * b2 + b * behind) / (b + c);
        cubic[k] = {b0, 3 * (b1 - b0), 3 * (b0 - 2 * b1 + b2), b3 - 3 * b2 + 3 * b1 - b0, 0, 0};
    }
    // Cut where the path passes its vertices, in proportion to the lengths.
    const std::size_t from = control_[i].vertex, to = control_[i + 1].vertex;
    double total = 0;
    for (std::size_t v = from; v < to; ++v) total += distance(path(v), path(v + 1));
    double done = 0, u = 0;
    for (std::size_t v = from; v < to; ++v) {
        done += distance(path(v), path(v + 1));
        const double next = v + 1 == to ? 1.0 : done / total;
        Piece piece;
        piece.line = v;
        piece.last_of_line = !(last_span && v + 1 == to);
        piece.turn = v > dropped_ ? turn_at(path(v - 1), path(v), path(v + 1)) : 0;
        if (v + 2 < dropped_ + path_.size())
            piece.turn = std::max(piece.turn, turn_at(path(v), path(v + 1), path(v + 2)));
        add_piece(cubic, u, next, piece, 0);
        u = next;
    }
}

void SplineRun::add_piece(const Cubic& cubic, double from, double to, Piece piece, int depth) {
    for (std::size_t k = 0; k < axes_; ++k)
        piece.curve.position[k] = part_of(cubic[k], from, to - from);
    // The last cut is taken as it is: the axes' limits come from the true derivatives, only the
    // feed is off a little.
    if (fit_parameter(axes_, measured_, piece.curve) || depth == kDeepestCut) {
        ready_.push_back(piece);
        return;
    }
    const double middle = 0.5 * (from + to);
    Piece first = piece;
    first.last_of_line = false;
    add_piece(cubic, from, middle, first, depth + 1);
    add_piece(cubic, middle, to, piece, depth + 1);
}

}  // namespace polyturn::channels
