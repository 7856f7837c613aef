// The equidistant of a contour where the contour has less room than the distance. Points are (z, x)
// in radii; the contours come from +Z along -Z, the tool is outside, right of them.
#include "channels/cycles/contour_offset.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_contour.hpp"

namespace polyturn::channels::cycles {
namespace {

using testing::Drawn;
using testing::number;
using testing::shown;

TEST(ContourOffset, KeepsAnInnerArcThatHasRoom) {
    const Drawn part =
        Drawn({0, 10}).line({-10, 10}).arc({-12, 12}, {-10, 12}, true).line({-12, 30});
    EXPECT_EQ(shown(equidistant(part.contour(), 1, -1)),
              "0.000,11.000 -10.000,11.000 cw1.000:-11.000,12.000 -11.000,30.000");
}

// The lines on both sides of the arc meet: x = 10 + 3, z = -12 + 3.
TEST(ContourOffset, LeavesOutAnInnerArcSmallerThanTheDistance) {
    const Drawn part =
        Drawn({0, 10}).line({-10, 10}).arc({-12, 12}, {-10, 12}, true).line({-12, 30});
    EXPECT_EQ(shown(equidistant(part.contour(), 3, -1)),
              "0.000,13.000 -9.000,13.000 -9.000,30.000");
}

// A step of 1: the line x = 13 ends on the arc about the step's corner, z = -10 + sqrt(3 * 3 - 2 *
// 2).
TEST(ContourOffset, ClimbsAStepLowerThanTheDistanceOnTheArcAboutItsCorner) {
    const Drawn part = Drawn({0, 10}).line({-10, 10}).line({-10, 11}).line({-20, 11});
    EXPECT_EQ(shown(equidistant(part.contour(), 3, -1)),
              "0.000,13.000 -7.764,13.000 ccw3.000:-10.000,14.000 -20.000,14.000");
}

// A chamfer of 1 in an inner corner: the distance 4 leaves it no room.
TEST(ContourOffset, LeavesOutAChamferBetweenTwoInnerCorners) {
    const Drawn part = Drawn({0, 10}).line({-10, 10}).line({-11, 11}).line({-11, 30});
    EXPECT_EQ(shown(equidistant(part.contour(), 4, -1)),
              "0.000,14.000 -7.000,14.000 -7.000,30.000");
}

// Between inner arc and outer arc, tangential: line x = 15 + 4 meets the circle about (-16, 17) of
// radius 2 + 4.
TEST(ContourOffset, JoinsAcrossAnArcThatDisappears) {
    const Drawn part = Drawn({0, 15})
                           .line({-12, 15})
                           .arc({-14, 17}, {-12, 17}, true)
                           .arc({-16, 19}, {-16, 17}, false)
                           .line({-30, 19});
    EXPECT_EQ(shown(equidistant(part.contour(), 4, -1)),
              "0.000,19.000 " + number(-16 + std::sqrt(32.0)) +
                  ",19.000 ccw6.000:-16.000,23.000 -30.000,23.000");
}

// The call point (1, 25) lies on the other side of the chord than the recess in which the tool
// works.
TEST(ContourOffset, IsOnTheSideOfTheInfeed) {
    const Drawn recess = Drawn({0, 20}).line({-5, 20}).line({-5, 5});
    EXPECT_EQ(side_towards(recess.contour(), {1, 25}, false), 1);
    const Drawn shaft = Drawn({0, 10}).line({-10, 10}).line({-20, 20});
    EXPECT_EQ(side_towards(shaft.contour(), {5, 25}, true), -1);
    EXPECT_EQ(side_towards(shaft.contour(), {5, 4}, true), 1);  // boring
    const Drawn wall = Drawn({0, 10}).line({0, 20});
    EXPECT_EQ(side_towards(wall.contour(), {5, 25}, true), -1);  // no way along Z: by its line
}

// An inner arc of 1 at the start, then up: the arc about the corner (-1, 11) begins where it is 3
// away from the first point too.
TEST(ContourOffset, BeginsInItsDistanceFromTheFirstPoint) {
    const Drawn part = Drawn({0, 10}).arc({-1, 11}, {0, 11}, true).line({-10, 11});
    const Contour out = equidistant(part.contour(), 3, -1);
    ASSERT_FALSE(out.elements.empty());
    EXPECT_GT(std::hypot(out.first.z, out.first.x - 10), 3 - 1e-3) << shown(out);
    EXPECT_EQ(shown(out).substr(shown(out).find(' ')), " ccw3.000:-1.000,14.000 -10.000,14.000");
}

TEST(ContourOffset, EndsWhereTheContourComesBeyondABound) {
    const Drawn part = Drawn({0, 10}).line({-10, 10}).line({-20, 20});
    EXPECT_EQ(shown(without_end_beyond(part.contour(), true, 1, 16)),
              "0.000,10.000 -10.000,10.000 -16.000,16.000");
    EXPECT_EQ(shown(without_end_beyond(part.contour(), true, 1, 20)),
              "0.000,10.000 -10.000,10.000 -20.000,20.000");
    EXPECT_EQ(shown(without_end_beyond(part.contour(), true, 1, 9)), "nothing");
}

}  // namespace
}  // namespace polyturn::channels::cycles
