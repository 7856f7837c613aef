// Moves: from a target in the workpiece system to what the machine's axes do.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/state/core.hpp"

namespace polyturn::channels {
namespace {

constexpr double kSame = 1e-9;        // mm: no movement
constexpr double kSamePoint = 1e-7;   // mm: an arc that ends where it starts is a full circle
constexpr double kLimitSlack = 1e-6;  // mm: exactly on the limit is inside
constexpr double kTurn = 2.0 * std::numbers::pi;

double wrapped(double value, double period) { return value - std::floor(value / period) * period; }

}  // namespace

double Core::rollover_target(unsigned i, double word, bool absolute) {
    const ChannelAxis& axis = view_->axes[i];
    const double period = axis.rollover_deg, now = path.programmed[i];
    double distance = 0.0;
    if (!absolute) {
        distance = axis.rollover_reduces_increments ? std::fmod(word, period) : word;
    } else if (axis.rollover_shortest) {
        distance = wrapped(word, period) - now;
        if (distance > period / 2) distance -= period;
        if (distance <= -period / 2) distance += period;  // half a turn goes in positive direction
    } else {
        const double target =
            wrapped(axis.rollover_sign_is_direction ? std::fabs(word) : word, period);
        // the sign of a position: 0 is positive (part 1, 3.5)
        const bool backwards = axis.rollover_sign_is_direction ? std::signbit(word) : word < 0;
        distance = backwards ? -wrapped(now - target, period) : wrapped(target - now, period);
    }
    return now + distance;
}

// Fills start, end and the set of moving axes of move_. I2: path is untouched.
bool Core::begin_move(const AxisValues& target, MoveKind kind) {
    const unsigned count = view_->axis_count;
    AxisSet moved = forced_;
    forced_ = 0;
    factors_off_ = false;
    if (path.framed && !frame_reachable(target)) return false;
    const AxisValues& point = path.framed ? framed_ = framed(target) : target;
    AxisValues along{};  // that the table takes the workpiece with it
    if (path.fixture.on) {
        if (!follow_fixture(target, kind)) return false;
        put_geo(along, fixture_step_);
    }
    for (unsigned i = 0; i < count; ++i) {
        const double end =
            along[i] + point[i] + path.turns_deg[i] + path.zero[i] + path.shift[i] + path.wanted[i];
        move_.machine_start[i] = path.machine[i];
        move_.pos[i] = point[i];
        if (std::fabs(end - path.machine[i]) > kSame) {
            moved |= 1u << i;
            move_.machine[i] = end;
        } else {
            move_.machine[i] = path.machine[i];
        }
    }
    move_.kind = kind;
    move_.moved = moved;
    move_.tap_turns = 0.0;  // of the tap before: only turn_with_move() makes another one
    move_.tap_floats = false;
    if (moved & view_->own_programs && at.own_axis < 0) {
        const ChannelAxis& axis =
            view_->axes[static_cast<unsigned>(__builtin_ctz(moved & view_->own_programs))];
        return fail(Alarm::PositioningRefused, axis.name[0], axis.name);
    }
    const bool arc = kind == MoveKind::ArcCw || kind == MoveKind::ArcCcw;
    return within_stroke(move_.machine, moved) && (arc || zones_allow());
}

bool Core::within_stroke(const AxisValues& machine, AxisSet moved) {
    for (AxisSet left = moved; left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        const ChannelAxis& axis = view_->axes[i];
        if (axis.hypothetical)
            return fail(Alarm::AxisHypothetical, axis.name[0], std::string(axis.name));
    }
    if (!view_->stroke.before_move ||
        (view_->stroke.not_before_skip && move_.kind == MoveKind::Skip))
        return true;
    // only the kernel knows from where
    if (at.own_by_way && (moved & view_->own_programs)) return true;
    StrokeFault out;
    AxisValues drives = machine;
    if (!on_machine(drives)) return true;  // TransformSink says what is wrong with it
    if (routes_)
        for (unsigned i = 0; i < view_->axis_count; ++i)
            drives[i] = view_->axes[i].to_drive(machine[i]);
    // what a superimposed master has added counts (nct part 2 22.5)
    for (AxisSet left = moved; left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        drives[i] += port_->axis_added(view_->axes[i].machine_axis);
    }
    if (!forbidden(zones_, drives.data(), moved, out)) return true;
    const ChannelAxis& axis = view_->axes[out.axis];
    return fail(Alarm::StrokeExceeded, axis.name[0], std::string(axis.name),
                view_->to_shown(out.axis, drives[out.axis]), view_->to_shown(out.axis, out.limit));
}

// The zones hold for the tool's tip in the machine: its lengths are taken off (fagor_8037t part 1,
// 3.8).
bool Core::zones_allow() {
    if (!factors_off_) return zones_allow(move_);
    // An arc with factors: its chords, where they really are.
    constexpr int kChords = 90;
    const unsigned p = move_.plane_p, q = move_.plane_q;
    const double first = std::atan2(move_.machine_start[q] - move_.centre_q,
                                    move_.machine_start[p] - move_.centre_p);
    Move chord = move_;
    chord.kind = MoveKind::Linear;
    chord.machine = path.machine;
    for (int k = 1; k <= kChords; ++k) {
        const double angle = first + move_.sweep * k / kChords;
        chord.machine_start = chord.machine;
        for (const unsigned i : {p, q}) {
            const double plain = i == p ? move_.centre_p + move_.radius * std::cos(angle)
                                        : move_.centre_q + move_.radius * std::sin(angle);
            chord.machine[i] =
                behind_factors(i, plain, path.zero[i] + path.shift[i] + path.wanted[i]);
        }
        if (!zones_allow(chord)) return false;
    }
    return true;
}

bool Core::zones_allow(const Move& move) {
    for (std::size_t n = 0; n < path.zones.size(); ++n) {
        if (path.zones[n].guard == WorkZone::Guard::Off || !move.moved) continue;
        Move tip = move;
        for (unsigned i = 0; i < view_->axis_count; ++i) {
            tip.machine[i] -= path.wanted[i];
            tip.machine_start[i] -= path.vector[i];
        }
        int p = -1, q = -1;
        plane_axes(p, q);
        if (p >= 0 && q >= 0) {
            tip.centre_p -= path.wanted[static_cast<std::size_t>(p)];
            tip.centre_q -= path.wanted[static_cast<std::size_t>(q)];
        }
        if (!violates(path.zones[n], tip)) continue;
        const bool enters = path.zones[n].guard == WorkZone::Guard::NoEntry;
        return fail(enters ? Alarm::FagorZoneEntered : Alarm::FagorZoneLeft, 0, {},
                    static_cast<double>(n + 1));
    }
    return within_second_limits(move);
}

// Travel limits besides those of the stroke, for the axes themselves (fagor_8037t part 2, 11.2.7).
bool Core::within_second_limits(const Move& move) {
    if (path.second_limits.guard == WorkZone::Guard::Off) return true;
    WorkZone zone = path.second_limits;
    // an axis at rest is no fault
    zone.has_low &= move.moved;
    zone.has_high &= move.moved;
    if (!violates(zone, move)) return true;
    unsigned i = 0;
    for (AxisSet left = zone.has_low | zone.has_high; left; left &= left - 1) {
        i = static_cast<unsigned>(__builtin_ctz(left));
        const bool below = (zone.has_low >> i & 1u) && move.machine[i] < zone.low[i],
                   above = (zone.has_high >> i & 1u) && move.machine[i] > zone.high[i];
        if (below || above) break;  // none: the middle of an arc is beyond
    }
    const double limit =
        (zone.has_low >> i & 1u) && move.machine[i] < zone.low[i] ? zone.low[i] : zone.high[i];
    return fail(Alarm::StrokeExceeded, view_->axes[i].name[0], std::string(view_->axes[i].name),
                view_->to_shown(i, move.machine[i]), view_->to_shown(i, limit));
}

void Core::deliver() {
    take_factors_off();
    take_incline_off();
    move_.exact_stop = (exact_once_ || path.exact_stop_mode) && !path.exact_stop_off;
    move_.in_position = move_.exact_stop;
    move_.override_locked = path.override_locked;
    move_.offset_alone = offset_alone_;
    exact_once_ = false;
    emitted_ = true;
    ++moves_;
    for (AxisSet left = move_.moved; left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        const double way = move_.machine[i] - move_.machine_start[i];
        if (way != 0.0) path.last_travel[i] = way > 0 ? 1 : -1;
    }
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (view_->axes[i].rollover)
            move_.pos[i] = wrapped(move_.pos[i], view_->axes[i].rollover_deg);
    // a corner lies in the plane that holds
    if (staged_ && move_.kind != MoveKind::ArcCw && move_.kind != MoveKind::ArcCcw) {
        int p = -1, q = -1;
        plane_axes(p, q);
        move_.plane_p = static_cast<std::uint8_t>(std::max(p, 0));
        move_.plane_q = static_cast<std::uint8_t>(std::max(q, 0));
    }
    if (reads_ahead()) tell_nose();
    add_bias();
    sink_->move(move_, at);
}

void Core::accept(const AxisValues& target) {
    if (!offset_alone_ || move_.moved) ++ways_;  // an offset that changes nothing is no travel
    if (path.fixture.on) take_fixture_step();
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        path.programmed[i] = target[i];
        path.vector[i] = path.wanted[i];
        path.machine[i] = move_end()[i];
        if (view_->axes[i].rollover && !path.framed) rebase(i);
    }
    if (path.framed) settle_turns();
}

bool Core::feed_ready() {
    if (path.feed <= 0.0) return fail(Alarm::FeedMissing);
    const bool geared = path.feed_mode == FeedMode::PerRevolution && gear_feed.spindle != 0;
    if (!geared && path.feed_mode == FeedMode::PerRevolution &&
        !spindle_ready(Alarm::SpindleStopped))
        return false;
    move_.feed_mode = path.feed_mode;
    move_.feed = path.feed;
    move_.spindle = geared ? static_cast<std::uint16_t>(gear_feed.spindle) : path.spindle.spindle;
    if (path.feed_path.degree_unit != 1.0 && path.feed_mode != FeedMode::InverseTime &&
        only_degrees())
        move_.feed /= path.feed_path.degree_unit;
    set_feed_path();
    if (geared) move_.feed_scale *= gear_feed.factor;
    return true;
}

bool Core::only_degrees() const {
    const FeedPath& by = path.feed_path;
    for (AxisSet left = move_.moved & ~by.degrees; left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        if (view_->axes[i].rotary || (by.counted >> i & 1u)) return false;
    }
    return (move_.moved & by.degrees) != 0;
}

// The feed counts other axes than the path does: how much of the path one unit of it is, and which
// axis holds it back.
void Core::set_feed_path() {
    const FeedPath& by = path.feed_path;
    move_.feed_scale = by.scale;
    move_.speed_limit = 0.0;
    const bool arc = move_.kind == MoveKind::ArcCw || move_.kind == MoveKind::ArcCcw;
    const double arc_length = arc ? move_.radius * std::fabs(move_.sweep) : 0.0;
    if (helix_in_plane_ && arc && !by.active && arc_length > kSame) {
        double beside2 = 0.0;  // of the axes that go along with the arc
        for (unsigned i = 0; i < view_->axis_count; ++i)
            if (i != move_.plane_p && i != move_.plane_q && !view_->axes[i].rotary)
                beside2 += std::pow(move_.machine[i] - move_.machine_start[i], 2);
        move_.feed_scale *= std::sqrt(arc_length * arc_length + beside2) / arc_length;
    }
    if (!by.active) {
        if (by.degree_mm <= 0 || path.transformation.active()) return;
        double along2 = arc_length * arc_length, round2 = 0.0;
        for (unsigned i = 0; i < view_->axis_count; ++i) {
            if (arc && (i == move_.plane_p || i == move_.plane_q)) continue;
            (view_->axes[i].rotary ? round2 : along2) +=
                std::pow((move_.machine[i] - move_.machine_start[i]) *
                             (view_->axes[i].rotary ? by.degree_mm : 1.0),
                         2);
        }
        if (along2 > kSame * kSame && round2 > 0)
            move_.feed_scale *= std::sqrt(along2 / (along2 + round2));
        return;
    }
    double linear2 = 0.0, rotary2 = 0.0, counted2 = 0.0;
    bool linear = false;
    std::array<double, kChannelAxes> way{};
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const bool in_plane = arc && (i == move_.plane_p || i == move_.plane_q);
        // Both axes of an arc together make its length.
        way[i] = !in_plane            ? std::fabs(move_.machine[i] - move_.machine_start[i])
                 : i == move_.plane_p ? arc_length
                                      : 0.0;
        if (way[i] <= kSame) continue;
        (view_->axes[i].rotary ? rotary2 : linear2) += way[i] * way[i];
        linear = linear || !view_->axes[i].rotary;
        if (by.counted >> i & 1u) counted2 += way[i] * way[i] * by.weight[i] * by.weight[i];
    }
    const double length = std::sqrt(linear ? linear2 : rotary2);
    if (length <= kSame) return;
    if (counted2 > 0) move_.feed_scale *= length / std::sqrt(counted2);
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const double distance = arc && i == move_.plane_q ? arc_length : way[i];
        if (by.limit_mm_min[i] <= 0 || distance <= kSame) continue;
        const double limit = by.limit_mm_min[i] * length / distance;
        if (move_.speed_limit <= 0 || limit < move_.speed_limit) move_.speed_limit = limit;
    }
}

bool Core::rapid(const AxisValues& target) {
    if (!begin_move(target, MoveKind::Rapid)) return false;
    if (stops_ & move_.moved) {
        skip_due_ = true;
        return fixed_stop(target, rapid_speed(), FeedMode::PerMinute, true);
    }
    if (move_.moved) {
        move_.feed_mode = FeedMode::Rapid;
        move_.feed = 0.0;
        move_.spindle = 0;
        move_.speed_limit =
            path.feed_path.rapid_scale < 1 ? path.feed_path.rapid_scale * rapid_speed() : 0.0;
        deliver();
        path.after_thread = false;
    } else if (compensating_) {
        tell_zero_distance();
    }
    accept(target);
    return true;
}

// Along the path, mm/min: the axis that reaches its rapid traverse first sets it.
double Core::rapid_speed() const {
    double linear2 = 0.0, rotary2 = 0.0, slowest = 0.0;
    for (AxisSet left = move_.moved; left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        const double way = std::fabs(move_.machine[i] - move_.machine_start[i]);
        (view_->axes[i].rotary ? rotary2 : linear2) += way * way;
        // minutes
        if (view_->axes[i].rapid_mm_min > 0)
            slowest = std::fmax(slowest, way / view_->axes[i].rapid_mm_min);
    }
    return slowest > 0 ? std::sqrt(linear2 > 0 ? linear2 : rotary2) / slowest : 0.0;
}

bool Core::linear(const AxisValues& target) {
    if (stops_) {
        skip_due_ = true;
        return fixed_stop(target, 0.0, path.feed_mode, true);
    }
    if (!begin_move(target, MoveKind::Linear)) return false;
    if (move_.moved) {
        if (!feed_ready()) return false;
        if (path.tap_pitch != 0)
            turn_with_move();
        else if (path.tap_floats)
            follow_with_holder();
        deliver();
        path.after_thread = false;
    } else if (compensating_) {
        tell_zero_distance();
    }
    accept(target);
    return true;
}

// Into the hole the spindle turns as the thread's hand says, out of it in the opposite direction.
void Core::turn_with_move() {
    const double way =
        (move_.machine[path.tap_axis] - move_.machine_start[path.tap_axis]) * path.tap_depth_sign;
    move_.tap_turns = way / path.tap_pitch;
    move_.tap_rpm = path.spindle.rpm;
    move_.tap_out = way < 0 && path.tap_own_acceleration_out;
    move_.tap_feedforward = path.tap_feedforward;
}

// Constant surface speed has no speed of its own to make a pitch of.
void Core::follow_with_holder() {
    const SpindleState& s = path.spindle;
    move_.tap_floats = s.mode == SpindleModeCode::Rpm && s.rpm > 0;
    move_.tap_rpm = s.rpm;
}

// The programmed point with the named axes at these machine coordinates.
AxisValues Core::programmed_at(const AxisValues& machine, AxisSet which) const {
    AxisValues target = path.framed ? framed(path.programmed) : path.programmed;
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (which >> i & 1u)
            target[i] =
                machine[i] - path.turns_deg[i] - path.zero[i] - path.shift[i] - path.wanted[i];
    return path.framed ? unframed(target) : target;
}

bool Core::machine_rapid(const AxisValues& machine, AxisSet which) {
    if (reads_ahead()) suspend_compensation(which);
    const AxisValues target = programmed_at(machine, which);
    return rapid(target);
}

bool Core::reference(const AxisValues& machine, AxisSet which, MoveKind kind) {
    if (reads_ahead()) suspend_compensation(which);
    AxisSet without = 0;  // those that have no reference point find it
    for (unsigned i = 0; i < view_->axis_count && kind == MoveKind::Reference; ++i)
        if ((which >> i & 1u) && !view_->axes[i].referenced && !view_->axes[i].hypothetical)
            without |= 1u << i;
    if (without) {
        find_reference(without, machine);
        which &= ~without;
    }
    const AxisValues target = programmed_at(machine, which);
    if (!begin_move(target, kind)) return false;
    if (move_.moved) {
        move_.feed_mode = FeedMode::Rapid;
        move_.feed = 0.0;
        move_.spindle = 0;
        deliver();
        path.after_thread = false;
    }
    accept(target);
    return true;
}

bool Core::skip(const AxisValues& target, double feed, FeedMode mode, std::string_view input,
                bool release, double torque) {
    skip_moved_ = 0;
    if (!begin_move(target, MoveKind::Skip)) return false;
    if (!move_.moved) {
        ++ways_;
        return true;
    }
    if (feed > 0) {
        move_.feed = feed;
        move_.feed_mode = mode;
        move_.spindle = path.spindle.spindle;
    } else if (!feed_ready()) {
        return false;
    }
    unsigned number = 0;
    for (const char c : input)
        number =
            c >= '0' && c <= '9' && number < 25 ? number * 10 + static_cast<unsigned>(c - '0') : 0;
    move_.skip_input = static_cast<std::uint8_t>(number);
    move_.skip_name = input;
    move_.skip_release = release;
    move_.skip_torque = torque;
    deliver();
    path.after_thread = false;
    skip_moved_ = move_.moved;
    skip_target_ = move_end();
    (void)on_machine(skip_target_);
    accept(target);
    sink_->barrier(at);
    return true;
}

bool Core::measure(const AxisValues& target, std::string_view input, bool release, bool passes) {
    measure_due_ = true;
    move_.skip_passes = skip_passes_ = passes;
    const bool good = skip(target, 0.0, path.feed_mode, input, release);
    move_.skip_passes = false;
    return good;
}

bool Core::fixed_stop(const AxisValues& target, double feed, FeedMode mode, bool must_come,
                      std::string_view input) {
    stops_ = 0;
    move_.fixed_stop = true;
    move_.stop_must_come = must_come;
    const bool good = skip(target, feed, mode, input);
    move_.fixed_stop = move_.stop_must_come = false;
    return good;
}

AxisSet Core::take_skip() {
    AxisSet early = 0, came = 0;
    const bool passes = std::exchange(skip_passes_, false);
    skip_point_ = path.programmed;
    // All axes first: behind a transformation a programmed coordinate depends on several of them.
    for (AxisSet left = skip_moved_; left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        const auto stopped = port_->axis_at_skip(view_->axes[i].machine_axis);
        if (!stopped) continue;
        came |= 1u << i;
        take_machine(i, *stopped);
        if (std::fabs(view_->axes[i].from_drive(*stopped) - skip_target_[i]) > kLimitSlack)
            early |= 1u << i;
    }
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (came >> i & 1u) skip_point_[i] = path.programmed[i];
    for (AxisSet left = came; left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        if (const auto rests = port_->axis_command(view_->axes[i].machine_axis))
            take_machine(i, *rests);
        else if (passes)
            take_machine(i, view_->axes[i].to_drive(skip_target_[i]));
    }
    return early;
}

bool Core::curve(const AxisValues& target, const std::vector<AxisValues>& between) {
    if (compensating_) return fail(Alarm::CurveUnderCompensation, 0, std::string(at.cycle));
    if (transformed()) return fail(Alarm::NotBuilt, 0, "curves under a transformation");
    if (!begin_move(target, MoveKind::Linear)) return false;
    auto through = std::make_shared<std::vector<AxisValues>>();
    through->reserve(between.size());
    AxisSet moved = move_.moved;
    AxisValues before = move_.machine_start;
    for (const AxisValues& inner : between) {
        const AxisValues point = path.framed ? framed(inner) : inner;
        AxisValues machine = move_.machine_start;
        double step2 = 0.0;
        for (unsigned i = 0; i < view_->axis_count; ++i) {
            const double there =
                point[i] + path.turns_deg[i] + path.zero[i] + path.shift[i] + path.wanted[i];
            if (std::fabs(there - machine[i]) > kSame) {
                moved |= 1u << i;
                machine[i] = there;
            }
            step2 += (machine[i] - before[i]) * (machine[i] - before[i]);
        }
        if (!within_stroke(machine, moved)) return false;
        if (step2 < kSamePoint * kSamePoint) continue;
        before = machine;
        through->push_back(machine);
    }
    const auto at_end = [&](const AxisValues& point) {
        double way2 = 0.0;
        for (unsigned i = 0; i < view_->axis_count; ++i)
            way2 += (point[i] - move_.machine[i]) * (point[i] - move_.machine[i]);
        return way2 < kSamePoint * kSamePoint;
    };
    while (!through->empty() && at_end(through->back())) through->pop_back();
    move_.moved = moved;
    if (!moved) {
        accept(target);
        return true;
    }
    if (!feed_ready()) return false;
    // the curve's own length counts
    if (path.feed_path.active || path.feed_path.scale != 1) {
        move_.feed_scale = path.feed_path.scale;
        move_.speed_limit = 0.0;
    }
    move_.through = std::move(through);
    deliver();
    move_.through = nullptr;
    path.after_thread = false;
    accept(target);
    return true;
}

bool Core::arc(const AxisValues& target, const ArcCall& programmed) {
    int pi = -1, qi = -1;
    plane_axes(pi, qi);
    if (pi < 0 || qi < 0) return fail(Alarm::PlaneAxisMissing);
    auto p = static_cast<unsigned>(pi), q = static_cast<unsigned>(qi);
    ArcCall call = programmed;
    if (inclined_)
        incline_arc(call, target, p, q);
    else if (path.framed && !frame_arc(call, target, p, q))
        return false;
    bool moves = false;
    if (!begin_move(target, call.clockwise ? MoveKind::ArcCw : MoveKind::ArcCcw)) return false;
    take_factors_off();
    take_incline_off();
    if (!shape_arc(call, p, q, moves)) return false;
    if (!moves) {
        accept(target);
        return true;
    }
    if (!zones_allow() || !feed_ready()) return false;
    deliver();
    path.after_thread = false;
    accept(target);
    return true;
}

// Fills what is an arc's own in move_, whose ends are known; the call is the one outside the frame.
bool Core::shape_arc(ArcCall call, unsigned p, unsigned q, bool& moves) {
    moves = false;
    const double to_machine_p = path.zero[p] + path.shift[p] + path.wanted[p];
    const double to_machine_q = path.zero[q] + path.shift[q] + path.wanted[q];
    const double sp = move_.machine_start[p], sq = move_.machine_start[q], ep = move_.machine[p],
                 eq = move_.machine[q];
    const double chord = std::hypot(ep - sp, eq - sq);
    double cp = 0.0, cq = 0.0;
    if (call.has_radius) {
        if (call.radius == 0.0) return fail(Alarm::ArcRadiusIllegal, 'R');
        // an arc by its radius that goes nowhere has no angle
        if (chord < kSamePoint) return true;
        const double radius = std::fabs(call.radius), half = chord / 2;
        if (half - radius > call.tolerance + kSame)
            return fail(Alarm::RadiusTooSmall, 'R', {}, half - radius);
        const double height = radius > half ? std::sqrt((radius - half) * (radius + half)) : 0.0;
        // The centre lies to the left of the chord for a short arc anticlockwise and for a long one
        // clockwise.
        const double side = (call.clockwise != (call.radius < 0)) ? -1.0 : 1.0;
        cp = (sp + ep) / 2 - side * height * (eq - sq) / chord;
        cq = (sq + eq) / 2 + side * height * (ep - sp) / chord;
    } else {
        cp = call.centre_p + to_machine_p;
        cq = call.centre_q + to_machine_q;
    }
    const double rs = std::hypot(sp - cp, sq - cq), re = std::hypot(ep - cp, eq - cq);
    if (rs < kSamePoint || re < kSamePoint)
        return fail(at.comp != CompSide::Off ? Alarm::CompArcCentre : Alarm::ArcWithoutRadius, 0);
    if (std::fabs(rs - re) > call.tolerance + kSame)
        return fail(Alarm::ArcRadiusDiffers, 0, {}, std::fabs(rs - re), call.tolerance);
    const double a0 = std::atan2(sq - cq, sp - cp), a1 = std::atan2(eq - cq, ep - cp);
    double sweep = call.clockwise ? a0 - a1 : a1 - a0;  // in the direction of travel
    sweep = wrapped(sweep, kTurn);
    if (chord < kSamePoint)
        sweep = kTurn;
    else if (kTurn - sweep < 1e-12)
        sweep = 0.0;
    sweep += kTurn * call.turns;
    move_.plane_p = static_cast<std::uint8_t>(p);
    move_.plane_q = static_cast<std::uint8_t>(q);
    move_.centre_p = cp;
    move_.centre_q = cq;
    move_.pos_centre_p = cp - to_machine_p;
    move_.pos_centre_q = cq - to_machine_q;
    move_.radius = rs;
    move_.radius_end = re;
    move_.sweep = call.clockwise ? -sweep : sweep;
    move_.turns = call.turns;
    if (sweep == 0.0) return true;
    // Where the arc bulges beyond both ends: at whole quarter turns inside the sweep.
    const double first = call.clockwise ? a1 : a0;  // lower end of the angle range
    AxisValues extreme = move_.machine;
    for (int k = static_cast<int>(std::ceil(first / (kTurn / 4) - 1e-12));
         k * (kTurn / 4) < first + sweep && k < 16; ++k) {
        extreme[p] = cp + (k & 1 ? 0.0 : (k & 2 ? -rs : rs));
        extreme[q] = cq + (k & 1 ? (k & 2 ? -rs : rs) : 0.0);
        AxisValues real = extreme;
        if (inclined_)
            real = behind_incline(extreme);
        else if (factors_off_)
            for (unsigned i = 0; i < view_->axis_count; ++i)
                real[i] = i == p   ? behind_factors(p, extreme[p], to_machine_p)
                          : i == q ? behind_factors(q, extreme[q], to_machine_q)
                                   : real_end_[i];
        if (!within_stroke(real, (1u << p) | (1u << q))) {
            fault_.alarm = Alarm::MirrorOfStroke;
            return false;
        }
    }
    move_.moved |= (1u << p) | (1u << q);
    moves = true;
    return true;
}

}  // namespace polyturn::channels
