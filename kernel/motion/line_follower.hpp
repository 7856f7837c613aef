// A driven element follows a line that another one draws: a spindle its master, a workpiece axis
// the hob, a polygon cutter the workpiece. From any state at its beginning it reaches the line
// within its speed, acceleration and jerk, and stays on it.
//
//   s |              .-'  line + offset
//     |          .-'.'
//     |  follower_.'
//     |_________.'
//     +---------|---------> t
//     Closing     On line
//
// Closing  The gap e = s - (line + offset) runs to 0 as the quintic in time that begins at
//          (e, e', e'') and ends in (0, 0, 0).
// On line  The line is an estimate with an encoder's noise in it; the follower is a triple
//          integrator whose jerk is what the deviation asks for, within the limits: noise moves
//          nothing but jerk (as in thread_follower.hpp).
// Offset   Aim::Exactly 0; Aim::Period integer multiples of a period (a phase: any turn will do),
//          Aim::Anywhere whatever the gentlest approach to the line leaves. The gentlest one starts
//          |e'| T/2 beside the line and asks for 1.5 |e'|/T of acceleration and 6 |e'|/T^2 of jerk;
//          what else is between them asks for 5.78 r/T^2 and 60 r/T^3.
// Share    Closing uses a part of the limits, the rest is the line's own motion.
// Cost     A search of at most 64 steps in the tick in which it begins; then some ten
//          multiplications a tick.
#pragma once
#include "kernel/motion/closing_gap.hpp"
#include "kernel/motion/jerk_profile.hpp"

namespace polyturn::kernel {

class LineFollower {
public:
    enum class Aim : unsigned char { Exactly, Period, Anywhere };
    struct Limits {
        double speed = 0, acceleration = 0, jerk = 0;  // jerk may be infinite
    };
    // `now` and `line`: at this tick's start.
    void begin(const PathState& now, const PathState& line, const Limits& limits, Aim aim,
               double period, double dt) noexcept;
    // `line`: at this tick's end. Where the follower is then.
    PathState tick(const PathState& line, double dt) noexcept;
    // Leaves the line: one tick of braking to rest.
    PathState brake(double dt) noexcept;

    [[nodiscard]] bool on_line() const noexcept { return !gap_.open(); }
    [[nodiscard]] double offset() const noexcept { return offset_; }
    // that it is meant to have at this tick's end
    [[nodiscard]] double gap() const noexcept { return e_; }
    [[nodiscard]] const PathState& state() const noexcept { return state_; }
    // its speed limit keeps it off the line
    [[nodiscard]] bool too_slow() const noexcept { return too_slow_; }
    // its coordinate was moved
    void shift(double by) noexcept {
        state_.s += by;
        offset_ += by;
    }

private:
    double fitting_time(double e, double e1, double e2, double line_speed) const noexcept;
    Limits limits_;
    PathState state_;
    ClosingGap gap_;
    double offset_ = 0, e_ = 0, sum_ = 0;
    bool too_slow_ = false;
};

}  // namespace polyturn::kernel
