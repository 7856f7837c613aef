#include "toolmgmt/presetter/robust_line.hpp"

#include <cmath>
#include <random>

namespace polyturn::presetter {
namespace {

constexpr int kTrials = 300;
constexpr std::uint32_t kSeed = 20'26;
constexpr std::size_t kLeast = 20;

// Total least squares of the points on it.
void fit(const std::vector<Point>& points, Line& line) {
    double mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
    const auto n = static_cast<double>(line.on.size());
    for (const std::size_t i : line.on) {
        mx += points[i].x / n;
        my += points[i].y / n;
    }
    for (const std::size_t i : line.on) {
        const double x = points[i].x - mx, y = points[i].y - my;
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    const double along = 0.5 * std::atan2(2 * xy, xx - yy);
    line.nx = -std::sin(along);
    line.ny = std::cos(along);
    line.d = line.nx * mx + line.ny * my;
    double sum = 0;
    for (const std::size_t i : line.on) sum += line.distance(points[i]) * line.distance(points[i]);
    line.deviation = std::sqrt(sum / n);
}

void collect(const std::vector<Point>& points, double tolerance, Line& line) {
    line.on.clear();
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::fabs(line.distance(points[i])) <= tolerance) line.on.push_back(i);
}

}  // namespace

std::optional<Line> robust_line(const std::vector<Point>& points, double tolerance) {
    if (points.size() < kLeast) return {};
    std::mt19937 random(kSeed);
    Line best;
    std::size_t most = 0;
    const std::size_t stride = points.size() / 400 + 1;  // enough to count who agrees
    for (int trial = 0; trial < kTrials; ++trial) {
        const Point &a = points[random() % points.size()], &b = points[random() % points.size()];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length < 6 * tolerance) continue;  // too near for a direction
        Line line;
        line.nx = -(b.y - a.y) / length;
        line.ny = (b.x - a.x) / length;
        line.d = line.nx * a.x + line.ny * a.y;
        std::size_t agree = 0;
        for (std::size_t i = 0; i < points.size(); i += stride)
            if (std::fabs(line.distance(points[i])) <= tolerance) ++agree;
        if (agree > most) {
            most = agree;
            best = line;
        }
    }
    if (most == 0) return {};
    for (int round = 0; round < 3; ++round) {
        collect(points, tolerance, best);
        if (best.on.size() < kLeast) return {};
        fit(points, best);
    }
    return best;
}

}  // namespace polyturn::presetter
