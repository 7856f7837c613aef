#include "channels/process/coupled_limits.hpp"

#include <gtest/gtest.h>

namespace polyturn::channels {
namespace {

PathLimits limits() {
    PathLimits all;
    for (PathAxis& axis : all.axis) axis = {100, 50, 1000, 800, 1e5, 10, 0, 0, false};
    all.axis[3].rapid = 40;
    all.axis[3].accel = 300;
    return all;
}

TEST(CoupledLimits, AMasterGoesNoFasterThanTheLastSlaveOfItsChain) {
    PathLimits all = limits();
    Couplings couplings;
    couplings.synchronous[2] = 1;  // A3 follows A1
    couplings.synchronous[3] = 3;  // A4 follows A3
    lower_for_couplings(all, couplings);
    EXPECT_EQ(all.axis[0].rapid, 40);
    EXPECT_EQ(all.axis[0].accel, 300);
    EXPECT_EQ(all.axis[1].rapid, 100);
    EXPECT_EQ(all.axis[0].speed_step, 10);
}

TEST(CoupledLimits, WhatIsAddedToAnAxisAndItselfShareItsLimits) {
    PathLimits all = limits();
    Couplings couplings;
    couplings.superimposed[3] = 2;
    lower_for_couplings(all, couplings);
    EXPECT_EQ(all.axis[3].rapid, 20);
    EXPECT_EQ(all.axis[1].rapid, 20);
    EXPECT_EQ(all.axis[1].accel, 150);
    EXPECT_EQ(all.axis[0].rapid, 100);
}

// A4 gets its own way, that of A3 and with it that of A1: all three together are no faster than A4.
TEST(CoupledLimits, AChainOfSuperimposedAxesSharesTheLastLimit) {
    PathLimits all = limits();
    Couplings couplings;
    couplings.superimposed[3] = 3;
    couplings.superimposed[2] = 1;
    lower_for_couplings(all, couplings);
    EXPECT_EQ(all.axis[3].rapid, 20);
    EXPECT_EQ(all.axis[2].rapid, 10);
    EXPECT_EQ(all.axis[0].rapid, 10);
}

TEST(CoupledLimits, WithoutCouplingsNothingChanges) {
    PathLimits all = limits();
    lower_for_couplings(all, {});
    EXPECT_EQ(all.axis[3].rapid, 40);
    EXPECT_EQ(all.axis[0].accel_step, 0);
}

}  // namespace
}  // namespace polyturn::channels
