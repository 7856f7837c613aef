// One machine axis: commanded position, position loop, supervision, and the drive behind it.
//
// In tick n (from t[n] to t[n+1]) the axis knows command() = cmd(t[n]), is given the command for t[n+1], and hands the
// drive a speed. What the drive measured at t[n] arrives with the exchange, is shown with this tick, and enters the loop in
// the next one together with the command of the same moment: an encoder that is a tick late leaves no error behind.
//
//     speed = K (cmd - act)|a tick ago  +  A (v + 2d/w a)      K N0504, A N0511
// v and a are those of the command over this very tick, 2d/w is the lag of the drive: with A = 1 an ideal drive follows
// without error, with A = 0 it lags by v / K.
#pragma once
#include <cstdint>

#include "kernel/config/kernel_config.hpp"
#include "kernel/drives/drive.h"

namespace polyturn::kernel {

class AxisUnit {
public:
    enum class Fault : std::uint8_t { None, Drive, FollowingError, StandstillError };

    // Not in the cyclic thread: opens the drive.
    bool open(unsigned number, const AxisConfig& config, double tick_s, double start, const PolyturnDriveApi& api);
    void close();
    void configure(const AxisConfig& config) noexcept { config_ = config; }

    const AxisConfig& config() const noexcept { return config_; }
    bool exists() const noexcept { return drive_ != nullptr; }
    double command() const noexcept { return command_; }   // at the start of this tick
    double target() const noexcept { return target_; }     // at its end
    double velocity() const noexcept { return velocity_; } // of the command over the last tick
    double measured() const noexcept { return measured_; } // at the start of the last exchanged tick
    double error() const noexcept { return error_; }
    bool moving() const noexcept { return moving_; }
    bool in_position() const noexcept { return !moving_ && still_ticks_ > 1 && error_ <= config_.in_position && error_ >= -config_.in_position; }
    bool faulted() const noexcept { return fault_ != Fault::None; }
    Fault fault() const noexcept { return fault_; }
    void clear_fault() noexcept { fault_ = Fault::None; }
    bool referenced = false;
    bool rapid = false;                                    // feedforward in rapid is a choice of its own (N0515 FFR)
    std::uint32_t owner = 0;                               // channel (from 1) that moves it now
    std::uint32_t stroke_side = 0;                         // bit 0 at the positive end, bit 1 at the negative end

    // Where the axis is to be at the end of this tick. Not called: it stays.
    void move_to(double position) noexcept {
        own_target_ = position;
        target_ = position + added_;
    }
    // Coupled axes (couplings.hpp): what its channel commands, and what a master adds to it.
    void couple(double own_target, double added) noexcept {
        own_target_ = own_target;
        added_ = added;
        target_ = own_target + added;
    }
    double own() const noexcept { return own_command_; }          // at the start of this tick, without what a master adds
    double own_target() const noexcept { return own_target_; }
    bool slave = false;                                    // synchronous: nobody but its master may move it
    // Own braking at PT_ESTOP_DEC, away from any path (emergency stop, drive fault). True while it still moves.
    bool brake(double tick_s) noexcept;
    // The position loop and the drive; ends the tick. `powered`: the loop is closed.
    void exchange(double tick_s, bool powered) noexcept;
    void* drive() const noexcept { return drive_; }

private:
    void supervise(double tick_s) noexcept;
    AxisConfig config_;
    const PolyturnDriveApi* api_ = nullptr;
    void* drive_ = nullptr;
    double command_ = 0, target_ = 0, velocity_ = 0;
    double own_command_ = 0, own_target_ = 0, own_velocity_ = 0, added_ = 0;
    double measured_ = 0, error_ = 0;
    double remainder_ = 0;                                 // of the speed command, thousandths of an increment
    double lag_s_ = 0;
    std::int64_t still_ticks_ = 2;
    bool moving_ = false;
    bool powered_ = true;                                  // nothing to follow up at the start: command and drive agree
    Fault fault_ = Fault::None;
    PolyturnDriveStatus status_{};
};

}  // namespace polyturn::kernel
