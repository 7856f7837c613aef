// $AA_OFF: ways that synchronized actions lay over the path.
#include "channels/sinumerik/actions/overlays.hpp"

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/coordination/procedures.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/variables/changes.hpp"

namespace polyturn::channels::sinumerik {

// $AA_OFF[axis]: a position that lies over the path, true mm or degrees (sinumerik_part2 13.11).
// The axis goes there in rapid where the block or action that says so is done; the programmed
// numbers do not know of it until CORROF hands it over to them.
bool write_overlay(Execution& x, const std::string& name, const std::vector<Value>& indices,
                   const char* from, std::size_t length, const Value& value) {
    if (indices.size() != 1 || indices[0].type != Type::Axis || indices[0].place() >= kSpindleAxis)
        return fail_at(x, Alarm::AxisArgumentMissing, from, length, name);
    undo(x, [&x, before = x.actions.overlays] { x.actions.overlays = before; });
    x.actions.overlays.push_back({static_cast<std::size_t>(indices[0].place()), value.number});
    x.changes.written.push_back({name + "[" + axis_name(x, indices[0].place()) + "]", value});
    return true;
}
bool drive_overlays(Execution& x) {
    if (x.actions.overlays.empty()) return true;
    if (x.core.compensating() || x.core.transformed())
        return fail(x, Alarm::NotBuilt, "$AA_OFF, G41 G42 TRANSMIT");
    AxisValues wanted = x.core.path.wanted;
    for (const Overlay& one : x.actions.overlays) wanted[one.place] = one.mm;
    x.actions.overlays.clear();
    x.core.set_wanted(wanted);
    x.run.state_changed = true;
    return !x.core.vector_pending() || x.core.travel_offset(true);
}
// DRFOF, CORROF(axis, "DRF" | "AA_OFF" ...): no axis moves; what lay over the path belongs to the
// programmed position now. There is no DRF.
bool p_overlay_off(Execution& x, Call& c) {
    if (c.arguments.size() % 2 != 0)
        return fail(x, Alarm::ArgumentCountIllegal, "CORROF",
                    static_cast<double>(c.arguments.size()));
    for (std::size_t k = 0; k < c.arguments.size(); k += 2) {
        std::size_t place = 0;
        if (!axis_argument(x, c, k, "CORROF", place)) return false;
        const std::string which = c.has(k + 1) ? upper(c.value(k + 1).text) : std::string();
        if (which != "DRF" && which != "AA_OFF")
            return fail(x, Alarm::FunctionArgument, "CORROF: " + which, static_cast<double>(k + 2));
        if (which == "DRF") continue;
        if (x.core.compensating()) return fail(x, Alarm::CodesContradict, "CORROF, G41, G42");
        AxisValues wanted = x.core.path.wanted;
        wanted[place] = 0.0;
        x.core.set_wanted(wanted);
        x.core.take_wanted();
        x.run.state_changed = true;
    }
    return p_stopre(x, c);
}
}  // namespace polyturn::channels::sinumerik
