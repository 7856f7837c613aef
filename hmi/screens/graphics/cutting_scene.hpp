// What the channels have cut so far: their paths and what is left of the blank, in the work area of
// the machine. Fed by the running machine or by a dry run; knows nothing of pictures. X as a
// radius, Z along the room.
#pragma once
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "hmi/machine/bodies/cutting_tool.hpp"
#include "ipc/model/files/job.hpp"

namespace polyturn::hmi {

// What is left of a turned blank: its outer and its inner radius along Z, from the workpiece zero.
// Pure.
class TurnedStock {
public:
    void begin(double diameter, double bore, double length, double face);
    bool any() const { return !radius_.empty(); }
    const std::vector<double>& radii() const { return radius_; }
    const std::vector<double>& holes() const { return inner_; }
    // what another one of the same blank had lost as well
    void cutTo(const std::vector<double>& radii, const std::vector<double>& holes);
    // The tip has cut from one point to the other; Z from the workpiece zero, X as a radius. At
    // which side of the wall it works is answered, as the tool says it, else as the cut looks:
    // Unknown, where it touched nothing.
    CutSide cut(double z0, double x0, double z1, double x1, const CuttingTool& tool = {});
    double radiusAt(double z) const;
    double boreAt(double z) const;  // the radius of the hole there; 0: none
    bool hollow() const;
    double left() const { return left_; }
    double right() const { return left_ + static_cast<double>(radius_.size()) * kStep; }
    double outer() const { return outer_; }
    double bore() const { return bore_; }
    static constexpr double kStep = 0.1;  // mm

private:
    bool drills(double z0, double x0, double z1, double x1) const;
    // the wall of a hole rather than the outside, by what is nearer; `i`: where it works
    bool bores(long i, double x) const;
    CutSide sideOf(double z0, double x0, double z1, double x1, const CuttingTool& tool) const;

    std::vector<double> radius_, inner_;
    double left_ = 0, outer_ = 0, bore_ = 0;
};

// How far an arc turns, from Z towards X, whose ends' directions from its centre differ so;
// `whole`: its end is its beginning.
double arcTurn(double difference, bool clockwise, bool whole);

struct TrailPoint {
    double z, x;  // in the work area
    bool rapid, begins;
    CuttingTool tool = {};  // that has come here
};
struct Trail {
    std::deque<TrailPoint> points;
    bool open = false;
    std::size_t drawn = 0;  // points that are in the picture already
};

class CuttingScene {
public:
    // The workpiece zero in the work area, and the direction of its Z; where its axis
    // is.
    struct Zero {
        double z = 0, x = 0, sense = 1;
    };
    void clear();
    void begin(const text::JobStock& stock, const Zero& zero);
    void place(const Zero& zero) {
        zero_ = zero;
        changed = true;
    }
    const Zero& zero() const { return zero_; }
    void add(unsigned channel, double z, double x, bool rapid, const CuttingTool& tool = {});
    // What was driven before the blank was known, cut out of it.
    void cutAgain(const std::map<unsigned, Trail>& driven);
    // What a channel has driven before all that is known of it.
    void addBefore(unsigned channel, std::deque<TrailPoint> points);
    // the next point is not joined with the last
    void lift(unsigned channel) { trails[channel].open = false; }

    std::map<unsigned, Trail> trails;
    TurnedStock stock;
    // changed: the picture must be drawn anew; cut: the stock is another one since
    bool changed = true, cut = false;

private:
    void cutTo(unsigned channel, const TrailPoint& from, const TrailPoint& to);
    Zero zero_;
    // Of tools that do not say themselves at which side they work: where they began. A tool does
    // not change from the outside into a hole because the wall in between has become thin.
    struct Seen {
        std::int32_t number = 0;
        CutSide side = CutSide::Unknown;
    };
    std::map<unsigned, Seen> seen_;
};

}  // namespace polyturn::hmi
