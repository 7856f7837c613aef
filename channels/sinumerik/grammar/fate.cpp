#include "channels/sinumerik/grammar/fate.hpp"

#include <algorithm>
#include <initializer_list>

#include "channels/sinumerik/actions/synchronized.hpp"
#include "channels/sinumerik/axes/axis_procedures.hpp"
#include "channels/sinumerik/axes/feeds.hpp"
#include "channels/sinumerik/coordination/procedures.hpp"
#include "channels/sinumerik/geometry/geo_threads.hpp"
#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"

namespace polyturn::channels::sinumerik {
namespace {

template <class Act>
bool is_one_of(Act act, std::initializer_list<Act> all) {
    return std::find(all.begin(), all.end(), act) != all.end();
}

}  // namespace

Fate fate_of(const GCode& row) {
    if (!row.act || row.act == geo_not_built) return Fate::Refused;
    if (is_one_of(row.act, {g_without_effect, g_as_continuous})) return Fate::Warns;
    return row.act == g_as_machine ? Fate::AsMachine : Fate::Acts;
}

Fate fate_of(const Address& row) {
    if (row.use == Address::Use::Refused) return Fate::Refused;
    if (is_one_of(row.act, {a_without_effect, a_rounding, a_handwheel_feed, a_thread_ramp}))
        return Fate::Warns;
    return is_one_of(row.act, {a_as_machine, a_no_holder}) ? Fate::AsMachine : Fate::Acts;
}

Fate fate_of(const Command& row) {
    if (!row.act) return Fate::Refused;
    if (is_one_of(row.act, {p_without_effect, p_profile_without_effect, p_spindle_control,
                            p_action_reset, p_cycle_steps}))
        return Fate::Warns;
    // a tangential axis is turned between two blocks anyway
    if (row.name == "TLIFT") return Fate::AsMachine;
    return is_one_of(row.act, {p_as_machine, p_soft_axes, p_spindle_speed, p_master_holder,
                               p_geometry_axes, p_swivel})
               ? Fate::AsMachine
               : Fate::Acts;
}

Fate fate_of(const Statement& row) { return row.act ? Fate::Acts : Fate::Refused; }

}  // namespace polyturn::channels::sinumerik
