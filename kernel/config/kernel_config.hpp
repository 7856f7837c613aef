// The parameters as the cyclic thread needs them, in its units (mm, degrees, seconds, 1/min), so
// that no tick divides by 60 or checks the machine's unit. Made from the table at the start and
// again at the start of a tick at which parameters change; building it allocates nothing.
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "ipc/capacities.hpp"
#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/params/table.hpp"
#include "ipc/path/stroke_zones.hpp"
#include "kernel/config/servo_config.hpp"
#include "kernel/config/spindle_config.hpp"

namespace polyturn::kernel {

inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

using ShortName = std::array<char, 8>;  // zero-ended

struct AxisConfig {
    bool exists = false;
    bool rotary = false;
    bool inch = false;  // its parameters are inches
    bool diameter = false;
    // N0422, part of rapid below which the next block may begin (N0421 ROL)
    double rapid_share = 0;
    // from 1: it shares the drive of this spindle (N0503 = N0603); 0 none
    std::uint32_t on_spindle = 0;
    std::uint32_t channel = 0;       // from 1; 0: belongs to none
    double rapid = 0, max_feed = 0;  // mm/s
    double manual_rapid = 0, jog_max_feed = 0;
    double setup_feed = kUnlimited;  // PT_SETUP_FEED, mm/s
    double acceleration = 0;         // mm/s2
    // mm/s2 across the path (N0402): the channel's limit on bends
    double normal_acceleration = 0;
    double jerk = kUnlimited;       // mm/s3; N0401 = 0 means that acceleration may step
    double estop_deceleration = 0;  // mm/s2, without jerk limit
    double tick_s = 0.001;
    ServoConfig servo;
    ReferenceConfig reference;
    double rollover = 0;       // degrees of a turn; 0: positions run on
    double index_step = 0;     // N0110 of an indexed axis; 0: none
    std::uint32_t handle = 0;  // N2400
    double lubrication = 0;    // N1273, mm; 0: none
    double gear_retract = 0;   // N1804, mm with sign
    double retract = 0;        // PT_RETRACT, mm with sign; 0: none
    // N2105 MMI: exchanged, its address counts against the drive
    bool counts_other_way = false;
    bool measured_only = false, hypothetical = false, named = false;
    ShortName name{};   // as programs call it; "A3" without a name
    AxisStroke stroke;  // ranges that are watched once the axis is referenced
};

// What the death of a channel's process means for the others of its machine group
// (PT_PARTNER_DEATH).
enum class PartnerDeath : std::uint8_t { GoOn, Hold, Reset, Retract };

struct ChannelConfig {
    bool exists = false;
    std::uint32_t group = 0;  // machine group
    std::uint32_t default_spindle = 0;
    std::int64_t jog_feed_source = 1;     // N0316
    double jog_feed = 0;                  // N0317, mm/s
    double jog_feed_rev = 0;              // N0318, mm a revolution
    double measure_feed = 0;              // N0319, mm/s
    double rapid_key_factor = 1;          // N0313
    bool feed_override_in_rapid = false;  // FG.RAPIDOVR
    // PT_LANGUAGE; a job may say another one (Channel::speaks)
    Dialect language = Dialect::Fanuc;
    // most that the feed switch does, 1 is 100 %: in any language, and where the language has an end
    // of its own (LanguageTraits::override_ranges)
    double feed_override_max = 2.0, feed_override_end = 1.2;
    double default_feed = 0, default_feed_rev = 0;  // N0300, N0301
    bool inch = false, per_revolution = false;      // N0104 IND; N1301 G95
    std::uint32_t surface_speed_axis = 0;           // from 1
    double surface_speed_min_rpm = 0;
    double in_position_timeout_s = 0;
    double wait_timeout_s = 0;  // 0: never
    PartnerDeath partner_death = PartnerDeath::GoOn;
    bool rapid_overlaps = false;         // N0421 ROL
    bool reads_one_block_ahead = false;  // N1301 MBM = 0; three blocks in G41 and G42
    double parts_wanted = 0;             // N2308; 0: no end
    bool stops_at_wanted = true;         // PT_PARTS_STOP
    bool feed_needs_spindle = true;      // PT_FEED_WAITS
    std::int64_t increments = 2;         // N0105
    double handwheel_time_s = 0.02;      // PT_WHEEL_TIME: of the program, a detent
    std::array<char, 3> aux_letters{};   // N1333 to N1335: their values go to CN_AUX1C to CN_AUX3C
    ChannelStroke stroke;
    double contour_tolerance = 0;  // PT_CONTOUR_TOL, mm; 0: not watched
    bool gear_opens = false;       // N1800 RCE
    double gear_retract_feed = 0;  // N1805, mm/s
};

// N1101 to N1196.
struct PositionSwitch {
    std::uint32_t axis = 0;    // from 1; 0: there is no such switch
    double low = 0, high = 0;  // mm, degrees
};

struct KernelConfig {
    std::int64_t tick_ns = 1'000'000;
    double tick_s = 0.001;
    std::uint32_t horizon = 1024;  // records
    std::uint32_t history = 2000;  // PT_HISTORY, records
    std::int64_t plc_cycle_ticks = 10;
    std::int64_t answer_ticks = 10;
    double channel_timeout_s = 1.0, supervisor_timeout_s = 5.0;
    std::int64_t late_max_ticks = 5;
    std::uint16_t drive_lost = 3;  // PT_DRIVE_LOST, cycles
    std::array<AxisConfig, kMaxAxes> axes{};
    std::array<SpindleConfig, kMaxSpindles> spindles{};
    std::array<ChannelConfig, kMaxChannels> channels{};
    std::array<PositionSwitch, 32> switches{};
    std::uint32_t axis_count = 0;  // highest existing one
    std::uint32_t spindle_count = 0;
};

// The tick and the PLC cycle are taken once, at the start: `first`.
void read_config(const params::Table& table, KernelConfig& config, bool first);

}  // namespace polyturn::kernel
