// The G codes of the language fagor, one row each: number, modal group, words, handler (fagor_8037t
// part 1, 5.1; part 2, 9).
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace polyturn::channels::fagor {

struct Execution;

// The order of the groups is the order in which they act within a block: units before everything
// that is measured, the plane and the dimensions before points, feed and spindle before motion,
// what changes the place of points before the points. At most one code of a group in a block, but
// mirrors combine.
enum class GGroup : std::uint8_t {
    Units,
    XFormat,
    Plane,
    Distance,
    Feed,
    Spindle,
    Corner,
    Mirror,
    Comp,
    Modifier,  // G06 G08 G09: how the arc of this block is given
    Element,   // G36 G37 G38 G39: what happens at the end of this block
    Machine,   // G53
    OneShot,   // acts by itself
    Cycle,
    Motion,
    Count
};

struct GCode {
    std::uint16_t number;
    GGroup group;
    // nullptr: nothing to do but to hold; false: a fault is noted
    bool (*act)(Execution&, const GCode&);
    std::string_view takes;  // letters of words; 'x': the axes of the channel
    // the word that belongs to it when it stands directly behind: R, N; 0 none
    char binds;
    bool alone;  // nothing else in the block
    bool modal;
    std::string_view text;
};

std::span<const GCode> g_codes();
const GCode* find_g_code(unsigned number);  // nullptr: there is none

constexpr std::uint32_t letter_bit(char letter) {
    return letter >= 'A' && letter <= 'Z' ? 1u << (letter - 'A') : 0u;
}
constexpr std::uint32_t letter_set(std::string_view letters) {
    std::uint32_t set = 0;
    for (const char letter : letters) set |= letter_bit(letter);
    return set;
}

}  // namespace polyturn::channels::fagor
