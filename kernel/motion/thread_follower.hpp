// Threads: the path follows the angle of the spindle, whatever its speed.
//
//   s |                          .-'  <- leaves the line only to stop at the end of the last record
//     |                  line .-'
//     |                    .-'
//     |                  .-'          line: s = lead (angle - start angle)/360, record after record
//     |              _.-'
//     |__________.-''                 from rest at s = 0, begun so early that it is on the line
//     +---------|---+-------------> angle                                              after T
//               |<->| w T/2   start angle
//
// Start    At rest, T/2 before the spindle comes to the start angle: then the line is v T/2 behind
//          the axis, and an axis that accelerates for T to v covers exactly v T/2 less than the
//          line. The gap e = s - line runs to 0 as the quintic in time that begins at the gap's
//          (e, e', e'') and ends in (0, 0, 0): with v = 0 -> v it asks for 1.5 v/T of acceleration
//          and 6 v/T^2 of jerk, which gives T. It ends on the line exactly, so where it began in
//          the tick, and with it the phase, does not matter. Where the lead jumps between records
//          the gap is closed likewise.
// Driving  The line is known by estimates that carry the encoder's noise. The path is a triple
//          integrator whose jerk j = p^4 (integral of d) + 4 p^3 d + 6 p^2 d' + 4 p d'', d = (line
//          + e) - s, is kept within the limits: noise moves nothing but jerk. The integral is there
//          because the estimates of speed and acceleration lag a little behind the derivatives of
//          the estimated angle while the spindle swings; without it d would follow that lag.
// End      At each tick the next state must still be able to stop at the end; when it is not, land
//          (landing.hpp).
// Limit    A spindle that runs the thread above v_max is refused at the start (Waiting, too_fast);
//          if it speeds up later the path stays at v_max and says lost_line: the thread is spoilt,
//          the machine is not.
// Cost     Some ten multiplications a tick; no state outside this object.
#pragma once
#include <array>
#include <cstdint>

#include "kernel/motion/closing_gap.hpp"
#include "kernel/motion/landing.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::kernel {

inline constexpr std::uint32_t kThreadRecords = 128;  // chained records of one thread

struct ThreadInput {
    double angle = 0;          // degrees over all revolutions at the end of this tick, as estimated
    double speed = 0;          // degrees a second, then
    double acceleration = 0;   // degrees a second squared, then
    bool brake = false;        // leave the line and come to rest along the path
    double emergency_dec = 0;  // mm/s2; > 0: at once, exempt from jerk
};

enum class ThreadPhase : std::uint8_t { Idle = 0, Waiting, Closing, OnLine, Leaving, Done };

struct ThreadStep {
    ThreadPhase phase = ThreadPhase::Idle;
    std::uint64_t record = 0;  // running at the tick's end
    double s = 0, speed = 0, acceleration = 0;
    std::uint64_t began_from = 0, began_to = 0, ended_from = 0, ended_to = 0;  // as in PathStep
    bool too_fast = false;   // lead times speed is above the limit: does not start
    bool lost_line = false;  // the path could not keep up with the spindle
};

class ThreadFollower {
public:
    void configure(double dt) noexcept { dt_ = dt; }
    // A new thread from rest. `first`: ring index of its first record; then append() the chained
    // ones up to kThreadEnd.
    void clear(std::uint64_t first) noexcept;
    // false: kThreadRecords are there already
    [[nodiscard]] bool append(const PathRecord& record) noexcept;
    [[nodiscard]] ThreadStep tick(const ThreadInput& input) noexcept;

    [[nodiscard]] double begin_fraction(std::uint64_t record) const noexcept {
        return pieces_[record - first_].begin_fraction;
    }
    [[nodiscard]] double end_fraction(std::uint64_t record) const noexcept {
        return pieces_[record - first_].end_fraction;
    }
    [[nodiscard]] double deviation() const noexcept { return deviation_; }  // mm off the line
    // Whole distance from rest to the line at a spindle speed (degrees a second): what a run-in
    // must have.
    [[nodiscard]] double run_in(double spindle_speed) const noexcept;

private:
    struct Piece {
        double begin, length, turn;  // mm along the thread; revolutions at its beginning
        double lead, lead_change;
        double v_max, a_max, j_max;
        double begin_fraction, end_fraction;
    };
    struct Line {
        double s, v, a;
        std::uint32_t piece;
    };
    [[nodiscard]] Line line_at(double angle, double speed, double acceleration) const noexcept;
    [[nodiscard]] static double closing_time(double speed_step, double a_max, double j_max,
                                             double peak_a, double peak_j) noexcept;
    [[nodiscard]] bool wait_for_angle(const ThreadInput& input, ThreadStep& step) noexcept;
    [[nodiscard]] PathState follow(const ThreadInput& input, ThreadStep& step) noexcept;
    void report(double moved_from, ThreadStep& step) noexcept;

    double dt_ = 0.001;
    std::uint64_t first_ = 0;
    std::array<Piece, kThreadRecords> pieces_{};
    std::uint32_t count_ = 0, piece_ = 0;  // piece_: where the path is
    std::uint32_t line_piece_ = 0;         // where the line is
    double start_angle_ = 0;               // as programmed
    double origin_ = 0;                    // angle over all revolutions that belongs to s = 0
    double sense_ = 1;                     // of rotation
    double a_max_ = 0, j_max_ = 0, v_max_ = 0, length_ = 0;  // least of the pieces; whole length
    ThreadPhase phase_ = ThreadPhase::Idle;
    PathState state_;  // s along the whole thread
    ClosingGap gap_;
    double deviation_ = 0, sum_ = 0;  // off the line now, mm; and its integral, mm s
    bool began_ = false;
    Landing landing_;
};

}  // namespace polyturn::kernel
