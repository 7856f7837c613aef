// Channels that restart at a block together (press restart L1=N170 L2=N100). Each searches by
// itself, replays the waits between them, and stops at its block; a search is complete only when
// all have found their blocks.
//
//             asked              block found                      all are there
//   (nothing) -----> Searching -------------> AtBlock ... of all: -------------> a start of each is
//   allowed; who starts has left
//                        '-- reset, alarm, death, no block, refused, never asked: all others go
//                        back to reset --'
//
// I1  Who is at its block while another one is not, or is no longer, is not started. I2  The end of
// one that has not started yet is the end of all that have not. I3  It is said once, with the
// channel that ended it; where the operator has ended all in one tick, nothing is said. Asked from
// what the channels are, once a tick and before each start, so that no way into reset, alarm or
// death can be forgotten.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/capacities.hpp"
#include "kernel/waits/restart_fate.hpp"
#include "kernel/waits/waits.hpp"

namespace polyturn::kernel {

class RestartGroups {
public:
    using Fate = RestartFate;
    // A group that ends: channels that must go back to reset (those in alarm too), and why.
    struct Refusal {
        ChannelSet back = 0;
        ChannelSet all = 0;  // of the restart
        unsigned who = 0;    // from 0
        Fate why = Fate::Searching;
        bool told = false;  // it is to be said
    };

    // A channel (from 0) is asked to restart with these: the place of its group. `over`: that
    // restart is refused already, it does not begin.
    struct Asked {
        std::size_t place = 0;
        std::uint32_t id = 0;  // distinguishes it from every other restart
        bool over = false;
    };
    Asked ask(unsigned channel, ChannelSet together, std::int64_t tick) noexcept;
    void began(const Asked& asked, unsigned channel) noexcept {
        groups_[asked.place].members |= ChannelSet{1} << channel;
    }
    // it cannot begin: what that means for the others
    Refusal refused(const Asked& asked, unsigned channel) noexcept;
    bool any() const noexcept { return used_ != 0; }
    // All of its group are at their blocks: each may be started.
    bool complete(unsigned channel) const noexcept;

    // One group after the other: `fate(channel)` of each member. Calls `end(refusal)` for a group
    // that ends. Bounded by the channels.
    template <class FateOf, class End>
    void judge(std::int64_t tick, std::int64_t timeout, FateOf fate_of, End end) noexcept {
        for (Group& group : groups_) {
            if (group.set == 0) continue;
            Refusal refusal;
            const ChannelSet members = group.members;
            ChannelSet there = 0;
            for (unsigned l = 0; l < kMaxChannels; ++l) {
                const ChannelSet bit = ChannelSet{1} << l;
                if (!(members & bit)) continue;
                const Fate fate = fate_of(l);
                if (fate == Fate::AtBlock) there |= bit;
                if (fate == Fate::Searching || fate == Fate::AtBlock) continue;
                group.members &= ~bit;
                if (fate == Fate::Started) continue;
                refusal.all = group.set;
                if (fate > refusal.why) {
                    refusal.who = l;
                    refusal.why = fate;
                }
                if (fate == Fate::Alarm || fate == Fate::Ended) refusal.back |= bit;
            }
            const bool late = group.asked != group.set && tick - group.since > timeout;
            if (!group.over && !refusal.all && late) {
                refusal.all = group.set;
                refusal.why = Fate::NotAsked;
                refusal.who = static_cast<unsigned>(__builtin_ctz(group.set & ~group.asked));
            }
            if (refusal.all) {
                refusal.told = group.members != 0;
                refusal.back |= group.members;
                group.over = true;
                group.members = 0;
                end(refusal);
            }
            group.complete = !group.over && group.asked == group.set && there == group.members;
            if (group.members == 0 && (group.asked == group.set || late)) drop(group);
        }
    }

private:
    struct Group {
        ChannelSet set = 0;      // that restart together; 0: this entry is free
        ChannelSet asked = 0;    // channels whose command has come
        ChannelSet members = 0;  // that search or are at their blocks
        std::int64_t since = 0;  // tick of the first command
        std::uint32_t id = 0;
        bool complete = false, over = false;
    };
    void drop(Group& group) noexcept {
        group = {};
        --used_;
    }
    // members are disjoint; the rest is for those that wait for a command
    std::array<Group, 2 * kMaxChannels> groups_{};
    std::uint32_t used_ = 0, last_id_ = 0;
};

}  // namespace polyturn::kernel
