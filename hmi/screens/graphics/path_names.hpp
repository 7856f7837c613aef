// Where the name of its channel is on a path, so that colour is not all that distinguishes paths:
// at even distances along it, and never near an older one, for roughing goes along the same line
// again and again.
#pragma once
#include <QPointF>
#include <QRectF>
#include <algorithm>
#include <cmath>
#include <vector>

namespace polyturn::hmi {

class PathNames {
public:
    static constexpr std::size_t kMost = 60;  // on a picture
    void clear() {
        places_.clear();
        sinceLast_ = -1;
    }
    // The path goes on by a straight line, in pixels. A name is a distance `every` after the
    // last one, if it is within the area and
    // `apart` from all others.
    void goOn(const QPointF& from, const QPointF& to, double every, double apart,
              const QRectF& area) {
        const double length = std::hypot(to.x() - from.x(), to.y() - from.y());
        // the first one comes sooner: a path may be short
        if (sinceLast_ < 0) sinceLast_ = every * 0.6;
        double at = every - sinceLast_;
        for (; at <= length && places_.size() < kMost; at += every) {
            const QPointF place = from + (to - from) * (at / std::max(length, 1e-9));
            const auto near = [&](const QPointF& other) {
                return std::hypot(other.x() - place.x(), other.y() - place.y()) < apart;
            };
            if (area.contains(place) && std::none_of(places_.begin(), places_.end(), near))
                places_.push_back(place);
        }
        sinceLast_ = every - (at - length);
    }
    const std::vector<QPointF>& places() const { return places_; }

private:
    std::vector<QPointF> places_;
    double sinceLast_ = -1;  // nothing yet
};

}  // namespace polyturn::hmi
