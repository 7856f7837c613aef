// Cutting speeds: SVC of a rotating tool, SCC the axis that G96 looks at (sinumerik_part1 7.2,
// 7.3).
#include <cmath>
#include <numbers>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

// SVC = cutting speed of the tool's edge in m/min: n = SVC * 1000 / (2 pi R).
bool Interpreter::a_cutting_speed(const Word& word) {
    const auto found = tools_.find(modal_.tool);
    const Edge* edge = nullptr;
    if (found != tools_.end())
        if (const int number = edge_of_d(found->second, modal_.edge))
            edge = &found->second.edges.at(number);
    const double radius =
        edge ? edge->dp[6] + edge->dp[15] + edge->sum[1][6] + edge->setup[1][6] : 0.0;
    if (radius <= 0) return fail_word(Alarm::ToolUnknown, word, "SVC: R = 0");
    if (surface_speed_active()) return fail_word(Alarm::CodesContradict, word, "SVC, G96");
    double speed = word.number();
    if (!metric_technology()) speed *= 0.3048;  // feet a minute
    // output here, whatever else the block says (7.2)
    const bool other = word.index > 0 && word.index != core_.path.spindle.spindle;
    if (other && !core_.commit_spindle()) return false;
    return with_spindle(other ? static_cast<std::uint16_t>(word.index) : std::uint16_t{0}, [&] {
        const std::uint16_t n = core_.path.spindle.spindle;
        if (n == 0 || spindle_closed(n))
            return fail_word(n ? Alarm::CodesContradict : Alarm::SpindleMissing, word, "SVC, SPOS");
        modal_.cutting_speeds |= 1u << (n - 1);
        modal_.cutting_speed_m_min[n] = speed;
        return ask_speed(speed_of_tool(speed, radius, found->second.max_velocity)) &&
               (!other || core_.commit_spindle());
    });
}

double Interpreter::speed_of_tool(double m_min, double radius_mm, double most) const {
    const double rpm = m_min * 1000.0 / (2.0 * std::numbers::pi * radius_mm);
    return most > 0 ? std::fmin(rpm, most) : rpm;
}

// Another tool or offset: spindles whose speed comes from SVC turn as it asks now.
bool Interpreter::refresh_cutting_speeds() {
    if (!modal_.cutting_speeds || !modal_.edge_data) return true;
    const Edge& edge = *modal_.edge_data;
    const double radius = edge.dp[6] + edge.dp[15] + edge.sum[1][6] + edge.setup[1][6];
    if (radius <= 0) return true;
    const auto found = tools_.find(modal_.tool);
    const double most = found == tools_.end() ? 0.0 : found->second.max_velocity;
    for (std::uint16_t n = 1; n <= kMaxSpindles; ++n) {
        if (!(modal_.cutting_speeds >> (n - 1) & 1u)) continue;
        if (!with_spindle(n, [&] {
                return ask_speed(speed_of_tool(modal_.cutting_speed_m_min[n], radius, most)) &&
                       core_.commit_spindle();
            }))
            return false;
    }
    return true;
}

// GWPSON(t), GWPSOF(t): S of the master spindle is the speed of a grinding wheel's rim in m/s, n =
// S * 60000 / (2 pi R); t: a tool that is not the active one (7.4). R is the edge's radius, or its
// length 1 where it has none.
bool Interpreter::p_wheel_speed(Call& c) {
    const bool on = block_.procedures.front().first->name == "GWPSON";
    const auto found =
        tools_.find(c.has(0) ? static_cast<std::int64_t>(c.value(0).number) : modal_.tool);
    // TPG1: the wheel's spindle
    const double own = found == tools_.end() ? 0.0 : found->second.grinding[1];
    const auto n =
        static_cast<std::uint16_t>(own >= 1 && own <= kMaxSpindles ? own : modal_.master_spindle);
    if (n == 0 || !core_.view().machine.spindle(n).exists()) return fail(Alarm::SpindleMissing);
    modal_.wheel_speeds &= ~(1u << (n - 1));
    if (!on) return true;
    if (found == tools_.end() || found->second.edges.empty())
        return fail(Alarm::ToolUnknown, c.has(0) ? to_text(c.value(0)) : "GWPSON");
    const bool active_one = found->first == modal_.tool && modal_.edge_data;
    const Edge& edge = active_one ? *modal_.edge_data : found->second.edges.begin()->second;
    if (edge.dp[1] < 400 || edge.dp[1] >= 500)
        return fail(Alarm::ValueOutOfRange, "GWPSON: $TC_DP1", edge.dp[1]);
    const std::array<double, 10>& wheel = found->second.grinding;
    const int by = static_cast<int>(wheel[9]);  // TPG9: the length or radius that reaches the rim
    const double radius = by >= 3 && by <= 5 ? edge.dp[static_cast<std::size_t>(by)] +
                                                   edge.dp[static_cast<std::size_t>(by) + 9]
                          : edge.dp[6] > 0 ? edge.dp[6] + edge.dp[15]
                                           : edge.dp[3] + edge.dp[12];
    if (!(radius > 0)) return fail(Alarm::ToolUnknown, "GWPSON: R = 0");
    // TPG7: most at the rim, m/s; TPG6: most 1/min
    const double rim = wheel[7] * 60'000.0 / (2.0 * std::numbers::pi * radius);
    modal_.wheel_most_rpm[n] =
        wheel[6] > 0 && rim > 0 ? std::fmin(wheel[6], rim) : std::fmax(wheel[6], rim);
    modal_.wheel_speeds |= 1u << (n - 1);
    modal_.wheel_radius_mm[n] = radius;
    return true;
}

// SCC[axis]: another geometry axis carries the radius of G96.
bool Interpreter::a_surface_axis(const Word& word) {
    const PlaneRole role = core_.view().axes[static_cast<std::size_t>(word.axis)].role;
    if (role != PlaneRole::BasicX && role != PlaneRole::BasicY && role != PlaneRole::BasicZ)
        return fail_word(Alarm::AxisKindWrong, word, axis_name(word.axis));
    return core_.surface_axis_is(word.axis);
}

// Naming an axis makes one of its spindle again that SPOS, M19 or a tap has put under position
// control (8.4): the spindle lets go of the drive, and the block is read again where it is known at
// which angle the axis stands.
bool Interpreter::spindles_to_axes() {
    if (!modal_.closed_spindles || block_.coded[3]) return true;  // TRANS C moves nothing
    const MachineView& view = core_.view();
    AxisSet named = 0;
    for (const Word& w : block_.words)
        if (names_moved_axis(w)) named |= 1u << w.axis;
    if (named && core_.transformed() && core_.path.transformation.rotary_place() >= 0)
        named |= 1u << core_.path.transformation.rotary_place();
    bool switched = false;
    for (; named; named &= named - 1) {
        const std::uint16_t spindle =
            view.machine
                .axis(view.axes[static_cast<std::size_t>(__builtin_ctz(named))].machine_axis + 1u)
                .on_spindle;
        if (spindle == 0 || !spindle_closed(spindle)) continue;
        with_spindle(spindle, [this] {
            spindle_to_axis();
            return true;
        });
        switched = true;
    }
    if (switched) needs_barrier_ = true;
    return !switched;
}

// By the PLC's M5, as where a turning spindle stops.
void Interpreter::spindle_to_axis() {
    SpindleState& now = core_.path.spindle;
    now.turn = SpindleTurn::Stop;
    modal_.closed_spindles &= ~(1u << (now.spindle - 1));
    Spindle off;
    off.spindle = now.spindle;
    off.mode = SpindleModeCode::Off;
    off.turn_changed = off.silent = true;
    core_.mark_emitted();
    core_.sink().spindle(off, core_.at);
    Aux stop;
    stop.value = 5;
    stop.text = "M5";
    stop.silent = stop.drained = true;
    core_.sink().aux(stop, core_.at);
}

// SPCON, SPCOF: position control of a spindle besides what needs it. Here positions, threads and
// couplings close the loop by themselves, so that SPCOF has nothing to open and SPCON no effect.
bool Interpreter::p_spindle_control(Call& c) { return p_spindle_speed(c) && p_without_effect(c); }
bool Interpreter::p_spindle_speed(Call& c) {
    for (const Argument& argument : c.arguments) {
        const double n = argument.value.number;
        if (!argument.given || !(n >= 1 && n <= kMaxSpindles) ||
            !core_.view().machine.spindle(static_cast<std::size_t>(n)).exists())
            return fail(Alarm::SpindleNumberIllegal, {}, n);
    }
    return true;
}

}  // namespace polyturn::channels::sinumerik
