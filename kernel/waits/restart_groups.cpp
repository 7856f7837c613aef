#include "kernel/waits/restart_groups.hpp"

namespace polyturn::kernel {

RestartGroups::Asked RestartGroups::ask(unsigned channel, ChannelSet together,
                                        std::int64_t tick) noexcept {
    const ChannelSet bit = ChannelSet{1} << channel, set = together | bit;
    std::size_t place = groups_.size();
    std::uint32_t newest = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        const Group& group = groups_[g];
        if (group.set == set && !(group.asked & bit) && group.id > newest) {
            place = g;
            newest = group.id;
        } else if (group.set == 0 && place == groups_.size())
            place = g;
    }
    // more unfinished restarts than channels
    if (place == groups_.size()) return {0, 0, true};
    Group& group = groups_[place];
    if (group.set == 0) {
        group = {};
        group.set = set;
        group.since = tick;
        group.id = ++last_id_;
        ++used_;
    }
    group.asked |= bit;
    return {place, group.id, group.over};
}

RestartGroups::Refusal RestartGroups::refused(const Asked& asked, unsigned channel) noexcept {
    Group& group = groups_[asked.place];
    Refusal refusal;
    refusal.back = group.members;
    refusal.all = group.set;
    refusal.who = channel;
    refusal.why = Fate::Refused;
    // of one alone its own refusal says all
    refusal.told = !group.over && group.set != ChannelSet{1} << channel;
    group.over = true;
    group.complete = false;
    group.members = 0;
    return refusal;
}

bool RestartGroups::complete(unsigned channel) const noexcept {
    for (const Group& group : groups_)
        if (group.members >> channel & 1u) return group.complete;
    return true;  // it restarts in no group any more
}

}  // namespace polyturn::kernel
