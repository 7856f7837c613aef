// What the picture of a cycle is made of: the part, the tool's way, and for each mark of a form
// what it dimensions. Lathe coordinates of a sheet of 100 x 60: Z to the right, X upwards, the
// centre line at kCentre; the shapes explain, they are not to scale.
#pragma once
#include <QPolygonF>
#include <vector>

#include "ipc/model/languages/forms.hpp"

namespace polyturn::hmi {

inline constexpr double kSceneWidth = 100, kSceneHeight = 60, kCentre = 5;

struct SceneDim {
    // Way: an arrow; Point: a place
    enum class Kind : std::uint8_t { Length, Way, Point, Angle } kind = Kind::Length;
    forms::Mark mark = forms::Mark::None;
    QPointF from, to;
};

struct Scene {
    struct Path {
        QPolygonF points;
        bool rapid = false;
    };
    // outline of the finished part (filled) and of what it is made from
    QPolygonF part, blank;
    std::vector<QPolygonF> detail;  // further lines of the part
    std::vector<Path> paths;        // of the tool
    std::vector<SceneDim> dims;
    QPointF tool;        // where the tool stands when the cycle begins
    bool drill = false;  // the tool is a drill, from above when `across`
    bool across = false;
    // the part is seen from the front, the tool from behind: no centre line lies in the sheet
    bool front = false;
};

Scene sceneOf(forms::Picture picture);
// cycle_scene_holes.cpp
Scene planesOfHole(bool feed_back);
Scene rowOfHoles();
Scene circleOfHoles();

}  // namespace polyturn::hmi
