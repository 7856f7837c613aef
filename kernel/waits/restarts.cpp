// Channels that restart at blocks together: all of them, or none.
#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {

// the commands of one restart come in one tick, unless their ring was full between them
constexpr double kAskedWithin_s = 1.0;

std::string_view words_of(RestartGroups::Fate why) noexcept {
    switch (why) {
        case RestartGroups::Fate::Reset:
            return " was reset";
        case RestartGroups::Fate::Alarm:
            return " has an alarm";
        case RestartGroups::Fate::Dead:
            return " has lost its process";
        case RestartGroups::Fate::Ended:
            return " has come to the end of its program";
        case RestartGroups::Fate::NotAsked:
            return " was never asked to";
        default:
            return " cannot begin";
    }
}

}  // namespace

void Machine::restart_channel(const Command& command, std::uint32_t channel) noexcept {
    ChannelRunner& runner = *channels_[channel - 1];
    if (!runner.attached() && command.channel == 0) return;  // all that are there
    const RestartGroups::Asked asked = restarts_.ask(channel - 1, command.flags, core_.tick);
    if (asked.over) return;  // said when the first one was refused
    if (runner.attached() && runner.restart(command.value, command.flags, asked.id))
        restarts_.began(asked, channel - 1);
    else
        end_restart(restarts_.refused(asked, channel - 1));
}

// What became of those that restart: a program starts at its block when all of its restart are
// there, and none does when one is not to come.
void Machine::judge_restarts() noexcept {
    if (!restarts_.any()) return;
    const auto timeout = static_cast<std::int64_t>(kAskedWithin_s / core_.config.tick_s);
    restarts_.judge(
        core_.tick, timeout, [&](unsigned l) { return channels_[l]->restart_fate(); },
        [&](const RestartGroups::Refusal& refusal) { end_restart(refusal); });
    for (unsigned l = 0; l < kMaxChannels; ++l)
        channels_[l]->let_restart_begin(restarts_.complete(l));
}

void Machine::end_restart(const RestartGroups::Refusal& refusal) noexcept {
    for (unsigned l = 0; l < kMaxChannels; ++l)
        if (refusal.back >> l & 1u) channels_[l]->end_restart();
    if (!refusal.told) return;
    ShortText text = name_of('L', refusal.who);
    text << words_of(refusal.why) << " (";
    text.channels(refusal.all) << ")";
    core_.alarm(Alarm::RestartRefused, refusal.who + 1, text.view(), 0,
                channels_[refusal.who]->line());
}

}  // namespace polyturn::kernel
