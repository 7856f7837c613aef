// Records of moves of the path: straight, arcs, threads, curves of many pieces, blocks with slow
// ends; what transformation, retract and limits they carry.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/records/record_place.hpp"
#include "channels/records/record_sink.hpp"
#include "ipc/image/compensated_flag.hpp"
#include "ipc/model/machine/named_inputs.hpp"

namespace polyturn::channels {

void RecordSink::move(const Move& move, const BlockContext& at) {
    if (move.beside || at.own_axis >= 0) return beside(move, at);
    await_axes_of(move, at);
    last_moved_ = move.moved;
    if (move.kind == MoveKind::Thread && move.sweep != 0)
        thread_arc(move, at);
    else if (move.through)
        curve(move, at);
    else if (move.slow_head > 0 || move.slow_tail > 0)
        slow_ends(move, at);
    else
        add(move, at, true);
}

// Straight pieces under one note; PathMaker makes one smooth path of them where they are short.
void RecordSink::curve(const Move& move, const BlockContext& at) {
    const std::vector<AxisValues>& inner = *move.through;
    Move piece = move;
    piece.through = nullptr;
    if (move.feed_mode == FeedMode::InverseTime) {  // counts for the whole
        double length = 0.0;
        AxisValues before = move.machine_start;
        for (std::size_t k = 0; k <= inner.size(); ++k) {
            const AxisValues& next = k < inner.size() ? inner[k] : move.machine;
            double step2 = 0.0;
            for (unsigned i = 0; i < view_->axis_count; ++i)
                step2 += (next[i] - before[i]) * (next[i] - before[i]);
            length += std::sqrt(step2);
            before = next;
        }
        piece.feed_mode = FeedMode::PerMinute;
        piece.feed = move.feed * length;
    }
    const std::uint64_t number = note_move(move, at);
    piece.exact_stop = piece.in_position = false;
    for (std::size_t k = 0; k <= inner.size(); ++k) {
        if (k > 0) piece.machine_start = piece.machine;
        const bool last = k == inner.size();
        piece.machine = last ? move.machine : inner[k];
        if (last) {
            piece.exact_stop = move.exact_stop;
            piece.in_position = move.in_position;
        }
        add(piece, at, false, number,
            (k > 0 ? std::uint32_t{kMoreBefore} : 0u) | (last ? 0u : std::uint32_t{kMoreBehind}));
    }
}

// A cut between inner corners: up to three pieces under one note, the outer ones with a share of
// the feed.
//
//   |--head--|-------- as programmed --------|--tail--|
void RecordSink::slow_ends(const Move& move, const BlockContext& at) {
    const bool arc = move.kind == MoveKind::ArcCw || move.kind == MoveKind::ArcCcw;
    double length = 0.0;
    if (arc)
        length = std::fabs(move.sweep) * move.radius;
    else
        for (unsigned i = 0; i < view_->axis_count; ++i)
            length = std::hypot(length, move.machine[i] - move.machine_start[i]);
    if (!(length > 0) || move.feed_mode == FeedMode::InverseTime) return add(move, at, true);
    // Shares of the travel where the feed changes; where both slow ends meet, all of it is slow.
    double from = std::fmin(move.slow_head / length, 1.0),
           to = 1.0 - std::fmin(move.slow_tail / length, 1.0);
    if (from >= to) from = to = 1.0;
    const double ends[] = {from, to, 1.0};
    const double first = arc ? std::atan2(move.machine_start[move.plane_q] - move.centre_q,
                                          move.machine_start[move.plane_p] - move.centre_p)
                             : 0.0;
    const std::uint64_t number = note_move(move, at);  // output whole
    Move piece = move;
    piece.slow_head = piece.slow_tail = 0.0;
    piece.exact_stop = piece.in_position = false;
    double done = 0.0;
    for (int k = 0; k < 3; ++k) {
        if (ends[k] - done < 1e-9) continue;
        const double share = ends[k];
        const bool last = share >= 1.0;
        if (done > 0) piece.machine_start = piece.machine;
        for (unsigned i = 0; i < view_->axis_count; ++i)
            piece.machine[i] =
                last ? move.machine[i]
                     : move.machine_start[i] + (move.machine[i] - move.machine_start[i]) * share;
        if (arc) {
            piece.sweep = move.sweep * (share - done);
            const double radius = move.radius + (move.radius_end - move.radius) * share;
            if (!last) {
                piece.machine[move.plane_p] =
                    move.centre_p + radius * std::cos(first + move.sweep * share);
                piece.machine[move.plane_q] =
                    move.centre_q + radius * std::sin(first + move.sweep * share);
            }
            piece.radius = move.radius + (move.radius_end - move.radius) * done;
            piece.radius_end = radius;
            piece.turns = 0;
        }
        piece.feed = k == 1 ? move.feed : move.feed * move.slow_share;
        if (last) {
            piece.exact_stop = move.exact_stop;
            piece.in_position = move.in_position;
        }
        add(piece, at, false, number,
            (done > 0 ? std::uint32_t{kMoreBefore} : 0u) |
                (last ? 0u : std::uint32_t{kMoreBehind}));
        done = share;
    }
}

// The lead counts along one axis of the plane, so along an arc the travel per revolution changes:
// short arcs, each with its mean.
void RecordSink::thread_arc(const Move& move, const BlockContext& at) {
    constexpr double kPiece = 0.02;  // rad
    const unsigned p = move.plane_p, q = move.plane_q;
    const auto pieces = static_cast<int>(std::ceil(std::fabs(move.sweep) / kPiece));
    // travel of the lead's axis
    const double along = move.lead * std::fabs(move.sweep) * move.radius / move.lead_path;
    const double way_p = std::fabs(move.machine[p] - move.machine_start[p]),
                 way_q = std::fabs(move.machine[q] - move.machine_start[q]);
    const unsigned axis = std::fabs(way_p - along) <= std::fabs(way_q - along) ? p : q;
    const double first =
        std::atan2(move.machine_start[q] - move.centre_q, move.machine_start[p] - move.centre_p);
    Move piece = move;
    piece.sweep = move.sweep / pieces;
    piece.exact_stop = piece.in_position = false;  // they are one thread, and only that ends
    std::uint64_t number = 0;
    for (int k = 0; k < pieces; ++k) {
        const double share = static_cast<double>(k + 1) / pieces,
                     angle = first + move.sweep * share;
        if (k > 0) {
            piece.machine_start = piece.machine;
            piece.thread_chained = true;
        }
        if (k + 1 == pieces) {
            piece.exact_stop = move.exact_stop;
            piece.in_position = move.in_position;
        }
        for (unsigned i = 0; i < view_->axis_count; ++i)
            piece.machine[i] =
                move.machine_start[i] + (move.machine[i] - move.machine_start[i]) * share;
        piece.machine[p] =
            k + 1 == pieces ? move.machine[p] : move.centre_p + move.radius * std::cos(angle);
        piece.machine[q] =
            k + 1 == pieces ? move.machine[q] : move.centre_q + move.radius * std::sin(angle);
        const double step = std::fabs(piece.machine[axis] - piece.machine_start[axis]);
        if (step > 0) piece.lead_path = move.lead * std::fabs(piece.sweep) * move.radius / step;
        if (k == 0) number = note_move(move, at);  // output whole
        add(piece, at, false, number,
            (k > 0 ? std::uint32_t{kMoreBefore} : 0u) |
                (k + 1 < pieces ? std::uint32_t{kMoreBehind} : 0u));
    }
}

// The transformation as the drives see it. It changes where the path is stopped: the channel is at
// a barrier, or the rotary axis turns in the pole between two moves that end with a stop.
void RecordSink::use_transformation(const Move& move) {
    if (!transformed_) return;
    if (!move.kinematics) {
        if (entry_ == 0 && !limits_forgotten_) return;
        limits_forgotten_ = false;
        maker_->flush();
        maker_->use_limits(limits_of_path());
        entry_ = 0;
        return;
    }
    Kinematics k = *move.kinematics;
    const std::size_t roles = role_count(kind_of(k));
    const Kinematics places = k;
    k.axis.fill(0xff);
    for (std::size_t r = 0; r < roles; ++r) {
        if (places.axis[r] >= view_->axis_count) {  // no axis: it is at its centre
            k.sign[r] = 1.0;
            k.shift[r] = 0.0;
            continue;
        }
        const ChannelAxis& axis = view_->axes[places.axis[r]];
        k.axis[r] = axis.machine_axis;
        k.shift[r] = axis.to_drive(0.0);
        k.sign[r] = axis.to_drive(1.0) - k.shift[r] < 0 ? -1.0 : 1.0;
    }
    const std::uint16_t entry = ring_->enter(k);
    if (entry == entry_) return;
    limits_forgotten_ = false;
    maker_->flush();
    const bool polar = kind_of(k) == KinematicsKind::Polar;
    // machine_start is the drive's already.
    const double turn = polar ? unrouted(k, 1, move.machine_start[places.axis[1]]) : 0.0;
    const bool negative = polar && unrouted(k, 0, move.machine_start[places.axis[0]]) < k.centre[0];
    transformed_->begin(k, turn, negative ? SideOfPole::Negative : SideOfPole::Positive);
    maker_->use_limits(transformed_->limits());
    entry_ = entry;
}

void RecordSink::add(const Move& move, const BlockContext& at, bool told, std::uint64_t number,
                     std::uint32_t flags) {
    use_transformation(move);
    PathRecord& r = maker_->next_move();
    r.flags |= flags;
    r.transform = entry_;
    const AxisValues &from = move.kinematics ? move.path_start : move.machine_start,
                     &to = move.kinematics ? move.path : move.machine;
    const bool arc = move.kind == MoveKind::ArcCw || move.kind == MoveKind::ArcCcw ||
                     (move.kind == MoveKind::Thread && move.sweep != 0);
    r.kind = code_of(arc ? RecordKind::Arc : RecordKind::Line);
    AxisSet moved = move.moved;
    if (arc) moved |= 1u << move.plane_p | 1u << move.plane_q;
    for (unsigned i = 0; i < view_->axis_count && r.axis_count < kMaxPathAxes; ++i) {
        if (!(moved >> i & 1)) continue;
        if (arc && i == move.plane_p) r.plane[0] = r.axis_count;
        if (arc && i == move.plane_q) r.plane[1] = r.axis_count;
        r.axis[r.axis_count] = view_->axes[i].machine_axis;
        r.start[r.axis_count] = from[i];
        r.nose[r.axis_count] = move.nose[i];
        r.end[r.axis_count++] = to[i];
    }
    if (arc) fill_arc(move, r);
    place(at, r);
    r.spindle = move.spindle;
    r.feed_mode = static_cast<std::uint8_t>(move.feed_mode);
    switch (move.feed_mode) {
        case FeedMode::PerMinute:
            r.feed = move.feed / 60 * move.feed_scale;
            break;
        // 1/min over the length of this block: a speed like any other once that is known
        case FeedMode::InverseTime:
            r.feed = move.feed / 60 * maker_->length_of_next();
            r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerMinute);
            break;
        default:
            r.feed = move.feed * move.feed_scale;
            break;
    }
    if (move.speed_limit > 0 && r.feed_mode == static_cast<std::uint8_t>(FeedMode::PerMinute))
        r.feed = std::min(r.feed, move.speed_limit / 60);
    if (move.kind == MoveKind::Rapid || move.kind == MoveKind::Reference) r.flags |= kRapid;
    if (move.kind == MoveKind::Rapid && move.speed_limit > 0) r.feed = move.speed_limit / 60;
    if (move.kind == MoveKind::Reference) r.flags |= kReference;
    if (move.kind == MoveKind::Skip) {
        // kFlying: it does not brake
        r.flags |= kSkipMove | (move.skip_release ? std::uint32_t{kSkipRelease} : 0u) |
                   (move.skip_passes ? std::uint32_t{kFlying} : 0u);
        const auto input = move.skip_name.empty() ? std::optional<std::uint32_t>(move.skip_input)
                                                  : input_by_name(move.skip_name, view_->channel);
        // a signal that does not exist never comes
        r.code = input ? static_cast<std::int32_t>(*input) : -1;
        if (move.skip_torque != 0) {
            r.flags |= kFixedStop;
            r.value = std::max(move.skip_torque, 0.0);
            if (move.skip_name.empty()) r.code = -1;
        }
        if (move.fixed_stop)
            r.flags |= kFixedStop | (move.stop_must_come ? std::uint32_t{kStopMustCome} : 0u);
    }
    if (move.kind == MoveKind::Thread) {
        r.flags |= kThread | kOverrideLocked;
        if (move.thread_chained) r.flags |= kThreadChained;
        maker_->thread_turns(move.tap_rpm / 60);
        r.feed_mode = static_cast<std::uint8_t>(FeedMode::Thread);
        r.lead = move.lead_path;
        r.lead_change = move.lead > 0 ? move.lead_change * move.lead_path / move.lead : 0;
        r.start_angle = move.start_angle;
        fill_retract(move, r);
    }
    if (move.tap_turns != 0 && r.axis_count < kMaxPathAxes && move.spindle != 0) {
        r.flags |= kTapping | kOverrideLocked | kExactStop | kInPosition |
                   (move.tap_out ? std::uint32_t{kTapOut} : 0u);
        // behind the axes: its slot is no axis
        r.axis[r.axis_count] = static_cast<std::uint8_t>(kMaxAxes + move.spindle - 1u);
        r.end[r.axis_count] = move.tap_turns;
        r.value = move.tap_feedforward ? 1.0 : 0.0;
        if (move.feed_mode == FeedMode::PerRevolution) {  // the spindle does not lead, it is led
            r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerMinute);
            r.feed = move.feed * move.tap_rpm / 60;
        }
    }
    // A floating tap follows the speed that the spindle really has, at its pitch, whether the feed
    // was programmed per minute or per revolution.
    if (move.tap_floats && move.feed_mode == FeedMode::PerMinute && move.tap_rpm > 0 &&
        move.spindle != 0) {
        r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerRevolution);
        r.feed = move.feed / move.tap_rpm * move.feed_scale;
    }
    if (move.exact_stop) r.flags |= kExactStop;
    if (move.in_position) r.flags |= kExactStop | kInPosition;
    if (move.override_locked) r.flags |= kOverrideLocked;
    if (at.comp != CompSide::Off) r.flags |= kCompensated;
    if (maker_->length_of_next() > 0) {
        r.note = told ? note_move(move, at) : number;
        if (move.kind == MoveKind::Skip && !move.skip_passes && r.note)
            skip_ = {r.note,
                     move,
                     at,
                     std::string(at.tool.name),
                     std::string(at.cycle),
                     std::string(move.skip_name)};
        maker_->add_move();
        drained_ = false;
    }
    last_ = at;
}

// An axis that the thread itself does not move gets a slot, so that the kernel can move it out.
void RecordSink::fill_retract(const Move& move, PathRecord& r) const {
    for (std::size_t k = 0; k < move.withdraw_axis.size(); ++k) {
        if (move.withdraw_axis[k] < 0 || move.withdraw[k] == 0.0) continue;
        const auto place = static_cast<std::size_t>(move.withdraw_axis[k]);
        const std::uint8_t axis = view_->axes[place].machine_axis;
        std::size_t slot = 0;
        while (slot < r.axis_count && r.axis[slot] != axis) ++slot;
        if (slot == r.axis_count) {
            if (slot == kMaxPathAxes) continue;
            r.axis[slot] = axis;
            r.start[slot] = r.end[slot] = move.machine[place];
            r.nose[slot] = move.nose[place];
            ++r.axis_count;
        }
        if (slot < r.retract.size()) r.retract[slot] = move.withdraw[k];
    }
}

// Radii and angles from the points themselves, so that the record meets them exactly whatever was
// rounded on the between.
void RecordSink::fill_arc(const Move& move, PathRecord& r) const {
    const std::size_t p = r.plane[0], q = r.plane[1];
    const double p0 = r.start[p] - move.centre_p, q0 = r.start[q] - move.centre_q;
    const double p1 = r.end[p] - move.centre_p, q1 = r.end[q] - move.centre_q;
    const double start = std::atan2(q0, p0);
    const double rest =
        std::remainder(std::atan2(q1, p1) - start - move.sweep, 2 * std::numbers::pi);
    r.shape[arc_shape::kCentreP] = move.centre_p;
    r.shape[arc_shape::kCentreQ] = move.centre_q;
    r.shape[arc_shape::kRadius] = std::hypot(p0, q0);
    r.shape[arc_shape::kStartAngle] = start;
    r.shape[arc_shape::kSweep] = move.sweep + rest;
    const double last = std::hypot(p1, q1);  // nearly the same is the same: no parameter needed
    r.shape[arc_shape::kRadiusEnd] =
        std::abs(last - r.shape[arc_shape::kRadius]) > 1e-9 ? last : r.shape[arc_shape::kRadius];
}

}  // namespace polyturn::channels
