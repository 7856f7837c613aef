// Compensation of measured machine errors: what is added to the command behind the displayed
// position (nct_parameters_part2 26 to 29): pitch in both directions with a periodic second table,
// four-point gradient, straightness of one axis by another, the volumetric grid, and the
// temperature of the axis (PT_TEMP_*, AP_TEMP).
//
//   cell i lies at (i - N2502) * N2501       between two cells linear, outside the last value holds
//
//   value |        *---.                     L: measured machine position. The direction of
//         |   .---'     '.                   travel is the encoder's; it changes when the axis has
//         |--*            '*--               come kReversal back.
//         +--10499--10500--10501---> L
//
// The sum is not output directly: it is followed within a share of the axis' speed, acceleration
// and jerk, so that switching a table on, a reversal with two tables, or a jump of a sensor makes
// no step. Only a referenced axis is compensated; others fade to 0. Tables are loaded before the
// cyclic thread begins; a tick looks up, it never searches. Cost: a few multiplications for each
// compensated axis.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/model/compensation/compensation_tables.hpp"
#include "kernel/motion/jerk_profile.hpp"
#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

class Compensation {
public:
    // not in the cyclic thread
    void take_tables(CompensationTables tables) {
        own_ = std::move(tables);
        tables_ = &own_;
    }
    // that outlive their use
    void use_tables(const CompensationTables& tables) noexcept { tables_ = &tables; }
    void configure(const params::Table& table, const KernelConfig& config) noexcept;
    // Before the drives are spoken to.
    void step(Core& core) noexcept;
    double of(std::size_t axis) const noexcept { return axes_[axis].now.s; }

private:
    struct Curve {  // four points
        double at[4] = {}, value[4] = {};
        double cycle = 0;  // length after which it repeats; 0 not
        double operator()(double position) const noexcept;
    };
    struct Pitch {
        bool on = false, both = false;
        double interval = 1, cycle = 0;  // cycle: cyclic
        std::int64_t zero = 0, first = 0, last = 0, second = 0;
    };
    struct Straight {
        std::uint32_t moving = 0, compensated = 0;  // from 1
        bool simple = false;
        Curve curve;
        Pitch cells;
    };
    struct Grid {
        std::uint32_t axis[3] = {};  // from 1; 0 none
        std::int64_t count[3] = {1, 1, 1}, zero[3] = {};
        double interval[3] = {1, 1, 1};
    };
    struct Axis {
        bool used = false;
        // mm of what its cells and grid points count: inches of an inch machine
        double unit = 1;
        Pitch pitch, periodic;
        bool gradient = false;
        Curve curve;
        double temp_shift = 0, temp_slope = 0, temp_zero = 0;
        bool negative = false;  // direction of travel
        double turned_at = 0;
        double wanted = 0;
        PathState now;  // given out: mm, mm/s, mm/s2
    };
    double cell_value(const Pitch& layout, double position, bool second) const noexcept;
    static void follow(Axis& axis, const AxisConfig& config, double dt) noexcept;
    void add_grid(const Core& core, std::size_t channel) noexcept;

    CompensationTables own_;  // what the machine began with
    const CompensationTables* tables_ = &own_;
    std::array<Axis, kMaxAxes> axes_{};
    std::array<Straight, kMaxChannels * 6> straights_{};
    std::size_t straight_count_ = 0;
    std::array<Grid, kMaxChannels> grids_{};
    bool any_ = false;
};

}  // namespace polyturn::kernel
