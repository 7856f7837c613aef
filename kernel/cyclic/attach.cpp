#include "kernel/cyclic/attach.hpp"

namespace polyturn::kernel {
namespace {
ProcessState state_of(const ProcessEntry& entry) { return static_cast<ProcessState>(entry.state.load(std::memory_order_acquire)); }

// A segment that a dead predecessor has left behind is not this process's.
template <class Layout>
std::optional<PeerSegment<Layout>> attach_to(const std::string& instance, std::size_t number, const ProcessEntry& entry) {
    auto peer = PeerSegment<Layout>::attach(instance, number, std::chrono::milliseconds(2));
    if (!peer || (entry.pid != 0 && (*peer)->header.writer_pid != entry.pid)) return std::nullopt;
    return std::move(*peer);
}
}  // namespace

bool Peers::attach_plc(Machine& machine) {
    plc_ = attach_to<PlcSegment>(instance_, 0, supervisor_.processes[kProcessPlc]);
    if (plc_) machine.attach_plc(**plc_);
    return plc_.has_value();
}

bool Peers::attach_channel(Machine& machine, unsigned index) {
    channels_[index] = attach_to<ChannelSegment>(instance_, index + 1, supervisor_.processes[kProcessChannel + index]);
    if (channels_[index]) machine.attach_channel(index, **channels_[index]);
    return channels_[index].has_value();
}

void Peers::attach_all(Machine& machine) {
    for (;;) {
        bool missing = false;
        const auto wanted = [&](std::size_t process) {
            const ProcessState state = state_of(supervisor_.processes[process]);
            return state == ProcessState::Starting || state == ProcessState::Running;
        };
        if (!plc_ && wanted(kProcessPlc) && !attach_plc(machine)) missing = true;
        for (unsigned l = 0; l < kMaxChannels; ++l)
            if (!channels_[l] && wanted(kProcessChannel + l) && !attach_channel(machine, l)) missing = true;
        if (!missing) return;
    }
}

}  // namespace polyturn::kernel
