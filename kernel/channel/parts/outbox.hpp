// What a channel's process must know: events that wait for room in its ring, in the order in which
// they happened.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "ipc/image/segments.hpp"

namespace polyturn::kernel {

class Outbox {
public:
    // 16 events a tick: more only by a fault of ours, and the ring holds 64
    static constexpr std::size_t kMost = 16;

    // A successor has seen none of the events of its predecessor and must not.
    void begin_at(std::uint64_t sent) noexcept {
        sent_ = sent;
        count_ = 0;
        rung_at_ = 0;
    }
    bool full() const noexcept { return count_ == kMost; }
    bool empty() const noexcept { return count_ == 0; }
    bool has_room_for(std::size_t more) const noexcept { return count_ + more <= kMost; }
    void put(ChannelEventKind kind, std::uint32_t epoch, std::int64_t tick, std::uint64_t record,
             double value, std::string_view text) noexcept;
    std::uint64_t sent() const noexcept { return sent_; }
    // Number of the event that was put last.
    std::uint64_t newest() const noexcept { return sent_ + count_; }
    // True: the channel is to be woken, for something was sent, or `cursor` has gone on so far.
    bool send(RingHead<ChannelEvent, 64>& head, const RingTail& tail,
              std::uint64_t cursor) noexcept;

    bool store_changed = false;

private:
    std::array<ChannelEvent, kMost> events_{};
    std::size_t count_ = 0;
    std::uint64_t sent_ = 0, rung_at_ = 0;
};

}  // namespace polyturn::kernel
