#include "channels/process/record_place.hpp"
#include "channels/process/record_sink.hpp"

#include "ipc/image/balance.hpp"
#include "ipc/image/interrupt_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "ipc/machine/named_inputs.hpp"

namespace polyturn::channels {
namespace {

void copy_text(std::string_view from, std::array<char, 48>& to) {
    to.fill(0);
    std::memcpy(to.data(), from.data(), std::min(from.size(), to.size() - 1));
}

std::uint8_t code_of(RecordKind kind) { return static_cast<std::uint8_t>(kind); }

}  // namespace

// The describing sink writes its line into *text_; a call may also describe nothing.
template <class Call>
std::uint64_t RecordSink::note(Call&& call) {
    if (!describe_) return 0;
    std::string& text = *text_;
    text.clear();
    call(*describe_);
    if (text.empty()) return 0;
    if (text.back() == '\n') text.pop_back();
    put_note_(++note_, text);
    return note_;
}

std::uint64_t RecordSink::note_move(const Move& move, const BlockContext& at) {
    return note([&](Sink& sink) { sink.move(move, at); });
}

PathRecord RecordSink::event(RecordKind kind, const BlockContext& at, std::uint64_t note) const {
    PathRecord r;
    r.kind = code_of(kind);
    r.flags = kBlockBegin | kBlockEnd;
    r.note = note;
    place(at, r);
    return r;
}

void RecordSink::push(PathRecord& r, bool stands, bool drains) {
    if (drains) r.flags |= kDrains;
    maker_->add_event(r, stands || drains);
    drained_ = drains;
    if (drains) drain_index_ = ring_->last_index();
}

void RecordSink::move(const Move& move, const BlockContext& at) {
    if (move.beside) return beside(move, at);
    await_axes_of(move, at);
    last_moved_ = move.moved;
    if (move.kind == MoveKind::Thread && move.sweep != 0) thread_arc(move, at);
    else if (move.through) curve(move, at);
    else if (move.slow_head > 0 || move.slow_tail > 0) slow_ends(move, at);
    else add(move, at, true);
}

// Straight pieces under one note; PathMaker makes one smooth path of them where they are short.
void RecordSink::curve(const Move& move, const BlockContext& at) {
    const std::vector<AxisValues>& inner = *move.through;
    Move piece = move;
    piece.through = nullptr;
    if (move.feed_mode == FeedMode::InverseTime) {   // counts for the whole
        double length = 0.0;
        AxisValues before = move.machine_start;
        for (std::size_t k = 0; k <= inner.size(); ++k) {
            const AxisValues& next = k < inner.size() ? inner[k] : move.machine;
            double step2 = 0.0;
            for (unsigned i = 0; i < view_->axis_count; ++i) step2 += (next[i] - before[i]) * (next[i] - before[i]);
            length += std::sqrt(step2);
            before = next;
        }
        piece.feed_mode = FeedMode::PerMinute;
        piece.feed = move.feed * length;
    }
    const std::uint64_t number = note([&](Sink& sink) { sink.move(move, at); });
    piece.exact_stop = piece.in_position = false;
    for (std::size_t k = 0; k <= inner.size(); ++k) {
        if (k > 0) piece.machine_start = piece.machine;
        const bool last = k == inner.size();
        piece.machine = last ? move.machine : inner[k];
        if (last) piece.exact_stop = move.exact_stop, piece.in_position = move.in_position;
        add(piece, at, false, number, (k > 0 ? std::uint32_t{kMoreBefore} : 0u) | (last ? 0u : std::uint32_t{kMoreBehind}));
    }
}

// A cut between inner corners: up to three pieces under one note, the outer ones with a share of the feed.
//
//   |--head--|-------- as programmed --------|--tail--|
void RecordSink::slow_ends(const Move& move, const BlockContext& at) {
    const bool arc = move.kind == MoveKind::ArcCw || move.kind == MoveKind::ArcCcw;
    double length = 0.0;
    if (arc) length = std::fabs(move.sweep) * move.radius;
    else
        for (unsigned i = 0; i < view_->axis_count; ++i) length = std::hypot(length, move.machine[i] - move.machine_start[i]);
    if (!(length > 0) || move.feed_mode == FeedMode::InverseTime) return add(move, at, true);
    // Shares of the way where the feed changes; where both slow ends meet, all of it is slow.
    double from = std::fmin(move.slow_head / length, 1.0), to = 1.0 - std::fmin(move.slow_tail / length, 1.0);
    if (from >= to) from = to = 1.0;
    const double ends[] = {from, to, 1.0};
    const double first = arc ? std::atan2(move.machine_start[move.plane_q] - move.centre_q, move.machine_start[move.plane_p] - move.centre_p) : 0.0;
    const std::uint64_t number = note([&](Sink& sink) { sink.move(move, at); });   // told whole
    Move piece = move;
    piece.slow_head = piece.slow_tail = 0.0;
    piece.exact_stop = piece.in_position = false;
    double done = 0.0;
    for (int k = 0; k < 3; ++k) {
        if (ends[k] - done < 1e-9) continue;
        const double share = ends[k];
        const bool last = share >= 1.0;
        if (done > 0) piece.machine_start = piece.machine;
        for (unsigned i = 0; i < view_->axis_count; ++i) piece.machine[i] = last ? move.machine[i] : move.machine_start[i] + (move.machine[i] - move.machine_start[i]) * share;
        if (arc) {
            piece.sweep = move.sweep * (share - done);
            const double radius = move.radius + (move.radius_end - move.radius) * share;
            if (!last) piece.machine[move.plane_p] = move.centre_p + radius * std::cos(first + move.sweep * share), piece.machine[move.plane_q] = move.centre_q + radius * std::sin(first + move.sweep * share);
            piece.radius = move.radius + (move.radius_end - move.radius) * done;
            piece.radius_end = radius;
            piece.turns = 0;
        }
        piece.feed = k == 1 ? move.feed : move.feed * move.slow_share;
        if (last) piece.exact_stop = move.exact_stop, piece.in_position = move.in_position;
        add(piece, at, false, number, (done > 0 ? std::uint32_t{kMoreBefore} : 0u) | (last ? 0u : std::uint32_t{kMoreBehind}));
        done = share;
    }
}

// The lead counts along one axis of the plane, so along an arc the way a revolution changes: short arcs, each with its mean.
void RecordSink::thread_arc(const Move& move, const BlockContext& at) {
    constexpr double kPiece = 0.02;   // rad
    const unsigned p = move.plane_p, q = move.plane_q;
    const auto pieces = static_cast<int>(std::ceil(std::fabs(move.sweep) / kPiece));
    const double along = move.lead * std::fabs(move.sweep) * move.radius / move.lead_path;   // way of the lead's axis
    const double way_p = std::fabs(move.machine[p] - move.machine_start[p]), way_q = std::fabs(move.machine[q] - move.machine_start[q]);
    const unsigned axis = std::fabs(way_p - along) <= std::fabs(way_q - along) ? p : q;
    const double first = std::atan2(move.machine_start[q] - move.centre_q, move.machine_start[p] - move.centre_p);
    Move piece = move;
    piece.sweep = move.sweep / pieces;
    std::uint64_t number = 0;
    for (int k = 0; k < pieces; ++k) {
        const double share = static_cast<double>(k + 1) / pieces, angle = first + move.sweep * share;
        if (k > 0) piece.machine_start = piece.machine, piece.thread_chained = true;
        for (unsigned i = 0; i < view_->axis_count; ++i) piece.machine[i] = move.machine_start[i] + (move.machine[i] - move.machine_start[i]) * share;
        piece.machine[p] = k + 1 == pieces ? move.machine[p] : move.centre_p + move.radius * std::cos(angle);
        piece.machine[q] = k + 1 == pieces ? move.machine[q] : move.centre_q + move.radius * std::sin(angle);
        const double step = std::fabs(piece.machine[axis] - piece.machine_start[axis]);
        if (step > 0) piece.lead_path = move.lead * std::fabs(piece.sweep) * move.radius / step;
        if (k == 0) number = note([&](Sink& sink) { sink.move(move, at); });   // told whole
        add(piece, at, false, number, (k > 0 ? std::uint32_t{kMoreBefore} : 0u) | (k + 1 < pieces ? std::uint32_t{kMoreBehind} : 0u));
    }
}

// The transformation as the drives see it. It changes where the path stands: the channel is at a barrier, or the rotary axis turns
// in the pole between two moves that end with a stop.
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
        if (places.axis[r] >= view_->axis_count) {   // no axis: it stands at its centre
            k.sign[r] = 1.0, k.shift[r] = 0.0;
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

void RecordSink::add(const Move& move, const BlockContext& at, bool told, std::uint64_t number, std::uint32_t flags) {
    use_transformation(move);
    PathRecord& r = maker_->next_move();
    r.flags |= flags;
    r.transform = entry_;
    const AxisValues &from = move.kinematics ? move.path_start : move.machine_start, &to = move.kinematics ? move.path : move.machine;
    const bool arc = move.kind == MoveKind::ArcCw || move.kind == MoveKind::ArcCcw || (move.kind == MoveKind::Thread && move.sweep != 0);
    r.kind = code_of(arc ? RecordKind::Arc : RecordKind::Line);
    AxisSet moved = move.moved;
    if (arc) moved |= 1u << move.plane_p | 1u << move.plane_q;
    for (unsigned i = 0; i < view_->axis_count && r.axis_count < kMaxPathAxes; ++i) {
        if (!(moved >> i & 1)) continue;
        if (arc && i == move.plane_p) r.plane[0] = r.axis_count;
        if (arc && i == move.plane_q) r.plane[1] = r.axis_count;
        r.axis[r.axis_count] = view_->axes[i].machine_axis;
        r.start[r.axis_count] = from[i];
        r.end[r.axis_count++] = to[i];
    }
    if (arc) fill_arc(move, r);
    place(at, r);
    r.spindle = move.spindle;
    r.feed_mode = static_cast<std::uint8_t>(move.feed_mode);
    switch (move.feed_mode) {
        case FeedMode::PerMinute: r.feed = move.feed / 60 * move.feed_scale; break;
        case FeedMode::InverseTime:   // 1/min over the length of this block: a speed like any other once that is known
            r.feed = move.feed / 60 * maker_->length_of_next();
            r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerMinute);
            break;
        default: r.feed = move.feed * move.feed_scale; break;
    }
    if (move.speed_limit > 0 && r.feed_mode == static_cast<std::uint8_t>(FeedMode::PerMinute)) r.feed = std::min(r.feed, move.speed_limit / 60);
    if (move.kind == MoveKind::Rapid || move.kind == MoveKind::Reference) r.flags |= kRapid;
    if (move.kind == MoveKind::Rapid && move.speed_limit > 0) r.feed = move.speed_limit / 60;
    if (move.kind == MoveKind::Reference) r.flags |= kReference;
    if (move.kind == MoveKind::Skip) {
        r.flags |= kSkipMove | (move.skip_release ? std::uint32_t{kSkipRelease} : 0u);
        const auto input = move.skip_name.empty() ? std::optional<std::uint32_t>(move.skip_input) : input_by_name(move.skip_name, view_->channel);
        r.code = input ? static_cast<std::int32_t>(*input) : -1;   // a signal that does not exist never comes
        if (move.skip_torque != 0) {
            r.flags |= kFixedStop;
            r.value = std::max(move.skip_torque, 0.0);
            if (move.skip_name.empty()) r.code = -1;
        }
        if (move.fixed_stop) r.flags |= kFixedStop | (move.stop_must_come ? std::uint32_t{kStopMustCome} : 0u);
    }
    if (move.kind == MoveKind::Thread) {
        r.flags |= kThread | kOverrideLocked;
        if (move.thread_chained) r.flags |= kThreadChained;
        r.feed_mode = static_cast<std::uint8_t>(FeedMode::Thread);
        r.lead = move.lead_path;
        r.lead_change = move.lead > 0 ? move.lead_change * move.lead_path / move.lead : 0;
        r.start_angle = move.start_angle;
        fill_retract(move, r);
    }
    if (move.tap_turns != 0 && r.axis_count < kMaxPathAxes && move.spindle != 0) {
        r.flags |= kTapping | kOverrideLocked | kExactStop | (move.tap_out ? std::uint32_t{kTapOut} : 0u);
        r.axis[r.axis_count] = static_cast<std::uint8_t>(kMaxAxes + move.spindle - 1u);   // behind the axes: its slot is no axis
        r.end[r.axis_count] = move.tap_turns;
        r.value = move.tap_feedforward ? 1.0 : 0.0;
        if (move.feed_mode == FeedMode::PerRevolution) {   // the spindle does not lead, it is led
            r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerMinute);
            r.feed = move.feed * move.tap_rpm / 60;
        }
    }
    if (move.exact_stop) r.flags |= kExactStop;
    if (move.in_position) r.flags |= kExactStop | kInPosition;
    if (move.override_locked) r.flags |= kOverrideLocked;
    if (maker_->length_of_next() > 0) {
        r.note = told ? note([&](Sink& sink) { sink.move(move, at); }) : number;
        if (move.kind == MoveKind::Skip && r.note) skip_ = {r.note, move, at, std::string(at.tool.name), std::string(at.cycle), std::string(move.skip_name)};
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
            ++r.axis_count;
        }
        if (slot < r.retract.size()) r.retract[slot] = move.withdraw[k];
    }
}

// Radii and angles from the points themselves, so that the record meets them exactly whatever was rounded on the way.
void RecordSink::fill_arc(const Move& move, PathRecord& r) const {
    const std::size_t p = r.plane[0], q = r.plane[1];
    const double p0 = r.start[p] - move.centre_p, q0 = r.start[q] - move.centre_q;
    const double p1 = r.end[p] - move.centre_p, q1 = r.end[q] - move.centre_q;
    const double start = std::atan2(q0, p0);
    const double rest = std::remainder(std::atan2(q1, p1) - start - move.sweep, 2 * std::numbers::pi);
    r.shape[arc_shape::kCentreP] = move.centre_p;
    r.shape[arc_shape::kCentreQ] = move.centre_q;
    r.shape[arc_shape::kRadius] = std::hypot(p0, q0);
    r.shape[arc_shape::kStartAngle] = start;
    r.shape[arc_shape::kSweep] = move.sweep + rest;
    const double last = std::hypot(p1, q1);   // nearly the same is the same: no parameter needed
    r.shape[arc_shape::kRadiusEnd] = std::abs(last - r.shape[arc_shape::kRadius]) > 1e-9 ? last : r.shape[arc_shape::kRadius];
}

void RecordSink::dwell(const Dwell& dwell, const BlockContext& at) {
    PathRecord r = event(RecordKind::Dwell, at, note([&](Sink& sink) { sink.dwell(dwell, at); }));
    r.feed_mode = static_cast<std::uint8_t>(dwell.revolutions ? FeedMode::Revolutions : FeedMode::Seconds);
    r.feed = dwell.value;
    r.spindle = dwell.spindle;
    if (const auto input = dwell.until.empty() ? std::nullopt : input_by_name(dwell.until, view_->channel)) {
        r.flags |= kSkipMove;
        r.code = static_cast<std::int32_t>(*input);
    }
    push(r, true, false);
}

void RecordSink::aux(const Aux& aux, const BlockContext& at) {
    PathRecord r = event(RecordKind::Aux, at, aux.silent ? 0 : note([&](Sink& sink) { sink.aux(aux, at); }));
    r.code = aux.letter;
    r.value = aux.value;
    if (aux.beside) r.flags |= kBesidePath;
    copy_text(aux.text, r.text);
    push(r, true, aux.drained);
}

void RecordSink::spindle(const Spindle& spindle, const BlockContext& at) {
    std::uint64_t number = spindle.silent ? 0 : note([&](Sink& sink) { sink.spindle(spindle, at); });
    PathRecord r = event(RecordKind::SpindleMode, at, number);
    r.spindle = spindle.spindle;
    r.code = static_cast<std::int32_t>(spindle.mode);
    r.value = spindle.value;
    if ((spindle.mode == SpindleModeCode::Rpm || spindle.mode == SpindleModeCode::SurfaceSpeed) && spindle.spindle <= kMaxSpindles) r.value *= shares_.spindle[spindle.spindle];
    r.shape[0] = spindle.limit;
    if (spindle.css_axis >= 0) {
        r.axis[0] = view_->axes[static_cast<std::size_t>(spindle.css_axis)].machine_axis;
        r.shape[1] = spindle.css_zero;
    }
    if (spindle.mode == SpindleModeCode::Position) {
        r.plane[0] = static_cast<std::uint8_t>(spindle.approach);
        r.shape[2] = spindle.way;
        if (spindle.beside && spindle.spindle >= 1 && spindle.spindle <= kMaxSpindles) {
            r.flags |= kBesidePath;
            under_way_.spindle[spindle.spindle - 1u] = true;
            return push(r, false, false);
        }
    }
    if (spindle.mode == SpindleModeCode::Watch) {
        r.value = spindle.watch[0];
        r.shape[0] = spindle.watch[1], r.shape[2] = spindle.watch[2], r.shape[3] = spindle.watch[3];
    }
    const bool couples = spindle.mode == SpindleModeCode::Couple, frees = spindle.mode == SpindleModeCode::Uncouple;
    if (couples || frees) {
        r.axis[0] = spindle.follower;
        r.axis[1] = spindle.helix;
        r.shape[0] = spindle.turns, r.shape[1] = spindle.master_turns, r.shape[2] = spindle.phase_deg, r.shape[3] = spindle.helix_deg_mm;
        r.mask = (spindle.gear ? 1u : 0u) | (spindle.cutter ? 2u : 0u);
        return push(r, true, true);   // what follows it is an axis that has turned
    }
    // An S word alone is a speed; what it turns like is the PLC's.
    const bool plain = spindle.mode == SpindleModeCode::Rpm && !spindle.mode_changed && !spindle.limit_changed;
    if (plain) r.kind = code_of(RecordKind::SpindleSpeed);
    push(r, spindle.mode == SpindleModeCode::Position, false);
}

void RecordSink::wait(const Wait& wait, const BlockContext& at) {
    if (wait.act == Wait::Act::Arrive) {
        Outstanding whom;
        for (unsigned i = 0; i < view_->axis_count; ++i)
            if (wait.axes >> i & 1u) whom.axis[view_->axes[i].machine_axis] = true;
        for (unsigned s = 0; s < kMaxSpindles; ++s) whom.spindle[s] = (wait.spindles >> s & 1u) != 0;
        return await(whom, at);
    }
    if (wait.act != Wait::Act::Meet) {
        PathRecord r = event(RecordKind::Marker, at, note([&](Sink& sink) { sink.wait(wait, at); }));
        r.code = static_cast<std::int32_t>(wait.code);
        r.value = wait.act == Wait::Act::SetMarker ? 1.0 : 0.0;
        push(r, false, false);
        return;
    }
    PathRecord r = event(RecordKind::Wait, at, note([&](Sink& sink) { sink.wait(wait, at); }));
    r.code = static_cast<std::int32_t>(wait.code);
    r.mask = wait.channels;
    copy_text(wait.marker, r.text);
    if (wait.flying) r.flags |= kFlying;
    const bool in_passing = wait.flying && wait.code == kBalanceMeeting;   // between two moves of a block: nobody reads the world there
    push(r, true, !in_passing);
}

void RecordSink::variable(const Variable& variable, const BlockContext& at) {
    const std::uint64_t number = note([&](Sink& sink) { sink.variable(variable, at); });
    if (variable.persistent < 0 && number == 0) return;   // nobody outside this process would notice
    PathRecord r = event(RecordKind::Variable, at, number);
    r.code = variable.persistent;
    r.mask = variable.channel;
    r.value = variable.value;
    copy_text(variable.name, r.text);
    push(r, false, false);
}

void RecordSink::offset(const OffsetWrite& offset, const BlockContext& at) {
    if (changes_) changes_->wrote(offset);
    PathRecord r = event(RecordKind::Offset, at, note([&](Sink& sink) { sink.offset(offset, at); }));
    r.code = static_cast<std::int32_t>(offset.work ? OffsetTable::Work : offset.store_table);
    r.mask = static_cast<std::uint32_t>(offset.work ? offset.row : offset.number);
    r.plane[0] = static_cast<std::uint8_t>(offset.work ? offset.place : static_cast<std::int32_t>(offset.field));
    r.plane[1] = static_cast<std::uint8_t>(offset.work ? std::uint32_t{offset.until_power_off} : offset.channel);
    r.value = offset.value;
    push(r, false, false);
}

void RecordSink::message(std::string_view text, const BlockContext& at) {
    PathRecord r = event(RecordKind::Message, at, note([&](Sink& sink) { sink.message(text, at); }));
    copy_text(text, r.text);
    push(r, false, false);
}

void RecordSink::interrupts(const Interrupts& interrupts, const BlockContext& at) {
    PathRecord r = event(RecordKind::Interrupts, at, 0);
    r.code = interrupts.on;
    r.mask = (interrupts.at_block_end ? kInterruptAtBlockEnd : 0u) | (interrupts.by_level ? kInterruptByLevel : 0u) | (interrupts.mint ? kInterruptByMint : 0u) | (interrupts.inputs << kInterruptInput);
    push(r, false, false);
}

void RecordSink::signal(std::string_view name, double value, const BlockContext& at) {
    if (name == "SMOOTHING") {   // how the path is made, nobody else's business
        maker_->flush();
        maker_->smooth(smoothing_of(view_->table(), view_->machine, view_->channel, static_cast<int>(value)));
        return;
    }
    if (takes_share(name, value) || demand(name, value, at)) return;
    static constexpr std::pair<std::string_view, std::int32_t> kCodes[] = {
        {"TAPPING", kFlagTapping}, {"CONTROL", kFlagControl}, {"STROKE2", kFlagStroke2}, {"CN_UOUT", kFlagOutputs}, {"CN_UOUTW", kFlagOutputsWide},
        {"CN_BALANCE", kFlagBalance}};
    for (const auto& [known, code] : kCodes) {
        if (name != known) continue;
        PathRecord r = event(RecordKind::Flag, at, 0);
        r.code = code;
        r.value = value;
        push(r, false, false);
    }
}

void RecordSink::parameter(std::string_view line, const BlockContext& at) {
    PathRecord r = event(RecordKind::Parameter, at, 0);
    copy_text(line, r.text);
    push(r, true, false);
}

// Only an event: a variable that nobody keeps.
void RecordSink::print(std::string_view text, const BlockContext& at) {
    const std::uint64_t number = note([&](Sink& sink) { sink.print(text, at); });
    if (number == 0) return;
    PathRecord r = event(RecordKind::Variable, at, number);
    r.code = -1;
    copy_text("DPRNT", r.text);   // a name that the store does not keep
    push(r, false, false);
}

void RecordSink::stop(const Stop& stop, const BlockContext& at) {
    if (stop.reason != StopReason::M00 && stop.reason != StopReason::M01 && stop.reason != StopReason::Restart && stop.reason != StopReason::Alarm) await(under_way_, at);
    PathRecord r = event(RecordKind::Stop, at, note([&](Sink& sink) { sink.stop(stop, at); }));
    r.code = static_cast<std::int32_t>(stop.reason);
    const bool goes_on = stop.reason == StopReason::M00 || stop.reason == StopReason::M01;
    if (stop.reason == StopReason::Restart) return push(r, true, false);   // the interpreter reads on behind it
    if (!goes_on && more_parts_) r.kind = code_of(RecordKind::Barrier);   // reported, but the machine goes on with the next part
    push(r, true, goes_on || more_parts_);
    if (!goes_on) stopped_ = true;
}

void RecordSink::part(double count, const BlockContext& at) {
    PathRecord r = event(RecordKind::Part, at, note([&](Sink& sink) { sink.part(count, at); }));
    r.value = count;
    push(r, false, false);
}

// In path order: the machine drives what stands before it, then reports it and stands.
void RecordSink::alarm(const Diagnosis& diagnosis, const BlockContext& at) {
    const std::uint64_t number = note([&](Sink& sink) { sink.alarm(diagnosis, at); });
    const bool error = diagnosis.severity() == Severity::Error;
    PathRecord r = event(error ? RecordKind::Stop : RecordKind::Message, at, number);
    r.code = error ? static_cast<std::int32_t>(StopReason::Alarm) : 0;
    r.value = static_cast<double>(static_cast<std::int32_t>(diagnosis.alarm));
    copy_text(diagnosis.text(), r.text);
    push(r, error, false);
    if (error) stopped_ = failed_ = true;
}

void RecordSink::barrier(const BlockContext& at) {
    await_spindles(at);   // a preprocessing stop waits for them
    PathRecord r = event(RecordKind::Barrier, at, 0);
    push(r, true, true);
}

void RecordSink::block_end(const BlockContext& at) { last_ = at; }

void RecordSink::skip_ended(Port& port) {
    if (!skip_.number || !describe_) return;
    Move& m = skip_.move;
    m.skip_name = skip_.input;
    m.kinematics = nullptr;   // it may be gone
    skip_.at.tool.name = skip_.tool;
    skip_.at.cycle = skip_.cycle;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const auto end = m.moved >> i & 1u ? port.axis_at_skip(view_->axes[i].machine_axis) : std::nullopt;
        if (!end) continue;
        const double there = view_->axes[i].from_drive(*end);
        m.pos[i] += there - m.machine[i];
        m.machine[i] = there;
    }
    text_->clear();
    describe_->move(m, skip_.at);
    if (!text_->empty() && text_->back() == '\n') text_->pop_back();
    if (!text_->empty()) put_note_(skip_.number, *text_);
    skip_.number = 0;
}

void RecordSink::reach_barrier() {
    if (!drained_) barrier(last_);
}

void RecordSink::finish(StopReason reason) {
    if (stopped_) maker_->flush();
    else stop({reason}, last_);
}

void RecordSink::end_of_part() { reach_barrier(); }

}  // namespace polyturn::channels
