// A gap between an actual and a wanted position, closed without a step of acceleration: the quintic
// in time that begins at (e, e', e'') and ends at (0, 0, 0). A follower of a line (a spindle's
// thread, a partner's axis) adds it to that line.
//
//   e |--.
//     |    '-.
//     |       '-.._
//     +-------------''----> t
//     0             time
//
// Cost      16 multiplications a tick.
// Weakness  It knows no limit; the time decides how much acceleration and jerk it asks for, and the
//           caller chooses it (ThreadFollower, LineFollower).
#pragma once

namespace polyturn::kernel {

class ClosingGap {
public:
    struct Value {
        double e = 0, e1 = 0, e2 = 0;  // mm, mm/s, mm/s2
    };

    // From now on, within `time` seconds > 0.
    void begin(const Value& from, double time) noexcept {
        const double t = time, t2 = t * t;
        c_[0] = from.e;
        c_[1] = from.e1;
        c_[2] = from.e2 / 2;
        c_[3] = -(20 * from.e + 12 * from.e1 * t + 3 * from.e2 * t2) / (2 * t2 * t);
        c_[4] = (30 * from.e + 16 * from.e1 * t + 3 * from.e2 * t2) / (2 * t2 * t2);
        c_[5] = -(12 * from.e + 6 * from.e1 * t + from.e2 * t2) / (2 * t2 * t2 * t);
        run_ = 0;
        time_ = time;
    }
    void clear() noexcept { time_ = 0; }
    [[nodiscard]] bool open() const noexcept { return time_ > 0; }

    // What is left of it at the end of a tick of `dt` seconds.
    Value tick(double dt) noexcept {
        if (!open()) return {};
        run_ += dt;
        const double t = run_;
        if (t >= time_) {
            time_ = 0;
            return {};
        }
        return {c_[0] + t * (c_[1] + t * (c_[2] + t * (c_[3] + t * (c_[4] + t * c_[5])))),
                c_[1] + t * (2 * c_[2] + t * (3 * c_[3] + t * (4 * c_[4] + t * 5 * c_[5]))),
                2 * c_[2] + t * (6 * c_[3] + t * (12 * c_[4] + t * 20 * c_[5]))};
    }

private:
    double c_[6] = {};           // e(t) = sum c_[i] t^i
    double run_ = 0, time_ = 0;  // time_ 0: closed
};

}  // namespace polyturn::kernel
