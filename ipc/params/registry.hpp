// The registry: what is known about each parameter, one row per parameter (architecture 8). The
// rows come from parameters.csv, see README.md for its columns; the same row gives the handle, the
// check at import, the HMI's line, the manual's entry and the name in the history. Fixed at build
// time; nothing here is ever written.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/params/handle.hpp"

namespace polyturn::params {

// What a text parameter may hold beside being short enough.
enum class TextRule : std::uint8_t {
    Any,     // printable text
    Choice,  // one of the row's choices
    Ipv4,    // four numbers 0..255 with points, or nothing
};

struct Bit {
    std::uint8_t number;       // 0..7
    std::string_view name;     // DIA
    std::string_view meaning;  // "off: radius; on: diameter"
};

struct Row {
    std::string_view number;  // N0304, PT_HORIZON, F5002, MEFI.80: as written in a parameter line
    std::string_view name;    // Rapid
    std::string_view group;   // Feedrate: where the HMI and the manual list it
    std::string_view unit;    // empty for a plain number
    std::string_view meaning;
    std::string_view acts;  // "yes", or why it has no effect
    Scope scope;
    Type type;
    TextRule text_rule;
    Effect effect;
    Protection protection;
    double min;  // inclusive; for texts the number of characters
    double max;
    // slot of (instance, element) = first_slot + (instance - 1) * array + element
    std::uint32_t first_slot;
    std::uint16_t array;
    std::span<const double> default_numbers;  // one for all elements, or one each; empty for texts
    std::string_view default_text;
    std::span<const Bit> bits;                  // named bits of a bit parameter, ascending
    std::span<const std::string_view> choices;  // TextRule::Choice

    [[nodiscard]] double default_number(unsigned element = 0) const noexcept {
        return default_numbers.size() == 1 ? default_numbers[0] : default_numbers[element];
    }
    // "N0304 Rapid", as the history and the alarms name it.
    [[nodiscard]] std::string title() const;
};

// All rows in the order of the table: by group, numbers ascending.
[[nodiscard]] std::span<const Row> rows() noexcept;

// The row with this number, whatever its case; nullptr when there is none.
[[nodiscard]] const Row* find(std::string_view number) noexcept;

// Up to `count` numbers that look most like `number`, best first: what to propose when find() knows
// nothing.
[[nodiscard]] std::vector<std::string_view> nearest(std::string_view number, std::size_t count = 3);

[[nodiscard]] std::string_view to_string(Scope scope) noexcept;    // "channel"
[[nodiscard]] std::string_view to_string(Type type) noexcept;      // "whole number"
[[nodiscard]] std::string_view to_string(Effect effect) noexcept;  // "barrier"
[[nodiscard]] std::string_view to_string(Protection protection) noexcept;

// Everything about one parameter as lines of text, for `params get` and the manual.
[[nodiscard]] std::string describe(const Row& row);

}  // namespace polyturn::params
