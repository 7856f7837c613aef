#include "channels/path/blend.hpp"

#include <algorithm>

#include "channels/path/quintic.hpp"

namespace polyturn::channels {
namespace {

using Values = std::array<double, kMaxCurveAxes>;
struct State {
    Values p{}, t{}, k{};  // position, tangent, curvature (derivatives over s)
};

// The axes of both records, and which of them are measured in s.
struct Frame {
    std::uint8_t count = 0;
    std::array<std::uint8_t, kMaxCurveAxes> axis{};
    std::array<bool, kMaxCurveAxes> measured{};
    // -1: that record does not move it
    std::array<std::int8_t, kMaxCurveAxes> slot_before{}, slot_after{};
};

bool make_frame(const PathRecord& before, const PathRecord& after, bool linear,
                const PathLimits& limits, Frame& frame) {
    for (std::size_t i = 0; i < before.axis_count; ++i) {
        if (frame.count == kMaxCurveAxes) return false;
        frame.axis[frame.count] = before.axis[i];
        frame.slot_before[frame.count] = static_cast<std::int8_t>(i);
        frame.slot_after[frame.count++] = -1;
    }
    for (std::size_t i = 0; i < after.axis_count; ++i) {
        std::size_t k = 0;
        while (k < frame.count && frame.axis[k] != after.axis[i]) ++k;
        if (k == frame.count) {
            if (frame.count == kMaxCurveAxes) return false;
            frame.axis[k] = after.axis[i];
            frame.slot_before[k] = -1;
            ++frame.count;
        }
        frame.slot_after[k] = static_cast<std::int8_t>(i);
    }
    for (std::size_t k = 0; k < frame.count; ++k)
        frame.measured[k] = limits.axis[frame.axis[k]].rotary != linear;
    return true;
}

State state_of(const PathRecord& r, double s, const Frame& frame, bool after,
               const PathRecord& other) {
    SlotVector position;
    PathDerivatives d;
    position_at(r, s, position);
    derivatives_at(r, s, d);
    State state;
    for (std::size_t k = 0; k < frame.count; ++k) {
        const int slot = after ? frame.slot_after[k] : frame.slot_before[k];
        if (slot < 0) {  // this record leaves the axis where the other one has it at the corner
            state.p[k] = after ? other.end[static_cast<std::size_t>(frame.slot_before[k])]
                               : other.start[static_cast<std::size_t>(frame.slot_after[k])];
            continue;
        }
        const auto i = static_cast<std::size_t>(slot);
        state.p[k] = position[i];
        state.t[k] = d.first[i];
        state.k[k] = d.second[i];
    }
    return state;
}

double dot(const Frame& f, const Values& a, const Values& b) {
    double sum = 0;
    for (std::size_t k = 0; k < f.count; ++k)
        if (f.measured[k]) sum += a[k] * b[k];
    return sum;
}
double norm(const Frame& f, const Values& a) { return std::sqrt(dot(f, a, a)); }

// Terms of the series (1), and the size below which another one changes no digit.
constexpr int kSeriesTerms = 12;
constexpr double kSeriesEnd = 1e-17;
// 1/mm and of a unit tangent: two sides that differ by less are the same.
constexpr double kSameBend = 1e-9, kSameTangent = 1e-9;
// rad: below, the values of the limit T -> 0 hold to 1e-9.
constexpr double kSmallTurn = 1e-4;

// A quintic over u in 0..1 in its middle, as the combination of position p, dp/du and d2p/du2 at
// the ends 0 and 1:
//     p    = (p0 + p1)/2 + 5/32 (p0' - p1') + (p0" + p1")/64
//     p'   = 15/8 (p1 - p0) - 7/16 (p0' + p1') + (p1" - p0")/32
//     p"   = 3/2 (p1' - p0') - (p0" + p1")/4
constexpr double kMiddleTangents = 5.0 / 32, kMiddleBends = 64;  // divided by the latter
constexpr double kSlopeEnds = 1.875, kSlopeTangents = 0.4375, kSlopeBends = 32;
constexpr double kBendTangents = 1.5, kBendBends = 0.25;

// Of the tolerance: the first trial stays below it, for a quintic is not quite the clothoid.
constexpr double kFirstTrial = 0.98;
// A change of curvature k within a trim d leads 0.006 k d^2 away, as chosen for the first trial.
constexpr double kBendDeviation = 0.006;
// Another trial aims at this much of the tolerance, ...
constexpr double kNextTrial = 0.95;
// ... changes the trim by no less and no more than this, for it goes with a power between 1 and 2
// ...
constexpr double kTrialLeast = 0.3, kTrialMost = 0.95;
constexpr int kTrials = 6;  // ... and so often.
// A longer trim is worth nothing where the axes could go on faster: of their acceleration and jerk
// the part that a blend is given, the factor of its steepest place (see the header's weakness), and
// mm: not shorter than this many of the shortest.
constexpr double kBlendShare = 0.15, kSteepest = 2.25, kCurvedShare = 1.6;
constexpr double kUsefulShortest = 100;

// Series (1) of the header.
struct Clothoid {
    double trim, deviation;  // for halves of length 1
};
Clothoid clothoid(double turn) {
    const double h = 0.5 * turn, h2 = h * h;
    double x = 0, y = 0, term = 1;  // term: (-h2)^n / (2n)!
    for (int n = 0; n < kSeriesTerms && std::abs(term) > kSeriesEnd; ++n) {
        x += term / (4 * n + 1);
        y += term * h / ((2 * n + 1) * (4.0 * n + 3));
        term *= -h2 / ((2.0 * n + 1) * (2 * n + 2));
    }
    return {x + y * std::tan(h), y / std::cos(h)};
}

// What the corner alone decides.
struct Corner {
    State before, after;  // at the corner itself
    Values turn{};        // after.t - before.t
    double angle = 0;
    double trim_ratio = 1;          // trim / half length
    double offset_ratio = 1.0 / 6;  // deviation / (half length |turn|)
    double bend_ratio = 1;          // curvature in the middle * half length / |turn|
};

// Halves of the blend with this trim as quintics over u in 0..1.
struct Halves {
    std::array<Quintic, kMaxCurveAxes> first{}, second{};
};
Halves build(const PathRecord& a, const PathRecord& b, const Frame& f, const Corner& c,
             double trim) {
    const State begin = state_of(a, a.length - trim, f, false, b),
                end = state_of(b, trim, f, true, a);
    const double l = trim / c.trim_ratio, whole = 2 * l;
    State middle;
    for (std::size_t k = 0; k < f.count; ++k) {
        // What the neighbours' curvature adds to the straight ones: offsets e, tangent changes g.
        const double e0 = begin.p[k] - (c.before.p[k] - trim * c.before.t[k]),
                     e1 = end.p[k] - (c.before.p[k] + trim * c.after.t[k]);
        const double g0 = begin.t[k] - c.before.t[k], g1 = end.t[k] - c.after.t[k];
        middle.p[k] = c.before.p[k] + l * c.offset_ratio * c.turn[k] + 0.5 * (e0 + e1) +
                      kMiddleTangents * whole * (g0 - g1) +
                      whole * whole / kMiddleBends * (begin.k[k] + end.k[k]);
        middle.t[k] = 0.5 * (c.before.t[k] + c.after.t[k]) * c.trim_ratio +
                      kSlopeEnds * (e1 - e0) / whole - kSlopeTangents * (g0 + g1) +
                      whole / kSlopeBends * (end.k[k] - begin.k[k]);
        middle.k[k] = c.bend_ratio * c.turn[k] / l + kBendTangents * (g1 - g0) / whole -
                      kBendBends * (begin.k[k] + end.k[k]);
    }
    // Unit speed in the middle, curvature across it.
    const double speed = norm(f, middle.t);
    for (std::size_t k = 0; k < f.count; ++k)
        if (f.measured[k]) middle.t[k] /= speed;
    const double along = dot(f, middle.t, middle.k);
    for (std::size_t k = 0; k < f.count; ++k)
        if (f.measured[k]) middle.k[k] -= along * middle.t[k];
    Halves halves;
    for (std::size_t k = 0; k < f.count; ++k) {
        const QuinticEnd left{begin.p[k], l * begin.t[k], l * l * begin.k[k]},
            right{end.p[k], l * end.t[k], l * l * end.k[k]};
        const QuinticEnd centre{middle.p[k], l * middle.t[k], l * l * middle.k[k]};
        halves.first[k] = hermite(left, centre);
        halves.second[k] = hermite(centre, right);
    }
    return halves;
}

// Largest distance from the programmed path at the same distance from the corner; rotary axes count
// degrees by themselves.
double deviation(const PathRecord& a, const PathRecord& b, const Frame& f, const Halves& halves,
                 double trim) {
    double worst = 0;
    const auto look = [&](const Quintic* q, double u, const PathRecord& r, double s, bool after) {
        const State programmed = state_of(r, s, f, after, after ? a : b);
        Values apart{};
        for (std::size_t k = 0; k < f.count; ++k) {
            apart[k] = at(q[k], u) - programmed.p[k];
            if (!f.measured[k]) worst = std::max(worst, std::abs(apart[k]));
        }
        worst = std::max(worst, norm(f, apart));
    };
    for (double u : {0.2, 0.4, 0.6, 0.8, 1.0})  // the middle of the blend is the first half's
        look(halves.first.data(), u, a, a.length - trim + u * trim, false);
    for (double u : {0.2, 0.4, 0.6, 0.8}) look(halves.second.data(), u, b, u * trim, true);
    return worst;
}

// One half as 1, 2 or 4 pieces.
bool add_half(const Frame& f, const std::array<Quintic, kMaxCurveAxes>& half, Blend& blend) {
    for (std::size_t parts = 1; parts <= kMostPieces / 2; parts *= 2) {
        bool good = true;
        for (std::size_t n = 0; n < parts && good; ++n) {
            BlendPiece& piece = blend.piece[blend.count + n];
            const double width = 1.0 / static_cast<double>(parts);
            for (std::size_t k = 0; k < f.count; ++k)
                piece.position[k] =
                    parts == 1 ? half[k] : part_of(half[k], width * static_cast<double>(n), width);
            good = fit_parameter(f.count, f.measured, piece);
        }
        if (good) {
            blend.count += parts;
            return true;
        }
    }
    return false;
}

// Trim beyond which the axes' limits are no longer what bounds `speed` at the corner (shares of
// blend.hpp's limits).
double useful_trim(const Frame& f, const Corner& c, double speed, const PathLimits& limits) {
    double trim = 0;
    const double v2 = speed * speed, v3 = v2 * speed;
    for (std::size_t k = 0; k < f.count; ++k) {
        const PathAxis& axis = limits.axis[f.axis[k]];
        const double turn = std::abs(c.turn[k]), bend = std::abs(c.after.k[k] - c.before.k[k]);
        trim = std::max({trim, turn * v2 / (kBlendShare * axis.accel),
                         std::sqrt(turn * v3 / (kBlendShare * axis.jerk)),
                         kSteepest * bend * v3 / (kCurvedShare * axis.jerk)});
    }
    return trim * c.trim_ratio;
}

}  // namespace

bool linear_metric(const PathRecord& r, const PathLimits& limits) {
    for (std::size_t i = 0; i < r.axis_count; ++i)
        if (!limits.axis[r.axis[i]].rotary &&
            (r.start[i] != r.end[i] || static_cast<RecordKind>(r.kind) != RecordKind::Line))
            return true;
    return false;
}

Junction make_blend(const PathRecord& a, double room_before, const PathRecord& b, double room_after,
                    double speed, const PathLimits& limits, Blend& blend) {
    const bool linear = linear_metric(a, limits);
    Frame f;
    if (linear != linear_metric(b, limits) || !make_frame(a, b, linear, limits, f))
        return Junction::Stop;
    Corner c;
    c.before = state_of(a, a.length, f, false, b);
    c.after = state_of(b, 0, f, true, a);
    double step = 0, bend = 0, side_step = 0;
    bool jerk_limited = false;
    for (std::size_t k = 0; k < f.count; ++k) {
        c.turn[k] = c.after.t[k] - c.before.t[k];
        const double change = std::abs(c.turn[k]), curve = std::abs(c.after.k[k] - c.before.k[k]);
        step = std::max(step, change);
        if (!f.measured[k]) side_step = std::max(side_step, change);
        bend = std::max(bend, curve);
        if (curve > kSameBend && std::isfinite(limits.axis[f.axis[k]].jerk)) jerk_limited = true;
    }
    const bool straight = step < kSameTangent;
    if (straight && !jerk_limited) return Junction::Smooth;
    if (!(limits.tolerance > 0)) return Junction::Stop;

    const double size = norm(f, c.turn);
    c.angle = 2 * std::asin(std::min(1.0, 0.5 * size));
    if (c.angle > kSharpestTurn) return Junction::Stop;
    if (c.angle > kSmallTurn) {
        const Clothoid unit = clothoid(c.angle);
        c.trim_ratio = unit.trim;
        c.offset_ratio = unit.deviation / size;
        c.bend_ratio = c.angle / size;
    }

    // The longest trim within tolerance and the space there is.
    const double tolerance = kFirstTrial * limits.tolerance;
    double trim = std::min(room_before, room_after);
    const double apart = std::max(size, side_step) * c.offset_ratio / c.trim_ratio;
    if (apart > 0) trim = std::min(trim, tolerance / apart);
    if (bend > 0) trim = std::min(trim, std::sqrt(tolerance / (kBendDeviation * bend)));
    trim =
        std::min(trim, std::max(useful_trim(f, c, speed, limits), kUsefulShortest * kShortestTrim));
    const bool lines = static_cast<RecordKind>(a.kind) == RecordKind::Line &&
                       static_cast<RecordKind>(b.kind) == RecordKind::Line;
    Halves halves;
    for (int trial = 0;; ++trial) {
        if (trim < kShortestTrim) return Junction::Stop;
        halves = build(a, b, f, c, trim);
        if (lines) break;
        const double off = deviation(a, b, f, halves, trim);
        blend.count = 0;
        if (off <= limits.tolerance) break;
        if (trial == kTrials) return Junction::Stop;
        trim *= std::clamp(kNextTrial * limits.tolerance / off, kTrialLeast, kTrialMost);
    }
    blend.count = 0;
    if (!add_half(f, halves.first, blend)) return Junction::Stop;
    blend.first_half = blend.count;
    if (!add_half(f, halves.second, blend)) return Junction::Stop;
    blend.axis_count = f.count;
    blend.axis = f.axis;
    blend.trim = trim;
    blend.angle = c.angle;
    blend.sides = {};
    blend.sides.count = f.count;
    blend.sides.arc = !lines;
    for (std::size_t k = 0; k < f.count; ++k) {
        blend.sides.axis[k] = f.axis[k];
        blend.sides.before[k] = c.before.t[k];
        blend.sides.after[k] = c.after.t[k];
        blend.sides.bend_before[k] = c.before.k[k];
        blend.sides.bend_after[k] = c.after.k[k];
    }
    return Junction::Blended;
}

}  // namespace polyturn::channels
