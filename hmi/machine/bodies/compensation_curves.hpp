// The compensation tables of a machine as curves: what an axis is corrected by at each of its
// positions, and which parameters say so. From N2500 to N2808 and the measured cells
// (ipc/model/compensation/compensation_tables.hpp), as kernel/axes/compensation.cpp reads them. Values
// as they are stored: in the unit of the axis, X as a radius.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "ipc/model/compensation/compensation_tables.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::hmi {

// A parameter of one axis or channel.
struct ParameterPlace {
    const params::Row* row = nullptr;
    unsigned instance = 1;
    std::size_t slot() const {
        return row->first_slot + (instance - 1) * static_cast<std::size_t>(row->array);
    }
    bool operator==(const ParameterPlace&) const = default;
};

struct CompensationCurve {
    enum class Kind : std::uint8_t {
        Pitch,
        PitchBack,
        Periodic,
        Gradient,
        Straightness,
        Grid
    } kind = Kind::Pitch;
    unsigned channel = 0;                // of straightness and grid
    unsigned moving = 0, corrected = 0;  // axes; 0: not known which
    struct Point {
        std::int64_t number = 0;  // of the cell or grid point; A to D are 0 to 3
        double at = 0, value = 0;
        bool given = true;  // false: 0, because it was not measured
    };
    std::vector<Point> points = {};  // by position; of a grid none: gridRow() has them
    bool on = false;                 // the kernel works with it
    unsigned pair = 0;               // of straightness, from 1
    bool four = false;               // its points are parameters: positions A to D and their values
    CompensationGrid grid = {};
    std::int64_t count = 0;  // of points, those of a whole grid
    double largest = 0;      // correction, in either direction

    bool described() const { return count >= 2; }
    bool sameTable(const CompensationCurve& other) const;  // whatever it says now
    // Parameter of the value of a point, or of its position, when the points are parameters.
    std::optional<ParameterPlace> parameterOf(std::size_t point, bool position) const;
    // What lays it out and switches it on, without the points.
    std::vector<ParameterPlace> describedBy() const;
};
// Those that the parameters describe, whether they act or not; or also all others that axes and
// channels could have, with no points.
enum class Tables : std::uint8_t { Described, All };
std::vector<CompensationCurve> compensationCurves(const params::Table& table,
                                                  const MachineConfig& machine,
                                                  const CompensationTables& cells,
                                                  Tables which = Tables::Described);

// A row of a grid: along one of its axes, at a place of the others, what it corrects of one of them
// (`component`, 0 to 2).
struct GridRow {
    std::size_t component = 0, along = 0;
    std::array<std::int64_t, 3> place{};
};
// along its first axis, through machine zero
GridRow firstRow(const CompensationGrid& grid);
// what is not there goes to what is
GridRow within(GridRow row, const CompensationGrid& grid);
CompensationCurve gridRow(const CompensationCurve& grid, const CompensationTables& cells,
                          const GridRow& row);

}  // namespace polyturn::hmi
