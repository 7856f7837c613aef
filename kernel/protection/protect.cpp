// Reaction to a finding of the protection (guard.hpp): the movers of the two bodies stop, and the
// alarm names both.
#include <algorithm>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {
constexpr std::int64_t kShownEvery = 20;  // ticks, for screens
}

void Machine::protect() noexcept {
    if (const std::size_t left_out = guard_.unguarded(); left_out != 0) {
        ShortText text;
        text << static_cast<std::int64_t>(left_out)
             << " shapes are more than protection can hold and are not guarded";
        core_.alarm(Alarm::GuardConfig, 0, text.view());
    }
    if (!guard_.any()) return;
    for (std::uint32_t l = 0; l < kMaxChannels; ++l) {
        // P4: this thread has stored it, after acquiring it
        const ChannelSegment* segment = core_.channel_segment[l].load(std::memory_order_relaxed);
        if (!segment || !core_.config.channels[l].exists) continue;
        (void)tool_in_work_[l].look(*segment, channels_[l]->serial());
        guard_.take_tool(l + 1, tool_in_work_[l].shift());
    }
    const Guard::Finding found = guard_.step(core_);
    if (core_.tick % kShownEvery == 0) {
        guard_.publish(core_.image.guard.draft());
        core_.image.guard.publish();
    }
    std::array<bool, kMaxAxes> held{};
    if (found.first != Guard::kNone) {
        ShortText text;
        text << guard_.name(found.first) << " and " << guard_.name(found.second);
        const double distance = std::max(found.distance, 0.0);
        bool told = false;
        for (const std::uint32_t body : {found.first, found.second}) {
            const ChannelSet movers = guard_.movers(core_, body);
            for (std::uint32_t l = 1; l <= kMaxChannels; ++l)
                if (movers >> (l - 1) & 1u) {
                    channels_[l - 1]->fault(Alarm::GuardStop, text.view(), distance);
                    told = true;
                }
            for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
                if (!guard_.carries(body, a)) continue;
                held[a] = true;
                if (homing_[a].active()) homing_[a].stop();
                stop_carrier(a);
                if (!jogs_[a].active()) continue;
                jogs_[a].stop();
                handwheel_left_[a] = 0;
                if (!told && !guarded_[a])
                    core_.alarm(Alarm::GuardStop, core_.config.axes[a].channel, text.view(),
                                distance);
                told = true;
            }
        }
    }
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (held[a] != guarded_[a])
            core_.signals.set_nc(signals::an_guard(a + 1), guarded_[a] = held[a]);
}

}  // namespace polyturn::kernel
