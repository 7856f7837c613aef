// Real time: an absolute timer, first-in first-out priority and locked memory where the system
// grants them (a message where it does not). A late tick is not made up for: the next tick comes
// one whole tick later.
#pragma once
#include <atomic>
#include <string>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

class RealClock {
public:
    explicit RealClock(Machine& machine, const std::atomic<bool>& alone)
        : machine_(machine), alone_(alone) {}
    // Asks for priority and locked memory; what was refused, for the log and stderr. Empty: all
    // granted.
    std::string claim_real_time();
    void run();

private:
    void supervise();
    Machine& machine_;
    const std::atomic<bool>& alone_;  // the supervisor has died, or the kernel was asked to end
    std::uint64_t beat_ = 0;
    std::int64_t beat_tick_ = 0;
    std::uint64_t rung_ = 0;
    std::int64_t late_in_a_row_ = 0;
    bool silent_ = false;
};

}  // namespace polyturn::kernel
