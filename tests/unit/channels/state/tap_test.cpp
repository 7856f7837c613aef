// Rigid taps: only the moves of the tap itself turn the spindle along (sinumerik part 2 10.11.1,
// nct part 1 15.6).
#include <gtest/gtest.h>

#include "core_rig.hpp"

namespace polyturn::channels::testing {
namespace {

struct Tapper : CoreRig {
    Tapper() {
        core->path.spindle.spindle = 1;
        core->path.spindle.rpm = 300;
        core->path.tap_axis = static_cast<std::uint8_t>(z);
        core->path.tap_depth_sign = -1.0;
    }
    double turns() { return sink.moves().back().move.tap_turns; }
};

TEST(Tap, TurnsInAndOut) {
    Tapper rig;
    rig.core->path.tap_pitch = 2.0;
    ASSERT_TRUE(rig.line(0, -10));
    EXPECT_DOUBLE_EQ(rig.turns(), 5.0);
    ASSERT_TRUE(rig.line(0, 0));
    EXPECT_DOUBLE_EQ(rig.turns(), -5.0);
}

TEST(Tap, MovesBehindItLeaveTheSpindleAlone) {
    Tapper rig;
    rig.core->path.tap_pitch = 2.0;
    ASSERT_TRUE(rig.line(0, -10));
    ASSERT_TRUE(rig.line(0, 0));
    rig.core->path.tap_pitch = 0.0;
    ASSERT_TRUE(rig.line(20, 0));
    EXPECT_EQ(rig.turns(), 0.0);
    ASSERT_TRUE(rig.arc(30, -10, 30, 0, true));
    EXPECT_EQ(rig.turns(), 0.0);
}

}  // namespace
}  // namespace polyturn::channels::testing
