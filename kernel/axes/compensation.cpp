#include "kernel/axes/compensation.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace p = params;
namespace {
constexpr double kShare = 0.02;      // of rapid and acceleration that compensation may use
constexpr double kJerkShare = 0.05;  // of the jerk
constexpr double kFollow = 100;      // 1/s, how fast the sum is followed
// mm, degrees: less is noise, or a drive that settles
constexpr double kReversal = 2e-3;
constexpr double kThere = 1e-9;  // mm
constexpr double kMmPerInch = 25.4;

constexpr std::array kPosition{p::n2801_position_a, p::n2802_position_b, p::n2803_position_c,
                               p::n2804_position_d};
constexpr std::array kGradient{p::n2805_gradient_value_a, p::n2806_gradient_value_b,
                               p::n2807_gradient_value_c, p::n2808_gradient_value_d};
constexpr std::array kStraightAt{
    p::n2619_position_a_of_moving_axis_1, p::n2620_position_b_of_moving_axis_1,
    p::n2621_position_c_of_moving_axis_1, p::n2622_position_d_of_moving_axis_1,
    p::n2623_position_a_of_moving_axis_2, p::n2624_position_b_of_moving_axis_2,
    p::n2625_position_c_of_moving_axis_2, p::n2626_position_d_of_moving_axis_2,
    p::n2627_position_a_of_moving_axis_3, p::n2628_position_b_of_moving_axis_3,
    p::n2629_position_c_of_moving_axis_3, p::n2630_position_d_of_moving_axis_3};
constexpr std::array kStraightValue{
    p::n2631_value_a_of_comp_axis_1, p::n2632_value_b_of_comp_axis_1,
    p::n2633_value_c_of_comp_axis_1, p::n2634_value_d_of_comp_axis_1,
    p::n2635_value_a_of_comp_axis_2, p::n2636_value_b_of_comp_axis_2,
    p::n2637_value_c_of_comp_axis_2, p::n2638_value_d_of_comp_axis_2,
    p::n2639_value_a_of_comp_axis_3, p::n2640_value_b_of_comp_axis_3,
    p::n2641_value_c_of_comp_axis_3, p::n2642_value_d_of_comp_axis_3};
constexpr std::array kGridAxis{p::n2700_1st_axis_of_3d_compensation,
                               p::n2701_2nd_axis_of_3d_compensation,
                               p::n2702_3rd_axis_of_3d_compensation};
constexpr std::array kGridPoints{p::n2703_no_of_points_on_1st_axis,
                                 p::n2704_no_of_points_on_2nd_axis,
                                 p::n2705_no_of_points_on_3rd_axis};
constexpr std::array kGridZero{p::n2706_point_no_of_machine_zero_on_1st_axis,
                               p::n2707_point_no_of_machine_zero_on_2nd_axis,
                               p::n2708_point_no_of_machine_zero_on_3rd_axis};
constexpr std::array kGridInterval{p::n2709_comp_interval_on_1st_axis,
                                   p::n2710_comp_interval_on_2nd_axis,
                                   p::n2711_comp_interval_on_3rd_axis};
}  // namespace

double Compensation::Curve::operator()(double position) const noexcept {
    double x = position;
    if (cycle > 0) x = position - std::floor(position / cycle) * cycle;
    if (x <= at[0]) return value[0];
    for (int i = 1; i < 4; ++i)
        if (x <= at[i])
            return value[i - 1] + (value[i] - value[i - 1]) * (x - at[i - 1]) / (at[i] - at[i - 1]);
    // The last section of a repeating one leads back to 0.
    return cycle > at[3] ? value[3] * (cycle - x) / (cycle - at[3]) : value[3];
}

double Compensation::cell_value(const Pitch& layout, double position, bool second) const noexcept {
    double x = position;
    const double low = static_cast<double>(layout.first - layout.zero) * layout.interval;
    if (layout.cycle > 0) x = low + (x - low) - std::floor((x - low) / layout.cycle) * layout.cycle;
    const double place = std::clamp((x - low) / layout.interval, 0.0,
                                    static_cast<double>(layout.last - layout.first));
    const auto left = std::min(static_cast<std::int64_t>(place), layout.last - layout.first - 1);
    const double share = place - static_cast<double>(left);
    const std::int64_t base = second ? layout.second : layout.first;
    return tables_->cell(base + left) * (1 - share) + tables_->cell(base + left + 1) * share;
}

void Compensation::configure(const p::Table& t, const KernelConfig& config) noexcept {
    any_ = false;
    for (unsigned a = 1; a <= kMaxAxes; ++a) {
        Axis& axis = axes_[a - 1];
        const AxisConfig& home = config.axes[a - 1];
        axis.used = false;
        if (!home.exists) continue;
        const double unit = axis.unit = home.inch ? kMmPerInch : 1.0;
        axis.pitch.on = p::bit(t, p::n2500_pitch_comp_contr, a, 0);
        axis.pitch.both = p::bit(t, p::n2500_pitch_comp_contr, a, 1);
        axis.pitch.interval = std::max(p::get(t, p::n2501_primary_interval, a) * unit, 1e-6);
        axis.pitch.zero = p::get(t, p::n2502_cell_no_of_mach_zero, a);
        axis.pitch.first = p::get(t, p::n2503_primary_smallest_cell_no, a);
        axis.pitch.last = p::get(t, p::n2504_primary_largest_cell_no, a);
        axis.pitch.second = p::get(t, p::n2505_primary_smallest_cell_no_both_dir, a);
        const double cycle = p::get(t, p::n2506_distance_of_cycle, a) * unit;
        axis.pitch.cycle = p::bit(t, p::n2500_pitch_comp_contr, a, 2) ? cycle : 0.0;
        axis.pitch.on = axis.pitch.on && axis.pitch.last > axis.pitch.first;
        // The periodic table begins at its own zero; N0109 is the period that the axis' error has.
        axis.periodic.on =
            p::bit(t, p::n2500_pitch_comp_contr, a, 3) && p::bit(t, p::n0106_axis_properties, a, 2);
        axis.periodic.interval = std::max(p::get(t, p::n2507_secondary_interval, a) * unit, 1e-6);
        axis.periodic.first = axis.periodic.zero =
            p::get(t, p::n2508_secondary_smallest_cell_no, a);
        axis.periodic.last = p::get(t, p::n2509_secondary_largest_cell_no, a);
        const double period = p::get(t, p::n2510_distance_of_period, a) * unit;
        axis.periodic.cycle = period > 0 ? period : p::get(t, p::n0109_peramount, a) * unit;
        axis.periodic.on =
            axis.periodic.on && axis.periodic.last > axis.periodic.first && axis.periodic.cycle > 0;
        axis.gradient = p::bit(t, p::n2800_gradient_comp_contr, a, 0);
        axis.curve.cycle = p::bit(t, p::n2800_gradient_comp_contr, a, 1) ? cycle : 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            axis.curve.at[i] = p::get(t, kPosition[i], a) * unit;
            axis.curve.value[i] = p::get(t, kGradient[i], a) * unit;
        }
        axis.temp_shift = p::get(t, p::pt_temp_shift, a);
        axis.temp_slope = p::get(t, p::pt_temp_slope, a);
        axis.temp_zero = p::get(t, p::pt_temp_zero, a) * unit;
        axis.used = axis.pitch.on || axis.periodic.on || axis.gradient || axis.temp_shift != 0 ||
                    axis.temp_slope != 0;
    }
    straight_count_ = 0;
    const auto existing = [&](std::int64_t n) {
        return n >= 1 && n <= static_cast<std::int64_t>(kMaxAxes) &&
               config.axes[static_cast<std::size_t>(n - 1)].exists;
    };
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        const bool simple = p::bit(t, p::n2600_straightness_comp_contr, l, 0);
        for (unsigned g = 1; g <= (simple ? 3u : 6u); ++g) {
            const auto moving = p::get(t, p::nth(p::n2601_no_of_moving_axis_1, g), l),
                       other = p::get(t, p::nth(p::n2607_no_of_compensation_axis_1, g), l);
            if (!existing(moving) || !existing(other) || !config.channels[l - 1].exists) continue;
            Straight& s = straights_[straight_count_++];
            s = {};
            s.moving = static_cast<std::uint32_t>(moving);
            s.compensated = static_cast<std::uint32_t>(other);
            s.simple = simple;
            const double unit = config.axes[s.moving - 1].inch ? kMmPerInch : 1.0;
            for (std::size_t i = 0; simple && i < 4; ++i) {
                s.curve.at[i] = p::get(t, kStraightAt[(g - 1) * 4 + i], l) * unit;
                s.curve.value[i] = p::get(t, kStraightValue[(g - 1) * 4 + i], l) * unit;
            }
            s.cells = axes_[s.moving - 1].pitch;
            const std::int64_t begin =
                p::get(t, p::nth(p::n2613_smallest_cell_no_of_moving_axis_1, g), l);
            s.cells.second = begin;
            axes_[s.compensated - 1].used = true;
        }
        Grid& grid = grids_[l - 1];
        grid = {};
        for (std::size_t n = 0; n < 3; ++n) {
            const auto number = p::get(t, kGridAxis[n], l);
            if (!existing(number) || !config.channels[l - 1].exists) continue;
            grid.axis[n] = static_cast<std::uint32_t>(number);
            grid.count[n] = std::max<std::int64_t>(1, p::get(t, kGridPoints[n], l));
            grid.zero[n] = p::get(t, kGridZero[n], l);
            grid.interval[n] = std::max(p::get(t, kGridInterval[n], l) *
                                            (config.axes[grid.axis[n] - 1].inch ? kMmPerInch : 1.0),
                                        1e-6);
            axes_[grid.axis[n] - 1].used = true;
        }
    }
    for (const Axis& axis : axes_) any_ = any_ || axis.used || axis.now.s != 0;
}

// Eight corners around the point, each weighted with how near it is.
void Compensation::add_grid(const Core& core, std::size_t l) noexcept {
    const Grid& grid = grids_[l];
    const auto& points = tables_->points[l];
    if (points.empty() || (!grid.axis[0] && !grid.axis[1] && !grid.axis[2])) return;
    std::int64_t corner[3] = {};
    double share[3] = {};
    for (std::size_t n = 0; n < 3; ++n) {
        if (!grid.axis[n]) continue;
        if (!core.axes[grid.axis[n] - 1].referenced) return;
        const double place = std::clamp(core.axes[grid.axis[n] - 1].measured() / grid.interval[n] +
                                            static_cast<double>(grid.zero[n]),
                                        0.0, static_cast<double>(grid.count[n] - 1));
        corner[n] = std::clamp<std::int64_t>(static_cast<std::int64_t>(place), 0,
                                             std::max<std::int64_t>(grid.count[n] - 2, 0));
        share[n] = place - static_cast<double>(corner[n]);
    }
    double sum[3] = {};
    for (unsigned which = 0; which < 8; ++which) {
        double weight = 1;
        std::int64_t at[3];
        for (unsigned n = 0; n < 3; ++n) {
            const bool far = (which >> n & 1u) != 0;
            weight *= far ? share[n] : 1 - share[n];
            at[n] = std::min(corner[n] + (far ? 1 : 0), grid.count[n] - 1);
        }
        const auto index =
            static_cast<std::size_t>(at[0] + grid.count[0] * (at[1] + grid.count[1] * at[2]));
        if (weight == 0 || index >= points.size()) continue;
        for (std::size_t n = 0; n < 3; ++n)
            sum[n] += weight * static_cast<double>(points[index][n]);
    }
    for (std::size_t n = 0; n < 3; ++n)
        if (grid.axis[n]) axes_[grid.axis[n] - 1].wanted += sum[n] * axes_[grid.axis[n] - 1].unit;
}

// One tick towards the sum: not faster than it can be stopped on what is left. With the
// acceleration A and the jerk J of the share, a stop from v takes v^2/(2A) + vA/(2J) at the most;
// solved for v. Half of A there leaves time for A to rise.
void Compensation::follow(Axis& axis, const AxisConfig& config, double dt) noexcept {
    const double left = axis.wanted - axis.now.s, most = kShare * config.rapid,
                 rise = kShare * config.acceleration;
    if (std::fabs(left) < kThere && std::fabs(axis.now.v) < kThere / dt && axis.now.a == 0) {
        axis.now = {axis.wanted, left / dt, 0};
        return;
    }
    const double jerk = kJerkShare * config.jerk, brakes = rise / 2;
    if (!std::isfinite(jerk) || jerk <= 0) {
        const double v = std::copysign(std::min({kFollow * std::fabs(left), most,
                                                 std::sqrt(2 * brakes * std::fabs(left))}),
                                       left),
                     step = rise * dt;
        axis.now.v = std::clamp(v, axis.now.v - step, axis.now.v + step);
        axis.now.s += axis.now.v * dt;
        return;
    }
    const double b = brakes * brakes / (2 * jerk);
    const double v = std::copysign(std::min({kFollow * std::fabs(left), most,
                                             std::sqrt(b * b + 2 * brakes * std::fabs(left)) - b}),
                                   left);
    axis.now = towards_speed(axis.now, v, rise, jerk, dt);
}

void Compensation::step(Core& core) noexcept {
    if (!any_) return;
    const double dt = core.config.tick_s;
    for (std::uint32_t a = 0; a < core.config.axis_count; ++a) {
        Axis& axis = axes_[a];
        const AxisUnit& unit = core.axes[a];
        axis.wanted = 0;
        if (!unit.exists() || !unit.referenced || unit.detached) continue;
        const double at = unit.measured();
        // turned_at is the foremost point of the present direction.
        if (axis.negative ? at < axis.turned_at : at > axis.turned_at)
            axis.turned_at = at;
        else if (std::fabs(at - axis.turned_at) > kReversal) {
            axis.negative = !axis.negative;
            axis.turned_at = at;
        }
        if (axis.pitch.on)
            axis.wanted += axis.unit * cell_value(axis.pitch, at, axis.pitch.both && axis.negative);
        if (axis.periodic.on) axis.wanted += axis.unit * cell_value(axis.periodic, at, false);
        if (axis.gradient) axis.wanted += axis.curve(at);
        if (axis.temp_shift != 0 || axis.temp_slope != 0) {
            const double warm = core.signals.plc(signals::ap_temp(a + 1)) / 100.0;
            axis.wanted += warm * (axis.temp_shift + axis.temp_slope * (at - axis.temp_zero));
        }
    }
    for (std::size_t i = 0; i < straight_count_; ++i) {
        const Straight& s = straights_[i];
        const AxisUnit& moving = core.axes[s.moving - 1];
        if (!moving.exists() || !moving.referenced || !core.axes[s.compensated - 1].referenced)
            continue;
        const bool laid_out = s.cells.last > s.cells.first;
        if (s.simple)
            axes_[s.compensated - 1].wanted += s.curve(moving.measured());
        else if (laid_out)
            axes_[s.compensated - 1].wanted +=
                axes_[s.compensated - 1].unit * cell_value(s.cells, moving.measured(), true);
    }
    for (std::size_t l = 0; l < kMaxChannels; ++l) add_grid(core, l);
    for (std::uint32_t a = 0; a < core.config.axis_count; ++a) {
        Axis& axis = axes_[a];
        if (!axis.used && axis.now.s == 0 && axis.now.v == 0) continue;
        follow(axis, core.config.axes[a], dt);
        core.axes[a].compensate(axis.now.s, axis.now.v);
    }
}

}  // namespace polyturn::kernel
