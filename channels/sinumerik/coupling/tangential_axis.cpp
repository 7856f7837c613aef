// Tangential control: a rotary axis points along the path of two others (sinumerik_part3 7.3, TANG
// TANGON TANGOF TANGDEL TLIFT).
//
//      lead2 |      . '            angle = factor * atan2(d lead2, d lead1) + offset
//            |   . ' )  angle      At a corner the axis turns to the new tangent before the path goes on, as TLIFT has it done in
//            +------------ lead1   a block of its own; on an arc it turns along with it.
//
// The directions are those of the workpiece ("W"); "B", those of the basic system, is the same
// where no frame turns.
#include "channels/sinumerik/coupling/tangential_axis.hpp"

#include <cmath>

#include "channels/angles.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/geo_motion.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kNoDirection = 1e-9;  // mm: the leading axes stand
constexpr double kTurned = 1e-7;       // degrees

// Turns the axis into the direction in which the leading axes begin to move, by components at the
// places of the channel.
bool turn_to_tangent(Execution& x, const AxisValues& direction) {
    const Tangential& t = x.modal.tangential;
    const double first = direction[t.leads[0]], second = direction[t.leads[1]];
    if (std::hypot(first, second) < kNoDirection) return true;
    const auto i = static_cast<std::size_t>(t.follows);
    const double now = x.core.path.programmed[i],
                 by = std::remainder(
                     t.factor * std::atan2(second, first) / kDegree + t.offset_deg - now, 360.0);
    if (std::fabs(by) < kTurned) return true;
    AxisValues turned = x.core.path.programmed;
    turned[i] = now + by;
    return x.core.rapid(turned);
}

}  // namespace

bool p_tangential(Execution& x, Call& c) {
    const std::string name(x.block.procedures.front().first->name);
    std::size_t follows = 0;
    if (!axis_argument(x, c, 0, name, follows)) return false;
    if (!x.core.view().axes[follows].rotary) return fail(x, Alarm::AxisKindWrong, c.value(0).text);
    Tangential& tangential = x.modal.tangential;
    if (name == "TANG") {
        Tangential made;
        made.follows = static_cast<int>(follows);
        if (!axis_argument(x, c, 1, name, made.leads[0]) ||
            !axis_argument(x, c, 2, name, made.leads[1]))
            return false;
        if (made.leads[0] == made.leads[1] || made.leads[0] == follows || made.leads[1] == follows)
            return fail(x, Alarm::FunctionArgument, name, 3);
        made.factor = c.number(3, 1.0);
        if (made.factor == 0) return fail(x, Alarm::FunctionArgument, name, 4);
        if (const std::string system = c.has(4) ? upper(c.value(4).text) : "B";
            system != "B" && system != "W")
            return fail(x, Alarm::FunctionArgument, name, 5);
        tangential = made;
        return true;
    }
    if (tangential.follows != static_cast<int>(follows))
        return name == "TANGOF" || name == "TANGDEL" ||
               fail(x, Alarm::CodesContradict, name + ", TANG");
    if (name == "TANGON") {
        tangential.on = true;
        tangential.offset_deg = c.number(1, 0.0);
    } else if (name == "TANGOF")
        tangential.on = false;
    else if (name == "TANGDEL")
        tangential = {};
    return true;  // TLIFT: as it is done anyhow
}

bool tangential_line(Execution& x, AxisValues& target) {
    if (!x.modal.tangential.on) return true;
    AxisValues direction{};
    for (std::size_t k = 0; k < direction.size(); ++k)
        direction[k] = target[k] - x.core.path.programmed[k];
    if (!turn_to_tangent(x, direction)) return false;
    const auto i = static_cast<std::size_t>(x.modal.tangential.follows);
    target[i] = x.core.path.programmed[i];
    return true;
}

bool tangential_arc(Execution& x, AxisValues& target, const ArcCall& call) {
    if (!x.modal.tangential.on) return true;
    const auto [p, q] = plane_places(x);
    const Tangential& t = x.modal.tangential;
    const bool along = t.leads[0] == p && t.leads[1] == q,
               across = t.leads[0] == q && t.leads[1] == p;
    if (!along && !across) return fail(x, Alarm::NotBuilt, "TANGON: " + axis_name(x, t.follows));
    const AxisValues from = x.core.path.programmed;
    const double sense = call.clockwise ? -1.0 : 1.0;
    AxisValues direction{};
    direction[p] = -sense * (from[q] - call.centre_q);
    direction[q] = sense * (from[p] - call.centre_p);
    if (!turn_to_tangent(x, direction)) return false;
    double sweep = std::fmod((std::atan2(target[q] - call.centre_q, target[p] - call.centre_p) -
                              std::atan2(from[q] - call.centre_q, from[p] - call.centre_p)) *
                                 sense,
                             kTurn);
    if (sweep < 1e-9) sweep += kTurn;
    sweep += kTurn * call.turns;
    const auto i = static_cast<std::size_t>(t.follows);
    target[i] = x.core.path.programmed[i] + (along ? sense : -sense) * t.factor * sweep / kDegree;
    return true;
}

}  // namespace polyturn::channels::sinumerik
