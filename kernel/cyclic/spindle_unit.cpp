#include "kernel/cyclic/spindle_unit.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kPi = 3.14159265358979323846;
// How a main spindle's speed follows its command; no parameter of the machine speaks of it.
constexpr double kFrequencyHz = 15.0, kDamping = 1.0;
constexpr std::int32_t kRight = 3, kLeft = 4;
constexpr double kSmallestDiameterMm = 1e-3;
}  // namespace

bool SpindleUnit::open(unsigned number, const SpindleConfig& config, double tick_s) {
    config_ = config;
    api_ = &simulated_drive_api();
    PolyturnDriveSetup setup{};
    setup.version = POLYTURN_DRIVE_VERSION;
    setup.number = number;
    setup.tick_s = tick_s;
    setup.increments_per_unit = config.encoder_counts;
    setup.frequency_hz = kFrequencyHz;
    setup.damping = kDamping;
    drive_ = api_->open(&setup);
    observer_.configure(tick_s, config.encoder_counts, tick_s);
    observer_.reset(0);
    return drive_ != nullptr;
}

void SpindleUnit::close() {
    if (drive_) api_->close(drive_);
    drive_ = nullptr;
}

double SpindleUnit::true_speed() const noexcept { return drive_ ? static_cast<const SimulatedDrive*>(drive_)->true_speed() * 60.0 : 0.0; }
double SpindleUnit::true_angle() const noexcept {
    if (!drive_) return 0.0;
    const double turns = static_cast<const SimulatedDrive*>(drive_)->true_position();
    return (turns - std::floor(turns)) * 360.0;
}

double SpindleUnit::wanted(std::int32_t rotation, double factor, double axis_position) const noexcept {
    if (rotation != kRight && rotation != kLeft) return 0.0;
    double rpm = speed_;
    if (mode_ == Mode::SurfaceSpeed) {
        const double diameter = std::max(2.0 * std::fabs(axis_position - surface_centre_), kSmallestDiameterMm);
        rpm = 1000.0 * surface_speed_ / (kPi * diameter);
    }
    rpm *= factor;
    if (rpm <= 0.0) return 0.0;
    rpm = std::max(rpm, config_.speed_min);
    if (mode_ == Mode::SurfaceSpeed) {
        rpm = std::max(rpm, surface_min_);
        if (surface_limit_ > 0) rpm = std::min(rpm, surface_limit_);
    }
    rpm = std::min(rpm, config_.speed_max);
    return rotation == kRight ? rpm : -rpm;
}

void SpindleUnit::step(double tick_s, std::int32_t rotation, double factor, double axis_position, bool powered, bool stop) noexcept {
    target_ = stop || !powered ? 0.0 : wanted(rotation, factor, axis_position);
    // The ramp is steeper or flatter as the magnitude grows or falls; through zero it is first the one, then the other.
    const bool grows = std::fabs(target_) > std::fabs(ramped_) && target_ * ramped_ >= 0;
    const double most = (grows ? config_.ramp_up : config_.ramp_down) * tick_s;
    ramped_ = target_ > ramped_ + most ? ramped_ + most : target_ < ramped_ - most ? ramped_ - most : target_;
    PolyturnDriveCommand out{};
    out.control = powered ? POLYTURN_DRIVE_ENABLE : POLYTURN_DRIVE_SHUTDOWN;
    out.mode = POLYTURN_DRIVE_MODE_VELOCITY;
    out.brake_release = 1;
    out.torque_limit = 1000;
    const double exact = ramped_ / 60.0 * config_.encoder_counts * 1e3 + remainder_;
    out.target_velocity = static_cast<std::int64_t>(std::floor(exact + 0.5));
    remainder_ = exact - static_cast<double>(out.target_velocity);
    PolyturnDriveStatus status{};
    api_->exchange(drive_, &out, &status);
    observer_.update(status.position);
    measured_speed_ = observer_.speed() / 6.0;  // degrees a second to revolutions a minute
    const double turns = observer_.angle() / 360.0;
    angle_ = (turns - std::floor(turns)) * 360.0;
    const double band = std::max(config_.tolerance_percent * 0.01 * std::fabs(target_), config_.tolerance_rpm);
    standing_ = std::fabs(measured_speed_) <= config_.standstill_rpm;
    reached_ = standing_ ? target_ == 0.0 || std::fabs(target_) <= config_.standstill_rpm : std::fabs(measured_speed_ - target_) <= band;
}

}  // namespace polyturn::kernel
