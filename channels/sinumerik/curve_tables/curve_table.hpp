// A curve table: the position of a following axis over that of a leading one, straight from point
// to point (sinumerik_part3 7.4, 9.3). Positions are those that the program writes (mm, inch or
// degrees, X as it is programmed).
//
//   follow                      periodic 0: before and behind the table its end values
//     |   p1___p2               periodic 1: the table again and again, the following axis comes back
//     |  /       \              periodic 2: and the following axis goes on by what it has gained in each round
//     | p0        p3___p4
//     +----------------------- lead, rising from point to point
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace polyturn::channels::sinumerik {

class CurveTable {
public:
    struct Point {
        double lead = 0.0, follow = 0.0;
    };
    struct Sample {
        double value = 0.0, slope = 0.0;  // slope: of the following axis over the leading one
    };
    int periodic = 0;           // 0 to 2
    bool dynamic = false;       // DRAM: lost when the control is switched off
    bool locked = false;        // CTABLOCK
    std::vector<Point> points;  // at least two; lead rises

    std::size_t segments() const { return points.size() - 1; }
    Sample at(double lead) const;
    // The leading position nearest to `about` at which the following axis is at `follow`; beyond
    // what it reaches: the end whose value is nearer.
    Sample inverse(double follow, double about) const;
    double length() const { return points.back().lead - points.front().lead; }
    Sample last() const { return {points.back().follow, slope(segments() - 1)}; }
    Sample segment_start(double lead) const;  // of the segment that holds `lead`
    Sample segment_end(double lead) const;
    // Smallest (largest) following position between two leading ones.
    double extreme(double from, double to, bool largest) const;

private:
    double gain() const {
        return periodic == 2 ? points.back().follow - points.front().follow : 0.0;
    }
    // into the table, and how many rounds before it
    double round(double lead, double& rounds) const;
    std::size_t segment(double lead) const;
    double slope(std::size_t segment) const;
};

// Between CTABDEF and CTABEND. A table of the number stays as it is until CTABEND.
struct CurveDefinition {
    std::size_t follows = 0, leads = 0;  // axes of the channel, by place
    int number = 0;
    CurveTable table;
};

using CurveTables = std::map<int, CurveTable>;

}  // namespace polyturn::channels::sinumerik
