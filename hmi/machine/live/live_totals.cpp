#include "hmi/machine/live/live_totals.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::hmi {

// The stored value comes a little later than it was counted: what has been seen until now goes on,
// unless it is far from it (somebody has set the parameter, or a new part has begun).
void LiveTotals::Hours::add(double stored_ms, double more_ms) {
    constexpr double kLate_ms = 1'500;
    since += more_ms;
    if (stored_ms == stored) return;
    const double ahead = stored < 0 ? -1 : now() - stored_ms;
    stored = stored_ms;
    since = ahead >= 0 && ahead <= kLate_ms ? ahead : 0;
}

void LiveTotals::follow(const Live& live) {
    if (!live.connected() || live.machineRun() != run_) {
        *this = {};
        run_ = live.machineRun();
        if (!live.connected()) return;
    }
    const std::int64_t tick = live.status().tick;
    const bool first = tick_ < 0 || tick < tick_;
    const double ms = first ? 0 : live.seconds(tick - tick_) * 1e3;
    tick_ = tick;
    const auto stored = [&](std::int32_t number) {
        return live.table().numbers[static_cast<std::size_t>(counter_slot(number))];
    };
    hours_[static_cast<std::size_t>(kPowerOnTime)].add(stored(kPowerOnTime), ms);
    for (const unsigned channel : live.channels()) {
        const ChannelStatus& now = live.channel(channel);
        Seen& seen = seen_[channel - 1];
        const auto state = static_cast<ChannelState>(now.state);
        // As ChannelRunner::operates() and cuts() have it (kernel/channel/channel_runner.hpp).
        const bool operates = static_cast<ChannelMode>(now.mode) == ChannelMode::Auto &&
                              (state == ChannelState::Running || state == ChannelState::Waiting);
        // the part's time begins with the program
        const bool begins = now.cycle_s < seen.cycle_s;
        const double cut = first || !(operates || seen.operates)
                               ? 0
                               : std::max(0.0, now.cutting_s - (begins ? 0 : seen.cutting_s)) * 1e3,
                     ran = operates ? ms : 0;
        const auto add = [&](Counter counter, double more_ms) {
            hours(counter, channel).add(stored(counter_number(counter, channel)), more_ms);
        };
        add(Counter::OperationTime, ran);
        add(Counter::CuttingTime, cut);
        add(Counter::IntervalTime, live.plc(signals::cp_tmren(channel)) ? ms : 0);
        add(Counter::PartTime, ran);
        if (begins) {
            Hours& part = hours(Counter::PartTime, channel);
            part.since = now.cycle_s * 1e3 - part.stored;  // until the stored one follows
        }
        seen = {now.cutting_s, now.cycle_s, operates};
    }
}

double LiveTotals::ms(std::size_t slot) const {
    for (std::int32_t number = 0; number <= kPowerOnTime; ++number) {
        const auto of = static_cast<Counter>(number % kCountersOfChannel);
        const bool parts =
            number != kPowerOnTime && (of == Counter::TotalParts || of == Counter::MachinedParts);
        if (!parts && counter_slot(number) == static_cast<std::int64_t>(slot))
            return hours_[static_cast<std::size_t>(number)].now();
    }
    return -1;
}

}  // namespace polyturn::hmi
