#include "channels/path/path_limits.hpp"

#include <algorithm>
#include <numbers>

namespace polyturn::channels {

PathLimits path_limits(const MachineConfig& machine, const params::Table& parameters,
                       unsigned channel) {
    PathLimits limits;
    for (std::size_t i = 0; i < kMaxAxes; ++i) {
        const AxisConfig& axis = machine.axes[i];
        if (!axis.exists()) continue;
        const AxisLimits& from = axis.limits;
        limits.axis[i] = {from.rapid_mm_s,
                          from.max_feed_mm_s,
                          from.accel_mm_s2,
                          from.normal_accel_mm_s2,
                          from.jerk_mm_s3,
                          from.speed_step_mm_s,
                          from.accel_step_mm_s2,
                          from.accel_step_arc_mm_s2,
                          axis.rotary,
                          params::get(parameters, params::n0422_rapid_reduct_ratio,
                                      static_cast<unsigned>(i) + 1) /
                              100.0};
    }
    const ChannelConfig& own = machine.channel(channel);
    limits.tolerance = params::get(parameters, params::pt_path_tol, channel);
    limits.corner_by_axis_step = own.corner_by_axis_step;
    limits.corner_angle = own.corner_angle_deg * std::numbers::pi / 180;
    limits.corner_feed = own.corner_feed_mm_s;
    limits.arc_feed_min = own.arc_feed_min_mm_s;
    limits.rapid_overlaps = params::bit(parameters, params::n0421_acc_contr, channel, 0);
    limits.rapid_in_position = params::bit(parameters, params::n1337_execution_config, channel, 0);
    return limits;
}

Smoothing smoothing_of(const params::Table& t, const MachineConfig& machine, unsigned channel,
                       int kind) {
    using namespace params;
    Smoothing s;
    s.on = kind == 2 || kind == 3;
    if (!s.on) return s;
    const double unit = bit(t, n0104_unit_of_measure, channel, 0) ? 25.4 : 1.0;
    s.longest = get(t, n3100_max_distance_of_a_block, channel) * unit;
    s.shortest = get(t, n3101_min_distance_of_a_block, channel) * unit;
    s.turn = get(t, n3102_angle_cancelling_smooth, channel) * std::numbers::pi / 180;
    s.tolerance = (kind == 2 ? get(t, n3104_max_tolerance_of_smooth, channel)
                             : get(t, n3106_tolerance_of_smooth2, channel)) *
                  unit;
    if (kind == 2) {
        s.least = get(t, n3105_min_tolerance_of_smooth, channel) * unit;
        return s;
    }
    s.always_below = std::min(
        get(t, n3107_dist_cancelling_of_angular_calc_in_smooth2, channel) * unit, 2 * s.tolerance);
    for (std::size_t i = 0; i < kMaxAxes; ++i)
        if (machine.axes[i].exists() && machine.axes[i].channel == channel &&
            machine.axes[i].rotary) {
            const double most = get(t, n3108_tolerance_of_rot_ax_in_smooth2, i + 1);
            if (most > 0 && (s.rotary == 0 || most < s.rotary)) s.rotary = most;
        }
    return s;
}

}  // namespace polyturn::channels
