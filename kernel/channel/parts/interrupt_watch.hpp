// The interrupt macro's signal, watched between M96 and M97, and the channel's answer to being
// notified ahead (program/interrupt.hpp).
#pragma once
#include <cstdint>

namespace polyturn::kernel {

class Signals;

struct InterruptWatch {
    // on: the signal is watched; due: it has come and the path is to stop. A program that leaves
    // M96 while it is due (in statements that act ahead) is due and not on.
    bool on = false, due = false;
    // InterruptBit; bit n: input n + 1; those that were on at the last tick
    std::uint32_t bits = 0, inputs = 0, seen = 0;
    std::uint32_t input = 0;  // number of the input that came; 0: there is but one
    // The channel was notified ahead: the question it answers (0 none), and the first record that
    // may act at once.
    std::uint64_t ahead_asked = 0, ahead = ~0ull;

    // The watched signals that are on: bit 0 the only one, or bit n input n + 1.
    std::uint32_t signals_now(const Signals& signals, std::uint32_t channel) const noexcept;
    void off() noexcept { on = due = false; }
    void nothing_ahead() noexcept {
        ahead_asked = 0;
        ahead = ~0ull;
    }
};

}  // namespace polyturn::kernel
