// Where the axes of a channel may be: stroke range 1 (sets A and B), range 2 (inside or outside),
// range 3 (inside), and what the PLC selects or switches off (nct_parameters_part1 11). The channel
// asks before it delivers a move, the kernel while it is driven; both must mean the same.
//
//   forbidden outside   each axis by itself has an interval [low, high]: range 1, and range 2 with
//                       N1001 EXT
//   forbidden inside    ranges 2 and 3: a place is forbidden only if every axis that is enabled for
//                       the range lies inside its own interval: a box in the space of the channel's
//                       axes
//
// Machine coordinates, mm (X as a radius) and degrees. Exactly on a limit is allowed.
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "ipc/capacities.hpp"
#include "ipc/params/table.hpp"

namespace polyturn {

struct StrokeInterval {
    double low = 0, high = 0;
};

// N1000, N1002 to N1009 of an axis, and F1322 where it is used.
struct AxisStroke {
    bool range1 = false, range2 = false, range3 = false;
    StrokeInterval a, b, second, third;
    bool any() const noexcept { return range1 || range2 || range3; }
};

// N1001 of a channel.
struct ChannelStroke {
    bool second_outside = false;  // EXT: range 2 is forbidden outside
    bool second_watched = false;  // STE
    // CBM: the end of a block is judged before it begins. The text prints the polarity the other
    // way round; its name and SKD decide (part 1, 11.2). This is the only place that knows.
    bool before_move = false;
    bool not_before_skip = false;  // SKD: G31 and G37 are not judged before they begin
    bool by_channel = false;       // ABA: CP_LIMSEL selects the set, not AP_LIMSELP and AP_LIMSELN
};

// from 1
[[nodiscard]] AxisStroke read_axis_stroke(const params::Table& table, unsigned axis) noexcept;
// from 1
[[nodiscard]] ChannelStroke read_channel_stroke(const params::Table& table,
                                                unsigned channel) noexcept;

// What the PLC says: CP_LIMSEL, AP_LIMSELP, AP_LIMSELN, CP_LIM1DIS to CP_LIM3DIS.
struct StrokeFlags {
    bool channel_b = false, positive_b = false, negative_b = false;
    bool first_off = false, second_off = false, third_off = false;
    bool operator==(const StrokeFlags&) const = default;
};

// What holds for one axis now.
struct AxisZone {
    StrokeInterval allowed{-std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::infinity()};
    bool in_box[2] = {false, false};  // takes part in the box of range 2, range 3
    StrokeInterval box[2];
    bool operator==(const AxisZone& other) const noexcept;
};
[[nodiscard]] AxisZone zone_of(const AxisStroke& axis, const ChannelStroke& channel,
                               const StrokeFlags& flags) noexcept;

// All axes of a channel; positions and zones in the same order.
struct StrokeZones {
    unsigned count = 0;
    std::array<AxisZone, kChannelAxes> axes;
};
struct StrokeFault {
    unsigned axis = 0;  // place in the zones
    double limit = 0;
    bool positive = true;  // side of the axis
};
inline constexpr double kOnLimit = 1e-6;  // mm: still on the limit

// Is this place forbidden? Only the `moved` axes (bits) are asked for the intervals; a box counts
// as soon as one of its axes moves.
[[nodiscard]] bool forbidden(const StrokeZones& zones, const double* position, std::uint32_t moved,
                             StrokeFault& fault) noexcept;

// A straight line from `from` to `to`: the part of it (0 to 1) that can be driven before it would
// enter what is forbidden or go further out; 1 when nothing is forbidden on it.
[[nodiscard]] double free_part(const StrokeZones& zones, const double* from, const double* to,
                               StrokeFault& fault) noexcept;

// Which directions of the axis are closed at this place: bit 0 positive, bit 1 negative.
[[nodiscard]] std::uint32_t closed_sides(const StrokeZones& zones, const double* position,
                                         unsigned axis) noexcept;

}  // namespace polyturn
