// The program of a positioning axis (B axis, fanuc_lathe 10.4): steps that the channel's program
// has handed over, executed one after the other while the path goes on.
//
//   path records   M81  Begin Move Dwell Function Move End   G1 ..   M82  Begin ...
//   queue               '--------- started: 1 ----------'            '-- started: 2, runs behind it
//
// Invariants
//   I1  The queue never grows beyond its capacity: the path waits with Begin and Room records until
//       there is room.
//   I2  M, S and T of a step go to the PLC at the axis (AN_PAXFSTR), apart from those of the path.
//   I3  A reset, an alarm or the end of the program clears it; the axis comes to rest by itself
//       (positioning_axis.cpp).
//   I4  An axis does one program at a time (Core::PositioningTurn), whichever channels have started
//       them: in the order of their starts.
#pragma once
#include <cstdint>
#include <vector>

#include "ipc/image/positioning_step.hpp"

namespace polyturn::kernel {

struct PositioningTask {
    PositioningStep what = PositioningStep::Plain;
    std::uint8_t axis = 0;  // machine axis, from 0
    char letter = 0;        // Function: M, S or T
    // by_way: value counts from the axis' position when its program began
    bool per_turn = false, by_way = false;
    double value = 0;  // Move: target; Dwell: seconds; Function: number
    double speed = 0;  // Move: mm/s, or mm a revolution; 0 rapid
    std::uint32_t spindle = 0, line = 0;
    std::uint64_t note = 0;
    std::uint64_t turn = 0;  // Begin: counts the starts of all channels
};

class PositioningProgram {
public:
    static constexpr std::size_t kSteps = 4096;
    static constexpr std::uint32_t kMostStarted = 5;

    PositioningProgram() : tasks_(kSteps) {}

    // For the steps behind a Begin or Room record, up to the next.
    bool has_room() const noexcept { return kSteps - count_ > kStepsAtOnce + 1; }
    bool put(const PositioningTask& task) noexcept {
        if (dropping_ && task.what != PositioningStep::Begin) {
            if (task.what == PositioningStep::End) dropping_ = open_ = false;
            return true;
        }
        if (count_ == kSteps) return false;
        if (task.what == PositioningStep::Begin) {
            ++started_;
            dropping_ = false;
        }
        open_ = task.what != PositioningStep::End;
        axis_ = task.axis;
        tasks_[(first_ + count_++) % kSteps] = task;
        return true;
    }
    // What was handed over is all that comes: the rest of the program was discarded with its path
    // (an interrupt macro, a skip).
    void close() noexcept {
        if (open_) put({.what = PositioningStep::End, .axis = axis_});
    }
    // The PLC ends it and those behind it: what the path has still to hand over of it is dropped.
    void drop() noexcept {
        const bool more = open_;
        clear();
        open_ = dropping_ = more;
    }
    const PositioningTask* now() const noexcept { return count_ ? &tasks_[first_] : nullptr; }
    void next() noexcept {
        if (tasks_[first_].what == PositioningStep::End) --started_;
        first_ = (first_ + 1) % kSteps;
        --count_;
        begun = false;
    }
    void clear() noexcept {
        count_ = 0;
        started_ = 0;
        begun = open_ = dropping_ = false;
    }
    // a program is begun and not ended
    bool busy() const noexcept { return count_ != 0 || (open_ && !dropping_); }
    std::uint8_t axis() const noexcept { return axis_; }         // that of the newest step
    std::uint32_t started() const noexcept { return started_; }  // begun or waiting, not ended
    bool moves(std::uint32_t axis) const noexcept {
        return count_ != 0 && tasks_[first_].axis == axis;
    }

    bool begun = false;  // now() has begun
    double left_s = 0;   // of a dwell
    double base = 0;     // the axis' position when the program began

private:
    std::vector<PositioningTask> tasks_;  // sized once, before the cyclic thread runs
    std::size_t first_ = 0, count_ = 0;
    std::uint32_t started_ = 0;
    bool open_ = false;      // a Begin without its End
    bool dropping_ = false;  // whose rest does not count
    std::uint8_t axis_ = 0;
};

}  // namespace polyturn::kernel
