#include "hmi/widgets/pictures/cycle_scene.hpp"

#include <cmath>

namespace polyturn::hmi {
namespace {

using forms::Mark;
using forms::Picture;
using Kind = SceneDim::Kind;

void length(Scene& s, Mark mark, QPointF from, QPointF to) {
    s.dims.push_back({Kind::Length, mark, from, to});
}
void way(Scene& s, Mark mark, QPointF from, QPointF to) {
    s.dims.push_back({Kind::Way, mark, from, to});
}
void point(Scene& s, Mark mark, QPointF at) { s.dims.push_back({Kind::Point, mark, at, at}); }
void feed(Scene& s, QPolygonF points) { s.paths.push_back({std::move(points), false}); }
void rapid(Scene& s, QPolygonF points) { s.paths.push_back({std::move(points), true}); }

constexpr double kFace = 72;  // Z of the face, the zero of most programs

// A shaft with a cone and a shoulder.
QPolygonF stepped() {
    return {{8, kCentre}, {kFace, kCentre}, {kFace, 17}, {56, 17},
            {44, 29},     {28, 29},         {28, 41},    {8, 41}};
}
QPolygonF contourOfStepped() {
    return {{kFace, 17}, {56, 17}, {44, 29}, {28, 29}, {28, 41}, {14, 41}};
}
QPolygonF bar(double top) { return {{8, kCentre}, {kFace, kCentre}, {kFace, top}, {8, top}}; }
QPolygonF moved(QPolygonF line, double z, double x) {
    line.translate(z, x);
    return line;
}
QPolygonF arc(QPointF centre, double radius, double from, double to) {  // degrees
    QPolygonF out;
    for (int i = 0; i <= 24; ++i) {
        const double a = (from + (to - from) * i / 24.0) * M_PI / 180;
        out << QPointF(centre.x() + radius * std::cos(a), centre.y() + radius * std::sin(a));
    }
    return out;
}

void contour(Scene& s) {
    point(s, Mark::Contour, {kFace, 17});
    point(s, Mark::Contour, {14, 41});
}

Scene roughing() {
    Scene s;
    s.part = stepped();
    s.blank = bar(47);
    s.tool = {82, 53};
    rapid(s, {{82, 53}, {82, 41.5}});
    feed(s, {{82, 41.5}, {31, 41.5}});
    rapid(s, {{31, 41.5}, {34, 44.5}, {82, 44.5}});
    feed(s, {{82, 36}, {31, 36}});
    rapid(s, {{31, 36}, {34, 39}, {78, 39}});
    feed(s, moved({{kFace, 17}, {56, 17}, {44, 29}, {28, 29}, {28, 41}}, 2.5, 2.5));
    length(s, Mark::Depth, {77, 47}, {77, 41.5});
    length(s, Mark::Retract, {31, 36}, {34, 39});
    length(s, Mark::AllowanceX, {64, 17}, {64, 19.5});
    length(s, Mark::AllowanceZ, {28, 38}, {30.5, 38});
    way(s, Mark::Feed, {62, 36}, {48, 36});
    way(s, Mark::FinishFeed, {66, 19.5}, {58, 19.5});
    point(s, Mark::StartX, {kFace, 17});
    point(s, Mark::StartZ, {kFace, 17});
    length(s, Mark::Safety, {34, 44.5}, {31, 41.5});
    contour(s);
    return s;
}

Scene faceRoughing() {
    Scene s;
    s.part = stepped();
    s.blank = {{8, kCentre}, {80, kCentre}, {80, 47}, {8, 47}};
    s.tool = {90, 53};
    for (const double z : {70.0, 62.0}) {
        feed(s, {{z, 53}, {z, z > 65 ? 20 : 21.5}});
        rapid(s, {{z, z > 65 ? 20 : 21.5}, {z + 3, z > 65 ? 23 : 24.5}, {z + 3, 53}});
    }
    feed(s, moved({{28, 41}, {28, 29}, {44, 29}, {56, 17}, {kFace, 17}}, 2.5, 2.5));
    rapid(s, {{90, 53}, {70, 53}});
    length(s, Mark::Depth, {70, 50}, {62, 50});
    length(s, Mark::Retract, {62, 21.5}, {65, 24.5});
    length(s, Mark::AllowanceX, {36, 29}, {36, 31.5});
    length(s, Mark::AllowanceZ, {28, 37}, {30.5, 37});
    way(s, Mark::Feed, {62, 44}, {62, 33});
    way(s, Mark::FinishFeed, {34, 31.5}, {42, 31.5});
    point(s, Mark::StartX, {kFace, 17});
    point(s, Mark::StartZ, {kFace, 17});
    length(s, Mark::Safety, {65, 24.5}, {62, 21.5});
    contour(s);
    return s;
}

Scene pattern() {
    Scene s;
    s.part = stepped();
    s.blank = moved(stepped(), 4, 8);
    s.tool = {92, 55};
    const QPolygonF line = contourOfStepped();
    for (const double k : {0.25, 0.6, 1.0}) feed(s, moved(line, 8 * k, 9 * k));
    rapid(s, {{92, 55}, {80, 26}});
    length(s, Mark::ReliefX, {62, 17}, {62, 26});
    length(s, Mark::ReliefZ, {28, 36}, {36, 36});
    length(s, Mark::Depth, {67, 22.4}, {67, 26});
    length(s, Mark::AllowanceX, {38, 29}, {38, 31.2});
    length(s, Mark::AllowanceZ, {28, 40}, {30, 40});
    point(s, Mark::Count, {50, 38});
    way(s, Mark::Feed, {78, 26}, {68, 26});
    way(s, Mark::FinishFeed, {70, 17}, {60, 17});
    point(s, Mark::StartX, {kFace, 17});
    point(s, Mark::StartZ, {kFace, 17});
    contour(s);
    return s;
}

Scene finishing() {
    Scene s;
    s.part = stepped();
    s.tool = {84, 50};
    rapid(s, {{84, 50}, {kFace, 17}});
    feed(s, contourOfStepped());
    rapid(s, {{14, 41}, {14, 50}, {84, 50}});
    way(s, Mark::FinishFeed, {68, 17}, {58, 17});
    contour(s);
    return s;
}

Scene peckFace() {
    Scene s;
    s.part = {{8, kCentre}, {kFace, kCentre}, {kFace, 14}, {40, 14},    {40, 22},    {kFace, 22},
              {kFace, 30},  {40, 30},         {40, 38},    {kFace, 38}, {kFace, 46}, {8, 46}};
    s.blank = bar(46);
    s.tool = {84, 38};
    feed(s, {{84, 34}, {56, 34}});
    rapid(s, {{56, 32.6}, {60, 32.6}});
    feed(s, {{60, 34}, {40, 34}});
    rapid(s, {{40, 34}, {40, 36.5}, {84, 36.5}, {84, 18}});
    feed(s, {{84, 18}, {40, 18}});
    length(s, Mark::EndX, {93, kCentre}, {93, 18});
    length(s, Mark::EndZ, {kFace, 50}, {40, 50});
    length(s, Mark::Peck, {kFace, 27}, {56, 27});
    length(s, Mark::Retract, {56, 32.6}, {60, 32.6});
    length(s, Mark::Step, {88, 34}, {88, 18});
    length(s, Mark::Aside, {37, 34}, {37, 36.5});
    way(s, Mark::Feed, {82, 34}, {74, 34});
    return s;
}

Scene groove() {
    Scene s;
    s.part = {{8, kCentre}, {kFace, kCentre}, {kFace, 40}, {62, 40}, {62, 20}, {54, 20},
              {54, 40},     {38, 40},         {38, 20},    {30, 20}, {30, 40}, {8, 40}};
    s.blank = bar(40);
    s.tool = {58, 50};
    feed(s, {{58, 48}, {58, 30}});
    rapid(s, {{56.6, 30}, {56.6, 33}});
    feed(s, {{58, 33}, {58, 20}});
    rapid(s, {{58, 20}, {60, 20}, {60, 48}, {34, 48}});
    feed(s, {{34, 48}, {34, 20}});
    length(s, Mark::EndX, {25, kCentre}, {25, 20});
    length(s, Mark::EndZ, {kFace, 12}, {34, 12});
    length(s, Mark::StartX, {80, kCentre}, {80, 40});
    length(s, Mark::StartZ, {kFace, 55}, {62, 55});
    length(s, Mark::Peck, {49, 40}, {49, 30});
    length(s, Mark::Retract, {56.6, 30}, {56.6, 33});
    length(s, Mark::Step, {58, 52}, {34, 52});
    length(s, Mark::Aside, {58, 17}, {60, 17});
    length(s, Mark::Safety, {44, 40}, {44, 48});
    point(s, Mark::Dwell, {34, 20});
    way(s, Mark::Feed, {34, 46}, {34, 36});
    return s;
}

Scene grooveFace() {
    Scene s = peckFace();
    s.dims.clear();
    length(s, Mark::StartX, {93, kCentre}, {93, 38});
    length(s, Mark::StartZ, {kFace, 54}, {84, 54});
    length(s, Mark::EndX, {80, kCentre}, {80, 14});
    length(s, Mark::EndZ, {kFace, 50}, {40, 50});
    length(s, Mark::Step, {88, 34}, {88, 18});
    length(s, Mark::Safety, {kFace, 42}, {84, 42});
    point(s, Mark::Dwell, {40, 18});
    return s;
}

// A thread with its teeth; `taper`: it rises to the left.
Scene thread(bool passes) {
    Scene s;
    s.part = {{8, kCentre}, {kFace, kCentre}};
    for (int i = 0; i <= 8; ++i) {
        const double z = kFace - 4.0 * i;
        s.part << QPointF(z, 26 + 0.3 * i) << QPointF(z - 2, 34 + 0.3 * i);
    }
    s.part << QPointF(38, 36.7) << QPointF(30, 36.7) << QPointF(30, 42) << QPointF(8, 42);
    s.blank = {{8, kCentre}, {kFace, kCentre}, {kFace, 34}, {38, 36.7},
               {30, 36.7},   {30, 42},         {8, 42}};
    s.tool = {86, 50};
    rapid(s, {{86, 50}, {86, 26}});
    feed(s, {{86, 25.4}, {43, 28.6}, {37, 36}});
    rapid(s, {{37, 36}, {37, 50}, {86, 50}});
    length(s, Mark::EndX, {22, kCentre}, {22, 28.6});
    length(s, Mark::EndZ, {kFace, 12}, {37, 12});
    length(s, Mark::StartX, {80, kCentre}, {80, 34});
    length(s, Mark::StartZ, {kFace, 16}, {86, 16});
    length(s, Mark::Taper, {91, 25.4}, {91, 28.6});
    length(s, Mark::Lead, {kFace - 6, 39}, {kFace - 10, 39});
    way(s, Mark::Feed, {80, 25.8}, {70, 26.6});
    point(s, Mark::StartAngle, {86, 25.4});
    length(s, Mark::RunIn, {kFace, 20}, {86, 20});
    length(s, Mark::Chamfer, {43, 40}, {37, 40});
    if (!passes) return s;
    length(s, Mark::ThreadDepth, {62, 26.6}, {62, 34.6});
    length(s, Mark::FirstPass, {54, 35.2}, {54, 32});
    length(s, Mark::LeastPass, {50, 30}, {50, 28.8});
    length(s, Mark::AllowanceX, {58, 27.2}, {58, 28.6});
    length(s, Mark::Safety, {70, 34}, {70, 50});
    s.dims.push_back({Kind::Angle, Mark::ToolAngle, {46, 28.4}, {46, 38}});
    point(s, Mark::Count, {66, 30});
    return s;
}

Scene faceThread() {
    Scene s;
    s.part = {{8, kCentre}};
    s.part << QPointF(62, kCentre);
    for (int i = 0; i <= 7; ++i)
        s.part << QPointF(64, 10 + 4.0 * i) << QPointF(kFace, 12 + 4.0 * i);
    s.part << QPointF(kFace, 44) << QPointF(8, 44);
    s.blank = bar(44);
    s.tool = {88, 52};
    rapid(s, {{88, 52}, {64, 52}});
    feed(s, {{64, 52}, {64, 14}, {72, 8}});
    rapid(s, {{72, 8}, {88, 8}, {88, 52}});
    length(s, Mark::StartX, {94, kCentre}, {94, 44});
    length(s, Mark::EndX, {88, kCentre}, {88, 14});
    point(s, Mark::StartZ, {kFace, 44});
    point(s, Mark::EndZ, {64, 14});
    length(s, Mark::ThreadDepth, {64, 48}, {kFace, 48});
    length(s, Mark::FirstPass, {69, 40}, {kFace, 40});
    length(s, Mark::LeastPass, {64, 30}, {65.5, 30});
    length(s, Mark::Lead, {58, 22}, {58, 26});
    length(s, Mark::Chamfer, {76, 14}, {76, 8});
    length(s, Mark::Safety, {kFace, 55}, {88, 55});
    length(s, Mark::AllowanceX, {64, 35}, {66, 35});
    length(s, Mark::RunIn, {58, 44}, {58, 52});
    s.dims.push_back({Kind::Angle, Mark::ToolAngle, {64, 18}, {74, 18}});
    point(s, Mark::StartAngle, {64, 52});
    point(s, Mark::Count, {68, 24});
    return s;
}

// A thread along an arc: the teeth stand on it, the tool's way is one.
Scene barrelThread() {
    Scene s;
    const auto crest = [](double z) { return 38 - (z - 54) * (z - 54) / 40.0; };
    s.part = {{8, kCentre}, {kFace, kCentre}};
    for (double z = kFace; z >= 38; z -= 4)
        s.part << QPointF(z, crest(z) - 8) << QPointF(z - 2, crest(z - 2));
    s.part << QPointF(32, crest(36)) << QPointF(32, 42) << QPointF(8, 42);
    s.blank = {{8, kCentre}, {kFace, kCentre}};
    for (double z = kFace; z >= 36; z -= 2) s.blank << QPointF(z, crest(z));
    s.blank << QPointF(32, crest(36)) << QPointF(32, 42) << QPointF(8, 42);
    s.tool = {86, 50};
    QPolygonF way;
    for (double z = 80; z >= 38; z -= 2) way << QPointF(z, crest(z) - 8);
    rapid(s, {{86, 50}, {86, way.front().y()}, way.front()});
    feed(s, way);
    rapid(s, {way.back(), {38, 50}, {86, 50}});
    length(s, Mark::EndX, {22, kCentre}, {22, way.back().y()});
    length(s, Mark::EndZ, {kFace, 9}, {38, 9});
    length(s, Mark::Lead, {58, 42}, {54, 42});
    length(s, Mark::ArcRadius, {46, 28}, {46, kCentre});
    length(s, Mark::RunIn, {kFace, 24}, {80, 24});
    length(s, Mark::Chamfer, {44, 45}, {38, 45});
    point(s, Mark::StartAngle, way.front());
    return s;
}

Scene turning() {
    Scene s;
    s.part = {{8, kCentre}, {kFace, kCentre}, {kFace, 24}, {30, 29}, {30, 42}, {8, 42}};
    s.blank = bar(42);
    s.tool = {86, 50};
    rapid(s, {{86, 50}, {86, 22.4}});
    feed(s, {{86, 22.4}, {30, 29}, {30, 50}});
    rapid(s, {{30, 50}, {86, 50}});
    length(s, Mark::EndX, {22, kCentre}, {22, 29});
    length(s, Mark::EndZ, {kFace, 13}, {30, 13});
    length(s, Mark::Taper, {92, 22.4}, {92, 29});
    way(s, Mark::Feed, {66, 24.8}, {54, 26.2});
    return s;
}

Scene facing() {
    Scene s;
    s.part = {{8, kCentre}, {kFace, kCentre}, {kFace, 16}, {68, 44}, {8, 44}};
    s.blank = {{8, kCentre}, {80, kCentre}, {80, 44}, {8, 44}};
    s.tool = {90, 52};
    rapid(s, {{90, 52}, {66.9, 52}});
    feed(s, {{66.9, 52}, {kFace, 16}, {90, 16}});
    rapid(s, {{90, 16}, {90, 52}});
    length(s, Mark::EndX, {84, kCentre}, {84, 16});
    length(s, Mark::EndZ, {80, 10}, {kFace, 10});
    length(s, Mark::Taper, {66.9, 55}, {kFace, 55});
    way(s, Mark::Feed, {69, 38}, {70.6, 26});
    return s;
}

// A hole along Z in the face. `tap`: threaded; `bore`: back with the feed.
Scene holeFace(bool tap, bool bore) {
    Scene s;
    s.part = {{8, kCentre}, {kFace, kCentre}, {kFace, 20}, {36, 20}, {32, 25},
              {36, 30},     {kFace, 30},      {kFace, 46}, {8, 46}};
    s.blank = bar(46);
    s.tool = {90, 25};
    s.drill = true;
    rapid(s, {{90, 25}, {79, 25}});
    if (tap || bore) {
        feed(s, {{79, 25}, {35, 25}});
        feed(s, {{35, 27}, {79, 27}});
    } else {
        feed(s, {{79, 25}, {58, 25}});
        rapid(s, {{58, 27}, {79, 27}});
        feed(s, {{62, 23.4}, {34, 23.4}});
    }
    if (tap)
        for (double z = 40; z < 70; z += 3) s.detail.push_back({{z, 20}, {z - 2, 30}});
    length(s, Mark::Place, {82, kCentre}, {82, 25});
    length(s, Mark::Bottom, {kFace, 36}, {33, 36});
    length(s, Mark::RLevel, {kFace, 16}, {79, 16});
    length(s, Mark::Peck, {kFace, 41}, {58, 41});
    length(s, Mark::Retract, {58, 33}, {62, 33});
    length(s, Mark::LeastPass, {42, 41}, {36, 41});
    if (tap) length(s, Mark::Lead, {61, 33}, {64, 33});
    length(s, Mark::Safety, {kFace, 12}, {79, 12});
    point(s, Mark::StartZ, {kFace, 46});
    point(s, Mark::Dwell, {33, 25});
    point(s, Mark::Count, {64, 50});
    way(s, Mark::Feed, {72, 25}, {62, 25});
    return s;
}

// The same across, from above.
Scene holeSide(bool tap, bool bore) {
    Scene s;
    s.part = {{8, kCentre}, {86, kCentre}, {86, 40}, {52, 40}, {52, 18},
              {47, 14},     {42, 18},      {42, 40}, {8, 40}};
    s.blank = {{8, kCentre}, {86, kCentre}, {86, 40}, {8, 40}};
    s.tool = {47, 56};
    s.drill = s.across = true;
    rapid(s, {{47, 56}, {47, 45}});
    if (tap || bore) {
        feed(s, {{47, 45}, {47, 16}});
        feed(s, {{49, 16}, {49, 45}});
    } else {
        feed(s, {{47, 45}, {47, 30}});
        rapid(s, {{49, 30}, {49, 45}});
        feed(s, {{45.4, 32}, {45.4, 16}});
    }
    if (tap)
        for (double x = 20; x < 38; x += 3) s.detail.push_back({{42, x}, {52, x - 2}});
    length(s, Mark::Place, {86, 52}, {47, 52});
    length(s, Mark::Bottom, {36, kCentre}, {36, 14.5});
    length(s, Mark::RLevel, {57, 40}, {57, 45});
    length(s, Mark::Peck, {62, 40}, {62, 30});
    if (tap) length(s, Mark::Lead, {56, 26}, {56, 29});
    point(s, Mark::Dwell, {47, 15});
    point(s, Mark::Count, {30, 46});
    way(s, Mark::Feed, {47, 42}, {47, 34});
    return s;
}

Scene section(bool facing, bool round) {
    Scene s;
    const QPointF start = facing ? QPointF(36, 18) : QPointF(66, 17),
                  end = facing ? QPointF(66, 38) : QPointF(34, 38);
    QPolygonF line{start, end};
    if (round)
        line = facing ? arc({66, 18 - 12.5 + 0.0}, 32.5, 157.4, 90)
                      : arc({34, 38 - 26.9}, 32.5, 10.5, 90);
    if (round && facing) {
        line.front() = start;
        line.back() = end;
    }
    s.part << QPointF(8, kCentre);
    if (facing) {
        s.part << QPointF(36, kCentre);
        for (const QPointF& p : line) s.part << p;
        s.part << QPointF(66, 42) << QPointF(8, 42);
    } else {
        s.part << QPointF(66, kCentre);
        for (const QPointF& p : line) s.part << p;
        s.part << QPointF(34, 42) << QPointF(8, 42);
    }
    s.blank = {{8, kCentre}, {kFace, kCentre}, {kFace, 42}, {8, 42}};
    s.tool = {84, 48};
    if (facing) {
        for (const double z : {66.0, 58.0}) {
            feed(s, {{z, 48}, {z, z > 60 ? 41.0 : 37.0}});
            rapid(s, {{z, z > 60 ? 41.0 : 37.0}, {z + 3, z > 60 ? 44.0 : 40.0}, {z + 3, 48}});
        }
    } else {
        for (const double x : {38.0, 32.0}) {
            feed(s, {{84, x}, {x > 35 ? 38.0 : 44.0, x}});
            rapid(s, {{x > 35 ? 38.0 : 44.0, x}, {x > 35 ? 41.0 : 47.0, x + 3}, {84, x + 3}});
        }
    }
    feed(s, moved(line, 2.5, 2));
    length(s, Mark::StartX, {90, kCentre}, {90, start.y()});
    length(s, Mark::StartZ, {kFace, facing ? 12.0 : 9.0}, {start.x(), facing ? 12.0 : 9.0});
    length(s, Mark::EndX, {20, kCentre}, {20, end.y()});
    length(s, Mark::EndZ, {kFace, 55}, {end.x(), 55});
    if (facing) {
        length(s, Mark::Depth, {66, 51}, {58, 51});
        length(s, Mark::Safety, {58, 37}, {61, 40});
        way(s, Mark::Feed, {58, 46}, {58, 39});
    } else {
        length(s, Mark::Depth, {78, 38}, {78, 32});
        length(s, Mark::Safety, {44, 32}, {47, 35});
        way(s, Mark::Feed, {74, 32}, {60, 32});
    }
    const QPointF middle = line.at(line.size() / 2);
    const QPointF on = round ? middle : (start + end) / 2;
    length(s, Mark::AllowanceX, on, on + QPointF(0, 4));
    length(s, Mark::AllowanceZ, on + QPointF(-1, 0), on + QPointF(4, 0));
    way(s, Mark::FinishFeed, start + QPointF(2.5, 2),
        start + (end - start) * 0.3 + QPointF(2.5, 2));
    if (round) {
        const QPointF centre = facing ? QPointF(66, 9) : QPointF(34, 11);
        length(s, Mark::CentreX, {start.x(), start.y()}, {start.x(), centre.y()});
        length(s, Mark::CentreZ, {start.x(), centre.y()}, centre);
    }
    return s;
}

}  // namespace

Scene sceneOf(Picture picture) {
    switch (picture) {
        case Picture::Roughing:
            return roughing();
        case Picture::FaceRoughing:
            return faceRoughing();
        case Picture::Pattern:
            return pattern();
        case Picture::Finishing:
            return finishing();
        case Picture::PeckFace:
            return peckFace();
        case Picture::Groove:
            return groove();
        case Picture::GrooveFace:
            return grooveFace();
        case Picture::Thread:
            return thread(true);
        case Picture::FaceThread:
            return faceThread();
        case Picture::Turning:
            return turning();
        case Picture::Facing:
            return facing();
        case Picture::TurningThread:
            return thread(false);
        case Picture::DrillFace:
            return holeFace(false, false);
        case Picture::DrillSide:
            return holeSide(false, false);
        case Picture::TapFace:
            return holeFace(true, false);
        case Picture::TapSide:
            return holeSide(true, false);
        case Picture::BoreFace:
            return holeFace(false, true);
        case Picture::BoreSide:
            return holeSide(false, true);
        case Picture::SectionTurning:
            return section(false, false);
        case Picture::SectionFacing:
            return section(true, false);
        case Picture::ArcTurning:
            return section(false, true);
        case Picture::ArcFacing:
            return section(true, true);
        case Picture::BarrelThread:
            return barrelThread();
        case Picture::DrillPlanes:
            return planesOfHole(false);
        case Picture::ReamPlanes:
            return planesOfHole(true);
        case Picture::HoleRow:
            return rowOfHoles();
        case Picture::HoleCircle:
            return circleOfHoles();
    }
    return {};
}

}  // namespace polyturn::hmi
