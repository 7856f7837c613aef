#include "kernel/motion/thread_follower.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kPole = 120;  // 1/s, of what is left to the line; see «Driving»
// of the limits for closing a gap; the rest follows the spindle's swings
constexpr double kShareA = 0.85, kShareJ = 0.8;
constexpr double kPlannedJerk = 0.98;  // the landing ends exactly with the rest
// of the limit of jerk that the controller takes; the rest is rounding of what drives it
constexpr double kControlJerk = 0.99;
constexpr double kDegrees = 360;  // a revolution
// The quintic of ClosingGap in a time T, its peaks:
//   from rest onto a line of speed v, over the travel v T/2:   a = 1.5 v/T,  j = 6 v/T^2
//   a jump of speed v without a gap of position:            a = 4 v/T,    j = 36 v/T^2
constexpr double kRunInA = 1.5, kRunInJ = 6, kJumpA = 4, kJumpJ = 36;
// of the change of speed that a tick at full acceleration makes: a smaller jump is left to the
// controller
constexpr double kJumpWorthClosing = 0.02;
// mm a revolution, mm/s, mm/s2, mm/s3: what a record may not go below, lest a quotient be infinite
constexpr double kLeastLead = 1e-9, kLeastLimit = 1e-6;
// without a jerk limit: all acceleration within a tick divided by this
constexpr double kJerkSteps = 100;
// a landing is no softer than the limit divided by this
constexpr double kSoftestLanding = 100;
}  // namespace

void ThreadFollower::clear(std::uint64_t first) noexcept {
    first_ = first;
    count_ = piece_ = line_piece_ = 0;
    length_ = 0;
    state_ = {};
    phase_ = ThreadPhase::Idle;
    gap_.clear();
    deviation_ = sum_ = 0;
    began_ = false;
}

bool ThreadFollower::append(const PathRecord& record) noexcept {
    if (count_ == kThreadRecords) return false;
    Piece& piece = pieces_[count_];
    piece = {length_,
             std::max(record.length, 0.0),
             0,
             std::max(std::abs(record.lead), kLeastLead),
             record.lead_change,
             std::max(record.v_max, kLeastLimit),
             std::max(record.a_max, kLeastLimit),
             0,
             0,
             0};
    piece.j_max = std::clamp(record.j_max, kLeastLimit, kJerkSteps * piece.a_max / dt_);
    if (count_ == 0) {
        start_angle_ = record.start_angle;
        a_max_ = piece.a_max;
        j_max_ = piece.j_max;
        v_max_ = piece.v_max;
        phase_ = ThreadPhase::Waiting;
    } else {
        const Piece& last = pieces_[count_ - 1];
        // Revolutions that the piece before takes: lead u + change u^2/2 = length.
        const double root =
            std::sqrt(std::max(0.0, last.lead * last.lead + 2 * last.lead_change * last.length));
        piece.turn = last.turn + 2 * last.length / (last.lead + root);
        a_max_ = std::min(a_max_, piece.a_max);
        j_max_ = std::min(j_max_, piece.j_max);
        v_max_ = std::min(v_max_, piece.v_max);
    }
    length_ += piece.length;
    ++count_;
    return true;
}

ThreadFollower::Line ThreadFollower::line_at(double angle, double speed,
                                             double acceleration) const noexcept {
    const double turn = sense_ * (angle - origin_) / kDegrees;
    std::uint32_t i = line_piece_;
    while (i + 1 < count_ && turn >= pieces_[i + 1].turn) ++i;
    const Piece& piece = pieces_[i];
    const double u = turn - piece.turn;
    // before its beginning the line is straight
    const double change = u > 0 ? piece.lead_change : 0;
    const double lead = std::max(0.0, piece.lead + change * u);
    const double rate = sense_ * speed / kDegrees;
    return {piece.begin + u * (piece.lead + change * u / 2), lead * rate,
            lead * sense_ * acceleration / kDegrees + change * rate * rate, i};
}

double ThreadFollower::closing_time(double speed_step, double a_max, double j_max, double peak_a,
                                    double peak_j) noexcept {
    return std::max(peak_a * speed_step / (kShareA * a_max),
                    std::sqrt(peak_j * speed_step / (kShareJ * j_max)));
}

double ThreadFollower::run_in(double spindle_speed) const noexcept {
    if (count_ == 0) return 0;
    const double v = pieces_[0].lead * std::abs(spindle_speed) / kDegrees;
    return v * closing_time(v, a_max_, j_max_, kRunInA, kRunInJ) / 2;
}

// True when the axis must begin to move in this tick.
bool ThreadFollower::wait_for_angle(const ThreadInput& input, ThreadStep& step) noexcept {
    const double speed = std::abs(input.speed), v = pieces_[0].lead * speed / kDegrees;
    if (!(speed > 0)) return false;
    double lead = 0;
    for (std::uint32_t i = 0; i < count_; ++i) {
        const Piece& piece = pieces_[i];
        const double root = std::sqrt(
            std::max(0.0, piece.lead * piece.lead + 2 * piece.lead_change * piece.length));
        lead = std::max({lead, piece.lead, root});
    }
    step.too_fast = lead * speed / kDegrees > v_max_;
    if (step.too_fast) return false;
    sense_ = input.speed > 0 ? 1 : -1;
    // degrees before the start angle
    const double need = speed * closing_time(v, a_max_, j_max_, kRunInA, kRunInJ) / 2;
    // input.angle is that of the tick's end; the motion would begin at its beginning.
    const double angle = input.angle - input.speed * dt_;
    double over = std::fmod(sense_ * (start_angle_ - angle) - need, kDegrees);
    if (over < 0) over += 360;
    if (over >= speed * dt_) return false;  // the next tick is early enough
    // degrees until the start angle: the line is that far behind s = 0
    const double ahead = need + over;
    origin_ = angle + sense_ * ahead;
    gap_.begin({v * ahead / speed, -v, 0}, 2 * ahead / speed);
    line_piece_ = 0;
    return true;
}

PathState ThreadFollower::follow(const ThreadInput& input, ThreadStep& step) noexcept {
    Line line = line_at(input.angle, input.speed, input.acceleration);
    if (line.piece != line_piece_) {  // the lead may jump: close the gap of speed
        line_piece_ = line.piece;
        const double jump = state_.v - line.v;
        if (std::abs(jump) > kJumpWorthClosing * a_max_ * dt_) {
            const double time = closing_time(std::abs(jump), a_max_, j_max_, kJumpA, kJumpJ) + dt_;
            gap_.begin({state_.s + state_.v * dt_ - line.s, jump, state_.a - line.a}, time);
        }
    }
    const ClosingGap::Value gap = gap_.tick(dt_);
    phase_ = gap_.open() ? ThreadPhase::Closing : ThreadPhase::OnLine;
    // Where the path would be at the tick's end without jerk, and what is then left.
    const PathState free = advanced(state_, 0, dt_);
    const double d = line.s + gap.e - free.s, d1 = line.v + gap.e1 - free.v,
                 d2 = line.a + gap.e2 - free.a;
    // All four poles at -p: (x + p)^4 = x^4 + 4 p x^3 + 6 p^2 x^2 + 4 p^3 x + p^4, the factors of
    // d2, d1, d and the integral of d.
    constexpr double p = kPole;
    double j = p * p * p * (p * sum_ + 4 * d) + 6 * p * p * d1 + 4 * p * d2;
    const double limit = kControlJerk * j_max_;
    if (std::abs(j) < limit) sum_ += d * dt_;
    j = std::clamp(j, std::max(-limit, (-a_max_ - state_.a) / dt_),
                   std::min(limit, (a_max_ - state_.a) / dt_));
    PathState next = advanced(state_, j, dt_);
    if (next.v < 0) next = towards_speed(state_, 0, a_max_, limit, dt_);
    if (release_speed(next.v, std::max(next.a, 0.0), limit) > v_max_) {
        next = towards_speed(state_, v_max_, a_max_, limit, dt_);
        step.lost_line = true;
    }
    deviation_ = next.s - line.s;
    return next;
}

ThreadStep ThreadFollower::tick(const ThreadInput& input) noexcept {
    ThreadStep step;
    step.began_from = step.began_to = step.ended_from = step.ended_to = first_ + piece_;
    if (phase_ == ThreadPhase::Waiting && !input.brake && input.emergency_dec <= 0 &&
        wait_for_angle(input, step))
        phase_ = ThreadPhase::Closing;
    const double before = state_.s;
    if (phase_ == ThreadPhase::Closing || phase_ == ThreadPhase::OnLine ||
        phase_ == ThreadPhase::Leaving) {
        if (input.emergency_dec > 0) {
            const double time = std::min(dt_, state_.v / input.emergency_dec);
            state_ = {state_.s + time * (state_.v - input.emergency_dec * time / 2),
                      time < dt_ ? 0.0 : state_.v - input.emergency_dec * time, 0};
            phase_ = state_.v > 0 ? ThreadPhase::Leaving : ThreadPhase::Done;
            state_.s = std::min(state_.s, length_);
        } else if (phase_ == ThreadPhase::Leaving && !input.brake) {
            const PathState next = landing_.step(dt_);
            state_ = {state_.s + next.s, next.v, next.a};
        } else {
            PathState next = input.brake
                                 ? towards_speed(state_, 0, a_max_, kPlannedJerk * j_max_, dt_)
                                 : follow(input, step);
            const double left = length_ - state_.s;
            if (next.v > 0 &&
                stopping_distance(next.v, next.a, a_max_, kPlannedJerk * j_max_) >
                    length_ - next.s &&
                landing_.aim(state_.v, state_.a, left, a_max_, j_max_ / kSoftestLanding, j_max_)) {
                phase_ = ThreadPhase::Leaving;
                next = landing_.step(dt_);
                next.s += state_.s;
            }
            state_ = next;
        }
        if (phase_ == ThreadPhase::Leaving && landing_.landed() && state_.v == 0) {
            state_.s = length_;
            phase_ = ThreadPhase::Done;
        } else if (input.brake && state_.v == 0 && state_.a == 0) {
            phase_ = ThreadPhase::Done;
        }
    }
    report(before, step);
    return step;
}

void ThreadFollower::report(double moved_from, ThreadStep& step) noexcept {
    const double moved = state_.s - moved_from;
    const auto part = [&](double s) {
        return moved > 0 ? std::clamp((s - moved_from) / moved, 0.0, 1.0) : 1.0;
    };
    while (count_ > 0 && (phase_ != ThreadPhase::Waiting && phase_ != ThreadPhase::Idle)) {
        Piece& piece = pieces_[piece_];
        if (!began_) {
            if (step.began_from == step.began_to) step.began_from = first_ + piece_;
            step.began_to = first_ + piece_ + 1;
            piece.begin_fraction = piece_ == 0 ? 0 : part(piece.begin);
            began_ = true;
        }
        const bool last = piece_ + 1 == count_;
        if (state_.s < piece.begin + piece.length || (last && phase_ != ThreadPhase::Done)) break;
        if (last && step.ended_to > first_ + piece_) break;
        piece.end_fraction = part(piece.begin + piece.length);
        if (step.ended_from == step.ended_to) step.ended_from = first_ + piece_;
        step.ended_to = first_ + piece_ + 1;
        if (last) break;
        ++piece_;
        began_ = false;
    }
    step.phase = phase_;
    step.record = first_ + piece_;
    step.s = count_ > 0 ? state_.s - pieces_[piece_].begin : 0;
    step.speed = state_.v;
    step.acceleration = state_.a;
}

}  // namespace polyturn::kernel
