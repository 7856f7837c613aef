#include "kernel/channel/program/production.hpp"

#include <cmath>
#include <utility>

#include "kernel/records/record_executor.hpp"

namespace polyturn::kernel {

void part_made(Channel& c) noexcept {
    if (c.hand.run()) return;  // M99 or M30 in a block by hand ends that
    ++c.production.parts;
    end_lap(c);
    c.core.totals.part(c.index);
    c.core.tools.part(c.core, c.index);
    const ChannelConfig& config = c.core.config.channels[c.index];
    const bool enough =
        config.parts_wanted > 0 && c.core.totals.machined(c.index) >= config.parts_wanted;
    if (enough) {
        ShortText text;
        text << static_cast<std::int64_t>(c.core.totals.machined(c.index)) << "/"
             << static_cast<std::int64_t>(config.parts_wanted);
        c.core.alarm(Alarm::PartsDone, c.number, text.view(), 0, c.shown.line);
    }
    const bool last = std::exchange(c.production.stops_after_part, false);
    // if more is to follow: end_record()
    c.production.ends_with_part = last || (enough && config.stops_at_wanted);
}

void end_lap(Channel& c) noexcept {
    if (!c.hand.run()) c.production.end_lap();
}

bool part_counter(Channel& c, std::string_view variable, double value) noexcept {
    if (variable == "#3901") {
        c.core.totals.set_machined(c.index, std::isfinite(value) ? value : 0.0);
        return true;
    }
    if (variable != "#3902") return false;
    ShortText line;
    line << "N2308 L" << static_cast<std::int64_t>(c.number) << "="
         << static_cast<std::int64_t>(std::isfinite(value) ? value : 0.0);
    (void)c.core.store.ask_parameter(line.view(), c.core.tick, c.core.config.answer_ticks);
    return true;
}

void watch_production(Channel& c) noexcept {
    const ChannelConfig& config = c.core.config.channels[c.index];
    c.core.signals.set_nc(
        signals::cn_parts(c.number),
        config.parts_wanted > 0 && c.core.totals.machined(c.index) >= config.parts_wanted);
    if (c.production.warm_up_s <= 0 || !c.program.runs() ||
        c.production.times.cycle_s < c.production.warm_up_s)
        return;
    ShortText text;
    text << static_cast<std::int64_t>(c.production.warm_up_s) << " s";
    c.production.warm_up_s = 0;
    c.production.stops_after_part = true;
    c.core.alarm(Alarm::WarmUpOver, c.number, text.view(), 0, c.shown.line);
}

}  // namespace polyturn::kernel
