// Cutting speeds: SVC of a rotating tool, SCC the axis that G96 looks at (sinumerik_part1 7.2,
// 7.3).
#include "channels/sinumerik/spindles/cutting_speeds.hpp"

#include <numbers>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/spindles/speed_limits.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "channels/sinumerik/tools/tool_functions.hpp"

namespace polyturn::channels::sinumerik {
namespace {

double speed_of_tool(double m_min, double radius_mm, double most) {
    const double rpm = m_min * 1000.0 / (2.0 * std::numbers::pi * radius_mm);
    return most > 0 ? std::fmin(rpm, most) : rpm;
}

}  // namespace

// SVC = cutting speed of the tool's edge in m/min: n = SVC * 1000 / (2 pi R).
bool a_cutting_speed(Execution& x, const Word& word) {
    const auto found = x.tools.table.find(x.modal.tool);
    const Edge* edge = nullptr;
    if (found != x.tools.table.end())
        if (const int number = edge_of_d(found->second, x.modal.edge))
            edge = &found->second.edges.at(number);
    const double radius =
        edge ? edge->dp[6] + edge->dp[15] + edge->sum[1][6] + edge->setup[1][6] : 0.0;
    if (radius <= 0) return fail_word(x, Alarm::ToolUnknown, word, "SVC: R = 0");
    if (surface_speed_active(x)) return fail_word(x, Alarm::CodesContradict, word, "SVC, G96");
    double speed = word.number();
    if (!metric_technology(x)) speed *= 0.3048;  // feet a minute
    // output here, whatever else the block says (7.2)
    const bool other = word.index > 0 && word.index != x.core.path.spindle.spindle;
    if (other && !x.core.commit_spindle()) return false;
    return with_spindle(x, other ? static_cast<std::uint16_t>(word.index) : std::uint16_t{0}, [&] {
        const std::uint16_t n = x.core.path.spindle.spindle;
        if (n == 0 || spindle_closed(x, n))
            return fail_word(x, n ? Alarm::CodesContradict : Alarm::SpindleMissing, word,
                             "SVC, SPOS");
        x.modal.cutting_speeds |= 1u << (n - 1);
        x.modal.cutting_speed_m_min[n] = speed;
        return ask_speed(x, speed_of_tool(speed, radius, found->second.max_velocity)) &&
               (!other || x.core.commit_spindle());
    });
}

// Another tool or offset: spindles whose speed comes from SVC turn as it asks now.
bool refresh_cutting_speeds(Execution& x) {
    if (!x.modal.cutting_speeds || !x.modal.edge_data) return true;
    const Edge& edge = *x.modal.edge_data;
    const double radius = edge.dp[6] + edge.dp[15] + edge.sum[1][6] + edge.setup[1][6];
    if (radius <= 0) return true;
    const auto found = x.tools.table.find(x.modal.tool);
    const double most = found == x.tools.table.end() ? 0.0 : found->second.max_velocity;
    for (std::uint16_t n = 1; n <= kMaxSpindles; ++n) {
        if (!(x.modal.cutting_speeds >> (n - 1) & 1u)) continue;
        if (!with_spindle(x, n, [&] {
                return ask_speed(x, speed_of_tool(x.modal.cutting_speed_m_min[n], radius, most)) &&
                       x.core.commit_spindle();
            }))
            return false;
    }
    return true;
}

// GWPSON(t), GWPSOF(t): S of the master spindle is the speed of a grinding wheel's rim in m/s, n =
// S * 60000 / (2 pi R); t: a tool that is not the active one (7.4). R is the edge's radius, or its
// length 1 where it has none.
bool p_wheel_speed(Execution& x, Call& c) {
    const bool on = x.block.procedures.front().first->name == "GWPSON";
    const auto found =
        x.tools.table.find(c.has(0) ? static_cast<std::int64_t>(c.value(0).number) : x.modal.tool);
    // TPG1: the wheel's spindle
    const double own = found == x.tools.table.end() ? 0.0 : found->second.grinding[1];
    const auto n =
        static_cast<std::uint16_t>(own >= 1 && own <= kMaxSpindles ? own : x.modal.master_spindle);
    if (n == 0 || !x.core.view().machine.spindle(n).exists()) return fail(x, Alarm::SpindleMissing);
    x.modal.wheel_speeds &= ~(1u << (n - 1));
    if (!on) return true;
    if (found == x.tools.table.end() || found->second.edges.empty())
        return fail(x, Alarm::ToolUnknown, c.has(0) ? to_text(c.value(0)) : "GWPSON");
    const bool active_one = found->first == x.modal.tool && x.modal.edge_data;
    const Edge& edge = active_one ? *x.modal.edge_data : found->second.edges.begin()->second;
    if (edge.dp[1] < 400 || edge.dp[1] >= 500)
        return fail(x, Alarm::ValueOutOfRange, "GWPSON: $TC_DP1", edge.dp[1]);
    const std::array<double, 10>& wheel = found->second.grinding;
    const int by = static_cast<int>(wheel[9]);  // TPG9: the length or radius that reaches the rim
    const double radius = by >= 3 && by <= 5 ? edge.dp[static_cast<std::size_t>(by)] +
                                                   edge.dp[static_cast<std::size_t>(by) + 9]
                          : edge.dp[6] > 0 ? edge.dp[6] + edge.dp[15]
                                           : edge.dp[3] + edge.dp[12];
    if (!(radius > 0)) return fail(x, Alarm::ToolUnknown, "GWPSON: R = 0");
    // TPG7: most at the rim, m/s; TPG6: most 1/min
    const double rim = wheel[7] * 60'000.0 / (2.0 * std::numbers::pi * radius);
    x.modal.wheel_most_rpm[n] =
        wheel[6] > 0 && rim > 0 ? std::fmin(wheel[6], rim) : std::fmax(wheel[6], rim);
    x.modal.wheel_speeds |= 1u << (n - 1);
    x.modal.wheel_radius_mm[n] = radius;
    return true;
}

// SCC[axis]: another geometry axis carries the radius of G96.
bool a_surface_axis(Execution& x, const Word& word) {
    const PlaneRole role = x.core.view().axes[static_cast<std::size_t>(word.axis)].role;
    if (role != PlaneRole::BasicX && role != PlaneRole::BasicY && role != PlaneRole::BasicZ)
        return fail_word(x, Alarm::AxisKindWrong, word, axis_name(x, word.axis));
    return x.core.surface_axis_is(word.axis);
}

}  // namespace polyturn::channels::sinumerik
