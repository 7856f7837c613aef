#include "kernel/channel/channel.hpp"

#include <algorithm>

#include "kernel/channel/program/settle.hpp"

namespace polyturn::kernel {

void Channel::report(KernelEventKind kind, const PathRecord& r, double offset_s) noexcept {
    if (r.note == 0) return;
    KernelEvent* event = core.log.claim(kind, number, core.tick, offset_s);
    if (!event) return;
    event->note = r.note;
    event->line = r.line;
    event->code = r.kind;
    core.log.put();
}

void Channel::stand(ChannelState state, StopReason reason) noexcept {
    program.enter(state, reason);
    core.event(KernelEventKind::Stopped, number, static_cast<std::int32_t>(reason), 0, shown.line);
}

void Channel::raise(Alarm alarm, std::string_view detail, double value) noexcept {
    if (program.alarm) return;  // the first one is the cause
    program.alarm = true;
    program.brake_for(Brake::Alarm);  // settle_program() makes it the state once the path rests
    core.alarm(alarm, number, detail, value, shown.line);
}

void Channel::tell(ChannelEventKind kind, std::uint64_t of_record, double value,
                   std::string_view text) noexcept {
    // positions and states that the channel reads are those of the end of this tick
    outbox.put(kind, path.epoch, core.tick + 1, of_record, value, text);
}

// The language of what runs: of the selected program, where its job says one; a block by hand is in
// that of the machine.
Dialect Channel::speaks() const noexcept {
    return program.mode != ChannelMode::Mdi && !hand.run() && process.says_language()
               ? process.language
               : core.config.channels[index].language;
}

double Channel::feed_factor() const noexcept {
    const ChannelConfig& config = core.config.channels[index];
    return std::min(panel.feed_override, traits().override_ranges ? config.feed_override_end
                                                                  : config.feed_override_max);
}

}  // namespace polyturn::kernel
