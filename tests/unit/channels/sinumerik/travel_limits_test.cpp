// CALCPOSI (sinumerik_part3 9.8): the way is cut where the first limit is met; statuses as
// travel_limits.cpp tells them.
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

// Working area X 0 to 100 (diameter), Z -50 to 200 in the basic system.
Played asked(const std::string& start, const std::string& way,
             const std::string& distances = "0,0,0", const std::string& head = "DIAMON",
             const std::string& more = "") {
    Play how;
    how.language = "sinumerik";
    return play("G18 G90 DIAMON\nDEF REAL START1[3]=SET(" + start + ")\nDEF REAL WAY1[3]=SET(" +
                    way + ")\nDEF REAL LEAVE1[5]=SET(" + distances +
                    ")\nDEF REAL FREE1[3]\nG25 X0 Z-50\nG26 X100 Z200\n" + head +
                    "\nR1=CALCPOSI(START1,WAY1,LEAVE1,FREE1" + more +
                    ")\nR2=FREE1[0] R3=FREE1[2]\nM30\n",
                how);
}

void expect(const Played& played, const char* status, const char* x, const char* z) {
    EXPECT_EQ(played.errors, 0u) << played.events;
    const std::pair<const char*, const char*> rows[] = {{"R1", status}, {"R2", x}, {"R3", z}};
    for (const auto& [name, value] : rows)
        EXPECT_TRUE(played.has({"\"name\":\"" + std::string(name) + "\",\"value\":" + value + "}"}))
            << name << " should be " << value << '\n'
            << played.events;
}

TEST(TravelLimits, CutTheWay) {
    expect(asked("20,0,0", "10,0,-30"), "0", "10", "-30");
    // axis 2, lower limit, leaves, working area
    expect(asked("20,0,0", "0,0,-80"), "2222", "0", "-50");
    // X 100 at half of the way, before Z -50
    expect(asked("20,0,0", "160,0,-80"), "1122", "80", "-40");
    expect(asked("20,0,0", "0,0,-80", "0,0,5"), "2222", "0", "-45");  // 5 mm are left
    expect(asked("20,0,-60", "0,0,10"), "2212", "0", "0");            // already outside
    expect(asked("20,0,0", "0,0,-80", "0,0,-1"), "-1", "0", "0");
    expect(asked("20,0,0", "0,0,-80", "0,0,0", "WALIMOF"), "0", "0", "-80");
    // limits of the axes only: there are none here
    expect(asked("20,0,0", "0,0,-80", "0,0,0", "DIAMON", ",FALSE,1"), "0", "0", "-80");
    // radii: 100 is 50
    expect(asked("10,0,0", "60,0,0", "0,0,0", "DIAMOF"), "1122", "40", "0");
    expect(asked("0,0,0", "0,0,-4", "0,0,0", "G70"), "2222", "0", "-1.968504");  // -50 mm
    // in the machine's unit
    expect(asked("0,0,0", "0,0,-80", "0,0,0", "G70", ",TRUE"), "2222", "0", "-50");
    expect(asked("20,0,0", "0,0,-80", "0,0,0", "TRANS Z20"), "2222", "0", "-70");
}

TEST(TravelLimits, WantArrays) {
    Play how;
    how.language = "sinumerik";
    EXPECT_EQ(
        play("DEF REAL AA1[3]\nDEF REAL BB1[2]\nR1=CALCPOSI(AA1,AA1,AA1,BB1)\nM30\n", how).errors,
        1u);
    EXPECT_EQ(play("DEF REAL AA1[3]\nR1=CALCPOSI(AA1,AA1,5,AA1)\nM30\n", how).errors, 1u);
}

}  // namespace
}  // namespace polyturn::channels::testing
