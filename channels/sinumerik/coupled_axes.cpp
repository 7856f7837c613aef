// TRAILON, TRAILOF: an axis follows another one by a factor (sinumerik_part3 7.3). Straight moves take it along; what is no
// straight move of the leading axis is refused while it leads.
#include <algorithm>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

bool Interpreter::p_trail(Call& c) {
    const std::string_view name = block_.procedures.front().first->name;
    std::size_t follows = 0, leads = 0;
    if (!axis_argument(c, 0, name, follows)) return false;
    const bool has_leader = c.has(1);
    if (has_leader && !axis_argument(c, 1, name, leads)) return false;
    std::vector<Trail>& trails = modal_.trails;
    if (name == "TRAILOF") {
        std::erase_if(trails, [&](const Trail& one) { return one.follows == follows && (!has_leader || one.leads == leads); });
        return true;
    }
    if (!has_leader) return fail(Alarm::AxisArgumentMissing, "TRAILON");
    if (core_.compensating()) return fail(Alarm::AxisExchangeIllegal, axis_name(static_cast<int>(follows)));
    // Nothing may lead itself, by whatever way.
    AxisSet reached = 1u << leads;
    for (bool again = true; again;) {
        again = false;
        for (const Trail& one : trails)
            if ((reached >> one.follows & 1u) && !(reached >> one.leads & 1u)) reached |= 1u << one.leads, again = true;
    }
    if (reached >> follows & 1u) return fail(Alarm::CodesContradict, "TRAILON(" + axis_name(static_cast<int>(follows)) + "," + axis_name(static_cast<int>(leads)) + ")");
    std::erase_if(trails, [&](const Trail& one) { return one.follows == follows && one.leads == leads; });
    trails.push_back({follows, leads, c.number(2, 1.0)});
    return true;
}

// What the axes that follow have to do for this target. Leaders come before those that follow them, however deep.
AxisValues Interpreter::trailed(AxisValues target) const {
    const AxisValues own = target;
    const AxisValues& now = core_.path.programmed;
    for (std::size_t depth = 0; depth < modal_.trails.size(); ++depth) {
        AxisValues next = own;
        for (const Trail& one : modal_.trails) next[one.follows] += one.factor * (target[one.leads] - now[one.leads]);
        if (next == target) break;
        target = next;
    }
    return target;
}

// An arc, a thread or a curve to `target`: an axis that leads may not take part.
bool Interpreter::leads_nobody(const AxisValues& target) {
    for (const Trail& one : modal_.trails)
        if (target[one.leads] != core_.path.programmed[one.leads]) return fail(Alarm::NotBuilt, "TRAILON: " + axis_name(static_cast<int>(one.leads)) + " G2 G3 G33");
    return true;
}

}  // namespace polyturn::channels::sinumerik
