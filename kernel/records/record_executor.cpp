#include "kernel/records/record_executor.hpp"

#include <array>
#include <type_traits>

#include "ipc/image/interrupt_inputs.hpp"
#include "kernel/channel/path/place_axes.hpp"
#include "kernel/channel/path/skip_move.hpp"
#include "kernel/channel/path/standstill.hpp"
#include "kernel/channel/path/supply.hpp"
#include "kernel/channel/path/thread_run.hpp"
#include "kernel/channel/program/production.hpp"
#include "kernel/records/aux_records.hpp"
#include "kernel/records/axis_records.hpp"
#include "kernel/records/program_records.hpp"
#include "kernel/records/record_kinds.hpp"
#include "kernel/records/spindle_records.hpp"
#include "kernel/records/store_records.hpp"

namespace polyturn::kernel {
namespace {

// bounds the work of a tick; more stationary records go on with the next one
constexpr int kStandingPerTick = 64;

// What a record does. standing: at standstill; true: it is done, and `left` of the tick remains.
// instant: between two moves.
using Standing = bool (*)(Channel& c, const PathRecord& r, double& left) noexcept;
using Instant = void (*)(Channel& c, const PathRecord& r, double offset_s) noexcept;
struct RecordRow {
    RecordKind kind;
    Standing standing;  // nullptr: its kind never holds the path
    Instant instant;    // nullptr: there is nothing to do
};

// Handlers take what they need of it.
template <auto kHandler>
bool standing(Channel& c, const PathRecord& r, double& left) noexcept {
    if constexpr (std::is_invocable_v<decltype(kHandler), Channel&, const PathRecord&, double&>)
        return kHandler(c, r, left);
    else
        return kHandler(c, r);
}
template <auto kHandler>
void instant(Channel& c, const PathRecord& r, double offset_s) noexcept {
    if constexpr (std::is_invocable_v<decltype(kHandler), Channel&, const PathRecord&, double>)
        kHandler(c, r, offset_s);
    else
        (void)kHandler(c, r);
}
// The channel is told by end_record().
bool barrier(Channel&, const PathRecord&) noexcept { return true; }
// The end of a group of blocks: single block stops behind it.
bool standing_flag(Channel& c, const PathRecord& r) noexcept {
    set_flag(c, r);
    return true;
}
void part(Channel& c, const PathRecord&) noexcept { part_made(c); }

constexpr auto kRecordRows = std::to_array<RecordRow>({
    {RecordKind::None, nullptr, nullptr},
    // motion: by the planner, threads by thread_run
    {RecordKind::Line, nullptr, nullptr},
    {RecordKind::Arc, nullptr, nullptr},
    {RecordKind::Curve, nullptr, nullptr},
    {RecordKind::Dwell, standing<dwell>, nullptr},
    {RecordKind::Aux, standing<give_function>, nullptr},
    {RecordKind::SpindleMode, standing<standing_spindle_record>, instant<spindle_record>},
    {RecordKind::SpindleSpeed, nullptr, instant<spindle_record>},
    {RecordKind::Wait, standing<arrive_at_wait>, instant<flying_wait>},
    {RecordKind::Barrier, standing<barrier>, nullptr},
    {RecordKind::Variable, nullptr, instant<variable_or_offset>},
    {RecordKind::Offset, nullptr, instant<variable_or_offset>},
    {RecordKind::Message, nullptr, instant<message_record>},
    {RecordKind::Stop, standing<stop_program>, nullptr},
    {RecordKind::Part, nullptr, instant<part>},
    {RecordKind::Interrupts, nullptr, instant<interrupts_record>},
    {RecordKind::Marker, nullptr, instant<marker_record>},
    {RecordKind::Flag, standing<standing_flag>, instant<set_flag>},
    {RecordKind::PositioningAxis, standing<begin_positioning>, instant<begin_positioning>},
    {RecordKind::Await, standing<await_axes>, nullptr},
    {RecordKind::Torque, standing<limit_torque>, nullptr},
    {RecordKind::Home, standing<find_reference>, nullptr},
    {RecordKind::ToolData, nullptr, instant<tool_data>},
    {RecordKind::Parameter, standing<parameter_record>, nullptr},
    {RecordKind::LifeGroup, nullptr, instant<life_group>},
});
constexpr bool rows_fit() noexcept {
    for (std::size_t i = 0; i < kRecordRows.size(); ++i) {
        const RecordRow& row = kRecordRows[i];
        if (static_cast<std::size_t>(row.kind) != i) return false;
        if (i == 0) continue;  // RecordKind::None: of nothing
        const When when = when_of(row.kind);
        if ((when == When::Standing || when == When::ByContents) && !row.standing) return false;
        if ((when == When::Instant || when == When::ByContents) && !row.instant) return false;
    }
    return kRecordRows.size() == kRecordKinds;
}
static_assert(rows_fit(), "each kind has its row, and a handler for when it acts");

// True: done, the next one may begin.
bool execute_at_standstill(Channel& c, const PathRecord& r, double& left) noexcept {
    const Standing handler = r.kind < kRecordRows.size() ? kRecordRows[r.kind].standing : nullptr;
    if (handler) return handler(c, r, left);
    c.raise(Alarm::RecordInvalid, "unknown kind");
    return false;
}

// First-part mode: the operator looks at each tool before it comes.
bool stops_for_tool(Channel& c, const PathRecord& r) noexcept {
    if (!c.panel.has(kKeyFirstPart) || c.restart.searches() ||
        static_cast<RecordKind>(r.kind) != RecordKind::Aux || r.code != 'T' ||
        c.standing.tool_shown == c.path.cursor)
        return false;
    c.standing.tool_shown = c.path.cursor;
    c.shown.line = r.line;
    c.stand(ChannelState::ProgramStop, StopReason::FirstPart);
    return true;
}

}  // namespace

void execute_standing(Channel& c, double& left) noexcept {
    for (int i = 0; i < kStandingPerTick; ++i) {
        if (c.path.cursor >= c.path.planner->next_record()) return;
        const PathRecord& r = c.path.here();
        if (!stops_path(r) && !(c.path.cursor == c.path.cut.record && c.path.cut.s < kOnLimit))
            return;
        if (!c.standing.begun) {
            // A new step needs a running program; one that has begun is brought to its end in a
            // hold too.
            if (!c.program.is(ChannelState::Running) || c.program.holds() ||
                c.program.interrupted() || c.program.resets() || c.process.dead() ||
                c.core.all_stop)
                return;
            if (c.retrace.wheel.holds() || stops_for_tool(c, r) || c.standing.wait.owed) return;
            if (c.interrupts.due &&
                (!(c.interrupts.bits & kInterruptAtBlockEnd) || r.serial != c.shown.ended_serial))
                return;
            c.shown.show(r);
            c.standing.begun = true;
            c.standing.since = c.core.tick;
            if (!is_motion(r) && c.standing.handshake.early != c.path.cursor)
                begin_record(c, r, (1.0 - left) * c.core.config.tick_s);
        }
        // nothing of it may be driven, or it is a thread, which cannot stop within
        if (c.path.cursor == c.path.cut.record) {
            if (c.program.interrupted()) return;
            begin_record(c, r, (1.0 - left) * c.core.config.tick_s);
            stop_at_limit(c);
            return;
        }
        if (is_motion(r)) {
            if (!drive_thread(c, left)) return;
            continue;
        }
        if (!execute_at_standstill(c, r, left)) return;
        const auto kind = static_cast<RecordKind>(r.kind);
        if ((r.flags & kDrains) && (kind == RecordKind::Aux || kind == RecordKind::Barrier) &&
            (drive_is_coming(c.core, c.number) || leaves_stop(c.core, c.number)))
            return;
        const std::uint64_t index = c.path.cursor++;
        c.path.planner->skip(c.path.cursor);
        c.standing.begun = false;
        c.standing.phase = RecordPhase::None;
        c.path.at_boundary = true;
        end_record(c, r, index, (1.0 - left) * c.core.config.tick_s);
        // a search moves nothing
        if (c.panel.has(kKeySingleBlock) && block_ends_at(c, index) &&
            c.program.is(ChannelState::Running) && !c.restart.searches()) {
            c.stand(ChannelState::ProgramStop, StopReason::SingleBlock);
            return;
        }
    }
}

void begin_record(Channel& c, const PathRecord& r, double offset_s) noexcept {
    refuse_bound(c, r);
    c.shown.serial = r.serial;
    if (r.flags & kSkipMove) c.standing.skip.came = false;
    c.standing.passes_stop = is_optional_stop(r) && !c.panel.has(kKeyOptionalStop);
    // a step that waits for those before it
    const bool later =
        static_cast<RecordKind>(r.kind) == RecordKind::PositioningAxis && r.code != 0;
    if (!later && (!is_motion(r) || (r.flags & kBlockBegin)) && !c.standing.passes_stop)
        c.report(KernelEventKind::RecordBegin, r, offset_s);
}

void end_record(Channel& c, const PathRecord& r, std::uint64_t index, double offset_s) noexcept {
    const auto kind = static_cast<RecordKind>(r.kind);
    // what follows may be needed: an M code that removes another limit
    if (r.flags & kFixedStop) allow_torque(c, nullptr);
    const bool passed = c.standing.passes_stop && is_optional_stop(r);
    if (kind != RecordKind::PositioningAxis && (!is_motion(r) || (r.flags & kBlockEnd)) && !passed)
        c.report(KernelEventKind::RecordEnd, r, offset_s);
    if ((r.flags & kStopMustCome) && !c.standing.skip.came)
        c.raise(Alarm::FixedStopMissed,
                r.axis_count > 0 ? name_of('A', r.axis[0]).view() : std::string_view{}, r.end[0]);
    if (r.flags & kBlockEnd) ++c.production.blocks;
    if (c.production.ends_with_part && (r.flags & kDrains)) c.program.brake_for(Brake::Reset);
    c.shown.ended(r.serial, r.part);
    // An end can be taken back. Behind a stop that is passed the program may have been read anew,
    // so retrace cannot go back over it.
    if (!(kind == RecordKind::Stop && c.program.is(ChannelState::Ended)) &&
        (!passed || (r.flags & kDrains)))
        c.retrace.trail.add(r, r.length, c.retrace.meeting);
    c.retrace.meeting = 0;
    if (r.flags & kDrains) {
        c.axes.limited = kMaxAxes;  // it takes over its axes' positions
        know_positions(c.core, c.number);
        c.tell(ChannelEventKind::BarrierReached, index, r.value);
    }
}

void execute_instant(Channel& c, const PathRecord& r, double offset_s) noexcept {
    const Instant handler = r.kind < kRecordRows.size() ? kRecordRows[r.kind].instant : nullptr;
    if (handler) handler(c, r, offset_s);
}

}  // namespace polyturn::kernel
