#include "hmi/screens/graphics/cutting_scene.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::hmi {
namespace {
constexpr std::size_t kMostPoints = 20'000;
constexpr double kLeastWay = 0.02;  // mm
constexpr double kOnAxis = 0.5;     // mm: so near a drill's point runs
// Where neither table nor offset tells a drill's diameter, a third of the bar's is drawn, 20 mm at
// most.
constexpr double kDrillShare = 1.0 / 3.0, kLargestDrill = 10.0;
}  // namespace

void TurnedStock::begin(double diameter, double bore, double length, double face) {
    outer_ = diameter / 2;
    bore_ = bore / 2;
    left_ = -length;
    const auto count = static_cast<std::size_t>(std::clamp((length + face) / kStep, 0.0, 50'000.0));
    radius_.assign(count, outer_);
    inner_.assign(count, bore_);
}

// Along the axis into the part; in front of its zero there is only what is faced away.
bool TurnedStock::drills(double z0, double x0, double z1, double x1) const {
    return std::abs(x0) < kOnAxis && std::abs(x1 - x0) < 1e-3 && z1 - z0 > 1e-9;
}

// There is a hole, and its wall is nearer than the outside. What the hole in front of the tip has
// counts: from there it has come.
bool TurnedStock::bores(long i, double x) const {
    const auto here = static_cast<std::size_t>(i), front = std::min(here + 1, radius_.size() - 1);
    const double hole = std::max(inner_[here], inner_[front]), outside = radius_[here];
    return hole > 0 && x < outside && x - hole < outside - x;
}

// A tool whose side is only what its cuts before looked like is believed until it is plainly beyond
// the other wall: a whole cut there, or one that comes from outside.
CutSide TurnedStock::sideOf(double z0, double x0, double z1, double x1,
                            const CuttingTool& tool) const {
    if (!tool.guessed) return tool.side;
    const auto at = [&](double z) {
        return static_cast<std::size_t>(
            std::clamp((z - left_) / kStep, 0.0, static_cast<double>(radius_.size() - 1)));
    };
    const double outside = std::min(radius_[at(z0)], radius_[at(z1)]),
                 hole = std::min(inner_[at(z0)], inner_[at(z1)]);
    const double least = std::min(std::abs(x0), std::abs(x1)),
                 most = std::max(std::abs(x0), std::abs(x1));
    if (tool.side == CutSide::Inside && outside > 0 &&
        (least >= outside || (z1 - z0 < 1e-9 && most >= outside)))
        return CutSide::Outside;
    if (tool.side == CutSide::Outside && hole > 0 && z1 <= 0 && most <= hole)
        return CutSide::Inside;
    return tool.side;
}

CutSide TurnedStock::cut(double z0, double x0, double z1, double x1, const CuttingTool& tool) {
    if (radius_.empty()) return CutSide::Unknown;
    const bool inwards = z1 < z0;
    if (z0 > z1) {
        std::swap(z0, z1);
        std::swap(x0, x1);
    }
    const double first = (z0 - left_) / kStep, last = (z1 - left_) / kStep;
    const auto from = static_cast<long>(std::floor(std::max(first, 0.0)));
    const auto to =
        std::min(static_cast<long>(std::floor(last)), static_cast<long>(radius_.size()) - 1);
    const bool across = z1 - z0 < 1e-9;
    if (inwards && drills(z0, x0, z1, x1)) {  // the retract from a faced centre is none
        const double hole =
            tool.hole > 0 ? tool.hole : std::min(outer_ * kDrillShare, kLargestDrill);
        for (long i = from; i <= to; ++i) {
            const auto at = static_cast<std::size_t>(i);
            if (left_ + static_cast<double>(i) * kStep >= -1e-9)
                radius_[at] = bore_;
            else
                inner_[at] = std::max(inner_[at], hole);
        }
        return CutSide::Inside;
    }
    CutSide side = sideOf(z0, x0, z1, x1, tool), seen = CutSide::Unknown;
    const auto inHole = [&](long i, double x) {
        const auto at = static_cast<std::size_t>(i);
        const bool touches = x < radius_[at] && x > inner_[at] && radius_[at] > inner_[at];
        if (side != CutSide::Unknown) {
            if (touches) seen = side;
            return side == CutSide::Inside && inner_[at] > 0;
        }
        const bool inside = bores(i, x);
        if (touches && inner_[at] > 0 && seen == CutSide::Unknown)
            seen = inside ? CutSide::Inside : CutSide::Outside;
        return inside;
    };
    // From the face inwards, so that a hole grows from its mouth.
    if (across && first >= 0 && from <= to && inHole(from, std::max(std::abs(x0), std::abs(x1)))) {
        auto& hole = inner_[static_cast<std::size_t>(from)];
        hole = std::max({hole, std::abs(x0), std::abs(x1)});
        return seen;
    }
    const double mouth = from >= 0 && from < static_cast<long>(inner_.size())
                             ? inner_[static_cast<std::size_t>(from)]
                             : 0.0;
    for (long i = to; i >= from; --i) {
        const double part =
            across
                ? 0.0
                : std::clamp((left_ + static_cast<double>(i) * kStep - z0) / (z1 - z0), 0.0, 1.0);
        const double x =
            across ? std::min(std::abs(x0), std::abs(x1)) : std::abs(x0 + (x1 - x0) * part);
        if (!across && inHole(i, x)) {
            auto& hole = inner_[static_cast<std::size_t>(i)];
            hole = std::max(hole, x);
            continue;
        }
        auto& radius = radius_[static_cast<std::size_t>(i)];
        radius = std::max(std::min(radius, x), bore_);
    }
    // A facing cut, to the axis or into the hole, takes what is in front of it.
    if (first >= 0 && across && std::min(std::abs(x0), std::abs(x1)) < std::max(1.0, mouth))
        for (long i = std::max(0L, from); i < static_cast<long>(radius_.size()); ++i)
            radius_[static_cast<std::size_t>(i)] = bore_;
    return seen;
}

void TurnedStock::cutTo(const std::vector<double>& radii, const std::vector<double>& holes) {
    if (radii.size() != radius_.size() || holes.size() != inner_.size()) return;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        radius_[i] = std::min(radius_[i], std::max(radii[i], bore_));
        inner_[i] = std::max(inner_[i], holes[i]);
    }
}

double TurnedStock::radiusAt(double z) const {
    const double at = (z - left_) / kStep;
    return at < 0 || at >= static_cast<double>(radius_.size())
               ? 0.0
               : radius_[static_cast<std::size_t>(at)];
}

double arcTurn(double difference, bool clockwise, bool whole) {
    constexpr double kRounded = 1e-4;  // a short arc whose ends are rounded is no long one
    if (whole) return clockwise ? -2 * M_PI : 2 * M_PI;
    const double turn = std::remainder(difference, 2 * M_PI);
    if (clockwise && turn > kRounded) return turn - 2 * M_PI;
    return !clockwise && turn < -kRounded ? turn + 2 * M_PI : turn;
}

double TurnedStock::boreAt(double z) const {
    const double at = (z - left_) / kStep;
    return at < 0 || at >= static_cast<double>(inner_.size())
               ? 0.0
               : std::min(inner_[static_cast<std::size_t>(at)],
                          radius_[static_cast<std::size_t>(at)]);
}

bool TurnedStock::hollow() const {
    return std::any_of(inner_.begin(), inner_.end(), [](double radius) { return radius > 0; });
}

void CuttingScene::clear() {
    trails.clear();
    seen_.clear();
    stock = {};
    changed = true;
}

void CuttingScene::begin(const text::JobStock& blank, const Zero& zero) {
    stock.begin(blank.diameter, blank.bore, blank.length, blank.face);
    seen_.clear();
    zero_ = zero;
    changed = true;
}

void CuttingScene::addBefore(unsigned channel, std::deque<TrailPoint> points) {
    Trail& trail = trails[channel];
    points.insert(points.end(), trail.points.begin(), trail.points.end());
    while (points.size() > kMostPoints) points.pop_front();
    trail.points = std::move(points);
    trail.drawn = 0;
    changed = true;
}

void CuttingScene::cutTo(unsigned channel, const TrailPoint& from, const TrailPoint& to) {
    Seen& seen = seen_[channel];
    if (to.tool.number <= 0) seen = {};  // not known whether it is still the same one
    if (seen.number != to.tool.number) seen = {to.tool.number, CutSide::Unknown};
    CuttingTool tool = to.tool;
    if (tool.side == CutSide::Unknown) {
        tool.side = seen.side;
        tool.guessed = true;
    }
    const CutSide worked =
        stock.cut((from.z - zero_.z) * zero_.sense, std::abs(from.x - zero_.x),
                  (to.z - zero_.z) * zero_.sense, std::abs(to.x - zero_.x), tool);
    if (tool.guessed && worked != CutSide::Unknown) seen.side = worked;
    cut = cut || stock.any();
}

void CuttingScene::cutAgain(const std::map<unsigned, Trail>& driven) {
    for (const auto& [channel, trail] : driven)
        for (std::size_t i = 1; i < trail.points.size(); ++i)
            if (const TrailPoint& point = trail.points[i]; !point.rapid && !point.begins)
                cutTo(channel, trail.points[i - 1], point);
}

void CuttingScene::add(unsigned channel, double z, double x, bool rapid, const CuttingTool& tool) {
    Trail& trail = trails[channel];
    const TrailPoint point{z, x, rapid, !trail.open, tool};
    if (trail.open) {
        const TrailPoint& last = trail.points.back();
        if (std::hypot(z - last.z, x - last.x) < kLeastWay) return;
        if (!rapid) cutTo(channel, last, point);
    }
    trail.points.push_back(point);
    if (trail.points.size() > kMostPoints) {
        trail.points.pop_front();
        trail.drawn -= trail.drawn > 0;
    }
    trail.open = true;
}

}  // namespace polyturn::hmi
