// Stock removal along a contour: fanuc G71 (turning), G72 (facing), G73 (pattern). Once for every
// language.
//
//   type I: rises towards its end                      type II: pockets
//    h ^                                       A          .-<------------------- - - - A
//      |  <---- rapid, escape above the level  |          |   level 1
//      |  B---. / - - - - - - - - - - - - - - -|        B-. .----.   .------.
//      |      |/<------------------- level 1   |           v      '.'        '.
//      |       '-. / - - - - - - - - - - - - - |           '-.____.' '._______.'
//      |          '<---------------- level 2   |
//      |            '-----.  then once along   |        down along the contour, level, up along it;
//      |                   '-- the contour -- A'        each pocket to its floor before the next
//      s <--------------------------------------
//
// s is the roughing direction (G71: Z, G72: X), h the height above the contour, measured towards A.
//
// Invariants
//   I1  No cut goes below the contour shifted by the allowance; after the last pass along it,
//       nothing more is left.
//   I2  Rapid traverse stays above what the passes before have removed.
//   I3  The number of passes is bounded before the first move: by kMostPasses, or an alarm says
//       which word is wrong.
//   I4  A level exactly on a stretch of the contour cuts along this stretch; a level on its lowest
//       point is the last pass.
#pragma once
#include "channels/cycles/contour.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

inline constexpr int kMostPasses = 10'000;

struct StockRemoval {
    bool facing = false;   // G72: the roles of Z and X change
    bool pockets = false;  // type II
    bool first_pocket_first = true;
    double depth = 0.0;       // of one pass, mm, towards the contour
    char depth_letter = 'U';  // to point at when it is illegal
    double escape = 0.0;      // mm, in both directions
    Point allowance;          // what finishing finds; signed
    // how far the contour may run back, mm
    double roughing_tolerance = 0.0, cutting_tolerance = 0.0;
    double arc_tolerance = 0.02;
};

bool remove_stock(Core& core, const Contour& contour, const StockRemoval& cycle);

struct Pattern {
    Point relief;  // of the first pass, signed
    int passes = 1;
    int divisor = 1;  // the relief is divided by this
    Point allowance;
    double arc_tolerance = 0.02;
};

bool repeat_pattern(Core& core, const Contour& contour, const Pattern& cycle);

}  // namespace polyturn::channels::cycles
