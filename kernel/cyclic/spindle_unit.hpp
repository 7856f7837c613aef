// One spindle: who commands it, how fast it is to turn, its ramps, and the drive with its encoder behind it.
//
//   S or surface speed -> x override -> limits of the gear range -> limit of G96 -> sign from SP_ROT -> ramp -> drive
// (nct_parameters_part1 8.6). The PLC decides whether and which way it turns (SP_ROT 3, 4, 5), programs only how fast.
#pragma once
#include <cstdint>

#include "kernel/config/kernel_config.hpp"
#include "kernel/drives/simulated_drive.hpp"
#include "kernel/motion/spindle_observer.hpp"

namespace polyturn::kernel {

class SpindleUnit {
public:
    enum class Mode : std::uint8_t { Speed, SurfaceSpeed };

    // Not in the cyclic thread.
    bool open(unsigned number, const SpindleConfig& config, double tick_s);
    void close();
    void configure(const SpindleConfig& config) noexcept { config_ = config; }

    const SpindleConfig& config() const noexcept { return config_; }
    bool exists() const noexcept { return drive_ != nullptr; }

    // What a program demands.
    void demand_speed(double rpm) noexcept { mode_ = Mode::Speed, speed_ = rpm; }
    void demand_surface_speed(double m_min, double limit_rpm, double min_rpm, std::uint32_t axis, double centre) noexcept {
        mode_ = Mode::SurfaceSpeed, surface_speed_ = m_min, surface_limit_ = limit_rpm, surface_min_ = min_rpm, surface_axis_ = axis, surface_centre_ = centre;
    }
    void limit_surface_speed(double rpm) noexcept { surface_limit_ = rpm; }
    Mode mode() const noexcept { return mode_; }
    std::uint32_t surface_axis() const noexcept { return surface_axis_; }  // from 0
    double surface_centre() const noexcept { return surface_centre_; }

    // One tick. rotation: SP_ROT (0 like 5); axis_position of the axis that surface speed follows; stop: brake whatever is said.
    void step(double tick_s, std::int32_t rotation, double override_factor, double axis_position, bool powered, bool stop) noexcept;

    double command() const noexcept { return target_; }       // 1/min with sign, after limits, before the ramp
    double speed() const noexcept { return measured_speed_; } // 1/min with sign
    double angle() const noexcept { return angle_; }          // degrees now, estimated, 0..360
    const SpindleObserver& observer() const noexcept { return observer_; }
    double true_speed() const noexcept;                       // simulated drive: behind the encoder
    double true_angle() const noexcept;
    bool reached() const noexcept { return reached_; }
    bool standing() const noexcept { return standing_; }
    bool settled() const noexcept { return ramped_ == target_; }
    double override_factor = 1.0;
    std::uint32_t owner = 0;       // channel that commands it
    std::uint32_t locked_by = 0;   // channel whose G96, thread or tap needs it; 0 none
    bool override_locked = false;  // in a thread (N0607 TOE)

private:
    double wanted(std::int32_t rotation, double factor, double axis_position) const noexcept;
    SpindleConfig config_;
    const PolyturnDriveApi* api_ = nullptr;
    void* drive_ = nullptr;
    Mode mode_ = Mode::Speed;
    double speed_ = 0, surface_speed_ = 0, surface_limit_ = 0, surface_min_ = 0, surface_centre_ = 0;
    std::uint32_t surface_axis_ = 0;
    double target_ = 0, ramped_ = 0, remainder_ = 0;
    double measured_speed_ = 0, angle_ = 0;
    SpindleObserver observer_;  // asked after the exchange: what it calls now is the start of the next tick
    bool reached_ = true, standing_ = true;
};

}  // namespace polyturn::kernel
