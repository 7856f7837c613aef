#include "kernel/supervisor/status/latency.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace polyturn::supervisor {
namespace {

TEST(Latency, EveryTickIsMeasuredAndNoneIsEarly) {
    const Latency measured = measure_latency(0.05, 500.0);
    ASSERT_EQ(measured.late_us.size(), 100u);
    EXPECT_TRUE(std::is_sorted(measured.late_us.begin(), measured.late_us.end()));
    EXPECT_GE(measured.late_us.front(), 0.0);
}

}  // namespace
}  // namespace polyturn::supervisor
