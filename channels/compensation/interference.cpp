#include "channels/compensation/interference.hpp"

#include "channels/angles.hpp"

namespace polyturn::channels::compensation {
namespace {

constexpr double kStands = 1e-7;  // mm: the nose does not move along the element

}  // namespace

bool interferes(const Element& e, Vec from, Vec to) {
    const Vec path = e.end + to - (e.start + from);
    if (!e.arc) return dot(path, e.end - e.start) < 0 && length(path) > kStands;
    // A nose larger than the arc it lies in comes out on the other side of the centre.
    if (e.nose_path_radius(e.start_radius) < -kStands ||
        e.nose_path_radius(e.end_radius) < -kStands)
        return length(path) > kStands;
    const Vec a = e.start + from - e.centre, b = e.end + to - e.centre;
    if (length(a) < kStands || length(b) < kStands) return false;
    // The turn nearest to the programmed one: more than half a turn off it appears as a turn the
    // other way or a lap more.
    const double turn = std::atan2(cross(a, b), dot(a, b));
    const double driven = e.sweep + std::remainder(turn - e.sweep, kTurn);
    const double forward = e.sweep > 0 ? driven : -driven;
    const double slack = kStands / length(a);
    return forward < -slack || forward > std::fmax(kTurn, std::fabs(e.sweep)) + slack;
}

Verdict check_element(const Element& e, Vectors& at_start, Vectors& at_end, Check check) {
    if (check == Check::Off) return Verdict::Clean;
    // in use: at_start[0, last) and at_end[first, count)
    unsigned last = at_start.count, first = 0;
    bool dropped = false;
    while (interferes(e, at_start.at[last - 1], at_end.at[first])) {
        const bool start_has = last > 1, end_has = first + 1 < at_end.count;
        if (check == Check::Alarm || (!start_has && !end_has)) return Verdict::Interferes;
        if (start_has) --last;
        if (end_has) ++first;
        dropped = true;
    }
    if (!dropped) return Verdict::Clean;
    at_start.count = last;
    Vectors rest;
    for (unsigned i = first; i < at_end.count; ++i)
        rest.add(at_end.at[i], i > first && at_end.by_arc[i], at_end.overshoot[i]);
    at_end = rest;
    return Verdict::Corrected;
}

}  // namespace polyturn::channels::compensation
