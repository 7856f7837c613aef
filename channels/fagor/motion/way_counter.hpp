// The way that each axis of the channel has been sent, for DIST (fagor_8037t part 2, 11.2.7): a
// sink that adds up what passes.
#pragma once
#include <cmath>
#include <numbers>

#include "channels/forwarding_sink.hpp"

namespace polyturn::channels::fagor {

class TravelCounter final : public ForwardingSink {
public:
    explicit TravelCounter(Sink& next) : ForwardingSink(&next) {}

    // mm (X as a radius) or degrees
    double way(unsigned place) const { return way_[place]; }
    void take_ways(const TravelCounter& other) { way_ = other.way_; }
    // A move that the probe has ended `short_of` its end.
    void take_back(unsigned place, double short_of) { way_[place] -= std::fabs(short_of); }

    void move(const Move& m, const BlockContext& at) override {
        // Under a transformation centre and radius are not those of the axes: their ways count as
        // straight.
        const bool arc = (m.kind == MoveKind::ArcCw || m.kind == MoveKind::ArcCcw) && !m.kinematics;
        for (unsigned i = 0; i < kChannelAxes; ++i) {
            if (arc && (i == m.plane_p || i == m.plane_q)) continue;
            if (m.moved >> i & 1u) way_[i] += std::fabs(m.machine[i] - m.machine_start[i]);
        }
        if (arc) {
            const double first = std::atan2(m.machine_start[m.plane_q] - m.centre_q,
                                            m.machine_start[m.plane_p] - m.centre_p);
            way_[m.plane_p] += m.radius * swing(first, m.sweep);
            way_[m.plane_q] += m.radius * swing(first - std::numbers::pi / 2, m.sweep);
        }
        next_->move(m, at);
    }

private:
    // How far cos goes up and down altogether between two angles.
    static double swing(double first, double sweep) {
        const double turn = std::numbers::pi;
        double from = std::fmin(first, first + sweep), sum = 0.0;
        const double to = std::fmax(first, first + sweep);
        while (from < to - 1e-12) {
            const double next = std::fmin(to, (std::floor(from / turn + 1e-9) + 1.0) * turn);
            sum += std::fabs(std::cos(next) - std::cos(from));
            from = next;
        }
        return sum;
    }

    AxisValues way_{};
};

}  // namespace polyturn::channels::fagor
