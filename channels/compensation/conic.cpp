#include "channels/compensation/conic.hpp"

#include <algorithm>

namespace polyturn::channels::compensation {
namespace {

// What is driven instead of the conic are chords: half a micrometre, a step of the axes.
constexpr double kChordErrorMm = 5e-4;
constexpr int kFewestPieces = 4, kMostPieces = 512;
// cos h: a reversal, its corner is at infinity; and 1 - cos h: straight on, nothing to round.
constexpr double kReversal = 1e-6, kStraight = 1e-12;
constexpr double kShortestChordMm = 1e-12;  // keeps a quotient finite

}  // namespace

std::vector<Vec> conic_about(Vec from, Vec to, Vec corner, double overshoot) {
    const Vec a = from - corner, b = to - corner, sum = a + b;
    const double cos_full = dot(a, b) / (length(a) * length(b));
    const double c = std::sqrt(std::fmax(0.0, (1.0 + cos_full) / 2.0));  // cos h
    if (c < kReversal || 1.0 - c < kStraight) return {};
    const Vec top = (1.0 / (1.0 + cos_full)) * sum;  // C seen from the corner: |C| = r / cos h
    const double q = (1.0 - c + overshoot * (1.0 / c - 1.0)) / (1.0 / c - c), w = q / (1.0 - q);
    const auto at = [&](double t) {
        const double u = 1.0 - t, d = u * u + 2.0 * w * t * u + t * t;
        return corner + (1.0 / d) * (u * u * a + (2.0 * w * t * u) * top + t * t * b);
    };
    // Halved until the middle of no piece is farther from its chord than may be; the curve has no
    // turning point.
    int pieces = kFewestPieces;
    for (; pieces < kMostPieces; pieces *= 2) {
        double worst = 0;
        for (int k = 0; k < pieces; ++k) {
            const Vec p = at(static_cast<double>(k) / pieces), r = at((k + 1.0) / pieces),
                      m = at((k + 0.5) / pieces);
            worst = std::max(
                worst, std::fabs(cross(r - p, m - p)) / std::fmax(length(r - p), kShortestChordMm));
        }
        if (worst < kChordErrorMm) break;
    }
    std::vector<Vec> points;
    for (int k = 1; k < pieces; ++k) points.push_back(at(static_cast<double>(k) / pieces));
    return points;
}

}  // namespace polyturn::channels::compensation
