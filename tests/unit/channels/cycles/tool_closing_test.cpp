// What a tool cannot reach is closed; the rest of the contour stays as it is (fagor_8037t part 2,
// 9.1.5).
#include "channels/cycles/tool_closing.hpp"

#include <gtest/gtest.h>

#include "drawn_contour.hpp"

namespace polyturn::channels::cycles {
namespace {

using testing::Drawn;
using testing::number;
using testing::shown;

// Trailing flank 30 degrees: behind the wall at Z-8 a line leads down 2 mm within 2 / tan 30. The
// arc before it stays one.
TEST(ToolClosing, LeavesArcsBesideAHollowAsTheyAre) {
    const Drawn part = Drawn({0, 10})
                           .arc({-4, 14}, {-4, 10}, false)
                           .line({-8, 14})
                           .line({-8, 12})
                           .line({-20, 12})
                           .line({-20, 16});
    bool changed = false;
    EXPECT_EQ(shown(closed_for(part.contour(), false, -1, 1, {30, 95}, changed)),
              "0.000,10.000 ccw4.000:-4.000,14.000 -8.000,14.000 " +
                  number(-8 - 2 * std::sqrt(3.0)) + ",12.000 -20.000,12.000 -20.000,16.000");
    EXPECT_TRUE(changed);
}

// Leading flank 60 degrees, seen from the other end: the wall at Z-20 is reached by a line of 4 mm
// within 4 / tan 60.
TEST(ToolClosing, ClosesWallsSteeperThanTheLeadingFlank) {
    const Drawn part = Drawn({0, 10})
                           .arc({-4, 14}, {-4, 10}, false)
                           .line({-20, 14})
                           .line({-20, 18})
                           .line({-30, 18});
    bool changed = false;
    const std::string closed = shown(closed_for(part.contour(), false, -1, 1, {120, 60}, changed));
    EXPECT_NE(
        closed.find(number(-20 + 4 / std::sqrt(3.0)) + ",14.000 -20.000,18.000 -30.000,18.000"),
        std::string::npos)
        << closed;
    EXPECT_TRUE(changed);
}

TEST(ToolClosing, ChangesNothingThatIsReached) {
    const Drawn part = Drawn({0, 10}).line({-10, 10}).line({-14, 14}).line({-20, 12});
    bool changed = true;
    EXPECT_EQ(shown(closed_for(part.contour(), false, -1, 1, {30, 95}, changed)),
              shown(part.contour()));
    EXPECT_FALSE(changed);
}

}  // namespace
}  // namespace polyturn::channels::cycles
