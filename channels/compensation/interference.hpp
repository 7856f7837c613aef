// Detects elements that the nose would run backwards between their start and end vectors, and
// leaves out the inner vectors.
//
//   its start   V1 V2 V3 V4 | element | V5 V6 V7 V8   its end
//                        '-------------'                pairs are checked from the inside outwards:
//                     '--------------------'            (V4,V5) (V3,V6) (V2,V7) (V1,V8)
//
// A pair that interferes is left out on both sides, on one side only where the other has but one
// left. V1 and the last are never left out: where only they remain and interfere, the contour is
// narrower than the nose.
#pragma once
#include "channels/compensation/corner.hpp"

namespace polyturn::channels::compensation {

// The nose centre from start + from to end + to: against the programmed direction, or in the
// wrong direction of an arc?
bool interferes(const Element& element, Vec from, Vec to);

enum class Verdict : std::uint8_t {
    Clean,
    Corrected,  // vectors were left out: the element is driven as a straight line
    Interferes,
};
Verdict check_element(const Element& element, Vectors& at_start, Vectors& at_end, Check check);

}  // namespace polyturn::channels::compensation
