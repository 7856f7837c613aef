// One motor, two users: a spindle, and the C axis that it is when it is positioned (equal output
// addresses N0503, N0603). Behind it lies one drive in millionths of a degree; the spindle sees
// whole counts of its own encoder, the axis all of it.
//
//   spindle --exchange--> +-------------+
//                         | SharedDrive | --> drive
//   axis    --exchange--> +-------------+
//
// The kernel decides who has the drive. The other one's command is not given out; what is measured
// both see. Spindles come first in a tick: without the drive they see it one tick older.
#pragma once
#include <array>
#include <memory>

#include "kernel/drives/drive.h"

namespace polyturn::kernel {

class SharedDrive {
public:
    enum class User : std::uint8_t { Spindle, Axis };
    SharedDrive(const PolyturnDriveApi& api, PolyturnDriveSetup setup, double spindle_counts);
    ~SharedDrive();
    SharedDrive(const SharedDrive&) = delete;
    SharedDrive& operator=(const SharedDrive&) = delete;

    void* real() const noexcept { return real_; }
    void give_to(User user) noexcept { user_ = user; }
    User user() const noexcept { return user_; }
    void exchange(User user, const PolyturnDriveCommand& command,
                  PolyturnDriveStatus& status) noexcept;

    // open() gives nullptr: the kernel passes the object itself
    static const PolyturnDriveApi& spindle_side();
    // open() gives the drive that hand_to_axis() named last. Not in the cyclic thread.
    static const PolyturnDriveApi& axis_side();
    void hand_to_axis() noexcept;

private:
    const PolyturnDriveApi* api_;
    void* real_;
    double counts_;
    User user_ = User::Spindle;
    std::array<std::uint16_t, 2> simulate_{};  // simulated behaviour of each user's drive
    PolyturnDriveStatus status_{};
};

}  // namespace polyturn::kernel
