// Loops and collisions of a compensated contour: fagor_8037t part 1, 8.3.
#include "channels/fagor/motion/contour_loops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polyturn::channels::fagor {
namespace {

using cycles::Element;
using cycles::Point;

std::vector<Element> lines(std::initializer_list<Point> points) {
    std::vector<Element> all;
    for (auto p = points.begin(); p + 1 != points.end(); ++p) {
        Element e;
        e.from = p[0];
        e.to = p[1];
        all.push_back(e);
    }
    return all;
}

constexpr int kRight = -1;

TEST(ContourLoops, ASlotNarrowerThanTheNoseIsLeftOut) {
    const auto slot = [](double width) {
        return lines(
            {{10, 30}, {-10, 30}, {-10, 26}, {-10 - width, 26}, {-10 - width, 30}, {-60, 30}});
    };
    const auto found = find_loops(slot(2), {3.0, kRight}, 5);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].before, 0u);
    EXPECT_EQ(found[0].after, 4u);
    EXPECT_FALSE(found[0].meeting);  // one line before and behind
    EXPECT_TRUE(find_loops(slot(10), {3.0, kRight}, 5).empty());
    EXPECT_TRUE(find_loops(slot(2), {0.5, kRight}, 5).empty());
    EXPECT_TRUE(find_loops(slot(2), {3.0, kRight}, 2).empty()) << "further ahead than the window";
}

TEST(ContourLoops, AContourThatCrossesItselfIsCutOffThere) {
    const auto found =
        find_loops(lines({{10, 0}, {-10, 0}, {-10, 10}, {0, 10}, {0, -10}}), {1.0, kRight}, 10);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].before, 0u);
    EXPECT_EQ(found[0].after, 3u);
    ASSERT_TRUE(found[0].meeting);
    EXPECT_NEAR(found[0].meeting->z, 0.0, 1e-9);
    EXPECT_NEAR(found[0].meeting->x, 0.0, 1e-9);
}

TEST(ContourLoops, NeighboursMeetWhereTheirLinesDo) {
    // A groove between two slopes: they meet above its mouth.
    const auto found = find_loops(lines({{20, 20}, {2, 29}, {2, 24}, {0, 24}, {0, 30}, {-20, 20}}),
                                  {3.0, kRight}, 10);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].after - found[0].before, 4u);
    ASSERT_TRUE(found[0].meeting);
    EXPECT_NEAR(found[0].meeting->z, 0.0, 1e-9);
    EXPECT_NEAR(found[0].meeting->x, 30.0, 1e-9);
}

TEST(ContourLoops, TheNoseDoesNotFitIntoASmallArc) {
    auto all = lines({{10, 30}, {0, 30}, {0, 30}, {-20, 30}});
    Element& arc = all[1];
    arc.form = Element::Form::ArcCw;  // a dent of radius 1, the nose inside of it
    arc.from = {1, 30};
    arc.to = {-1, 30};
    arc.centre = {0, 30};
    arc.radius = 1;
    arc.first_angle = 0;
    arc.sweep = -std::numbers::pi;
    all[0].to = arc.from;
    all[2].from = arc.to;
    const auto found = find_loops(all, {3.0, kRight}, 3);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].after, 2u);
    EXPECT_TRUE(find_loops(all, {0.9, kRight}, 3).empty());
}

// Between two inner corners a line shorter than what they take runs backwards: it is no place for
// the nose however deep it lies.
TEST(ContourLoops, ADeepGrooveNarrowerThanTheNoseIsLeftOut) {
    const auto deep = find_loops(lines({{10, 30}, {0, 30}, {0, 20}, {-2, 20}, {-2, 30}, {-20, 30}}),
                                 {2.0, kRight}, 10);
    ASSERT_EQ(deep.size(), 1u);
    EXPECT_EQ(deep[0].before, 0u);
    EXPECT_EQ(deep[0].after, 4u);
    EXPECT_FALSE(deep[0].meeting);
    const auto vee =
        find_loops(lines({{10, 30}, {0, 30}, {-1, 25}, {-2, 30}, {-20, 30}}), {2.0, kRight}, 10);
    ASSERT_EQ(vee.size(), 1u);
    EXPECT_EQ(vee[0].after, 3u);
    EXPECT_TRUE(
        find_loops(lines({{10, 30}, {0, 30}, {-10, 25}, {-20, 30}, {-30, 30}}), {2.0, kRight}, 10)
            .empty());
    // as wide as the nose
    EXPECT_TRUE(find_loops(lines({{10, 30}, {0, 30}, {0, 20}, {-4, 20}, {-4, 30}, {-20, 30}}),
                           {2.0, kRight}, 10)
                    .empty());
}

TEST(ContourLoops, AConcaveChainOfShortLinesEndsWhereTheLongOnesMeet) {
    // A corner with a chamfer of 1 mm: 45 degrees take .83 at each end of 1.41.
    const auto chamfer =
        find_loops(lines({{10, 30}, {-19, 30}, {-20, 31}, {-20, 60}}), {2.0, kRight}, 10);
    ASSERT_EQ(chamfer.size(), 1u);
    EXPECT_EQ(chamfer[0].after, 2u);
    ASSERT_TRUE(chamfer[0].meeting);
    EXPECT_NEAR(chamfer[0].meeting->z, -20.0, 1e-9);
    EXPECT_NEAR(chamfer[0].meeting->x, 30.0, 1e-9);
    // Three times 30 degrees, which take .80: the second step of 1.4 is too short, and without it
    // so is the first of 1.7: one loop.
    const auto chain =
        find_loops(lines({{10, 30}, {-18, 30}, {-19.472, 30.85}, {-20.172, 32.062}, {-20.172, 60}}),
                   {3.0, kRight}, 10);
    ASSERT_EQ(chain.size(), 1u);
    EXPECT_EQ(chain[0].before, 0u);
    EXPECT_EQ(chain[0].after, 3u);
    ASSERT_TRUE(chain[0].meeting);
    EXPECT_NEAR(chain[0].meeting->z, -20.172, 1e-9);
    EXPECT_NEAR(chain[0].meeting->x, 30.0, 1e-9);
}

TEST(ContourLoops, AGrooveBetweenTwoDiametersKeepsItsHigherShoulder) {
    const auto up = find_loops(lines({{10, 28}, {0, 28}, {0, 24}, {-2, 24}, {-2, 31}, {-20, 31}}),
                               {2.0, kRight}, 10);
    ASSERT_EQ(up.size(), 1u);
    EXPECT_EQ(up[0].before, 0u);
    EXPECT_EQ(up[0].after, 3u);
    ASSERT_TRUE(up[0].meeting);
    EXPECT_NEAR(up[0].meeting->z, -2.0, 1e-9);
    EXPECT_NEAR(up[0].meeting->x, 28.0, 1e-9);
    const auto down = find_loops(lines({{10, 31}, {0, 31}, {0, 24}, {-2, 24}, {-2, 28}, {-20, 28}}),
                                 {2.0, kRight}, 10);
    ASSERT_EQ(down.size(), 1u);
    EXPECT_EQ(down[0].before, 1u);
    EXPECT_EQ(down[0].after, 4u);
    ASSERT_TRUE(down[0].meeting);
    EXPECT_NEAR(down[0].meeting->z, 0.0, 1e-9);
    EXPECT_NEAR(down[0].meeting->x, 28.0, 1e-9);
}

// At an outer corner the way goes on beyond the line: 1 mm between an outer and an inner corner is
// enough, but for arcs about corners.
TEST(ContourLoops, AStepThatTheNoseGetsRoundIsKept) {
    const auto flat = lines({{10, 30}, {0, 30}, {0, 29}, {-10, 29}, {-10, 30}, {-20, 30}});
    EXPECT_TRUE(find_loops(flat, {2, kRight}, 10).empty());
    EXPECT_TRUE(find_loops(flat, {2, kRight, compensation::Corner::Extended}, 10).empty());
    EXPECT_FALSE(find_loops(flat, {2, kRight, compensation::Corner::Arc}, 10).empty());
}

TEST(ContourLoops, ALowStepUpBehindAGrooveIsKept) {
    const auto up = find_loops(
        lines({{10, 30}, {0, 30}, {0, 25}, {-2, 25}, {-2, 30.5}, {-20, 30.5}}), {2, kRight}, 10);
    ASSERT_EQ(up.size(), 1u);
    EXPECT_EQ(up[0].after, 3u);
    ASSERT_TRUE(up[0].meeting);
    EXPECT_NEAR(up[0].meeting->z, -2.0, 1e-9);
    EXPECT_NEAR(up[0].meeting->x, 30.0, 1e-9);
}

TEST(ContourLoops, AStepMayBeProgrammedInPieces) {
    const auto step =
        find_loops(lines({{10, 30}, {0, 30}, {0, 30.5}, {0, 31}, {-20, 31}}), {2, kRight}, 10);
    ASSERT_EQ(step.size(), 1u);
    EXPECT_EQ(step[0].before, 0u);
    EXPECT_EQ(step[0].after, 2u);
    EXPECT_FALSE(step[0].meeting);
}

// G00 suspends compensation (8.2.7): the way back is no part of the contour, and what it crosses is
// none of its loops. The nose stops before it, which leaves nothing of a line shorter than the
// nose.
TEST(ContourLoops, ARapidMoveEndsAContour) {
    const auto back = [](double chamfer) {
        auto all = lines({{10, 30},
                          {-20, 30},
                          {-20 - chamfer, 30 + chamfer},
                          {-20 - chamfer, 60},
                          {0, 60},
                          {0, 20}});
        for (std::size_t k = 2; k < all.size(); ++k) all[k].rapid = true;
        return all;
    };
    EXPECT_TRUE(find_loops(back(3), {2, kRight}, 10).empty());
    const auto found = find_loops(back(1), {2, kRight}, 10);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].before, 0u);
    EXPECT_EQ(found[0].after, 2u);
    ASSERT_TRUE(found[0].meeting);
    EXPECT_NEAR(found[0].meeting->z, -21.0, 1e-9);
}

TEST(ContourLoops, AClosedContourIsNoLoop) {
    EXPECT_TRUE(
        find_loops(lines({{0, 10}, {-20, 10}, {-20, -10}, {0, -10}, {0, 10}}), {3.0, kRight}, 50)
            .empty());
}

}  // namespace
}  // namespace polyturn::channels::fagor
