#include "kernel/channel/parts/outbox.hpp"

#include <algorithm>

#include "kernel/tick/event_log.hpp"

namespace polyturn::kernel {
namespace {
// A channel sleeps when its ring is full; it is woken when this much has become free, not for every
// record.
constexpr std::uint64_t kWakeChunk = 1024;
}  // namespace

void Outbox::put(ChannelEventKind kind, std::uint32_t epoch, std::int64_t tick,
                 std::uint64_t record, double value, std::string_view text) noexcept {
    if (full()) return;
    ChannelEvent& event = events_[count_++];
    event.kind = static_cast<std::uint32_t>(kind);
    event.epoch = epoch;
    event.tick = tick;
    event.record = record;
    event.value = value;
    copy_text(event.text, text);
}

bool Outbox::send(RingHead<ChannelEvent, 64>& head, const RingTail& tail,
                  std::uint64_t cursor) noexcept {
    bool rang = false;
    if (count_ > 0) {
        RingProducer<RingHead<ChannelEvent, 64>> ring(head, tail);
        std::size_t sent = 0;
        while (sent < count_) {
            events_[sent].seq = sent_ + 1;
            if (!ring.push(events_[sent])) break;
            ++sent_;
            ++sent;
        }
        std::move(events_.begin() + static_cast<std::ptrdiff_t>(sent),
                  events_.begin() + static_cast<std::ptrdiff_t>(count_), events_.begin());
        count_ -= sent;
        rang = sent > 0;
    }
    if (!rang && cursor - rung_at_ < kWakeChunk) return false;
    rung_at_ = cursor;
    return true;
}

}  // namespace polyturn::kernel
