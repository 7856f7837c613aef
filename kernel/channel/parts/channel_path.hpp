// A channel's place in its ring, and the plan of what is visible of it.
//
//   ring   ... | done | running | planned ...      | seen, not planned | not to be used this tick |
//              tail ^ (published)   planner.next_record() ^      visible_end ^           head ^
#pragma once
#include <cstdint>
#include <memory>

#include "kernel/motion/path_planner.hpp"
#include "kernel/protection/stroke_guard.hpp"
#include "kernel/records/record_inbox.hpp"

namespace polyturn::kernel {

inline constexpr std::uint64_t kNoRecord = ~0ull;

struct ChannelPath {
    // The record that leads out of the travel limits, how far along it the path may go, and why;
    // judged when it is planned.
    struct Cut {
        std::uint64_t record = kNoRecord;
        double s = 0;
        StrokeFault fault;
        std::uint64_t version = 0;  // of the limits that it was judged by
        // of the channel's axes at the end of what is planned
        StrokeGuard::Places places{};
        bool places_known = false;
    };

    RecordInbox inbox;  // nothing else reads records of the segment
    std::unique_ptr<PathPlanner> planner;
    std::uint32_t epoch = 0;
    // running record, or the one before which the path is stopped
    std::uint64_t cursor = 0;
    // limit: end of what a dead or stopped process had announced
    std::uint64_t visible_end = 0, limit = ~0ull;
    bool at_boundary = true;             // at standstill, and the record at cursor may begin
    bool moving = false, rapid = false;  // in this tick
    PathStep step{};                     // what the planner did in this tick
    std::uint64_t flying = kNoRecord;    // nearest flying wait that still stops the path
    // the one that does not, because its partners are there, and that the path has not come to yet
    std::uint64_t let_pass = kNoRecord;
    Cut cut;
    std::uint32_t writes_ahead = 0;     // records that are planned and will write to the store
    std::uint64_t superposed_from = 0;  // records from this one on leave limits for the handwheel
    std::uint64_t overlays = 0;         // axes that it moves just now

    const PathRecord& record(std::uint64_t index) const noexcept { return inbox.record(index); }
    const PathRecord& here() const noexcept { return record(cursor); }
    // Within the record at the cursor.
    bool within() const noexcept { return !step.over && step.s > 0 && step.record == cursor; }
    void plan_anew(std::uint64_t from) noexcept {
        planner->clear(from);
        writes_ahead = 0;
    }
    // Behind what was discarded, at standstill.
    void stand_here() noexcept {
        step = {};
        step.record = cursor;
        flying = let_pass = kNoRecord;
        at_boundary = true;
    }
    // Nothing of what the ring holds is wanted any more.
    void begin_behind_all() noexcept {
        inbox.look(cursor);
        cursor = inbox.head(cursor);
        inbox.begin_at(cursor);
        plan_anew(cursor);
    }
};

}  // namespace polyturn::kernel
