#include "kernel/supervisor/check/spindles_known.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace polyturn::supervisor {
namespace {

void meet(SpindlesKnown& known, std::initializer_list<unsigned> channels) {
    const std::vector<unsigned> all(channels);
    known.met(all);
}

TEST(SpindlesKnown, AreLearntAtMeetingsAlsoFromAThirdChannel) {
    SpindlesKnown known;
    known.commanded(1, 1, true);
    EXPECT_EQ(known.turning(1), 1u);
    EXPECT_EQ(known.turning(2), 0u) << "not before they meet";
    meet(known, {1, 2});
    EXPECT_EQ(known.turning(2), 1u);
    EXPECT_EQ(known.turning(3), 0u);
    meet(known, {2, 3});
    EXPECT_EQ(known.turning(3), 1u) << "what L2 knew";
}

TEST(SpindlesKnown, OfTwoCommandsTheLaterOneCounts) {
    SpindlesKnown known;
    known.commanded(1, 2, true);
    meet(known, {1, 2});
    known.commanded(1, 2, false);
    EXPECT_EQ(known.turning(2), 2u) << "L2 has not heard of it";
    meet(known, {1, 2});
    EXPECT_EQ(known.turning(2), 0u);
    known.commanded(2, 2, true);
    meet(known, {2, 1});
    EXPECT_EQ(known.turning(1), 2u);
}

TEST(SpindlesKnown, WhatDoesNotExistIsPassedOver) {
    SpindlesKnown known;
    known.commanded(0, 1, true);
    known.commanded(1, 0, true);
    known.commanded(kMaxChannels + 1, 1, true);
    known.commanded(1, kMaxSpindles + 1, true);
    meet(known, {0, 1, kMaxChannels + 1});
    EXPECT_EQ(known.turning(1), 0u);
    EXPECT_EQ(known.turning(kMaxChannels + 1), 0u);
}

}  // namespace
}  // namespace polyturn::supervisor
