#include "kernel/tick/totals.hpp"

#include <cmath>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kTimersEveryS = 10.0;
constexpr double kSamePlace = 1e-6;  // mm: changes below the encoder's resolution are ignored
}  // namespace

void Totals::start(const params::Table& table) noexcept {
    for (std::size_t n = 0; n < kNumbers; ++n)
        values_[n] = shown_[n] =
            table.numbers[static_cast<std::size_t>(counter_slot(static_cast<std::int32_t>(n)))];
}

void Totals::adopt(const params::Table& table) noexcept {
    for (std::size_t n = 0; n < kNumbers; ++n) {
        const double now =
            table.numbers[static_cast<std::size_t>(counter_slot(static_cast<std::int32_t>(n)))];
        if (now != shown_[n]) values_[n] = shown_[n] = now;
    }
}

void Totals::part(unsigned channel) noexcept {
    for (const Counter counter : {Counter::TotalParts, Counter::MachinedParts}) {
        value(counter, channel) += 1;
        due_[static_cast<std::size_t>(counter_number(counter, channel + 1))] = true;
    }
}

void Totals::spend(unsigned channel, const Activity& activity, double ms) noexcept {
    operated_[channel] = activity.operates;
    if (activity.operates) {
        value(Counter::OperationTime, channel) += ms;
        value(Counter::PartTime, channel) += ms;
    }
    if (activity.cuts) value(Counter::CuttingTime, channel) += ms;
    if (activity.interval) value(Counter::IntervalTime, channel) += ms;
}

void Totals::rests(unsigned axis, double position) noexcept {
    if (known_[axis] && std::fabs(position - kept_[axis]) < kSamePlace) return;
    position_[axis] = position;
    moved_[axis] = true;
}

void Totals::send(params::Table& table, StoreLink& store) noexcept {
    if (due_.any())
        for (std::size_t n = 0; n < kNumbers; ++n) {
            if (!due_[n]) continue;
            if (values_[n] != shown_[n]) {
                if (!store.write(StoreRequestKind::Counter, 0, static_cast<std::int32_t>(n), 0,
                                 values_[n], {}))
                    return;
                table
                    .numbers[static_cast<std::size_t>(counter_slot(static_cast<std::int32_t>(n)))] =
                    shown_[n] = values_[n];
            }
            due_[n] = false;
        }
    if (moved_.any())
        for (unsigned a = 0; a < kMaxAxes; ++a) {
            if (!moved_[a]) continue;
            if (!store.write(StoreRequestKind::LastPosition, 0, static_cast<std::int32_t>(a + 1), 0,
                             position_[a], {}))
                return;
            kept_[a] = position_[a];
            known_[a] = true;
            moved_[a] = false;
        }
}

void Machine::count_totals() noexcept {
    Totals& totals = core_.totals;
    const double ms = core_.config.tick_s * 1000.0;
    bool rests = true;
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        if (!core_.config.channels[l].exists) continue;
        const bool ran = totals.operated(l);
        const Totals::Activity activity{channels_[l]->operates(), channels_[l]->cuts(),
                                        core_.signals.plc(signals::cp_tmren(l + 1)) != 0};
        totals.spend(l, activity, ms);
        if (ran && !activity.operates) totals.timers_due();
        const bool cuts =
            activity.cuts && (channels_[l]->panel().keys & (kKeyDryRun | kKeyMachineLock)) == 0;
        core_.tools.spend(core_, l, cuts, core_.config.tick_s,
                          channels_[l]->path_speed() * core_.config.tick_s);
        if ((ran && !activity.operates) || core_.end_run) (void)core_.tools.flush(core_, l);
        switch (core_.tools.take_end(l)) {
            case ToolClient::End::StopAfterPart:
                channels_[l]->stop_after_part(true);
                break;
            case ToolClient::End::Hold:
                channels_[l]->safe_hold();
                break;
            case ToolClient::End::Nothing:
                break;
        }
        rests = rests && !activity.operates;
    }
    totals.power_on(ms);
    const auto every = static_cast<std::int64_t>(kTimersEveryS / core_.config.tick_s);
    if (core_.tick % every == 0 || core_.end_run) totals.timers_due();
    if (rests || core_.end_run)
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
            if (core_.axes[a].exists() && !core_.axes[a].moving())
                totals.rests(
                    a, core_.axes[a].command() - core_.config.axes[a].reference.absolute_origin());
    // While it moves too, for an axis whose encoder is checked against it at the next start (10.4).
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        const ReferenceConfig& reference = core_.config.axes[a].reference;
        const double raw = core_.axes[a].measured() - reference.absolute_origin();
        if (core_.axes[a].exists() && reference.absolute && reference.alarm_distance > 0 &&
            totals.strays(a, raw, reference.alarm_distance))
            totals.rests(a, raw);
    }
    totals.send(core_.table, core_.store);
}

}  // namespace polyturn::kernel
