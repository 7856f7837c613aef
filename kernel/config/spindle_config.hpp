// A spindle's parameters as the cyclic thread needs them (nct_parameters_part1 8 and 9): the
// spindle's kind, and for each of its eight gear ranges the highest speed, the ramps and the tuning
// of the position loop. Units: revolutions, seconds; 1/min for turning speeds, rev/s for
// positioning speeds.
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "ipc/params/table.hpp"
#include "kernel/config/drive_source.hpp"

namespace polyturn::kernel {

inline constexpr unsigned kGearRanges = 8;

struct SpindleRange {
    double multiply = 1, divide = 1;      // N0611, N0619: encoder counts to counts of N0608
    double calibration = 0;               // N0634, 1/min at full drive command; 0: without end
    double speed_min = 0, speed_max = 0;  // N0642, N0650, 1/min
    double creep = 0;                     // N0658, 1/min while SP_PAR
    // N0666, N0674, 1/min per s
    double ramp_up = std::numeric_limits<double>::infinity(), ramp_down = ramp_up;
    // As a positioned spindle
    double rapid = 0, feed_max = 0;     // N0320, N0328, rev/s
    double acceleration = 0, jerk = 0;  // N0405, N0413: rev/s2, rev/s3
    double gain = 0;                    // N0701, 1/s
    // N0710, N0718, N0726, N0734
    double command_filter_s = 0, equalise_s = 0, dead_time_s = 0, feedforward = 0;
    double in_position = 0;  // N0744, rev
    double model_s = 0;      // N0753
    // N0761, N0769, N0777, rev; 0: not watched
    double error_standing = 0, error_moving = 0, error_absolute = 0;
    double orient_speed = 0;  // N0801, 1/min
    double backlash = 0;      // N0809, rev
    double synchr_gain = 0;   // N0785, 1/s
    double drift_s = 0;       // N0709; 0: off
    // N1508, N1516, N1524, N1532
    double tap_acceleration = 0, tap_jerk = 0, out_acceleration = 0, tap_gain = 0;
};

enum class OrientBy : std::uint8_t { ZeroPulse, Probe, Switch };  // N0609 OTR, OSW

struct SpindleConfig {
    bool exists = false;                         // N0607 SEX
    bool can_orient = false, can_close = false;  // ORI, INX
    bool index_by_code = true;                   // IXC = 0
    bool search_always = false;                  // ZOR
    bool override_in_thread = false;             // TOE
    double override_min = 0, override_max = 2;   // FG.MINSOVR, FG.MAXSOVR; 1 is 100 %
    bool absolute = false;                       // EAB
    bool index_negative = false;                 // IDS
    // N0609 MD, ID or AD, UNI
    bool output_inverted = false, counts_inverted = false, unsigned_speed = false;
    OrientBy orient_by = OrientBy::ZeroPulse;
    double encoder_counts = 0;  // N0608 a revolution; 0: no encoder
    // what the simulated encoder gives (PT_ENCODER_COUNTS, or as N0608)
    double drive_counts = 4096;
    // it is on the spindle and gives N0608, whatever the range
    bool drive_counts_fit = true;
    DriveSource drive_source = DriveSource::Simulated;
    std::uint16_t drive_lost = 3;                                         // PT_DRIVE_LOST, cycles
    double speed_filter_s = 0;                                            // N0610
    double tolerance_percent = 0, tolerance_rpm = 0, standstill_rpm = 0;  // N0627 to N0629
    // N0630 to N0633
    double watch_time_s = 0, watch_start_percent = 0, watch_percent = 0, watch_rpm = 0;
    double grid_shift = 0;  // N0684, rev
    // N0682: 10 V over what full scale gives; N0683: share of full scale
    double output_scale = 1, output_offset = 0;
    bool encoder_unwatched = false;                              // N0609 END
    double setup_rpm = std::numeric_limits<double>::infinity();  // PT_SETUP_SPEED
    double basic_angle = 0;                                      // N0822, rev; 0: none
    bool loop_stays_open = false;                                // N0742 OPN
    bool feedforward = false, feedforward_in_rapid = false;      // N0743 FFE, FFR
    double in_position_timeout_s = 0;                            // N0752
    // Synchronous run (spindle_couplings.hpp)
    std::uint32_t sync_master = 0;  // PT_SPINDLE_MASTER, from 1
    std::int32_t sync_code = 0, phase_code = 0;
    double sync_turns = 1, sync_master_turns = 1;
    double phase_shift = 0;                  // N0685, rev
    double sync_window = 0, sync_error = 0;  // rev
    std::array<SpindleRange, kGearRanges> range{};
};

SpindleConfig read_spindle(const params::Table& table, unsigned spindle);

}  // namespace polyturn::kernel
