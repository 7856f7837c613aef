// Where in the text the contour of a cycle stands.
#pragma once
#include <cstdint>

#include "channels/fanuc/program/text_place.hpp"

namespace polyturn::channels::fanuc {

struct ContourText {
    TextPlace first, behind;  // block P; what follows block Q
    std::int64_t last = 0;    // Q
    bool directly = false;    // nothing is between the cycle and block P
};

}  // namespace polyturn::channels::fanuc
