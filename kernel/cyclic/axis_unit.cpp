#include "kernel/cyclic/axis_unit.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kIncrementsPerUnit = 1e6;  // nct_parameters_part1 3.3: 1e-6 mm or degree
constexpr double kStandstillSupervisionS = 1.0;
}  // namespace

bool AxisUnit::open(unsigned number, const AxisConfig& config, double tick_s, double start, const PolyturnDriveApi& api) {
    config_ = config;
    api_ = &api;
    PolyturnDriveSetup setup{};
    setup.version = POLYTURN_DRIVE_VERSION;
    setup.number = number;
    setup.tick_s = tick_s;
    setup.increments_per_unit = kIncrementsPerUnit;
    setup.start_position = std::llround(start * kIncrementsPerUnit);
    setup.frequency_hz = config.drive_frequency_hz;
    setup.damping = config.drive_damping;
    drive_ = api.open(&setup);
    command_ = target_ = measured_ = own_command_ = own_target_ = start;
    lag_s_ = 2.0 * config.drive_damping / (2.0 * 3.14159265358979323846 * config.drive_frequency_hz);
    return drive_ != nullptr;
}

void AxisUnit::close() {
    if (drive_) api_->close(drive_);
    drive_ = nullptr;
}

bool AxisUnit::brake(double tick_s) noexcept {
    const double step = config_.estop_deceleration * tick_s;
    double v = own_velocity_;
    v = v > step ? v - step : v < -step ? v + step : 0.0;
    move_to(own_command_ + v * tick_s);
    return v != 0.0;
}

void AxisUnit::exchange(double tick_s, bool powered) noexcept {
    if (powered && !powered_) command_ = target_ = measured_, own_command_ = own_target_ = measured_ - added_;  // follow-up (N0514 FUP = 0): closing the loop moves nothing
    powered_ = powered;
    const double v = (target_ - command_) / tick_s;
    const double a = (v - velocity_) / tick_s;
    // error_ and the command it was taken from are a tick old, both of the same moment.
    double speed = config_.gain * error_;
    if (!rapid || config_.feedforward_in_rapid) speed += config_.feedforward * (v + lag_s_ * a);
    PolyturnDriveCommand out{};
    out.control = powered && !faulted() ? POLYTURN_DRIVE_ENABLE : POLYTURN_DRIVE_SHUTDOWN;
    if (status_.status == POLYTURN_DRIVE_FAULT && !faulted()) out.control = POLYTURN_DRIVE_FAULT_RESET;
    out.mode = POLYTURN_DRIVE_MODE_VELOCITY;
    out.brake_release = powered;
    out.torque_limit = 1000;
    const double exact = speed * kIncrementsPerUnit * 1e3 + remainder_;
    out.target_velocity = static_cast<std::int64_t>(std::floor(exact + 0.5));
    remainder_ = exact - static_cast<double>(out.target_velocity);
    api_->exchange(drive_, &out, &status_);
    measured_ = static_cast<double>(status_.position) / kIncrementsPerUnit;
    error_ = powered ? command_ - measured_ : 0.0;
    moving_ = target_ != command_;
    still_ticks_ = moving_ ? 0 : still_ticks_ + 1;
    velocity_ = v;
    command_ = target_;
    own_velocity_ = (own_target_ - own_command_) / tick_s;
    own_command_ = own_target_;
    if (powered) supervise(tick_s);
}

void AxisUnit::supervise(double tick_s) noexcept {
    if (status_.status == POLYTURN_DRIVE_FAULT) fault_ = Fault::Drive;
    if (faulted()) return;
    const double size = std::fabs(error_);
    if (config_.error_absolute > 0 && size > config_.error_absolute) fault_ = Fault::FollowingError;
    // The lag of a stop dies out within a few 1/K; what is left long after is a drive that does not follow.
    if (config_.error_standing > 0 && size > config_.error_standing && static_cast<double>(still_ticks_) * tick_s > kStandstillSupervisionS)
        fault_ = Fault::StandstillError;
}

}  // namespace polyturn::kernel
