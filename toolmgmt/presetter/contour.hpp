// The edge of the shadow, point by point, to a fraction of a pixel.
//
//   threshold halfway between shadow and light -> outline of the largest shadow -> at each of its
//   pixels, along the gradient, where the grey crosses the half: that place does not move with the
//   blur of a straight edge
//
// Refused, with the reason: nothing in the picture, no light, too little contrast, an edge that is
// spread over too many pixels.
#pragma once

#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/presetter/shadow_image.hpp"

namespace polyturn::presetter {

struct Point {
    double x = 0, y = 0;  // pixels; the middle of the first pixel is 0, y downwards
};

struct Contour {
    // from one border of the picture to the other, the shadow always on the same side
    std::vector<Point> points;
    bool at_border = false;  // the shadow reaches the border (a tool comes from outside)
    double blur = 0;         // standard deviation of the edge's spread, pixels
    double noise = 0;        // of the grey values in the light
    double contrast = 0;     // light less shadow, grey values
};

Result<Contour> find_contour(const ShadowImage& image);

}  // namespace polyturn::presetter
