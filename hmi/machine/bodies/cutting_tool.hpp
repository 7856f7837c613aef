// What the table of tools and the offsets say about a tool's position at the part: whether it
// works at the outside or in a hole, and what diameter it drills. Of a tool that says neither the
// picture guesses.
#pragma once
#include <cstdint>

#include "hmi/machine/live/live.hpp"

namespace polyturn::hmi {

enum class CutSide : std::uint8_t { Unknown, Outside, Inside };

struct CuttingTool {
    CutSide side = CutSide::Unknown;
    bool guessed = false;  // the side: from what it has cut before
    // radius of the hole that it leaves when it goes along the axis; 0: not given
    float hole = 0;
    std::int32_t number = 0;  // another number is another tool
};

// How the program has called it; `data`: the number in the table of tools, 0 where there is none.
// Offset: the cell that holds its geometry.
struct CalledTool {
    std::int32_t number = 0, data = 0, offset = 0, edge = 0;
    bool operator==(const CalledTool&) const = default;
};
CuttingTool cuttingTool(const Live& live, unsigned channel, const CalledTool& called);
// From the code of the tip: on which side of the nose it points away from the axis.
CutSide sideOfTip(Dialect language, int tip);

}  // namespace polyturn::hmi
