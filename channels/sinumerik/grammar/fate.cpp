#include "channels/sinumerik/grammar/fate.hpp"

#include <algorithm>
#include <initializer_list>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

template <class Act>
bool is_one_of(Act act, std::initializer_list<Act> all) {
    return std::find(all.begin(), all.end(), act) != all.end();
}

}  // namespace

Fate fate_of(const GCode& row) {
    using I = Interpreter;
    if (!row.act || row.act == &I::geo_not_built) return Fate::Refused;
    if (is_one_of(row.act, {&I::g_without_effect, &I::g_as_continuous})) return Fate::Warns;
    return row.act == &I::g_as_machine ? Fate::AsMachine : Fate::Acts;
}

Fate fate_of(const Address& row) {
    using I = Interpreter;
    if (row.use == Address::Use::Refused) return Fate::Refused;
    if (is_one_of(row.act,
                  {&I::a_without_effect, &I::a_rounding, &I::a_handwheel_feed, &I::a_thread_ramp}))
        return Fate::Warns;
    return is_one_of(row.act, {&I::a_as_machine, &I::a_no_holder}) ? Fate::AsMachine : Fate::Acts;
}

Fate fate_of(const Command& row) {
    using I = Interpreter;
    if (!row.act) return Fate::Refused;
    if (is_one_of(row.act, {&I::p_without_effect, &I::p_profile_without_effect,
                            &I::p_spindle_control, &I::p_action_reset, &I::p_cycle_steps}))
        return Fate::Warns;
    // a tangential axis is turned between two blocks anyway
    if (row.name == "TLIFT") return Fate::AsMachine;
    return is_one_of(row.act, {&I::p_as_machine, &I::p_soft_axes, &I::p_spindle_speed,
                               &I::p_master_holder, &I::p_geometry_axes, &I::p_swivel})
               ? Fate::AsMachine
               : Fate::Acts;
}

Fate fate_of(const Statement& row) { return row.act ? Fate::Acts : Fate::Refused; }

}  // namespace polyturn::channels::sinumerik
