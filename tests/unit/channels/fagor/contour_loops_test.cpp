// Loops and collisions of a compensated contour: fagor_8037t part 1, 8.3.
#include "channels/fagor/contour_loops.hpp"

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
        e.from = p[0], e.to = p[1];
        all.push_back(e);
    }
    return all;
}

constexpr int kRight = -1;

TEST(ContourLoops, ASlotNarrowerThanTheNoseIsLeftOut) {
    const auto slot = [](double width) { return lines({{10, 30}, {-10, 30}, {-10, 26}, {-10 - width, 26}, {-10 - width, 30}, {-60, 30}}); };
    const auto found = find_loops(slot(2), 3.0, kRight, 5);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].before, 0u);
    EXPECT_EQ(found[0].after, 4u);
    EXPECT_FALSE(found[0].meeting);   // one line before and behind
    EXPECT_TRUE(find_loops(slot(10), 3.0, kRight, 5).empty());
    EXPECT_TRUE(find_loops(slot(2), 0.5, kRight, 5).empty());
    EXPECT_TRUE(find_loops(slot(2), 3.0, kRight, 2).empty()) << "further ahead than the window";
}

TEST(ContourLoops, AContourThatCrossesItselfIsCutOffThere) {
    const auto found = find_loops(lines({{10, 0}, {-10, 0}, {-10, 10}, {0, 10}, {0, -10}}), 1.0, kRight, 10);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].before, 0u);
    EXPECT_EQ(found[0].after, 3u);
    ASSERT_TRUE(found[0].meeting);
    EXPECT_NEAR(found[0].meeting->z, 0.0, 1e-9);
    EXPECT_NEAR(found[0].meeting->x, 0.0, 1e-9);
}

TEST(ContourLoops, NeighboursMeetWhereTheirLinesDo) {
    // A groove between two slopes: they meet above its mouth.
    const auto found = find_loops(lines({{20, 20}, {2, 29}, {2, 24}, {0, 24}, {0, 30}, {-20, 20}}), 3.0, kRight, 10);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].after - found[0].before, 4u);
    ASSERT_TRUE(found[0].meeting);
    EXPECT_NEAR(found[0].meeting->z, 0.0, 1e-9);
    EXPECT_NEAR(found[0].meeting->x, 30.0, 1e-9);
}

TEST(ContourLoops, TheNoseDoesNotFitIntoASmallArc) {
    auto all = lines({{10, 30}, {0, 30}, {0, 30}, {-20, 30}});
    Element& arc = all[1];
    arc.form = Element::Form::ArcCw;   // a dent of radius 1, the nose inside of it
    arc.from = {1, 30}, arc.to = {-1, 30}, arc.centre = {0, 30};
    arc.radius = 1, arc.first_angle = 0, arc.sweep = -std::numbers::pi;
    all[0].to = arc.from, all[2].from = arc.to;
    const auto found = find_loops(all, 3.0, kRight, 3);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].after, 2u);
    EXPECT_TRUE(find_loops(all, 0.9, kRight, 3).empty());
}

TEST(ContourLoops, AClosedContourIsNoLoop) {
    EXPECT_TRUE(find_loops(lines({{0, 10}, {-20, 10}, {-20, -10}, {0, -10}, {0, 10}}), 3.0, kRight, 50).empty());
}

}  // namespace
}  // namespace polyturn::channels::fagor
