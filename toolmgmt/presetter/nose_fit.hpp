// A tool's tip as a rounded wedge, fitted to the points of its edge.
//
//              \        /        c  centre of the nose, r its radius
//     flank +   \      /  flank -        b  direction in which the tool points: angle `points_to`
//                \ c  /          h  half the angle between the two outward normals: `half`
//                 '--'
//                   b
//
// Distance of a point: to the circle within the sector of the normals, else to the flank of its
// side.
// Weakness: a flank that is curved within the picture is taken for a straight one; what departs
// from it counts as chips.
#pragma once

#include <Eigen/Core>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/presetter/contour.hpp"

namespace polyturn::presetter {

struct Nose {
    double x = 0, y = 0, r = 0;      // in the units of the points
    double points_to = 0, half = 0;  // rad
    // of x y r points_to half
    Eigen::Matrix<double, 5, 5> covariance = Eigen::Matrix<double, 5, 5>::Zero();
    double deviation = 0;    // of the good points from the model
    double outliers = 0;     // share of the points that belong to chips or dirt
    std::size_t on_arc = 0;  // good points of the nose itself
};

// `pixel`: distance of neighbouring points.
Result<Nose> fit_nose(const std::vector<Point>& points, double pixel);

}  // namespace polyturn::presetter
