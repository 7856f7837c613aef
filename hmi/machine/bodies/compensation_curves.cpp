#include "hmi/machine/bodies/compensation_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "polyturn/parameter_handles.hpp"

namespace polyturn::hmi {
namespace {

namespace p = params;
using Kind = CompensationCurve::Kind;

constexpr unsigned kFirstPosition = 2801, kFirstGradient = 2805, kFirstStraightAt = 2619,
                   kFirstStraightValue = 2631;

ParameterPlace place(unsigned number, unsigned instance) {
    return {p::find("N" + std::to_string(number)), instance};
}
double valueAt(const p::Table& t, const ParameterPlace& at) { return t.numbers[at.slot()]; }

struct Layout {
    std::int64_t first = 0, last = 0, zero = 0;
    double interval = 0;
};
Layout layoutOf(const p::Table& t, unsigned a) {
    return {p::get(t, p::n2503_primary_smallest_cell_no, a),
            p::get(t, p::n2504_primary_largest_cell_no, a),
            p::get(t, p::n2502_cell_no_of_mach_zero, a), p::get(t, p::n2501_primary_interval, a)};
}

// The cells of the layout; `base`: the cell that first's value is taken from.
void takeCells(CompensationCurve& curve, const Layout& own, std::int64_t base,
               const CompensationTables& cells) {
    if (own.first < kFirstCell || own.last > kLastCell || own.last <= own.first ||
        own.interval <= 0)
        return;
    for (std::int64_t n = own.first; n <= own.last; ++n) {
        const std::int64_t cell = base + n - own.first;
        const bool given = cell >= kFirstCell && cell <= kLastCell && !cells.cells.empty() &&
                           !std::isnan(cells.cells[static_cast<std::size_t>(cell - kFirstCell)]);
        curve.points.push_back(
            {cell, static_cast<double>(n - own.zero) * own.interval, cells.cell(cell), given});
    }
}

void takeParameters(CompensationCurve& curve, const p::Table& t) {
    for (std::size_t i = 0; i < 4; ++i)
        curve.points.push_back({static_cast<std::int64_t>(i),
                                valueAt(t, *curve.parameterOf(i, true)),
                                valueAt(t, *curve.parameterOf(i, false)), true});
}

double component(const CompensationTables& cells, unsigned channel, std::int64_t number,
                 std::size_t which) {
    const auto& all = cells.points[channel - 1];
    return number >= 0 && number < static_cast<std::int64_t>(all.size())
               ? static_cast<double>(all[static_cast<std::size_t>(number)][which])
               : std::nan("");
}

}  // namespace

bool CompensationCurve::sameTable(const CompensationCurve& other) const {
    if (kind != other.kind || channel != other.channel) return false;
    return kind == Kind::Grid ||
           (kind == Kind::Straightness ? pair == other.pair : moving == other.moving);
}

std::optional<ParameterPlace> CompensationCurve::parameterOf(std::size_t point,
                                                             bool position) const {
    if (!four || point > 3) return std::nullopt;
    const auto letter = static_cast<unsigned>(point);
    if (kind == Kind::Gradient)
        return place((position ? kFirstPosition : kFirstGradient) + letter, moving);
    return place((position ? kFirstStraightAt : kFirstStraightValue) + 4 * (pair - 1) + letter,
                 channel);
}

std::vector<ParameterPlace> CompensationCurve::describedBy() const {
    std::vector<ParameterPlace> out;
    const auto take = [&](unsigned instance, std::initializer_list<unsigned> numbers) {
        for (const unsigned number : numbers) out.push_back(place(number, instance));
    };
    switch (kind) {
        case Kind::Pitch:
            take(moving, {2500, 2501, 2502, 2503, 2504, 2506});
            break;
        case Kind::PitchBack:
            take(moving, {2500, 2505, 2501, 2502, 2503, 2504});
            break;
        case Kind::Periodic:
            out.push_back({p::find("N0106"), moving});
            take(moving, {2500, 2507, 2508, 2509, 2510});
            break;
        case Kind::Gradient:
            take(moving, {2800, 2506});
            break;
        case Kind::Straightness:
            take(channel, {2600, 2600 + pair, 2606 + pair});
            if (four) break;
            take(channel, {2612 + pair});
            if (moving != 0) take(moving, {2501, 2502, 2503, 2504});
            break;
        case Kind::Grid:
            take(channel, {2700, 2703, 2706, 2709, 2701, 2704, 2707, 2710, 2702, 2705, 2708, 2711});
            break;
    }
    return out;
}

std::vector<CompensationCurve> compensationCurves(const params::Table& t,
                                                  const MachineConfig& machine,
                                                  const CompensationTables& cells, Tables which) {
    std::vector<CompensationCurve> out;
    // `described`: beside its points there is something that says that it is meant.
    const auto keep = [&](CompensationCurve curve, bool described = true) {
        if (curve.kind != Kind::Grid) {
            curve.count = static_cast<std::int64_t>(curve.points.size());
            for (const auto& point : curve.points)
                curve.largest = std::max(curve.largest, std::abs(point.value));
        }
        if (which == Tables::All || (described && curve.described()))
            out.push_back(std::move(curve));
    };
    const auto exists = [&](std::int64_t axis) {
        return axis >= 1 && axis <= static_cast<std::int64_t>(kMaxAxes) &&
               machine.axis(static_cast<std::size_t>(axis)).exists();
    };
    for (unsigned a = 1; a <= machine.last_axis; ++a) {
        if (!machine.axis(a).exists()) continue;
        const auto bit = [&](unsigned number) {
            return p::bit(t, p::n2500_pitch_comp_contr, a, number);
        };
        const Layout own = layoutOf(t, a);
        CompensationCurve pitch{.kind = Kind::Pitch, .moving = a, .corrected = a, .on = bit(0)};
        takeCells(pitch, own, own.first, cells);
        keep(std::move(pitch));
        CompensationCurve back{
            .kind = Kind::PitchBack, .moving = a, .corrected = a, .on = bit(0) && bit(1)};
        if (bit(1))
            takeCells(back, own, p::get(t, p::n2505_primary_smallest_cell_no_both_dir, a), cells);
        keep(std::move(back), bit(1));
        const std::int64_t second = p::get(t, p::n2508_secondary_smallest_cell_no, a);
        CompensationCurve periodic{.kind = Kind::Periodic,
                                   .moving = a,
                                   .corrected = a,
                                   .on = bit(3) && p::bit(t, p::n0106_axis_properties, a, 2)};
        if (bit(3))
            takeCells(periodic,
                      {second, p::get(t, p::n2509_secondary_largest_cell_no, a), second,
                       p::get(t, p::n2507_secondary_interval, a)},
                      second, cells);
        keep(std::move(periodic), bit(3));
        CompensationCurve gradient{.kind = Kind::Gradient,
                                   .moving = a,
                                   .corrected = a,
                                   .on = p::bit(t, p::n2800_gradient_comp_contr, a, 0),
                                   .four = true};
        takeParameters(gradient, t);
        const bool laidOut = gradient.on || gradient.points[0].at != gradient.points[3].at;
        keep(std::move(gradient), laidOut);
    }
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        if (!machine.channel(l).exists()) continue;
        const bool four = p::bit(t, p::n2600_straightness_comp_contr, l, 0);
        for (unsigned pair = 1; pair <= (four ? 3u : 6u); ++pair) {
            const std::int64_t moving = p::get(t, p::nth(p::n2601_no_of_moving_axis_1, pair), l),
                               corrected =
                                   p::get(t, p::nth(p::n2607_no_of_compensation_axis_1, pair), l);
            const bool both = exists(moving) && exists(corrected);
            CompensationCurve curve{
                .kind = Kind::Straightness, .channel = l, .on = both, .pair = pair, .four = four};
            if (exists(moving)) curve.moving = static_cast<unsigned>(moving);
            if (exists(corrected)) curve.corrected = static_cast<unsigned>(corrected);
            if (four)
                takeParameters(curve, t);
            else if (both)
                takeCells(curve, layoutOf(t, curve.moving),
                          p::get(t, p::nth(p::n2613_smallest_cell_no_of_moving_axis_1, pair), l),
                          cells);
            keep(std::move(curve), both);
        }
        CompensationCurve grid{.kind = Kind::Grid, .channel = l, .grid = compensation_grid(t, l)};
        for (std::size_t i = 0; i < 3; ++i)
            if (grid.grid.axis[i] && !exists(grid.grid.axis[i])) {
                grid.grid.axis[i] = 0;
                grid.grid.count[i] = 1;
                grid.grid.zero[i] = 0;
            }
        grid.count = grid.grid.points();
        grid.on = grid.described();
        const auto& points = cells.points[l - 1];
        for (std::size_t n = 0; n < std::min(points.size(), static_cast<std::size_t>(grid.count));
             ++n)
            for (std::size_t i = 0; i < 3; ++i)
                if (grid.grid.axis[i] && !std::isnan(points[n][i]))
                    grid.largest =
                        std::max(grid.largest, std::abs(static_cast<double>(points[n][i])));
        keep(std::move(grid));
    }
    return out;
}

GridRow firstRow(const CompensationGrid& grid) { return within({3, 3, grid.zero}, grid); }

GridRow within(GridRow row, const CompensationGrid& grid) {
    const auto used = [&](std::size_t wanted) {
        if (wanted < 3 && grid.axis[wanted]) return wanted;
        const auto found = std::find_if(grid.axis.begin(), grid.axis.end(),
                                        [](unsigned axis) { return axis != 0; });
        return found == grid.axis.end() ? std::size_t{0}
                                        : static_cast<std::size_t>(found - grid.axis.begin());
    };
    row.component = used(row.component);
    row.along = used(row.along);
    for (std::size_t i = 0; i < 3; ++i)
        row.place[i] =
            std::clamp<std::int64_t>(row.place[i], 0, std::max<std::int64_t>(grid.count[i] - 1, 0));
    return row;
}

CompensationCurve gridRow(const CompensationCurve& grid, const CompensationTables& cells,
                          const GridRow& row) {
    CompensationCurve out = grid;
    out.moving = grid.grid.axis[row.along];
    out.corrected = grid.grid.axis[row.component];
    out.points.clear();
    if (!grid.described() || out.moving == 0) return out;
    std::array<std::int64_t, 3> at = row.place;
    for (at[row.along] = 0; at[row.along] < grid.grid.count[row.along]; ++at[row.along]) {
        const std::int64_t number = grid.grid.number(at);
        const double value = component(cells, grid.channel, number, row.component);
        out.points.push_back({number,
                              static_cast<double>(at[row.along] - grid.grid.zero[row.along]) *
                                  grid.grid.interval[row.along],
                              std::isnan(value) ? 0.0 : value, !std::isnan(value)});
    }
    return out;
}

}  // namespace polyturn::hmi
