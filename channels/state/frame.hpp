// A frame: the transformation of a point of one coordinate system into the system around it.
//
//   outer = linear * point + shift      X, Y, Z (as a radius, mm), by PlaneRole, whatever places
//                                       they have in the channel
//   outer = scale * value + offset      every other axis, by its index
//
// A chain of frames (basic, settable, programmable, additive ones) is one frame again:
// Frame::operator*.
//
// Invariant   linear can be inverted and no scale is 0; a language asks invertible() before it
//             hands a frame to Core.
#pragma once
#include <cstdint>

#include "channels/sink.hpp"

namespace polyturn::channels {

enum class GeoAxis : std::uint8_t { X, Y, Z };
using Point3 = std::array<double, 3>;  // X Y Z

struct Frame {
    std::array<Point3, 3> linear{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // rows
    Point3 shift{};
    AxisValues scale = ones(), offset{};  // of the axes that are not X, Y, Z

    static Frame translation(const Point3& by);
    static Frame translation(unsigned place, double by);  // an axis that is none of X, Y, Z
    // right-handed: Y to Z, Z to X, X to Y
    static Frame rotation(GeoAxis about, double degrees);
    static Frame scaling(const Point3& factors);
    static Frame scaling(unsigned place, double factor);
    static Frame mirror(bool x, bool y, bool z);
    static Frame mirror(unsigned place) { return scaling(place, -1.0); }

    // First inner, then this one.
    Frame operator*(const Frame& inner) const;
    bool invertible() const;
    Frame inverse() const;
    bool is_identity() const;
    double determinant() const;
    Point3 map(const Point3& point) const;         // shift included
    Point3 direction(const Point3& vector) const;  // without it
    // where that direction points outside, times its scale
    Point3 axis(GeoAxis of) const;

private:
    static constexpr AxisValues ones() {
        AxisValues all{};
        for (double& one : all) one = 1.0;
        return all;
    }
};

}  // namespace polyturn::channels
