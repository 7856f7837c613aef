#include "channels/cycles/grooving.hpp"

#include <cmath>
#include <string>

#include "channels/cycles/cycle_moves.hpp"

namespace polyturn::channels::cycles {
namespace {

constexpr double kSameGroove = 1e-9;  // mm

}  // namespace

bool cut_grooves(Core& core, const Grooving& cycle) {
    const auto refuse = [&](char letter, double value) {
        return core.fail(Alarm::CycleValueIllegal, letter, std::string(1, letter), value);
    };
    CycleMoves moves(core);
    if (!moves.ready()) return false;
    const Point start = moves.here();
    // d along the pecks, r along the rows
    const double d0 = cycle.along_x ? start.x : start.z,
                 d1 = cycle.along_x ? cycle.end.x : cycle.end.z;
    const double r0 = cycle.along_x ? start.z : start.x,
                 r1 = cycle.along_x ? cycle.end.z : cycle.end.x;
    const auto at = [&](double d, double r) { return cycle.along_x ? Point{r, d} : Point{d, r}; };
    const double deep = std::fabs(d1 - d0), wide = std::fabs(r1 - r0);
    if (cycle.peck < 0) return refuse(cycle.peck_letter, cycle.peck);
    if (cycle.row < 0 || (wide > kSameGroove && cycle.row <= 0))
        return refuse(cycle.row_letter, cycle.row);
    const double pecks = cycle.peck > 0 ? std::ceil(deep / cycle.peck - 1e-9) : 1,
                 rows = wide > kSameGroove ? std::ceil(wide / cycle.row - 1e-9) : 0;
    if (pecks > kMostPecks) return refuse(cycle.peck_letter, cycle.peck);
    if (rows > kMostPecks || rows * pecks > kMostPecks) return refuse(cycle.row_letter, cycle.row);
    if (cycle.peck > 0 && pecks > 1 && cycle.retract >= cycle.peck + deep)
        return refuse('R', cycle.retract);
    const double d_way = std::copysign(1.0, d1 - d0), r_way = std::copysign(1.0, r1 - r0);
    const double aside = wide > kSameGroove ? -r_way * cycle.relief : cycle.relief;
    for (int row = 0; row <= static_cast<int>(rows); ++row) {
        const double r =
            row == static_cast<int>(rows) && rows > 0 ? r1 : r0 + r_way * cycle.row * row;
        if (!moves.rapid(at(d0, r))) return false;
        for (int k = 1; k <= static_cast<int>(pecks); ++k) {
            const bool last = k == static_cast<int>(pecks);
            const double d = last ? d1 : d0 + d_way * cycle.peck * k;
            if (!moves.linear(at(d, r))) return false;
            if (!last && !moves.rapid(at(d - d_way * cycle.retract, r))) return false;
        }
        if (aside != 0 && !moves.rapid(at(d1, r + aside))) return false;
        if (!moves.rapid(at(d0, r + aside))) return false;
    }
    return moves.rapid(start);
}

bool plunge_groove(Core& core, const PlungedGroove& groove) {
    CycleMoves moves(core);
    if (!moves.ready()) return false;
    const Point call = moves.here();
    const bool x = groove.along_x;
    const auto side = [x](Point p) { return x ? p.z : p.x; };
    const auto deep = [x](Point p) { return x ? p.x : p.z; };
    const auto point = [x](double s, double d) { return x ? Point{s, d} : Point{d, s}; };
    const double width = std::fabs(side(groove.end) - side(groove.start)) - groove.cutter;
    const double towards = side(groove.end) >= side(groove.start) ? 1.0 : -1.0;
    const double away = deep(groove.start) >= deep(groove.end) ? 1.0 : -1.0;
    const int steps = width > 1e-9 ? static_cast<int>(std::ceil(width / groove.step - 1e-9)) : 0;
    if (steps > kMostPecks) return core.fail(Alarm::CycleValueIllegal, 'C', "C", groove.step);
    const double clear = deep(groove.start) + away * groove.safety;
    for (int k = 0; k <= steps; ++k) {
        const double at =
            side(groove.start) + towards * ((steps ? width * k / steps : 0.0) +
                                            (groove.far_corner ? groove.cutter : 0.0));
        if (!moves.rapid(point(at, clear))) return false;
        if (!moves.linear(point(at, deep(groove.end)))) return false;
        if (groove.dwell > 0 && !core.dwell(groove.dwell, false)) return false;
        if (!moves.rapid(point(at, clear))) return false;
    }
    return moves.rapid(call);
}

}  // namespace polyturn::channels::cycles
