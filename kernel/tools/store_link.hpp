// The kernel's two conversations with the store (toolmgmt), neither of which it ever waits for in
// real time:
//   persist      what programs and operators write, in path order; applied and brought to the disk
//                over there
//   param_changes  values that act: taken at the start of a tick, all values of one import in the
//   same tick
//
// A parameter that is set while the machine runs is asked for through persist and comes back as a
// change. In virtual time the answer acts exactly PT_ANSWER_TICKS after the question, whatever the
// load of the computer (architecture 6).
#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "ipc/image/segments.hpp"
#include "kernel/config/kernel_config.hpp"

namespace polyturn::kernel {

class StoreLink {
public:
    StoreLink(KernelSegment& image, const StoreSegment& store)
        : persist_(image.persist, store.persist_tail),
          changes_(store.param_changes, image.param_tail),
          store_(&store) {}

    // A successor of the store has come. What its predecessor had not applied stays in the ring for
    // it.
    void rebind(KernelSegment& image, const StoreSegment& store) noexcept {
        persist_ = {image.persist, store.persist_tail};
        // P2: nothing of its ring was taken
        image.param_tail.tail.store(0, std::memory_order_release);
        changes_ = {store.param_changes, image.param_tail};
        store_ = &store;
        due_count_ = 0;
    }
    // False when the ring is full: the record that writes waits.
    [[nodiscard]] bool write(StoreRequestKind kind, std::uint32_t channel, std::int32_t number,
                             std::int32_t field, double value, std::string_view name) noexcept;
    // The source of the commands that follow; 0: a program, or the machine itself.
    void set_asker(std::uint32_t level, std::uint32_t user) noexcept {
        level_ = level;
        user_ = user;
    }
    // A parameter line; its answer is due `answer_ticks` later. All three: false when the ring is
    // full, nothing was asked then.
    [[nodiscard]] bool ask_parameter(std::string_view line, std::int64_t tick,
                                     std::int64_t answer_ticks) noexcept {
        return ask(StoreRequestKind::Parameter, 0, 0, 0, 0.0, line, tick + answer_ticks, false);
    }
    // About a tool: a T call, or a write whose answer is a change notification about the tool in
    // work (StoreSegment::tool_answers).
    [[nodiscard]] bool ask_tool(StoreRequestKind kind, std::uint32_t channel, std::int32_t number,
                                std::int32_t field, double value, std::string_view name,
                                std::int64_t tick, std::int64_t answer_ticks) noexcept {
        return ask(kind, channel, number, field, value, name, tick + answer_ticks, false);
    }
    // Likewise an offset or a zero.
    [[nodiscard]] bool ask_value(StoreRequestKind kind, std::uint32_t channel, std::int32_t number,
                                 std::int32_t field, double value, std::string_view name,
                                 std::int64_t tick, std::int64_t answer_ticks) noexcept {
        return ask(kind, channel, number, field, value, name, tick + answer_ticks, true);
    }
    // An offset or zero that was asked for acts from this tick on; read once, behind
    // take_changes().
    bool value_taken() noexcept { return std::exchange(value_taken_, false); }

    // Virtual time: must the store have answered before this tick, and has it?
    bool answer_due(std::int64_t tick) const noexcept {
        return due_count_ > 0 && due_[0].tick <= tick;
    }
    bool answered() const noexcept {
        return due_count_ == 0 ||
               // P1: the answer was published before the tail was moved
               store_->persist_tail.tail.load(std::memory_order_acquire) >= due_[0].request;
    }
    bool question_open() const noexcept { return due_count_ > 0; }
    bool value_open() const noexcept {
        for (std::size_t i = 0; i < due_count_; ++i)
            if (due_[i].value) return true;
        return false;
    }
    // Capacity for every write that the channels have planned (kWritesAhead each) and for what the
    // machine writes of its own.
    bool has_room() const noexcept {
        // P3: how much room; claim() looks itself (P2)
        return persist_.head() - store_->persist_tail.tail.load(std::memory_order_acquire) +
                   kReserve <=
               RingHead<StoreRequest, 8192>::capacity;
    }
    static constexpr std::uint32_t kWritesAhead = 256;
    // Takes complete imports into the table. True when something changed. `hold_back`: virtual time
    // and a question is open that is not due yet, then nothing is taken before its tick.
    bool take_changes(params::Table& table, std::int64_t tick, bool virtual_time) noexcept;
    std::uint64_t id() const noexcept { return persist_.head(); }
    // number of the last question whose answer acts
    std::uint64_t last_answer() const noexcept { return last_answer_; }
    bool rang() noexcept { return std::exchange(written_, false); }

private:
    struct Due {
        std::int64_t tick;
        std::uint64_t request;
        bool value = false;
    };
    static constexpr std::uint64_t kReserve = kMaxChannels * kWritesAhead + 1024;
    [[nodiscard]] bool ask(StoreRequestKind kind, std::uint32_t channel, std::int32_t number,
                           std::int32_t field, double value, std::string_view name,
                           std::int64_t due, bool is_value) noexcept;

    RingProducer<RingHead<StoreRequest, 8192>> persist_;
    RingConsumer<RingHead<ParamChange, 8192>> changes_;
    const StoreSegment* store_;
    // in order of their ticks; one for all questions of a tick
    std::array<Due, 64> due_{};
    std::size_t due_count_ = 0;
    bool written_ = false, value_taken_ = false;
    std::uint32_t level_ = 0, user_ = 0;
    std::uint64_t last_answer_ = 0;
    void drop_due() noexcept;
};

}  // namespace polyturn::kernel
