#include "kernel/cyclic/start_conditions.hpp"

#include <array>

namespace polyturn::kernel {
namespace {

using Scope = StartCondition::Scope;

template <class Misses>
std::uint32_t next_axis(const Core& core, const StartView& view, std::uint32_t after, Misses misses) {
    for (std::uint32_t a = after; a < core.config.axis_count; ++a)
        if (core.config.axes[a].exists && core.config.axes[a].channel == view.channel && misses(core.axes[a], core.config.axes[a], a)) return a + 1;
    return 0;
}

constexpr std::array<StartCondition, 18> kConditions{{
    {"process", Scope::Channel, "the channel's process is not there", "wait until it is started again, then reset",
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t { return !v.process_there; }},
    {"emergency_stop", Scope::Machine, "the emergency stop is active", "release it and switch the machine on",
     [](const Core& c, const StartView&, std::uint32_t) -> std::uint32_t { return c.state == MachineState::EmergencyStop; }},
    {"machine_on", Scope::Machine, "the machine is not switched on", "switch it on",
     [](const Core& c, const StartView&, std::uint32_t) -> std::uint32_t { return c.state == MachineState::Off; }},
    {"no_stop", Scope::Machine, "everything was stopped by an alarm", "remove its cause and reset",
     [](const Core& c, const StartView&, std::uint32_t) -> std::uint32_t { return c.on() && c.all_stop; }},
    {"store", Scope::Machine, "the store is dead: nothing would be kept", "wait until it runs again",
     [](const Core& c, const StartView&, std::uint32_t) -> std::uint32_t { return c.store_dead; }},
    {"reset_over", Scope::Channel, "the reset is not over", "wait until the axes rest",
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t { return !v.resting; }},
    {"by_hand", Scope::Channel, "an axis is being moved by hand", "wait until it rests",
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t { return c.jogging >> (v.channel - 1) & 1u; }},
    {"back_on_path", Scope::Channel, "axes were moved in the hold", "press return",
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t { return v.away; }},
    {"alarm", Scope::Channel, "an alarm of the channel stands", "press reset",
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t { return v.alarmed; }},
    {"mode", Scope::Channel, "the mode is for moving by hand", "choose auto or mdi",
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t { return v.by_hand_mode; }},
    {"door", Scope::Channel, "the door is open", "close it, or switch to setup mode",
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t { return c.door_open(v.channel); }},
    {"lubrication", Scope::Channel, "the lubrication is missing", "fill up its oil",
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t { return c.signals.plc(signals::cp_nolube(v.channel)) != 0; }},
    {"bar", Scope::Channel, "the bar is used up", "load a new one",
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t { return c.signals.plc(signals::cp_barend(v.channel)) != 0; }},
    {"tailstock", Scope::Channel, "the tailstock is neither back nor does it hold", "bring it to its end",
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t { return c.signals.plc(signals::cp_tailopen(v.channel)) != 0; }},
    {"tool", Scope::Channel, "no tool is in place, the turret is not locked", "bring a tool into place",
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t { return c.signals.plc(signals::cp_turretopen(v.channel)) != 0; }},
    {"chuck", Scope::Spindle, "the chuck does not hold", "close it, look at its pressure",
     [](const Core& c, const StartView& v, std::uint32_t after) -> std::uint32_t {
         const std::uint32_t s = c.config.channels[v.channel - 1].default_spindle;   // the one that the channel's plain S means
         return s > after && c.signals.plc(signals::sp_unclamped(s)) != 0 ? s : 0u;
     }},
    {"attached", Scope::Axis, "detached", "attach it (AP_DETCHR)",
     [](const Core& c, const StartView& v, std::uint32_t after) -> std::uint32_t {
         // A C axis that has lent its drive to the spindle comes back by itself.
         return next_axis(c, v, after, [](const AxisUnit& axis, const AxisConfig& config, std::uint32_t) { return axis.detached && config.named && !config.on_spindle; });
     }},
    {"referenced", Scope::Axis, "not referenced", "reference it",
     [](const Core& c, const StartView& v, std::uint32_t after) -> std::uint32_t {
         return next_axis(c, v, after, [&](const AxisUnit& axis, const AxisConfig&, std::uint32_t a) { return !axis.referenced && c.must_be_referenced(a); });
     }},
}};

}  // namespace

std::span<const StartCondition> start_conditions() noexcept { return kConditions; }

ShortText missing_for_start(const Core& core, const StartView& view) noexcept {
    ShortText text;
    const StartCondition* only = nullptr;
    int count = 0;
    for (const StartCondition& condition : kConditions) {
        const bool many = condition.scope == Scope::Axis || condition.scope == Scope::Spindle;
        std::uint32_t which = condition.missing(core, view, 0);
        if (!which) continue;
        only = count++ == 0 ? &condition : nullptr;
        if (count > 1) text << "; ";
        for (bool first = true; many && which; which = condition.missing(core, view, which), first = false)
            text << (first ? "" : " ") << name_of(condition.scope == Scope::Axis ? 'A' : 'S', which - 1).view();
        if (many) text << " ";
        text << condition.text;
    }
    if (only) text << " (" << only->remedy << ")";   // of several, the operator sees what to do
    return text;
}

}  // namespace polyturn::kernel
