#include "kernel/spindles/spindle_unit.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kPi = 3.14159265358979323846;
// How a main spindle's speed follows its command; no parameter of the machine speaks of it.
constexpr double kFrequencyHz = 15.0, kDamping = 1.0;
constexpr double kDriveLagS = 2.0 * kDamping / (2.0 * kPi * kFrequencyHz);
constexpr std::int32_t kRight = 3, kLeft = 4, kOrient = 19;
constexpr double kSmallestDiameterMm = 1e-3;
constexpr double kSwitchOnS = 1.0;  // a drive that is enabled operates by then
// beyond N0752: so many revolutions without pulse or switch
constexpr double kSearchTurns = 3.0;
// the orientation speed counts as reached within this share of it
constexpr double kApproachBand = 0.05;

double part_of_turn(double turns) noexcept { return turns - std::floor(turns); }
}  // namespace

void* SpindleUnit::open_drive(unsigned number, const SpindleConfig& config, double tick_s,
                              const PolyturnDriveApi& api) {
    PolyturnDriveSetup setup{};
    setup.version = POLYTURN_DRIVE_VERSION;
    setup.number = number;
    setup.tick_s = tick_s;
    setup.increments_per_unit = config.drive_counts;
    setup.frequency_hz = kFrequencyHz;
    setup.damping = kDamping;
    setup.mark_distance = 1.0;  // the switch on the probe input: once a revolution
    return api.open(&setup);
}

void SpindleUnit::open(const SpindleConfig& config, double tick_s, const PolyturnDriveApi& api,
                       void* drive, SimulatedDrive* simulated) {
    config_ = config;
    api_ = &api;
    drive_ = drive;
    simulated_ = simulated;
    observer_.configure(
        tick_s, config.encoder_counts > 0 ? config.encoder_counts : config.drive_counts, tick_s);
    observer_.reset(0);
    status_.status = POLYTURN_DRIVE_SWITCHED_ON;  // until it has said something itself
}

void SpindleUnit::close() {
    if (drive_) api_->close(drive_);
    drive_ = nullptr;
    simulated_ = nullptr;
}

double SpindleUnit::true_speed() const noexcept {
    return simulated_ ? simulated_->true_speed() * 60.0 : measured_speed_;
}
double SpindleUnit::true_angle() const noexcept {
    return simulated_ ? part_of_turn(simulated_->true_position()) * 360.0 : angle_;
}

bool SpindleUnit::at_index() const noexcept {
    if (config_.basic_angle <= 0 || !config_.index_by_code || !closed()) return false;
    const double off = std::remainder(
        from_zero(static_cast<double>(counts_) / config_.encoder_counts), config_.basic_angle);
    return std::fabs(off) <= range().in_position;
}

bool SpindleUnit::at_speed(std::int32_t rotation) const noexcept {
    // its master and their ratio say how it turns, not its own SP_ROT
    if (coupled_) return follows_well_;
    if (rotation != kRight && rotation != kLeft) return true;
    if (mode_ == Mode::Speed && speed_ == 0) return true;
    if (fresh_demand_ || target_ == 0 || (target_ > 0) != (rotation == kRight)) return false;
    if (!has_encoder()) return !ramping();
    return reached() && (!standing() || std::fabs(target_) <= config_.standstill_rpm);
}

double SpindleUnit::feedforward() const noexcept {
    if (coupled_) return 1.0;  // a follower must not lag behind
    if (!config_.feedforward) return 0.0;
    // except in tapping all its moves are rapid
    const bool on = tapping_ ? tap_feedforward_ : config_.feedforward_in_rapid;
    return on ? range().feedforward : 0.0;
}

double SpindleUnit::wanted(const SpindleInput& in) const noexcept {
    const SpindleRange& range = this->range();
    if (in.creep) return in.rotation == kLeft ? -range.creep : range.creep;
    if (in.rotation != kRight && in.rotation != kLeft) return 0.0;
    double rpm = speed_;
    if (mode_ == Mode::SurfaceSpeed) {
        const double diameter =
            std::max(2.0 * std::fabs(in.axis_position - surface_centre_), kSmallestDiameterMm);
        rpm = 1000.0 * surface_speed_ / (kPi * diameter);
    }
    rpm *= in.override_factor;
    if (mode_ == Mode::Speed) rpm = std::min(rpm, speed_most_);
    if (rpm <= 0.0) return 0.0;
    rpm = std::max(rpm, range.speed_min);
    if (mode_ == Mode::SurfaceSpeed) {
        rpm = std::max(rpm, surface_min_);
        if (surface_limit_ > 0) rpm = std::min(rpm, surface_limit_);
    }
    rpm = std::min({rpm, range.speed_max, ceiling_rpm, in.most_rpm});
    return in.rotation == kRight ? rpm : -rpm;
}

bool SpindleUnit::demand_position(double degrees, SpindleApproach how, double feed_rev_s) noexcept {
    wanted_feed_ = feed_rev_s;
    if (closed()) positioner_.limits({position_speed(), range().acceleration, range().jerk});
    in_position_ = false;
    waited_s_ = 0;
    if (how == SpindleApproach::Incremental) {
        if (!closed()) return false;
        positioner_.go(positioner_.target() + degrees / 360.0);
        return true;
    }
    wanted_angle_ = degrees / 360.0;
    wanted_how_ = how;
    if (closed() && config_.search_always && !config_.absolute)
        search_again_ = true;
    else if (closed())
        aim(positioner_.speed() != 0);
    return true;
}

// At rapid N0320, or at a feed, which N0328 holds.
double SpindleUnit::position_speed() const noexcept {
    const double fastest = range().feed_max > 0 ? range().feed_max : range().rapid;
    return wanted_feed_ > 0 ? std::fmin(wanted_feed_, fastest) : range().rapid;
}

void SpindleUnit::aim(bool moving) noexcept {
    const double angle = part_of_turn(wanted_angle_);
    switch (wanted_how_) {
        case SpindleApproach::Positive:
            positioner_.go(positioner_.beyond(angle, true));
            break;
        case SpindleApproach::Negative:
            positioner_.go(positioner_.beyond(angle, false));
            break;
        default:
            positioner_.go(moving ? positioner_.next_in_direction(angle)
                                  : positioner_.nearest(angle));
            break;
    }
}

void SpindleUnit::open_loop() noexcept {
    if (loop_ == Loop::Closed) ramped_ = positioner_.speed() * 60.0;
    loop_ = Loop::Turning;
    in_position_ = interpolating_ = tapping_ = false;
    waited_s_ = 0;
}

void SpindleUnit::close_loop(const SpindleInput& in, bool orient) noexcept {
    const double speed = observer_.speed() / 360.0;
    const double here = from_zero(observer_.angle() / 360.0);
    positioner_.limits(
        {orient ? position_speed() : range().rapid, range().acceleration, range().jerk});
    positioner_.take_over(loop_controller_.close(here, std::fabs(ramped_) > 0 ? speed : 0.0,
                                                 range(), gain(), feedforward()),
                          std::fabs(ramped_) > 0 ? speed : 0.0);
    last_position_ = positioner_.position();
    backlash_ = 0;
    if (orient)
        aim(positioner_.speed() != 0);
    else
        positioner_.stop();
    loop_ = Loop::Closed;
    search_again_ = in_position_ = false;
    waited_s_ = 0;
    target_ = ramped_ = 0;
    (void)in;
}

// What the PLC asks of the position loop, and how far that has come.
void SpindleUnit::follow_request(const SpindleInput& in) noexcept {
    const bool orient = in.rotation == kOrient;
    const bool allowed = config_.can_close && has_encoder() && (!orient || config_.can_orient);
    cannot_orient_ = in.powered && in.close_loop && !config_.loop_stays_open && !allowed;
    const bool wants = in.powered && !in.stop && !in.muted && in.close_loop &&
                       !config_.loop_stays_open && allowed && fault_ == Fault::None;
    if (!wants) {
        if (loop_ != Loop::Turning) open_loop();
        return;
    }
    if (loop_ == Loop::Closed && orient && search_again_ && positioner_.resting()) open_loop();
    if (loop_ == Loop::Turning) {
        loop_ = Loop::Approach;
        in_position_ = false;
        const bool turning = std::fabs(ramped_) > range().orient_speed * (1 + kApproachBand);
        approach_rpm_ = !orient ? 0.0
                        : needs_search() || turning
                            ? std::copysign(range().orient_speed, ramped_ != 0 ? ramped_ : 1.0)
                            : 0.0;
    }
    if (loop_ == Loop::Approach) {
        const bool there =
            ramped_ == approach_rpm_ && std::fabs(observer_.speed() / 6.0 - approach_rpm_) <=
                                            std::max(kApproachBand * std::fabs(approach_rpm_), 1.0);
        if (!there) return;
        if (orient && needs_search()) {
            loop_ = Loop::Searching;
            search_from_ = counts_;
            switch_was_ = true;  // only a rising edge counts
        } else {
            close_loop(in, orient);
        }
    }
}

double SpindleUnit::ramp(double dt) noexcept {
    // The ramp is steeper or flatter as the magnitude grows or falls; through zero it is first the
    // one, then the other.
    const bool grows = std::fabs(target_) > std::fabs(ramped_) && target_ * ramped_ >= 0;
    const double most = std::min(grows ? range().ramp_up : range().ramp_down, ceiling_ramp) * dt;
    ramped_ = target_ > ramped_ + most   ? ramped_ + most
              : target_ < ramped_ - most ? ramped_ - most
                                         : target_;
    return ramped_ / 60.0;
}

double SpindleUnit::closed_speed(const SpindleInput& in) noexcept {
    if (interpolating_)
        positioner_.follow(interpolated_, in.tick_s);
    else {
        // the path has brought it to rest
        if (interpolated_before_) positioner_.take_over(positioner_.position(), 0);
        positioner_.step(in.tick_s);
    }
    interpolated_before_ = interpolating_;
    interpolating_ = false;
    const double position = positioner_.position();
    if (position != last_position_) backlash_ = position > last_position_ ? 0.0 : -range().backlash;
    last_position_ = position;
    // A follower's drive gets in advance what it will lag behind.
    const double ahead = coupled_ ? kDriveLagS * coupled_a_ : 0.0;
    return loop_controller_.output(position + backlash_, in.tick_s, range(), gain(),
                                   feedforward()) +
           ahead;
}

void SpindleUnit::uncouple() noexcept {
    if (!coupled_) return;
    if (loop_ == Loop::Closed) open_loop();
    coupled_ = follows_well_ = false;
}

PathState SpindleUnit::turning_state() const noexcept {
    if (loop_ == Loop::Closed)
        return {positioner_.position() + zero_ + config_.grid_shift, positioner_.speed(), 0};
    return {turns(), std::fabs(ramped_) > 0 ? observer_.speed() / 360.0 : 0.0, 0};
}

void SpindleUnit::step(const SpindleInput& in) noexcept {
    range_ = std::clamp<std::uint32_t>(in.range, 1, kGearRanges);
    muted_ = in.muted;
    if (coupled_ && (!in.powered || in.muted)) uncouple();
    if (coupled_) {
        if (loop_ != Loop::Closed) close_loop(in, false);
        interpolate(from_zero(coupled_to_));
    } else {
        follow_request(in);
    }
    fresh_demand_ = false;
    double rev_s = 0;
    if (loop_ == Loop::Closed) {
        target_ = ramped_ = 0;
        rev_s = closed_speed(in);
    } else {
        target_ = loop_ != Loop::Turning               ? approach_rpm_
                  : in.stop || !in.powered || in.muted ? 0.0
                                                       : wanted(in);
        if (!in.powered) ramped_ = 0;
        rev_s = ramp(in.tick_s);
    }
    const double full = range().calibration / 60.0;
    if (full > 0) rev_s = std::clamp(rev_s, -full, full);  // a drive has no more to give
    rev_s = rev_s * config_.output_scale +
            (in.powered && !in.muted ? config_.output_offset * full : 0.0);
    if (config_.output_inverted) rev_s = -rev_s;
    PolyturnDriveCommand out{};
    out.control = !in.powered || in.muted  ? POLYTURN_DRIVE_SHUTDOWN
                  : fault_ == Fault::Drive ? POLYTURN_DRIVE_FAULT_RESET
                                           : polyturn_drive_next(status_.status, 1);
    out.simulate = simulate;
    const std::uint16_t was = status_.status;
    out.mode = POLYTURN_DRIVE_MODE_VELOCITY;
    out.brake_release = 1;
    out.torque_limit = in.torque_limit;
    out.touch_probe = loop_ == Loop::Searching && config_.orient_by == OrientBy::Probe
                          ? POLYTURN_DRIVE_MARK_ARMED
                          : 0;
    const double exact = rev_s * config_.drive_counts * 1e3 + remainder_;
    out.target_velocity = static_cast<std::int64_t>(std::floor(exact + 0.5));
    remainder_ = exact - static_cast<double>(out.target_velocity);
    api_->exchange(drive_, &out, &status_);
    read_encoder(in, status_);
    const bool wanted_on = in.powered && !in.muted,
               has_fault = polyturn_drive_has_fault(status_.status) != 0;
    const bool encoder = (status_.error_code & 0xFF00u) == 0x7300u;  // CiA 402: sensor
    not_on_s_ = wanted_on && !polyturn_drive_operates(was) && !polyturn_drive_has_fault(was)
                    ? not_on_s_ + in.tick_s
                    : 0.0;
    if (has_fault && !(encoder && (config_.encoder_unwatched || in.unwatched)))
        fault_ = Fault::Drive;
    else if (wanted_on && status_.lost > config_.drive_lost)
        fault_ = Fault::Lost;
    else if (wanted_on && not_on_s_ > kSwitchOnS)
        fault_ = Fault::NotOn;
    else if (fault_ == Fault::Drive && !in.powered)
        fault_ = Fault::None;
    if (coupled_) target_ = positioner_.speed() * 60.0;
    const double command = loop_ == Loop::Closed ? positioner_.speed() * 60.0 : target_;
    const double measured = config_.unsigned_speed ? std::fabs(filtered_speed_) : filtered_speed_;
    watch_.update(config_,
                  loop_ == Loop::Closed && !coupled_ ? 0.0
                  : config_.unsigned_speed           ? std::fabs(command)
                                                     : command,
                  measured, in.tick_s);
    if (loop_ != Loop::Closed) return;
    const double scale = tapping_ && range().tap_gain > 0 ? range().gain / range().tap_gain : 1.0;
    const double at = from_zero(static_cast<double>(counts_) / config_.encoder_counts);
    const auto verdict = loop_controller_.observe(at, in.tick_s, !positioner_.resting(), range(),
                                                  scale, coupled_ ? 0.0 : scale);
    if (verdict != SpindleLoop::Fault::None && fault_ == Fault::None)
        fault_ = verdict == SpindleLoop::Fault::Absolute ? Fault::Absolute
                 : verdict == SpindleLoop::Fault::Moving ? Fault::Moving
                                                         : Fault::Standstill;
    const bool near = std::fabs(loop_controller_.error()) <= range().in_position * scale;
    in_position_ = positioner_.resting() && near;
    waited_s_ = positioner_.resting() && !near ? waited_s_ + in.tick_s : 0.0;
    if (config_.in_position_timeout_s > 0 && waited_s_ > config_.in_position_timeout_s &&
        fault_ == Fault::None)
        fault_ = Fault::NotInPosition;
}

// Counts of the drive to counts of N0608; the zero pulse, or the switch, is met between two of
// them.
void SpindleUnit::read_encoder(const SpindleInput& in, const PolyturnDriveStatus& status) noexcept {
    if (!raw_known_) {
        raw_ = status.position;
        raw_known_ = true;
    }
    const double scale = (config_.drive_counts_fit ? 1.0 : range().multiply / range().divide) *
                         (config_.counts_inverted ? -1.0 : 1.0);
    const double exact = static_cast<double>(status.position - raw_) * scale + count_rest_;
    const double whole = std::floor(exact);
    const std::int64_t before = counts_;
    counts_ += static_cast<std::int64_t>(whole);
    count_rest_ = exact - whole;
    raw_ = status.position;
    observer_.update(counts_);
    measured_speed_ = observer_.speed() / 6.0;  // degrees a second to revolutions a minute
    if (!has_encoder()) measured_speed_ = ramped_;
    filtered_speed_ +=
        (measured_speed_ - filtered_speed_) *
        (config_.speed_filter_s > 0 ? 1.0 - std::exp(-in.tick_s / config_.speed_filter_s) : 1.0);
    angle_ = part_of_turn(observer_.angle() / 360.0) * 360.0;
    if (loop_ != Loop::Searching) return;
    waited_s_ += in.tick_s;
    const double turn_s = range().orient_speed > 0 ? 60.0 / range().orient_speed : 0.0;
    if (config_.in_position_timeout_s > 0 &&
        waited_s_ > config_.in_position_timeout_s + kSearchTurns * turn_s)
        fault_ = Fault::NotOriented;
    bool found = false;
    switch (config_.orient_by) {
        case OrientBy::ZeroPulse: {
            const auto turns = [&](std::int64_t counts) {
                return std::floor(static_cast<double>(counts) / config_.encoder_counts);
            };
            const double now = turns(counts_), then = turns(before);
            // Downwards the pulse is met when its own count is left.
            if ((found = now != then)) zero_ = std::max(now, then);
            break;
        }
        case OrientBy::Switch:
            found = in.orient_switch && !switch_was_;
            switch_was_ = in.orient_switch;
            if (found) zero_ = static_cast<double>(counts_) / config_.encoder_counts;
            break;
        case OrientBy::Probe:
            found = (status.touch_probe & POLYTURN_DRIVE_MARK_SEEN) != 0;
            if (found)
                zero_ = (static_cast<double>(counts_) +
                         static_cast<double>(status.probe_position - status.position) * scale) /
                        config_.encoder_counts;
            break;
    }
    if (!found) return;
    zero_known_ = true;
    close_loop(in, true);
}

}  // namespace polyturn::kernel
