// G71 and G72 against an area model: the stock above every place of the work, lowered by what the
// tool passes over.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../compensation/lathe_program.hpp"
#include "tests/property.hpp"

namespace polyturn::channels {
namespace {

using testing::Nose;
using testing::NoseRun;
using testing::Point;
using testing::run_lathe;

constexpr double kMicron = 0.001;

// Heights (radius) on a raster along Z; a polyline of the contour gives the height that must be
// left.
class Stock {
public:
    Stock(double from_z, double to_z, double radius) : from_(from_z), to_(to_z) {
        for (int i = 0; i <= kCells; ++i) height_.push_back(radius);
    }
    double z(int i) const { return from_ + (to_ - from_) * i / kCells; }
    double height(int i) const { return height_[static_cast<std::size_t>(i)]; }
    // A straight move: cutting lowers the stock, rapid traverse must not touch it. The depth that
    // rapid would have cut.
    double pass(const Point& a, const Point& b, bool cuts) {
        double touched = 0.0;
        for (int i = 0; i <= kCells; ++i) {
            const double at = z(i), low = std::min(a.z, b.z), high = std::max(a.z, b.z);
            if (at < low - 1e-6 || at > high + 1e-6) continue;
            double tip = std::min(a.x, b.x) / 2;
            if (high - low > 1e-6) tip = (a.x + (b.x - a.x) * (at - a.z) / (b.z - a.z)) / 2;
            double& stock = height_[static_cast<std::size_t>(i)];
            if (cuts)
                stock = std::min(stock, tip);
            else
                touched = std::max(touched, stock - tip);
        }
        return touched;
    }
    static constexpr int kCells = 400;

private:
    double from_, to_;
    std::vector<double> height_;
};

// diameter
struct Corner {
    double x, z;
};

double contour_radius(const std::vector<Corner>& contour, double z, bool upper) {
    double best = upper ? -1e9 : 1e9;
    for (std::size_t k = 0; k + 1 < contour.size(); ++k) {
        const Corner &a = contour[k], &b = contour[k + 1];
        if (z > a.z + 1e-9 || z < b.z - 1e-9) continue;
        for (const double x :
             a.z - b.z < 1e-9 ? std::vector<double>{a.x, b.x}
                              : std::vector<double>{a.x + (b.x - a.x) * (z - a.z) / (b.z - a.z)})
            best = upper ? std::max(best, x / 2) : std::min(best, x / 2);
    }
    return best;
}

std::string program(const std::vector<Corner>& contour, double depth, double allowance,
                    bool pockets) {
    char text[200];
    std::snprintf(text, sizeof text, "G71 U%.3f R0.5\nG71 P10 Q99 U%.3f W0. F0.3\n", depth,
                  2 * allowance);
    std::string out = text;
    for (std::size_t k = 0; k < contour.size(); ++k) {
        const bool last = k + 1 == contour.size();
        std::snprintf(text, sizeof text, "%s %s X%.3f",
                      k == 0 ? "N10"
                      : last ? "N99"
                             : "",
                      k == 0 ? "G0" : "G1", contour[k].x);
        out += text;
        if (k > 0 || pockets) {
            std::snprintf(text, sizeof text, " Z%.3f", contour[k].z);
            out += text;
        }
        out += "\n";
    }
    return out;
}

// After roughing exactly the allowance is left; nothing was cut below it; no rapid went through
// stock.
void judge(const std::vector<Corner>& contour, double depth, double allowance, bool pockets,
           double start_x, double start_z) {
    const NoseRun run =
        run_lathe(program(contour, depth, allowance, pockets), Nose{0.0, 0}, start_x, start_z);
    ASSERT_EQ(run.played.errors, 0u) << run.played.events;
    Stock stock(contour.front().z - 0.001, contour.back().z + 0.001, start_x / 2 - 0.5);
    Point here{start_x, start_z};
    for (const Point& to : run.points) {
        const bool rapid = to.line.find("\"kind\":\"rapid\"") != std::string::npos;
        ASSERT_LE(stock.pass(here, to, !rapid), rapid ? kMicron : 1e9)
            << "rapid through stock: " << to.line;
        here = to;
    }
    for (int i = 0; i <= Stock::kCells; ++i) {
        const double z = stock.z(i);
        const double highest =
                         std::min(contour_radius(contour, z, true) + allowance, start_x / 2 - 0.5),
                     lowest = contour_radius(contour, z, false) + allowance;
        ASSERT_LE(stock.height(i), highest + kMicron) << "stock left at Z" << z;
        ASSERT_GE(stock.height(i), std::min(lowest, start_x / 2 - 0.5) - kMicron)
            << "cut too deep at Z" << z;
    }
    EXPECT_NEAR(here.x, start_x, 1e-6);
    EXPECT_NEAR(here.z, start_z, 1e-6);
}

TEST(StockRemoval, LeavesTheAllowanceOnAStepAndACone) {
    judge({{20, 2}, {20, -10}, {30, -15}, {40, -15}, {44, -30}, {60, -30}}, 2.0, 0.3, false, 60, 2);
}

TEST(StockRemoval, TakesALevelThatLiesExactlyOnACorner) {
    // Levels at 56 52 48 .. 24: with no allowance the shoulders at 40 and 32 and the first diameter
    // 24 are levels.
    judge({{24, 2}, {24, -10}, {32, -15}, {32, -20}, {40, -20}, {40, -30}, {60, -30}}, 2.0, 0.0,
          false, 60, 2);
}

TEST(StockRemoval, ClearsPocketsOneAfterTheOther) {
    judge({{20, 0},
           {20, -10},
           {40, -15},
           {40, -20},
           {30, -25},
           {30, -30},
           {50, -35},
           {34, -45},
           {34, -50},
           {60, -55}},
          1.5, 0.2, true, 60, 0);
}

TEST(StockRemoval, EndsInsideAPocket) {
    judge({{30, 0}, {50, -10}, {30, -20}, {30, -30}}, 2.0, 0.2, true, 60, 0);
}

PROPERTY(StockRemoval, RandomContours, ()) {
    const bool pockets = *rc::gen::arbitrary<bool>();
    std::vector<Corner> contour{{static_cast<double>(*rc::gen::inRange(10, 40)), 2.0}};
    const int corners = *rc::gen::inRange(1, 9);
    for (int k = 0; k < corners; ++k) {
        Corner next = contour.back();
        next.z -= *rc::gen::inRange(k == corners - 1 ? 1 : 0, 12) * 0.5;
        next.x =
            pockets ? *rc::gen::inRange(10, 58) : std::min(58.0, next.x + *rc::gen::inRange(0, 12));
        if (next.z == contour.back().z && next.x == contour.back().x) next.z -= 0.5;
        contour.push_back(next);
    }
    judge(contour, *rc::gen::inRange(5, 40) * 0.1, *rc::gen::inRange(0, 5) * 0.1, pockets, 60, 2);
    RC_ASSERT(!::testing::Test::HasFatalFailure());
}

struct Bad {
    const char* blocks;
    int fanuc;
    int line;
};
TEST(StockRemoval, RefusesWhatCannotEnd) {
    const Bad kBad[] = {
        // zero depth
        {"G71 U0. R1.\nG71 P1 Q2 U0.4 F0.2\nN1 G0 X20.\nN2 G1 Z-10.", 62, 3},
        // ends where it begins along Z
        {"G71 U2. R1.\nG71 P1 Q2 U0.4 F0.2\nN1 G0 X20.\nN2 G1 X30.", 62, 5},
        // falls: type I
        {"G71 U2. R1.\nG71 P1 Q3 U0.4 F0.2\nN1 G0 X20.\nG1 Z-10.\nN3 X10. Z-20.", 64, 7},
        // runs back along Z
        {"G71 U2. R1.\nG71 P1 Q3 U0.4 F0.2\nN1 G0 X20. Z2.\nG1 Z-10.\nN3 X30. Z-5.", 64, 7},
        // no G0 or G1
        {"G71 U2. R1.\nG71 P1 Q2 U0.4 F0.2\nN1 X20.\nN2 G1 Z-10.", 65, 5},
        {"G71 U2. R1.\nG71 P1 Q3 U0.4 F0.2\nN1 G0 X20.\nG4 X1.\nG32 Z-10. F1.\nN3 G1 Z-12.", 66, 7},
        // Q is not there
        {"G71 U2. R1.\nG71 P1 Q9 U0.4 F0.2\nN1 G0 X20.\nN2 G1 Z-10.", 63, 4},
        {"G71 U2. R1.\nG71 P8 Q2 U0.4 F0.2\nN1 G0 X20.\nN2 G1 Z-10.", 63, 4},
        // the arc does not fit
        {"G71 U2. R1.\nG71 P1 Q2 U0.4 F0.2\nN1 G0 X20.\nN2 G2 X40. Z-10. R3.", 20, 6},
    };
    for (const Bad& bad : kBad) {
        SCOPED_TRACE(bad.blocks);
        const NoseRun run = run_lathe(bad.blocks, Nose{0.0, 0}, 60, 2);
        EXPECT_TRUE(run.alarm(bad.fanuc)) << run.played.events;
        EXPECT_TRUE(run.played.has({"\"alarm\"", "\"line\":" + std::to_string(bad.line)}))
            << run.played.events;
        EXPECT_TRUE(run.points.empty());
    }
}

TEST(StockRemoval, LeavesVariablesAsTheyWereAndSkipsTheContour) {
    const NoseRun run = run_lathe(
        "#101=20\nG71 U5. R1.\nG71 P1 Q2 U0. F0.2\nN1 G0 X#101\n#101=#101+1\nN2 G1 Z-10.\nG0 X#101",
        Nose{0.0, 0}, 60, 2);
    ASSERT_EQ(run.played.errors, 0u) << run.played.events;
    EXPECT_NEAR(run.points.back().x, 20, 1e-9);  // the contour's own assignment has left no trace
}

TEST(StockRemoval, FacingExchangesTheAxes) {
    // Levels at Z 1, 0, -1, -2 ... from X60 towards the centre; the contour runs from outside in.
    const NoseRun run = run_lathe(
        "G72 W1. R0.5\nG72 P1 Q2 U0. W0. F0.2\nN1 G0 Z-3.\nN2 G1 X20. Z2.", Nose{0.0, 0}, 60, 2);
    ASSERT_EQ(run.played.errors, 0u) << run.played.events;
    double lowest = 9;
    for (const Point& p : run.points) {
        lowest = std::min(lowest, p.z);
        EXPECT_GE(p.z, -3.0 + (60 - p.x) / 8 - 1e-6) << p.line;  // never behind the contour
    }
    EXPECT_NEAR(lowest, -3.0, 1e-9);
    EXPECT_NE(run.points[1].line.find("\"cycle\":\"G72\""), std::string::npos);
}

}  // namespace
}  // namespace polyturn::channels
