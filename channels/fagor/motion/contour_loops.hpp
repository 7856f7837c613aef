// Loops and collisions of a contour that is about to be compensated (fagor_8037t part 1, 8.3):
// which of its elements the nose cannot come to without cutting into others of the next N, and
// where the path goes on instead.
//
//        A          E            B C D are a slot narrower than the nose: they are left out. A ends, and E begins, where
//   ----------.  .--------       the two meet (here on one line); a contour that crosses itself is cut off at the crossing.
//          B  |  | D
//             '--' C
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "channels/compensation/options.hpp"
#include "channels/cycles/contour.hpp"

namespace polyturn::channels::fagor {

struct ContourLoop {
    std::size_t before = 0, after = 0;  // the elements between them are left out
    // where `before` ends; nothing: where it is programmed to end
    std::optional<cycles::Point> meeting;
};

struct Nose {
    double radius = 0.0;
    int side = 0;  // +1 left of the path, -1 right of it
    // how it gets round an outer one
    compensation::Corner corner = compensation::Corner::Intersection;
};

// window: so many elements are looked at together.
std::vector<ContourLoop> find_loops(const std::vector<cycles::Element>& elements, const Nose& nose,
                                    std::size_t window);

// The same contour without them.
std::vector<cycles::Element> without_loops(std::vector<cycles::Element> elements,
                                           const std::vector<ContourLoop>& loops);

}  // namespace polyturn::channels::fagor
