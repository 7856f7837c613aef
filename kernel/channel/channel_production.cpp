// Making parts: how many are wanted and made, the end after this one, the first part tool by tool,
// the warm-up; and setup mode.
#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {

// A Part record is executed: the counters go on (N2306, N2307), and the program may be at its end
// with it.
void ChannelRunner::part_made() noexcept {
    if (by_hand()) return;  // M99 or M30 in a block by hand ends that
    ++production_.parts;
    end_lap();
    core_.totals.part(index_);
    core_.tools.part(core_, index_);
    const ChannelConfig& config = core_.config.channels[index_];
    const bool enough =
        config.parts_wanted > 0 && core_.totals.machined(index_) >= config.parts_wanted;
    if (enough) {
        ShortText text;
        text << static_cast<std::int64_t>(core_.totals.machined(index_)) << "/"
             << static_cast<std::int64_t>(config.parts_wanted);
        core_.alarm(Alarm::PartsDone, number_, text.view(), 0, shown_.line);
    }
    const bool last = std::exchange(production_.stops_after_part, false);
    // if more is to follow: finished()
    production_.ends_with_part = last || (enough && config.stops_at_wanted);
}

void ChannelRunner::end_lap() noexcept {
    if (!by_hand()) production_.end_lap();
}

// #3901 and #3902 are N2307 and N2308 (nct_parameters_part2 24): a program that writes them sets
// the counters. True: it was one.
bool ChannelRunner::part_counter(std::string_view variable, double value) noexcept {
    if (variable == "#3901") {
        core_.totals.set_machined(index_, std::isfinite(value) ? value : 0.0);
        return true;
    }
    if (variable != "#3902") return false;
    ShortText line;
    line << "N2308 L" << static_cast<std::int64_t>(number_) << "="
         << static_cast<std::int64_t>(std::isfinite(value) ? value : 0.0);
    (void)core_.store.ask_parameter(line.view(), core_.tick, core_.config.answer_ticks);
    return true;
}

void ChannelRunner::warm_up(double seconds) noexcept { production_.warm_up_s = seconds; }

// Once a tick.
void ChannelRunner::watch_production() noexcept {
    const ChannelConfig& config = core_.config.channels[index_];
    core_.signals.set_nc(
        signals::cn_parts(number_),
        config.parts_wanted > 0 && core_.totals.machined(index_) >= config.parts_wanted);
    if (production_.warm_up_s <= 0 || !program_.runs() ||
        production_.times.cycle_s < production_.warm_up_s)
        return;
    ShortText text;
    text << static_cast<std::int64_t>(production_.warm_up_s) << " s";
    production_.warm_up_s = 0;
    production_.stops_after_part = true;
    core_.alarm(Alarm::WarmUpOver, number_, text.view(), 0, shown_.line);
}

// Setup mode: no axis of the path is faster than its PT_SETUP_FEED.
double ChannelRunner::setup_ceiling() const noexcept {
    double ceiling = kUnlimited;
    if (!core_.signals.plc(signals::cp_setup(number_))) return ceiling;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        const AxisConfig& axis = core_.config.axes[a];
        if (axis.exists && axis.channel == number_ && !axis.rotary)
            ceiling = std::min(ceiling, axis.setup_feed);
    }
    // Turning axes have their own share of the running record.
    if (path_.cursor < path_.planner->next_record()) {
        const PathRecord& r = record(path_.cursor);
        for (std::uint32_t i = 0; is_motion(r) && i < r.axis_count; ++i) {
            if (r.axis[i] >= kMaxAxes || !core_.config.axes[r.axis[i]].rotary) continue;
            const double way = std::fabs(r.end[i] - r.start[i]);
            if (way > 0)
                ceiling =
                    std::min(ceiling, core_.config.axes[r.axis[i]].setup_feed * r.length / way);
        }
    }
    return ceiling;
}

// N0302 of the axes that it moves and that have no reference (nct_parameters_part1 5: in any mode).
// Along a line each has its share of the speed, elsewhere none is faster than the path.
double ChannelRunner::ceiling_before_reference(const PathRecord& r) const noexcept {
    double ceiling = kUnlimited;
    if (!core_.some_slow || !is_motion(r)) return ceiling;
    const auto kind = static_cast<RecordKind>(r.kind);
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        if (r.axis[i] >= kMaxAxes || !core_.is_slow(r.axis[i])) continue;
        const double way = std::fabs(r.end[i] - r.start[i]),
                     most = core_.config.axes[r.axis[i]].reference.rapid;
        const bool in_plane = kind == RecordKind::Arc && (r.plane[0] == i || r.plane[1] == i);
        if (kind == RecordKind::Line && r.transform == 0)
            ceiling = way > 0 ? std::min(ceiling, most * r.length / way) : ceiling;
        else if (way > 0 || in_plane || r.transform != 0)
            ceiling = std::min(ceiling, most);
    }
    return ceiling;
}

}  // namespace polyturn::kernel
