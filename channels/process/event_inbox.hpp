// Events of the kernel for this channel that the process has not acted on yet. Taken out of the
// ring as soon as it is seen, so that a reset is found behind other events.
#pragma once
#include <deque>
#include <functional>

#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/image/segments.hpp"

namespace polyturn::channels {

class EventInbox {
public:
    EventInbox(const KernelSegment& kernel, unsigned index, ChannelSegment& own)
        : ring_(kernel.events[index], own.event_tail) {}

    void poll() {
        while (const ChannelEvent* event = ring_.front()) {
            if (cuts(*event)) ++interrupts_;
            events_.push_back(*event);
            if (static_cast<ChannelEventKind>(event->kind) == ChannelEventKind::AskResume &&
                on_question)
                on_question(*event);
            ring_.pop();
        }
    }
    // A question is answered as soon as it is seen, also while interpretation waits for room in the
    // ring.
    std::function<void(const ChannelEvent&)> on_question;
    // Interpretation must not go on: a reset or the end is among what has come.
    bool interrupts() const { return interrupts_ > 0; }
    bool empty() const { return events_.empty(); }
    ChannelEvent take() {
        const ChannelEvent event = events_.front();
        events_.pop_front();
        if (cuts(event)) --interrupts_;
        return event;
    }

private:
    static bool cuts(const ChannelEvent& event) {
        const auto kind = static_cast<ChannelEventKind>(event.kind);
        // the running block may still be read
        if (kind == ChannelEventKind::Interrupt && (event.record & kInterruptAhead)) return false;
        return kind == ChannelEventKind::Reset || kind == ChannelEventKind::Quit ||
               kind == ChannelEventKind::Interrupt || kind == ChannelEventKind::Resume ||
               kind == ChannelEventKind::HeldMdi;
    }
    RingConsumer<RingHead<ChannelEvent, 64>> ring_;
    std::deque<ChannelEvent> events_;
    int interrupts_ = 0;
};

}  // namespace polyturn::channels
