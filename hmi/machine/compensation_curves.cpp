#include "hmi/machine/compensation_curves.hpp"

#include <algorithm>
#include <array>

#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::hmi {
namespace {

namespace p = params;
using Kind = CompensationCurve::Kind;

constexpr std::array kPosition{p::n2801_position_a, p::n2802_position_b, p::n2803_position_c, p::n2804_position_d};
constexpr std::array kGradient{p::n2805_gradient_value_a, p::n2806_gradient_value_b, p::n2807_gradient_value_c, p::n2808_gradient_value_d};
constexpr std::array kGridAxis{p::n2700_1st_axis_of_3d_compensation, p::n2701_2nd_axis_of_3d_compensation, p::n2702_3rd_axis_of_3d_compensation};
constexpr std::array kGridPoints{p::n2703_no_of_points_on_1st_axis, p::n2704_no_of_points_on_2nd_axis, p::n2705_no_of_points_on_3rd_axis};
constexpr std::array kGridZero{p::n2706_point_no_of_machine_zero_on_1st_axis, p::n2707_point_no_of_machine_zero_on_2nd_axis, p::n2708_point_no_of_machine_zero_on_3rd_axis};
constexpr std::array kGridInterval{p::n2709_comp_interval_on_1st_axis, p::n2710_comp_interval_on_2nd_axis, p::n2711_comp_interval_on_3rd_axis};

// The cells first ... last with `zero` at machine zero; `base`: the cell that first's value is taken from.
CompensationCurve ofCells(Kind kind, unsigned moving, unsigned corrected, std::int64_t first, std::int64_t last, std::int64_t zero, double interval, std::int64_t base, const CompensationTables& cells, bool on) {
    CompensationCurve curve{kind, 0, moving, corrected, {}, on};
    if (first < kFirstCell || last > kLastCell || interval <= 0) return curve;
    for (std::int64_t n = first; n <= last; ++n) curve.points.push_back({base + n - first, static_cast<double>(n - zero) * interval, cells.cell(base + n - first)});
    return curve;
}

}  // namespace

std::vector<CompensationCurve> compensationCurves(const params::Table& t, const MachineConfig& machine, const CompensationTables& cells) {
    std::vector<CompensationCurve> out;
    const auto keep = [&](CompensationCurve curve) {
        if (curve.points.size() >= 2) out.push_back(std::move(curve));
    };
    struct Layout {
        std::int64_t first, last, zero;
        double interval;
    };
    const auto layout = [&](unsigned a) { return Layout{p::get(t, p::n2503_primary_smallest_cell_no, a), p::get(t, p::n2504_primary_largest_cell_no, a), p::get(t, p::n2502_cell_no_of_mach_zero, a), p::get(t, p::n2501_primary_interval, a)}; };
    for (unsigned a = 1; a <= machine.last_axis; ++a) {
        if (!machine.axis(a).exists()) continue;
        const auto bit = [&](unsigned number) { return p::bit(t, p::n2500_pitch_comp_contr, a, number); };
        const Layout own = layout(a);
        keep(ofCells(Kind::Pitch, a, a, own.first, own.last, own.zero, own.interval, own.first, cells, bit(0)));
        if (bit(1)) keep(ofCells(Kind::PitchBack, a, a, own.first, own.last, own.zero, own.interval, p::get(t, p::n2505_primary_smallest_cell_no_both_dir, a), cells, bit(0)));
        const std::int64_t second = p::get(t, p::n2508_secondary_smallest_cell_no, a);
        if (bit(3)) keep(ofCells(Kind::Periodic, a, a, second, p::get(t, p::n2509_secondary_largest_cell_no, a), second, p::get(t, p::n2507_secondary_interval, a), second, cells, true));
        CompensationCurve gradient{Kind::Gradient, 0, a, a, {}, p::bit(t, p::n2800_gradient_comp_contr, a, 0)};
        for (std::size_t i = 0; i < 4; ++i) gradient.points.push_back({static_cast<std::int64_t>(i), p::get(t, kPosition[i], a), p::get(t, kGradient[i], a)});
        if (gradient.on || gradient.points[0].at != gradient.points[3].at) keep(std::move(gradient));
    }
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        if (!machine.channel(l).exists()) continue;
        const bool four = p::bit(t, p::n2600_straightness_comp_contr, l, 0);
        for (unsigned pair = 0; pair < (four ? 3u : 6u); ++pair) {
            const auto moving = static_cast<unsigned>(p::get(t, p::nth(p::n2601_no_of_moving_axis_1, pair + 1), l)), corrected = static_cast<unsigned>(p::get(t, p::nth(p::n2607_no_of_compensation_axis_1, pair + 1), l));
            if (moving == 0 || moving > kMaxAxes || corrected == 0 || corrected > kMaxAxes) continue;
            CompensationCurve curve{Kind::Straightness, l, moving, corrected, {}, true};
            if (four) {
                // Positions and values stand together, four of each pair.
                const auto value = [&](const params::Row* first, unsigned i) { return t.numbers[first[4 * pair + i].first_slot + l - 1]; };
                const params::Row *at = params::find("N2619"), *by = params::find("N2631");
                for (unsigned i = 0; i < 4; ++i) curve.points.push_back({i, value(at, i), value(by, i)});
            } else {
                const Layout own = layout(moving);
                curve = ofCells(Kind::Straightness, moving, corrected, own.first, own.last, own.zero, own.interval, p::get(t, p::nth(p::n2613_smallest_cell_no_of_moving_axis_1, pair + 1), l), cells, true);
                curve.channel = l;
            }
            keep(std::move(curve));
        }
        // The volumetric grid along each of its axes, through machine zero of the others.
        std::array<std::int64_t, 3> count{}, zero{};
        for (std::size_t i = 0; i < 3; ++i) count[i] = std::max<std::int64_t>(1, p::get(t, kGridPoints[i], l)), zero[i] = p::get(t, kGridZero[i], l);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<unsigned>(p::get(t, kGridAxis[i], l));
            if (axis == 0 || axis > kMaxAxes) continue;
            CompensationCurve curve{Kind::Grid, l, axis, axis, {}, true};
            for (std::int64_t n = 0; n < count[i]; ++n) {
                std::array<std::int64_t, 3> place = zero;
                place[i] = n;
                const auto number = static_cast<std::size_t>(place[0] + count[0] * (place[1] + count[1] * place[2]));
                const auto& all = cells.points[l - 1];
                const double value = number < all.size() ? static_cast<double>(all[number][i]) : 0.0;
                curve.points.push_back({static_cast<std::int64_t>(number), static_cast<double>(n - zero[i]) * p::get(t, kGridInterval[i], l), value == value ? value : 0.0});
            }
            keep(std::move(curve));
        }
    }
    return out;
}

}  // namespace polyturn::hmi
