#include "kernel/channel/channel_runner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kMoves = 1e-9;  // mm, degrees in a tick: less is how transformations round
}  // namespace

ChannelRunner::ChannelRunner(Core& core, unsigned index)
    : core_(core), index_(index), number_(index + 1) {}

void ChannelRunner::prepare() {
    if (path_.planner) return;
    path_.planner = std::make_unique<PathPlanner>();
    thread_.follower = std::make_unique<ThreadFollower>();
    retrace_.trail.prepare(core_.config.history);
    path_.inbox.prepare();
}

void ChannelRunner::attach(const ChannelSegment& segment) {
    prepare();
    thread_.follower->configure(core_.config.tick_s);
    thread_.empty();
    path_.planner->configure(core_.config.tick_s,
                             std::min<std::uint32_t>(core_.config.horizon, kPlannerWindow - 2));
    retrace_.trail.configure(core_.config.tick_s,
                             std::min<std::uint32_t>(core_.config.horizon, kPlannerWindow - 2));
    retrace_.way = Retrace::Way::None;
    resume_.question = 0;
    interrupts_.nothing_ahead();
    // P1: the first one was stored before the segment was published
    path_.epoch = segment.epoch.load(std::memory_order_acquire);
    path_.cursor = 0;
    path_.inbox.attach(segment);
    axes_.off_path = axes_.placed = {};
    // P2: nothing of its ring was taken
    core_.image.path_tail[index_].tail.store(0, std::memory_order_release);
    plan_anew(0);
    // A successor has seen none of the events of its predecessor and must not: it starts with the
    // next one.
    // P4: own head
    outbox_.begin_at(core_.image.events[index_].head.load(std::memory_order_relaxed));
    path_.limit = ~0ull;
    standing_.handshake.early = kNoRecord;
    path_.at_boundary = true;
    standing_.phase = Phase::None;
    standing_.begun = program_.alarm = standing_.wait.owed = restart_.refused = false;
    program_.brakes.remove(Brake::Hold, Brake::Reset, Brake::Alarm);
    process_.life = ProcessLink::Life::Live;
    path_.flying = path_.let_pass = kNoRecord;
    restart_.stage = RestartState::None;
    core_.waits.leave(index_);
    ++program_.run;
    program_.control = 0;  // a predecessor's program put off what the operator's switches do
    hand_.lines.broken_off();
    hand_.block = {};
    process_.selected = false;  // it knows nothing of its predecessor's commands
    shown_.broken_off = 0;
    program_.enter(ChannelState::Reset, StopReason::None);
    process_.segment = &segment;
}

bool ChannelRunner::stops_path(const PathRecord& r) noexcept {
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::Flag:
            return r.code == kFlagControl &&
                   (static_cast<std::uint32_t>(r.value) & kControlGroupEnds) != 0;
        case RecordKind::Line:
        case RecordKind::Arc:
        case RecordKind::Curve:
            return (r.flags & kThread) != 0;
        case RecordKind::SpindleMode: {
            const auto mode = static_cast<SpindleModeCode>(r.code);
            if (mode == SpindleModeCode::Position && (r.flags & kPositioning)) return false;
            return mode == SpindleModeCode::Position || mode == SpindleModeCode::Couple ||
                   mode == SpindleModeCode::Uncouple;
        }
        case RecordKind::Variable:
        case RecordKind::Offset:
        case RecordKind::ToolData:
        case RecordKind::LifeGroup:
        case RecordKind::SpindleSpeed:
        case RecordKind::Message:
        case RecordKind::Part:
        case RecordKind::Interrupts:
        case RecordKind::Marker:
            return false;
        case RecordKind::PositioningAxis: {  // it may be one too many, or have to wait for room
            const auto step = static_cast<PositioningStep>(r.code);
            return step == PositioningStep::Begin || step == PositioningStep::Room;
        }
        default:
            return true;
    }
}

// What brings something to the disk without stopping the path.
bool ChannelRunner::writes_store(const PathRecord& r) noexcept {
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::Variable:
        case RecordKind::Offset:
        case RecordKind::ToolData:
        case RecordKind::LifeGroup:
            return true;
        default:
            return false;
    }
}

void ChannelRunner::plan_anew(std::uint64_t from) noexcept {
    path_.planner->clear(from);
    path_.writes_ahead = 0;
}

// After a reset the ring still holds what the channel pushed before it heard of it. Nothing of that
// is executed.
void ChannelRunner::drop_old_epochs(std::uint64_t most) noexcept {
    path_.inbox.look(path_.cursor);
    if (!path_.planner || path_.planner->next_record() != path_.cursor || !path_.planner->at_rest())
        return;
    const auto head = path_.inbox.head(path_.cursor), from = path_.cursor;
    while (path_.cursor < head && path_.cursor - from < most &&
           path_.inbox.epoch_of(path_.cursor) != path_.epoch)
        ++path_.cursor;
    if (path_.cursor == from) return;
    path_.inbox.begin_at(path_.cursor);
    plan_anew(path_.cursor);
    // P2: the records before cursor_ are needed no more
    core_.image.path_tail[index_].tail.store(path_.cursor, std::memory_order_release);
}

bool ChannelRunner::supplied() noexcept {
    if (!listens()) return true;
    // Quiet first: what it pushed before it became quiet is then visible in the head that supply()
    // reads (P1).
    if (const std::uint64_t asked = std::max(resume_.question, interrupts_.ahead_asked);
        asked && process_.segment->answered.load(std::memory_order_acquire) < asked)
        return false;
    // P1: as above. Both before the head is looked at
    const bool quiet = process_.segment->quiet.load(std::memory_order_acquire) >= outbox_.sent();
    drop_old_epochs(kPathRing);  // between two ticks: all of them
    return quiet || path_.inbox.refusal().field ||
           path_.inbox.head(path_.cursor) - path_.cursor >= core_.config.horizon;
}

// Marks of the PLC that are keys of the operator (Fagor: BLKSKIP1 to BLKSKIP3, M01STOP, M5008).
void ChannelRunner::take_keys() noexcept {
    // Machine lock changes only while no program runs: a moving axis that is locked would stop, one
    // that is unlocked away from its path would jump.
    const std::uint32_t lock = program_.runs() || path_.moving ? panel_.keys & kKeyMachineLock
                                                               : panel_.pressed & kKeyMachineLock;
    panel_.keys = (panel_.pressed & ~static_cast<std::uint32_t>(kKeyMachineLock)) | lock;
    const auto mark = [&](PlcSignal signal, std::uint32_t bit) {
        if (core_.signals.plc(signal(number_))) panel_.keys |= bit;
    };
    mark(signals::blkskip1, kKeyBlockSkip1);
    mark(signals::blkskip2, kKeyBlockSkip1 << 1);
    mark(signals::blkskip3, kKeyBlockSkip1 << 2);
    mark(signals::m01stop, kKeyOptionalStop);
    mark(signals::m5008, kKeySingleBlock);
    mark(signals::cp_rapidkey, kKeyRapid);
    if (program_.control & kControlNoSingleBlock)
        panel_.keys &= ~static_cast<std::uint32_t>(kKeySingleBlock);
}

// Whether single block stops behind a record. What follows of its block belongs to it (M3 S500 G1
// Z-1. is one block), except the next move: a cycle is driven move by move. A macro statement is no
// block (fanuc_lathe 6.7), nor is a statement outside the path, such as the one that suppresses
// single block.
bool ChannelRunner::block_ends_at(std::uint64_t index) const noexcept {
    const PathRecord& r = record(index);
    if (!(r.flags & kBlockEnd) || (!is_motion(r) && (r.flags & kMoreBehind)) ||
        static_cast<RecordKind>(r.kind) == RecordKind::Flag)
        return false;
    if (index + 1 >= path_.visible_end) return true;
    const PathRecord& next = record(index + 1);
    return next.serial != r.serial || next.serial == 0 || next.epoch != r.epoch ||
           (is_motion(r) && is_motion(next));
}

void ChannelRunner::supply() noexcept {
    take_keys();  // the rapid key is for jogging too, which needs no process
    if (!process_.segment) return;
    drop_old_epochs(RecordInbox::kSkipsPerTick);
    if (process_.listens())
        path_.limit = std::min(path_.inbox.head(path_.cursor), path_.cursor + core_.config.horizon);
    take_records();
    judge_stroke_anew();
    while (path_.planner->wants_record() && path_.planner->next_record() < path_.visible_end) {
        const PathRecord& r = record(path_.planner->next_record());
        // pushed after a reset of which the path has not come to rest yet
        if (r.epoch != path_.epoch) break;
        if (r.flags & kAtOnce) break;  // obey_ahead() does it; the path breaks off before
        // A flying record cannot wait when its turn comes. So it is not planned before the store's
        // ring has room for it: the path comes to rest in front of it until the store has caught
        // up.
        if (writes_store(r)) {
            if (path_.writes_ahead == StoreLink::kWritesAhead || !core_.store.has_room()) break;
            ++path_.writes_ahead;
        }
        const bool flying =
            static_cast<RecordKind>(r.kind) == RecordKind::Wait && (r.flags & kFlying);
        if (flying && path_.flying == kNoRecord) path_.flying = path_.planner->next_record();
        PlannedRecord planned = PlannedRecord::from(r, stops_path(r));
        planned.block_end = block_ends_at(path_.planner->next_record());
        if (r.flags & kTapping) limit_tapping(r, planned);
        if (is_motion(r) && ends_at_limit(r)) {
            planned.length = path_.cut.s;
            planned.stop_after = true;
            planned.stop_before = planned.stop_before || path_.cut.s < kOnLimit;
        }
        planned.v_max = std::min(planned.v_max, ceiling_before_reference(r));
        if (superposes() || path_.overlays) {
            planned.v_max *= 1 - kOverlayShare;
            planned.a_max *= 1 - kOverlayShare;
            planned.j_max *= 1 - kOverlayShare;
        }
        path_.planner->append(planned);
    }
}

// Limits that have changed act on what is planned as soon as the path rests; until then the axes
// are braked where they must.
void ChannelRunner::judge_stroke_anew() noexcept {
    if (!path_.cut.places_known || path_.cut.version != core_.stroke.version(index_)) {
        if (!at_rest() || !path_.at_boundary) return;
        plan_anew(path_.cursor);
        path_.flying = path_.let_pass = kNoRecord;
        path_.cut.record = kNoRecord;
        path_.cut.version = core_.stroke.version(index_);
    } else if (path_.planner->next_record() != path_.cursor || !at_rest()) {
        return;
    }
    // nothing is planned: the axes are at standstill
    core_.stroke.places_now(core_, index_, path_.cut.places);
    path_.cut.places_known = true;
    if (path_.planner->next_record() == path_.cursor && path_.cut.record < path_.cursor)
        path_.cut.record = kNoRecord;
}

bool ChannelRunner::ends_at_limit(const PathRecord& r) noexcept {
    StrokeFault fault;
    const double s = core_.stroke.exit_of(index_, r, kinematics_of(r), path_.cut.places, fault);
    if (!(s < r.length) || path_.cut.record != kNoRecord) return false;
    path_.cut.record = path_.planner->next_record();
    path_.cut.s = s;
    path_.cut.fault = fault;
    return true;
}

void ChannelRunner::stop_at_limit() noexcept {
    raise(Alarm::StrokeLimit,
          name_of('A', core_.stroke.axis_of(index_, path_.cut.fault.axis)).view(),
          path_.cut.fault.limit);
}

void ChannelRunner::run() noexcept {
    path_.moving = false;
    if (!process_.segment) return;
    double left = 1.0;  // part of the tick that is still to be used
    if (axes_.off_path.any()) return brake_off_path();
    axes_.placed_before = std::exchange(axes_.placed, {});
    watch_interrupt();
    const bool back = retrace_.trail.active() || (retrace_.wheel.on && handwheel_drives_trail());
    if (back) {
        if (!((program_.interrupted() || process_.dead() || resume_.aside ||
               !drives_by_handwheel()) &&
              at_rest()))
            drive_trail();
        left = 0.0;
    }
    if (path_.at_boundary && !back) execute_standing(left);
    // What took a part of the tick ends within it: motion begins with the next one.
    const bool frozen = (program_.interrupted() || process_.dead() || resume_.aside) && at_rest();
    if (standing_.phase == Phase::None && left == 1.0 && !frozen && !back) {
        drive();
        if (path_.at_boundary) {
            if (path_.step.ended_to > path_.step.ended_from)
                left = 1.0 - path_.planner->end_fraction(path_.step.ended_to - 1);
            execute_standing(left);
        }
    }
    watch_commands();
    settle();
    watch_production();
    if (program_.runs()) production_.times.cycle_s += core_.config.tick_s;
    if (program_.start_lamp()) production_.times.lit_s += core_.config.tick_s;
    if (path_.moving)
        (path_.rapid ? production_.times.rapid_s : production_.times.cutting_s) +=
            core_.config.tick_s;
    if (program_.is(ChannelState::Waiting)) production_.times.waiting_s += core_.config.tick_s;
    const auto& tail = core_.image.path_tail[index_].tail;
    // P4: own tail. P2: the records before cursor_ are needed no more
    if (tail.load(std::memory_order_relaxed) != path_.cursor)
        core_.image.path_tail[index_].tail.store(path_.cursor, std::memory_order_release);
}

// States that begin with the path at rest.
void ChannelRunner::settle() noexcept {
    if (!at_rest()) return;
    if (program_.resets()) finish_reset();
    if (interrupts_.due && is_stopped_for_interrupt()) break_off();
    settle_hold();
    if (hand_.lines.goes_on()) next_line();
    if (process_.life == ProcessLink::Life::Dead) {
        process_.life = ProcessLink::Life::DeadAtRest;
        core_.waits.leave(index_);
        core_.event(KernelEventKind::Stopped, number_, static_cast<std::int32_t>(StopReason::Death),
                    0, shown_.line);
    }
    if (program_.interrupted() && !program_.is(ChannelState::Interrupted) && !process_.dead()) {
        restart_.stage = RestartState::None;
        core_.waits.leave(index_);
        stand(ChannelState::Interrupted, StopReason::Alarm);
    }
    if (program_.holds() && !program_.interrupted() && program_.is(ChannelState::Running) &&
        standing_.phase != Phase::Handshake)
        stand(ChannelState::Held, StopReason::Held);
    if (program_.is(ChannelState::Running) &&
        ((path_.step.stands == Stands::BlockEnd && (panel_.keys & kKeySingleBlock)) ||
         program_.take_group_end()))
        stand(ChannelState::ProgramStop, StopReason::SingleBlock);
}

// What holds and slows every path of this channel.
PathInput ChannelRunner::path_input() noexcept {
    PathInput input;
    // N0313
    input.feed_override = (panel_.keys & kKeyRapid)
                              ? feed_factor() * core_.config.channels[index_].rapid_key_factor
                              : feed_factor();
    input.rapid_override = panel_.rapid_override;
    if (core_.config.channels[index_].feed_override_in_rapid)
        input.rapid_override *= std::min(panel_.feed_override, 1.0);
    input.speed_ceiling = setup_ceiling();
    // lost since it was planned
    if (path_.cursor < path_.planner->next_record())
        input.speed_ceiling =
            std::min(input.speed_ceiling, ceiling_before_reference(record(path_.cursor)));
    input.spindle_rev_s = core_.spindle_rev_s.data();
    input.hold =
        (core_.signals.plc(signals::cp_stop(number_)) && !(program_.control & kControlNoPlcStop)) ||
        program_.holds() || program_.group_ends() || program_.resets() || process_.dead() ||
        program_.interrupted() || core_.all_stop || !core_.on() || !drives_by_handwheel() ||
        standing_.wait.owed;
    if (program_.emergency()) input.emergency_dec = emergency_deceleration();
    return input;
}

void ChannelRunner::drive() noexcept {
    if (!program_.interrupted() && program_.is(ChannelState::Running) && path_.planner->at_rest() &&
        path_.cursor < path_.planner->next_record())
        refuse_bound(record(path_.cursor));
    if (path_.flying != kNoRecord && path_.planner->next_record() > path_.flying) {
        const PathRecord& r = record(path_.flying);
        if (core_.waits.open_for(index_, r.code, r.mask, core_.no_wait(), wait_phase())) {
            path_.planner->let_pass(path_.flying);
            path_.let_pass = std::exchange(path_.flying, kNoRecord);
        }
    }
    PathInput input = path_input();
    if (flies_unmet()) input.hold = true;
    const bool breaks_off = interrupts_.due && !(interrupts_.bits & kInterruptAtBlockEnd);
    const bool ends_block = interrupts_.due && !breaks_off;
    if (skip_signal() || breaks_off) input.hold = true;
    // behind a block that is no move nothing else keeps the path
    if (program_.stopped_by(StopReason::SingleBlock)) input.hold = true;
    input.single_block = (panel_.keys & kKeySingleBlock) != 0 || ends_block;
    input.in_position = axes_in_position();
    if (program_.is(ChannelState::Running) && waits_for_drive()) input.hold = true;
    if (retrace_.wheel.on) {
        input.hold = input.hold || retrace_.wheel.rate <= 0;
        input.feed_override *= std::max(retrace_.wheel.rate, 0.0);
        input.rapid_override *= std::max(retrace_.wheel.rate, 0.0);
    }
    if (panel_.keys & kKeyDryRun)
        input.dry_run_feed = dry_run_feed();
    else if (awaited_spindle())
        input.speed_ceiling = 0;  // a tap too, whose override is locked
    path_.step = path_.planner->tick(input);
    report_progress();
    if (standing_.skip.ending && path_.planner->at_rest()) end_skipped_move();
    // at the limit, in the middle of the record
    if (path_.cut.record < path_.step.ended_to && path_.cut.record >= path_.step.ended_from) {
        path_.cursor = path_.cut.record;
        path_.moving = true;
        path_.at_boundary = false;
        return;
    }
    path_.cursor = path_.step.over ? path_.step.record + 1 : path_.step.record;
    path_.moving = path_.step.speed > 0 || path_.step.ended_to > path_.step.ended_from;
    // The boundary is free when nothing but the record behind it keeps the path: not in position,
    // not single block.
    path_.at_boundary =
        path_.step.stands == Stands::BeforeRecord || path_.step.stands == Stands::NoRecord;
    if (path_.step.stands == Stands::NoRecord) path_.cursor = path_.planner->next_record();
    if (path_.step.stands == Stands::Moving && path_.step.over && path_.planner->at_rest()) {
        const PathRecord& last = record(path_.step.record);
        path_.at_boundary = !(last.flags & kInPosition) &&
                            !(input.single_block && block_ends_at(path_.step.record));
    }
    // the record that ended is the channel's again
    if (path_.step.stands == Stands::InPosition) watch_standstill(nullptr);
    if (path_.step.over || path_.cursor >= path_.planner->next_record()) return;
    const PathRecord& r = record(path_.cursor);
    if (!is_motion(r) || (r.flags & kThread)) return;
    path_.rapid = (r.flags & kRapid) != 0;
    axes_.record = path_.cursor;
    if (path_.step.s > 0) place_axes(r, path_.step.s);
    begin_function_early();
    shown_.show(r);
    watch_standstill(&r);
}

// The partners of a wait have stopped after they released this channel and before it has come
// there: the path comes to rest, at the wait if that still lies ahead, else behind it
// (after_waits).
bool ChannelRunner::flies_unmet() noexcept {
    if (path_.let_pass == kNoRecord) return false;
    if (path_.cursor > path_.let_pass) {
        path_.let_pass = kNoRecord;
        return false;
    }
    const PathRecord& r = record(path_.let_pass);
    if (core_.waits.open_for(index_, r.code, r.mask, core_.no_wait(), wait_phase())) return false;
    if (!path_.planner->at_rest()) return true;
    path_.planner->stand_before(path_.let_pass);
    path_.flying = std::exchange(path_.let_pass, kNoRecord);
    return false;
}

void ChannelRunner::report_progress() noexcept {
    const double dt = core_.config.tick_s;
    const bool any_began = path_.step.began_to > path_.step.began_from,
               any_ended = path_.step.ended_to > path_.step.ended_from;
    if (!any_began && !any_ended) return;
    const std::uint64_t from = !any_began ? path_.step.ended_from
                               : !any_ended
                                   ? path_.step.began_from
                                   : std::min(path_.step.began_from, path_.step.ended_from);
    for (std::uint64_t i = from; i < std::max(path_.step.began_to, path_.step.ended_to); ++i) {
        const PathRecord& r = record(i);
        if (i >= path_.step.began_from && i < path_.step.began_to)
            begin_record(r, path_.planner->begin_fraction(i) * dt);
        if (i < path_.step.ended_from || i >= path_.step.ended_to) continue;
        const double offset_s = path_.planner->end_fraction(i) * dt;
        axes_.record = i;
        if (i == path_.cut.record) {
            place_axes(r, path_.cut.s);
            shown_.show(r);
            stop_at_limit();
            continue;
        }
        if (is_motion(r))
            place_axes(r, r.length);
        else
            execute_instant(r, offset_s);
        if (writes_store(r)) --path_.writes_ahead;
        finished(r, i, offset_s);
    }
}

void ChannelRunner::place_axes(const PathRecord& r, double s) noexcept {
    if ((r.flags & kTapping) && !place_spindle(r, s)) return;
    SlotVector position;
    if (!drives_at(r, kinematics_of(r), s, position)) return leave_off_path(kMaxAxes);
    const double tap_gain = tap_gain_of(r);
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        if (core_.config.axes[r.axis[i]].on_spindle &&
            position[i] != core_.axes[r.axis[i]].command() &&
            !core_.shared_axes[r.axis[i]].has_drive) {
            raise(Alarm::AxisIsSpindle, name_of('A', r.axis[i]).view());
            continue;
        }
        AxisUnit& axis = core_.axes[r.axis[i]];
        axis.owner = number_;
        axes_.placed.add(r.axis[i]);
        axis.rapid = (r.flags & kRapid) != 0;
        axis.tap_with(tap_gain, tap_gain > 0 && r.value != 0);
        if (!(panel_.keys & kKeyMachineLock) && !axis.bound() && !axis.beside && !axis.detached &&
            r.axis[i] != axes_.limited) {
            // lost in transit
            if (!axis.referenced && !program_.interrupted() &&
                core_.must_be_referenced(r.axis[i]) &&
                std::fabs(position[i] - axis.command()) > kMoves) {
                shown_.show(r);
                raise(Alarm::AxisUnreferenced, name_of('A', r.axis[i]).view());
            }
            axis.move_to(position[i]);
        }
        axes_.last[i] = r.axis[i];
    }
    axes_.last_count = r.axis_count;
}

void ChannelRunner::report(KernelEventKind kind, const PathRecord& r, double offset_s) noexcept {
    if (r.note == 0) return;
    KernelEvent* event = core_.log.claim(kind, number_, core_.tick, offset_s);
    if (!event) return;
    event->note = r.note;
    event->line = r.line;
    event->code = r.kind;
    core_.log.put();
}

// Axes that obey a master, are not there, or have lost their reference while the program ran, move
// for no program.
void ChannelRunner::refuse_bound(const PathRecord& r) noexcept {
    for (std::uint32_t i = 0; is_motion(r) && i < r.axis_count; ++i)
        if (r.axis[i] == axes_.limited) {
            shown_.show(r);
            raise(Alarm::PositioningRefused, name_of('A', r.axis[i]).view());
        } else if (r.end[i] != r.start[i]) {
            const AxisUnit& axis = core_.axes[r.axis[i]];
            const bool away = axis.detached && !axis.config().on_spindle,
                       lost = !axis.referenced && core_.must_be_referenced(r.axis[i]);
            if (!axis.bound() && !axis.beside && !away && !lost) continue;
            const Alarm why = axis.bound()  ? Alarm::SlaveCommanded
                              : axis.beside ? Alarm::PositioningRefused
                              : away        ? Alarm::AxisDetached
                                            : Alarm::AxisUnreferenced;
            // the refused block, not the one before it
            shown_.show(r);
            raise(why, name_of('A', r.axis[i]).view());
        }
}

void ChannelRunner::begin_record(const PathRecord& r, double offset_s) noexcept {
    refuse_bound(r);
    shown_.serial = r.serial;
    if (r.flags & kSkipMove) standing_.skip.came = false;
    standing_.passes_stop = is_optional_stop(r) && !(panel_.keys & kKeyOptionalStop);
    // a step that waits for those before it
    const bool later =
        static_cast<RecordKind>(r.kind) == RecordKind::PositioningAxis && r.code != 0;
    if (!later && (!is_motion(r) || (r.flags & kBlockBegin)) && !standing_.passes_stop)
        report(KernelEventKind::RecordBegin, r, offset_s);
}

// An M01 whose key is off when the machine comes to it: no stop, no report. Switching the key while
// the machine is at the M01 has no effect any more.
bool ChannelRunner::is_optional_stop(const PathRecord& r) noexcept {
    return static_cast<RecordKind>(r.kind) == RecordKind::Stop &&
           static_cast<StopReason>(r.code) == StopReason::M01;
}

void ChannelRunner::finished(const PathRecord& r, std::uint64_t index, double offset_s) noexcept {
    const auto kind = static_cast<RecordKind>(r.kind);
    // what follows may be needed: an M code that removes another limit
    if (r.flags & kFixedStop) allow_torque(nullptr);
    const bool passed = standing_.passes_stop && is_optional_stop(r);
    if (kind != RecordKind::PositioningAxis && (!is_motion(r) || (r.flags & kBlockEnd)) && !passed)
        report(KernelEventKind::RecordEnd, r, offset_s);
    if ((r.flags & kStopMustCome) && !standing_.skip.came)
        raise(Alarm::FixedStopMissed,
              r.axis_count > 0 ? name_of('A', r.axis[0]).view() : std::string_view{}, r.end[0]);
    if (r.flags & kBlockEnd) ++production_.blocks;
    if (production_.ends_with_part && (r.flags & kDrains)) program_.brake_for(Brake::Reset);
    shown_.ended_serial = r.serial;
    shown_.ended_part = r.part;
    // An end can be taken back. Behind a stop that is passed the program may have been read anew,
    // so retrace cannot go back over it.
    if (!(kind == RecordKind::Stop && program_.is(ChannelState::Ended)) &&
        (!passed || (r.flags & kDrains)))
        retrace_.trail.add(r, r.length, retrace_.meeting);
    retrace_.meeting = 0;
    if (r.flags & kDrains) {
        axes_.limited = kMaxAxes;  // it takes over its axes' positions
        know_positions();
        tell(ChannelEventKind::BarrierReached, index, r.value);
    }
}

void ChannelRunner::tell(ChannelEventKind kind, std::uint64_t index, double value,
                         std::string_view text) noexcept {
    // positions and states that the channel reads are those of the end of this tick
    outbox_.put(kind, path_.epoch, core_.tick + 1, index, value, text);
}

void ChannelRunner::send_events() noexcept {
    if (!process_.segment) return;
    if (outbox_.store_changed) {
        outbox_.store_changed = false;
        tell(ChannelEventKind::StoreChanged, path_.cursor);
    }
    if (outbox_.send(core_.image.events[index_], process_.segment->event_tail, path_.cursor))
        wake();
}

void ChannelRunner::publish(ChannelStatus& status) noexcept {
    status.state = static_cast<std::uint32_t>(program_.state());
    status.mode = static_cast<std::uint32_t>(program_.mode);
    status.feed_override = panel_.feed_override;
    status.rapid_override = panel_.rapid_override;
    status.path_speed = path_.moving ? path_.step.speed : 0.0;
    const bool motion =
        process_.segment && path_.cursor < path_.visible_end && is_motion(record(path_.cursor));
    status.path_left =
        motion ? record(path_.cursor).length -
                     (path_.step.record == path_.cursor && !path_.step.over ? path_.step.s : 0.0)
               : 0.0;
    status.record = path_.cursor;
    status.line = shown_.line;
    status.file = shown_.file;
    status.block = shown_.block;
    core_.tools.publish(index_, status);
    const auto& arrival = core_.waits.at(index_);
    status.wait_code = arrival.here ? arrival.code : 0;
    status.wait_set = arrival.here ? arrival.set : 0;
    status.wait_missing = arrival.here ? core_.waits.missing(index_, core_.no_wait()) : 0;
    status.wait_since = arrival.here ? standing_.wait.since : 0;
    status.parts = production_.parts;
    status.cutting_s = production_.times.cutting_s;
    status.rapid_s = production_.times.rapid_s;
    status.waiting_s = production_.times.waiting_s;
    status.cycle_s = production_.times.cycle_s;
    status.blocks = production_.blocks;
    status.epoch = path_.epoch;
    status.stop_reason = static_cast<std::int32_t>(program_.reason());
    // Counted by command, not by key: the first and the last end by themselves, the PLC may set the
    // second one.
    status.keys = panel_.keys | (production_.stops_after_part ? kKeyStopAfterPart : 0u) |
                  (core_.signals.plc(signals::cp_nowt(number_)) ? kKeyIgnoreWaits : 0u) |
                  (retrace_.way == Retrace::Way::Back ? kKeyRetrace : 0u);
    // of the selected program, in MDI too
    status.speaks = static_cast<std::uint32_t>(process_.language != Dialect::Polyturn
                                                   ? process_.language
                                                   : core_.config.channels[index_].language);
    status.skipped = standing_.skip.came ? 1 : 0;
    status.retrace = retrace_.trail.active() ? (retrace_.trail.direction() < 0 ? -1 : 1) : 0;
    status.wheel = retrace_.wheel.on ? 1 : 0;
    status.start_missing = panel_.start_missing;
    status.broken_off = shown_.broken_off;
    status.cycles = production_.cycles;
    status.last_cycle_s = production_.last_cycle_s;
    status.mean_cycle_s = production_.cycles ? production_.cycles_s / production_.cycles : 0.0;
    status.lit_s = production_.times.lit_s;
    status.restart = static_cast<std::uint32_t>(restart_.stage);
    status.mdi_waiting = hand_.lines.waiting();
    status.by_hand = by_hand() ? 1 : 0;
    hand_.lines.publish(core_.image.mdi[index_]);
    core_.signals.set_nc(signals::cn_state(number_), static_cast<std::int32_t>(program_.state()));
    core_.signals.set_nc(signals::cn_run(number_), program_.drives());
    core_.signals.set_nc(signals::cn_hold(number_), program_.holds());
    core_.signals.set_nc(signals::stl(number_), program_.start_lamp());
    core_.signals.set_nc(signals::den(number_), distribution_ended());
    core_.signals.set_nc(signals::cn_wtng(number_), arrival.here);
    core_.signals.set_nc(signals::cn_alarm(number_), program_.alarm);
    core_.signals.set_nc(signals::cn_reset(number_), program_.reset_count);
    core_.signals.set_nc(signals::cn_end(number_), program_.is(ChannelState::Ended));
}

bool ChannelRunner::polls() const noexcept {
    return (program_.control & kControlPolls) && process_.segment &&
           program_.is(ChannelState::Running) && standing_.phase == Phase::None &&
           path_.cursor + 1 == path_.inbox.head(path_.cursor) &&
           path_.inbox.kind_of(path_.cursor) == RecordKind::Barrier;
}

bool ChannelRunner::can_go_on() const noexcept {
    if (!process_.segment) return false;
    if (path_.planner && !at_rest()) return true;
    if (program_.resets() || !outbox_.empty() || resume_.question) return true;
    if (process_.frozen()) return true;  // the timeout counts
    if (retrace_.wheel.on && retrace_.wheel.rate == 0) return standing_.phase == Phase::Handshake;
    if (retrace_.trail.active()) return program_.is(ChannelState::Running) || retrace_.wheel.on;
    if (program_.is(ChannelState::Waiting))
        return core_.config.channels[index_].wait_timeout_s > 0 && !program_.interrupted();
    if (program_.is(ChannelState::Ended) && hand_.lines.goes_on()) return true;
    if (!program_.is(ChannelState::Running)) return standing_.phase == Phase::Handshake;
    // a drive may never find it
    if (standing_.phase == Phase::Home)
        return static_cast<double>(core_.tick - standing_.since) * core_.config.tick_s < 600.0;
    if (positioning_.now()) return true;
    if (standing_.phase != Phase::None) return true;
    if (path_.step.stands == Stands::NoFeed)
        return panel_.feed_override > 0;  // a spindle may come up to speed
    if (polls()) return false;
    // The ring itself, not what the last tick saw of it: a wait that has just opened is followed by
    // records pushed since.
    return path_.cursor < path_.inbox.head(path_.cursor) || path_.step.stands == Stands::Moving;
}

}  // namespace polyturn::kernel
