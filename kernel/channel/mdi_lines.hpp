// MDI blocks, in the order in which a start takes them (H2: entering is not starting).
//
//   A done | B runs | C entered (due) | D entered (due) | E entered |
//                                                          ^ after the start: it waits for the next
//                                                          one
//
// Invariants
//   L1  A line is appended, never changed: its text is what was entered.
//   L2  A line runs once: Entered -> Runs -> Done | BrokenOff.
//   L3  Only begin() makes a line due, and only a start of the operator calls it.
//   L4  At most one line runs.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "ipc/memory/snapshot.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::kernel {

class MdiLines {
public:
    // False: the list is full, all lines are still to run.
    [[nodiscard]] bool enter(std::string_view text) noexcept;
    std::uint32_t waiting() const noexcept { return list_.waiting; }
    // A start of the operator: `all` that is entered now, or the first line alone.
    void begin(bool all) noexcept;
    // The next line is to run without another start.
    bool goes_on() const noexcept { return due_ > 0; }
    // What follows waits for another start.
    void stand() noexcept { due_ = 0; }
    // Text of the line that runs now; it was the first that waited.
    std::string_view run_next() noexcept;
    std::string_view next() const noexcept;
    void ended() noexcept { leave(MdiState::Done); }
    // A reset: what was to come before the other lines has not happened, so that they go, too.
    void broken_off() noexcept;
    // What has run and what waits; a line that runs stays.
    void clear() noexcept;
    // Written when something has changed since.
    void publish(Snapshot<MdiList>& shown) noexcept;

private:
    static bool is(const MdiLine& line, MdiState state) noexcept {
        return line.state == static_cast<std::uint32_t>(state);
    }
    void leave(MdiState state) noexcept;
    void drop(std::uint32_t at) noexcept;
    MdiList list_{};
    std::uint32_t due_ = 0;      // of the waiting lines, the first ones
    std::uint32_t entered_ = 0;  // since the channel is there
    bool changed_ = false;
};

}  // namespace polyturn::kernel
