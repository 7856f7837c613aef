// Retract from a thread that is held, and return to where its pass begins.
//
//   hold                                        cycle start
//    |  Leaving: the thread goes on, the          |  Along: the thread's own axis back to the start,
//    v  retract axes move out beside it           v  clear of the part
//   ...-------.                                 <-------------.
//              '-.___ Clear: brakes              | Across: the others           then the pass again
//                     Out: stopped               v
//
// The axes leave the thread while the path still follows the spindle, so the tool does not cut a
// groove; only then the path brakes. Within velocity, acceleration and jerk of each axis. No
// channel process takes part (architecture 5.7): the records of the thread stay in the ring until
// the pass has been driven to its end.
#pragma once
#include <array>
#include <cstdint>

#include "kernel/axes/axis_unit.hpp"
#include "kernel/by_hand/axis_jog.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::kernel {

class ThreadRetract {
public:
    // Of slot `k`, as the record says; 0: none.
    static double of(const PathRecord& r, std::uint32_t k) noexcept {
        return k < r.retract.size() ? r.retract[k] : 0.0;
    }
    void clear() noexcept { *this = {}; }
    bool active() const noexcept { return phase_ != Phase::None; }
    bool clear_of_part() const noexcept { return phase_ >= Phase::Clear; }
    bool out() const noexcept { return phase_ >= Phase::Out; }

    // Retract by record.retract from a path of speed `path_speed`. False: no retract is possible.
    bool begin(const PathRecord& record, const std::array<AxisUnit, kMaxAxes>& axes,
               double path_speed, double tick_s) noexcept;
    // One tick of the retract, on top of what the path commands.
    void move_axes(std::array<AxisUnit, kMaxAxes>& axes, double tick_s) noexcept;
    void stop() noexcept { jog_.stop(); }
    bool moving() const noexcept { return jog_.active(); }
    void stands_out() noexcept { phase_ = Phase::Out; }

    // One tick of the return to the start of `record`; `go`: it may move, else it brakes. True
    // when it is there.
    bool step_back(const PathRecord& record, std::array<AxisUnit, kMaxAxes>& axes, bool go,
                   double tick_s) noexcept;

private:
    enum class Phase : std::uint8_t { None, Leaving, Clear, Out, Along, Across };
    bool begin_leg(const PathRecord& record, const std::array<AxisUnit, kMaxAxes>& axes,
                   double tick_s) noexcept;

    Phase phase_ = Phase::None;
    std::uint32_t slots_ = 0;
    std::array<std::uint8_t, kMaxPathAxes> axis_{};
    // of the travel, per axis; where the leg began
    std::array<double, kMaxPathAxes> share_{}, from_{};
    double length_ = 0, offset_ = 0;
    AxisJog jog_;
};

}  // namespace polyturn::kernel
