#include "hmi/screens/cutting_scene.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::hmi {
namespace {
constexpr std::size_t kMostPoints = 20'000;
constexpr double kLeastWay = 0.02;     // mm
}  // namespace

void TurnedStock::begin(double diameter, double bore, double length, double face) {
    outer_ = diameter / 2, bore_ = bore / 2;
    left_ = -length;
    const auto count = static_cast<std::size_t>(std::clamp((length + face) / kStep, 0.0, 50'000.0));
    radius_.assign(count, outer_);
}

void TurnedStock::cut(double z0, double x0, double z1, double x1) {
    if (radius_.empty()) return;
    if (z0 > z1) std::swap(z0, z1), std::swap(x0, x1);
    const double first = (z0 - left_) / kStep, last = (z1 - left_) / kStep;
    const auto from = static_cast<long>(std::floor(std::max(first, 0.0)));
    const auto to = std::min(static_cast<long>(std::floor(last)), static_cast<long>(radius_.size()) - 1);
    for (long i = from; i <= to; ++i) {
        const double part = z1 - z0 < 1e-9 ? 0.0 : std::clamp((left_ + static_cast<double>(i) * kStep - z0) / (z1 - z0), 0.0, 1.0);
        const double x = z1 - z0 < 1e-9 ? std::min(std::abs(x0), std::abs(x1)) : std::abs(x0 + (x1 - x0) * part);
        auto& radius = radius_[static_cast<std::size_t>(i)];
        radius = std::max(std::min(radius, x), bore_);
    }
    // A facing cut takes what stands in front of it.
    if (first >= 0 && z1 - z0 < 1e-9 && std::min(std::abs(x0), std::abs(x1)) < 1.0)
        for (long i = std::max(0L, from); i < static_cast<long>(radius_.size()); ++i) radius_[static_cast<std::size_t>(i)] = bore_;
}

void TurnedStock::cutTo(const std::vector<double>& radii) {
    if (radii.size() != radius_.size()) return;
    for (std::size_t i = 0; i < radii.size(); ++i) radius_[i] = std::min(radius_[i], std::max(radii[i], bore_));
}

double TurnedStock::radiusAt(double z) const {
    const double at = (z - left_) / kStep;
    return at < 0 || at >= static_cast<double>(radius_.size()) ? 0.0 : radius_[static_cast<std::size_t>(at)];
}

void CuttingScene::clear() {
    trails.clear();
    stock = {};
    changed = true;
}

void CuttingScene::begin(const text::JobStock& blank, const Zero& zero) {
    stock.begin(blank.diameter, blank.bore, blank.length, blank.face);
    zero_ = zero;
    changed = true;
}

void CuttingScene::addBefore(unsigned channel, std::deque<TrailPoint> points) {
    Trail& trail = trails[channel];
    points.insert(points.end(), trail.points.begin(), trail.points.end());
    while (points.size() > kMostPoints) points.pop_front();
    trail.points = std::move(points), trail.drawn = 0;
    changed = true;
}

void CuttingScene::cutTo(const TrailPoint& from, double z, double x) {
    stock.cut((from.z - zero_.z) * zero_.sense, std::abs(from.x - zero_.x), (z - zero_.z) * zero_.sense, std::abs(x - zero_.x));
    cut = cut || stock.any();
}

void CuttingScene::cutAgain(const std::map<unsigned, Trail>& driven) {
    for (const auto& [channel, trail] : driven)
        for (std::size_t i = 1; i < trail.points.size(); ++i)
            if (const TrailPoint& point = trail.points[i]; !point.rapid && !point.begins) cutTo(trail.points[i - 1], point.z, point.x);
}

void CuttingScene::add(unsigned channel, double z, double x, bool rapid) {
    Trail& trail = trails[channel];
    if (trail.open) {
        const TrailPoint& last = trail.points.back();
        if (std::hypot(z - last.z, x - last.x) < kLeastWay) return;
        if (!rapid) cutTo(last, z, x);
    }
    trail.points.push_back({z, x, rapid, !trail.open});
    if (trail.points.size() > kMostPoints) trail.points.pop_front(), trail.drawn -= trail.drawn > 0;
    trail.open = true;
}

}  // namespace polyturn::hmi
