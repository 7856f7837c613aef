// What must keep holding while a program runs: one table, as for its start (start_conditions.hpp).
// Each row has the fault, its remedy, and the reaction of the machine:
//
//   Hold       the path brakes and stops; cycle start goes on once the cause is gone
//   Stop       the program is broken off along its path, with an alarm; reset
//   EndOfPart  the part is finished, then the program ends; a warning says why
//
// The PLC reports (inputs, positions of its devices); whether something turns or moves in spite of
// it is checked here.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

struct InterlockView {
    std::uint32_t channel = 0;  // from 1
    std::uint32_t spindle = 0;  // from 1: the one that the channel's plain S means; 0 none
    bool spindle_turns = false;
    bool path_moves = false;
    bool turret_may_turn = false;  // its T was given on the last part of a rapid move
};

struct Interlock {
    enum class Act : std::uint8_t { Hold, Stop, EndOfPart };
    std::string_view name;  // for tests and documents
    Act act;
    std::string_view text, remedy;
    bool (*broken)(const Core& core, const InterlockView& view);
};

[[nodiscard]] std::span<const Interlock> interlocks() noexcept;
inline constexpr std::size_t kMostInterlocks = 16;

}  // namespace polyturn::kernel
