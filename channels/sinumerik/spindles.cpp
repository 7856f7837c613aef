// Cutting speeds: SVC of a rotating tool, SCC the axis that G96 looks at (sinumerik_part1 7.2, 7.3).
#include <cmath>
#include <numbers>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

// SVC = cutting speed of the tool's edge in m/min: n = SVC * 1000 / (2 pi R).
bool Interpreter::a_cutting_speed(const Word& word) {
    const auto found = tools_.find(modal_.tool);
    const Edge* edge = nullptr;
    if (found != tools_.end())
        if (const auto e = found->second.edges.find(modal_.edge); e != found->second.edges.end()) edge = &e->second;
    const double radius = edge ? edge->dp[6] + edge->dp[15] + edge->sum[1][6] + edge->setup[1][6] : 0.0;
    if (radius <= 0) return fail_word(Alarm::ToolUnknown, word, "SVC: R = 0");
    const unsigned group = active(15);
    if (group == 4 || group == 7 || group == 11) return fail_word(Alarm::CodesContradict, word, "SVC, G96");
    double speed = word.number();
    if (active(13) == 3) speed *= 0.3048;   // G700: feet a minute
    double rpm = speed * 1000.0 / (2.0 * std::numbers::pi * radius);
    if (found->second.max_velocity > 0) rpm = std::fmin(rpm, found->second.max_velocity);
    return with_spindle(word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0, [&] { return core_.spindle_speed(rpm); });
}

// SCC[axis]: another geometry axis carries the radius of G96.
bool Interpreter::a_surface_axis(const Word& word) {
    const PlaneRole role = core_.view().axes[static_cast<std::size_t>(word.axis)].role;
    if (role != PlaneRole::BasicX && role != PlaneRole::BasicY && role != PlaneRole::BasicZ) return fail_word(Alarm::AxisKindWrong, word, axis_name(word.axis));
    return core_.surface_axis_is(word.axis);
}

// SPCON, SPCOF: position control of a spindle; the drive of a spindle that follows a thread is always in it here.
bool Interpreter::p_spindle_control(Call& c) {
    for (const Argument& argument : c.arguments) {
        const double n = argument.value.number;
        if (!argument.given || !(n >= 1 && n <= kMaxSpindles) || !core_.view().machine.spindle(static_cast<std::size_t>(n)).exists()) return fail(Alarm::SpindleNumberIllegal, {}, n);
    }
    return true;
}

}  // namespace polyturn::channels::sinumerik
