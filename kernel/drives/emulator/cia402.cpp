#include "kernel/drives/emulator/cia402.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::drives {
namespace {
constexpr double kPi = 3.14159265358979323846;
constexpr double kPositionGain = 120.0;  // 1/s, of the drive's own loop (csp)
constexpr double kStopS = 0.15;          // quick stop and fault reaction: from full speed to rest
constexpr double kHomingSpeed = 5.0;     // units/s
constexpr double kRested = 1e-3;         // units/s
constexpr int kSteps = 16;               // of the motor's equation in a cycle
}  // namespace

Cia402::Cia402(const PolyturnDriveSetup& setup)
    : setup_(setup),
      position_(static_cast<double>(setup.start_position) / setup.increments_per_unit *
                (setup.encoder_reversed ? -1.0 : 1.0)),
      slide_(position_) {}

void Cia402::fault(std::uint16_t code) {
    if (state_ == State::Fault || state_ == State::FaultReaction) return;
    error_ = code;
    ramp_ = speed_;
    state_ = state_ == State::Operating || state_ == State::QuickStop ? State::FaultReaction
                                                                      : State::Fault;
}

// Bits 0 switch on, 1 voltage, 2 no quick stop, 3 operation, 7 fault reset.
void Cia402::obey(std::uint16_t control) {
    const bool reset = (control & 0x80) && !(last_control_ & 0x80);
    const bool voltage = control & 0x02, no_stop = control & 0x04, on = control & 0x01,
               operate = control & 0x08;
    switch (state_) {
        case State::FaultReaction:
            if (std::fabs(ramp_) <= kRested) state_ = State::Fault;
            return;
        case State::Fault:
            if (reset && !(simulated_ == POLYTURN_SIMULATE_FAULT ||
                           simulated_ == POLYTURN_SIMULATE_ENCODER_FAULT)) {
                state_ = State::SwitchOnDisabled;
                error_ = 0;
            }
            return;
        case State::SwitchOnDisabled:
            if (voltage && no_stop && !on && !dead_) state_ = State::Ready;
            return;
        case State::Ready:
            if (!voltage || !no_stop)
                state_ = State::SwitchOnDisabled;
            else if (on)
                state_ = State::SwitchedOn;
            return;
        case State::SwitchedOn:
            if (!voltage || !no_stop)
                state_ = State::SwitchOnDisabled;
            else if (!on)
                state_ = State::Ready;
            else if (operate)
                state_ = State::Operating;
            return;
        case State::Operating:
            if (!voltage)
                state_ = State::SwitchOnDisabled;
            else if (!no_stop) {
                state_ = State::QuickStop;
                ramp_ = speed_;
            } else if (!on)
                state_ = State::Ready;
            else if (!operate)
                state_ = State::SwitchedOn;
            return;
        case State::QuickStop:
            if (!voltage || std::fabs(ramp_) <= kRested) state_ = State::SwitchOnDisabled;
            return;
    }
}

std::uint16_t Cia402::status_word() const {
    constexpr std::uint16_t kVoltage = 0x10, kRemote = 0x200;
    std::uint16_t word = kRemote;
    switch (state_) {
        case State::SwitchOnDisabled:
            word |= POLYTURN_DRIVE_SWITCH_ON_DISABLED;
            break;
        case State::Ready:
            word |= POLYTURN_DRIVE_READY | kVoltage;
            break;
        case State::SwitchedOn:
            word |= POLYTURN_DRIVE_SWITCHED_ON | kVoltage;
            break;
        case State::Operating:
            word |= POLYTURN_DRIVE_OPERATING | kVoltage;
            break;
        case State::QuickStop:
            word |= POLYTURN_DRIVE_QUICK_STOPS | kVoltage;
            break;
        case State::FaultReaction:
            word |= POLYTURN_DRIVE_FAULT_REACTION | kVoltage;
            break;
        case State::Fault:
            word |= POLYTURN_DRIVE_FAULT;
            break;
    }
    return homed_ ? word | POLYTURN_DRIVE_HOMED : word;
}

void Cia402::simulate(std::uint16_t what) {
    if (what == simulated_) return;
    simulated_ = what;
    silent_ = what == POLYTURN_SIMULATE_SILENCE;
    dead_ = what == POLYTURN_SIMULATE_DEAD;
    delay_ = (what & 0xFF00u) == POLYTURN_SIMULATE_DELAY ? what & 0xFFu : 0;
    loses_ = (what & 0xFF00u) == POLYTURN_SIMULATE_LOSES ? what & 0xFFu : 0;
    if (what == POLYTURN_SIMULATE_FAULT) fault(kFollowing);
    if (what == POLYTURN_SIMULATE_ENCODER_FAULT) fault(kEncoder);
    if (dead_) fault(kUnderVoltage);
}

std::int64_t Cia402::counts(double position) const {
    return static_cast<std::int64_t>(
        std::floor((setup_.encoder_reversed ? -1.0 : 1.0) * (position + home_shift_) *
                       setup_.increments_per_unit +
                   (setup_.increments_per_unit > 1e5 ? 0.5 : 0.0)));
}

// Zero pulses lie a mark distance apart; a coded scale has another mark between two of them, a
// period further each time.
bool Cia402::find_mark(double from, double to, double& at) const {
    if (setup_.mark_distance <= 0 || from == to) return false;
    const auto place = [&](double k, bool second) {
        const double fixed = setup_.mark_origin + k * setup_.mark_distance;
        return second ? fixed + setup_.mark_distance / 2 +
                            (k + 1) * setup_.mark_distance / setup_.mark_periods
                      : fixed;
    };
    const double k0 = std::floor((std::min(from, to) - setup_.mark_origin) / setup_.mark_distance);
    for (double k = k0 - 1; k <= k0 + 2; ++k)
        for (const bool second : {false, true}) {
            if (second && setup_.mark_periods <= 0) continue;
            const double mark = place(k, second);
            if (to > from ? mark > from && mark <= to : mark < from && mark >= to) {
                at = mark;
                return true;
            }
        }
    return false;
}

// Mode 6: to the next zero pulse; the position counts from there.
double Cia402::homing_speed(const PolyturnDriveCommand& command) {
    const bool start = (command.control & POLYTURN_DRIVE_START_HOMING) &&
                       !(last_control_ & POLYTURN_DRIVE_START_HOMING);
    if (start) {
        homing_ = true;
        homed_ = false;
    }
    if (!(command.control & POLYTURN_DRIVE_START_HOMING)) homing_ = false;
    return homing_ && !homed_ ? kHomingSpeed : 0.0;
}

double Cia402::wanted_speed(const PolyturnDriveCommand& command) {
    const double direction = setup_.motor_reversed ? -1.0 : 1.0;
    if (command.mode != POLYTURN_DRIVE_MODE_POSITION) positioning_ = false;
    if (command.mode != POLYTURN_DRIVE_MODE_HOMING) homing_ = false;
    switch (command.mode) {
        case POLYTURN_DRIVE_MODE_VELOCITY:
            return direction * static_cast<double>(command.target_velocity) * 1e-3 /
                       setup_.increments_per_unit +
                   setup_.drift;
        case POLYTURN_DRIVE_MODE_POSITION: {
            const double target = (setup_.encoder_reversed ? -1.0 : 1.0) *
                                      static_cast<double>(command.target_position) /
                                      setup_.increments_per_unit -
                                  home_shift_;
            const double before = positioning_ ? told_ : target;
            positioning_ = true;
            told_ = target;
            return (target - before) / setup_.tick_s +
                   kPositionGain * (before - (setup_.at_slide ? slide_ : position_));
        }
        case POLYTURN_DRIVE_MODE_HOMING:
            return homing_speed(command);
        default:
            fault(kUnknownMode);
            return 0.0;
    }
}

// v'' = w^2 (wanted - v) - 2 d w v', in small steps; then slide and stop.
void Cia402::turn(double wanted) {
    const double w = 2.0 * kPi * setup_.frequency_hz, h = setup_.tick_s / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const double jerk = w * w * (wanted - speed_) - 2.0 * setup_.damping * w * acceleration_;
        acceleration_ += h * jerk;
        speed_ += h * acceleration_;
        position_ += h * speed_;
    }
    if (setup_.has_stop && position_ >= setup_.stop_at && (speed_ > 0 || wanted > 0)) {
        position_ = setup_.stop_at;
        speed_ = acceleration_ = 0;
    }
    caught_ = caught_ || (setup_.has_hold && position_ > setup_.hold_at);
    if (caught_ && position_ <= setup_.hold_at && (speed_ < 0 || wanted < 0)) {
        position_ = setup_.hold_at;
        speed_ = acceleration_ = 0;
    }
    slide_ = std::clamp(slide_, position_, position_ + setup_.backlash);
}

bool Cia402::cycle(const PolyturnDriveCommand& command, PolyturnDriveStatus& status) {
    simulate(command.simulate);
    obey(command.control);
    double wanted = 0;
    if (state_ == State::Operating) {
        wanted = wanted_speed(command);
        if (setup_.friction > 0 && std::fabs(speed_) < 1e-3 * setup_.friction &&
            std::fabs(wanted) < setup_.friction)
            wanted = 0;
    } else if (state_ == State::QuickStop || state_ == State::FaultReaction) {
        ramp_ -= ramp_ * std::min(1.0, 5.0 * setup_.tick_s / kStopS);
        if (std::fabs(ramp_) <= kRested) ramp_ = 0;
        wanted = ramp_;
    }
    last_control_ = command.control;
    const double before = setup_.at_slide ? slide_ : position_;
    turn(wanted);
    const double seen = setup_.at_slide ? slide_ : position_;
    double mark = 0;
    const bool passed = find_mark(before, seen, mark);
    if (homing_ && !homed_ && passed) {
        home_shift_ = -mark;
        homed_ = true;
    }
    status = {};
    status.status = status_word();
    status.error_code = error_;
    status.brake_open = command.brake_release;
    status.position = counts(seen);
    if (passed && (command.touch_probe & POLYTURN_DRIVE_MARK_ARMED)) {
        status.touch_probe = POLYTURN_DRIVE_MARK_SEEN;
        status.probe_position = counts(mark);
    }
    const double torque = state_ == State::Operating ? 100.0 * (wanted - speed_) : 0.0,
                 limit = command.torque_limit;
    status.torque = static_cast<std::int16_t>(std::clamp(torque, -limit, limit));
    status.limited = std::fabs(torque) >= limit;
    ++count_;
    return !silent_ && !(loses_ && count_ % loses_ == 0);
}

}  // namespace polyturn::drives
