// Virtual time: the same machine, as fast as it goes, and the same whatever the load of the
// computer.
//
// Before each tick the clock makes sure that everything this tick may depend on is there
// (segments.hpp): records of each channel up to the horizon or its word that it has nothing more to
// say, the PLC's answer that acts now, the store's answer that acts now, and what the supervisor
// has to say to the newest event. It waits for the participants in turn, on the bell in each one's
// own segment: usually all is there already and a tick costs no system call.
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
    // Runs until the end of the run. Attached before: everybody who takes part.
    void run();
    // One tick when all is there; false when the machine is idle and no command is there (tests
    // drive it by hand).
    bool step();

    // For how long it waited, by participant; tells what limits the speed.
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
    Peers* peers_;  // who looks for successors; nullptr: nobody
    Waits waits_;
    std::uint64_t rung_ = 0;  // newest event that the supervisor was woken for
    bool idle_said_ = false;
};

}  // namespace polyturn::kernel
