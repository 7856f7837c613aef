// Attaches the other processes: they start after the kernel and may be restarted while it runs.
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
    // Waits for every process that the supervisor has announced (or that has died since), as long
    // as the supervisor lives.
    void attach_all(Machine& machine, const std::atomic<bool>& alone);
    // Attaches successors of dead processes until it is stopped; runs in a thread of its own (real
    // time).
    void watch(Machine& machine, const std::atomic<bool>& stop);
    // Virtual time, between two ticks: attaches successors of channels whose axes are at
    // standstill. The supervisor starts them while the clock waits.
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
