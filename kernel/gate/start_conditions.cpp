#include "kernel/gate/start_conditions.hpp"

#include <array>

namespace polyturn::kernel {
namespace {

using Scope = StartCondition::Scope;

template <class Misses>
std::uint32_t next_axis(const Core& core, const StartView& view, std::uint32_t after,
                        Misses misses) {
    for (std::uint32_t a = after; a < core.config.axis_count; ++a)
        if (core.config.axes[a].exists && core.config.axes[a].channel == view.channel &&
            misses(core.axes[a], core.config.axes[a], a))
            return a + 1;
    return 0;
}

constexpr std::array<StartCondition, kStartWords.size()> kConditions{{
    {"process", Scope::Channel,
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t {
         return !v.process_there;
     }},
    {"emergency_stop", Scope::Machine,
     [](const Core& c, const StartView&, std::uint32_t) -> std::uint32_t {
         return c.state == MachineState::EmergencyStop;
     }},
    {"machine_on", Scope::Machine,
     [](const Core& c, const StartView&, std::uint32_t) -> std::uint32_t {
         return c.state == MachineState::Off;
     }},
    {"no_stop", Scope::Machine,
     [](const Core& c, const StartView&, std::uint32_t) -> std::uint32_t {
         return c.on() && c.all_stop;
     }},
    {"store", Scope::Machine,
     [](const Core& c, const StartView&, std::uint32_t) -> std::uint32_t { return c.store_dead; }},
    {"store_whole", Scope::Machine,
     [](const Core& c, const StartView&, std::uint32_t) -> std::uint32_t { return c.store_unfit; }},
    {"reset_over", Scope::Channel,
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t { return !v.resting; }},
    {"by_hand", Scope::Channel,
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t {
         return c.jogging >> (v.channel - 1) & 1u;
     }},
    {"back_on_path", Scope::Channel,
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t { return v.away; }},
    {"alarm", Scope::Channel,
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t { return v.alarmed; }},
    {"mode", Scope::Channel,
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t {
         return v.by_hand_mode;
     }},
    {"door", Scope::Channel,
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t {
         return c.door_open(v.channel);
     }},
    {"lubrication", Scope::Channel,
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t {
         return c.signals.plc(signals::cp_nolube(v.channel)) != 0;
     }},
    {"bar", Scope::Channel,
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t {
         return c.signals.plc(signals::cp_barend(v.channel)) != 0;
     }},
    {"tailstock", Scope::Channel,
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t {
         return c.signals.plc(signals::cp_tailopen(v.channel)) != 0;
     }},
    {"tool", Scope::Channel,
     [](const Core& c, const StartView& v, std::uint32_t) -> std::uint32_t {
         return c.signals.plc(signals::cp_turretopen(v.channel)) != 0;
     }},
    {"chuck", Scope::Spindle,
     [](const Core& c, const StartView& v, std::uint32_t after) -> std::uint32_t {
         // the one that the channel's plain S means
         const std::uint32_t s = c.config.channels[v.channel - 1].default_spindle;
         return s > after && c.signals.plc(signals::sp_unclamped(s)) != 0 ? s : 0u;
     }},
    {"attached", Scope::Axis,
     [](const Core& c, const StartView& v, std::uint32_t after) -> std::uint32_t {
         // A C axis whose drive the spindle uses now gets it back by itself.
         return next_axis(c, v, after,
                          [](const AxisUnit& axis, const AxisConfig& config, std::uint32_t) {
                              return axis.detached && config.named && !config.on_spindle;
                          });
     }},
    {"referenced", Scope::Axis,
     [](const Core& c, const StartView& v, std::uint32_t after) -> std::uint32_t {
         return next_axis(c, v, after,
                          [&](const AxisUnit& axis, const AxisConfig&, std::uint32_t a) {
                              return !axis.referenced && c.must_be_referenced(a);
                          });
     }},
    {"program", Scope::Channel,
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t {
         return v.lacks_program;
     }},
    {"block", Scope::Channel,
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t { return v.lacks_block; }},
    {"restart", Scope::Channel,
     [](const Core&, const StartView& v, std::uint32_t) -> std::uint32_t {
         return v.others_search;
     }},
}};

constexpr bool same_order() {
    for (std::size_t row = 0; row < kConditions.size(); ++row)
        if (kConditions[row].name != kStartWords[row].name) return false;
    return true;
}
static_assert(same_order(), "each row has its words, bit for bit of ChannelStatus::start_missing");

}  // namespace

std::span<const StartCondition> start_conditions() noexcept { return kConditions; }

ShortText missing_for_start(const Core& core, const StartView& view) noexcept {
    ShortText text;
    const StartWords* only = nullptr;
    int count = 0;
    for (std::size_t row = 0; row < kConditions.size(); ++row) {
        const StartCondition& condition = kConditions[row];
        const bool many = condition.scope == Scope::Axis || condition.scope == Scope::Spindle;
        std::uint32_t which = condition.missing(core, view, 0);
        if (!which) continue;
        only = count++ == 0 ? &kStartWords[row] : nullptr;
        if (count > 1) text << "; ";
        for (bool first = true; many && which;
             which = condition.missing(core, view, which), first = false)
            text << (first ? "" : " ")
                 << name_of(condition.scope == Scope::Axis ? 'A' : 'S', which - 1).view();
        if (many) text << " ";
        text << kStartWords[row].text;
    }
    if (only) text << " (" << only->remedy << ")";  // of several, the operator sees what to do
    return text;
}

std::uint32_t rows_missing_for_start(const Core& core, const StartView& view) noexcept {
    std::uint32_t rows = 0;
    for (std::size_t row = 0; row < kConditions.size(); ++row)
        if (kConditions[row].missing(core, view, 0)) rows |= 1u << row;
    return rows;
}

}  // namespace polyturn::kernel
