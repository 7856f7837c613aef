// What the program has brought the machine to, or found there, and no resume point keeps: loops of
// spindles, couplings, axes moved by hand, shifts of one block.
#pragma once
#include <cstdint>
#include <optional>

#include "channels/fanuc/g_codes.hpp"
#include "channels/fanuc/spindles/turned_spindles.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct OneBlockShift {  // mefi G58, G59: what holds again behind the block
    std::int32_t before = 0;
    const GCode* code = nullptr;
};

struct MachineState {
    TurnedSpindles turned{};
    bool polygon_on = false, balance_on = false;
    AxisSet synchronous = 0;  // axes that follow a master (F8311)
    // moved in the hold (N1337 REL): the next block with axis words decides
    std::optional<AxisValues> away;
    OneBlockShift one_block;
};

}  // namespace polyturn::channels::fanuc
