// A closed inner contour whose two elements meet twice (sinumerik_part2 11.1, SD42496).
#include <gtest/gtest.h>

#include "channels/compensation/element.hpp"

namespace polyturn::channels::compensation {
namespace {

// A lens: over the top from (-8, 0) to (8, 0) about (0, -6), back below about (0, 6); the nose
// inside it, right of the path. Its centre runs on circles of 10 - 2 about the same centres: they
// meet at p = +-sqrt(8 * 8 - 6 * 6), q = 0.
struct Lens {
    Element over, under;
};
Lens lens(double gap) {
    const auto turn = [](Vec from, Vec to, Vec centre) {
        const Vec a = from - centre, b = to - centre;
        Element e = arc(from, to, centre, std::atan2(cross(a, b), dot(a, b)));
        e.nose = 2;
        e.side = -1;
        return e;
    };
    return {turn({-8, 0}, {8, 0}, {0, -6}), turn({8, 0}, {-8 + gap, 0}, {gap / 2, 6})};
}

TEST(ClosedContour, MeetsAtTheEndOrAtTheBeginningOfItsFirstElement) {
    const Lens closed = lens(0);
    const double p = std::sqrt(28.0);
    const auto at_end = closed_meeting_point(closed.over, closed.under, false),
               at_start = closed_meeting_point(closed.over, closed.under, true);
    ASSERT_TRUE(at_end && at_start);
    EXPECT_NEAR(at_end->p + 8, p, 1e-9);
    EXPECT_NEAR(at_start->p + 8, -p, 1e-9);
    EXPECT_NEAR(at_end->q, 0, 1e-9);
    EXPECT_NEAR(at_start->q, 0, 1e-9);
}

// Almost closed: nearer than a tenth of the nose's radius.
TEST(ClosedContour, IsOneOnlyWhereItsEndsAreNear) {
    EXPECT_TRUE(closed_meeting_point(lens(0.15).over, lens(0.15).under, true));
    EXPECT_FALSE(closed_meeting_point(lens(0.25).over, lens(0.25).under, true));
    Element a = line({0, 0}, {10, 0}), b = line({10, 0}, {0, 0.01});
    a.nose = b.nose = 1;
    EXPECT_FALSE(closed_meeting_point(a, b, true));  // two lines meet once
}

}  // namespace
}  // namespace polyturn::channels::compensation
