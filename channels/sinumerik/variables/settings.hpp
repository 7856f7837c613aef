// What machine and setting data say about the language, read once and again where the program
// changes them.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "channels/machine_view.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {

struct Settings {
    std::array<std::uint8_t, 64> g_reset{};  // MD20150[group - 1]
    std::array<bool, 64> g_keep{};           // MD20152[group - 1]
    bool metric_base = true;                 // MD10240
    int diameter_axis = -1;                  // place of the transverse axis (MD20100), -1 none
    bool tool_by_m6 = false;                 // MD22550
    std::int64_t tool_change_m = 6;          // MD22560
    int default_edge = 1;                    // MD20270: edge, 0 none, -2 the old one
    bool tool_checked_late = false;          // MD22562 bit 7
    int frames = 99;                         // MD28080
    int r_parameters = 300;                  // MD28050
    int length_const = 0, length_type = 0;   // SD42940, SD42950
    bool zero_travels = true, tool_travels = true;               // SD42440, SD42442
    double circle_error_mm = 0.01, circle_error_factor = 0.001;  // MD21000, MD21010
    double m19_position_deg = 0.0;                               // SD43240
    int m19_mode = 0;                                            // SD43250
    double thread_start_deg = 0.0;                               // SD42000
    double involute_error_mm = 0.01;                             // MD21015
    double approach_slack_mm = 0.01;                             // MD20204
    double lift_distance_mm = 2.0;                               // MD21200
    bool area_with_radius = false;                               // MD21020
    int mirror_reference = 0;                                    // MD10610
    double dwell_cycle_s = 0.0;  // MD10071 where MD10280 bit 4 asks for it; 0 not
    // MD10652 MD10654 MD10656: angle, rounding, chamfer
    std::array<std::string, 3> corner_names;
    bool mirror_toggle = false;                            // MD10612
    bool corner_alarm = false;                             // MD11411 bit 4
    int corner_idle_blocks = 3;                            // MD20200
    bool corner_from_this = false;                         // MD20201 bit 0
    double corner_limit_deg = 100.0;                       // MD20210
    int comp_idle_blocks = 3;                              // MD20250
    int comp_known_blocks = 3;                             // MD20240
    double highest_disc = 50.0;                            // MD20220
    bool comp_closed_start = false;                        // SD42496
    bool euler_angles = false;                             // MD10600 is 0
    bool fine_translation = true;                          // MD24000
    std::array<bool, kMaxAxes> area_plus{}, area_minus{};  // SD43400, SD43410: by machine axis
    std::array<double, kMaxAxes> area_high{}, area_low{};  // SD43420, SD43430
    bool mode_828d = false;
};

Settings read_settings(const params::Table& table, const MachineView& view);

}  // namespace polyturn::channels::sinumerik
