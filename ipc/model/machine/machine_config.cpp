#include "ipc/model/machine/machine_config.hpp"

#include <algorithm>
#include <limits>

#include "ipc/model/machine/reference_position.hpp"

namespace polyturn {
namespace {

using namespace params;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::int64_t kMeasuredOnly = 99;  // N0002

template <std::size_t kSize>
void copy_text(char (&to)[kSize], std::string_view from) noexcept {
    const std::size_t count = std::min(from.size(), kSize - 1);
    std::memcpy(to, from.data(), count);
    std::memset(to + count, 0, kSize - count);
}

// 0 in the second character ends the name, whatever the third says (part 1, 3.1).
void put_name(char (&to)[4], std::int64_t first, std::int64_t second, std::int64_t third) noexcept {
    std::memset(to, 0, sizeof to);
    if (first == 0) return;
    to[0] = static_cast<char>(first);
    if (second == 0) return;
    to[1] = static_cast<char>(second);
    to[2] = static_cast<char>(third);
}

ChannelConfig channel_config(const Table& t, unsigned l) noexcept {
    ChannelConfig c{};
    c.group = static_cast<std::uint16_t>(get(t, n0000_machine_group, l));
    if (c.group == 0) return c;
    c.number = static_cast<std::uint16_t>(l);
    c.kind = get(t, n0001_control_type, l) == 1 ? ChannelKind::Mill : ChannelKind::Lathe;
    c.inch = bit(t, n0104_unit_of_measure, l, 0);
    c.increment_system = static_cast<std::uint8_t>(get(t, n0105_increment_system, l));
    c.offset_count = static_cast<std::uint16_t>(get(t, n1400_no_of_tool_offsets, l));
    copy_text(c.name, get_text(t, n0003_channel_name, l));
    const double per_minute = c.length_unit_mm() / 60.0;
    c.corner_by_axis_step = bit(t, n0306_feed_control, l, 0);
    c.corner_angle_deg = get(t, n0307_crit_a_diff, l);
    c.corner_feed_mm_s = get(t, n0308_feed_corn, l) * per_minute;
    c.arc_feed_min_mm_s = get(t, n0310_circ_f_min, l) * per_minute;
    return c;
}

AxisLimits axis_limits(const Table& t, unsigned a, double unit) noexcept {
    const double per_minute = unit / 60.0;
    AxisLimits m{};
    m.rapid_mm_s = get(t, n0304_rapid, a) * per_minute;
    m.max_feed_mm_s = get(t, n0305_max_feed, a) * per_minute;
    m.manual_rapid_mm_s = get(t, n0314_manual_rapid, a) * per_minute;
    m.jog_feed_mm_s = get(t, n0315_jog_max_feed, a) * per_minute;
    m.ref_rapid_mm_s = get(t, n0302_ref_rapid, a) * per_minute;
    m.ref_feed_mm_s = get(t, n0303_ref_feed, a) * per_minute;
    m.accel_mm_s2 = get(t, n0400_acceleration, a) * unit;
    const double rise_s = get(t, n0401_acc_tc, a);
    m.jerk_mm_s3 = rise_s > 0 ? m.accel_mm_s2 / rise_s : kInfinite;
    m.normal_accel_mm_s2 = get(t, n0402_normal_acc, a) * unit;
    m.speed_step_mm_s = get(t, n0309_crit_f_diff, a) * per_minute;
    m.accel_step_mm_s2 = get(t, n0403_acc_diff, a) * unit;
    m.accel_step_arc_mm_s2 = get(t, n0404_acc_diff_circ, a) * unit;
    return m;
}

AxisConfig axis_config(const Table& t, unsigned a, const MachineConfig& machine) noexcept {
    AxisConfig x{};
    x.slot = kNoSlot;
    const std::int64_t owner = get(t, n0002_axis_assign, a);
    if (owner == 0) return x;
    const bool assigned = owner >= 1 && owner <= static_cast<std::int64_t>(kMaxChannels);
    if (!assigned && owner != kMeasuredOnly) return x;
    if (assigned && !machine.channel(static_cast<std::size_t>(owner)).exists()) return x;
    x.number = static_cast<std::uint16_t>(a);
    x.channel = assigned ? static_cast<std::uint16_t>(owner) : std::uint16_t{0};
    put_name(x.name, get(t, n0100_axis_name1, a), get(t, n0101_axis_name2, a),
             get(t, n0102_axis_name3, a));
    const std::int64_t role = get(t, n0103_axis_to_plane, a);
    x.role = role == 4 ? PlaneRole::None : static_cast<PlaneRole>(role);
    x.rotary = bit(t, n0106_axis_properties, a, 1);
    x.diameter = bit(t, n0106_axis_properties, a, 0) && !x.rotary;
    x.offset_diameter = x.diameter && !(assigned && bit(t, f5004, static_cast<unsigned>(owner), 1));
    x.indexed = bit(t, n0106_axis_properties, a, 3);
    x.measured_only = !assigned || bit(t, n0106_axis_properties, a, 4);
    x.hypothetical = bit(t, n0106_axis_properties, a, 7);
    x.rollover =
        x.rotary && bit(t, n0107_rollover_control, a, 0) && get(t, n0108_rollamount, a) > 0;
    x.rollover_shortest = bit(t, n0107_rollover_control, a, 1);
    x.rollover_sign_is_direction = bit(t, n0107_rollover_control, a, 2) && !x.rollover_shortest;
    x.rollover_reduces_increments = bit(t, n0107_rollover_control, a, 3);
    x.rollover_deg = get(t, n0108_rollamount, a);

    const double unit = x.rotary || !assigned ? 1.0 : machine.channel(x.channel).length_unit_mm();
    x.index_step_mm = get(t, n0110_indexing_amount, a) * unit;
    x.reference_mm = {reference_position(t, a) * unit, get(t, n0201_reference_position2, a) * unit,
                      get(t, n0202_reference_position3, a) * unit,
                      get(t, n0203_reference_position4, a) * unit};
    x.limits = axis_limits(t, a, unit);
    x.stroke = {bit(t, n1000_range_enable, a, 0), get(t, n1002_range1a_positive, a) * unit,
                get(t, n1003_range1a_negative, a) * unit, get(t, n1004_range1b_positive, a) * unit,
                get(t, n1005_range1b_negative, a) * unit};
    x.position_gain_1_s = get(t, n0504_position_gain, a);
    x.feed_forward = bit(t, n0515_feed_forward_control, a, 0) ? get(t, n0511_feedforward, a) : 0.0;
    x.in_position_mm = get(t, n0516_inpos, a) * unit;
    return x;
}

SpindleConfig spindle_config(const Table& t, unsigned s) noexcept {
    SpindleConfig c{};
    if (!bit(t, n0607_spindle_config, s, 0)) return c;
    c.number = static_cast<std::uint16_t>(s);
    put_name(c.name, 'S', get(t, n0605_spindle_name2, s), get(t, n0606_spindle_name3, s));
    c.can_orient = bit(t, n0607_spindle_config, s, 1);
    c.can_index = bit(t, n0607_spindle_config, s, 2);
    c.override_in_thread = bit(t, n0607_spindle_config, s, 5);
    c.inverted_indexing = bit(t, n0607_spindle_config, s, 7);
    c.encoder_counts = static_cast<double>(get(t, n0608_spindle_encoder_counts, s));
    c.speed_tolerance_percent = get(t, n0627_s_n, s);
    c.speed_tolerance_rpm = get(t, n0628_s_nw, s);
    c.standstill_rpm = get(t, n0629_s_n0, s);
    for (unsigned n = 1; n <= 8; ++n) {
        GearRange& r = c.range[n - 1];
        r.full_scale_rpm = get(t, nth(n0634_r1_s_calibration, n), s);
        r.min_rpm = get(t, nth(n0642_r1_s_min, n), s);
        r.max_rpm = get(t, nth(n0650_r1_s_max, n), s);
        r.ramp_up_rpm_s = get(t, nth(n0666_r1_s_ramp_up, n), s);
        r.ramp_down_rpm_s = get(t, nth(n0674_r1_s_ramp_down, n), s);
    }
    return c;
}

// Gives the channel's named axes their slots in ascending order of axis number.
void assign_slots(MachineConfig& machine) noexcept {
    for (AxisConfig& x : machine.axes) {
        if (!x.exists() || x.channel == 0 || x.name[0] == 0) continue;
        ChannelConfig& c = machine.channels[x.channel - 1u];
        if (c.axis_count == kChannelAxes) continue;
        x.slot = c.axis_count;
        c.axes[c.axis_count++] = x.number;
    }
}

// A C axis and its spindle are one motor: they carry the same output address (part 1, 7.1).
void find_shared_drives(MachineConfig& machine, const Table& t) noexcept {
    for (AxisConfig& x : machine.axes) {
        if (!x.exists()) continue;
        const std::int64_t address = get(t, n0503_axis_output_address, x.number);
        if (address == 0) continue;
        for (const SpindleConfig& s : machine.spindles)
            if (s.exists() && get(t, n0603_spindle_output_address, s.number) == address) {
                x.on_spindle = s.number;
                break;
            }
    }
}

std::uint16_t count_and_last(const auto& items, std::uint16_t& last) noexcept {
    std::uint16_t count = 0;
    for (const auto& item : items)
        if (item.exists()) {
            ++count;
            last = item.number;
        }
    return count;
}

}  // namespace

std::uint32_t auto_tick_us(std::size_t channels_with_axes) noexcept {
    return channels_with_axes <= 2 ? 1000 : channels_with_axes <= 4 ? 2000 : 5000;
}

MachineConfig derive_machine_config(const Table& table) noexcept {
    MachineConfig m{};
    for (unsigned l = 1; l <= kMaxChannels; ++l) m.channels[l - 1] = channel_config(table, l);
    for (unsigned a = 1; a <= kMaxAxes; ++a) m.axes[a - 1] = axis_config(table, a, m);
    for (unsigned s = 1; s <= kMaxSpindles; ++s) m.spindles[s - 1] = spindle_config(table, s);
    assign_slots(m);
    find_shared_drives(m, table);
    m.channel_count = count_and_last(m.channels, m.last_channel);
    m.axis_count = count_and_last(m.axes, m.last_axis);
    m.spindle_count = count_and_last(m.spindles, m.last_spindle);

    std::array<bool, kMaxChannels> owns{};
    for (const AxisConfig& x : m.axes)
        if (x.channel != 0) owns[x.channel - 1u] = true;
    const auto tick_us = get(table, n0005_nc_cycle_time);
    m.tick_us =
        tick_us > 0
            ? static_cast<std::uint32_t>(tick_us)
            : auto_tick_us(static_cast<std::size_t>(std::count(owns.begin(), owns.end(), true)));
    m.wait_code_min = static_cast<double>(get(table, n2201_waiting_m_codes_min));
    m.wait_code_max = static_cast<double>(get(table, n2202_waiting_m_codes_max));

    for (ChannelConfig& c : m.channels) {
        if (!c.exists()) continue;
        const auto spindle = get(table, n0604_default_spindle, c.number);
        if (spindle >= 1 && spindle <= static_cast<std::int64_t>(kMaxSpindles) &&
            m.spindle(static_cast<std::size_t>(spindle)).exists())
            c.default_spindle = static_cast<std::uint16_t>(spindle);
        const auto axis = get(table, n0687_default_g96_axis, c.number);
        if (axis >= 1 && axis <= static_cast<std::int64_t>(kMaxAxes) &&
            m.axis(static_cast<std::size_t>(axis)).channel == c.number)
            c.surface_speed_axis = static_cast<std::uint16_t>(axis);
        // Without the parameter the diameter is that of the channel's basic X axis.
        if (axis == 0)
            if (const AxisConfig* x = find_axis(m, c.number, PlaneRole::BasicX))
                c.surface_speed_axis = x->number;
    }
    return m;
}

std::uint32_t MachineConfig::channels_of_group(std::size_t group) const noexcept {
    std::uint32_t mask = 0;
    for (const ChannelConfig& c : channels)
        if (c.exists() && c.group == group) mask |= 1u << (c.number - 1u);
    return mask;
}

const AxisConfig* find_axis(const MachineConfig& machine, std::size_t channel,
                            std::string_view name) noexcept {
    if (channel < 1 || channel > kMaxChannels) return nullptr;
    for (const std::uint16_t number : machine.channel(channel).axis_numbers())
        if (machine.axis(number).name_text() == name) return &machine.axis(number);
    return nullptr;
}

const AxisConfig* find_axis(const MachineConfig& machine, std::size_t channel,
                            PlaneRole role) noexcept {
    if (channel < 1 || channel > kMaxChannels) return nullptr;
    for (const std::uint16_t number : machine.channel(channel).axis_numbers())
        if (machine.axis(number).role == role) return &machine.axis(number);
    return nullptr;
}

const SpindleConfig* find_spindle(const MachineConfig& machine, std::string_view name) noexcept {
    for (const SpindleConfig& s : machine.spindles)
        if (s.exists() && s.name_text() == name && name != "S") return &s;
    if (name.size() < 2 || name[0] != 'S') return nullptr;
    std::size_t number = 0;
    for (const char c : name.substr(1)) {
        if (c < '0' || c > '9' || number > kMaxSpindles) return nullptr;
        number = number * 10 + static_cast<std::size_t>(c - '0');
    }
    if (number < 1 || number > kMaxSpindles || !machine.spindle(number).exists()) return nullptr;
    return &machine.spindle(number);
}

}  // namespace polyturn
