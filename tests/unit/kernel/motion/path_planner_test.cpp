#include "kernel/motion/path_planner.hpp"

#include <gtest/gtest.h>

#include "planner_rig.hpp"

namespace polyturn::kernel {
namespace {

TEST(PathPlanner, KeepsLimitsOnRandomRecords) {
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        SCOPED_TRACE(seed);
        PlannerRig rig;
        const Judged judged = rig.drive(random_records(seed, 60));
        ASSERT_EQ(judged.fault, "");
    }
}

TEST(PathPlanner, KeepsLimitsWhenOverridesHoldsAndSingleBlockComeAtAnyTick) {
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        SCOPED_TRACE(seed);
        PlannerRig rig;
        std::mt19937_64 random(seed * 77);
        rig.operate = [&](std::int64_t, PathInput& input) {
            const auto dice = random() % 1000;
            if (dice < 5) input.feed_override = static_cast<double>(random() % 201) / 100;
            else if (dice < 8) input.rapid_override = static_cast<double>(random() % 101) / 100;
            else if (dice < 11) input.hold = true;
            else if (dice < 40) input.hold = false;
            else if (dice < 43) input.single_block = !input.single_block;
            if (dice < 30) input.feed_override = std::max(input.feed_override, 0.05);
            if (dice < 30) input.rapid_override = std::max(input.rapid_override, 0.05);
        };
        const Judged judged = rig.drive(random_records(seed, 40));
        ASSERT_EQ(judged.fault, "");
    }
}

}  // namespace
}  // namespace polyturn::kernel
