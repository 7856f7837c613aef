#include "kernel/config/spindle_config.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace p = params;

namespace {
constexpr double kLargestCounts = 16'777'216;  // the simulated encoder's
// rev/s3 where no time constant is given: as good as a step
constexpr double kStiffJerk = 1e6;

SpindleRange read_range(const p::Table& t, unsigned s, unsigned n, double counts) {
    const auto real = [&](auto first) {
        return static_cast<double>(p::get(t, p::nth(first, n), s));
    };
    const auto ramp = [](double rpm_per_s) {
        return rpm_per_s > 0 ? rpm_per_s : std::numeric_limits<double>::infinity();
    };
    const auto rise = [](double acceleration, double time_s) {
        return time_s > 0 ? acceleration / time_s : kStiffJerk;
    };
    SpindleRange r;
    r.multiply = real(p::n0611_r1_s_multiply);
    r.divide = real(p::n0619_r1_s_divide);
    r.calibration = real(p::n0634_r1_s_calibration);
    r.speed_min = real(p::n0642_r1_s_min);
    r.speed_max = real(p::n0650_r1_s_max);
    r.creep = real(p::n0658_r1_s_jog_speed);
    r.ramp_up = ramp(real(p::n0666_r1_s_ramp_up));
    r.ramp_down = ramp(real(p::n0674_r1_s_ramp_down));
    r.rapid = real(p::n0320_r1_s_rapid) / 60.0;
    r.feed_max = real(p::n0328_r1_s_f_max) / 60.0;
    r.acceleration = real(p::n0405_r1_s_acc);
    r.jerk = rise(r.acceleration, real(p::n0413_r1_s_acc_tc));
    r.gain = real(p::n0701_r1_spindle_gain);
    r.command_filter_s = real(p::n0710_r1_s_time_constant1);
    r.equalise_s = real(p::n0718_r1_s_time_constant2);
    r.dead_time_s = real(p::n0726_r1_s_dead_time);
    r.feedforward = real(p::n0734_r1_s_feedforward);
    r.in_position = real(p::n0744_r1_s_inpos);
    r.model_s = real(p::n0753_r1_s_time_constant3);
    r.error_standing = real(p::n0761_r1_s_serrl1);
    r.error_moving = real(p::n0769_r1_s_serrl2);
    r.error_absolute = real(p::n0777_r1_s_serrl3);
    r.orient_speed = real(p::n0801_r1_s_orientspeed);
    r.backlash = counts > 0 ? real(p::n0809_r1_s_backlash) / counts : 0.0;
    r.synchr_gain = real(p::n0785_r1_s_synchr_k);
    r.tap_acceleration = real(p::n1508_r1_acc_in_tapping);
    r.tap_jerk = rise(r.tap_acceleration, real(p::n1516_r1_acc_tc_in_tapping));
    r.out_acceleration = real(p::n1524_r1_acc_in_extract);
    r.tap_gain = real(p::n1532_r1_tapping_gain);
    return r;
}
}  // namespace

SpindleConfig read_spindle(const params::Table& t, unsigned s) {
    const auto is = [&](unsigned number) { return p::bit(t, p::n0607_spindle_config, s, number); };
    const auto encoder = [&](unsigned number) {
        return p::bit(t, p::n0609_spindle_encoder_config, s, number);
    };
    SpindleConfig c;
    c.encoder_unwatched = encoder(6);
    const double full_volts = p::get(t, p::n0682_spindle_analog_adjust, s);
    if (full_volts >= 10.0) c.output_scale = 10.0 / full_volts;
    c.output_offset = p::get(t, p::n0683_spindle_speed_offset, s) / 10.0;
    c.exists = is(0);
    c.can_orient = is(1);
    c.can_close = is(2);
    c.index_by_code = !is(3);
    c.search_always = is(4);
    c.override_in_thread = is(5);
    c.override_min = static_cast<double>(p::get(t, p::fg_minsovr, s)) / 100.0;
    c.override_max = static_cast<double>(p::get(t, p::fg_maxsovr, s)) / 100.0;
    c.absolute = is(6);
    c.index_negative = is(7);
    c.output_inverted = encoder(0);
    c.counts_inverted = encoder(c.absolute ? 2 : 1);
    c.orient_by = encoder(4)   ? OrientBy::Switch
                  : encoder(3) ? OrientBy::Probe
                               : OrientBy::ZeroPulse;
    c.unsigned_speed = encoder(5);
    c.encoder_counts = static_cast<double>(p::get(t, p::n0608_spindle_encoder_counts, s));
    const auto simulated = static_cast<double>(p::get(t, p::pt_encoder_counts, s));
    c.drive_source = static_cast<DriveSource>(p::get(t, p::pt_spindle_drive, s));
    // of an absolute encoder's turn
    const auto bits = static_cast<double>(p::get(t, p::n0691_endat_resolution, s));
    const double absolute =
        c.absolute && bits > 0 ? std::fmin(std::exp2(bits), kLargestCounts) : 0.0;
    c.drive_counts_fit = simulated <= 0 && absolute <= 0;
    c.drive_counts = simulated > 0          ? simulated
                     : absolute > 0         ? absolute
                     : c.encoder_counts > 0 ? std::fmin(c.encoder_counts, kLargestCounts)
                                            : 4096.0;
    c.speed_filter_s = p::get(t, p::n0610_spindle_n_time_constant, s);
    c.tolerance_percent = static_cast<double>(p::get(t, p::n0627_s_n, s));
    c.tolerance_rpm = static_cast<double>(p::get(t, p::n0628_s_nw, s));
    c.standstill_rpm = static_cast<double>(p::get(t, p::n0629_s_n0, s));
    c.watch_time_s = p::get(t, p::n0630_s_time, s);
    c.watch_start_percent = static_cast<double>(p::get(t, p::n0631_s_scerr, s));
    c.watch_percent = static_cast<double>(p::get(t, p::n0632_s_fluct, s));
    c.watch_rpm = static_cast<double>(p::get(t, p::n0633_s_fluctw, s));
    c.grid_shift =
        c.encoder_counts > 0
            ? static_cast<double>(p::get(t, p::n0684_spindle_grid_shift, s)) / c.encoder_counts
            : 0.0;
    c.setup_rpm = p::get(t, p::pt_setup_speed, s);
    c.basic_angle = p::get(t, p::n0822_basic_angle_of_spnd_pos, s) / 360.0;
    c.loop_stays_open = p::bit(t, p::n0742_spindle_servo_control, s, 7);
    c.feedforward = p::bit(t, p::n0743_spindle_feedforward_control, s, 0);
    c.feedforward_in_rapid = p::bit(t, p::n0743_spindle_feedforward_control, s, 1);
    for (SpindleRange& range : c.range)
        range.drift_s = p::get(t, p::n0709_s_position_drift_compensation, s);
    c.in_position_timeout_s = static_cast<double>(p::get(t, p::n0752_s_inpos_timeout, s));
    c.sync_master = static_cast<std::uint32_t>(p::get(t, p::pt_spindle_master, s));
    c.sync_code = static_cast<std::int32_t>(p::get(t, p::pt_sync_code, s));
    c.phase_code = static_cast<std::int32_t>(p::get(t, p::pt_phase_code, s));
    c.sync_turns = static_cast<double>(p::get(t, p::pt_sync_turns, s));
    c.sync_master_turns = static_cast<double>(p::get(t, p::pt_sync_master_turns, s));
    c.phase_shift =
        c.encoder_counts > 0
            ? static_cast<double>(p::get(t, p::n0685_spindle_phase_shift, s)) / c.encoder_counts
            : 0.0;
    c.sync_window = p::get(t, p::pt_sync_window, s) / 360.0;
    c.sync_error = p::get(t, p::pt_sync_error, s) / 360.0;
    for (unsigned n = 1; n <= kGearRanges; ++n)
        c.range[n - 1] = read_range(t, s, n, c.encoder_counts);
    return c;
}

}  // namespace polyturn::kernel
