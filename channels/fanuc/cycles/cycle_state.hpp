// What blocks with cycles leave for the blocks behind them: modal words of G90, G92, G94 and of the
// drilling cycles, the data of the first blocks of G71 to G76, and G70 under way.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "channels/fanuc/program/text_place.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct SimpleCycleWords {  // of G90 G92 G94 (G77 to G79)
    AxisValues end{};      // for the axes of `set`
    AxisSet set = 0;
    double taper = 0.0;
};

struct DrillWords {
    double initial = 0, r_level = 0, bottom = 0, q = 0, p = 0, e = 0;
    bool initial_known = false, r_set = false, bottom_set = false, p_set = false, e_set = false;
    std::array<double, 3> aside{};  // I, J, K of fine boring, mm
};

struct Finishing {  // G70 drives the blocks P to Q
    bool active = false;
    std::string_view name;
    std::int64_t last = 0;  // Q
    TextPlace resume;
    std::size_t depth = 0;  // of Calls::frames
    AxisValues start{};
};

// what first blocks have said (fanuc: it stays; nct: for the next block)
struct CycleData {
    std::optional<double> depth, escape, relief_z, relief_x, divisions, peck_return, thread_passes,
        thread_chamfer, tool_angle, least_infeed, thread_allowance;
};

struct CycleState {
    SimpleCycleWords simple;
    DrillWords drill;
    Finishing finishing;
    CycleData data;
};

}  // namespace polyturn::channels::fanuc
