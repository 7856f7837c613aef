// What blocks that are not executed yet have changed for the channel itself: variables, offsets,
// zeros. When their records are discarded it is all put back, newest first (architecture 5.4, 5.6).
#pragma once
#include <cstdint>
#include <deque>

namespace polyturn::channels {

class UndoLog {
public:
    void enable(bool on) { enabled_ = on; }
    bool enabled() const { return enabled_; }
    // Before `cell` is written by block `block`. The cell must live as long as the log.
    void note(std::uint64_t block, double& cell) {
        if (enabled_) entries_.push_back({block, &cell, cell});
    }
    void executed(std::uint64_t block) {  // blocks before `block` are done for good
        while (!entries_.empty() && entries_.front().block < block) entries_.pop_front();
    }
    void back_to(std::uint64_t block) {  // `block` and everything behind it has not happened
        while (!entries_.empty() && entries_.back().block >= block) {
            *entries_.back().cell = entries_.back().before;
            entries_.pop_back();
        }
    }
    void clear() { entries_.clear(); }

private:
    struct Entry {
        std::uint64_t block;
        double* cell;
        double before;
    };
    std::deque<Entry> entries_;
    bool enabled_ = false;
};

}  // namespace polyturn::channels
