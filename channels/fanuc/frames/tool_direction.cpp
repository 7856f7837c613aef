// G53.1: the rotary axes of head and table go where the tool points along Z of the rotated system
// (G68.1).
//
//   H(a, b) t = T(a, b) w      t tool with both axes at 0 (N3201), w that Z; heads turn the tool,
//                              tables turn the part
//
// Found from a raster of starts by Newton steps on the two angles; of all solutions the one with
// the least way counts. Under G43.1 and G43.4 the tip stays where it is and the linear axes follow;
// without them nothing but the rotary axes moves, which N3212 #7 must say.
#include "channels/fanuc/frames/tool_direction.hpp"

#include <array>
#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "channels/state/tip_control.hpp"
#include "ipc/kinematics/five_axis.hpp"

namespace polyturn::channels::fanuc {
namespace {

namespace f = five_axis;

using Direction = f::Vector<double>;

constexpr double kPointsThere = 1e-9;

// How far the tool is from pointing along w, as a vector.
Direction gap(const Kinematics& k, const Direction& t, const Direction& w,
              const std::array<double, 2>& angle) {
    Direction tool = t, part = w;
    if (k.value[f::kSecondIsHead] != 0 && f::exists(k, f::kSecondDirection))
        tool = f::turned(&k.value[f::kSecondDirection], angle[1], tool);
    if (k.value[f::kFirstIsHead] != 0 && f::exists(k, f::kFirstDirection))
        tool = f::turned(&k.value[f::kFirstDirection], angle[0], tool);
    if (k.value[f::kSecondIsHead] == 0 && f::exists(k, f::kSecondDirection))
        part = f::turned(&k.value[f::kSecondDirection], angle[1], part);
    if (k.value[f::kFirstIsHead] == 0 && f::exists(k, f::kFirstDirection))
        part = f::turned(&k.value[f::kFirstDirection], angle[0], part);
    return {tool[0] - part[0], tool[1] - part[1], tool[2] - part[2]};
}

double size(const Direction& d) { return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]); }

// Gauss and Newton on the free angles; true where it ends with the tool pointing there.
bool refine(const Kinematics& k, const Direction& t, const Direction& w,
            const std::array<bool, 2>& free, std::array<double, 2>& angle) {
    constexpr double kStep = 1e-4;  // degrees
    for (int round = 0; round < 40; ++round) {
        const Direction g = gap(k, t, w, angle);
        if (size(g) < kPointsThere) return true;
        double a[2][2] = {{1e-12, 0}, {0, 1e-12}}, b[2] = {0, 0};
        Direction slope[2]{};
        for (std::size_t i = 0; i < 2; ++i) {
            if (!free[i]) continue;
            std::array<double, 2> ahead = angle, behind = angle;
            ahead[i] += kStep;
            behind[i] -= kStep;
            const Direction hi = gap(k, t, w, ahead), lo = gap(k, t, w, behind);
            for (std::size_t r = 0; r < 3; ++r) slope[i][r] = (hi[r] - lo[r]) / (2 * kStep);
        }
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t r = 0; r < 3; ++r) b[i] += slope[i][r] * g[r];
            for (std::size_t j = 0; j < 2; ++j)
                for (std::size_t r = 0; r < 3; ++r) a[i][j] += slope[i][r] * slope[j][r];
        }
        const double det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
        if (det == 0) return false;
        const double d0 = (b[0] * a[1][1] - b[1] * a[0][1]) / det,
                     d1 = (a[0][0] * b[1] - a[1][0] * b[0]) / det;
        if (free[0]) angle[0] -= std::fmax(-20.0, std::fmin(20.0, d0));
        if (free[1]) angle[1] -= std::fmax(-20.0, std::fmin(20.0, d1));
    }
    return false;
}

}  // namespace

bool g_tool_direction(Execution& x, const GCode&) {
    if (x.core.reads_ahead()) return x.core.fail(Alarm::TransformPlace, 'G', "G41 G42");
    if (x.modal.frames.rotation.is_identity())
        return x.core.fail(Alarm::CycleWordMissing, 'G', "G68.1");
    const bool tip = controls_tip(x.core);
    const params::Table& table = x.core.view().table();
    const unsigned l = x.core.view().channel;
    if (!tip && (x.core.transformed() || !params::bit(table, params::n3212_5d_control, l, 7)))
        return x.core.fail(Alarm::CycleWordMissing, 'G', "G43.1, G43.4 (or N3212 #7)");
    Transformation described;
    if (!tip && !describe_head(x.core, false, described)) return false;
    const Kinematics k = tip ? x.core.path.transformation.kinematics : described.kinematics;
    Direction t{};
    t[static_cast<std::size_t>(params::get(table, params::n3201_tool_axis_direction, l) - 1)] = 1.0;
    const Point3 along = x.modal.frames.rotation.direction({0, 0, 1});
    const Direction w{along[0], along[1], along[2]};
    std::array<bool, 2> free{};
    std::array<double, 2> now{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::uint8_t place = k.axis[3 + i];
        free[i] = place != kNoPlace;
        now[i] = free[i] ? x.core.path.machine[place] : k.centre[3 + i];
    }
    constexpr double kRaster = 15.0;
    std::array<double, 2> best{};
    double least = 1e300;
    for (double a = 0; a < (free[0] ? 360.0 : 1.0); a += kRaster)
        for (double b = 0; b < (free[1] ? 360.0 : 1.0); b += kRaster) {
            std::array<double, 2> angle{free[0] ? a : now[0], free[1] ? b : now[1]};
            if (!refine(k, t, w, free, angle)) continue;
            double way = 0.0;
            for (std::size_t i = 0; i < 2; ++i) {
                angle[i] = now[i] + std::remainder(angle[i] - now[i], 360.0);
                way += std::fabs(angle[i] - now[i]);
            }
            if (way < least - 1e-6) {
                least = way;
                best = angle;
            }
        }
    if (least > 1e299)
        return x.core.fail(Alarm::FiveAxisUndefined, 'G',
                           "G53.1: no angle of head and table points the tool there");
    AxisValues target = x.core.path.programmed;
    for (std::size_t i = 0; i < 2; ++i)
        if (free[i]) target[k.axis[3 + i]] += std::round((best[i] - now[i]) * 1e6) / 1e6;
    return x.core.rapid(target);
}

}  // namespace polyturn::channels::fanuc
