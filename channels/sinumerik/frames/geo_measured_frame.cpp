// MEAFRAME: the frame that takes three wanted points of a workpiece to where they have been
// measured (sinumerik_part3 9.1).
//
//        P3            both triples are rigid: x' from P1 to P2, z' square on their plane. The
//                      rotation takes the triad of the
//       /              wanted points to that of the measured ones, the shift their centroid to the
//                      other one.
//     P1 ------ P2     P1 and the side P1 P2 count for more than P3: the specification says no more of it.
//
// The quality is the largest distance that is left, in mm. Points on one line say nothing about a
// rotation and are refused.
#include "channels/sinumerik/frames/geo_measured_frame.hpp"

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/frames/geo_frames.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

using Triple = std::array<Point3, 3>;  // X as a radius, Y, Z, mm

Point3 minus(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point3 cross(const Point3& a, const Point3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point3& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

// Columns x' y' z'; false: the points lie on one line.
bool triad(const Triple& p, Frame& out) {
    const Point3 x = minus(p[1], p[0]), z = cross(x, minus(p[2], p[0])), y = cross(z, x);
    if (!(length(z) > 1e-6 * length(x) * length(minus(p[2], p[0])))) return false;
    for (std::size_t row = 0; row < 3; ++row)
        out.linear[row] = {x[row] / length(x), y[row] / length(y), z[row] / length(z)};
    return true;
}

Point3 centroid(const Triple& p) {
    Point3 sum{};
    for (const Point3& one : p)
        for (std::size_t k = 0; k < 3; ++k) sum[k] += one[k] / 3;
    return sum;
}

}  // namespace

bool f_meaframe(Execution& x, Call& call) {
    Triple points[2];  // measured, wanted
    Frame axes[2];
    for (std::size_t which = 0; which < 2; ++which) {
        const Variable& said = *call.arguments[which].reference.variable;
        const auto wrong = [&] {
            return fail(x, Alarm::FunctionArgument, "MEAFRAME", static_cast<double>(which + 1));
        };
        if (said.cells.size() != 9 || said.dimensions.size() != 2 || said.dimensions[1] != 3)
            return wrong();
        for (std::size_t i = 0; i < 9; ++i)
            points[which][i / 3][i % 3] = said.cells[i].number * unit(x);
        if (!triad(points[which], axes[which])) return wrong();
    }
    Frame frame = axes[0] * axes[1].inverse();
    frame.shift = minus(centroid(points[0]), frame.direction(centroid(points[1])));
    double left = 0;
    for (std::size_t i = 0; i < 3; ++i)
        left = std::max(left, length(minus(frame.map(points[1][i]), points[0][i])));
    FrameValue value = components_of(x, frame, {});
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        const int place = x.core.view().axis_by_role(kRoles[k]);
        if (place < 0 && std::fabs(frame.shift[k]) > 1e-9)
            return fail(x, Alarm::FrameAxisMissing, std::string(1, "XYZ"[k]));
        if (place < 0) continue;
        const auto i = static_cast<std::size_t>(place);
        // as CTRANS says it
        value.coarse_mm[i] = value.fine_mm[i];
        value.fine_mm[i] = 0;
        value.scale[i] = 1;
    }
    store(x, call.arguments[2].reference, Value::of_real(left / unit(x)));
    call.result = Value::of_frame(value);
    return true;
}

}  // namespace polyturn::channels::sinumerik
