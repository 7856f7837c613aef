// One axis referencing (nct_parameters_part1 10.2). The reference run owns the axis' motion until
// it is over.
//
//   A  switch                 ToSwitch -> Stop -> Leave (latch at the edge) -> Stop -> Shift
//   B  switch, zero pulse     ToSwitch -> Stop -> Leave -> Seek (1/4 to 3/4 of a pulse distance) ->
//                             Stop -> Shift
//   B' the same with GOS      ToSwitch -> Stop -> Seek -> Stop -> Shift
//   C  zero pulse             Seek -> Stop -> Shift
//   D  coded marks            Seek, Seek -> Stop
//   E  absolute encoder       at once         F  by its drive: Await AP_RPE      floating: its
//      position
//
// The position of a signal gets its machine coordinate as soon as it is known: the axis then
// decelerates beyond it, and the position switches work meanwhile.
#pragma once
#include <cstdint>

#include "ipc/diagnosis/diagnosis.hpp"
#include "kernel/axes/axis_unit.hpp"
#include "kernel/by_hand/axis_jog.hpp"
#include "kernel/gate/motion_gate.hpp"

namespace polyturn::kernel {

class Homing {
public:
    enum class State : std::uint8_t { Idle, Busy, Done, Failed };

    bool active() const noexcept { return state_ == State::Busy; }
    // `most`: what other axes that come along can do; infinite values limit nothing.
    void start(Permit permit, AxisUnit& axis, bool drive_ready, double tick_s,
               const AxisJog::Limits& most) noexcept;
    // Brakes; the reference that it had is lost, as from the start on.
    void stop() noexcept;
    // One tick. `on_switch`: AP_DECSW, `drive_ready`: AP_RPE. When Failed, alarm() says why.
    State step(AxisUnit& axis, bool on_switch, bool drive_ready, double tick_s) noexcept;
    Alarm alarm() const noexcept { return alarm_; }

private:
    enum class Phase : std::uint8_t {
        None,
        Await,
        ToSwitch,
        StopOnSwitch,
        Leave,
        Seek,
        StopBehind,
        Shift,
        StopFailed
    };
    AxisJog::Limits limits(const AxisUnit& axis, double speed) const noexcept;
    void go(AxisUnit& axis, Phase phase, double sign, double speed, double distance,
            double tick_s) noexcept;
    void fail(Alarm why) noexcept;
    void found(AxisUnit& axis, double at, double machine) noexcept;
    bool seek(AxisUnit& axis) noexcept;
    bool coded_mark(AxisUnit& axis, double at) noexcept;
    double away(const AxisUnit& axis) const noexcept;  // driven since the phase began

    State state_ = State::Idle;
    Phase phase_ = Phase::None;
    Alarm alarm_ = Alarm::ReferenceNoSwitch;
    AxisJog motion_;
    AxisJog::Limits most_;
    double from_ = 0;         // command where the phase began
    double leave_point_ = 0;  // where the switch was left, N0903 included
    double first_mark_ = 0;
    bool has_leave_point_ = false, has_first_mark_ = false, quiet_ = false;
};

}  // namespace polyturn::kernel
