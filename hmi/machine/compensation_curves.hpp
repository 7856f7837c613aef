// The compensation tables of a machine as curves: what an axis is corrected by at each of its positions. From the parameters N2500 to N2808 and
// the measured cells (ipc/machine/compensation_tables.hpp), as kernel/cyclic/compensation.cpp reads them. Values as they are stored: in the
// unit of the axis, X as a radius.
#pragma once
#include <cstdint>
#include <vector>

#include "ipc/machine/compensation_tables.hpp"
#include "ipc/machine/machine_config.hpp"

namespace polyturn::hmi {

struct CompensationCurve {
    enum class Kind : std::uint8_t { Pitch, PitchBack, Periodic, Straightness, Gradient, Grid } kind = Kind::Pitch;
    unsigned channel = 0;           // of straightness and grid
    unsigned moving = 0, corrected = 0;   // axes
    struct Point {
        std::int64_t number = 0;    // of the cell or grid point; A to D are 0 to 3
        double at = 0, value = 0;
    };
    std::vector<Point> points;      // by position
    bool on = false;                // the kernel works with it
};
// Those that the parameters describe, whether they act or not.
std::vector<CompensationCurve> compensationCurves(const params::Table& table, const MachineConfig& machine, const CompensationTables& cells);

}  // namespace polyturn::hmi
