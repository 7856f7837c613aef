#include "channels/corners/corner_stage.hpp"

#include "channels/angles.hpp"
#include "channels/compensation/left_block.hpp"

namespace polyturn::channels::corners {
namespace {

constexpr double kStands = 1e-7;  // mm: nothing is left of a move
constexpr double kSame = 1e-9;    // as Core compares it

// Axes outside the plane keep their share of the travel: `share` of it from the start is kept, or
// comes first and is left out.
void keep_share(Move& m, double share, bool first, unsigned p, unsigned q) {
    for (unsigned i = 0; i < m.machine.size(); ++i) {
        if (i == p || i == q || !(m.moved >> i & 1u)) continue;
        const double way = m.machine[i] - m.machine_start[i];
        if (first) {
            m.machine[i] -= way * (1 - share);
            m.pos[i] -= way * (1 - share);
        } else
            m.machine_start[i] += way * (1 - share);
    }
}

void retell(Move& m, double share, unsigned p, unsigned q) {
    if (!is_arc(m)) {
        m.moved &= ~(1u << p | 1u << q);
        if (std::fabs(m.machine[p] - m.machine_start[p]) > kSame) m.moved |= 1u << p;
        if (std::fabs(m.machine[q] - m.machine_start[q]) > kSame) m.moved |= 1u << q;
        return;
    }
    m.sweep *= share;
    m.turns = static_cast<std::int32_t>(std::fabs(m.sweep) / kTurn);
    m.radius = std::hypot(m.machine_start[p] - m.centre_p, m.machine_start[q] - m.centre_q);
    m.radius_end = std::hypot(m.machine[p] - m.centre_p, m.machine[q] - m.centre_q);
}

void end_at(Move& m, Vec point, double share, unsigned p, unsigned q) {
    m.pos[p] += point.p - m.machine[p];
    m.pos[q] += point.q - m.machine[q];
    m.machine[p] = point.p;
    m.machine[q] = point.q;
    keep_share(m, share, true, p, q);
    if (m.feed_mode == FeedMode::InverseTime && share > 0) m.feed /= share;  // the same speed
    retell(m, share, p, q);
}

void start_at(Move& m, Vec point, double share, unsigned p, unsigned q) {
    m.machine_start[p] = point.p;
    m.machine_start[q] = point.q;
    keep_share(m, share, false, p, q);
    if (m.feed_mode == FeedMode::InverseTime && share > 0) m.feed /= share;
    retell(m, share, p, q);
}

bool compensated(const BlockContext& at, bool held) { return held && at.comp != CompSide::Off; }

}  // namespace

bool CornerStage::on_contour(const Move& m) const {
    const AxisSet plane = 1u << p_ | 1u << q_;
    if (m.through) return false;
    if (is_arc(m)) return m.plane_p == p_ && m.plane_q == q_ && !(m.moved & geometry_ & ~plane);
    if ((m.kind != MoveKind::Linear && m.kind != MoveKind::Rapid) || m.plane_p != p_ ||
        m.plane_q != q_)
        return false;
    return (m.moved & plane) && !(m.moved & geometry_ & ~plane);
}

Element CornerStage::element_of(const Move& m) const {
    const Vec start{m.machine_start[p_], m.machine_start[q_]}, end{m.machine[p_], m.machine[q_]};
    return is_arc(m) ? compensation::arc(start, end, {m.centre_p, m.centre_q}, m.sweep)
                     : compensation::line(start, end);
}

void CornerStage::move(const Move& m, const BlockContext& at) {
    if (failed_) return;
    // no move of the path
    if (m.beside) return holding_ ? waiting_.move(m, at) : down_->move(m, at);
    if (lose()) return;
    moved_ = true;
    if (holding_ && !reserved_) {
        if (on_contour(m)) {
            join(m, at);
            return;
        }
        if (held_.call.required) {
            fail(Alarm::CornerWithoutNext);
            return;
        }
        flush();
    }
    take(m, at);
}

// m is complete at its start; it is held if it has an element at its end.
void CornerStage::take(const Move& m, const BlockContext& at) {
    if (reserved_) {
        waiting_.move(m, at);
        return;
    }
    const bool corner = wanted_ && want_.size > 0 && on_contour(m);
    wanted_ = false;
    if (!corner) {
        down_->move(m, at);
        return;
    }
    held_ = {m, at, want_};
    holding_ = true;
    idle_ = 0;
}

void CornerStage::join(Move b, const BlockContext& at) {
    const Element first = element_of(held_.move), second = element_of(b);
    const Call call = held_.call;
    const bool both_rapid = held_.move.kind == MoveKind::Rapid && b.kind == MoveKind::Rapid;
    Corner corner;
    Fit fit = both_rapid && call.shape == Shape::Rounding ? Fit::Smooth  // rapid knows no arcs
              : call.reduce ? make_largest_corner(first, second, call.shape, call.size, corner)
                            : make_corner(first, second, call.shape, call.size, corner);
    if (fit == Fit::NotStraight || (call.straight && (is_arc(held_.move) || is_arc(b)))) {
        fail(Alarm::FagorTangential);
        return;
    }
    const bool cusp = fit == Fit::Smooth && call.letter != 0 && !both_rapid &&
                      compensation::dot(first.end_dir, second.start_dir) < 0;
    // straight back where a word of this block asks for the element
    if ((fit == Fit::TooLarge && !call.reduce) || cusp) {
        fail(Alarm::CornerTooLarge);
        return;
    }
    if (fit != Fit::Made) {
        flush();
        take(b, at);
        return;
    }
    const double whole_a = path_length(first), whole_b = path_length(second);
    Move a = held_.move;
    const BlockContext at_a = held_.at;
    end_at(a, corner.from, std::fmax(0.0, 1 - corner.cut_a / whole_a), p_, q_);
    start_at(b, corner.to, std::fmax(0.0, 1 - corner.cut_b / whole_b), p_, q_);
    const bool rapid_b = b.kind == MoveKind::Rapid, rapid_a = a.kind == MoveKind::Rapid;
    // An arc is not made in rapid: then the other block's feed holds.
    const bool from_b = corner.arc && (rapid_a || rapid_b) ? rapid_a : call.from_next;
    Move element = element_between(a, b, corner, from_b ? b : a);
    if (element.feed_mode == FeedMode::InverseTime) {
        const double model = from_b ? whole_b - corner.cut_b : whole_a - corner.cut_a;
        const double way = corner.arc ? std::fabs(corner.sweep) * element.radius
                                      : compensation::length(corner.to - corner.from);
        element.feed *= model / way;
    }
    const double said = call.from_next ? next_feed_ : call.feed;
    const double own = said > 0 ? said : call.block_feed;
    if (own > 0 && element.kind != MoveKind::Rapid) element.feed = own;
    holding_ = false;
    if (whole_a - corner.cut_a > kStands) down_->move(a, at_a);
    if (!call.from_next) down_->move(element, at_a);
    pass_waiting();
    if (call.from_next) down_->move(element, at);
    if (whole_b - corner.cut_b > kStands) take(b, at);
}

Move CornerStage::element_between(const Move& a, const Move& b, const Corner& corner,
                                  const Move& model) const {
    Move m = model;
    m.kind = corner.arc ? (corner.sweep > 0 ? MoveKind::ArcCcw : MoveKind::ArcCw)
             : model.kind == MoveKind::Rapid ? MoveKind::Rapid
                                             : MoveKind::Linear;
    m.machine_start = a.machine;
    m.machine = b.machine_start;
    m.pos = a.pos;
    for (unsigned i = 0; i < m.pos.size(); ++i) m.pos[i] += m.machine[i] - m.machine_start[i];
    m.sweep = corner.sweep;
    m.turns = 0;
    m.plane_p = static_cast<std::uint8_t>(p_);
    m.plane_q = static_cast<std::uint8_t>(q_);
    m.centre_p = corner.centre.p;
    m.centre_q = corner.centre.q;
    m.pos_centre_p = corner.centre.p + m.pos[p_] - m.machine[p_];
    m.pos_centre_q = corner.centre.q + m.pos[q_] - m.machine[q_];
    m.radius = compensation::length(corner.from - corner.centre);
    m.radius_end = compensation::length(corner.to - corner.centre);
    m.moved = corner.arc ? 1u << p_ | 1u << q_ : 0u;
    for (unsigned i = 0; i < m.machine.size(); ++i)
        if (std::fabs(m.machine[i] - m.machine_start[i]) > kSame) m.moved |= 1u << i;
    return m;
}

void CornerStage::pass_waiting() {
    compensation::HeldCalls calls;
    calls.append(waiting_);
    while (!calls.empty()) calls.pass_on(*down_);
}

// The move whose end the next line had to define is never made.
bool CornerStage::lose() {
    if (!reserved_ || lost_ == Alarm{}) return false;
    held_.at = lost_at_;
    held_.call.letter = 'A';
    fail(lost_);
    return true;
}

void CornerStage::flush() {
    if (!holding_ || failed_ || lose()) return;
    holding_ = false;
    if (!reserved_ || kept_) down_->move(held_.move, held_.at);
    if (kept_) {
        compensation::HeldCalls rest;
        rest.append(earlier_);
        rest.append(waiting_);
        waiting_.append(rest);
    }
    reserved_ = kept_ = false;
    pass_waiting();
}

void CornerStage::cut_off() {
    if (holding_ && !reserved_ && held_.call.required)
        fail(Alarm::CornerWithoutNext);
    else
        flush();
}

void CornerStage::block_done() {
    if (holding_ && !reserved_ && !moved_ && ++idle_ > held_.call.idle_blocks) {
        if (held_.call.required)
            fail(Alarm::CornerWithoutNext);
        else
            flush();
    }
    moved_ = false;
}

void CornerStage::stop(const Stop& s, const BlockContext& at) {
    if (s.reason == StopReason::M00 || s.reason == StopReason::M01) {
        if (holding_)
            waiting_.stop(s, at);
        else
            down_->stop(s, at);
        return;
    }
    if (holding_ && !reserved_ && held_.call.required) {
        fail(Alarm::CornerWithoutNext);
        return;
    }
    flush();
    // the end that comes instead of the next line: its alarm, not the end
    if (!failed_) down_->stop(s, at);
}

void CornerStage::barrier(const BlockContext& at) {
    flush();
    down_->barrier(at);
}

// Behind an error nothing is known of the next move: the held one is not begun, as with
// compensation. That one is shown it, so that the block before ends where it would have, and is
// driven.
void CornerStage::alarm(const Diagnosis& diagnosis, const BlockContext& at) {
    if (diagnosis.severity() == Severity::Error) {
        if (compensated(held_.at, holding_ && !reserved_) &&
            !compensation::leaves_held_block(diagnosis.alarm))
            down_->move(held_.move, held_.at);
        failed_ = true;
        holding_ = false;
        waiting_.clear();
        earlier_.clear();
    }
    down_->alarm(diagnosis, at);
}

void CornerStage::fail(Alarm alarm) {
    if (compensated(held_.at, holding_ && !reserved_)) down_->move(held_.move, held_.at);
    alarm_ = alarm;
    failed_ = true;
    holding_ = false;
    waiting_.clear();
    earlier_.clear();
}

}  // namespace polyturn::channels::corners
