// A program of tests whose one random test holds for its fixed seed alone: gate_test.py looks
// whether that is found and told.
#include <gtest/gtest.h>

#include "tests/property.hpp"

TEST(Probe, HoldsForItsFixedSeedAlone) { EXPECT_EQ(test_seed(7), 7u); }
TEST(Probe, AsksForNoSeed) {}
PROPERTY(Probe, HoldsAlways, (int a)) { RC_ASSERT(a == a); }
