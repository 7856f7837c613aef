// Chamfers, corners R and lines by their angle reach over two blocks: what the first has said, and
// where it stood, for the second (g_corners.cpp).
#pragma once
#include <array>
#include <cstdint>

#include "channels/corners/corner_stage.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct CornerThen {  // behind a chamfer or corner of the lathe's own form
    bool pending = false, along_z = false;
    int sign = 1;
    char letter = 0;
};

// the line before this one ends in a chamfer or corner R, and compensation is on
struct CornerBefore {
    bool pending = false, rounding = false;
    char letter = 0;               // its word; 0: behind a comma
    double size = 0;               // leg or radius, mm
    std::array<double, 2> from{};  // where that line began, in the plane
    BlockContext at;
};

struct AngleLine {  // a line whose end the next block gives
    double dp = 0.0, dq = 0.0;
    BlockContext at;
    corners::Call corner;  // ,C or ,R at its end; of no size: none
};

struct Corners {
    CornerBefore before;
    AngleLine angle;
    corners::Call of_block;  // ,C or ,R of the block that is read
    // of the newest blocks with a chamfer or corner R
    std::array<std::uint32_t, 8> lines{};
    std::array<char, 8> letters{};  // its word; 0: ,C or ,R
    unsigned count = 0;
    std::uint64_t comp_moves = ~0ull;  // moves delivered when compensation was switched on
    std::uint16_t comp_code = 0;       // G41 or G42, in tenths, as it was programmed last
};

}  // namespace polyturn::channels::fanuc
