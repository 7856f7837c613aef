// What a parameter is, and the typed handle through which the machine reads it. A handle is a
// constant of the program, generated from parameters.csv (polyturn/parameter_handles.hpp in the
// build tree): reading through it is one array access, without a search, so that the cyclic thread
// may do it at every tick.
#pragma once

#include <cstdint>

#include "ipc/capacities.hpp"

namespace polyturn::params {

// What a parameter exists once per. The letter is written before the index: L1, T1, A3, S2.
enum class Scope : std::uint8_t { Global, Group, Channel, Axis, Spindle };

enum class Type : std::uint8_t {
    Bits,  // eight flags #0..#7 in one value 0..255
    Int,   // whole number; the row says whether it may be negative
    Real,  // finite double in the unit that the row names
    Text,  // up to kTextCapacity bytes of UTF-8
};

// When a changed value is first used.
enum class Effect : std::uint8_t {
    Tick,  // at the next tick
    // when the channel concerned is next at a barrier: what it has already pushed keeps the old
    // value
    Barrier,
    Restart,  // at the next start of the controller
};

// Who may change it. Each level may also do what stands before it.
enum class Protection : std::uint8_t { Operator, Setter, Maker };

constexpr unsigned instances(Scope scope) noexcept {
    switch (scope) {
        case Scope::Group:
            return static_cast<unsigned>(kMaxGroups);
        case Scope::Channel:
            return static_cast<unsigned>(kMaxChannels);
        case Scope::Axis:
            return static_cast<unsigned>(kMaxAxes);
        case Scope::Spindle:
            return static_cast<unsigned>(kMaxSpindles);
        case Scope::Global:
            break;
    }
    return 1;
}

// The letter of a scope, 0 for the global one.
constexpr char scope_letter(Scope scope) noexcept {
    switch (scope) {
        case Scope::Group:
            return 'T';
        case Scope::Channel:
            return 'L';
        case Scope::Axis:
            return 'A';
        case Scope::Spindle:
            return 'S';
        case Scope::Global:
            break;
    }
    return '\0';
}

// One parameter of the table, its scope and type known to the compiler: a spindle parameter read
// with a text handle, or a global one read with an index, does not compile.
template <Scope kScopeOf, Type kTypeOf>
struct Handle {
    static constexpr Scope kScope = kScopeOf;
    static constexpr Type kType = kTypeOf;
    std::uint32_t first_slot;  // of instance 1, element 0
    std::uint16_t row;         // index in rows()
    // elements per instance; 1 unless the name is indexed, as in MD20150[5]
    std::uint16_t array;
    // how many alike rows begin here: 8 at the first of eight gear ranges
    std::uint16_t series;
};

// Number `n` (from 1) of the series that begins at `first`: nth(n0650_r1_s_max, 3) is the row for
// gear range 3. The generator lays alike rows with consecutive numbers side by side. n outside the
// series is our mistake and traps.
template <Scope kScope, Type kType>
constexpr Handle<kScope, kType> nth(Handle<kScope, kType> first, unsigned n) noexcept {
    if (n < 1 || n > first.series) __builtin_trap();
    return {
        static_cast<std::uint32_t>(first.first_slot + (n - 1) * instances(kScope) * first.array),
        static_cast<std::uint16_t>(first.row + n - 1), first.array,
        static_cast<std::uint16_t>(first.series - (n - 1))};
}

}  // namespace polyturn::params
