#include "kernel/axes/axis_unit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polyturn::kernel {
namespace {
constexpr double kIncrementsPerUnit = 1e6;  // nct_parameters_part1 3.3: 1e-6 mm or degree
constexpr double kNoDriveStop = 999'999.0;  // PT_DRIVE_STOP
constexpr double kSwitchOnS = 1.0;          // a drive that is commanded to operate does so by then
constexpr std::uint16_t kEncoderErrors = 0x7300, kEncoderErrorMask = 0xFF00;  // CiA 402: sensor
}  // namespace

bool AxisUnit::open(unsigned number, const AxisConfig& config, double tick_s, double start,
                    const PolyturnDriveApi& api) {
    config_ = config;
    set_most();
    take_limits();
    api_ = &api;
    const ServoConfig& servo = config.servo;
    const ReferenceConfig& reference = config.reference;
    pulses_per_unit_ = kIncrementsPerUnit * static_cast<double>(servo.divide) /
                       static_cast<double>(servo.multiply);
    PolyturnDriveSetup setup{};
    setup.version = POLYTURN_DRIVE_VERSION;
    setup.number = number;
    setup.tick_s = tick_s;
    setup.increments_per_unit = pulses_per_unit_;
    origin_ = reference.absolute_origin();  // raw - N0907 + N0200 (10.2 E)
    setup.start_position =
        std::llround((start - origin_) * pulses_per_unit_ * (servo.input_inverted ? -1.0 : 1.0));
    setup.frequency_hz = servo.drive_hz;
    setup.damping = servo.drive_damping;
    setup.backlash = servo.drive_backlash;
    setup.friction = servo.drive_friction;
    setup.drift = servo.drive_drift;
    setup.at_slide = servo.drive_scale;
    setup.has_stop = servo.drive_stop < kNoDriveStop;
    setup.stop_at = servo.drive_stop;
    setup.has_hold = servo.drive_held > -kNoDriveStop;
    setup.hold_at = servo.drive_held;
    setup.motor_reversed = servo.output_inverted;
    setup.encoder_reversed = servo.input_inverted;
    // A simulated machine is built so that referencing it finds the coordinates that it has: its
    // marks count from there.
    setup.mark_distance = reference.by_pulse || reference.coded ? reference.pulse_distance : 0.0;
    setup.mark_periods = reference.coded ? reference.periods : 0.0;
    setup.mark_origin = reference.coded ? reference.position : reference.position - reference.shift;
    drive_ = api.open(&setup);
    count_.begin(reference.encoder_bits, reference.keeps_rounds, reference.rounds,
                 pulses(reference.position));
    command_ = target_ = own_command_ = own_target_ = start;
    loop_.configure(servo, tick_s);
    loop_.reset(start);
    status_.status = POLYTURN_DRIVE_SWITCHED_ON;  // until it has said something itself
    return drive_ != nullptr;
}

void AxisUnit::configure(const AxisConfig& config) noexcept {
    config_ = config;
    set_most();
    widen_limits();
    if (!drive_) return;
    // A full scale (N0505) that begins to limit acts from standstill: what moves now was planned
    // without it.
    ServoConfig servo = config.servo;
    limit_waits_ = moving_;
    if (moving_) servo.full_speed = 0;
    loop_.configure(servo, config.tick_s);
}

bool AxisUnit::open_direct(unsigned number, const AxisConfig& device, double tick_s) {
    PolyturnDriveSetup setup{};
    setup.version = POLYTURN_DRIVE_VERSION;
    setup.number = number;
    setup.tick_s = tick_s;
    setup.increments_per_unit = kIncrementsPerUnit * static_cast<double>(device.servo.divide) /
                                static_cast<double>(device.servo.multiply);
    setup.start_position = std::llround(command_ * setup.increments_per_unit);
    setup.frequency_hz = device.servo.drive_hz;
    setup.damping = device.servo.drive_damping;
    direct_drive_ = api_->open(&setup);
    direct_count_.begin(device.reference.encoder_bits, device.reference.keeps_rounds,
                        device.reference.rounds, setup.start_position);
    direct_units_ = (device.servo.input_inverted ? -1.0 : 1.0) / setup.increments_per_unit;
    return direct_drive_ != nullptr;
}

void AxisUnit::close() {
    if (drive_) api_->close(drive_);
    if (direct_drive_) api_->close(direct_drive_);
    drive_ = direct_drive_ = nullptr;
}

bool AxisUnit::brake(double tick_s) noexcept {
    const double step = config_.estop_deceleration * tick_s;
    double v = own_velocity_;
    v = v > step ? v - step : v < -step ? v + step : 0.0;
    move_to(own_command_ + v * tick_s);
    return v != 0.0;
}

void AxisUnit::shift(double by) noexcept {
    origin_ += by;
    command_ += by;
    target_ += by;
    own_command_ += by;
    own_target_ += by;
    kept_ += by;
    shifted_ += by;
    loop_.shift(by);
}

double AxisUnit::take_shift() noexcept {
    const double by = shifted_;
    shifted_ = 0;
    return by;
}

double AxisUnit::take_return_path() noexcept {
    const double way = return_path_;
    return_path_ = 0;
    return way;
}

// pulses x M / D millionths of a unit; the whole part exact in 128 bits, so that nothing drifts
// however far it travels (7.3).
double AxisUnit::units(std::int64_t pulses) const noexcept {
    __extension__ using Wide = __int128;
    const Wide product = static_cast<Wide>(pulses) * config_.servo.multiply;
    const auto whole = static_cast<std::int64_t>(product / config_.servo.divide);
    const auto rest =
        static_cast<double>(static_cast<std::int64_t>(product % config_.servo.divide)) /
        static_cast<double>(config_.servo.divide);
    const double increments = static_cast<double>(whole) + rest;
    return (config_.servo.input_inverted ? -increments : increments) / kIncrementsPerUnit;
}

// The encoder's pulses at a machine coordinate: units() backwards, to the nearest one.
std::int64_t AxisUnit::pulses(double machine) const noexcept {
    const double count = (machine - origin_) * pulses_per_unit_;
    return std::llround(config_.servo.input_inverted ? -count : count);
}

bool AxisUnit::mark_seen(double& machine) const noexcept {
    if (!(status_.touch_probe & POLYTURN_DRIVE_MARK_SEEN)) return false;
    machine = units(status_.probe_position) + origin_;
    return true;
}

// What the drive has just reported. An absolute encoder of few bits may at first be in another turn
// than the one in which the axis was assumed to be: then it is where the encoder says, and nothing
// moves.
void AxisUnit::read_encoder() noexcept {
    const bool first = count_.limited() && !count_.known();
    if (!count_.known() && status_.lost != 0) return;  // no answer yet
    const double here = units(count_.take(status_.position)) + origin_ - compensation_;
    if (!first ||
        std::fabs(here - command_) * pulses_per_unit_ < static_cast<double>(count_.range()) / 4)
        return;
    command_ = target_ = here;
    own_command_ = own_target_ = here - added_ - overlay_;
    loop_.reset(here);
}

void AxisUnit::exchange(double tick_s, bool powered) noexcept {
    const bool closes = powered && !requests.open && !config_.servo.open && !detached;
    if (closes && !closed_) {
        // Follow-up: off, closing the loop moves nothing; on, the axis goes back to where it was
        // commanded (7.4).
        const bool back = config_.servo.follow_up || requests.follow_up;
        if (back) return_path_ = kept_ - loop_.position();
        command_ = target_ = loop_.position();
        own_command_ = own_target_ = command_ - added_ - overlay_;
        loop_.reset(command_);
        velocity_ = own_velocity_ = 0;
    }
    if (!closes && closed_) {
        kept_ = command_;
        uncounted_from_ = units(count_.full());
    }
    closed_ = closes;
    if (!closes) {
        target_ = command_;
        own_target_ = own_command_;
    } else
        watch_command();
    const double v = (target_ - command_) / tick_s;
    if (!forwarded_)
        output_ = closes ? loop_.speed(target_, rapid) + compensation_speed_ + pull_ : 0.0;
    pull_ = 0;
    const bool enabled = forwarded_ ? powered && !detached : closes;
    forwarded_ = false;
    PolyturnDriveCommand out{};
    out.control = polyturn_drive_next(status_.status, enabled && !faulted());
    // A reset is an edge: given again and again, as long as the drive keeps its fault.
    const bool drive_fault = polyturn_drive_has_fault(status_.status) != 0;
    resets_fault_ = drive_fault && !faulted() && !resets_fault_;
    if (resets_fault_)
        out.control = POLYTURN_DRIVE_FAULT_RESET;
    else if (drive_fault)
        out.control = POLYTURN_DRIVE_SHUTDOWN;
    out.mode =
        config_.servo.position_mode ? POLYTURN_DRIVE_MODE_POSITION : POLYTURN_DRIVE_MODE_VELOCITY;
    // The drive's own count, which may be a part of ours.
    const std::int64_t rounds_off = count_.limited() ? count_.full() - status_.position : 0;
    out.target_position = closes && (count_.known() || !count_.limited())
                              ? pulses(target_ - loop_.owed() + compensation_) - rounds_off
                              : status_.position;
    out.simulate = simulate;
    const std::uint16_t was = status_.status;
    out.brake_release = enabled;
    out.torque_limit = requests.torque_limit ? requests.torque_limit : 1000;
    out.touch_probe = mark_armed_ ? POLYTURN_DRIVE_MARK_ARMED : 0;
    const double exact =
        (config_.servo.output_inverted ? -output_ : output_) * pulses_per_unit_ * 1e3 + remainder_;
    out.target_velocity = static_cast<std::int64_t>(std::floor(exact + 0.5));
    remainder_ = exact - static_cast<double>(out.target_velocity);
    if (direct_drive_) {
        PolyturnDriveCommand nothing{};
        nothing.control = POLYTURN_DRIVE_SHUTDOWN;
        api_->exchange(direct_drive_, &nothing, &direct_status_);
    }
    api_->exchange(drive_, &out, &status_);
    read_encoder();
    const double encoder = units(count_.full());
    if (closes) {
        const double offset = origin_ - compensation_;
        if (direct_drive_)
            loop_.measured_direct(
                encoder + offset,
                static_cast<double>(direct_count_.take(direct_status_.position)) * direct_units_ +
                    offset);
        else
            loop_.measured(encoder + offset);
        error_ = loop_.error();
    } else {
        // Pulses of an open loop belong to the axis, unless its encoder serves another axis at
        // present (EFD).
        if (config_.servo.no_count_open || requests.no_count) origin_ -= encoder - uncounted_from_;
        uncounted_from_ = encoder;
        loop_.reset(encoder + origin_ - compensation_);
        // Switched off, the command waits for the machine to be switched on; an open loop never has
        // one.
        if (requests.open || config_.servo.open || detached) {
            command_ = target_ = encoder + origin_ - compensation_;
            own_command_ = own_target_ = command_ - added_ - overlay_;
        }
        error_ = 0;
    }
    moving_ = target_ != command_;
    if (limit_waits_ && in_position()) {
        loop_.configure(config_.servo, tick_s);
        limit_waits_ = false;
    }
    still_ticks_ = moving_ ? 0 : still_ticks_ + 1;
    velocity_ = closes ? v : 0.0;
    command_ = target_;
    own_velocity_ = (own_target_ - own_command_) / tick_s;
    own_command_ = own_target_;
    not_on_s_ = closes && !polyturn_drive_operates(was) && !polyturn_drive_has_fault(was)
                    ? not_on_s_ + tick_s
                    : 0.0;
    if (closes) supervise(tick_s);
}

// The last check in front of the drive. Whatever went wrong before it (a path that does not begin
// at the axis' position, a fault in a transformation): a command that is far beyond what the axis
// can do in a tick is not passed on. The axis brakes by itself, and the machine stops. Planned
// motion keeps the axis' own limits (can_reach), of a coupled axis those of its drive; the factor
// of four leaves a margin for added motion.
void AxisUnit::watch_command() noexcept {
    // and remains stopped until the fault is cleared
    const bool brakes = fault_ == Fault::CommandJump;
    if (!brakes && std::fabs(target_ - command_) <= most_in_a_tick_) return;
    if (!faulted()) {
        fault_ = Fault::CommandJump;
        fault_value_ = target_ - command_;
    }
    const double step = config_.estop_deceleration * config_.tick_s;
    const double v = velocity_ > step    ? velocity_ - step
                     : velocity_ < -step ? velocity_ + step
                                         : 0.0;
    target_ = command_ + v * config_.tick_s;
    own_target_ = target_ - added_ - overlay_;
}

bool AxisUnit::can_reach(double own_target, bool emergency) const noexcept {
    // rounding of geometry, and of speeds that are computed from it
    constexpr double kMore = 1.02;
    constexpr double kMeet = 2e-6;  // mm, degrees: by which two records may meet apart
    const double dt = config_.tick_s, v = (own_target - own_command_) / dt,
                 a = (v - own_velocity_) / dt;
    const double most = hardest_ + (emergency ? config_.estop_deceleration : 0.0);
    return std::fabs(v) <= kMore * fastest_ + kMeet / dt &&
           std::fabs(a) <= kMore * most + kMeet / (dt * dt);
}

void AxisUnit::take_limits() noexcept {
    fastest_ = hardest_ = 0;
    widen_limits();
}

void AxisUnit::widen_limits() noexcept {
    const double fastest =
        std::max({config_.rapid, config_.max_feed, config_.manual_rapid, config_.jog_max_feed});
    fastest_ = fastest > 0 ? std::max(fastest_, fastest) : std::numeric_limits<double>::infinity();
    hardest_ = config_.acceleration > 0
                   ? std::max({hardest_, config_.acceleration, config_.normal_acceleration})
                   : std::numeric_limits<double>::infinity();
}

void AxisUnit::set_most() noexcept {
    constexpr double kTimes = 4, kLeast = 0.05;  // mm or degrees: smoothed ends of short moves
    const double fastest =
        std::max({config_.rapid, config_.max_feed, config_.manual_rapid, config_.jog_max_feed});
    most_in_a_tick_ = fastest > 0 ? kTimes * fastest * config_.tick_s + kLeast
                                  : std::numeric_limits<double>::infinity();
}

void AxisUnit::supervise(double tick_s) noexcept {
    if (status_.lost > config_.servo.drive_lost) {
        fault_ = Fault::Lost;
        fault_value_ = status_.lost;
    }
    if (!faulted() && not_on_s_ > kSwitchOnS + tick_s) {
        fault_ = Fault::NotOn;
        fault_value_ = status_.status;
    }
    if (polyturn_drive_has_fault(status_.status)) {
        const bool encoder = (status_.error_code & kEncoderErrorMask) == kEncoderErrors;
        if (!(encoder && (config_.servo.encoder_unwatched || requests.unwatched)))
            fault_ = Fault::Drive;
    }
    const ServoConfig& servo = config_.servo;
    if (requests.seeks_stop && !faulted() && !pressing && servo.error_seeking > 0 &&
        std::fabs(error_) > servo.error_seeking) {
        fault_ = Fault::FollowingError;
        fault_value_ = error_;
        return;
    }
    // a drive that may not push lags as it must
    if (faulted() || pressing || leaves_stop || requests.torque_limit != 0) return;
    const double following = std::fabs(error_), model = std::fabs(loop_.model_error());
    if (not_on_s_ > 0) return;  // nothing holds it yet
    const auto fault = [&](Fault kind, double value) {
        fault_ = kind;
        fault_value_ = value;
    };
    if (servo.error_absolute > 0 && following > servo.error_absolute * loop_.lag_scale())
        return fault(Fault::FollowingError, error_);
    if (loop_.dual_differs()) return fault(Fault::DualDifference, loop_.model_error());
    if (loop_.standing() && servo.error_standing > 0 && model > servo.error_standing)
        return fault(Fault::StandstillError, loop_.model_error());
    if (!loop_.standing() && servo.error_moving > 0 && model > servo.error_moving)
        return fault(Fault::ModelError, loop_.model_error());
}

}  // namespace polyturn::kernel
