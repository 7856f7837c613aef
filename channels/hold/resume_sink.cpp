#include "channels/hold/resume_sink.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "channels/hold/approach.hpp"

namespace polyturn::channels {
namespace {

constexpr double kSamePlace = 1e-6;  // mm, degrees

bool has_way(const Move& move) {
    return (move.kind == MoveKind::ArcCw || move.kind == MoveKind::ArcCcw) && move.sweep != 0;
}
bool is_cut(const Move& move) { return move.kind == MoveKind::Linear && move.tap_turns == 0; }

bool same(const MachineView& view, const AxisValues& a, const AxisValues& b) {
    for (unsigned i = 0; i < view.axis_count; ++i)
        if (std::fabs(a[i] - b[i]) > kSamePlace) return false;
    return true;
}

// The share of the move at its point nearest to `here`; linear axes count, rotary ones where they
// move alone.
double share_of_line(const MachineView& view, const Move& move, const AxisValues& here) {
    for (const bool rotary : {false, true}) {
        double along = 0, square = 0;
        for (unsigned i = 0; i < view.axis_count; ++i) {
            if (view.axes[i].rotary != rotary) continue;
            const double way = move.machine[i] - move.machine_start[i];
            along += way * (here[i] - move.machine_start[i]);
            square += way * way;
        }
        if (square > kSamePlace * kSamePlace) return std::clamp(along / square, 0.0, 1.0);
    }
    return 0.0;
}

// What is left of a curve behind its point nearest to `here`.
void leave_out_passed(const MachineView& view, Move& curve, const AxisValues& here) {
    const std::vector<AxisValues>& inner = *curve.through;
    Move piece = curve;
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t first = 0;
    AxisValues start = curve.machine_start;
    for (std::size_t k = 0; k <= inner.size(); ++k) {
        piece.machine_start = k > 0 ? inner[k - 1] : curve.machine_start;
        piece.machine = k < inner.size() ? inner[k] : curve.machine;
        const double share = share_of_line(view, piece, here);
        double distance = 0;
        AxisValues foot = piece.machine_start;
        for (unsigned i = 0; i < view.axis_count; ++i) {
            foot[i] += (piece.machine[i] - piece.machine_start[i]) * share;
            distance += (here[i] - foot[i]) * (here[i] - foot[i]);
        }
        if (distance < nearest) {
            nearest = distance;
            first = k;
            start = foot;
        }
    }
    curve.through = std::make_shared<std::vector<AxisValues>>(
        inner.begin() + static_cast<std::ptrdiff_t>(first), inner.end());
    curve.machine_start = start;
}

double share_of_arc(const Move& move, const AxisValues& here) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const auto angle = [&](const AxisValues& v) {
        return std::atan2(v[move.plane_q] - move.centre_q, v[move.plane_p] - move.centre_p);
    };
    double way = std::fmod(angle(here) - angle(move.machine_start), kTurn);
    if (way * move.sweep < 0) way += std::copysign(kTurn, move.sweep);
    if (std::fabs(way) > std::fabs(move.sweep))
        return kTurn - std::fabs(way) < std::fabs(way) - std::fabs(move.sweep) ? 0.0 : 1.0;
    return way / move.sweep;
}

}  // namespace

void ResumeSink::go_back(std::uint64_t serial, std::uint32_t part, bool begun,
                         const AxisValues& here, const AxisValues& left_at) {
    serial_ = 0;
    skip_serial_ = serial;
    skip_part_ = part;
    begun_ = begun;
    entering_ = true;
    here_ = here;
    left_at_ = left_at;
}

bool ResumeSink::counts(const BlockContext& at) {
    if (at.serial != serial_) {
        serial_ = at.serial;
        part_ = 0;
    }
    at_ = at;
    at_.part = ++part_;
    return at.serial != skip_serial_ || part_ >= skip_part_;
}

// A zero change that G96 gets belongs to no block: whether it comes depends on the
// values, not on the text.
void ResumeSink::spindle(const Spindle& s, const BlockContext& at) {
    if (!s.silent) return pass(at, [&](const BlockContext& c) { next_->spindle(s, c); });
    next_->spindle(s, at);
}

void ResumeSink::move(const Move& m, const BlockContext& at) {
    if (!counts(at)) return;
    if (m.beside) return next_->move(m, at_);
    if (entering_) {
        entering_ = false;
        begun_ = begun_ && at.serial == skip_serial_ && part_ == skip_part_;
        // moved away in the hold: back to where the program was left
        if (!same(*view_, here_, left_at_)) {
            AxisValues pos = m.pos;
            for (unsigned i = 0; i < view_->axis_count; ++i) pos[i] += left_at_[i] - m.machine[i];
            approach(*view_, here_, left_at_, pos, at_, *next_);
            here_ = left_at_;
        }
        return enter(m);
    }
    next_->move(m, at_);
}

// A straight line to a point of the move, at its feed.
void ResumeSink::step_to(const AxisValues& point, const Move& of) {
    if (same(*view_, here_, point)) return;
    Move step = of;
    step.kind = is_cut(of) || has_way(of) ? MoveKind::Linear : MoveKind::Rapid;
    if (step.kind == MoveKind::Rapid) {
        step.feed_mode = FeedMode::Rapid;
        step.feed = 0.0;
        step.exact_stop = true;
    }
    if (step.feed_mode == FeedMode::InverseTime) {
        step.feed_mode = FeedMode::PerMinute;
        step.feed = 0.0;
    }
    step.sweep = step.lead = step.tap_turns = 0.0;
    step.turns = 0;
    step.thread_chained = false;
    step.kinematics = nullptr;  // the axes as they are
    step.through = nullptr;
    step.machine_start = here_;
    step.machine = point;
    step.moved = 0;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        if (std::fabs(here_[i] - point[i]) > kSamePlace) step.moved |= 1u << i;
        step.pos[i] += point[i] - of.machine[i];
    }
    next_->move(step, at_);
    here_ = point;
}

void ResumeSink::enter(const Move& m) {
    Move rest = m;
    const bool skip =
        m.kind == MoveKind::Rapid || m.kind == MoveKind::Reference || m.kind == MoveKind::Skip;
    if (skip && !m.kinematics) {  // no path to keep: straight to its end
        rest.machine_start = here_;
        for (unsigned i = 0; i < view_->axis_count; ++i)
            if (std::fabs(here_[i] - m.machine[i]) > kSamePlace) rest.moved |= 1u << i;
        return next_->move(rest, at_);
    }
    if (m.kinematics) {  // its path is not that of the axes: whole, from its beginning
        step_to(m.machine_start, m);
        return next_->move(m, at_);
    }
    if (m.through) {
        if (begun_) leave_out_passed(*view_, rest, here_);
        step_to(rest.machine_start, m);
        if (rest.through->empty() && same(*view_, rest.machine_start, rest.machine)) return;
        return next_->move(rest, at_);
    }
    double share = 0.0;
    if (begun_ && is_cut(m)) share = share_of_line(*view_, m, here_);
    if (begun_ && has_way(m) && m.turns == 0) share = share_of_arc(m, here_);
    for (unsigned i = 0; i < view_->axis_count; ++i)
        rest.machine_start[i] += (m.machine[i] - m.machine_start[i]) * share;
    if (has_way(m) && share > 0) {
        const auto angle = std::atan2(m.machine_start[m.plane_q] - m.centre_q,
                                      m.machine_start[m.plane_p] - m.centre_p) +
                           m.sweep * share;
        const double radius = m.radius + (m.radius_end - m.radius) * share;
        rest.machine_start[m.plane_p] = m.centre_p + radius * std::cos(angle);
        rest.machine_start[m.plane_q] = m.centre_q + radius * std::sin(angle);
        rest.radius = radius;
        rest.sweep = m.sweep * (1.0 - share);
    }
    step_to(rest.machine_start, m);
    if (same(*view_, rest.machine_start, rest.machine) &&
        !(has_way(m) && std::fabs(rest.sweep) > 1e-9))
        return;
    rest.thread_chained = false;
    next_->move(rest, at_);
}

}  // namespace polyturn::channels
