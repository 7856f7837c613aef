// The stroke ranges (N1000 to N1009) as the channel and the kernel judge them
// (ipc/path/stroke_zones.hpp), in the work area's coordinates: where the carrier of a channel may
// be in X and Z, and the boxes it must stay out of. An axis without reference, or detached, has
// none: there the kernel judges nothing either.
#pragma once
#include <vector>

#include "hmi/machine/bodies/room_view.hpp"

namespace polyturn::hmi {

struct ShownStroke {
    struct Area {
        double xLow, xHigh, zLow, zHigh;  // in the work area; infinite where nothing ends it
        bool operator==(const Area&) const = default;
    };
    unsigned channel = 0;
    Area allowed{};
    std::vector<std::pair<unsigned, Area>> forbidden;  // range 2 or 3, and where
    bool operator==(const ShownStroke&) const = default;
};

// Of each channel whose carrier has a position; as far as the tip of its tool in work may go,
// where that is known, else its own point. The other axes of the channel stand where they stand
// now. Rounded to hundredths: the same picture while nothing has changed.
std::vector<ShownStroke> shownStrokes(const Live& live, const RoomView& room, const RoomNow& now);

}  // namespace polyturn::hmi
