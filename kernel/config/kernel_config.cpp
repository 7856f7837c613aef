#include "kernel/config/kernel_config.hpp"

#include <algorithm>
#include <cmath>

#include "ipc/diagnosis/languages.hpp"

namespace polyturn::kernel {
namespace p = params;

namespace {
constexpr double kMmPerInch = 25.4;

// N0005 Auto: the more channels own axes, the longer the cycle (nct_parameters_part1 2.3).
std::int64_t automatic_tick_ns(const KernelConfig& config) {
    std::array<bool, kMaxChannels> owns{};
    for (const AxisConfig& axis : config.axes)
        if (axis.exists && axis.channel) owns[axis.channel - 1] = true;
    const auto channels = std::count(owns.begin(), owns.end(), true);
    return channels <= 2 ? 1'000'000 : channels <= 4 ? 2'000'000 : 5'000'000;
}

void name_axis(const p::Table& t, unsigned a, AxisConfig& axis) {
    std::size_t n = 0;
    for (const auto code : {p::get(t, p::n0100_axis_name1, a), p::get(t, p::n0101_axis_name2, a),
                            p::get(t, p::n0102_axis_name3, a)}) {
        if (code <= 0 || code > 127) break;
        axis.name[n++] = static_cast<char>(code);
    }
    axis.named = n > 0;
    if (axis.named) return;
    axis.name[n++] = 'A';
    if (a >= 10) axis.name[n++] = static_cast<char>('0' + a / 10);
    axis.name[n] = static_cast<char>('0' + a % 10);
}

AxisConfig read_axis(const p::Table& t, unsigned a) {
    AxisConfig axis;
    const auto assigned = p::get(t, p::n0002_axis_assign, a);
    const bool hypothetical = p::bit(t, p::n0106_axis_properties, a, 7);
    axis.channel = assigned >= 1 && assigned <= static_cast<std::int64_t>(kMaxChannels)
                       ? static_cast<std::uint32_t>(assigned)
                       : 0;
    axis.exists = axis.channel != 0 && !hypothetical;
    axis.rotary = p::bit(t, p::n0106_axis_properties, a, 1);
    axis.diameter = p::bit(t, p::n0106_axis_properties, a, 0) && !axis.rotary;
    // Parameters are in the machine's unit (1.3): inch only for linear axes of a channel with IND.
    const bool inch =
        axis.channel && !axis.rotary && p::bit(t, p::n0104_unit_of_measure, axis.channel, 0);
    const double unit = inch ? kMmPerInch : 1.0;
    axis.inch = inch;
    axis.rapid = p::get(t, p::n0304_rapid, a) * unit / 60.0;
    axis.rapid_share = static_cast<double>(p::get(t, p::n0422_rapid_reduct_ratio, a)) / 100.0;
    axis.max_feed = p::get(t, p::n0305_max_feed, a) * unit / 60.0;
    axis.manual_rapid = p::get(t, p::n0314_manual_rapid, a) * unit / 60.0;
    axis.jog_max_feed = p::get(t, p::n0315_jog_max_feed, a) * unit / 60.0;
    axis.setup_feed = p::get(t, p::pt_setup_feed, a) * unit / 60.0;
    axis.acceleration = p::get(t, p::n0400_acceleration, a) * unit;
    axis.normal_acceleration = p::get(t, p::n0402_normal_acc, a) * unit;
    const double rise = p::get(t, p::n0401_acc_tc, a);
    axis.jerk = rise > 0 ? axis.acceleration / rise : kUnlimited;
    axis.servo = read_servo(t, a, unit);
    axis.reference = read_reference(t, a, unit);
    if (p::bit(t, p::n0106_axis_properties, a, 3))
        axis.index_step = p::get(t, p::n0110_indexing_amount, a) * unit;
    if (axis.rotary && p::bit(t, p::n0107_rollover_control, a, 0))
        axis.rollover = p::get(t, p::n0108_rollamount, a);
    for (unsigned n = 0; n < 8; ++n)
        axis.handle |= p::bit(t, p::n2400_handle_direction, a, n) ? 1u << n : 0u;
    axis.lubrication = p::get(t, p::n1273_lubrication_distance, a) * unit;
    axis.gear_retract = p::get(t, p::n1804_retr_dist, a) * unit;
    axis.retract = p::get(t, p::pt_retract, a) * unit;
    axis.counts_other_way = p::bit(t, p::n2105_composit_config, a, 0);
    axis.hypothetical = hypothetical;
    axis.measured_only = assigned == 99 || p::bit(t, p::n0106_axis_properties, a, 4);
    name_axis(t, a, axis);
    if (axis.exists) axis.stroke = read_axis_stroke(t, a);
    axis.estop_deceleration = p::get(t, p::pt_estop_dec, a) * unit;
    return axis;
}

ChannelConfig read_channel(const p::Table& t, unsigned l) {
    ChannelConfig channel;
    channel.group = static_cast<std::uint32_t>(p::get(t, p::n0000_machine_group, l));
    channel.exists = channel.group != 0;
    channel.default_spindle = static_cast<std::uint32_t>(p::get(t, p::n0604_default_spindle, l));
    channel.jog_feed_source = p::get(t, p::n0316_jog_f_contr, l);
    channel.jog_feed = p::get(t, p::n0317_jog_f_g94, l) *
                       (p::bit(t, p::n0104_unit_of_measure, l, 0) ? kMmPerInch : 1.0) / 60.0;
    channel.contour_tolerance = p::get(t, p::pt_contour_tol, l);
    channel.gear_opens = p::bit(t, p::n1800_egb_contr, l, 0);
    channel.gear_retract_feed = p::get(t, p::n1805_retr_feed, l) *
                                (p::bit(t, p::n0104_unit_of_measure, l, 0) ? kMmPerInch : 1.0) /
                                60.0;
    channel.surface_speed_axis =
        static_cast<std::uint32_t>(p::get(t, p::n0687_default_g96_axis, l));
    channel.surface_speed_min_rpm =
        static_cast<double>(p::get(t, p::n0688_min_spindle_speed_g96, l));
    channel.in_position_timeout_s = p::get(t, p::n1340_inpos_timeout, l);
    channel.increments = p::get(t, p::n0105_increment_system, l);
    channel.handwheel_time_s = p::get(t, p::pt_wheel_time, l);
    channel.feed_needs_spindle = p::get(t, p::pt_feed_waits, l) != 0;
    for (unsigned n = 0; n < 3; ++n)
        channel.aux_letters[n] =
            static_cast<char>(p::get(t, p::nth(p::n1333_aux_fu_addr1, n + 1), l));
    channel.inch = p::bit(t, p::n0104_unit_of_measure, l, 0);
    const double unit = channel.inch ? kMmPerInch : 1.0;
    channel.jog_feed_rev = p::get(t, p::n0318_jog_f_g95, l) * unit;
    channel.measure_feed = p::get(t, p::n0319_t_meas_feed, l) * unit / 60.0;
    channel.rapid_key_factor = p::get(t, p::n0313_feed_mult, l);
    channel.feed_override_in_rapid = p::get(t, p::fg_rapidovr, l) != 0;
    channel.language = dialect_of(p::get_text(t, p::pt_language, l));
    // such a switch has 120 % at its end, and MAXFOVR caps it (fagor part 1, 5.2)
    channel.feed_override_end =
        std::fmin(static_cast<double>(p::get(t, p::fg_maxfovr, l)), 120.0) / 100.0;
    channel.parts_wanted = p::get(t, p::n2308_no_of_parts_reqrd, l);
    channel.stops_at_wanted = p::get(t, p::pt_parts_stop, l) != 0;
    channel.default_feed = p::get(t, p::n0300_default_f_g94, l) * unit / 60.0;
    channel.default_feed_rev = p::get(t, p::n0301_default_f_g95, l) * unit;
    channel.per_revolution = p::bit(t, p::n1301_defaultg2, l, 0);
    channel.stroke = read_channel_stroke(t, l);
    channel.rapid_overlaps = p::bit(t, p::n0421_acc_contr, l, 0);
    channel.reads_one_block_ahead = !p::bit(t, p::n1301_defaultg2, l, 6);
    if (channel.group >= 1 && channel.group <= kMaxGroups) {
        channel.wait_timeout_s = p::get(t, p::pt_wait_timeout, channel.group);
        channel.partner_death =
            static_cast<PartnerDeath>(p::get(t, p::pt_partner_death, channel.group));
    }
    return channel;
}
}  // namespace

void read_config(const params::Table& t, KernelConfig& config, bool first) {
    config.axis_count = config.spindle_count = 0;
    for (unsigned a = 1; a <= kMaxAxes; ++a) {
        config.axes[a - 1] = read_axis(t, a);
        if (config.axes[a - 1].exists) config.axis_count = a;
    }
    for (unsigned s = 1; s <= kMaxSpindles; ++s) {
        config.spindles[s - 1] = read_spindle(t, s);
        if (config.spindles[s - 1].exists) config.spindle_count = s;
    }
    for (unsigned a = 1; a <= config.axis_count; ++a) {
        AxisConfig& axis = config.axes[a - 1];
        const auto address = p::get(t, p::n0503_axis_output_address, a);
        if (!axis.exists || !axis.rotary || address == 0) continue;
        for (unsigned s = config.spindle_count; s >= 1; --s)
            if (config.spindles[s - 1].exists &&
                p::get(t, p::n0603_spindle_output_address, s) == address)
                axis.on_spindle = s;
    }
    for (unsigned l = 1; l <= kMaxChannels; ++l) config.channels[l - 1] = read_channel(t, l);
    // N0421 JRK: acceleration that rises without a step of its slope. All axes of a channel wait
    // alike, so that their path stays.
    constexpr double kShareOfRise = 0.5;
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        if (!p::bit(t, p::n0421_acc_contr, l, 1)) continue;
        double rise_s = 0;
        for (unsigned a = 1; a <= kMaxAxes; ++a)
            if (config.axes[a - 1].exists && config.axes[a - 1].channel == l)
                rise_s = std::max(rise_s, p::get(t, p::n0401_acc_tc, a));
        for (AxisConfig& axis : config.axes)
            if (axis.exists && axis.channel == l) axis.servo.smooth_s = kShareOfRise * rise_s;
    }
    for (unsigned n = 1; n <= config.switches.size(); ++n) {
        PositionSwitch& sw = config.switches[n - 1];
        sw.axis = static_cast<std::uint32_t>(p::get(t, p::nth(p::n1101_sw1_axis_number, n)));
        const AxisConfig* axis =
            sw.axis >= 1 && sw.axis <= kMaxAxes ? &config.axes[sw.axis - 1] : nullptr;
        const bool inch = axis && axis->channel && !axis->rotary &&
                          p::bit(t, p::n0104_unit_of_measure, axis->channel, 0);
        sw.low = p::get(t, p::nth(p::n1133_sw1_min_pos, n)) * (inch ? kMmPerInch : 1.0);
        sw.high = p::get(t, p::nth(p::n1165_sw1_max_pos, n)) * (inch ? kMmPerInch : 1.0);
    }
    config.channel_timeout_s = p::get(t, p::pt_channel_timeout);
    config.supervisor_timeout_s = p::get(t, p::pt_supervisor_timeout);
    config.late_max_ticks = p::get(t, p::pt_late_max);
    config.drive_lost = static_cast<std::uint16_t>(p::get(t, p::pt_drive_lost));
    for (AxisConfig& axis : config.axes) axis.servo.drive_lost = config.drive_lost;
    for (SpindleConfig& spindle : config.spindles) spindle.drive_lost = config.drive_lost;
    for (AxisConfig& axis : config.axes) axis.tick_s = config.tick_s;
    if (!first) return;
    const auto tick_us = p::get(t, p::n0005_nc_cycle_time);
    config.tick_ns = tick_us > 0 ? tick_us * 1000 : automatic_tick_ns(config);
    config.tick_s = static_cast<double>(config.tick_ns) * 1e-9;
    for (AxisConfig& axis : config.axes) axis.tick_s = config.tick_s;
    config.history = static_cast<std::uint32_t>(p::get(t, p::pt_history));
    config.horizon = static_cast<std::uint32_t>(p::get(t, p::pt_horizon));
    config.plc_cycle_ticks =
        std::max<std::int64_t>(1, p::get(t, p::pt_plc_cycle) * 1'000'000 / config.tick_ns);
    config.answer_ticks = p::get(t, p::pt_answer_ticks);
}

}  // namespace polyturn::kernel
