// The block being read, as Interpreter::classify() has sorted its words: places in Block::words,
// and what they have caused so far.
#pragma once
#include <array>
#include <cstdint>

#include "channels/fanuc/g_codes.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct BlockWords {
    std::array<const GCode*, static_cast<std::size_t>(GGroup::Count)> coded_{};
    std::uint32_t coded_groups_ = 0;
    std::array<std::uint8_t, 12> m_words_{};
    std::array<std::uint8_t, kChannelAxes * 2> axis_words_{};
    // Word::axis of a spindle's address of several letters: place in Settings::spindle_addresses
    static constexpr int kSpindleWord = 64;
    // ... of a spindle's name (S2=3200): place in Settings::spindle_names
    static constexpr int kNamedSpindle = 96;
    bool spindle_words_ = false;  // the block has such words
    unsigned m_count_ = 0, axis_word_count_ = 0, g_count_ = 0;
    std::array<std::uint8_t, 12> g_words_{};
    std::array<std::uint8_t, 2> comma_words_{};
    unsigned comma_count_ = 0;
    // ,A: the direction of a line where A is an axis, or as it is written
    int comma_angle_ = -1;
    bool words_used_ = false;  // a setting of this block has taken the axis words
    AxisValues target_{};
    // called by a code of this block when the block has acted
    std::int64_t sub_program_ = -1, sub_repeats_ = 1;
    std::uint32_t sub_column_ = 0, sub_length_ = 0;  // of that code
    // serial of the block whose calling letters have written their variables; it may be read twice
    std::uint64_t letters_written_in_ = 0;
    std::uint32_t letters_written_ = 0;  // and those letters
    // M97 P: the block of this program that is called when the block has acted
    std::int64_t local_call_ = -1;
    bool moved_ = false;            // the block moved: G66 calls follow
    std::uint32_t fault_line_ = 0;  // 0: the line read last
    // by the macro parser; 0: the letter decides
    std::uint32_t fault_column_ = 0, fault_length_ = 0;
};

}  // namespace polyturn::channels::fanuc
