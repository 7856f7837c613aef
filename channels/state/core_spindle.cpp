// The spindle that the channel commands: speed, direction, constant surface speed.
#include <cmath>
#include <numbers>

#include "channels/state/core.hpp"
#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::channels {

bool Core::surface_axis_is(int place) {
    path.surface_axis = place;
    if (path.spindle.mode == SpindleModeCode::SurfaceSpeed) mode_changed_ = true;
    return true;
}

int Core::surface_axis() const {
    if (path.surface_axis >= 0) return path.surface_axis;
    const std::uint16_t number = view_->config().surface_speed_axis;
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (number != 0 && view_->axes[i].machine_axis + 1u == number) return static_cast<int>(i);
    return -1;
}

// Machine coordinate of the axis at which the tool is on the turning axis.
double Core::surface_zero(int place) const {
    if (place < 0) return 0.0;
    const auto i = static_cast<std::size_t>(place);
    return path.zero[i] + path.shift[i] + path.wanted[i];
}

bool Core::spindle_speed(double value) {
    SpindleState& s = path.spindle;
    if (s.spindle == 0) return fail(Alarm::SpindleMissing, 'S');
    if (value < 0) return fail(Alarm::NegativeSign, 'S', "S");
    path.named = {};
    (s.mode == SpindleModeCode::SurfaceSpeed ? s.surface_m_min : s.rpm) = value;
    s.commanded = true;
    speed_changed_ = true;
    return true;
}

bool Core::named_spindle(unsigned spindle, double rpm) {
    if (rpm < 0) return fail(Alarm::NegativeSign, 'S', "S");
    if (spindle == path.spindle.spindle && path.spindle.mode == SpindleModeCode::Rpm)
        return spindle_speed(rpm);
    if (!commit_spindle()) return false;  // several in one block
    if (spindle != path.named.spindle)
        path.named = {static_cast<std::uint16_t>(spindle), 0.0, SpindleTurn::Stop};
    path.named.rpm = rpm;
    named_speed_changed_ = true;
    return true;
}

bool Core::spindle_turn(SpindleTurn turn) {
    if (path.named.spindle != 0) {
        path.named.turn = turn;
        named_turn_changed_ = true;
        return true;
    }
    SpindleState& s = path.spindle;
    if (s.spindle == 0) return fail(Alarm::SpindleMissing, 'M');
    s.turn = turn;
    s.commanded = true;
    turn_changed_ = true;
    return true;
}

bool Core::surface_speed(bool on) {
    SpindleState& s = path.spindle;
    const SpindleModeCode mode = on ? SpindleModeCode::SurfaceSpeed : SpindleModeCode::Rpm;
    if (s.mode == mode) return true;
    if (on && s.spindle == 0) return fail(Alarm::SpindleMissing);
    if (on && surface_axis() < 0) return fail(Alarm::SurfaceSpeedAxisMissing);
    if (!on) {
        // The speed that constant surface speed had reached here goes on until an S word.
        const int place = surface_axis();
        const double x = place < 0 ? 0.0 : std::fabs(framed_now()[static_cast<std::size_t>(place)]);
        if (const double rpm = spindle_rpm_at(x); rpm > 0) s.rpm = rpm;
    }
    s.mode = mode;
    mode_changed_ = true;
    return true;
}

bool Core::spindle_least(double rpm) {
    if (path.spindle.spindle == 0) return fail(Alarm::SpindleMissing, 'S');
    path.spindle.least_rpm = rpm;
    limit_changed_ = limit_changed_ || path.spindle.mode == SpindleModeCode::SurfaceSpeed;
    return true;
}

bool Core::spindle_limit(double rpm) {
    if (path.spindle.spindle == 0) return fail(Alarm::SpindleMissing, 'S');
    if (rpm < 0) return fail(Alarm::NegativeSign, 'S', "S");
    path.spindle.limit_rpm = rpm;
    limit_changed_ = true;
    return true;
}

bool Core::spindle_position(double degrees, SpindleApproach approach) {
    return spindle_to(degrees, approach, 0.0);
}

bool Core::spindle_angle(unsigned spindle, double degrees, bool incremental, bool closed,
                         double feed_rpm) {
    position_feed_rpm_ = feed_rpm;
    position_closed_ = closed;
    const SpindleState meant = path.spindle;
    path.spindle.spindle = static_cast<decltype(path.spindle.spindle)>(spindle);
    const bool done = incremental ? spindle_to(path.spindle.angle_deg + degrees,
                                               SpindleApproach::Incremental, degrees)
                                  : spindle_to(degrees, SpindleApproach::Shortest, 0.0);
    // the channel's own spindle goes on turning
    if (spindle != meant.spindle) path.spindle = meant;
    position_feed_rpm_ = 0;
    position_closed_ = false;
    return done;
}

bool Core::spindle_index(double way_deg) {
    return spindle_to(path.spindle.angle_deg + way_deg, SpindleApproach::Incremental, way_deg);
}

bool Core::spindle_unwrapped(double degrees, std::optional<double> way_deg) {
    return spindle_to(degrees, way_deg ? SpindleApproach::Incremental : SpindleApproach::Shortest,
                      way_deg.value_or(0.0), true);
}

bool Core::spindle_to(double degrees, SpindleApproach approach, double way_deg, bool whole_turns) {
    SpindleState& s = path.spindle;
    if (s.spindle == 0) return fail(Alarm::SpindleMissing, 'M');
    s.turn = SpindleTurn::Stop;
    s.commanded = true;
    const double as_told = degrees;
    degrees = std::fmod(degrees, 360.0);
    s.angle_deg = degrees < 0 ? degrees + 360.0 : degrees;
    emitted_ = true;
    Spindle told;
    told.spindle = s.spindle;
    told.mode = SpindleModeCode::Position;
    told.value = whole_turns ? as_told : s.angle_deg;
    told.approach = approach;
    told.way = way_deg;
    told.mode_changed = true;
    told.beside = spindle_positioning_;
    told.feed_rpm = position_feed_rpm_;
    told.needs_loop = position_closed_;
    sink_->spindle(told, at);
    return true;
}

bool Core::frees_axis() const {
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (path.spindle.spindle != 0 &&
            view_->machine.axis(view_->axes[i].machine_axis + 1u).on_spindle ==
                path.spindle.spindle)
            return true;
    return false;
}

bool Core::spindle_watch(bool on, const std::array<double, 4>& values) {
    if (path.spindle.spindle == 0) return on ? fail(Alarm::SpindleMissing, 'G') : true;
    emitted_ = true;
    Spindle told;
    told.spindle = path.spindle.spindle;
    told.mode = on ? SpindleModeCode::Watch : SpindleModeCode::WatchOff;
    told.watch = values;
    told.mode_changed = told.silent = true;
    sink_->spindle(told, at);
    return true;
}

bool Core::couple_spindle(const Spindle& told) {
    emitted_ = true;
    sink_->spindle(told, at);
    return true;
}

bool Core::commit_spindle() {
    if (named_speed_changed_ || named_turn_changed_) {
        Spindle told;
        told.spindle = path.named.spindle;
        told.turn = path.named.turn;
        told.mode = named_turn_changed_ && told.turn == SpindleTurn::Stop ? SpindleModeCode::Off
                                                                          : SpindleModeCode::Rpm;
        told.value = path.named.rpm;
        told.speed_changed = named_speed_changed_;
        told.turn_changed = named_turn_changed_;
        named_speed_changed_ = named_turn_changed_ = false;
        emitted_ = true;
        sink_->spindle(told, at);
    }
    if (!(mode_changed_ || speed_changed_ || turn_changed_ || limit_changed_)) return true;
    const SpindleState& s = path.spindle;
    Spindle told;
    told.spindle = s.spindle;
    told.mode = turn_changed_ && s.turn == SpindleTurn::Stop ? SpindleModeCode::Off : s.mode;
    told.turn = s.turn;
    told.limit = s.limit_rpm;
    told.least = s.least_rpm;
    if (s.mode == SpindleModeCode::SurfaceSpeed) {
        const int place = surface_axis();
        if (s.surface_m_min <= 0 && told.mode != SpindleModeCode::Off)
            return fail(Alarm::SurfaceSpeedNone, 'G');
        told.value = s.surface_m_min;
        told.css_axis = place;
        told.css_zero = surface_zero_told_ = surface_zero(place);
    } else {
        told.value = s.rpm;
    }
    told.mode_changed = mode_changed_;
    told.speed_changed = speed_changed_ || mode_changed_;
    told.turn_changed = turn_changed_;
    told.limit_changed = limit_changed_;
    mode_changed_ = speed_changed_ = turn_changed_ = limit_changed_ = false;
    emitted_ = true;
    sink_->spindle(told, at);
    return true;
}

void Core::refresh_surface_zero() {
    const SpindleState& s = path.spindle;
    if (s.mode != SpindleModeCode::SurfaceSpeed) return;
    const int place = surface_axis();
    if (std::fabs(surface_zero(place) - surface_zero_told_) < 1e-9) return;
    Spindle told;
    told.spindle = s.spindle;
    told.mode = s.mode;
    told.turn = s.turn;
    told.limit = s.limit_rpm;
    told.least = s.least_rpm;
    told.value = s.surface_m_min;
    told.css_axis = place;
    told.css_zero = surface_zero_told_ = surface_zero(place);
    told.mode_changed = told.silent = true;
    emitted_ = true;
    sink_->spindle(told, at);
}

double Core::spindle_rpm_at(double radius_mm) const {
    const SpindleState& s = path.spindle;
    if (s.turn == SpindleTurn::Stop) return 0.0;
    if (s.mode != SpindleModeCode::SurfaceSpeed) return s.rpm;
    if (radius_mm <= 0) return s.limit_rpm;
    const double rpm = s.surface_m_min * 1000.0 / (2.0 * std::numbers::pi * radius_mm);
    return s.limit_rpm > 0 ? std::fmin(rpm, s.limit_rpm) : rpm;
}

bool Core::spindle_ready(Alarm otherwise) {
    const SpindleState& s = path.spindle;
    if (s.spindle == 0) return fail(Alarm::SpindleMissing);
    const bool surface = s.mode == SpindleModeCode::SurfaceSpeed;
    if (s.turn != SpindleTurn::Stop && (surface ? s.surface_m_min : s.rpm) > 0) return true;
    switch (port_->started_by_others(s.spindle)) {
        case Port::Turning::No:
            if (waits_for_spindle_ && otherwise == Alarm::SpindleStopped) break;
            return fail(otherwise);
        case Port::Turning::Watched:
            return true;
        case Port::Turning::Unknown:
            break;
    }
    if (!warned_spindle_) {
        warned_spindle_ = true;
        sink_->alarm({Alarm::SpindleMaybeStopped,
                      {{}, at.line, 0, 0},
                      {static_cast<double>(s.spindle), 0.0},
                      {}},
                     at);
    }
    return true;
}

void Core::tell_control(std::uint32_t bits) {
    control_ = bits;
    signal("CONTROL", control_ | (polls_ ? kControlPolls : 0u));
}

void Core::asks_at(std::uint16_t file, std::uint64_t offset, std::size_t column) {
    const Asked here{file, offset, column, doings_};
    const bool again = here == asked_;
    asked_ = here;
    if (again == polls_) return;
    polls_ = again;
    tell_control(control_);
}

// The spindle turns on in a hold and would cut the thread away under the stopped tool (the
// field's standard; fagor_8037t part 2, 9.6.3: "cannot be interrupted"). Programs of positioning
// axes have no hold of their own.
void Core::taps(bool on) {
    path.tap_floats = on;
    if (at.own_axis < 0)
        signal("CONTROL", on ? control_ | kControlNoHold | kControlOwnSpindleOverride : control_);
}

bool Core::rigid_loop(TapLoop& loop, bool oriented) {
    const params::Table& t = view_->table();
    const unsigned s = path.spindle.spindle;
    if (s == 0 || s > kMaxSpindles) return fail(Alarm::SpindleMissing, 'G');
    loop.orients =
        oriented || params::bit(t, params::n1503_drilling_cycles_config, view_->channel, 1);
    loop.code =
        loop.orients
            ? 0.0
            : static_cast<double>(params::get(t, params::n0823_m_code_for_closing_s_loop, s));
    const bool closes = params::bit(t, params::n0607_spindle_config, s, 2) &&
                        params::get(t, params::n0608_spindle_encoder_counts, s) > 0 &&
                        !params::bit(t, params::n0742_spindle_servo_control, s, 7);
    const bool how =
        loop.orients ? params::bit(t, params::n0607_spindle_config, s, 1) : loop.code > 0;
    return (closes && how) || fail(Alarm::TapNotRigid, 'G', "S" + std::to_string(s));
}

}  // namespace polyturn::channels
