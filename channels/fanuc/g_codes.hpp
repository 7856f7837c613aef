// The G codes of the fanuc family: one row each, for system A (fanuc lathes by default), systems B
// and C, and nct, which speaks system B. Nothing else in the program knows a G code's number; the
// manual's list is printed from here.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;
using Handler = bool (*)(Execution&, const GCode&);

// At most one code of a group acts in a block (the last one written). The order is the order of
// execution, with reasons.
enum class GGroup : std::uint8_t {
    Units,        // first: all numbers of the block depend on it
    Plane,        // axes of arcs and radii
    Polar,        // points by radius and angle: G15 G16
    Distance,     // absolute or incremental words
    FeedMode,     // before F
    ReturnLevel,  // drilling
    ExactStop,    // holds for this block already
    Surface,      // before S
    Comp,         // nose-radius compensation
    Length,       // length offsets by G codes: G43 G44 G49
    Scale,
    Mirror,
    Rotation,
    StrokeArea,    // G22 G23
    SpindleWatch,  // G25 G26
    Zero,          // work zero of this block's targets
    Drilling,      // canned cycles: G80 ends them before the block moves
    MacroModal,    // G66 G67
    Transform,     // G12.1 G13.1: alone in their block
    OneShot,       // acts in its block only, takes the axis words
    Motion,        // last: everything above holds for it
    Count,
};

// kM: mefi, which has few codes of its own and those that all controls share (kShared).
enum GSystem : std::uint8_t {
    kA = 1,
    kB = 2,
    kC = 4,
    kN = 8,
    kM = 16,
    kAll = 15,
    kShared = 31,
    kBC = 6,
    kBN = 10,
    kABN = 11,
    kBCN = 14,
    kBCNM = 30,
    kFanuc = 7
};

constexpr std::uint32_t bit_of(GGroup group) { return 1u << static_cast<unsigned>(group); }

// What other words and codes of a block must know of a row.
struct Trait {
    enum Bits : std::uint16_t {
        Arc = 1,          // I, J, K are its centre
        Thread = 2,       // F is its lead
        SimpleCycle = 4,  // end point and taper are modal for such cycles together
        CompOn = 8,       // G41, G42
        CompOff = 16,     // I, K beside it say how the contour would go on
        Length = 32,      // H is the number of a length
        Cylinder = 64,    // switches a transformation though it acts in its block only
        Polygon = 128,    // alone in its block
        Preset = 256,     // S is the limit of the spindle's speed
        MacroCall = 512,  // all other words are arguments
    };
};

struct GCode {
    std::string_view name;  // "G50.2"
    std::uint16_t tenths;   // number times ten
    std::uint8_t systems;   // GSystem bits
    GGroup group;
    Handler act;             // what it does in its block; nullptr: this control does not do it yet
    std::string_view takes;  // words it consumes; x: axis words
    bool at_reset;           // the group's state after reset, unless a parameter says otherwise
    std::string_view text;
    std::uint16_t traits = 0;  // Trait bits

    bool is(Trait::Bits trait) const { return (traits & trait) != 0; }
};

std::span<const GCode> g_codes();

// Row of a number in tenths, by system.
class GTable {
public:
    explicit GTable(GSystem system);
    const GCode* find(std::uint32_t tenths) const {
        return tenths < index_.size() && index_[tenths] ? &g_codes()[index_[tenths] - 1u] : nullptr;
    }

private:
    std::array<std::uint8_t, 10000> index_{};
};

}  // namespace polyturn::channels::fanuc
