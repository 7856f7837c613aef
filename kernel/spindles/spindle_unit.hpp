// One spindle: its commanding channel, commanded speed, ramps, position loop, and the drive with
// its encoder.
//
//   S or surface speed -> x override -> limits of the gear range -> limit of G96
//                                                      -> sign from SP_ROT -> ramp -> drive
// (nct_parameters_part1 8.6). The PLC decides whether and in which direction it turns (SP_ROT 3, 4,
// 5), programs only the speed.
//
//   Turning ---SP_OREQ---> Approach ----------------------> Closed     SP_OREQ gone: Turning
//                 |          | M19 and the zero pulse unknown  ^       again, at its speed
//                 |          '--> Searching ---zero pulse------'
//                 '--at standstill, nothing to search----------'
// M19 (SP_ROT 19): approach at N0801, then to zero pulse + N0684 + the angle that the program
// wants. Any other code with SP_OREQ (N0823): brake, and close the loop at that position.
#pragma once
#include <cstdint>

#include "ipc/image/enums.hpp"
#include "kernel/config/spindle_config.hpp"
#include "kernel/drives/simulated_drive.hpp"
#include "kernel/motion/spindle_observer.hpp"
#include "kernel/motion/spindle_positioner.hpp"
#include "kernel/spindles/spindle_loop.hpp"
#include "kernel/spindles/spindle_watch.hpp"

namespace polyturn::kernel {

// A tick's command to the spindle. rotation: SP_ROT (0 like 5).
struct SpindleInput {
    double tick_s = 0.001;
    std::int32_t rotation = 0;
    std::uint32_t range = 1;     // 1 to 8
    bool close_loop = false;     // SP_OREQ
    bool creep = false;          // SP_PAR
    bool orient_switch = false;  // SP_OSW
    bool muted = false;          // the drive is in use elsewhere, or it is detached
    double override_factor = 1;
    double most_rpm = std::numeric_limits<double>::infinity();  // setup mode
    double axis_position = 0;            // of the axis that surface speed follows
    bool powered = false, stop = false;  // stop: brake whatever is said
    bool unwatched = false;              // SP_SEND
    std::uint16_t torque_limit = 1000;   // SP_TORQ, thousandths
};

class SpindleUnit {
public:
    enum class Mode : std::uint8_t { Speed, SurfaceSpeed };
    enum class Loop : std::uint8_t { Turning, Approach, Searching, Closed };
    enum class Fault : std::uint8_t {
        None,
        Drive,
        Standstill,
        Moving,
        Absolute,
        NotOriented,
        NotInPosition,
        Lost,
        NotOn
    };

    // Not in the cyclic thread. The drive is opened by the caller; `simulated` is what is
    // behind it (truth for the trace).
    void open(const SpindleConfig& config, double tick_s, const PolyturnDriveApi& api, void* drive,
              SimulatedDrive* simulated);
    static void* open_drive(unsigned number, const SpindleConfig& config, double tick_s,
                            const PolyturnDriveApi& api);
    void close();
    void configure(const SpindleConfig& config) noexcept { config_ = config; }

    const SpindleConfig& config() const noexcept { return config_; }
    const SpindleRange& range() const noexcept { return config_.range[range_ - 1]; }
    std::uint32_t range_number() const noexcept { return range_; }
    bool exists() const noexcept { return drive_ != nullptr; }
    SimulatedDrive* simulated() const noexcept { return simulated_; }

    // What a program demands.
    void demand_speed(double rpm, double most = std::numeric_limits<double>::infinity()) noexcept {
        mode_ = Mode::Speed;
        speed_ = rpm;
        speed_most_ = most;
        fresh_demand_ = true;
    }
    void demand_surface_speed(double m_min, double limit_rpm, double min_rpm, std::uint32_t axis,
                              double centre) noexcept {
        mode_ = Mode::SurfaceSpeed;
        fresh_demand_ = true;
        surface_speed_ = m_min;
        surface_limit_ = limit_rpm;
        surface_min_ = min_rpm;
        surface_axis_ = axis;
        surface_centre_ = centre;
    }
    void limit_surface_speed(double rpm) noexcept { surface_limit_ = rpm; }
    // An angle in degrees from zero pulse + grid shift, or a travel in degrees. A loop that is open
    // takes an angle as the target of its orientation; false: only a closed loop can take a travel.
    bool demand_position(double degrees, SpindleApproach how, double feed_rev_s = 0) noexcept;
    void watch_fluctuation(bool on, double time_s, double start_percent, double percent,
                           double rpm) noexcept {
        watch_.fluctuation(on, time_s, start_percent, percent, rpm);
    }
    Mode mode() const noexcept { return mode_; }
    std::uint32_t surface_axis() const noexcept { return surface_axis_; }  // from 0
    // The position that counts for that axis: its actual one, unless a rapid move holds the speed
    // (Machine::surface_position).
    double surface_position = 0;
    bool demanded_anew() const noexcept { return fresh_demand_; }
    double surface_centre() const noexcept { return surface_centre_; }

    void step(const SpindleInput& in) noexcept;

    // 1/min with sign, after limits, before the ramp
    double command() const noexcept { return target_; }
    double speed() const noexcept { return measured_speed_; }        // 1/min with sign
    double shown_speed() const noexcept { return filtered_speed_; }  // through N0610
    // degrees now, estimated, 0..360; from zero once it is known
    double angle() const noexcept { return angle_; }
    const SpindleObserver& observer() const noexcept { return observer_; }
    double true_speed() const noexcept;  // simulated drive: behind the encoder
    double true_angle() const noexcept;
    bool reached() const noexcept { return watch_.reached(); }
    bool standing() const noexcept {
        return config_.encoder_counts > 0 ? watch_.standing() : ramped_ == 0.0;
    }
    bool fluctuates() const noexcept { return watch_.fluctuates(); }
    // It turns as demanded under this SP_ROT, or is not meant to turn.
    bool at_speed(std::int32_t rotation) const noexcept;
    bool ramping() const noexcept { return ramped_ != target_; }
    bool has_encoder() const noexcept { return config_.encoder_counts > 0; }
    const SpindleWatch& watch() const noexcept { return watch_; }
    bool settled() const noexcept {
        return coupled_ ? follows_well_
               : loop_ == Loop::Closed
                   ? positioner_.resting() && (in_position_ || fault_ != Fault::None)
                   : loop_ == Loop::Turning && ramped_ == target_;
    }
    Loop loop() const noexcept { return loop_; }
    bool closed() const noexcept { return loop_ == Loop::Closed; }
    bool in_position() const noexcept { return in_position_; }
    bool at_index() const noexcept;  // SN_SINDP
    // closed: commanded, revolutions
    double position() const noexcept { return positioner_.position(); }
    bool may_lend_drive() const noexcept {
        return loop_ == Loop::Turning && target_ == 0 && ramped_ == 0 && standing() &&
               measured_speed_ < kLendRpm && measured_speed_ > -kLendRpm;
    }
    bool cannot_orient() const noexcept { return cannot_orient_; }
    Fault fault() const noexcept { return fault_; }
    double error() const noexcept { return loop_controller_.error(); }  // revolutions
    std::uint16_t status_word() const noexcept { return status_.status; }
    // cycles without an answer
    std::uint16_t lost() const noexcept { return status_.lost; }
    void clear_fault() noexcept { fault_ = Fault::None; }

    // Interpolated with axes (rigid tapping): where it must be at this tick's end, revolutions.
    void interpolate(double revolutions) noexcept {
        interpolated_ = revolutions;
        interpolating_ = true;
    }
    void tapping(bool on, bool feedforward) noexcept {
        tapping_ = on;
        tap_feedforward_ = feedforward;
    }

    // Following another spindle (spindle_couplings.hpp): where it must be at this tick's end, by
    // its encoder over all revolutions. The loop closes on the running spindle; uncoupled, it goes
    // on at its present speed, as commanded.
    void couple(const PathState& at, bool well) noexcept {
        coupled_to_ = at.s;
        coupled_a_ = at.a;
        coupled_ = true;
        follows_well_ = well;
    }
    void uncouple() noexcept;
    bool coupled() const noexcept { return coupled_; }
    bool follows_well() const noexcept { return coupled_ && follows_well_; }
    bool may_follow() const noexcept {
        return exists() && has_encoder() && config_.can_close && !muted_ && fault_ == Fault::None &&
               loop_ != Loop::Searching;
    }
    double turns() const noexcept { return observer_.angle() / 360.0; }
    // a zero pulse
    double zero_turns() const noexcept {
        return config_.orient_by == OrientBy::ZeroPulse || config_.absolute ? 0.0 : zero_;
    }
    PathState turning_state() const noexcept;

    // what its followers can do: speed, and ramp in 1/min per s
    double ceiling_rpm = std::numeric_limits<double>::infinity();
    double ceiling_ramp = std::numeric_limits<double>::infinity();
    double override_factor = 1.0;
    std::uint16_t simulate = 0;    // behaviour of its drive, if it is a simulated one
    std::uint32_t owner = 0;       // channel that commands it
    std::uint32_t locked_by = 0;   // channel whose G96, thread or tap needs it; 0 none
    bool override_locked = false;  // in a thread (N0607 TOE)

private:
    static constexpr double kLendRpm = 0.5;
    double wanted(const SpindleInput& in) const noexcept;
    void follow_request(const SpindleInput& in) noexcept;
    void close_loop(const SpindleInput& in, bool orient) noexcept;
    void open_loop() noexcept;
    void aim(bool moving) noexcept;
    double position_speed() const noexcept;  // rev/s
    double ramp(double dt) noexcept;
    double closed_speed(const SpindleInput& in) noexcept;
    void read_encoder(const SpindleInput& in, const PolyturnDriveStatus& status) noexcept;
    bool needs_search() const noexcept {
        return !config_.absolute && (!zero_known_ || search_again_);
    }
    double gain() const noexcept { return tapping_ ? range().tap_gain : range().gain; }
    double feedforward() const noexcept;
    double from_zero(double revolutions) const noexcept {
        return revolutions - zero_ - config_.grid_shift;
    }

    SpindleConfig config_;
    const PolyturnDriveApi* api_ = nullptr;
    void* drive_ = nullptr;
    SimulatedDrive* simulated_ = nullptr;
    Mode mode_ = Mode::Speed;
    std::uint32_t range_ = 1;
    // of speed_ with the override on it
    double speed_most_ = std::numeric_limits<double>::infinity();
    double speed_ = 0, surface_speed_ = 0, surface_limit_ = 0, surface_min_ = 0,
           surface_centre_ = 0;
    std::uint32_t surface_axis_ = 0;
    double target_ = 0, ramped_ = 0, remainder_ = 0;
    double measured_speed_ = 0, filtered_speed_ = 0, angle_ = 0;
    // asked after the exchange: what it calls now is the start of the next tick
    SpindleObserver observer_;
    SpindleWatch watch_;
    // encoder
    std::int64_t raw_ = 0, counts_ = 0;  // of the drive; scaled to N0608, over all revolutions
    double count_rest_ = 0;
    bool raw_known_ = false;
    // position
    Loop loop_ = Loop::Turning;
    SpindleLoop loop_controller_;
    SpindlePositioner positioner_;
    // revolutions of the zero pulse (or switch) by the encoder
    double zero_ = 0;
    double wanted_angle_ = 0;  // revolutions, where M19 goes
    SpindleApproach wanted_how_ = SpindleApproach::Shortest;
    double wanted_feed_ = 0;  // rev/s; 0: in rapid
    double approach_rpm_ = 0, waited_s_ = 0, backlash_ = 0, last_position_ = 0;
    double interpolated_ = 0, coupled_to_ = 0, coupled_a_ = 0;
    bool coupled_ = false, follows_well_ = false, muted_ = false;
    bool zero_known_ = false, search_again_ = false, in_position_ = false, cannot_orient_ = false;
    bool fresh_demand_ = false;  // what target_ says is older than what is demanded
    bool interpolating_ = false, interpolated_before_ = false, tapping_ = false,
         tap_feedforward_ = false, switch_was_ = false, probe_armed_ = false;
    std::int64_t search_from_ = 0;
    Fault fault_ = Fault::None;
    PolyturnDriveStatus status_{};
    double not_on_s_ = 0;  // it should operate and does not
};

}  // namespace polyturn::kernel
