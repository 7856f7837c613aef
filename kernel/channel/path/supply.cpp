#include "kernel/channel/path/supply.hpp"

#include <algorithm>

#include "ipc/image/compensated_flag.hpp"
#include "ipc/image/interrupt_inputs.hpp"
#include "kernel/channel/path/drive.hpp"
#include "kernel/channel/path/place_axes.hpp"
#include "kernel/channel/program/interrupt.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {
namespace {

// Limits that have changed act on what is planned as soon as the path rests; until then the axes
// are braked where they must.
void judge_stroke_anew(Channel& c) noexcept {
    ChannelPath& path = c.path;
    if (!path.cut.places_known || path.cut.version != c.core.stroke.version(c.index)) {
        if (!c.at_rest() || !path.at_boundary) return;
        path.plan_anew(path.cursor);
        path.flying = path.let_pass = kNoRecord;
        path.cut.record = kNoRecord;
        path.cut.version = c.core.stroke.version(c.index);
    } else if (path.planner->next_record() != path.cursor || !c.at_rest()) {
        return;
    }
    // nothing is planned: the axes are at standstill
    c.core.stroke.places_now(c.core, c.index, path.cut.places);
    path.cut.places_known = true;
    if (path.planner->next_record() == path.cursor && path.cut.record < path.cursor)
        path.cut.record = kNoRecord;
}

bool ends_at_limit(Channel& c, const PathRecord& r) noexcept {
    ChannelPath& path = c.path;
    StrokeFault fault;
    const double s = c.core.stroke.exit_of(c.index, r, c.kinematics_of(r), path.cut.places, fault);
    if (!(s < r.length) || path.cut.record != kNoRecord) return false;
    path.cut.record = path.planner->next_record();
    path.cut.s = s;
    path.cut.fault = fault;
    return true;
}

// What is copied and judged; the path sees no more than that.
void take_records(Channel& c) noexcept {
    ChannelPath& path = c.path;
    if (path.inbox.taken() < path.limit || path.inbox.taken() < path.cursor)
        path.inbox.take(path.cursor, path.limit, path.epoch, c.core, c.index);
    if (path.inbox.kinematics_changed()) c.retrace.forget_driven();
    const std::uint64_t end = std::min(path.limit, path.inbox.taken());
    path.visible_end = end;
    if (c.core.config.channels[c.index].reads_one_block_ahead)
        path.visible_end = end_of_few_blocks(c, end);
}

}  // namespace

void supply_path(Channel& c) noexcept {
    ChannelPath& path = c.path;
    take_keys(c);  // the rapid key is for jogging too, which needs no process
    if (!c.process.segment) return;
    drop_old_epochs(c, RecordInbox::kSkipsPerTick);
    if (c.process.listens())
        path.limit = std::min(path.inbox.head(path.cursor), path.cursor + c.core.config.horizon);
    take_records(c);
    judge_stroke_anew(c);
    while (path.planner->wants_record() && path.planner->next_record() < path.visible_end) {
        const PathRecord& r = c.record(path.planner->next_record());
        // pushed after a reset of which the path has not come to rest yet
        if (r.epoch != path.epoch) break;
        if (r.flags & kAtOnce) break;  // obey_ahead() does it; the path breaks off before
        // A flying record cannot wait when its turn comes. So it is not planned before the store's
        // ring has room for it: the path comes to rest in front of it until the store has caught
        // up.
        if (writes_store(r)) {
            if (path.writes_ahead == StoreLink::kWritesAhead || !c.core.store.has_room()) break;
            ++path.writes_ahead;
        }
        const bool flying =
            static_cast<RecordKind>(r.kind) == RecordKind::Wait && (r.flags & kFlying);
        if (flying && path.flying == kNoRecord) path.flying = path.planner->next_record();
        PlannedRecord planned = PlannedRecord::from(r, stops_path(r));
        planned.block_end = block_ends_at(c, path.planner->next_record());
        if (r.flags & kTapping) limit_tapping(c.core, r, planned);
        if (is_motion(r) && ends_at_limit(c, r)) {
            planned.length = path.cut.s;
            planned.stop_after = true;
            planned.stop_before = planned.stop_before || path.cut.s < kOnLimit;
        }
        planned.v_max = std::min(planned.v_max, ceiling_before_reference(c.core, r));
        if (c.panel.superposes() || path.overlays) {
            planned.v_max *= 1 - OperatorPanel::kOverlayShare;
            planned.a_max *= 1 - OperatorPanel::kOverlayShare;
            planned.j_max *= 1 - OperatorPanel::kOverlayShare;
        }
        path.planner->append(planned);
    }
}

void take_keys(Channel& c) noexcept {
    // Machine lock changes only while no program runs: a moving axis that is locked would stop, one
    // that is unlocked away from its path would jump.
    const std::uint32_t lock = c.program.runs() || c.path.moving
                                   ? c.panel.keys & kKeyMachineLock
                                   : c.panel.pressed & kKeyMachineLock;
    c.panel.keys = (c.panel.pressed & ~static_cast<std::uint32_t>(kKeyMachineLock)) | lock;
    const auto mark = [&](PlcSignal signal, std::uint32_t bit) {
        if (c.core.signals.plc(signal(c.number))) c.panel.keys |= bit;
    };
    mark(signals::blkskip1, kKeyBlockSkip1);
    mark(signals::blkskip2, kKeyBlockSkip1 << 1);
    mark(signals::blkskip3, kKeyBlockSkip1 << 2);
    mark(signals::m01stop, kKeyOptionalStop);
    mark(signals::m5008, kKeySingleBlock);
    mark(signals::cp_rapidkey, kKeyRapid);
    if (c.program.control & kControlNoSingleBlock)
        c.panel.keys &= ~static_cast<std::uint32_t>(kKeySingleBlock);
}

bool block_ends_at(const Channel& c, std::uint64_t index) noexcept {
    const PathRecord& r = c.record(index);
    if (!(r.flags & kBlockEnd) || (!is_motion(r) && (r.flags & kMoreBehind)) ||
        static_cast<RecordKind>(r.kind) == RecordKind::Flag)
        return false;
    if (index + 1 >= c.path.visible_end) return true;
    const PathRecord& next = c.record(index + 1);
    return next.serial != r.serial || next.serial == 0 || next.epoch != r.epoch ||
           (is_motion(r) && is_motion(next));
}

void drop_old_epochs(Channel& c, std::uint64_t most) noexcept {
    ChannelPath& path = c.path;
    path.inbox.look(path.cursor);
    if (!path.planner || path.planner->next_record() != path.cursor || !path.planner->at_rest())
        return;
    const auto head = path.inbox.head(path.cursor), from = path.cursor;
    while (path.cursor < head && path.cursor - from < most &&
           path.inbox.epoch_of(path.cursor) != path.epoch)
        ++path.cursor;
    if (path.cursor == from) return;
    path.inbox.begin_at(path.cursor);
    path.plan_anew(path.cursor);
    // P2: the records before the cursor are needed no more
    c.core.image.path_tail[c.index].tail.store(path.cursor, std::memory_order_release);
}

void stop_at_limit(Channel& c) noexcept {
    c.raise(Alarm::StrokeLimit,
            name_of('A', c.core.stroke.axis_of(c.index, c.path.cut.fault.axis)).view(),
            c.path.cut.fault.limit);
}

std::uint64_t end_of_few_blocks(const Channel& c, std::uint64_t most) noexcept {
    std::uint64_t end = c.path.cursor;
    unsigned left = c.path.cursor < most && (c.path.here().flags & kCompensated) ? 4 : 2;
    for (; end < most && left > 0; ++end) {
        const std::uint32_t flags = c.record(end).flags;
        if ((flags & kBlockEnd) && !((flags & kThread) && !(flags & kThreadEnd))) --left;
    }
    return end;
}

}  // namespace polyturn::kernel
