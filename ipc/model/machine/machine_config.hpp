// The machine as its parameters describe it, in the units that motion computes with: which
// channels, axes and spindles exist, what they are called, what they may do. Derived from the
// parameter table by every process that needs it, so that all of them see the same machine; plain
// data that can be copied into a tick's state.
//
// Units: lengths mm, angles degrees, time seconds, whatever the parameters are written in (minutes;
// inches where N0104 says so). Positions and limits of an axis are true: X as a radius even where
// programs and displays show a diameter. Numbers of channels, axes and spindles count from 1 as the
// operator's do; 0 means none.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

#include "ipc/capacities.hpp"
#include "ipc/params/table.hpp"

namespace polyturn {

enum class ChannelKind : std::uint8_t { Lathe = 0, Mill = 1 };  // N0001
enum class PlaneRole : std::uint8_t {                           // N0103
    None = 0,
    BasicX = 1,
    BasicY = 2,
    BasicZ = 3,
    ParallelX = 5,
    ParallelY = 6,
    ParallelZ = 7,
};

// What one axis may do; an infinite value limits nothing. Rotary axes: degrees instead of
// millimetres.
struct AxisLimits {
    double rapid_mm_s;            // N0304
    double max_feed_mm_s;         // N0305, clamps what programs ask for
    double manual_rapid_mm_s;     // N0314
    double jog_feed_mm_s;         // N0315
    double ref_rapid_mm_s;        // N0302, also the most before the axis is referenced
    double ref_feed_mm_s;         // N0303
    double accel_mm_s2;           // N0400
    double jerk_mm_s3;            // N0400 / N0401; infinite when N0401 is 0
    double normal_accel_mm_s2;    // N0402, across the path
    double speed_step_mm_s;       // N0309, limit of a velocity step at a junction
    double accel_step_mm_s2;      // N0403, limit of an acceleration step between two lines
    double accel_step_arc_mm_s2;  // N0404, the same where an arc takes part
};

// Stroke range 1, parameter sets A (N1002, N1003) and B (N1004, N1005). Enabled by N1000 #0.
struct StrokeRange {
    bool enabled;
    double max_a_mm, min_a_mm, max_b_mm, min_b_mm;
};

struct AxisConfig {
    std::uint16_t number;   // 0: does not exist
    std::uint16_t channel;  // that owns it; 0: measured only (N0002 = 99)
    // position among its channel's axes, from 0; kNoSlot: programs cannot name it
    std::uint16_t slot;
    std::uint16_t on_spindle;  // spindle that shares its drive (a C axis); 0 none
    char name[4];              // N0100..N0102, zero-ended; empty: programs cannot name it
    PlaneRole role;
    bool diameter;  // N0106 #0: programmed and shown as a diameter
    // and so are its tool offsets in the tables (F5004 #1 ORC); what a table means outlasts its
    // language
    bool offset_diameter;
    bool rotary;                         // N0106 #1
    bool indexed;                        // N0106 #3
    bool measured_only;                  // N0106 #4 or N0002 = 99: never commanded
    bool hypothetical;                   // N0106 #7: has no drive until an exchange gives it one
    bool rollover;                       // N0107 #0
    bool rollover_shortest;              // N0107 #1
    bool rollover_sign_is_direction;     // N0107 #2
    bool rollover_reduces_increments;    // N0107 #3
    double rollover_deg;                 // N0108
    double index_step_mm;                // N0110
    std::array<double, 4> reference_mm;  // N0200..N0203
    AxisLimits limits;
    StrokeRange stroke;
    double position_gain_1_s;  // N0504
    double feed_forward;       // N0511 where N0515 #0 enables it, else 0
    double in_position_mm;     // N0516
    bool exists() const noexcept { return number != 0; }
    std::string_view name_text() const noexcept { return name; }
};
inline constexpr std::uint16_t kNoSlot = 0xffff;

struct GearRange {
    double full_scale_rpm, min_rpm, max_rpm;  // N0634.., N0642.., N0650..
    double ramp_up_rpm_s, ramp_down_rpm_s;    // N0666.., N0674..; 0: the command steps
};

struct SpindleConfig {
    std::uint16_t number;     // 0: does not exist (N0607 #0)
    char name[4];             // "S", or with N0605, N0606: "S2", "SMA"
    bool can_orient;          // N0607 #1
    bool can_index;           // N0607 #2: its position loop can be closed
    bool override_in_thread;  // N0607 #5
    bool inverted_indexing;   // N0607 #7
    double encoder_counts;    // N0608 a revolution; 0: no encoder
    double speed_tolerance_percent, speed_tolerance_rpm, standstill_rpm;  // N0627..N0629
    std::array<GearRange, 8> range;
    bool exists() const noexcept { return number != 0; }
    std::string_view name_text() const noexcept { return name; }
};

struct ChannelConfig {
    std::uint16_t number;  // 0: does not exist
    std::uint16_t group;   // machine group, from 1
    ChannelKind kind;
    std::uint8_t increment_system;  // 1..5: ISA..ISE (N0105)
    bool inch;                      // N0104 #0: its measuring devices count inches
    std::uint16_t axis_count;
    // machine axis numbers, ascending; the slot order of ChannelStore::zeros
    std::array<std::uint16_t, kChannelAxes> axes;
    std::uint16_t default_spindle;     // N0604; 0 none
    std::uint16_t surface_speed_axis;  // N0687, machine axis; 0 none
    std::uint16_t offset_count;        // N1400
    char name[64];                     // N0003
    bool corner_by_axis_step;          // N0306 #0: N0309 decides, not N0307 and N0308
    double corner_angle_deg;           // N0307
    double corner_feed_mm_s;           // N0308
    double arc_feed_min_mm_s;          // N0310
    bool exists() const noexcept { return number != 0; }
    std::string_view name_text() const noexcept { return name; }
    std::span<const std::uint16_t> axis_numbers() const noexcept {
        return {axes.data(), axis_count};
    }
    // Millimetres in one unit of the channel's length parameters.
    double length_unit_mm() const noexcept { return inch ? 25.4 : 1.0; }
    // Smallest decimal places that a position is shown and entered with, metric or degrees.
    unsigned decimals() const noexcept { return increment_system + 1u; }
};

struct MachineConfig {
    std::uint32_t tick_us;  // N0005; Auto by the number of channels that own axes
    std::uint16_t channel_count, axis_count, spindle_count;  // that exist
    // highest number that exists; bounds of loops
    std::uint16_t last_channel, last_axis, last_spindle;
    double wait_code_min, wait_code_max;               // N2201, N2202; both 0: no waiting codes
    std::array<ChannelConfig, kMaxChannels> channels;  // [0] is L1
    std::array<AxisConfig, kMaxAxes> axes;             // [0] is A1
    std::array<SpindleConfig, kMaxSpindles> spindles;  // [0] is S1

    const ChannelConfig& channel(std::size_t number) const noexcept { return channels[number - 1]; }
    const AxisConfig& axis(std::size_t number) const noexcept { return axes[number - 1]; }
    const SpindleConfig& spindle(std::size_t number) const noexcept { return spindles[number - 1]; }
    double tick_s() const noexcept { return tick_us * 1e-6; }
    bool is_wait_code(double code) const noexcept {
        return (wait_code_min != 0 || wait_code_max != 0) && code >= wait_code_min &&
               code <= wait_code_max;
    }
    std::uint32_t channels_of_group(std::size_t group) const noexcept;  // mask, bit 0 is channel 1
};

// What the parameters say. Contradictions (config_check.hpp) are not looked for; what contradicts
// is left out, so that every number in the result can be used as an index: a channel's 17th axis
// has no slot, an axis of an absent channel is no axis, a default spindle that does not exist is
// none.
[[nodiscard]] MachineConfig derive_machine_config(const params::Table& table) noexcept;

// The axis that programs of this channel call by that name (capital letters); nullptr when there is
// none.
[[nodiscard]] const AxisConfig* find_axis(const MachineConfig& machine, std::size_t channel,
                                          std::string_view name) noexcept;
// The axis of the channel with that plane role (a basic one, or the first parallel one); nullptr
// when there is none.
[[nodiscard]] const AxisConfig* find_axis(const MachineConfig& machine, std::size_t channel,
                                          PlaneRole role) noexcept;
// "S", "S2": by its name, or else by its number.
[[nodiscard]] const SpindleConfig* find_spindle(const MachineConfig& machine,
                                                std::string_view name) noexcept;
// The tick that Auto chooses.
[[nodiscard]] std::uint32_t auto_tick_us(std::size_t channels_with_axes) noexcept;

}  // namespace polyturn
