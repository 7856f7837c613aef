// One machine axis: commanded position, position loop, supervision, and the drive behind it.
//
// In tick n (from t[n] to t[n+1]) the axis knows command() = cmd(t[n]), is given the command for
// t[n+1], and hands the drive a speed. What the drive measured at t[n] arrives with the exchange,
// is shown with this tick, and enters the loop (position_loop.hpp) in the next one.
//
// Machine coordinate = encoder (after N0512 / N0513) + origin. Referencing moves the origin:
// command, target and measurement jump together, the drive does not notice.
#pragma once
#include <cstdint>

#include "kernel/axes/encoder_count.hpp"
#include "kernel/axes/position_loop.hpp"
#include "kernel/config/kernel_config.hpp"
#include "kernel/drives/drive.h"

namespace polyturn::kernel {

class AxisUnit {
public:
    enum class Fault : std::uint8_t {
        None,
        Drive,
        FollowingError,
        StandstillError,
        ModelError,
        DualDifference,
        Lost,
        NotOn,
        CommandJump
    };
    // What the PLC says about the loop; it acts with the next exchange.
    struct Requests {
        bool open = false;               // AP_OPNR
        bool no_count = false;           // AP_EFD
        bool follow_up = false;          // AP_FLWU
        bool unwatched = false;          // AP_END
        std::uint16_t torque_limit = 0;  // AP_TORQ, thousandths; 0 none
        // a move that ends at a torque drives it: N3019 limits how far it may lag
        bool seeks_stop = false;
    };

    // Not in the cyclic thread: opens the drive.
    bool open(unsigned number, const AxisConfig& config, double tick_s, double start,
              const PolyturnDriveApi& api);
    void close();
    void configure(const AxisConfig& config) noexcept;

    const AxisConfig& config() const noexcept { return config_; }
    bool exists() const noexcept { return drive_ != nullptr; }
    double command() const noexcept { return command_; }    // at the start of this tick
    double target() const noexcept { return target_; }      // at its end
    double velocity() const noexcept { return velocity_; }  // of the command over the last tick
    // at the start of the last exchanged tick
    double measured() const noexcept { return loop_.position(); }
    double error() const noexcept { return error_; }
    bool moving() const noexcept { return moving_; }
    bool in_position() const noexcept {
        const double window = config_.servo.in_position * loop_.lag_scale();
        return !moving_ && still_ticks_ > 1 && loop_.owed() <= window && loop_.owed() >= -window &&
               error_ <= window && error_ >= -window;
    }
    bool faulted() const noexcept { return fault_ != Fault::None; }
    Fault fault() const noexcept { return fault_; }
    double fault_value() const noexcept { return fault_value_; }
    void clear_fault() noexcept { fault_ = Fault::None; }
    // What its drive reports while it is off and has been commanded to reset its fault.
    bool drive_fault_stays() const noexcept {
        return polyturn_drive_has_fault(status_.status) || status_.lost > config_.servo.drive_lost;
    }
    // behaviour of its drive, if it is a simulated one
    std::uint16_t simulate = 0;
    bool closed() const noexcept { return closed_; }  // the position loop
    double output_speed() const noexcept { return output_; }
    // The lag after machine on with follow-up (N0514 FUP): travel back to the saved command; 0
    // none. Read once.
    double take_return_path() noexcept;
    // It leads a spindle into a thread, or no more (PositionLoop::tap_with).
    void tap_with(double gain, bool feedforward) noexcept { loop_.tap_with(gain, feedforward); }
    // a slave lags with its master
    void tap_like(const AxisUnit& master) noexcept { loop_.tap_like(master.loop_); }

    bool referenced = false;
    // AN_DETCHA: does not exist until it is attached again
    bool detached = false;
    // measured when the last skip signal came
    double skip = 0;
    // feedforward in rapid is a choice of its own (N0515 FFR)
    bool rapid = false;
    std::uint32_t owner = 0;  // channel (from 1) that moves it now
    // bit 0 at the positive end, bit 1 at the negative end
    std::uint32_t stroke_side = 0;
    Requests requests;

    // Where the axis is to be at the end of this tick. Not called: it stays.
    void move_to(double position) noexcept {
        own_target_ = position;
        target_ = position + added_ + overlay_;
    }
    // Coupled axes (couplings.hpp): what its channel commands, and what a master adds to it.
    void couple(double own_target, double added) noexcept {
        own_target_ = own_target;
        added_ = added;
        target_ = own_target + added + overlay_;
    }
    double added() const noexcept { return added_; }
    // A superposed handwheel: its travel is added behind everything that programs command.
    void overlay(double by) noexcept {
        target_ += by - overlay_;
        overlay_ = by;
    }
    double overlay() const noexcept { return overlay_; }
    // The superposed travel becomes the axis' own: nothing moves.
    void take_overlay() noexcept {
        own_command_ += overlay_;
        own_target_ += overlay_;
        overlay_ = 0;
    }
    // at the start of this tick, without what a master adds
    double own() const noexcept { return own_command_; }
    double own_target() const noexcept { return own_target_; }
    // moved asynchronously: no record moves it
    bool beside = false;
    // at its fixed stop under a torque limit (fixed_stop.cpp)
    bool pressing = false;
    // the limit was taken away: the command goes back to where the slide is
    bool leaves_stop = false;
    // what the move that ended there allowed, thousandths
    std::uint16_t stop_torque = 0;
    double pressed_at = 0;  // where
    // synchronous: only its master may move it
    bool slave = false;
    // it follows the turns of a spindle (spindle_couplings.hpp)
    bool geared = false;
    bool bound() const noexcept { return slave || geared; }
    // What measured errors add behind the command (compensation.hpp), and how fast that changes.
    void compensate(double by, double speed) noexcept {
        compensation_ = by;
        compensation_speed_ = speed;
    }
    double compensation() const noexcept { return compensation_; }
    // What its drive gets in addition to its own loop in the next exchange: a coupled slide goes
    // after its master's deviation (N0522).
    void pull(double speed) noexcept { pull_ = speed; }
    double torque() const noexcept { return status_.torque; }  // thousandths of the rated one
    bool torque_limited() const noexcept { return status_.limited != 0; }
    // Could it go there in this tick within its velocity and acceleration (its own command, without
    // what a master adds)? An emergency brakes harder. After a change of parameters the wider
    // limits hold until take_limits(): what was planned before is still to be driven.
    bool can_reach(double own_target, bool emergency) const noexcept;
    void take_limits() noexcept;
    // Own braking at PT_ESTOP_DEC, away from any path (emergency stop, drive fault). True while it
    // still moves.
    bool brake(double tick_s) noexcept;
    // The machine coordinate of where it is becomes greater by this much.
    void shift(double by) noexcept;
    // since the last call: couplings count from where axes were
    double take_shift() noexcept;
    // The position loop and the drive; ends the tick. `powered`: the machine lets it be closed.
    void exchange(double tick_s, bool powered) noexcept;
    // A tandem slave: its drive gets its master's speed.
    void forward(double speed) noexcept {
        forwarded_ = true;
        output_ = speed;
    }
    // The direct measuring device of a dual loop (N0534): the input of another axis number. Not in
    // the cyclic thread.
    bool open_direct(unsigned number, const AxisConfig& device, double tick_s);
    void* direct_drive() const noexcept { return direct_drive_; }
    EncoderCount& encoder() noexcept { return count_; }
    // its drive has reported its position
    bool answered() const noexcept { return count_.known() && status_.lost == 0; }
    // Zero pulses and marks of the encoder: armed, one that passes is latched.
    void watch_mark(bool on) noexcept { mark_armed_ = on; }
    bool mark_seen(double& machine) const noexcept;  // in the last exchange: where
    void* drive() const noexcept { return drive_; }

private:
    void supervise(double tick_s) noexcept;
    void watch_command() noexcept;
    void set_most() noexcept;
    void widen_limits() noexcept;
    void read_encoder() noexcept;
    [[nodiscard]] std::int64_t pulses(double machine) const noexcept;
    [[nodiscard]] double units(std::int64_t pulses) const noexcept;
    AxisConfig config_;
    const PolyturnDriveApi* api_ = nullptr;
    void* drive_ = nullptr;
    PositionLoop loop_;
    double command_ = 0, target_ = 0, velocity_ = 0;
    double own_command_ = 0, own_target_ = 0, own_velocity_ = 0, added_ = 0, shifted_ = 0,
           overlay_ = 0;
    double error_ = 0, origin_ = 0;
    double pulses_per_unit_ = 1e6;
    // remainder: of the speed command, thousandths of a pulse
    double output_ = 0, remainder_ = 0;
    double compensation_ = 0, compensation_speed_ = 0, pull_ = 0;
    // limit of one tick's travel that planning never exceeds
    double most_in_a_tick_ = 0;
    // mm/s, mm/s2; see can_reach(); infinity: no such limit
    double fastest_ = 0, hardest_ = 0;
    double kept_ = 0, return_path_ = 0, fault_value_ = 0;
    void* direct_drive_ = nullptr;
    double direct_units_ = 0;  // of a pulse of the direct device
    PolyturnDriveStatus direct_status_{};
    EncoderCount count_, direct_count_;
    double uncounted_from_ = 0;  // encoder when it stopped counting
    std::int64_t still_ticks_ = 2;
    double not_on_s_ = 0;  // it should operate and does not
    bool moving_ = false, forwarded_ = false, mark_armed_ = false, not_counting_ = false,
         resets_fault_ = false, limit_waits_ = false;
    // nothing to follow up at the start: command and drive agree
    bool closed_ = true;
    Fault fault_ = Fault::None;
    PolyturnDriveStatus status_{};
};

}  // namespace polyturn::kernel
