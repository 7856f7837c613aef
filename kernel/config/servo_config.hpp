// Position loop, supervision and reference of one axis, from N0500 to N0540 and N0900 to N0909, in
// mm (degrees) and seconds.
#pragma once
#include <cstdint>

#include "ipc/params/table.hpp"
#include "kernel/config/drive_source.hpp"

namespace polyturn::kernel {

// nct_parameters_part1 7.
struct ServoConfig {
    double gain = 0;         // 1/s
    double feedforward = 0;  // 0 when N0515 FFE is off
    bool feedforward_in_rapid = false;
    double full_speed = 0;                         // mm/s at full output (N0505); 0: not limited
    double offset = 0;                             // N0506
    double drift_s = 0;                            // N0507; 0: off
    double filter_s = 0, equal_s = 0, dead_s = 0;  // T1, T2, TD
    // N0421 JRK: over what the command is averaged, the same for all axes of a channel; 0: not
    double smooth_s = 0;
    double threshold = 0;                   // N0540
    std::int64_t multiply = 1, divide = 1;  // pulses to millionths of a unit
    // N0514 MD; ID, or AD on an absolute encoder
    bool output_inverted = false, input_inverted = false;
    // OPN, EFD, FUP, END
    bool open = false, no_count_open = false, follow_up = false, encoder_unwatched = false;
    double backlash = 0;  // N0523
    // N0525
    bool reversal_boost = false, boost_ends_by_way = false, start_boost = false,
         start_ends_by_way = false;
    double reversal_speed = 0, reversal_s = 0, reversal_travel = 0;    // N0526..N0528; mm/s
    double start_speed = 0, stood_s = 0, start_travel = 0;             // N0529..N0531
    double fade = 0;                                                   // N0532
    std::uint32_t tandem_master = 0;                                   // N0533, from 1
    std::uint32_t dual_axis = 0;                                       // N0534, from 1
    double dual_s = 0, dual_error = 0, dual_most = 0, dual_least = 0;  // N0535..N0538
    double in_position = 0;                                            // N0516
    double model_s = 0;                                                // T3
    // N3019: while a move looks for a fixed stop; 0: not supervised
    double error_seeking = 0;
    // N0519..N0521; 0: not supervised
    double error_standing = 0, error_moving = 0, error_absolute = 0;
    // The simulated drive.
    double drive_hz = 60, drive_damping = 0.9;
    double drive_backlash = 0, drive_friction = 0, drive_drift = 0;  // mm, mm/s, mm/s
    DriveSource drive_source = DriveSource::Simulated;
    std::uint16_t drive_lost = 3;            // PT_DRIVE_LOST, cycles
    bool position_mode = false;              // csp: the drive closes the position loop
    double drive_held = -1e6;                // mm; -1e6: nothing holds it
    double drive_stop = 1e6;                 // mm; 1e6: no limit there
    double stop_error = 1, stop_window = 1;  // PT_STOP_ERROR, PT_STOP_WINDOW
    bool drive_scale = false;                // measured behind the backlash
};

// nct_parameters_part1 10.
struct ReferenceConfig {
    // SWT GRI DCD ABS FLO
    bool by_switch = false, by_pulse = false, coded = false, absolute = false, floating = false;
    bool negative = false, on_switch = false;    // DIR, GOS
    double rapid = 0, feed = 0;                  // N0302, N0303, mm/s
    double distance = 0;                         // N0901, its sign is the direction
    double switch_length = 0, switch_shift = 0;  // N0902, N0903
    double pulse_distance = 0;                   // N0904
    double periods = 0;                          // N0905
    double shift = 0;                            // N0906
    double position = 0;                         // N0200
    double encoder_zero = 0;                     // N0907
    // N0524, absolute encoders only; 0: it reports its whole position
    unsigned encoder_bits = 0;
    bool keeps_rounds = false;  // CIR
    std::int64_t rounds = 0;    // N0908
    // Machine position of the place where an absolute encoder shows 0.
    double absolute_origin() const noexcept {
        return absolute && !floating ? position - encoder_zero : 0.0;
    }
    double alarm_distance = 0;  // N0909
    std::uint32_t order = 1;    // PT_REF_ORDER; 0: not with all
    bool moves() const noexcept { return by_switch || by_pulse || coded; }
};

// `unit`: millimetres (degrees) in one unit of the axis' parameters.
[[nodiscard]] ServoConfig read_servo(const params::Table& table, unsigned axis,
                                     double unit) noexcept;
[[nodiscard]] ReferenceConfig read_reference(const params::Table& table, unsigned axis,
                                             double unit) noexcept;

}  // namespace polyturn::kernel
