// Pecking in rows: fanuc G74 (pecks along Z, rows along X) and G75 (pecks along X, rows along Z). Once for every language.
//
//          row 3      row 2      row 1 = A
//            . <- - - - . <- - - - .
//            |          |          |  feed `peck`, back `retract` in rapid, again ...
//            v          v          v
//            '-> - - - -'-> - - - -'->    at the bottom `relief` aside, then rapid back to the level of A
//
// The last peck ends exactly on the bottom, the last row exactly at the programmed end.
#pragma once
#include "channels/cycles/contour.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

inline constexpr int kMostPecks = 100'000;

struct Grooving {
    bool along_x = false;           // G75
    Point end;                      // bottom and last row
    double peck = 0.0;              // mm; 0: in one go
    double row = 0.0;               // mm between rows; needed when the end lies aside of the start
    double retract = 0.0;           // mm
    double relief = 0.0;            // mm away from the next row; with one row only its sign says where to
    char peck_letter = 'Q', row_letter = 'P';
};

bool cut_grooves(Core& core, const Grooving& cycle);

}  // namespace polyturn::channels::cycles
