// Pecking in rows: fanuc G74 (pecks along Z, rows along X) and G75 (pecks along X, rows along Z).
// Once for every language.
//
//          row 3      row 2      row 1 = A
//            . <- - - - . <- - - - .
//            |          |          |  feed `peck`, back `retract` in rapid, again ...
//            v          v          v
//            '-> - - - -'-> - - - -'->    at the bottom `relief` aside, then rapid to A's level
//
// The last peck ends exactly on the bottom, the last row exactly at the programmed end.
#pragma once
#include "channels/cycles/contour.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

inline constexpr int kMostPecks = 100'000;

struct Grooving {
    bool along_x = false;  // G75
    Point end;             // bottom and last row
    double peck = 0.0;     // mm; 0: in one go
    double row = 0.0;      // mm between rows; needed when the end lies aside of the start
    double retract = 0.0;  // mm
    // mm away from the next row; with one row only its sign says where to
    double relief = 0.0;
    char peck_letter = 'Q', row_letter = 'P';
};

bool cut_grooves(Core& core, const Grooving& cycle);

// A groove as wide as its two points, plunged side by side with a cutter of some width (fagor G88,
// G89).
//
//   start ---.      .--- call point          steps of equal size, not above `step`;
//            |  |  |                         the last plunge ends on the far side
//            '--+--+-- end
//
// The first plunge is at the start with the cutter's corner that is there; where the tool's point
// is its other corner, every plunge lies the cutter's width further on.
struct PlungedGroove {
    bool along_x = true;      // plunges along X (G88), else along Z (G89)
    bool far_corner = false;  // the tool's point is the corner on the side of the end
    Point start, end;
    double cutter = 0.0, step = 0.0, safety = 0.0;  // mm
    double dwell = 0.0;                             // seconds behind each plunge; 0 none
};

bool plunge_groove(Core& core, const PlungedGroove& groove);

}  // namespace polyturn::channels::cycles
