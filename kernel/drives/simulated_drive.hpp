// A simulated drive: its speed follows the commanded one as a second-order system, it counts whole
// increments, latches them at the start of the tick, and can be commanded to fail. It uses drive.h
// like any other. Backlash, stiction, drift, zero pulses and coded marks are there when the setup
// names them.
#pragma once
#include <array>
#include <cstdint>

#include "kernel/drives/drive.h"

namespace polyturn::kernel {

const PolyturnDriveApi& simulated_drive_api();

// State x = (position, speed, acceleration) in units (mm, degrees, revolutions), u the commanded
// speed, held for a tick:
//     p' = v    v' = a    a' = w^2 (u - v) - 2 d w a
// The step over one tick is exact: x(t+T) = A x(t) + B u with A = exp(F T), so the result does not
// depend on the tick, and a stiff drive (w T near 1) stays stable, which an Euler step would not.
class SimulatedDrive {
public:
    // POLYTURN_SIMULATE_FAULT, POLYTURN_SIMULATE_ENCODER_FAULT
    enum class Failure : std::uint8_t { None, Drive, Encoder };
    explicit SimulatedDrive(const PolyturnDriveSetup& setup);
    void exchange(const PolyturnDriveCommand& command, PolyturnDriveStatus& status) noexcept;
    void fail(Failure how) noexcept { failure_ = how; }
    void jam(bool on) noexcept { jammed_ = on; }  // the rotor is held fast
    void fail(bool on) noexcept { failure_ = on ? Failure::Drive : Failure::None; }
    // What no real drive can report: the truth behind the encoder. Units and units per second, now.
    double true_position() const noexcept { return position_; }
    double true_slide() const noexcept { return slide_; }
    double true_speed() const noexcept { return speed_; }
    // This one only measures: the slide of another drive (the direct device of a dual loop).
    void measure(const SimulatedDrive& other) noexcept { other_ = &other; }

private:
    void step(double commanded) noexcept;
    double positioned(const PolyturnDriveCommand& command, double feedback) noexcept;
    [[nodiscard]] std::int64_t counted(double position) const noexcept;
    [[nodiscard]] bool mark_between(double from, double to, double& at) const noexcept;
    std::array<std::array<double, 3>, 3> a_{};
    std::array<double, 3> b_{};
    double increments_per_unit_;
    double position_, speed_ = 0, acceleration_ = 0;
    double slide_;
    double backlash_, friction_, drift_;
    double mark_distance_, mark_periods_, mark_origin_;
    double last_seen_;  // encoder at the last exchange
    double sign_, encoder_sign_;
    // fine scales are read to the nearest increment; coarse encoders count the lines passed
    double rounding_;
    double tick_s_, wanted_ = 0;  // csp: the last commanded position
    const SimulatedDrive* other_ = nullptr;
    std::uint16_t state_ = POLYTURN_DRIVE_SWITCH_ON_DISABLED;
    std::uint16_t last_control_ = 0, simulate_ = 0;
    bool positioning_ = false;
    bool at_slide_, has_stop_, has_hold_, caught_ = false, jammed_ = false;
    double stop_at_, hold_at_, torque_ = 0;
    Failure failure_ = Failure::None;
};

}  // namespace polyturn::kernel
