// What must hold before a program may start in a channel: one table. A refused start names
// everything that is missing, each with its remedy, so that the operator does not have to find the
// conditions one by one.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "ipc/requests/start_words.hpp"
#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

// What only the channel's runner knows.
struct StartView {
    std::uint32_t channel = 0;  // from 1
    bool process_there = true;  // its process lives and answers
    bool resting = true;        // a reset has come to its end
    bool alarmed = false;       // interrupted by an alarm: only a reset goes on
    bool by_hand_mode = false;  // jog, handwheel, reference
    bool away = false;          // axes were moved in a hold and have not come back
    // it has reached the block of a restart, and not all of that restart have
    bool others_search = false;
    bool lacks_program = false;  // it would begin the selected program, and none is
    bool lacks_block = false;    // it would begin the block entered by hand, and none is
};

struct StartCondition {
    enum class Scope : std::uint8_t { Machine, Channel, Axis, Spindle };
    std::string_view name;  // of its row in kStartWords, which has text and remedy
    Scope scope;
    // Machine and Channel: not 0 when it is missing. Axis and Spindle: the next one that misses it,
    // from 1, behind `after`; 0 none.
    std::uint32_t (*missing)(const Core& core, const StartView& view, std::uint32_t after);
};

[[nodiscard]] std::span<const StartCondition> start_conditions() noexcept;
// Which rows fail, bit by bit.
[[nodiscard]] std::uint32_t rows_missing_for_start(const Core& core,
                                                   const StartView& view) noexcept;
// All that is missing, as one text; empty: the program may start.
[[nodiscard]] ShortText missing_for_start(const Core& core, const StartView& view) noexcept;

}  // namespace polyturn::kernel
