#include "kernel/drives/shared_drive.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr std::int64_t kFinePerRev = 360'000'000;  // 1e-6 degree

void* no_open(const PolyturnDriveSetup*) { return nullptr; }
SharedDrive* handed = nullptr;
void* open_for_axis(const PolyturnDriveSetup*) { return handed; }
void no_close(void*) {}
void as_spindle(void* drive, const PolyturnDriveCommand* command, PolyturnDriveStatus* status) {
    static_cast<SharedDrive*>(drive)->exchange(SharedDrive::User::Spindle, *command, *status);
}
void as_axis(void* drive, const PolyturnDriveCommand* command, PolyturnDriveStatus* status) {
    static_cast<SharedDrive*>(drive)->exchange(SharedDrive::User::Axis, *command, *status);
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) noexcept {
    return a / b - (a % b < 0 ? 1 : 0);
}
}  // namespace

const PolyturnDriveApi& SharedDrive::spindle_side() {
    static constexpr PolyturnDriveApi kApi{POLYTURN_DRIVE_VERSION, no_open, no_close, as_spindle};
    return kApi;
}
const PolyturnDriveApi& SharedDrive::axis_side() {
    static constexpr PolyturnDriveApi kApi{POLYTURN_DRIVE_VERSION, open_for_axis, no_close,
                                           as_axis};
    return kApi;
}

SharedDrive::SharedDrive(const PolyturnDriveApi& api, PolyturnDriveSetup setup,
                         double spindle_counts)
    : api_(&api), counts_(spindle_counts) {
    setup.increments_per_unit = static_cast<double>(kFinePerRev);
    setup.mark_distance = 1.0;  // a revolution
    real_ = api.open(&setup);
}

void SharedDrive::hand_to_axis() noexcept { handed = this; }

SharedDrive::~SharedDrive() {
    if (real_) api_->close(real_);
}

void SharedDrive::exchange(User user, const PolyturnDriveCommand& command,
                           PolyturnDriveStatus& status) noexcept {
    simulate_[static_cast<std::size_t>(user)] = command.simulate;
    if (user == user_) {
        PolyturnDriveCommand out = command;
        out.simulate = simulate_[0] ? simulate_[0] : simulate_[1];
        if (user == User::Spindle) {
            const double scale = static_cast<double>(kFinePerRev) / counts_;
            out.target_velocity = static_cast<std::int64_t>(
                std::floor(static_cast<double>(command.target_velocity) * scale + 0.5));
            out.target_position = static_cast<std::int64_t>(
                std::floor(static_cast<double>(command.target_position) * scale + 0.5));
        }
        api_->exchange(real_, &out, &status_);
    }
    status = status_;
    if (user == User::Axis) return;
    const auto in_counts = [&](std::int64_t fine) {
        const std::int64_t turns = floor_div(fine, kFinePerRev);
        const double rest = static_cast<double>(fine - turns * kFinePerRev) * counts_ /
                            static_cast<double>(kFinePerRev);
        return turns * static_cast<std::int64_t>(counts_) +
               static_cast<std::int64_t>(std::floor(rest));
    };
    status.position = in_counts(status_.position);
    status.probe_position = in_counts(status_.probe_position);
}

}  // namespace polyturn::kernel
