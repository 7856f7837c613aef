#include "kernel/drives/simulated_drive.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {
using Matrix4 = std::array<std::array<double, 4>, 4>;

Matrix4 product(const Matrix4& left, const Matrix4& right) {
    Matrix4 out{};
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k)
            for (int j = 0; j < 4; ++j) out[i][j] += left[i][k] * right[k][j];
    return out;
}

// exp(M) by scaling with 2^-12 and squaring back; entries of M are w*T at most (30 for 1 kHz at 5 ms), so eight terms of
// the series are exact to the last bit. Only sums and products: the same on every computer, unlike a library's exp().
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

void* open_drive(const PolyturnDriveSetup* setup) { return setup->version == POLYTURN_DRIVE_VERSION ? new SimulatedDrive(*setup) : nullptr; }
void close_drive(void* drive) { delete static_cast<SimulatedDrive*>(drive); }
void exchange_drive(void* drive, const PolyturnDriveCommand* command, PolyturnDriveStatus* status) { static_cast<SimulatedDrive*>(drive)->exchange(*command, *status); }
}  // namespace

const PolyturnDriveApi& simulated_drive_api() {
    static constexpr PolyturnDriveApi kApi{POLYTURN_DRIVE_VERSION, open_drive, close_drive, exchange_drive};
    return kApi;
}

SimulatedDrive::SimulatedDrive(const PolyturnDriveSetup& setup)
    : increments_per_unit_(setup.increments_per_unit),
      position_(static_cast<double>(setup.start_position) / setup.increments_per_unit),
      rounding_(setup.increments_per_unit > 1e5 ? 0.5 : 0.0) {
    const double w = 2.0 * 3.14159265358979323846 * setup.frequency_hz, t = setup.tick_s;
    // In the units (w p, v, a / w) and time w t every entry is near 1. The held input is a fourth state with derivative 0:
    // one exponential gives A and B.
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
}

void SimulatedDrive::exchange(const PolyturnDriveCommand& command, PolyturnDriveStatus& status) noexcept {
    const bool reset = (command.control & POLYTURN_DRIVE_FAULT_RESET) && !(last_control_ & POLYTURN_DRIVE_FAULT_RESET);
    last_control_ = command.control;
    if (failing_) state_ = POLYTURN_DRIVE_FAULT;
    else if (state_ == POLYTURN_DRIVE_FAULT) state_ = reset ? POLYTURN_DRIVE_SWITCH_ON_DISABLED : POLYTURN_DRIVE_FAULT;
    else if ((command.control & POLYTURN_DRIVE_ENABLE) == POLYTURN_DRIVE_ENABLE) state_ = POLYTURN_DRIVE_OPERATING;
    else if ((command.control & POLYTURN_DRIVE_SWITCH_ON) == POLYTURN_DRIVE_SWITCH_ON) state_ = POLYTURN_DRIVE_SWITCHED_ON;
    else if ((command.control & POLYTURN_DRIVE_SHUTDOWN) == POLYTURN_DRIVE_SHUTDOWN) state_ = POLYTURN_DRIVE_READY;
    else state_ = POLYTURN_DRIVE_SWITCH_ON_DISABLED;
    // Latched as this exchange begins; the kernel computes with it in the next tick: one tick late.
    status.position = static_cast<std::int64_t>(std::floor(position_ * increments_per_unit_ + rounding_));
    status.status = state_;
    status.error_code = state_ == POLYTURN_DRIVE_FAULT ? 0x8611 : 0;
    status.touch_probe = 0;
    status.brake_open = command.brake_release;
    status.reserved = 0;
    status.probe_position = 0;
    const bool turns = state_ == POLYTURN_DRIVE_OPERATING;
    step(turns ? static_cast<double>(command.target_velocity) * 1e-3 / increments_per_unit_ : 0.0);
}

}  // namespace polyturn::kernel
