// A path maker that writes into a vector, a machine with easy numbers, and random paths.
#pragma once
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "channels/path/path_maker.hpp"

namespace polyturn::channels::rig {

struct Collected : RecordOut {
    std::vector<PathRecord> records;
    PathRecord& claim() override { return records.emplace_back(); }
    void commit() override {}
};

inline PathLimits easy_limits() {
    PathLimits limits;
    for (auto& axis : limits.axis) axis = {333, 166, 2000, 2000, 40000, 0, 0, 0, false};
    for (std::size_t i = 4; i < 6; ++i)
        limits.axis[i] = {3000, 2000, 20000, 20000, 400000, 0, 0, 0, true};
    limits.tolerance = 0.005;
    return limits;
}

struct Point {
    double x = 0, z = 0;
};

class Program {
public:
    Program(RecordOut& out, const PathLimits& limits) : maker(out, limits) {}
    PathMaker maker;
    Point at;
    std::int64_t block = 0;
    double feed = 100;  // mm/s

    PathRecord& begin(RecordKind kind) {
        PathRecord& r = maker.next_move();
        r.kind = static_cast<std::uint8_t>(kind);
        r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerMinute);
        r.feed = feed;
        r.block = ++block;
        r.axis_count = 2;
        r.axis = {0, 1};
        r.start = {at.x, at.z};
        return r;
    }
    void line(Point to, std::uint32_t flags = 0) {
        PathRecord& r = begin(RecordKind::Line);
        r.end = {to.x, to.z};
        r.flags = flags;
        at = to;
        maker.add_move();
    }
    // Turns by `sweep` about `centre`; the radius grows by `widening`.
    void arc(Point centre, double sweep, double widening = 0, std::uint32_t flags = 0) {
        PathRecord& r = begin(RecordKind::Arc);
        const double radius = std::hypot(at.x - centre.x, at.z - centre.z),
                     angle = std::atan2(at.z - centre.z, at.x - centre.x);
        r.plane = {0, 1};
        r.shape[arc_shape::kCentreP] = centre.x;
        r.shape[arc_shape::kCentreQ] = centre.z;
        r.shape[arc_shape::kRadius] = radius;
        r.shape[arc_shape::kRadiusEnd] = radius + widening;
        r.shape[arc_shape::kStartAngle] = angle;
        r.shape[arc_shape::kSweep] = sweep;
        at = {centre.x + (radius + widening) * std::cos(angle + sweep),
              centre.z + (radius + widening) * std::sin(angle + sweep)};
        r.end = {at.x, at.z};
        r.flags = flags;
        maker.add_move();
    }
};

inline RecordKind kind_of(const PathRecord& r) { return static_cast<RecordKind>(r.kind); }

// Position, first and second derivative of machine axis `axis` at s of a record.
struct AxisState {
    double p = 0, t = 0, k = 0;
    bool moves = false;
};
inline AxisState axis_state(const PathRecord& r, double s, unsigned axis) {
    SlotVector p{};
    PathDerivatives d{};
    position_at(r, s, p);
    derivatives_at(r, s, d);
    for (std::size_t i = 0; i < r.axis_count; ++i)
        if (r.axis[i] == axis) return {p[i], d.first[i], d.second[i], true};
    return {};
}

// Lines and arcs with corners of 0 to 180 degrees and lengths of 1 um to 100 mm; about a third
// continues tangentially.
inline void random_path(Program& program, std::mt19937_64& random, int moves) {
    std::uniform_real_distribution<double> unit(0, 1);
    double heading = unit(random) * 6.28;
    for (int n = 0; n < moves; ++n) {
        const double turn = unit(random);
        if (turn > 0.3)
            heading += (unit(random) - 0.5) * 2 * std::numbers::pi * (turn > 0.6 ? 1 : 0.02);
        const double length = std::pow(10.0, -3 + 5 * unit(random));
        if (unit(random) < 0.6) {
            program.line({program.at.x + length * std::cos(heading),
                          program.at.z + length * std::sin(heading)});
        } else {
            const double radius = std::max(0.05, length * (0.2 + unit(random)));
            const double sweep = (unit(random) < 0.5 ? -1 : 1) * std::min(length / radius, 6.0);
            // centre lies left of the heading for positive turns
            const double side = sweep > 0 ? 1 : -1;
            const Point centre{program.at.x - side * radius * std::sin(heading),
                               program.at.z + side * radius * std::cos(heading)};
            program.arc(centre, sweep, unit(random) < 0.1 ? 0.01 * radius * unit(random) : 0.0);
            heading += sweep;
        }
    }
}

}  // namespace polyturn::channels::rig
