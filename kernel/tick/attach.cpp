#include "kernel/tick/attach.hpp"

#include <cstring>

namespace polyturn::kernel {
namespace {
ProcessState state_of(const ProcessEntry& entry) {
    // P1: the pid was stored before
    return static_cast<ProcessState>(entry.state.load(std::memory_order_acquire));
}

// A segment that a dead predecessor has left behind is not this process's: a channel's ring holds
// the program of before, and a kernel that took it would drive it. So its maker must be the process
// that the supervisor has started by now (one that it has not, has pid 0), and belong to the same
// start of the controller.
template <class Layout>
std::optional<PeerSegment<Layout>> attach_to(const std::string& instance, std::size_t number,
                                             const ProcessEntry& entry, std::uint64_t generation) {
    const int maker = entry.pid;
    if (maker == 0) return std::nullopt;
    auto peer = PeerSegment<Layout>::attach(instance, number, std::chrono::milliseconds(2));
    if (!peer || (*peer)->header.writer_pid != maker || (*peer)->header.generation != generation)
        return std::nullopt;
    return std::move(*peer);
}
}  // namespace

bool Peers::attach_plc(Machine& machine) {
    plc_ = attach_to<PlcSegment>(instance_, 0, supervisor_.processes[kProcessPlc],
                                 supervisor_.header.generation);
    if (plc_) machine.attach_plc(**plc_);
    return plc_.has_value();
}

bool Peers::attach_channel(Machine& machine, unsigned index) {
    channels_[index] = attach_to<ChannelSegment>(instance_, index + 1,
                                                 supervisor_.processes[kProcessChannel + index],
                                                 supervisor_.header.generation);
    if (channels_[index]) machine.attach_channel(index, **channels_[index]);
    return channels_[index].has_value();
}

void Peers::attach_all(Machine& machine, const std::atomic<bool>& alone) {
    while (!alone) {
        bool missing = false;
        const auto wanted = [&](std::size_t process) {
            const ProcessState state = state_of(supervisor_.processes[process]);
            return state == ProcessState::Starting || state == ProcessState::Running;
        };
        if (!plc_ && wanted(kProcessPlc) && !attach_plc(machine)) missing = true;
        for (unsigned l = 0; l < kMaxChannels; ++l)
            if (!channels_[l] && wanted(kProcessChannel + l) && !attach_channel(machine, l))
                missing = true;
        if (!missing) return;
        sleep_ms(1);
    }
}

void Peers::attach_successors(Machine& machine) {
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        const ProcessEntry& entry = supervisor_.processes[kProcessChannel + l];
        if (!channels_[l] || state_of(entry) != ProcessState::Running ||
            entry.pid == (*channels_[l])->header.writer_pid ||
            !machine.channel(l).may_be_replaced())
            continue;
        auto next =
            attach_to<ChannelSegment>(instance_, l + 1, entry, supervisor_.header.generation);
        if (!next) continue;
        old_channels_.push_back(std::move(*channels_[l]));
        channels_[l] = std::move(next);
        machine.attach_channel(l, **channels_[l]);
    }
}

void Peers::watch(Machine& machine, const std::atomic<bool>& stop) {
    constexpr int kLookMs = 20;
    std::array<int, kProcesses> pid{};
    for (std::size_t p = 0; p < kProcesses; ++p) pid[p] = supervisor_.processes[p].pid;
    const StoreSegment* store = &machine.store_segment();
    // versions of the tools and of the parameters that say whose turret holds them
    std::uint64_t shown = 0, shown_by = 0;
    // P3: a flag (the order is stronger than needed)
    while (!stop.load(std::memory_order_acquire)) {
        sleep_ms(kLookMs);
        // The protection uses a longer tool from the next tick that sees this table. Counting tool
        // life changes the table too; only changed outlines matter here.
        if (const std::uint64_t now = store->tools.version(), by = store->parameters.version();
            (now != shown || by != shown_by) &&
            // P7: taken: the other of the two shapes_ is read no more
            machine.core().next_shapes.load(std::memory_order_acquire) == nullptr) {
            ToolShapes& fresh = shapes_[next_shapes_];
            if (read_tool_shapes(*store, fresh)) {
                shown = now;
                shown_by = by;
                if (std::memcmp(&fresh, &shapes_[next_shapes_ ^ 1u], sizeof fresh) != 0) {
                    // P7: offered, complete
                    machine.core().next_shapes.store(&fresh, std::memory_order_release);
                    next_shapes_ ^= 1u;
                }
            }
        }
        for (std::size_t p = 0; p < kProcesses; ++p) {
            const ProcessEntry& entry = supervisor_.processes[p];
            const int now = entry.pid;
            if (now == 0 || now == pid[p] || state_of(entry) != ProcessState::Running) continue;
            if (p == kProcessPlc) {
                auto next =
                    attach_to<PlcSegment>(instance_, 0, entry, supervisor_.header.generation);
                if (!next) continue;
                if (plc_) old_plcs_.push_back(std::move(*plc_));
                plc_ = std::move(next);
                // P7: offered
                machine.core().next_plc.store(&**plc_, std::memory_order_release);
            } else if (p == kProcessStore) {
                auto next =
                    attach_to<StoreSegment>(instance_, 0, entry, supervisor_.header.generation);
                if (!next) continue;
                stores_.push_back(std::move(*next));
                store = &*stores_.back();
                shown = shown_by = 0;
                // P7: offered
                machine.core().next_store.store(&*stores_.back(), std::memory_order_release);
            } else if (p == kProcessDrives) {
                if (!machine.segment_drives() || !machine.segment_drives()->attach_successor(now))
                    continue;
            } else if (p >= kProcessChannel) {
                const std::size_t index = p - kProcessChannel;
                auto next = attach_to<ChannelSegment>(instance_, index + 1, entry,
                                                      supervisor_.header.generation);
                if (!next) continue;
                if (channels_[index]) old_channels_.push_back(std::move(*channels_[index]));
                channels_[index] = std::move(next);
                // P7: offered
                machine.core().next_channel[index].store(&**channels_[index],
                                                         std::memory_order_release);
            }
            pid[p] = now;
        }
    }
}

}  // namespace polyturn::kernel
