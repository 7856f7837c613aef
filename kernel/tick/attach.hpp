// Finding the other processes: they start after the kernel and may be started anew while it runs.
#pragma once
#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "ipc/memory/segment.hpp"
#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

class Peers {
public:
    Peers(std::string instance, const SupervisorSegment& supervisor)
        : instance_(std::move(instance)), supervisor_(supervisor) {}
    // Waits for everybody whom the supervisor has announced (or who has died since), as long as
    // that lives.
    void attach_all(Machine& machine, const std::atomic<bool>& alone);
    // Successors of those that have died, until told to stop; runs in a thread of its own (real
    // time).
    void watch(Machine& machine, const std::atomic<bool>& stop);
    // Virtual time, between two ticks: successors of channels whose axes rest. The supervisor
    // starts them while the clock waits for it.
    void attach_successors(Machine& machine);

private:
    bool attach_channel(Machine& machine, unsigned index);
    bool attach_plc(Machine& machine);
    std::string instance_;
    const SupervisorSegment& supervisor_;
    // Old mappings stay until the end: the cyclic thread may still look at them in this tick.
    std::vector<PeerSegment<ChannelSegment>> old_channels_;
    std::vector<PeerSegment<PlcSegment>> old_plcs_;
    std::vector<PeerSegment<StoreSegment>> stores_;
    // the one that was handed over last, and the one that is read next
    std::array<ToolShapes, 2> shapes_{};
    unsigned next_shapes_ = 0;
    std::optional<PeerSegment<PlcSegment>> plc_;
    std::array<std::optional<PeerSegment<ChannelSegment>>, kMaxChannels> channels_;
};

}  // namespace polyturn::kernel
