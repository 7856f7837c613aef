// Contours as tests write them down and read them back. Points are (z, x), X as a radius.
#pragma once
#include <cmath>
#include <numbers>
#include <string>

#include "channels/cycles/contour.hpp"

namespace polyturn::channels::cycles::testing {

class Drawn {
public:
    explicit Drawn(Point first) { contour_.first = first; }
    Drawn& line(Point to) {
        Element e;
        e.from = contour_.end();
        e.to = to;
        contour_.elements.push_back(e);
        return *this;
    }
    Drawn& arc(Point to, Point centre, bool clockwise) {  // up to half a circle
        Element e;
        e.form = clockwise ? Element::Form::ArcCw : Element::Form::ArcCcw;
        e.from = contour_.end();
        e.to = to;
        e.centre = centre;
        e.radius = std::hypot(e.from.z - centre.z, e.from.x - centre.x);
        e.first_angle = std::atan2(e.from.x - centre.x, e.from.z - centre.z);
        e.sweep = std::atan2(to.x - centre.x, to.z - centre.z) - e.first_angle;
        if (clockwise && e.sweep > 0) e.sweep -= 2 * std::numbers::pi;
        if (!clockwise && e.sweep < 0) e.sweep += 2 * std::numbers::pi;
        contour_.elements.push_back(e);
        return *this;
    }
    const Contour& contour() const { return contour_; }

private:
    Contour contour_;
};

inline std::string number(double value) {
    const std::string text = std::to_string(std::round(value * 1000) / 1000);
    return text.substr(0, text.find('.') + 4);
}

// "z,x" of the beginning, then of each element's end; an arc is marked by its direction and radius.
inline std::string shown(const Contour& contour) {
    if (contour.elements.empty()) return "nothing";
    std::string all = number(contour.first.z) + "," + number(contour.first.x);
    for (const Element& e : contour.elements) {
        all += e.form == Element::Form::Line    ? " "
               : e.form == Element::Form::ArcCw ? " cw" + number(e.radius) + ":"
                                                : " ccw" + number(e.radius) + ":";
        all += number(e.to.z) + "," + number(e.to.x);
    }
    return all;
}

}  // namespace polyturn::channels::cycles::testing
