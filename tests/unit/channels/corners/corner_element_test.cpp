// The geometry of chamfers and roundings: worked examples and what must hold for any two elements.
#include "channels/corners/corner_element.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/property.hpp"

namespace polyturn::channels::corners {
namespace {

using namespace compensation;

double within(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 100'001) / 100'000.0;
}

// An element that ends (or begins) at the origin, with a random direction there.
Element any(bool ends_there) {
    const double angle = within(-std::numbers::pi, std::numbers::pi);
    const Vec dir{std::cos(angle), std::sin(angle)};
    if (*rc::gen::arbitrary<bool>()) {
        const double l = within(2, 60);
        return ends_there ? line((-l) * dir, {}) : line({}, l * dir);
    }
    const double radius = within(3, 50),
                 sweep = (*rc::gen::arbitrary<bool>() ? 1 : -1) * within(0.2, 3.0);
    const Vec centre = (sweep > 0 ? radius : -radius) * left_of(dir);
    const double turn = ends_there ? -sweep : sweep;
    const Vec arm = -1.0 * centre;
    const Vec other = centre + Vec{std::cos(turn) * arm.p - std::sin(turn) * arm.q,
                                   std::sin(turn) * arm.p + std::cos(turn) * arm.q};
    return ends_there ? arc(other, {}, centre, sweep) : arc({}, other, centre, sweep);
}

Vec direction_at(const Element& e, Vec at) {
    return e.arc ? (e.sweep > 0 ? 1.0 : -1.0) * left_of(unit(at - e.centre)) : e.end_dir;
}

TEST(CornerElement, ARightAngle) {
    Corner c;
    ASSERT_EQ(make_corner(line({-10, 0}, {0, 0}), line({0, 0}, {0, 10}), Shape::Rounding, 2, c),
              Fit::Made);
    EXPECT_NEAR(c.from.p, -2, 1e-12);
    EXPECT_NEAR(c.to.q, 2, 1e-12);
    EXPECT_NEAR(c.centre.p, -2, 1e-12);
    EXPECT_NEAR(c.centre.q, 2, 1e-12);
    EXPECT_NEAR(c.sweep, std::numbers::pi / 2, 1e-12);
    ASSERT_EQ(make_corner(line({-10, 0}, {0, 0}), line({0, 0}, {0, 10}), Shape::ChamferLength,
                          2 * std::sqrt(2.0), c),
              Fit::Made);
    EXPECT_NEAR(c.cut_a, 2, 1e-12);
    EXPECT_EQ(
        make_corner(line({-10, 0}, {0, 0}), line({0, 0}, {0, 10}), Shape::ChamferLeg, 10.1, c),
        Fit::TooLarge);
    EXPECT_EQ(make_corner(line({-10, 0}, {0, 0}), line({0, 0}, {9, 0}), Shape::Rounding, 1, c),
              Fit::Smooth);
    EXPECT_EQ(make_corner(line({-10, 0}, {0, 0}), line({0, 0}, {0, 10}), Shape::Rounding, 10, c),
              Fit::Made);
    EXPECT_EQ(
        make_largest_corner(line({-10, 0}, {0, 0}), line({0, 0}, {0, 30}), Shape::Rounding, 15, c),
        Fit::Made);
    EXPECT_NEAR(c.cut_a, 10, 1e-5);
}

PROPERTY(CornerElement, ARoundingIsTangentAndLiesOnBothElements, ()) {
    const Element a = any(true), b = any(false);
    const double radius = within(0.1, 10);
    Corner c;
    RC_PRE(make_corner(a, b, Shape::Rounding, radius, c) == Fit::Made);
    RC_ASSERT(std::fabs(length(c.from - c.centre) - radius) < 1e-6);
    RC_ASSERT(std::fabs(length(c.to - c.centre) - radius) < 1e-6);
    RC_ASSERT(length(point_before_end(a, c.cut_a) - c.from) < 1e-5);
    RC_ASSERT(length(point_behind_start(b, c.cut_b) - c.to) < 1e-5);
    const double turn = c.sweep > 0 ? 1.0 : -1.0;
    const Vec begins = turn * left_of((1 / radius) * (c.from - c.centre)),
              ends = turn * left_of((1 / radius) * (c.to - c.centre));
    RC_ASSERT(length(begins - direction_at(a, c.from)) < 1e-5);
    RC_ASSERT(length(ends - direction_at(b, c.to)) < 1e-5);
    RC_ASSERT(c.cut_a <= path_length(a) + 1e-5);
    RC_ASSERT(c.cut_b <= path_length(b) + 1e-5);
}

PROPERTY(CornerElement, AChamferHasItsLengthsAndIsSymmetrical, ()) {
    const Element a = any(true), b = any(false);
    const double size = within(0.1, 5);
    Corner c;
    if (make_corner(a, b, Shape::ChamferLength, size, c) == Fit::Made) {
        RC_ASSERT(std::fabs(length(c.to - c.from) - size) < 1e-6);
        RC_ASSERT(std::fabs(c.cut_a - c.cut_b) < 1e-9);
    }
    if (make_corner(a, b, Shape::ChamferLeg, size, c) == Fit::Made) {
        RC_ASSERT(c.cut_a == size);
        RC_ASSERT(c.cut_b == size);
        RC_ASSERT(length(point_before_end(a, size) - c.from) < 1e-9);
    }
}

PROPERTY(CornerElement, TheLargestThatFitsUsesUpOneElement, ()) {
    const Element a = any(true), b = any(false);
    const double turn =
        std::fabs(std::atan2(cross(a.end_dir, b.start_dir), dot(a.end_dir, b.start_dir)));
    RC_PRE(!a.arc && !b.arc && turn > 0.1 && turn < 3.0);
    const Shape shape = *rc::gen::element(Shape::Rounding, Shape::ChamferLeg, Shape::ChamferLength);
    Corner c;
    RC_PRE(make_corner(a, b, shape, 2000, c) == Fit::TooLarge);
    RC_ASSERT(make_largest_corner(a, b, shape, 2000, c) == Fit::Made);
    RC_ASSERT(std::fmin(path_length(a) - c.cut_a, path_length(b) - c.cut_b) < 1e-4);
}

}  // namespace
}  // namespace polyturn::channels::corners
