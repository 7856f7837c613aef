// The block being read, as classify() has sorted its words: places in Block::words, and what they
// have caused so far.
#pragma once
#include <array>
#include <cstdint>

#include "channels/fanuc/g_codes.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

// Word::axis of a spindle's address of several letters: place in Settings::spindle_addresses
inline constexpr int kSpindleWord = 64;
// ... of a spindle's name (S2=3200): place in Settings::spindle_names
inline constexpr int kNamedSpindle = 96;

// A call by a code of this block; it follows when the block has acted.
struct PendingCall {
    std::int64_t program = -1, repeats = 1;
    // M97 P: the block of this program that is called; -1 none
    std::int64_t local = -1;
    std::uint32_t column = 0, length = 0;  // of that code
};

// Where a fault of this block stands; 0: what the alarm names decides.
struct Culprit {
    std::uint32_t line = 0;  // 0: the line read last
    std::uint32_t column = 0, length = 0;
};

struct BlockWords {
    bool has(GGroup group) const { return groups >> static_cast<unsigned>(group) & 1u; }
    // valid where has(group)
    const GCode* row(GGroup group) const { return coded[static_cast<std::size_t>(group)]; }

    std::array<const GCode*, static_cast<std::size_t>(GGroup::Count)> coded{};
    std::uint32_t groups = 0;
    std::array<std::uint8_t, 12> g{}, m{};
    unsigned g_count = 0, m_count = 0;
    std::array<std::uint8_t, kChannelAxes * 2> axes{};
    unsigned axis_count = 0;
    std::array<std::uint8_t, 2> commas{};
    unsigned comma_count = 0;
    // ,A: the direction of a line where A is an axis, or as it is written
    int comma_angle = -1;
    bool spindles = false;  // the block has words of spindles' addresses
    bool used = false;      // a setting of this block has taken the axis words
    AxisValues target{};
    PendingCall call;
    Culprit culprit;
};

}  // namespace polyturn::channels::fanuc
