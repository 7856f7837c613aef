// What holds from block to block.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "channels/sinumerik/curve_tables/curve_table.hpp"
#include "channels/sinumerik/geometry/geo_state.hpp"
#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/tools/tool_table.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

// DIAMCHANA: the axis follows DIAMON, DIAM90, DIAMOF from now on
inline constexpr std::uint8_t kAsChannel = 0xff;

// MCALL: called behind each block that moves.
struct ModalCall {
    std::string name;
    std::vector<Argument> arguments;
    const Command* cycle = nullptr;  // null: a program
};

// HOLES1, HOLES2 under MCALL of a program: its block is read again for each hole, the values are
// those of the first time.
struct HolePattern {
    std::vector<Argument> arguments;
    int hole = 0, count = 0;  // the one at the tool's position, from 0
    bool more() const { return hole + 1 < count; }
};

// TRAILON: way of `follows` = factor * way of `leads`. LEADON: its place is what the table says of
// the place of `leads`.
struct Trail {
    std::size_t follows = 0, leads = 0;
    double factor = 1.0;
    int number = 0;                                // of the table
    std::shared_ptr<const CurveTable> table = {};  // null: TRAILON
    bool gear = false;                             // EGON
};

// TANG: the rotary axis that points along the path of two others.
struct Tangential {
    int follows = -1;  // -1: none
    std::array<std::size_t, 2> leads{};
    double factor = 1.0, offset_deg = 0.0;
    bool on = false;  // TANGON
};

// COUPDEF: turns of the following spindle for turns of the leading one.
struct SpindleRatio {
    double turns = 1.0, master_turns = 1.0;
};

// Everything that holds from block to block besides positions, calls and variables: part of a
// resume state.
struct Modal {
    std::optional<double> inclined_deg;          // TRAANG: the angle programmed last
    std::array<std::uint8_t, kGroups> active{};  // number of the active G command of each group
    std::uint8_t motion_before = 0;
    double feed = 0.0;             // F as it holds, mm/min, mm/rev or 1/min
    double feed_word_unit = 1.0;   // mm that a unit of that F is: G700
    double feed_per_tooth = 0.0;   // FZ; 0: F is in use
    double teeth = 0.0;            // $TC_DPNT of the active edge
    bool feed_revolution = false;  // what group 15 makes of F
    // S as programmed in revolutions, or the speed that G97 has kept
    std::array<double, kMaxSpindles + 1> asked_rpm{};
    // DIAMONA and the like: as the numbers of group 29, or kAsChannel; 0: not given
    std::array<std::uint8_t, kChannelAxes> axis_diameter{};
    double path_override = 100, rapid_override = 100;  // OVR, OVRRAP, percent
    bool feed_group_set = false;                       // FGROUP: F counts these axes
    AxisSet feed_group = 0;
    AxisValues feed_radius{};  // FGREF, mm; 0 as delivered
    AxisValues feed_limit{};   // FL, mm/min or deg/min; 0 none
    AxisValues axis_feed{};    // FA, mm/min or deg/min; 0 none
    // FA of a spindle that is positioned, deg/min; 0: in rapid
    std::array<double, kMaxSpindles + 1> spindle_feed{};
    std::int64_t tool_selected = -1;        // T that waits for M6; -1 none
    std::int64_t tool = 0;                  // active tool
    int edge = 0;                           // active D
    std::shared_ptr<const Edge> edge_data;  // its values when it was selected
    ToolLengths toff{};                     // TOFFL, TOFF, TOFFR
    bool toff_by_axis = false;
    std::array<double, 3> length_mm{};  // of the active edge, L1 to L3
    AxisValues travel_left{};           // what DELDTG has deleted
    bool travel_limited = false;        // it was the last one that did, not MEAS
    // end of the last block with MEAS: $AA_DELT is what is left to it
    AxisValues measured_to{};
    // how far changes of zero and tool have shifted the programmed number
    AxisValues pending_zero{}, pending_tool{};
    std::uint16_t master_spindle = 0;
    std::uint16_t feed_spindle = 0;  // FPR: G95 counts its revolutions; 0 the master spindle
    // bit n: spindle n is in position control (SPOS, M19, M70, G331)
    std::uint32_t closed_spindles = 0;
    std::uint32_t cutting_speeds = 0;                            // bit n: its speed comes from SVC
    std::array<double, kMaxSpindles + 1> cutting_speed_m_min{};  // SVC
    std::uint32_t wheel_speeds = 0;  // bit n: GWPSON, its S is the speed of the wheel's rim
    // most: of the wheel, 0 none
    std::array<double, kMaxSpindles + 1> wheel_radius_mm{}, wheel_most_rpm{};
    AxisValues acceleration{};                                    // ACC, percent as written; 0: 100
    int sum_offset = 0;                                           // DL
    AxisSet per_revolution = 0;                                   // FPRAON: FA counts revolutions
    std::array<std::uint16_t, kChannelAxes> axis_feed_spindle{};  // of that spindle
    AxisSet released = 0;                                         // RELEASE
    // FXST percent, FXSW mm or degrees; 0: the parameters'
    AxisValues stop_torque{}, stop_window{};
    std::vector<Trail> trails;                         // TRAILON, LEADON, EGON
    std::array<AxisSet, kChannelAxes> gear_leaders{};  // EGDEF: of the axis at that place; 0 none
    Tangential tangential;
    // COUPDEF, by 100 * following + leading spindle
    std::map<std::uint32_t, SpindleRatio> couplings;
    std::uint32_t coupled_spindles = 0;              // bit n: spindle n follows (COUPON)
    bool corner_feed_stale = false;                  // FRCM belongs to another feed type
    std::map<std::uint16_t, SpindleState> spindles;  // of spindles that are not the master now
    std::optional<ModalCall> call;
    std::shared_ptr<const HolePattern> holes;  // what the next block goes on with
    std::int64_t last_number = 0;
    // words without effect that this program has been warned of, each once
    std::vector<std::string> told;
    bool hides_steps = false, steps_hidden = false;  // SBLOF; what the machine has been sent
    bool actions_told = false;             // and that synchronized actions act between blocks only
    std::optional<CurveDefinition> curve;  // between CTABDEF and CTABEND
    AxisValues before_curve{};             // what was programmed before it
    GeoModal geo;
};

}  // namespace polyturn::channels::sinumerik
