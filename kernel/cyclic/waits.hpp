// Who waits for whom (architecture 7, nct_parameters_part2 23). A wait is a code and a set of channels. All channels of the
// set that have arrived leave in the same tick: when each channel of the set has arrived at the same code with the same
// set, or is one for which nobody waits (CP_NOWT). A channel with its own CP_NOWT waits for nobody.
//
//   arrived   1: M501 {1,2}   2: M502 {1,2}   -> 1 misses 2, 2 misses 1: a circle, no third channel can open it
//   arrived   1: M501 {1,2}   2: M502 {2,3}   -> 1 misses 2, 2 misses 3; 3 is on its way: no circle
//
// Invariant: an arrival is consumed by its release; a fast channel is never counted for an earlier meeting.
// Pure arithmetic on 16 channels: no clock, no image. Tested against a plain model.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/capacities.hpp"
#include "ipc/machine/wait_name.hpp"

namespace polyturn::kernel {

using ChannelSet = std::uint32_t;  // bit 0 is channel 1

class WaitBoard {
public:
    struct Arrival {
        bool here = false;
        std::int32_t code = 0;
        ChannelSet set = 0;
    };
    enum class Fault : std::uint8_t { None, OtherSet, Circle };
    struct Verdict {
        Fault fault = Fault::None;
        ChannelSet with = 0;  // the channels it concerns beside the one that arrived
    };

    // Code of a wait for the end of the programs of its set, whatever those wait for themselves.
    static constexpr std::int32_t kProgramEnd = kWaitAtProgramEnd;
    void idle(ChannelSet set) noexcept { idle_ = set; }   // channels in which no program runs, told each tick

    // Channels count from 0 here.
    void arrive(unsigned channel, std::int32_t code, ChannelSet set) noexcept { arrivals_[channel] = {true, code, set}; }
    void leave(unsigned channel) noexcept { arrivals_[channel].here = false; }
    // A marker of the channel (0 to 99): while it is set, the channel counts as arrived at that code, whatever the set. A
    // release of the channel itself at that code clears it. code -1: all.
    void mark(unsigned channel, std::int32_t code, bool on) noexcept;
    bool marked(unsigned channel, std::int32_t code) const noexcept;
    const Arrival& at(unsigned channel) const noexcept { return arrivals_[channel]; }

    // Channels of its set that `channel` still misses.
    ChannelSet missing(unsigned channel, ChannelSet no_wait) const noexcept;
    // Would a channel that came to (code, set) now pass at once? Flying waits ask before they arrive.
    bool open_for(unsigned channel, std::int32_t code, ChannelSet set, ChannelSet no_wait) const noexcept;
    // Who leaves now. Call once a tick, after all arrivals of the tick; their arrivals are consumed.
    ChannelSet release(ChannelSet no_wait) noexcept;
    // Is what `channel` just arrived at impossible? Ask after release().
    Verdict judge(unsigned channel, ChannelSet no_wait) const noexcept;

private:
    static constexpr std::int32_t kMarkers = 100;
    bool ended(unsigned channel, std::int32_t code) const noexcept { return code == kProgramEnd && (idle_ >> channel & 1u); }
    std::array<Arrival, kMaxChannels> arrivals_{};
    ChannelSet idle_ = 0;
    std::array<std::array<bool, kMarkers>, kMaxChannels> marks_{};
};

}  // namespace polyturn::kernel
