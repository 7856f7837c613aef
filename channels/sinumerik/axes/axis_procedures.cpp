// Axes and files of the machine seen from the program: PRESETON, GEOAX, axis exchange, words that
// this machine accepts and that leave its path as it is (sinumerik_part3 7).
#include "channels/sinumerik/axes/axis_procedures.hpp"

#include <algorithm>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/coordination/procedures.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {

// PRESETON, PRESETONS(axis, value ...): the axis' position is called `value` now. The drive's
// own position stays, so the limits of the machine keep their meaning; SUPA puts the difference
// away.
bool p_preset(Execution& x, Call& c) {
    const std::string_view name = x.block.procedures.front().first->name;
    if (c.arguments.size() % 2 != 0)
        return fail(x, Alarm::ArgumentCountIllegal, std::string(name),
                    static_cast<double>(c.arguments.size()));
    if (x.core.compensating()) return fail(x, Alarm::CompReference);
    for (std::size_t k = 0; k < c.arguments.size(); k += 2) {
        std::size_t place = 0;
        if (!axis_argument(x, c, k, name, place)) return false;
        if (!c.has(k + 1))
            return fail(x, Alarm::ArgumentMissing, std::string(name), static_cast<double>(k + 2));
        const double value = c.number(k + 1) * (x.core.view().axes[place].rotary ? 1.0
                                                : active(x, 13) == 3             ? 25.4
                                                                                 : 1.0);
        // an earlier one counts
        x.core.preset_by(
            static_cast<unsigned>(place),
            value - (x.core.machine_now(static_cast<unsigned>(place)) - x.core.path.preset[place]));
    }
    x.run.state_changed = true;
    x.core.mark_emitted();
    x.core.sink().barrier(x.core.at);
    stop_reading(x);
    return true;
}

// GEOAX(): the geometry axes of the machine; GEOAX(n, axis) where it names them as they are. Others
// are not built.
bool p_geometry_axes(Execution& x, Call& c) {
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    if (c.arguments.size() % 2 != 0)
        return fail(x, Alarm::ArgumentCountIllegal, "GEOAX",
                    static_cast<double>(c.arguments.size()));
    for (std::size_t k = 0; k < c.arguments.size(); k += 2) {
        const double n = c.number(k);
        std::size_t place = 0;
        if (!(n == 1 || n == 2 || n == 3)) return fail(x, Alarm::ValueOutOfRange, "GEOAX", n);
        // no axis has this number
        if (const PlaneRole role = kRoles[static_cast<std::size_t>(n) - 1];
            c.has(k + 1) && c.value(k + 1).is_number() && c.number(k + 1) == 0) {
            if (x.core.view().axis_by_role(role) < 0) continue;
            return fail(x, Alarm::NotBuilt, "GEOAX(" + std::to_string(static_cast<int>(n)) + ",0)");
        }
        if (!axis_argument(x, c, k + 1, "GEOAX", place)) return false;
        if (x.core.view().axes[place].role != kRoles[static_cast<std::size_t>(n) - 1])
            return fail(x, Alarm::NotBuilt,
                        "GEOAX(" + std::to_string(static_cast<int>(n)) + "," +
                            axis_name(x, static_cast<int>(place)) + ")");
    }
    return true;
}

// SOFTA, JERKA: the kernel keeps the jerk of each axis whatever is said. BRISKA, DRIVEA: so they
// have no effect.
bool p_soft_axes(Execution& x, Call& c) { return axes_only(x, c); }

// RELEASE(axis): no channel may move it until GET or GETD takes it back. Axes of other channels
// cannot be taken here.
bool p_axis_exchange(Execution& x, Call& c) {
    const std::string_view name = x.block.procedures.front().first->name;
    for (std::size_t k = 0; k < c.arguments.size(); ++k) {
        if (!c.has(k) || c.value(k).type != Type::Axis)
            return fail(x, Alarm::AxisArgumentMissing, std::string(name));
        const int place = c.value(k).place();
        if (place >= kSpindleAxis) continue;  // a spindle belongs to whoever commands it
        if (x.core.compensating()) return fail(x, Alarm::AxisExchangeIllegal, axis_name(x, place));
        const AxisSet bit = 1u << place;
        x.modal.released = name == "RELEASE" ? x.modal.released | bit : x.modal.released & ~bit;
    }
    x.core.mark_emitted();
    x.core.sink().barrier(x.core.at);
    stop_reading(x);
    return true;
}

// AXTOCHAN(axis, channel, ...): for this channel it is GET, for another one RELEASE: that one takes
// the axis with its own GET.
bool p_axis_to_channel(Execution& x, Call& c) {
    AxisSet comes = 0, goes = 0;
    for (std::size_t k = 0; k < c.arguments.size(); k += 2) {
        unsigned channel = 0;
        if (!c.has(k) || !c.has(k + 1) || c.value(k).type != Type::Axis)
            return fail(x, Alarm::AxisArgumentMissing, "AXTOCHAN");
        if (!channel_of(x, c.value(k + 1), channel)) return false;
        const int place = c.value(k).place();
        if (place >= kSpindleAxis) continue;  // a spindle belongs to whoever commands it
        if (x.core.compensating()) return fail(x, Alarm::AxisExchangeIllegal, axis_name(x, place));
        (channel == x.core.view().channel ? comes : goes) |= 1u << place;
    }
    x.modal.released = (x.modal.released | goes) & ~comes;
    x.core.mark_emitted();
    x.core.sink().barrier(x.core.at);
    stop_reading(x);
    return true;
}

// CYCLE800() at the head of a program: no swivelled plane is left (sinumerik_part1 4.2). There is
// none that it could swivel to.
bool p_swivel(Execution& x, Call& c) {
    const bool any = std::any_of(c.arguments.begin(), c.arguments.end(),
                                 [](const Argument& one) { return one.given; });
    return !any || fail(x, Alarm::NotBuilt, "CYCLE800");
}

// GETSELT(VAR t, spindle), GETEXET(VAR t, spindle): the tool that waits for its change, and the one
// that cuts.
bool p_tool_of_spindle(Execution& x, Call& c) {
    const bool selected = x.block.procedures.front().first->name == "GETSELT";
    const std::int64_t tool =
        selected && x.modal.tool_selected >= 0 ? x.modal.tool_selected : x.modal.tool;
    store(x, c.arguments[0].reference, Value::of_int(static_cast<double>(tool)));
    return true;
}

}  // namespace polyturn::channels::sinumerik
