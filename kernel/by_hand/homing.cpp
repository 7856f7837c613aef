#include "kernel/by_hand/homing.hpp"

#include <cmath>
#include <limits>

namespace polyturn::kernel {
namespace {
constexpr std::int64_t kForever = std::numeric_limits<std::int64_t>::max() / 2;
constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kPulsesToTry = 2.0;  // distances without a pulse until there is none
double sign_of(double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }
}  // namespace

double Homing::away(const AxisUnit& axis) const noexcept {
    return std::fabs(axis.target() - from_);
}

AxisJog::Limits Homing::limits(const AxisUnit& axis, double speed) const noexcept {
    return {std::fmin(speed, most_.speed),
            std::fmin(axis.config().acceleration, most_.acceleration),
            std::fmin(axis.config().jerk, most_.jerk)};
}

void Homing::go(AxisUnit& axis, Phase phase, double sign, double speed, double distance,
                double tick_s) noexcept {
    phase_ = phase;
    from_ = axis.command();
    motion_.start(from_, sign, limits(axis, speed), kForever, distance, kUnbounded, tick_s);
}

void Homing::fail(Alarm why) noexcept {
    alarm_ = why;
    motion_.stop();
    phase_ = Phase::StopFailed;
}

// The point `at` (in the present coordinate) is from now on called `machine`.
void Homing::found(AxisUnit& axis, double at, double machine) noexcept {
    const double by = machine - at;
    axis.shift(by);
    from_ += by;
    leave_point_ += by;
    motion_.shift(by);
    axis.referenced = true;
}

void Homing::start(Permit, AxisUnit& axis, bool drive_ready, double tick_s,
                   const AxisJog::Limits& most) noexcept {
    most_ = most;
    const ReferenceConfig& r = axis.config().reference;
    state_ = State::Busy;
    has_leave_point_ = has_first_mark_ = quiet_ = false;
    if (r.absolute) {
        phase_ = Phase::Await;
        if (!r.floating || drive_ready) {
            axis.referenced = true;
            state_ = State::Done;
        }
        return;
    }
    axis.referenced = false;
    const double sign = r.negative ? -1.0 : 1.0;
    if (r.coded || (r.by_pulse && !r.by_switch)) {
        axis.watch_mark(true);
        go(axis, Phase::Seek, sign, r.feed, 0, tick_s);
    } else if (r.by_switch) {
        go(axis, Phase::ToSwitch, r.distance < 0 ? -1.0 : 1.0, r.rapid, 0, tick_s);
    } else {  // floating, or no type at all: its position is its reference point
        if (r.floating) found(axis, axis.command(), r.position);
        axis.referenced = true;
        state_ = State::Done;
    }
}

void Homing::stop() noexcept {
    if (state_ != State::Busy) return;
    if (!motion_.active()) state_ = State::Idle;
    motion_.stop();
    quiet_ = true;
    phase_ = Phase::StopFailed;
}

bool Homing::seek(AxisUnit& axis) noexcept {
    const ReferenceConfig& r = axis.config().reference;
    double at = 0;
    if (axis.mark_seen(at)) {
        if (r.coded) return coded_mark(axis, at);
        if (has_leave_point_) {
            const double way = (at - leave_point_) * (r.negative ? -1.0 : 1.0);
            if (way < 0) return false;  // before the shifted switch
            if (way < r.pulse_distance / 4) {
                fail(Alarm::ReferencePulseEarly);
                return false;
            }
            if (way > r.pulse_distance * 3 / 4) {
                fail(Alarm::ReferenceNoPulse);
                return false;
            }
        }
        // The pulse lies N0906 before the reference point.
        found(axis, at, r.position - r.shift);
        return true;
    }
    const double from_switch = (axis.measured() - leave_point_) * (r.negative ? -1.0 : 1.0);
    if (r.coded            ? away(axis) > kPulsesToTry * r.pulse_distance
        : has_leave_point_ ? from_switch > r.pulse_distance * 3 / 4
        : r.by_switch      ? away(axis) > r.switch_length
                           : away(axis) > kPulsesToTry * r.pulse_distance)
        fail(Alarm::ReferenceNoPulse);
    return false;
}

// Two neighbours of a coded scale: their distance gives the position of the first one (the maker's
// formula, part 1, 10.2 D).
bool Homing::coded_mark(AxisUnit& axis, double at) noexcept {
    const ReferenceConfig& r = axis.config().reference;
    if (!has_first_mark_) {
        first_mark_ = at;
        has_first_mark_ = true;
        return false;
    }
    const double period = r.pulse_distance / r.periods, n = r.periods;
    const double direction = at > first_mark_ ? 1.0 : -1.0;
    const double m = std::round(std::fabs(at - first_mark_) / period);
    const double b = 2.0 * m - n, sign_b = sign_of(b);
    const double first =
        (std::fabs(b) - sign_b - 1.0) * n / 2.0 + (sign_b - sign_of(direction)) * m / 2.0;
    found(axis, first_mark_, first * period + r.position);
    return true;
}

Homing::State Homing::step(AxisUnit& axis, bool on_switch, bool drive_ready,
                           double tick_s) noexcept {
    if (state_ != State::Busy) return state_;
    const ReferenceConfig& r = axis.config().reference;
    const double sign = r.negative ? -1.0 : 1.0;
    if (phase_ == Phase::Await) {
        if (drive_ready) {
            axis.referenced = true;
            state_ = State::Done;
        }
        return state_;
    }
    switch (phase_) {
        case Phase::ToSwitch:
            if (on_switch) {
                motion_.stop();
                phase_ = Phase::StopOnSwitch;
            } else if (away(axis) >= std::fabs(r.distance)) {
                fail(Alarm::ReferenceNoSwitch);
            }
            break;
        case Phase::Leave:
            if (!on_switch) {
                // A switch moved by N0903 would have been left so much later.
                leave_point_ = axis.measured() + sign * r.switch_shift;
                if (r.by_pulse) {
                    has_leave_point_ = true;
                    axis.watch_mark(true);
                    phase_ = Phase::Seek;
                } else {
                    found(axis, leave_point_, r.position - r.shift);
                    motion_.stop();
                    phase_ = Phase::StopBehind;
                }
            } else if (away(axis) > r.switch_length) {
                fail(Alarm::ReferenceSwitchNotLeft);
            }
            break;
        case Phase::Seek:
            if (seek(axis)) {
                motion_.stop();
                phase_ = Phase::StopBehind;
            }
            break;
        default:
            break;
    }
    if (motion_.active()) axis.move_to(motion_.step(tick_s));
    if (motion_.active()) return state_;
    switch (phase_) {  // at standstill: the next step
        case Phase::StopOnSwitch:
            if (r.on_switch && r.by_pulse) {
                axis.watch_mark(true);
                go(axis, Phase::Seek, sign, r.feed, 0, tick_s);
            } else {
                go(axis, Phase::Leave, sign, r.feed, 0, tick_s);
            }
            break;
        case Phase::StopBehind: {
            axis.watch_mark(false);
            // With a coded scale nothing need be approached; otherwise N0906 behind the place of
            // the signal.
            const double way = r.coded || r.shift == 0 ? 0.0 : r.position - axis.target();
            if (way == 0) {
                state_ = State::Done;
                break;
            }
            axis.move_to(axis.target());
            phase_ = Phase::Shift;
            from_ = axis.target();
            motion_.start(from_, way > 0 ? 1.0 : -1.0, limits(axis, r.feed), 0, std::fabs(way),
                          kUnbounded, tick_s);
            break;
        }
        case Phase::Shift:
            state_ = State::Done;
            break;
        case Phase::StopFailed:
            axis.watch_mark(false);
            state_ = quiet_ ? State::Idle : State::Failed;
            break;
        default:
            break;
    }
    return state_;
}

}  // namespace polyturn::kernel
