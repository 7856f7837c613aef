#include "channels/path/path_limits.hpp"

#include <numbers>

namespace polyturn::channels {

PathLimits path_limits(const MachineConfig& machine, const params::Table& parameters, unsigned channel) {
    PathLimits limits;
    for (std::size_t i = 0; i < kMaxAxes; ++i) {
        const AxisConfig& axis = machine.axes[i];
        if (!axis.exists()) continue;
        const AxisLimits& from = axis.limits;
        limits.axis[i] = {from.rapid_mm_s, from.max_feed_mm_s, from.accel_mm_s2, from.normal_accel_mm_s2, from.jerk_mm_s3,
                          from.speed_step_mm_s, from.accel_step_mm_s2, from.accel_step_arc_mm_s2, axis.rotary};
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

}  // namespace polyturn::channels
