// Virtual time: the same machine as fast as the computer allows, with the same result at any load.
//
// Before each tick the clock waits until everything that this tick may depend on is there
// (segments.hpp): records of each channel up to the horizon or its notice that no more follow, the
// answers of the PLC and of the store that act now, and the supervisor's reaction to the newest
// event. It waits for the participants in turn, on the bell in each one's own segment: usually all
// is there already and a tick costs no system call.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "ipc/memory/doorbell.hpp"
#include "kernel/tick/attach.hpp"
#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

class VirtualClock {
public:
    // `alone`: the supervisor has died; nullptr: it lives as long as the machine.
    explicit VirtualClock(Machine& machine, Peers* peers = nullptr,
                          const std::atomic<bool>* alone = nullptr);
    // Runs until the end of the run. All participants must be attached before.
    void run();
    // One tick when all is there; false when the machine is idle and no command is there (tests
    // drive it by hand).
    bool step();

    // Waiting time by participant; shows what limits the speed.
    struct Waits {
        std::uint64_t channels = 0, plc = 0, store = 0, supervisor = 0;
    };
    const Waits& waits() const { return waits_; }

private:
    void participants();
    void supervisor();
    bool gone(std::size_t process) const;
    template <class Ready>
    void await(const Doorbell& bell, std::size_t process, Doorbell& theirs, std::uint64_t& count,
               Ready ready);

    // P3: a flag, announces nothing (the order is stronger than needed)
    bool alone() const { return alone_ && alone_->load(std::memory_order_acquire); }

    Machine& machine_;
    const std::atomic<bool>* alone_;
    Peers* peers_;  // looks for successors; nullptr: none are looked for
    Waits waits_;
    std::uint64_t rung_ = 0;  // newest event that the supervisor was woken for
    bool idle_said_ = false;
};

}  // namespace polyturn::kernel
