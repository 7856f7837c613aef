// What the machine parameters say about the language fagor (rows FG.* of
// ipc/params/parameters.csv).
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "channels/machine_view.hpp"

namespace polyturn::channels::fagor {

// An entry of the M table (fagor_8037t 5.5).
struct MEntry {
    std::int32_t code = -1;
    std::int32_t subroutine = 0;  // 0: none
    bool after_motion = false;
    bool stops_preparation = false;
    bool only_subroutine = false;
    bool goes_on = false;  // without waiting for AUXEND
};

struct Settings {
    bool g17 = false, inch = false, incremental = false, g1 = false, per_revolution = false,
         round_corner = false;
    bool polar_origin_moves = false;
    std::int32_t homing_subroutine = 0;
    double arc_tolerance = 0.01;  // mm
    std::int32_t offsets = 255;   // highest offset and tool number
    bool change_by_m06 = false;
    bool geometry_by_offset = false;
    int comp_mode = 0;
    bool comp_every_plane = false;
    bool probe_override = false, probe_error = false;
    std::array<std::int32_t, 4> interrupt_subroutine{};
    std::int32_t look_ahead_kind = 0, interpolation_period = 0;
    int inclined_axis = 0, orthogonal_axis = 0;  // 1 = X, 2 = Y ...
    double inclined_deg = 0.0, inclined_origin = 0.0;
    std::vector<MEntry> m_table;
    double override_max = 120.0;
    // of the spindle that plain S means
    bool thread_angle = false;  // M19TYPE
    bool gear_automatic = false;
    std::array<double, 4> gear_max{};
    double spindle_override_min = 50.0, spindle_override_max = 120.0;
};

Settings read_settings(const params::Table& table, unsigned channel);

// Formats and rotary axes as Fagor counts them; to be done before the interpreter looks at the
// view.
void prepare_axes(MachineView& view);

// Axes by their numbers in names and parameters: 1 X, 2 Y, 3 Z, 4 U, 5 V, 6 W, 7 A, 8 B, 9 C.
inline constexpr std::array<char, 9> kAxisLetters = {'X', 'Y', 'Z', 'U', 'V', 'W', 'A', 'B', 'C'};
constexpr int axis_number(char letter) {
    for (std::size_t i = 0; i < kAxisLetters.size(); ++i)
        if (kAxisLetters[i] == letter) return static_cast<int>(i) + 1;
    return 0;
}

}  // namespace polyturn::channels::fagor
