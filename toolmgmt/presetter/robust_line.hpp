// The straight line that most points of a set lie on, whatever chips and dirt the others belong to.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "toolmgmt/presetter/contour.hpp"

namespace polyturn::presetter {

struct Line {
    double nx = 1, ny = 0, d = 0;  // nx x + ny y = d; (nx, ny) of length 1
    std::vector<std::size_t> on;   // indices of the points that lie on it
    double deviation = 0;          // standard deviation of those from it
    double distance(const Point& p) const { return nx * p.x + ny * p.y - d; }
};

// `tolerance`: how far a point may lie from the line that it belongs to. The same points give the
// same line.
std::optional<Line> robust_line(const std::vector<Point>& points, double tolerance);

}  // namespace polyturn::presetter
