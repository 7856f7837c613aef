#include "kernel/tick/clock_virtual.hpp"

namespace polyturn::kernel {
namespace {
constexpr int kSpins = 200;
// bounds the harm of a participant that forgets to ring
constexpr std::int64_t kLookAgainUs = 5'000;
constexpr int kLooksAlone = 400;  // two seconds
// without follow_log the supervisor is woken for so many events
constexpr std::uint64_t kLogChunk = 256;
}  // namespace

VirtualClock::VirtualClock(Machine& machine, Peers* peers, const std::atomic<bool>* alone)
    : machine_(machine), alone_(alone), peers_(peers) {
    machine_.on_action = [](void* self) { static_cast<VirtualClock*>(self)->supervisor(); };
    machine_.on_action_context = this;
}

bool VirtualClock::gone(std::size_t process) const {
    // P1: dead is who was reaped: all that it wrote is visible
    return process < kProcesses &&
           machine_.core().supervisor.processes[process].state.load(std::memory_order_acquire) ==
               static_cast<std::uint32_t>(ProcessState::Dead);
}

template <class Ready>
void VirtualClock::await(const Doorbell& bell, std::size_t process, Doorbell& theirs,
                         std::uint64_t& count, Ready ready) {
    if (ready()) return;
    ++count;
    theirs.ring();  // it may sleep for want of room
    for (int without_supervisor = 0;;) {
        const std::uint32_t seen = bell.seen();
        if (ready() || gone(process)) return;
        // the process that reports deaths is gone
        if (alone() && ++without_supervisor > kLooksAlone) return;
        bell.wait(seen, kLookAgainUs, kSpins);
    }
}

// The supervisor has handled the newest event and sent its answers; there is room for what a tick
// may log and trace.
void VirtualClock::supervisor() {
    Core& core = machine_.core();
    const bool follow = core.supervisor.options.follow_log != 0;
    const auto ready = [&] {
        if (alone()) return true;  // the reader of log and trace is gone
        machine_.commands().drain(core.tick);
        return machine_.commands().end_requested() ||
               (core.log.has_room() && machine_.trace_has_room() &&
                // P1: what the supervisor sent before it is visible
                (!follow ||
                 core.supervisor.log_seen.load(std::memory_order_acquire) >= core.log.newest()));
    };
    if (!follow && core.log.newest() - rung_ >= kLogChunk) {
        rung_ = core.log.newest();
        core.image.supervisor_bell.ring();
    }
    await(core.supervisor.bell, kProcesses, core.image.supervisor_bell, waits_.supervisor, ready);
}

void VirtualClock::participants() {
    Core& core = machine_.core();
    supervisor();
    if (peers_) peers_->attach_successors(machine_);
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        ChannelRunner& channel = machine_.channel(l);
        if (!channel.listens()) continue;
        // P4: this thread has stored it (the order is stronger than needed)
        const ChannelSegment* segment = core.channel_segment[l].load(std::memory_order_acquire);
        await(segment->bell, kProcessChannel + l, core.image.channel_bell[l], waits_.channels,
              [&] { return channel.supplied(); });
    }
    if (machine_.plc().asked())
        // P4: as above
        await(core.plc_segment.load(std::memory_order_acquire)->bell, kProcessPlc,
              core.image.plc_bell, waits_.plc, [&] { return machine_.plc().answered(); });
    if (SegmentDrives* drives = machine_.segment_drives()) {
        const auto answers = [&] {
            // P1: as in gone()
            return core.supervisor.processes[kProcessDrives].state.load(
                       std::memory_order_acquire) ==
                   static_cast<std::uint32_t>(ProcessState::Running);
        };
        while (!drives->answered() && answers()) {
            drives->wake();
            drives->await_answer(kLookAgainUs);
        }
    }
    if (core.store.answer_due(core.tick) || !core.store.has_room())
        await(machine_.store_segment().bell, kProcessStore, core.image.store_bell, waits_.store,
              [&] {
                  return (!core.store.answer_due(core.tick) || core.store.answered()) &&
                         core.store.has_room();
              });
}

bool VirtualClock::step() {
    Core& core = machine_.core();
    participants();
    if (alone())
        machine_.left_alone();
    else if (machine_.idle()) {
        if (!idle_said_) {
            core.event(KernelEventKind::Idle, 0);
            idle_said_ = true;
            core.image.supervisor_bell.ring();
            rung_ = core.log.newest();
        }
        return false;
    }
    idle_said_ = false;
    machine_.tick();
    if (core.store.rang()) core.image.store_bell.ring();
    return true;
}

void VirtualClock::run() {
    Core& core = machine_.core();
    std::uint64_t none = 0;
    while (!machine_.ended()) {
        if (step()) continue;
        // Virtual time is stopped. A command starts it again; all of a batch are there when the
        // supervisor has seen «idle».
        await(core.supervisor.bell, kProcesses, core.image.supervisor_bell, none, [&] {
            if (alone()) return true;
            machine_.commands().drain(core.tick);
            return machine_.commands().end_requested() ||
                   // P1: all of the batch is visible
                   (core.supervisor.log_seen.load(std::memory_order_acquire) >= core.log.newest() &&
                    !machine_.commands().empty());
        });
    }
    core.image.supervisor_bell.ring();
}

}  // namespace polyturn::kernel
