// Tools and their edges as the program sees them: $TC_DPx[t,d], $TC_TP2[t].
#pragma once
#include <array>
#include <map>
#include <string>

namespace polyturn::channels::sinumerik {

inline constexpr unsigned kEdgeParameters = 36;  // DP1 to DP35; DP0 unused

struct Edge {
    std::array<double, kEdgeParameters> dp{};
    double teeth = 0.0;  // $TC_DPNT
    // by which D calls it; < 0: its own number, 0: DZERO has taken it
    int d_number = -1;
    std::array<std::array<double, 10>, 7> sum{}, setup{};  // $TC_SCPxy, $TC_ECPxy
};

struct Tool {
    std::string name;  // case counts
    // among those of its name; 0: none was given, the order of the numbers counts
    std::int32_t duplo = 0;
    double max_velocity = 0.0;          // $TC_TP_MAX_VELO
    std::array<double, 10> grinding{};  // $TC_TPG1 to $TC_TPG9, by their numbers (part 1, 6.5)
    std::map<int, Edge> edges;
};

using ToolTable = std::map<std::int64_t, Tool>;

// All tools, and the environments that TOOLENV keeps by name: T, D, DL.
struct ToolStore {
    ToolTable table;
    std::map<std::string, std::array<double, 3>, std::less<>> environments;
};

// TOFFL, TOFF and TOFFR: mm.
struct ToolLengths {
    std::array<double, 3> length_mm{};  // by L1 L2 L3, or by the geometry axes X Y Z
    double radius_mm = 0.0;
};

}  // namespace polyturn::channels::sinumerik
