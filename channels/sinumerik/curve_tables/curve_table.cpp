#include "channels/sinumerik/curve_tables/curve_table.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::channels::sinumerik {
namespace {

// a table that swings far and gains little: farther rounds are not looked at
constexpr double kMostTurns = 1000;

}  // namespace

double CurveTable::round(double lead, double& rounds) const {
    rounds = 0;
    if (periodic == 0) return std::clamp(lead, points.front().lead, points.back().lead);
    rounds = std::floor((lead - points.front().lead) / length());
    return lead - rounds * length();
}

// The last segment also holds the end of the table.
std::size_t CurveTable::segment(double lead) const {
    const auto behind =
        std::upper_bound(points.begin() + 1, points.end() - 1, lead,
                         [](double value, const Point& p) { return value < p.lead; });
    return static_cast<std::size_t>(behind - points.begin()) - 1;
}

double CurveTable::slope(std::size_t s) const {
    return (points[s + 1].follow - points[s].follow) / (points[s + 1].lead - points[s].lead);
}

CurveTable::Sample CurveTable::at(double lead) const {
    double rounds = 0;
    const double inside = round(lead, rounds);
    const std::size_t s = segment(inside);
    const bool outside = periodic == 0 && (lead < points.front().lead || lead > points.back().lead);
    return {points[s].follow + slope(s) * (inside - points[s].lead) + rounds * gain(),
            outside ? 0.0 : slope(s)};
}

CurveTable::Sample CurveTable::segment_start(double lead) const {
    double rounds = 0;
    const std::size_t s = segment(round(lead, rounds));
    return {points[s].follow + rounds * gain(), slope(s)};
}

CurveTable::Sample CurveTable::segment_end(double lead) const {
    double rounds = 0;
    const std::size_t s = segment(round(lead, rounds));
    return {points[s + 1].follow + rounds * gain(), slope(s)};
}

CurveTable::Sample CurveTable::inverse(double follow, double about) const {
    double rounds = 0;
    if (periodic != 0) round(about, rounds);
    std::optional<Sample> best;
    // A table that comes back passes the value in every round: that of `about` and its neighbours
    // hold the nearest one. One that goes on passes it in a few rounds: those in which what it has
    // gained is near the value.
    std::vector<double> turns{rounds};
    if (periodic != 0) turns.insert(turns.end(), {rounds - 1, rounds + 1});
    if (gain() != 0) {
        const auto [low, high] = std::ranges::minmax(points, {}, &Point::follow);
        const double a = (follow - high.follow) / gain(), b = (follow - low.follow) / gain();
        const double from = std::floor(std::min(a, b)), to = std::ceil(std::max(a, b));
        for (double turn = from; turn <= to && turn - from < kMostTurns; ++turn)
            turns.push_back(turn);
    }
    for (const double turn : turns) {
        const double wanted = follow - turn * gain();
        for (std::size_t s = 0; s < segments(); ++s) {
            const Point &a = points[s], &b = points[s + 1];
            if (wanted < std::min(a.follow, b.follow) || wanted > std::max(a.follow, b.follow))
                continue;
            const double from = a.lead + turn * length(), to = b.lead + turn * length();
            const double lead = a.follow == b.follow ? std::clamp(about, from, to)
                                                     : from + (wanted - a.follow) / slope(s);
            if (!best || std::fabs(lead - about) < std::fabs(best->value - about))
                best = Sample{lead, slope(s)};
        }
    }
    if (best) return *best;
    const bool first =
        std::fabs(follow - points.front().follow) <= std::fabs(follow - points.back().follow);
    return {first ? points.front().lead : points.back().lead, 0.0};
}

double CurveTable::extreme(double from, double to, bool largest) const {
    if (to < from) std::swap(from, to);
    double best = at(from).value;
    const auto look = [&](double value) {
        best = largest ? std::max(best, value) : std::min(best, value);
    };
    look(at(to).value);
    double first = 0, last = 0;
    round(from, first);
    round(to, last);
    // All rounds between the first and the last one are alike, or rise: their corners lie between
    // those of the two and their neighbours.
    const auto rounds = static_cast<std::size_t>(std::clamp(last - first, 0.0, 2.0));
    for (std::size_t k = 0; k <= rounds; ++k)
        for (const double turn : {first + static_cast<double>(k), last - static_cast<double>(k)})
            for (const Point& p : points)
                if (const double lead = p.lead + turn * length(); lead >= from && lead <= to)
                    look(p.follow + turn * gain());
    return best;
}

}  // namespace polyturn::channels::sinumerik
