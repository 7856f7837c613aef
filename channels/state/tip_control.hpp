// Rotary heads and tables (nct part 2 33): N3200 to N3224 as the transformation that channel and
// kernel share.
#pragma once
#include <cstdint>

namespace polyturn::channels {

class Core;
struct Transformation;

// Role of a transformation that has no axis (a fixed angle, or none at all): it is at its
// centre.
inline constexpr std::uint8_t kNoPlace = 0xff;

// Tool centre point control on: the tip goes where the program says while head and table turn.
// Nothing moves. false: fault().
bool control_tip(Core& core, bool head_alone = false);
bool controls_tip(Core& core);
// What N3200 to N3224 and the tool in use make of it; head_alone: without the axes of a table.
bool describe_head(Core& core, bool head_alone, Transformation& wanted);

}  // namespace polyturn::channels
