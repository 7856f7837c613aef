// Pictures of the drilling cycles that are told by planes (CYCLE81, HOLES1 of sinumerik):
// coordinates are points, ways between them lengths.
#include <cmath>

#include "hmi/widgets/pictures/cycle_scene.hpp"

namespace polyturn::hmi {
namespace {

constexpr QPointF kZero{50, 30};  // of the face, seen from the front

QPointF beside(QPointF from, double way, double degrees) {
    return from + way * QPointF(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
}

QPolygonF ring(QPointF centre, double radius, double from, double to) {
    QPolygonF out;
    for (int i = 0; i <= 36; ++i) out << beside(centre, radius, from + (to - from) * i / 36.0);
    return out;
}

// The face of the part, first axis of the plane to the right, second one upwards; the tool goes
// from hole to hole.
Scene face(const QPolygonF& holes) {
    Scene s;
    s.front = s.drill = true;
    s.part = ring(kZero, 27, -20, 360);  // what is drawn begins behind the first point
    s.tool = {88, 52};
    s.detail = {{{21, kZero.y()}, {79, kZero.y()}}, {{kZero.x(), 2}, {kZero.x(), 58}}};
    QPointF from = s.tool;
    for (const QPointF& hole : holes) {
        s.detail.push_back(ring(hole, 1.8, 0, 360));
        s.paths.push_back({{from, hole}, true});
        from = hole;
    }
    return s;
}

}  // namespace

Scene planesOfHole(bool feed_back) {
    using forms::Mark;
    using Kind = SceneDim::Kind;
    Scene s;
    s.part = {{8, kCentre}, {72, kCentre}, {72, 20}, {36, 20}, {32, 25},
              {36, 30},     {72, 30},      {72, 46}, {8, 46}};
    s.blank = {{8, kCentre}, {72, kCentre}, {72, 46}, {8, 46}};
    // the plane of the way back, that of the bottom
    s.detail = {{{86, 9}, {86, 52}}, {{32, 9}, {32, 40}}};
    s.tool = {90, 25};
    s.drill = true;
    s.paths = {{{{90, 25}, {79, 25}}, true}, {{{79, 25}, {34, 25}}, false}};
    if (feed_back) s.paths.push_back({{{34, 27}, {79, 27}}, false});
    s.paths.push_back({{{feed_back ? 79.0 : 34.0, 27}, {86, 27}}, true});
    s.dims = {
        {Kind::Point, Mark::RLevel, {86, 52}, {86, 52}},
        {Kind::Point, Mark::StartZ, {72, 46}, {72, 46}},
        {Kind::Length, Mark::Safety, {72, 14}, {79, 14}},
        {Kind::Point, Mark::Bottom, {32, 10}, {32, 10}},
        {Kind::Length, Mark::Depth, {72, 37}, {32, 37}},
        {Kind::Point, Mark::Dwell, {33, 25}, {33, 25}},
        {Kind::Way, Mark::Feed, {69, 25}, {60, 25}},
        {Kind::Way, Mark::FeedBack, {43, 27}, {52, 27}},
    };
    return s;
}

// The drawn angle opens by 30 degrees to both sides of its middle.
Scene rowOfHoles() {
    using forms::Mark;
    using Kind = SceneDim::Kind;
    const QPointF start{36, 14};
    QPolygonF holes;
    for (const double way : {10.0, 19.0, 28.0, 37.0}) holes << beside(start, way, 60);
    Scene s = face(holes);
    s.dims = {
        {Kind::Length, Mark::StartX, {kZero.x(), 7}, {start.x(), 7}},
        {Kind::Length, Mark::StartZ, {27, kZero.y()}, {27, start.y()}},
        {Kind::Angle, Mark::StartAngle, start, beside(start, 13, 30)},
        {Kind::Length, Mark::FirstHole, start, holes[0]},
        {Kind::Length, Mark::Step, holes[1], holes[2]},
        {Kind::Point, Mark::Count, holes[3], holes[3]},
    };
    return s;
}

Scene circleOfHoles() {
    using forms::Mark;
    using Kind = SceneDim::Kind;
    const QPointF centre{58, 35};
    QPolygonF holes;
    for (int k = 1; k <= 6; ++k) holes << beside(centre, 13, 60.0 * k);
    Scene s = face(holes);
    s.detail.push_back(ring(centre, 13, 0, 360));
    s.dims = {
        {Kind::Length, Mark::CentreX, {kZero.x(), 8}, {centre.x(), 8}},
        {Kind::Length, Mark::CentreZ, {32, kZero.y()}, {32, centre.y()}},
        {Kind::Length, Mark::ArcRadius, centre, holes[4]},
        {Kind::Angle, Mark::StartAngle, centre, beside(centre, 13, 30)},
        {Kind::Angle, Mark::Step, centre, beside(centre, 13, 90)},
        {Kind::Point, Mark::Count, holes[2], holes[2]},
    };
    return s;
}

}  // namespace polyturn::hmi
