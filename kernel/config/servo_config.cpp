#include "kernel/config/servo_config.hpp"

#include <algorithm>

#include "ipc/model/machine/reference_position.hpp"

namespace polyturn::kernel {

ServoConfig read_servo(const params::Table& t, unsigned a, double unit) noexcept {
    using namespace params;
    ServoConfig s;
    const double speed = unit / 60.0;
    s.gain = get(t, n0504_position_gain, a);
    if (bit(t, n0515_feed_forward_control, a, 0)) {
        s.feedforward = get(t, n0511_feedforward, a);
        s.feedforward_in_rapid = bit(t, n0515_feed_forward_control, a, 1);
        // They delay the command of the error only as far as feed-forward needs it.
        s.equal_s = get(t, n0509_time_constant2, a);
        s.dead_s = get(t, n0510_dead_time, a);
    }
    // A full scale below rapid was never entered: it would make every rapid a following error.
    const double full = get(t, n0505_position_calibration, a) * speed;
    const double fastest = std::max(get(t, n0304_rapid, a), get(t, n0305_max_feed, a)) * speed;
    s.full_speed = full >= fastest ? full : 0.0;
    s.offset = get(t, n0506_position_offset, a) * unit;
    s.drift_s = get(t, n0507_position_drift_compensation, a);
    s.filter_s = get(t, n0508_time_constant1, a);
    s.threshold = get(t, n0540_threshold, a) * unit;
    s.multiply = std::max<std::int64_t>(1, get(t, n0512_multiply, a));
    s.divide = std::max<std::int64_t>(1, get(t, n0513_divide, a));
    const bool absolute = bit(t, n0900_reference_type, a, 2) || bit(t, n0900_reference_type, a, 3);
    s.output_inverted = bit(t, n0514_servo_control, a, 0);
    s.input_inverted = bit(t, n0514_servo_control, a, absolute ? 2 : 1);
    s.no_count_open = bit(t, n0514_servo_control, a, 4);
    s.follow_up = bit(t, n0514_servo_control, a, 5);
    s.encoder_unwatched = bit(t, n0514_servo_control, a, 6);
    s.open = bit(t, n0514_servo_control, a, 7);
    s.backlash = get(t, n0523_backlash, a) * unit;
    s.reversal_boost = bit(t, n0525_compensation_control, a, 0);
    s.boost_ends_by_way = bit(t, n0525_compensation_control, a, 1);
    s.start_boost = bit(t, n0525_compensation_control, a, 2);
    s.start_ends_by_way = bit(t, n0525_compensation_control, a, 3);
    s.reversal_speed = get(t, n0526_backlash_acc_amount, a) * speed;
    s.reversal_s = get(t, n0527_backlash_acc_period, a);
    s.reversal_travel = get(t, n0528_backlash_acc_distance, a) * unit;
    s.start_speed = get(t, n0529_friction_comp_amount, a) * speed;
    s.stood_s = get(t, n0530_stop_judgement_period, a);
    s.start_travel = get(t, n0531_friction_comp_distance, a) * unit;
    s.fade = get(t, n0532_compensation_a_x_multiplier, a);
    s.tandem_master = static_cast<std::uint32_t>(get(t, n0533_tandem_master, a));
    s.dual_axis = static_cast<std::uint32_t>(get(t, n0534_dual_position_axis_number, a));
    s.dual_s = get(t, n0535_dual_position_delay_time, a);
    s.dual_error = get(t, n0536_dual_position_difference_error, a) * unit;
    s.dual_most = get(t, n0537_dual_position_maximum_value, a) * unit;
    s.dual_least = get(t, n0538_dual_position_minimum_value, a) * unit;
    s.in_position = get(t, n0516_inpos, a) * unit;
    s.model_s = get(t, n0518_time_constant3, a);
    s.error_standing = get(t, n0519_serrl1, a) * unit;
    s.error_seeking = get(t, n3019_servo_limit_during_torque_limit_skip, a) * unit;
    s.error_moving = get(t, n0520_serrl2, a) * unit;
    s.error_absolute = get(t, n0521_serrl3, a) * unit;
    s.drive_source = static_cast<DriveSource>(get(t, pt_drive, a));
    s.position_mode = get(t, pt_drive_mode, a) == 1;
    s.drive_hz = get(t, pt_drive_freq, a);
    s.drive_damping = get(t, pt_drive_damping, a);
    s.drive_backlash = get(t, pt_drive_backlash, a);
    s.drive_friction = get(t, pt_drive_friction, a);
    s.drive_drift = get(t, pt_drive_drift, a);
    s.drive_stop = get(t, pt_drive_stop, a);
    s.drive_held = get(t, pt_drive_held, a);
    s.stop_error = get(t, pt_stop_error, a) * unit;
    s.stop_window = get(t, pt_stop_window, a) * unit;
    s.drive_scale = get(t, pt_drive_scale, a) != 0;
    return s;
}

ReferenceConfig read_reference(const params::Table& t, unsigned a, double unit) noexcept {
    using namespace params;
    ReferenceConfig r;
    r.by_switch = bit(t, n0900_reference_type, a, 0);
    r.by_pulse = bit(t, n0900_reference_type, a, 1);
    r.coded = bit(t, n0900_reference_type, a, 2);
    r.absolute = bit(t, n0900_reference_type, a, 3);
    r.floating = bit(t, n0900_reference_type, a, 4);
    r.negative = bit(t, n0900_reference_type, a, 5);
    r.on_switch = bit(t, n0900_reference_type, a, 7);
    r.rapid = get(t, n0302_ref_rapid, a) * unit / 60.0;
    r.feed = get(t, n0303_ref_feed, a) * unit / 60.0;
    r.distance = get(t, n0901_reference_distance, a) * unit;
    r.switch_length = get(t, n0902_switch_length, a) * unit;
    r.switch_shift = get(t, n0903_switch_shift, a) * unit;
    r.pulse_distance = get(t, n0904_zerodis, a) * unit;
    r.periods = static_cast<double>(get(t, n0905_basdist, a));
    r.shift = get(t, n0906_reference_shift, a) * unit;
    r.position = reference_position(t, a) * unit;
    r.encoder_zero = get(t, n0907_endat_machine_reference, a) * unit;
    if (r.absolute && !r.floating)
        r.encoder_bits = static_cast<unsigned>(get(t, n0524_endat_resolution, a));
    r.keeps_rounds = bit(t, n0900_reference_type, a, 6);
    r.rounds = get(t, n0908_endat_round_number, a);
    r.alarm_distance = get(t, n0909_abs_position_alarm_distance, a) * unit;
    r.order = static_cast<std::uint32_t>(get(t, pt_ref_order, a));
    return r;
}

}  // namespace polyturn::kernel
