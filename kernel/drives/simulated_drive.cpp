#include "kernel/drives/simulated_drive.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kPositionGain = 100.0;  // 1/s, of a drive that closes its own loop
// thousandths of the rated torque for each unit/s that is missing
constexpr double kTorqueOfError = 100.0;
using Matrix4 = std::array<std::array<double, 4>, 4>;

Matrix4 product(const Matrix4& left, const Matrix4& right) {
    Matrix4 out{};
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k)
            for (int j = 0; j < 4; ++j) out[i][j] += left[i][k] * right[k][j];
    return out;
}

// exp(M) by scaling with 2^-12 and squaring back; entries of M are w*T at most (30 for 1 kHz at 5
// ms), so eight terms of the series are exact to the last bit. Only sums and products: the same on
// every computer, unlike a library's exp().
Matrix4 exponential(Matrix4 m) {
    constexpr int kSquarings = 12;
    for (auto& row : m)
        for (double& value : row) value = std::ldexp(value, -kSquarings);
    Matrix4 sum{}, term{};
    for (int i = 0; i < 4; ++i) sum[i][i] = term[i][i] = 1;
    for (int n = 1; n <= 8; ++n) {
        term = product(term, m);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                term[i][j] /= n;
                sum[i][j] += term[i][j];
            }
    }
    for (int n = 0; n < kSquarings; ++n) sum = product(sum, sum);
    return sum;
}

void* open_drive(const PolyturnDriveSetup* setup) {
    return setup->version == POLYTURN_DRIVE_VERSION ? new SimulatedDrive(*setup) : nullptr;
}
void close_drive(void* drive) { delete static_cast<SimulatedDrive*>(drive); }
void exchange_drive(void* drive, const PolyturnDriveCommand* command, PolyturnDriveStatus* status) {
    static_cast<SimulatedDrive*>(drive)->exchange(*command, *status);
}
}  // namespace

const PolyturnDriveApi& simulated_drive_api() {
    static constexpr PolyturnDriveApi kApi{POLYTURN_DRIVE_VERSION, open_drive, close_drive,
                                           exchange_drive};
    return kApi;
}

SimulatedDrive::SimulatedDrive(const PolyturnDriveSetup& setup)
    : increments_per_unit_(setup.increments_per_unit),
      position_(static_cast<double>(setup.start_position) / setup.increments_per_unit *
                (setup.encoder_reversed ? -1.0 : 1.0)),
      slide_(position_),
      backlash_(setup.backlash),
      friction_(setup.friction),
      drift_(setup.drift),
      mark_distance_(setup.mark_distance),
      mark_periods_(setup.mark_periods),
      mark_origin_(setup.mark_origin),
      last_seen_(position_),
      sign_(setup.motor_reversed ? -1.0 : 1.0),
      encoder_sign_(setup.encoder_reversed ? -1.0 : 1.0),
      rounding_(setup.increments_per_unit > 1e5 ? 0.5 : 0.0),
      tick_s_(setup.tick_s),
      at_slide_(setup.at_slide != 0),
      has_stop_(setup.has_stop != 0),
      has_hold_(setup.has_hold != 0),
      stop_at_(setup.stop_at),
      hold_at_(setup.hold_at) {
    const double w = 2.0 * 3.14159265358979323846 * setup.frequency_hz, t = setup.tick_s;
    // In the units (w p, v, a / w) and time w t every entry is near 1. The held input is a fourth
    // state with derivative 0: one exponential gives A and B.
    Matrix4 f{};
    f[0][1] = w * t;
    f[1][2] = w * t;
    f[2][1] = -w * t;
    f[2][2] = -2.0 * setup.damping * w * t;
    f[2][3] = w * t;
    const Matrix4 e = exponential(f);
    const std::array<double, 3> unit{1.0 / w, 1.0, w};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) a_[i][j] = e[i][j] * unit[i] / unit[j];
        b_[i] = e[i][3] * unit[i];
    }
}

void SimulatedDrive::step(double commanded) noexcept {
    const double v = speed_, a = acceleration_;
    position_ += a_[0][1] * v + a_[0][2] * a + b_[0] * commanded;
    speed_ = a_[1][1] * v + a_[1][2] * a + b_[1] * commanded;
    acceleration_ = a_[2][1] * v + a_[2][2] * a + b_[2] * commanded;
    if (jammed_) {
        position_ = slide_;
        speed_ = acceleration_ = 0;
    }
    if (has_stop_ && position_ >= stop_at_ && (speed_ > 0 || commanded > 0)) {
        position_ = stop_at_;
        speed_ = acceleration_ = 0;
    }
    caught_ |= has_hold_ && position_ > hold_at_;
    if (caught_ && position_ <= hold_at_ && (speed_ < 0 || commanded < 0)) {
        position_ = hold_at_;
        speed_ = acceleration_ = 0;
    }
    // The motor pushes the slide with one flank of the backlash: upwards with its lower end,
    // downwards with its upper one.
    if (position_ > slide_)
        slide_ = position_;
    else if (position_ + backlash_ < slide_)
        slide_ = position_ + backlash_;
}

std::int64_t SimulatedDrive::counted(double position) const noexcept {
    return static_cast<std::int64_t>(
        std::floor(encoder_sign_ * position * increments_per_unit_ + rounding_));
}

// Zero pulses lie at whole multiples of their distance. A coded scale has its fixed marks there,
// and behind the k-th of them another one, half way and k + 1 signal periods further: the distance
// of two neighbours gives their position.
bool SimulatedDrive::mark_between(double from, double to, double& at) const noexcept {
    if (mark_distance_ <= 0 || from == to) return false;
    const double low = std::fmin(from, to) - mark_origin_,
                 high = std::fmax(from, to) - mark_origin_;
    const bool up = to > from;
    bool found = false;
    const auto passed = [&](double mark) {
        if (up ? mark > low && mark <= high : mark >= low && mark < high) {
            at = mark + mark_origin_;
            found = true;
        }
    };
    const double k = std::floor((up ? high : low) / mark_distance_);
    for (const double n : {k - 1.0, k, k + 1.0}) {
        passed(n * mark_distance_);
        if (mark_periods_ > 0)
            passed(n * mark_distance_ + mark_distance_ / 2 +
                   (n + 1.0) * mark_distance_ / mark_periods_);
        if (found) return true;
    }
    return false;
}

// csp: the travel commanded for this tick as speed, and the gain on what was missed until now.
double SimulatedDrive::positioned(const PolyturnDriveCommand& command, double feedback) noexcept {
    const double wanted =
        encoder_sign_ * static_cast<double>(command.target_position) / increments_per_unit_;
    const double before = positioning_ ? wanted_ : wanted;
    wanted_ = wanted;
    positioning_ = true;
    return (wanted - before) / tick_s_ + kPositionGain * (before - feedback);
}

void SimulatedDrive::exchange(const PolyturnDriveCommand& command,
                              PolyturnDriveStatus& status) noexcept {
    const bool reset = (command.control & POLYTURN_DRIVE_FAULT_RESET) &&
                       !(last_control_ & POLYTURN_DRIVE_FAULT_RESET);
    last_control_ = command.control;
    if (command.simulate != simulate_) {
        simulate_ = command.simulate;
        failure_ = simulate_ == POLYTURN_SIMULATE_FAULT           ? Failure::Drive
                   : simulate_ == POLYTURN_SIMULATE_ENCODER_FAULT ? Failure::Encoder
                                                                  : Failure::None;
    }
    // no answer arrives, and its own watchdog stops it
    if (simulate_ == POLYTURN_SIMULATE_SILENCE) {
        if (status.lost < 0xFFFF) ++status.lost;
        state_ = POLYTURN_DRIVE_SWITCH_ON_DISABLED;
        step(0);
        return;
    }
    if (simulate_ == POLYTURN_SIMULATE_DEAD)
        state_ = POLYTURN_DRIVE_SWITCH_ON_DISABLED;
    else if (failure_ != Failure::None)
        state_ = POLYTURN_DRIVE_FAULT;
    else if (state_ == POLYTURN_DRIVE_FAULT)
        state_ = reset ? POLYTURN_DRIVE_SWITCH_ON_DISABLED : POLYTURN_DRIVE_FAULT;
    else if ((command.control & POLYTURN_DRIVE_ENABLE) == POLYTURN_DRIVE_ENABLE)
        state_ = POLYTURN_DRIVE_OPERATING;
    else if ((command.control & POLYTURN_DRIVE_SWITCH_ON) == POLYTURN_DRIVE_SWITCH_ON)
        state_ = POLYTURN_DRIVE_SWITCHED_ON;
    else if ((command.control & POLYTURN_DRIVE_SHUTDOWN) == POLYTURN_DRIVE_SHUTDOWN)
        state_ = POLYTURN_DRIVE_READY;
    else
        state_ = POLYTURN_DRIVE_SWITCH_ON_DISABLED;
    // Latched as this exchange begins; the kernel computes with it in the next tick: one tick late.
    const double seen = other_ ? other_->slide_ : at_slide_ ? slide_ : position_;
    status.position = counted(seen);
    status.status = state_;
    status.error_code = state_ != POLYTURN_DRIVE_FAULT ? 0
                        : failure_ == Failure::Encoder ? 0x7305
                                                       : 0x8611;
    status.touch_probe = 0;
    status.brake_open = command.brake_release;
    status.lost = 0;
    status.reserved[0] = status.reserved[1] = 0;
    const double limit = static_cast<double>(command.torque_limit);
    torque_ = std::clamp(torque_, -limit, limit);
    status.torque = static_cast<std::int16_t>(std::lround(torque_));
    status.limited = std::fabs(torque_) >= limit;
    double mark = 0;
    if ((command.touch_probe & POLYTURN_DRIVE_MARK_ARMED) && mark_between(last_seen_, seen, mark)) {
        status.touch_probe = POLYTURN_DRIVE_MARK_SEEN;
        status.probe_position = counted(mark);
    } else {
        status.probe_position = 0;
    }
    last_seen_ = seen;
    const bool turns = state_ == POLYTURN_DRIVE_OPERATING;
    double commanded = 0;
    if (turns && command.mode == POLYTURN_DRIVE_MODE_POSITION)
        commanded = positioned(command, seen) + drift_;
    else if (turns)
        commanded =
            sign_ * static_cast<double>(command.target_velocity) * 1e-3 / increments_per_unit_ +
            drift_;
    if (!turns || command.mode != POLYTURN_DRIVE_MODE_POSITION) positioning_ = false;
    if (friction_ > 0 && std::fabs(speed_) < 1e-3 * friction_ && std::fabs(commanded) < friction_)
        commanded = 0.0;
    step(commanded);
    // The speed controller asks for torque as long as the speed is not the commanded one.
    torque_ = turns ? kTorqueOfError * (commanded - speed_) : 0.0;
}

}  // namespace polyturn::kernel
