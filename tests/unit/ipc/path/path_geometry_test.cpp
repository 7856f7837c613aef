#include "ipc/path/path_geometry.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace polyturn {
namespace {

void set_kind(PathRecord& r, RecordKind kind) { r.kind = static_cast<std::uint8_t>(kind); }

PathRecord quarter_arc(double radius_end) {
    PathRecord r;
    set_kind(r, RecordKind::Arc);
    r.axis_count = 3;
    r.plane = {0, 2, 0, 0};
    r.shape[arc_shape::kCentreP] = 5;
    r.shape[arc_shape::kCentreQ] = -3;
    r.shape[arc_shape::kRadius] = 4;
    r.shape[arc_shape::kStartAngle] = 0.3;
    r.shape[arc_shape::kSweep] = -std::numbers::pi / 2;
    r.shape[arc_shape::kRadiusEnd] = radius_end;
    const double a0 = 0.3, a1 = 0.3 - std::numbers::pi / 2;
    r.start = {5 + 4 * std::cos(a0), 7, -3 + 4 * std::sin(a0)};
    r.end = {5 + radius_end * std::cos(a1), 9, -3 + radius_end * std::sin(a1)};
    r.length = 6.5;
    return r;
}

PathRecord curve() {
    PathRecord r;
    set_kind(r, RecordKind::Curve);
    r.axis_count = 2;
    for (std::size_t k = 0; k < 6; ++k) {
        r.shape[k] = 1.0 / static_cast<double>(k + 1);
        r.shape[6 + k] = k % 2 ? 2.0 : -1.5;
    }
    r.shape[curve_shape::kParameter + 1] = 0.5;
    r.shape[curve_shape::kParameter + 3] = 0.1;
    r.shape[curve_shape::kParameter + 5] = 0.02;
    r.length = 1.3;
    SlotVector at;
    position_at(r, 1.3 - 1e-15, at);
    for (std::size_t i = 0; i < 2; ++i) {
        r.start[i] = r.shape[6 * i];
        r.end[i] = at[i];
    }
    return r;
}

// Oracle: central differences of position_at, and of the derivative below for the higher ones.
void expect_derivatives_match(const PathRecord& r) {
    const double h = 1e-4;
    for (double s = 0.05; s < r.length - 0.05; s += r.length / 23) {
        SlotVector before, after;
        position_at(r, s - h, before);
        position_at(r, s + h, after);
        PathDerivatives at, low, high;
        derivatives_at(r, s, at);
        derivatives_at(r, s - h, low);
        derivatives_at(r, s + h, high);
        for (std::size_t i = 0; i < r.axis_count; ++i) {
            EXPECT_NEAR(at.first[i], (after[i] - before[i]) / (2 * h),
                        1e-6 * (1 + std::abs(at.third[i])))
                << "slot " << i << " s " << s;
            EXPECT_NEAR(at.second[i], (high.first[i] - low.first[i]) / (2 * h),
                        1e-6 * (1 + std::abs(at.third[i])))
                << "slot " << i << " s " << s;
            EXPECT_NEAR(at.third[i], (high.second[i] - low.second[i]) / (2 * h),
                        1e-5 * (1 + std::abs(at.third[i])))
                << "slot " << i << " s " << s;
        }
    }
}

TEST(PathGeometry, ALineIsStraightAndMeetsItsEndsExactly) {
    PathRecord r;
    set_kind(r, RecordKind::Line);
    r.axis_count = 3;
    r.start = {1, 2, 3};
    r.end = {1.1, -7, 3.7};
    r.length = 9.1;
    SlotVector p;
    position_at(r, 0, p);
    EXPECT_EQ(p[1], 2);
    position_at(r, 9.1, p);
    EXPECT_EQ(p[0], 1.1);
    EXPECT_EQ(p[1], -7);
    position_at(r, 4.55, p);
    EXPECT_NEAR(p[2], 3.35, 1e-12);
    position_at(r, 20, p);
    EXPECT_EQ(p[0], 1.1);
    expect_derivatives_match(r);
}

TEST(PathGeometry, DerivativesOfAnArcMatchDifferences) { expect_derivatives_match(quarter_arc(4)); }

TEST(PathGeometry, DerivativesOfASpiralMatchDifferencesWithAndWithoutItsParameter) {
    PathRecord r = quarter_arc(4.02);
    expect_derivatives_match(r);
    r.shape[curve_shape::kParameter + 1] = 0.9 / r.length;
    r.shape[curve_shape::kParameter + 2] = 0.1 / (r.length * r.length);
    expect_derivatives_match(r);
}

TEST(PathGeometry, DerivativesOfACurveMatchDifferences) { expect_derivatives_match(curve()); }

TEST(PathGeometry, AnArcTurnsOnItsCircle) {
    const PathRecord r = quarter_arc(4);
    SlotVector p;
    for (double s = 0; s <= r.length; s += 0.5) {
        position_at(r, s, p);
        EXPECT_NEAR(std::hypot(p[0] - 5, p[2] + 3), 4, 1e-12);
    }
    position_at(r, r.length, p);
    EXPECT_EQ(p[0], r.end[0]);
}

TEST(PathGeometry, ARecordWithoutLengthStaysWhereItIs) {
    PathRecord r;
    set_kind(r, RecordKind::Line);
    r.axis_count = 1;
    r.start = {4};
    r.end = {4};
    SlotVector p{};
    position_at(r, 0, p);
    EXPECT_EQ(p[0], 4);
    PathDerivatives d;
    derivatives_at(r, 0, d);
    EXPECT_EQ(d.first[0], 0);
}

}  // namespace
}  // namespace polyturn
