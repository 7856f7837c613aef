// Compensation tables as curves: positions and values as the parameters and the cells have them.
#include "hmi/machine/compensation_curves.hpp"

#include <gtest/gtest.h>

#include "ipc/machine/load_machine.hpp"
#include "tests/places.hpp"

namespace polyturn::hmi {
namespace {

using Kind = CompensationCurve::Kind;

std::vector<CompensationCurve> curvesOf(const std::vector<std::string>& lines, const std::string& cells) {
    LoadedMachine loaded = load_machine({std::string(kSourceFolder) + "/examples/machines/twin-turret", {}, lines});
    for (const Diagnosis& one : loaded.diagnoses) ADD_FAILURE() << one.text();
    std::vector<Diagnosis> wrong;
    const CompensationTables tables = parse_compensation(cells, "machine.compensation", wrong);
    EXPECT_TRUE(wrong.empty());
    return compensationCurves(*loaded.table, derive_machine_config(*loaded.table), tables);
}

TEST(CompensationCurves, HaveThePointsOfAPitchTableInBothDirections) {
    // Cells 10500 to 10504, 50 mm apart, machine zero at 10502; a second table for the way back from 10600 on.
    const auto curves = curvesOf({"N2500 A2=00000011", "N2501 A2=50", "N2502 A2=10502", "N2503 A2=10500", "N2504 A2=10504", "N2505 A2=10600"},
                                 "10500=-0.004\n10501=-0.002\n10502=0\n10503=0.003\n10504=0.007\n10600=-0.005\n10601=0\n10602=0\n10603=0\n10604=0.001\n");
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].kind, Kind::Pitch);
    EXPECT_EQ(curves[0].moving, 2u);
    EXPECT_TRUE(curves[0].on);
    ASSERT_EQ(curves[0].points.size(), 5u);
    const double at[] = {-100, -50, 0, 50, 100}, value[] = {-0.004, -0.002, 0, 0.003, 0.007};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(curves[0].points[i].number, static_cast<std::int64_t>(10500 + i));
        EXPECT_DOUBLE_EQ(curves[0].points[i].at, at[i]);
        EXPECT_NEAR(curves[0].points[i].value, value[i], 1e-7);
    }
    EXPECT_EQ(curves[1].kind, Kind::PitchBack);
    EXPECT_EQ(curves[1].points.front().number, 10600);
    EXPECT_DOUBLE_EQ(curves[1].points.front().at, -100);
    EXPECT_NEAR(curves[1].points.back().value, 0.001, 1e-7);
}

TEST(CompensationCurves, HaveTheFourPositionsOfGradientAndStraightness) {
    const auto curves = curvesOf({"N2800 A1=00000001", "N2801 A1=-10", "N2802 A1=0", "N2803 A1=20", "N2804 A1=60", "N2805 A1=0.001", "N2806 A1=0", "N2807 A1=-0.002", "N2808 A1=0.004",
                                  "N2600 L1=00000001", "N2602 L1=2", "N2608 L1=1", "N2623 L1=-5", "N2624 L1=5", "N2625 L1=15", "N2626 L1=25", "N2635 L1=0.01", "N2636 L1=0.02", "N2637 L1=0.03", "N2638 L1=0.04"}, "");
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].kind, Kind::Gradient);
    EXPECT_DOUBLE_EQ(curves[0].points[3].at, 60);
    EXPECT_DOUBLE_EQ(curves[0].points[2].value, -0.002);
    EXPECT_EQ(curves[1].kind, Kind::Straightness);   // pair 2
    EXPECT_EQ(curves[1].moving, 2u);
    EXPECT_EQ(curves[1].corrected, 1u);
    EXPECT_DOUBLE_EQ(curves[1].points[1].at, 5);
    EXPECT_DOUBLE_EQ(curves[1].points[3].value, 0.04);
}

TEST(CompensationCurves, AMachineWithoutTablesHasNone) { EXPECT_TRUE(curvesOf({}, "").empty()); }

}  // namespace
}  // namespace polyturn::hmi
