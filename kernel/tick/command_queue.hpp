// Commands of operator and scenario, waiting for their tick. The supervisor pushes them in any
// order of time; they are sorted by tick, and within a tick by sequence (the file's order). The
// capacity is fixed: what does not fit stays in the ring.
#pragma once
#include <array>
#include <cstdint>
#include <cstring>

#include "ipc/image/segments.hpp"

namespace polyturn::kernel {

class CommandQueue {
public:
    CommandQueue(const SupervisorSegment& supervisor, KernelSegment& image)
        : ring_(supervisor.commands, image.command_tail) {}

    // Takes what has come. A command without a tick, or for one that has passed, acts now.
    void drain(std::int64_t now) noexcept {
        while (count_ < kRoom) {
            const Command* command = ring_.front();
            if (!command) return;
            // looked at once: it is the supervisor's memory
            std::memcpy(static_cast<void*>(&came_), command, sizeof came_);
            __asm__ volatile("" : : "r"(&came_) : "memory");
            insert(came_, came_.tick > now ? came_.tick : now);
            ring_.pop();
        }
    }
    // The next one that is due, nullptr when there is none; good until the next call.
    const Command* next_due(std::int64_t now) noexcept {
        if (count_ == 0 || store_[order_[count_ - 1]].tick > now) return nullptr;
        return &store_[order_[--count_]];
    }
    // The run is to end: the log is not read any more.
    bool end_requested() const noexcept { return end_requested_; }
    bool empty() noexcept { return count_ == 0 && ring_.front() == nullptr; }

private:
    static constexpr std::size_t kRoom = 1024;
    void insert(const Command& command, std::int64_t tick) noexcept {
        if (!initialised_) {
            for (std::size_t i = 0; i < kRoom; ++i) order_[i] = static_cast<std::uint16_t>(i);
            initialised_ = true;
        }
        if (command.kind == static_cast<std::uint32_t>(CommandKind::EndRun)) end_requested_ = true;
        const std::uint16_t place = order_[count_];  // order_[count_..] are the free places
        store_[place] = command;
        store_[place].tick = tick;
        // Latest first, so that taking the next one is dropping the last.
        std::size_t i = count_++;
        for (; i > 0; --i) {
            const Command& before = store_[order_[i - 1]];
            if (before.tick > tick || (before.tick == tick && before.seq > command.seq)) break;
            order_[i] = order_[i - 1];
        }
        order_[i] = place;
    }

    RingConsumer<RingHead<Command, 1024>> ring_;
    Command came_{};
    std::array<Command, kRoom> store_{};
    std::array<std::uint16_t, kRoom> order_{};
    std::size_t count_ = 0;
    bool initialised_ = false, end_requested_ = false;
};

}  // namespace polyturn::kernel
