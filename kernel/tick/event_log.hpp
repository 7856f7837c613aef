// The kernel's log: everything that happened, in order, for the event log and the screens.
//
// In virtual time the clock makes room before each tick (clock_virtual.cpp), so that nothing is
// lost. In real time the cyclic thread never waits: it drops what does not fit and counts it.
#pragma once
#include <algorithm>
#include <cstring>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/image/segments.hpp"
#include "kernel/tick/short_text.hpp"

namespace polyturn::kernel {

template <std::size_t kBytes>
void copy_text(std::array<char, kBytes>& to, std::string_view from) noexcept {
    const std::size_t n = std::min(from.size(), kBytes - 1);
    std::memcpy(to.data(), from.data(), n);
    to[n] = 0;  // readers stop here; what an older event left behind it does not matter
}

class EventLog {
public:
    // A tick never logs more than this: one record's begin and end for every channel, many times
    // over.
    static constexpr std::uint64_t kReserve = 4096;

    EventLog(KernelSegment& image, const SupervisorSegment& supervisor)
        : ring_(image.log, supervisor.log_tail), tail_(&supervisor.log_tail) {}

    // The event to fill in; put() sends it. nullptr when there is no room.
    KernelEvent* claim(KernelEventKind kind, std::uint32_t channel, std::int64_t tick,
                       double offset_s = 0) noexcept {
        KernelEvent* event = ring_.claim();
        if (!event) {
            ++dropped_;
            return nullptr;
        }
        event->seq = newest_ + 1;
        event->kind = static_cast<std::uint32_t>(kind);
        event->channel = channel;
        event->tick = tick;
        event->offset_s = offset_s;
        event->note = 0;
        event->code = 0;
        event->line = 0;
        event->value = 0;
        event->text[0] = 0;
        return event;
    }
    void put() noexcept {
        ++newest_;
        ring_.commit();
    }
    std::uint64_t newest() const noexcept { return newest_; }
    std::uint64_t dropped() const noexcept { return dropped_; }
    bool has_room() const noexcept {
        // P3: how much room; claim() looks itself (P2)
        return ring_.head() - tail_->tail.load(std::memory_order_acquire) + kReserve <=
               RingHead<KernelEvent, 16384>::capacity;
    }

private:
    RingProducer<RingHead<KernelEvent, 16384>> ring_;
    const RingTail* tail_;
    std::uint64_t newest_ = 0, dropped_ = 0;
};

}  // namespace polyturn::kernel
