#include "kernel/channel/channel_runner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::kernel {
namespace {
// A channel sleeps when its ring is full; it is woken when this much has become free, not for every
// record.
constexpr std::uint64_t kWakeChunk = 1024;
constexpr double kMoves = 1e-9;  // mm, degrees in a tick: less is how transformations round
}  // namespace

ChannelRunner::ChannelRunner(Core& core, unsigned index)
    : core_(core), index_(index), number_(index + 1), names_(std::make_unique<ProgramNames>()) {}

void ChannelRunner::prepare() {
    if (planner_) return;
    planner_ = std::make_unique<PathPlanner>();
    thread_ = std::make_unique<ThreadFollower>();
    trail_.prepare(core_.config.history);
    inbox_.prepare();
}

void ChannelRunner::attach(const ChannelSegment& segment) {
    prepare();
    thread_->configure(core_.config.tick_s);
    thread_moving_ = thread_committed_ = false;
    planner_->configure(core_.config.tick_s,
                        std::min<std::uint32_t>(core_.config.horizon, kPlannerWindow - 2));
    trail_.configure(core_.config.tick_s,
                     std::min<std::uint32_t>(core_.config.horizon, kPlannerWindow - 2));
    retrace_ = 0;
    question_ = ahead_asked_ = 0;
    ahead_ = kNoRecord;
    // P1: the first one was stored before the segment was published
    epoch_ = segment.epoch.load(std::memory_order_acquire);
    cursor_ = 0;
    inbox_.attach(segment);
    off_path_ = placed_ = {};
    // P2: nothing of its ring was taken
    core_.image.path_tail[index_].tail.store(0, std::memory_order_release);
    plan_anew(0);
    // A successor has seen none of the events of its predecessor and must not: it starts with the
    // next one.
    // P4: own head
    events_sent_ = core_.image.events[index_].head.load(std::memory_order_relaxed);
    outbox_count_ = 0;
    limit_ = ~0ull;
    rung_at_ = 0;
    early_ = kNoRecord;
    at_boundary_ = true;
    phase_ = Phase::None;
    begun_ = hold_ = dead_ = stopped_ = resetting_ = interrupted_ = alarm_ = owes_rendezvous_ =
        restart_refused_ = false;
    flying_ = let_pass_ = kNoRecord;
    restart_ = RestartState::None;
    core_.waits.leave(index_);
    ++run_;
    control_ = 0;  // a predecessor's program put off what the operator's switches do
    lines_.broken_off();
    hand_ = {};
    selected_ = false;  // it knows nothing of its predecessor's commands
    broken_off_ = 0;
    state_ = ChannelState::Reset;
    stop_reason_ = StopReason::None;
    segment_ = &segment;
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
    planner_->clear(from);
    writes_ahead_ = 0;
}

// After a reset the ring still holds what the channel pushed before it heard of it. Nothing of that
// is executed.
void ChannelRunner::drop_old_epochs(std::uint64_t most) noexcept {
    inbox_.look(cursor_);
    if (!planner_ || planner_->next_record() != cursor_ || !planner_->at_rest()) return;
    const auto head = inbox_.head(cursor_), from = cursor_;
    while (cursor_ < head && cursor_ - from < most && inbox_.epoch_of(cursor_) != epoch_) ++cursor_;
    if (cursor_ == from) return;
    inbox_.begin_at(cursor_);
    plan_anew(cursor_);
    // P2: the records before cursor_ are needed no more
    core_.image.path_tail[index_].tail.store(cursor_, std::memory_order_release);
}

bool ChannelRunner::supplied() noexcept {
    if (!listens()) return true;
    // Quiet first: what it pushed before it became quiet is then visible in the head that supply()
    // reads (P1).
    if (const std::uint64_t asked = std::max(question_, ahead_asked_);
        asked && segment_->answered.load(std::memory_order_acquire) < asked)
        return false;
    // P1: as above. Both before the head is looked at
    const bool quiet = segment_->quiet.load(std::memory_order_acquire) >= events_sent_;
    drop_old_epochs(kPathRing);  // between two ticks: all of them
    return quiet || inbox_.refusal().field ||
           inbox_.head(cursor_) - cursor_ >= core_.config.horizon;
}

// Marks of the PLC that are keys of the operator (Fagor: BLKSKIP1 to BLKSKIP3, M01STOP, M5008).
void ChannelRunner::take_keys() noexcept {
    // Machine lock changes only while no program runs: a moving axis that is locked would stop, one
    // that is unlocked away from its path would jump.
    const std::uint32_t lock =
        program_runs() || moving_ ? keys & kKeyMachineLock : pressed_keys & kKeyMachineLock;
    keys = (pressed_keys & ~static_cast<std::uint32_t>(kKeyMachineLock)) | lock;
    const auto mark = [&](PlcSignal signal, std::uint32_t bit) {
        if (core_.signals.plc(signal(number_))) keys |= bit;
    };
    mark(signals::blkskip1, kKeyBlockSkip1);
    mark(signals::blkskip2, kKeyBlockSkip1 << 1);
    mark(signals::blkskip3, kKeyBlockSkip1 << 2);
    mark(signals::m01stop, kKeyOptionalStop);
    mark(signals::m5008, kKeySingleBlock);
    mark(signals::cp_rapidkey, kKeyRapid);
    if (control_ & kControlNoSingleBlock) keys &= ~static_cast<std::uint32_t>(kKeySingleBlock);
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
    if (index + 1 >= visible_end_) return true;
    const PathRecord& next = record(index + 1);
    return next.serial != r.serial || next.serial == 0 || next.epoch != r.epoch ||
           (is_motion(r) && is_motion(next));
}

void ChannelRunner::supply() noexcept {
    take_keys();  // the rapid key is for jogging too, which needs no process
    if (!segment_) return;
    drop_old_epochs(RecordInbox::kSkipsPerTick);
    if (!dead_ && !stopped_)
        limit_ = std::min(inbox_.head(cursor_), cursor_ + core_.config.horizon);
    take_records();
    judge_stroke_anew();
    while (planner_->wants_record() && planner_->next_record() < visible_end_) {
        const PathRecord& r = record(planner_->next_record());
        // pushed after a reset of which the path has not come to rest yet
        if (r.epoch != epoch_) break;
        if (r.flags & kAtOnce) break;  // obey_ahead() does it; the path breaks off before
        // A flying record cannot wait when its turn comes. So it is not planned before the store's
        // ring has room for it: the path comes to rest in front of it until the store has caught
        // up.
        if (writes_store(r)) {
            if (writes_ahead_ == StoreLink::kWritesAhead || !core_.store.has_room()) break;
            ++writes_ahead_;
        }
        const bool flying =
            static_cast<RecordKind>(r.kind) == RecordKind::Wait && (r.flags & kFlying);
        if (flying && flying_ == kNoRecord) flying_ = planner_->next_record();
        PlannedRecord planned = PlannedRecord::from(r, stops_path(r));
        planned.block_end = block_ends_at(planner_->next_record());
        if (r.flags & kTapping) limit_tapping(r, planned);
        if (is_motion(r) && ends_at_limit(r)) {
            planned.length = cut_.s;
            planned.stop_after = true;
            planned.stop_before = planned.stop_before || cut_.s < kOnLimit;
        }
        planned.v_max = std::min(planned.v_max, ceiling_before_reference(r));
        if (superposes() || overlays_) {
            planned.v_max *= 1 - kOverlayShare;
            planned.a_max *= 1 - kOverlayShare;
            planned.j_max *= 1 - kOverlayShare;
        }
        planner_->append(planned);
    }
}

// Limits that have changed act on what is planned as soon as the path rests; until then the axes
// are braked where they must.
void ChannelRunner::judge_stroke_anew() noexcept {
    if (!cut_.places_known || cut_.version != core_.stroke.version(index_)) {
        if (!at_rest() || !at_boundary_) return;
        plan_anew(cursor_);
        flying_ = let_pass_ = kNoRecord;
        cut_.record = kNoRecord;
        cut_.version = core_.stroke.version(index_);
    } else if (planner_->next_record() != cursor_ || !at_rest()) {
        return;
    }
    // nothing is planned: the axes are at standstill
    core_.stroke.places_now(core_, index_, cut_.places);
    cut_.places_known = true;
    if (planner_->next_record() == cursor_ && cut_.record < cursor_) cut_.record = kNoRecord;
}

bool ChannelRunner::ends_at_limit(const PathRecord& r) noexcept {
    StrokeFault fault;
    const double s = core_.stroke.exit_of(index_, r, kinematics_of(r), cut_.places, fault);
    if (!(s < r.length) || cut_.record != kNoRecord) return false;
    cut_.record = planner_->next_record();
    cut_.s = s;
    cut_.fault = fault;
    return true;
}

void ChannelRunner::stop_at_limit() noexcept {
    raise(Alarm::StrokeLimit, name_of('A', core_.stroke.axis_of(index_, cut_.fault.axis)).view(),
          cut_.fault.limit);
}

void ChannelRunner::run() noexcept {
    moving_ = false;
    if (!segment_) return;
    double left = 1.0;  // part of the tick that is still to be used
    if (off_path_.any()) return brake_off_path();
    placed_before_ = std::exchange(placed_, {});
    watch_interrupt();
    const bool back = trail_.active() || (handwheel_ && handwheel_drives_trail());
    if (back) {
        if (!((interrupted_ || dead_ || jog_in_hold_ || !drives_by_handwheel()) && at_rest()))
            drive_trail();
        left = 0.0;
    }
    if (at_boundary_ && !back) execute_standing(left);
    // What took a part of the tick ends within it: motion begins with the next one.
    const bool frozen = (interrupted_ || dead_ || jog_in_hold_) && at_rest();
    if (phase_ == Phase::None && left == 1.0 && !frozen && !back) {
        drive();
        if (at_boundary_) {
            if (step_.ended_to > step_.ended_from)
                left = 1.0 - planner_->end_fraction(step_.ended_to - 1);
            execute_standing(left);
        }
    }
    watch_commands();
    settle();
    watch_production();
    if (program_runs()) cycle_s_ += core_.config.tick_s;
    if (start_lamp()) lit_s_ += core_.config.tick_s;
    if (moving_) (moving_rapid_ ? rapid_s_ : cutting_s_) += core_.config.tick_s;
    if (state_ == ChannelState::Waiting) waiting_s_ += core_.config.tick_s;
    const auto& tail = core_.image.path_tail[index_].tail;
    // P4: own tail. P2: the records before cursor_ are needed no more
    if (tail.load(std::memory_order_relaxed) != cursor_)
        core_.image.path_tail[index_].tail.store(cursor_, std::memory_order_release);
}

// States that begin with the path at rest.
void ChannelRunner::settle() noexcept {
    if (!at_rest()) return;
    if (resetting_) finish_reset();
    if (interrupt_due_ && is_stopped_for_interrupt()) break_off();
    settle_hold();
    if (lines_.goes_on()) next_line();
    if (dead_ && !rest_reported_) {
        rest_reported_ = true;
        core_.waits.leave(index_);
        core_.event(KernelEventKind::Stopped, number_, static_cast<std::int32_t>(StopReason::Death),
                    0, line_);
    }
    if (interrupted_ && state_ != ChannelState::Interrupted && !dead_) {
        restart_ = RestartState::None;
        core_.waits.leave(index_);
        stand(ChannelState::Interrupted, StopReason::Alarm);
    }
    if (hold_ && !interrupted_ && state_ == ChannelState::Running && phase_ != Phase::Handshake)
        stand(ChannelState::Held, StopReason::Held);
    if (state_ == ChannelState::Running &&
        ((step_.stands == Stands::BlockEnd && (keys & kKeySingleBlock)) ||
         std::exchange(group_ended_, false)))
        stand(ChannelState::ProgramStop, StopReason::SingleBlock);
}

// What holds and slows every path of this channel.
PathInput ChannelRunner::path_input() noexcept {
    PathInput input;
    // N0313
    input.feed_override = (keys & kKeyRapid)
                              ? feed_factor() * core_.config.channels[index_].rapid_key_factor
                              : feed_factor();
    input.rapid_override = rapid_override;
    if (core_.config.channels[index_].feed_override_in_rapid)
        input.rapid_override *= std::min(feed_override, 1.0);
    input.speed_ceiling = setup_ceiling();
    // lost since it was planned
    if (cursor_ < planner_->next_record())
        input.speed_ceiling =
            std::min(input.speed_ceiling, ceiling_before_reference(record(cursor_)));
    input.spindle_rev_s = core_.spindle_rev_s.data();
    input.hold =
        (core_.signals.plc(signals::cp_stop(number_)) && !(control_ & kControlNoPlcStop)) ||
        hold_ || group_ended_ || resetting_ || dead_ || interrupted_ || core_.all_stop ||
        !core_.on() || !drives_by_handwheel() || owes_rendezvous_;
    if (emergency_) input.emergency_dec = emergency_deceleration();
    return input;
}

void ChannelRunner::drive() noexcept {
    if (!interrupted_ && state_ == ChannelState::Running && planner_->at_rest() &&
        cursor_ < planner_->next_record())
        refuse_bound(record(cursor_));
    if (flying_ != kNoRecord && planner_->next_record() > flying_) {
        const PathRecord& r = record(flying_);
        if (core_.waits.open_for(index_, r.code, r.mask, core_.no_wait(), wait_phase())) {
            planner_->let_pass(flying_);
            let_pass_ = std::exchange(flying_, kNoRecord);
        }
    }
    PathInput input = path_input();
    if (flies_unmet()) input.hold = true;
    const bool breaks_off = interrupt_due_ && !(interrupt_bits_ & kInterruptAtBlockEnd);
    const bool ends_block = interrupt_due_ && !breaks_off;
    if (skip_signal() || breaks_off) input.hold = true;
    // behind a block that is no move nothing else keeps the path
    if (state_ == ChannelState::ProgramStop && stop_reason_ == StopReason::SingleBlock)
        input.hold = true;
    input.single_block = (keys & kKeySingleBlock) != 0 || ends_block;
    input.in_position = axes_in_position();
    if (state_ == ChannelState::Running && waits_for_drive()) input.hold = true;
    if (handwheel_) {
        input.hold = input.hold || handwheel_rate_ <= 0;
        input.feed_override *= std::max(handwheel_rate_, 0.0);
        input.rapid_override *= std::max(handwheel_rate_, 0.0);
    }
    if (keys & kKeyDryRun)
        input.dry_run_feed = dry_run_feed();
    else if (awaited_spindle())
        input.speed_ceiling = 0;  // a tap too, whose override is locked
    step_ = planner_->tick(input);
    report_progress();
    if (skipping_ && planner_->at_rest()) end_skipped_move();
    // at the limit, in the middle of the record
    if (cut_.record < step_.ended_to && cut_.record >= step_.ended_from) {
        cursor_ = cut_.record;
        moving_ = true;
        at_boundary_ = false;
        return;
    }
    cursor_ = step_.over ? step_.record + 1 : step_.record;
    moving_ = step_.speed > 0 || step_.ended_to > step_.ended_from;
    // The boundary is free when nothing but the record behind it keeps the path: not in position,
    // not single block.
    at_boundary_ = step_.stands == Stands::BeforeRecord || step_.stands == Stands::NoRecord;
    if (step_.stands == Stands::NoRecord) cursor_ = planner_->next_record();
    if (step_.stands == Stands::Moving && step_.over && planner_->at_rest()) {
        const PathRecord& last = record(step_.record);
        at_boundary_ =
            !(last.flags & kInPosition) && !(input.single_block && block_ends_at(step_.record));
    }
    // the record that ended is the channel's again
    if (step_.stands == Stands::InPosition) watch_standstill(nullptr);
    if (step_.over || cursor_ >= planner_->next_record()) return;
    const PathRecord& r = record(cursor_);
    if (!is_motion(r) || (r.flags & kThread)) return;
    moving_rapid_ = (r.flags & kRapid) != 0;
    cursor_record_ = cursor_;
    if (step_.s > 0) place_axes(r, step_.s);
    begin_function_early();
    line_ = r.line;
    block_ = r.block;
    file_ = r.file;
    watch_standstill(&r);
}

// The partners of a wait have stopped after they released this channel and before it has come
// there: the path comes to rest, at the wait if that still lies ahead, else behind it
// (after_waits).
bool ChannelRunner::flies_unmet() noexcept {
    if (let_pass_ == kNoRecord) return false;
    if (cursor_ > let_pass_) {
        let_pass_ = kNoRecord;
        return false;
    }
    const PathRecord& r = record(let_pass_);
    if (core_.waits.open_for(index_, r.code, r.mask, core_.no_wait(), wait_phase())) return false;
    if (!planner_->at_rest()) return true;
    planner_->stand_before(let_pass_);
    flying_ = std::exchange(let_pass_, kNoRecord);
    return false;
}

void ChannelRunner::report_progress() noexcept {
    const double dt = core_.config.tick_s;
    const bool any_began = step_.began_to > step_.began_from,
               any_ended = step_.ended_to > step_.ended_from;
    if (!any_began && !any_ended) return;
    const std::uint64_t from = !any_began   ? step_.ended_from
                               : !any_ended ? step_.began_from
                                            : std::min(step_.began_from, step_.ended_from);
    for (std::uint64_t i = from; i < std::max(step_.began_to, step_.ended_to); ++i) {
        const PathRecord& r = record(i);
        if (i >= step_.began_from && i < step_.began_to)
            begin_record(r, planner_->begin_fraction(i) * dt);
        if (i < step_.ended_from || i >= step_.ended_to) continue;
        const double offset_s = planner_->end_fraction(i) * dt;
        cursor_record_ = i;
        if (i == cut_.record) {
            place_axes(r, cut_.s);
            line_ = r.line;
            block_ = r.block;
            file_ = r.file;
            stop_at_limit();
            continue;
        }
        if (is_motion(r))
            place_axes(r, r.length);
        else
            execute_instant(r, offset_s);
        if (writes_store(r)) --writes_ahead_;
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
        placed_.add(r.axis[i]);
        axis.rapid = (r.flags & kRapid) != 0;
        axis.tap_with(tap_gain, tap_gain > 0 && r.value != 0);
        if (!(keys & kKeyMachineLock) && !axis.bound() && !axis.beside && !axis.detached &&
            r.axis[i] != limited_axis_) {
            // lost in transit
            if (!axis.referenced && !interrupted_ && core_.must_be_referenced(r.axis[i]) &&
                std::fabs(position[i] - axis.command()) > kMoves) {
                line_ = r.line;
                block_ = r.block;
                file_ = r.file;
                raise(Alarm::AxisUnreferenced, name_of('A', r.axis[i]).view());
            }
            axis.move_to(position[i]);
        }
        last_axes_[i] = r.axis[i];
    }
    last_axis_count_ = r.axis_count;
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
        if (r.axis[i] == limited_axis_) {
            line_ = r.line;
            block_ = r.block;
            file_ = r.file;
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
            line_ = r.line;
            block_ = r.block;
            file_ = r.file;
            raise(why, name_of('A', r.axis[i]).view());
        }
}

void ChannelRunner::begin_record(const PathRecord& r, double offset_s) noexcept {
    refuse_bound(r);
    serial_ = r.serial;
    if (r.flags & kSkipMove) skipped_ = false;
    passes_stop_ = is_optional_stop(r) && !(keys & kKeyOptionalStop);
    // a step that waits for those before it
    const bool later =
        static_cast<RecordKind>(r.kind) == RecordKind::PositioningAxis && r.code != 0;
    if (!later && (!is_motion(r) || (r.flags & kBlockBegin)) && !passes_stop_)
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
    const bool passed = passes_stop_ && is_optional_stop(r);
    if (kind != RecordKind::PositioningAxis && (!is_motion(r) || (r.flags & kBlockEnd)) && !passed)
        report(KernelEventKind::RecordEnd, r, offset_s);
    if ((r.flags & kStopMustCome) && !skipped_)
        raise(Alarm::FixedStopMissed,
              r.axis_count > 0 ? name_of('A', r.axis[0]).view() : std::string_view{}, r.end[0]);
    if (r.flags & kBlockEnd) ++blocks_;
    if (ends_with_part_ && (r.flags & kDrains)) resetting_ = true;
    last_serial_ = r.serial;
    last_part_ = r.part;
    // An end can be taken back. Behind a stop that is passed the program may have been read anew,
    // so retrace cannot go back over it.
    if (!(kind == RecordKind::Stop && state_ == ChannelState::Ended) &&
        (!passed || (r.flags & kDrains)))
        trail_.add(r, r.length, meeting_);
    meeting_ = 0;
    if (r.flags & kDrains) {
        limited_axis_ = kMaxAxes;  // it takes over its axes' positions
        know_positions();
        tell(ChannelEventKind::BarrierReached, index, r.value);
    }
}

void ChannelRunner::tell(ChannelEventKind kind, std::uint64_t index, double value,
                         std::string_view text) noexcept {
    // 16 events a tick: more only by a fault of ours, and the ring holds 64
    if (outbox_count_ == outbox_.size()) return;
    ChannelEvent& event = outbox_[outbox_count_++];
    event.kind = static_cast<std::uint32_t>(kind);
    event.epoch = epoch_;
    // positions and states that the channel reads are those of the end of this tick
    event.tick = core_.tick + 1;
    event.record = index;
    event.value = value;
    copy_text(event.text, text);
}

void ChannelRunner::send_events() noexcept {
    if (!segment_) return;
    if (store_changed_) {
        store_changed_ = false;
        tell(ChannelEventKind::StoreChanged, cursor_);
    }
    bool rang = false;
    if (outbox_count_ > 0) {
        RingProducer<RingHead<ChannelEvent, 64>> ring(core_.image.events[index_],
                                                      segment_->event_tail);
        std::size_t sent = 0;
        while (sent < outbox_count_) {
            outbox_[sent].seq = events_sent_ + 1;
            if (!ring.push(outbox_[sent])) break;
            ++events_sent_;
            ++sent;
        }
        std::move(outbox_.begin() + static_cast<std::ptrdiff_t>(sent),
                  outbox_.begin() + static_cast<std::ptrdiff_t>(outbox_count_), outbox_.begin());
        outbox_count_ -= sent;
        rang = sent > 0;
    }
    if (!rang && cursor_ - rung_at_ < kWakeChunk) return;
    rung_at_ = cursor_;
    wake();
}

void ChannelRunner::publish(ChannelStatus& status) noexcept {
    status.state = static_cast<std::uint32_t>(state_);
    status.mode = static_cast<std::uint32_t>(mode_);
    status.feed_override = feed_override;
    status.rapid_override = rapid_override;
    status.path_speed = moving_ ? step_.speed : 0.0;
    const bool motion = segment_ && cursor_ < visible_end_ && is_motion(record(cursor_));
    status.path_left =
        motion ? record(cursor_).length - (step_.record == cursor_ && !step_.over ? step_.s : 0.0)
               : 0.0;
    status.record = cursor_;
    status.line = line_;
    status.file = file_;
    status.block = block_;
    core_.tools.publish(index_, status);
    const auto& arrival = core_.waits.at(index_);
    status.wait_code = arrival.here ? arrival.code : 0;
    status.wait_set = arrival.here ? arrival.set : 0;
    status.wait_missing = arrival.here ? core_.waits.missing(index_, core_.no_wait()) : 0;
    status.wait_since = arrival.here ? wait_since_ : 0;
    status.parts = parts_;
    status.cutting_s = cutting_s_;
    status.rapid_s = rapid_s_;
    status.waiting_s = waiting_s_;
    status.cycle_s = cycle_s_;
    status.blocks = blocks_;
    status.epoch = epoch_;
    status.stop_reason = static_cast<std::int32_t>(stop_reason_);
    // Counted by command, not by key: the first and the last end by themselves, the PLC may set the
    // second one.
    status.keys = keys | (stop_after_part_ ? kKeyStopAfterPart : 0u) |
                  (core_.signals.plc(signals::cp_nowt(number_)) ? kKeyIgnoreWaits : 0u) |
                  (retrace_ < 0 ? kKeyRetrace : 0u);
    // of the selected program, in MDI too
    status.speaks = static_cast<std::uint32_t>(job_language_ != Dialect::Polyturn
                                                   ? job_language_
                                                   : core_.config.channels[index_].language);
    status.skipped = skipped_ ? 1 : 0;
    status.retrace = trail_.active() ? (trail_.direction() < 0 ? -1 : 1) : 0;
    status.wheel = handwheel_ ? 1 : 0;
    status.start_missing = start_missing_;
    status.broken_off = broken_off_;
    status.cycles = cycles_;
    status.last_cycle_s = last_cycle_s_;
    status.mean_cycle_s = cycles_ ? cycles_s_ / cycles_ : 0.0;
    status.lit_s = lit_s_;
    status.restart = static_cast<std::uint32_t>(restart_);
    status.mdi_waiting = lines_.waiting();
    status.by_hand = by_hand() ? 1 : 0;
    lines_.publish(core_.image.mdi[index_]);
    core_.signals.set_nc(signals::cn_state(number_), static_cast<std::int32_t>(state_));
    core_.signals.set_nc(signals::cn_run(number_),
                         state_ == ChannelState::Running || state_ == ChannelState::Waiting);
    core_.signals.set_nc(signals::cn_hold(number_), hold_);
    core_.signals.set_nc(signals::stl(number_), start_lamp());
    core_.signals.set_nc(signals::den(number_), distribution_ended());
    core_.signals.set_nc(signals::cn_wtng(number_), arrival.here);
    core_.signals.set_nc(signals::cn_alarm(number_), alarm_);
    core_.signals.set_nc(signals::cn_reset(number_), resets_);
    core_.signals.set_nc(signals::cn_end(number_), state_ == ChannelState::Ended);
}

bool ChannelRunner::polls() const noexcept {
    return (control_ & kControlPolls) && segment_ && state_ == ChannelState::Running &&
           phase_ == Phase::None && cursor_ + 1 == inbox_.head(cursor_) &&
           inbox_.kind_of(cursor_) == RecordKind::Barrier;
}

bool ChannelRunner::can_go_on() const noexcept {
    if (!segment_) return false;
    if (planner_ && !at_rest()) return true;
    if (resetting_ || outbox_count_ > 0 || question_) return true;
    if (stopped_ && !dead_) return true;  // the timeout counts
    if (handwheel_ && handwheel_rate_ == 0) return phase_ == Phase::Handshake;
    if (trail_.active()) return state_ == ChannelState::Running || handwheel_;
    if (state_ == ChannelState::Waiting)
        return core_.config.channels[index_].wait_timeout_s > 0 && !interrupted_;
    if (state_ == ChannelState::Ended && lines_.goes_on()) return true;
    if (state_ != ChannelState::Running) return phase_ == Phase::Handshake;
    // a drive may never find it
    if (phase_ == Phase::Home)
        return static_cast<double>(core_.tick - phase_since_) * core_.config.tick_s < 600.0;
    if (positioning_program_.now()) return true;
    if (phase_ != Phase::None) return true;
    if (step_.stands == Stands::NoFeed) return feed_override > 0;  // a spindle may come up to speed
    if (polls()) return false;
    // The ring itself, not what the last tick saw of it: a wait that has just opened is followed by
    // records pushed since.
    return cursor_ < inbox_.head(cursor_) || step_.stands == Stands::Moving;
}

std::string_view ChannelRunner::program() noexcept {
    if (!segment_ || !segment_->programs.read(*names_)) return {};
    const std::size_t at = std::min<std::size_t>(file_, 31) * 256;
    const std::string_view path(&names_->name[at], ::strnlen(&names_->name[at], 255));
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

}  // namespace polyturn::kernel
