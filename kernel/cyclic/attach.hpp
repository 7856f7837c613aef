// Finding the other processes: they start after the kernel and may be started anew while it runs.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "ipc/memory/segment.hpp"
#include "kernel/cyclic/machine.hpp"

namespace polyturn::kernel {

class Peers {
public:
    Peers(std::string instance, const SupervisorSegment& supervisor) : instance_(std::move(instance)), supervisor_(supervisor) {}
    // Waits for everybody whom the supervisor has announced (or who has died since).
    void attach_all(Machine& machine);

private:
    bool attach_channel(Machine& machine, unsigned index);
    bool attach_plc(Machine& machine);
    std::string instance_;
    const SupervisorSegment& supervisor_;
    std::optional<PeerSegment<PlcSegment>> plc_;
    std::array<std::optional<PeerSegment<ChannelSegment>>, kMaxChannels> channels_;
};

}  // namespace polyturn::kernel
