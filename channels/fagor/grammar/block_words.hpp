// What classify() has found in the words of the block under way: its G codes by group, the words
// that no code has bound by letter and by axis, its M words. Valid until the next block is read;
// the words themselves lie in TextLine::block.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "channels/fagor/grammar/g_codes.hpp"
#include "channels/fagor/grammar/reader.hpp"
#include "channels/machine_view.hpp"

namespace polyturn::channels::fagor {

struct BlockWords {
    std::array<const GCode*, static_cast<std::size_t>(GGroup::Count)> codes{};
    std::uint32_t letters = 0;  // of words that are not bound to a G code
    std::array<const Word*, 26> by_letter{};
    std::array<const Word*, kChannelAxes> axis{};  // by place
    unsigned axis_count = 0;
    std::array<const Word*, 7> m{};
    unsigned m_count = 0;
    std::uint32_t mirrors = 0;            // G11 G12 G13 of this block: bits 1, 2, 4
    const Word* element = nullptr;        // R of G36 to G39
    const Word* bound_number = nullptr;   // N of G41, G42, G159; K of G04
    const Word* second_centre = nullptr;  // second word of one centre letter (plane XU)
    std::int64_t repeats = -1;            // N at the end of the block
    bool in_machine = false;              // G53 with motion

    bool has(char letter) const { return (letters & letter_bit(letter)) != 0; }
    bool has(GGroup group) const { return code(group) != nullptr; }
    bool has_axes() const { return axis_count != 0; }
    // An axis is named whose letter is not one of these.
    bool has_axes_beside(std::string_view others) const;
    const GCode* code(GGroup group) const { return codes[static_cast<std::size_t>(group)]; }
    const Word* word(char letter) const {
        return by_letter[static_cast<std::size_t>(letter - 'A')];
    }
    double number(char letter) const {
        const Word* w = word(letter);
        return w ? w->value : 0.0;
    }
};

}  // namespace polyturn::channels::fagor
