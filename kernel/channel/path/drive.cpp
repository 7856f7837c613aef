#include "kernel/channel/path/drive.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipc/image/interrupt_inputs.hpp"
#include "kernel/channel/path/early_function.hpp"
#include "kernel/channel/path/place_axes.hpp"
#include "kernel/channel/path/retrace_drive.hpp"
#include "kernel/channel/path/skip_move.hpp"
#include "kernel/channel/path/standstill.hpp"
#include "kernel/channel/path/supply.hpp"
#include "kernel/channel/program/wait_place.hpp"
#include "kernel/records/record_executor.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {
namespace {

// The partners of a wait have stopped after they released this channel and before it has come
// there: the path comes to rest, at the wait if that still lies ahead, else behind it
// (after_waits).
bool flies_unmet(Channel& c) noexcept {
    ChannelPath& path = c.path;
    if (path.let_pass == kNoRecord) return false;
    if (path.cursor > path.let_pass) {
        path.let_pass = kNoRecord;
        return false;
    }
    const PathRecord& r = c.record(path.let_pass);
    if (c.core.waits.open_for(c.index, r.code, r.mask, c.core.no_wait(), wait_phase(c)))
        return false;
    if (!path.planner->at_rest()) return true;
    path.planner->stand_before(path.let_pass);
    path.flying = std::exchange(path.let_pass, kNoRecord);
    return false;
}

void report_progress(Channel& c) noexcept {
    ChannelPath& path = c.path;
    const double dt = c.core.config.tick_s;
    const bool any_began = path.step.began_to > path.step.began_from,
               any_ended = path.step.ended_to > path.step.ended_from;
    if (!any_began && !any_ended) return;
    const std::uint64_t from = !any_began   ? path.step.ended_from
                               : !any_ended ? path.step.began_from
                                            : std::min(path.step.began_from, path.step.ended_from);
    for (std::uint64_t i = from; i < std::max(path.step.began_to, path.step.ended_to); ++i) {
        const PathRecord& r = c.record(i);
        if (i >= path.step.began_from && i < path.step.began_to)
            begin_record(c, r, path.planner->begin_fraction(i) * dt);
        if (i < path.step.ended_from || i >= path.step.ended_to) continue;
        const double offset_s = path.planner->end_fraction(i) * dt;
        c.axes.record = i;
        if (i == path.cut.record) {
            place_axes(c, r, path.cut.s);
            c.shown.show(r);
            stop_at_limit(c);
            continue;
        }
        if (is_motion(r))
            place_axes(c, r, r.length);
        else
            execute_instant(c, r, offset_s);
        if (writes_store(r)) --path.writes_ahead;
        end_record(c, r, i, offset_s);
    }
}

// In dry run a path feed moves as fast as N0305 lets the axes of the channel go; the limits of
// the records still hold.
double dry_run_feed(const Core& core, std::uint32_t number) noexcept {
    double feed = 0;
    for (std::uint32_t a = 0; a < core.config.axis_count; ++a)
        if (core.config.axes[a].channel == number && !core.config.axes[a].rotary)
            feed = std::max(feed, core.config.axes[a].max_feed);
    return feed;
}

// Setup mode: no axis of the path is faster than its PT_SETUP_FEED.
double setup_ceiling(const Channel& c) noexcept {
    double ceiling = kUnlimited;
    if (!c.core.signals.plc(signals::cp_setup(c.number))) return ceiling;
    for (std::uint32_t a = 0; a < c.core.config.axis_count; ++a) {
        const AxisConfig& axis = c.core.config.axes[a];
        if (axis.exists && axis.channel == c.number && !axis.rotary)
            ceiling = std::min(ceiling, axis.setup_feed);
    }
    // Turning axes have their own share of the running record.
    if (c.path.cursor < c.path.planner->next_record()) {
        const PathRecord& r = c.path.here();
        for (std::uint32_t i = 0; is_motion(r) && i < r.axis_count; ++i) {
            if (r.axis[i] >= kMaxAxes || !c.core.config.axes[r.axis[i]].rotary) continue;
            const double way = std::fabs(r.end[i] - r.start[i]);
            if (way > 0)
                ceiling =
                    std::min(ceiling, c.core.config.axes[r.axis[i]].setup_feed * r.length / way);
        }
    }
    return ceiling;
}

}  // namespace

void drive_path(Channel& c) noexcept {
    ChannelPath& path = c.path;
    if (!c.program.interrupted() && c.program.is(ChannelState::Running) &&
        path.planner->at_rest() && path.cursor < path.planner->next_record())
        refuse_bound(c, path.here());
    if (path.flying != kNoRecord && path.planner->next_record() > path.flying) {
        const PathRecord& r = c.record(path.flying);
        if (c.core.waits.open_for(c.index, r.code, r.mask, c.core.no_wait(), wait_phase(c))) {
            path.planner->let_pass(path.flying);
            path.let_pass = std::exchange(path.flying, kNoRecord);
        }
    }
    PathInput input = path_input(c);
    if (flies_unmet(c)) input.hold = true;
    const bool breaks_off = c.interrupts.due && !(c.interrupts.bits & kInterruptAtBlockEnd);
    const bool ends_block = c.interrupts.due && !breaks_off;
    if (skip_signal(c) || breaks_off) input.hold = true;
    // behind a block that is no move nothing else keeps the path
    if (c.program.stopped_by(StopReason::SingleBlock)) input.hold = true;
    input.single_block = c.panel.has(kKeySingleBlock) || ends_block;
    input.in_position = axes_in_position(c);
    if (c.program.is(ChannelState::Running) && waits_for_drive(c)) input.hold = true;
    if (c.retrace.wheel.on) {
        input.hold = input.hold || c.retrace.wheel.rate <= 0;
        input.feed_override *= std::max(c.retrace.wheel.rate, 0.0);
        input.rapid_override *= std::max(c.retrace.wheel.rate, 0.0);
    }
    if (c.panel.has(kKeyDryRun))
        input.dry_run_feed = dry_run_feed(c.core, c.number);
    else if (awaited_spindle(c))
        input.speed_ceiling = 0;  // a tap too, whose override is locked
    path.step = path.planner->tick(input);
    report_progress(c);
    if (c.standing.skip.ending && path.planner->at_rest()) end_skipped_move(c);
    // at the limit, in the middle of the record
    if (path.cut.record < path.step.ended_to && path.cut.record >= path.step.ended_from) {
        path.cursor = path.cut.record;
        path.moving = true;
        path.at_boundary = false;
        return;
    }
    path.cursor = path.step.over ? path.step.record + 1 : path.step.record;
    path.moving = path.step.speed > 0 || path.step.ended_to > path.step.ended_from;
    // The boundary is free when nothing but the record behind it keeps the path: not in position,
    // not single block.
    path.at_boundary =
        path.step.stands == Stands::BeforeRecord || path.step.stands == Stands::NoRecord;
    if (path.step.stands == Stands::NoRecord) path.cursor = path.planner->next_record();
    if (path.step.stands == Stands::Moving && path.step.over && path.planner->at_rest()) {
        const PathRecord& last = c.record(path.step.record);
        path.at_boundary = !(last.flags & kInPosition) &&
                           !(input.single_block && block_ends_at(c, path.step.record));
    }
    // the record that ended is the channel's again
    if (path.step.stands == Stands::InPosition) watch_standstill(c, nullptr);
    if (path.step.over || path.cursor >= path.planner->next_record()) return;
    const PathRecord& r = path.here();
    if (!is_motion(r) || (r.flags & kThread)) return;
    path.rapid = (r.flags & kRapid) != 0;
    c.axes.record = path.cursor;
    if (path.step.s > 0) place_axes(c, r, path.step.s);
    begin_function_early(c);
    c.shown.show(r);
    watch_standstill(c, &r);
}

PathInput path_input(Channel& c) noexcept {
    PathInput input;
    // N0313
    input.feed_override = c.panel.has(kKeyRapid)
                              ? c.feed_factor() * c.core.config.channels[c.index].rapid_key_factor
                              : c.feed_factor();
    input.rapid_override = c.panel.rapid_override;
    if (c.core.config.channels[c.index].feed_override_in_rapid)
        input.rapid_override *= std::min(c.panel.feed_override, 1.0);
    input.speed_ceiling = setup_ceiling(c);
    // lost since it was planned
    if (c.path.cursor < c.path.planner->next_record())
        input.speed_ceiling =
            std::min(input.speed_ceiling, ceiling_before_reference(c.core, c.path.here()));
    input.spindle_rev_s = c.core.spindle_rev_s.data();
    input.hold =
        (c.core.signals.plc(signals::cp_stop(c.number)) &&
         !(c.program.control & kControlNoPlcStop)) ||
        c.program.brakes.any_of(Brake::Hold, Brake::GroupEnd, Brake::Reset, Brake::Alarm) ||
        c.process.dead() || c.core.all_stop || !c.core.on() || !drives_by_handwheel(c) ||
        c.standing.wait.owed;
    if (c.program.emergency()) input.emergency_dec = emergency_deceleration(c.core, c.number);
    return input;
}

double emergency_deceleration(const Core& core, std::uint32_t number) noexcept {
    double least = kUnlimited;
    for (std::uint32_t a = 0; a < core.config.axis_count; ++a)
        if (core.axes[a].owner == number)
            least = std::min(least, core.config.axes[a].estop_deceleration);
    return least < kUnlimited ? least : 1e4;
}

double ceiling_before_reference(const Core& core, const PathRecord& r) noexcept {
    double ceiling = kUnlimited;
    if (!core.some_slow || !is_motion(r)) return ceiling;
    const auto kind = static_cast<RecordKind>(r.kind);
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        if (r.axis[i] >= kMaxAxes || !core.is_slow(r.axis[i])) continue;
        const double way = std::fabs(r.end[i] - r.start[i]),
                     most = core.config.axes[r.axis[i]].reference.rapid;
        const bool in_plane = kind == RecordKind::Arc && (r.plane[0] == i || r.plane[1] == i);
        if (kind == RecordKind::Line && r.transform == 0)
            ceiling = way > 0 ? std::min(ceiling, most * r.length / way) : ceiling;
        else if (way > 0 || in_plane || r.transform != 0)
            ceiling = std::min(ceiling, most);
    }
    return ceiling;
}

}  // namespace polyturn::kernel
