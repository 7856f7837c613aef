// The retrace memory: the last executed records of a channel (PT_HISTORY), driven backwards and
// forwards again by a planner of its own (architecture 5.7). The channel's own planner keeps its
// position meanwhile.
//
//   begin_                                   end_
//     | r0 | r1 | wall | r3 | wait | r5 | ... | the part of the running record that is driven |
//                        <---- at_, s_ ---->                                    left here ^
//
// A wall is what cannot be retraced: a thread, a tap, a skip move, an M, S, T or positioned
// spindle, a barrier. Retrace ends there. A wait is a barrier too; a handwheel that is the time
// base of the programs passes it when all its channels do (last_meeting).
//
// Invariants
//   I1  a place is (at_, s_) with 0 <= s_ < length of the entry at_; with s_ 0 it is the gap
//   between at_ - 1 and at_. The entry
//       end_ is the driven part of the running record, if there is one; behind it is the place that
//       was left.
//   I2  Nothing here allocates behind prepare().
#pragma once
#include <memory>
#include <vector>

#include "ipc/path/path_geometry.hpp"
#include "kernel/motion/path_planner.hpp"

namespace polyturn::kernel {

class Trail {
public:
    // Capacity in records; not in the cyclic thread.
    void prepare(std::size_t records);
    void configure(double tick_s, std::uint32_t horizon) noexcept;
    void clear() noexcept;
    // Executed: all of it, or up to `length` where the rest was discarded. `meeting` of a wait:
    // which release ended it.
    void add(const PathRecord& record, double length, std::uint64_t meeting) noexcept;
    // the newest wait, a flying one, met its partners now
    void met(std::uint64_t meeting) noexcept;

    // The path leaves the place where it rests: `record` driven up to `s`; nullptr: nothing of one.
    void enter(const PathRecord* record, double s) noexcept;
    void leave() noexcept { active_ = false; }
    bool ready() const noexcept { return planner_ && !ring_.empty(); }
    bool active() const noexcept { return active_; }
    bool at_rest() const noexcept { return !active_ || planner_->at_rest(); }
    bool at_end() const noexcept { return active_ && at_rest() && at_ >= limit(); }

    // At rest: from here backwards (-1) or forwards (1). through_waits: they are no walls, pass()
    // opens them.
    void turn(int direction, bool through_waits) noexcept;
    int direction() const noexcept { return direction_; }
    // One tick; false: nothing was driven. record() and s() give the new position.
    bool tick(const PathInput& input) noexcept;
    double speed() const noexcept { return planner_->speed(); }
    const PathRecord& record() const noexcept { return piece(shown_); }
    double s() const noexcept { return shown_s_; }
    // At rest behind the last record that can be driven in this direction: the record that stops
    // it; nullptr: the end of the memory.
    bool stands() const noexcept;
    const PathRecord* obstacle() const noexcept;
    bool from_the_start() const noexcept { return begin_ == 0; }  // no record has been forgotten

    // --- waits, for a channel that waits at one of them
    std::uint64_t obstacle_meeting() const noexcept;  // 0: the obstacle is no wait
    void pass() noexcept;                             // over the wait
    std::uint64_t last_meeting() const noexcept;      // the newest before this place
    // rests with nothing to drive between here and that wait
    bool beside(std::uint64_t meeting) const noexcept;

private:
    struct Entry {
        PathRecord record;
        double length = 0;
        std::uint64_t meeting = 0, last_meeting = 0;  // its own; the newest up to it
    };
    Entry& entry(std::uint64_t i) noexcept { return ring_[i % ring_.size()]; }
    const Entry& entry(std::uint64_t i) const noexcept { return ring_[i % ring_.size()]; }
    const PathRecord& piece(std::uint64_t i) const noexcept {
        return i < end_ ? entry(i).record : left_;
    }
    double length(std::uint64_t i) const noexcept { return i < end_ ? entry(i).length : left_s_; }
    bool drives(std::uint64_t i) const noexcept {
        return i == end_ ? left_s_ > 0 : entry(i).length > 0;
    }
    bool blocks(std::uint64_t i) const noexcept;
    std::uint64_t limit() const noexcept { return end_ + (left_s_ > 0 ? 1u : 0u); }
    // the first piece to drive from that gap on; false: none
    bool next(std::uint64_t from, std::uint64_t& i) const noexcept;
    std::uint64_t nearest_obstacle() const noexcept;  // kNone: none

    static constexpr std::uint64_t kNone = ~0ull;
    std::vector<Entry> ring_;
    std::vector<std::uint64_t> driven_;  // by planner record: which entry
    std::unique_ptr<PathPlanner> planner_;
    std::uint64_t begin_ = 0, end_ = 0;
    PathRecord left_{};
    double left_s_ = 0;
    bool active_ = false, through_waits_ = false;
    int direction_ = 0;
    std::uint64_t at_ = 0;
    double s_ = 0, from_s_ = 0;                    // from_s_: along the first piece of this run
    std::uint64_t shown_ = 0, last_appended_ = 0;  // entries
    double shown_s_ = 0;
    bool appended_ = false;
};

}  // namespace polyturn::kernel
