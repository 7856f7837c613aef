// Waits between channels (architecture 7, nct_parameters_part2 23; docs/design/waits.md). A wait is
// a code and a set of channels. All channels of the set that have arrived leave in the same tick:
// when each channel of the set has arrived at the same code with the same set, or is one that is
// not waited for (CP_NOWT). A channel with its own CP_NOWT does not wait.
//
//   arrived   1: M501 {1,2}   2: M502 {1,2}   -> 1 misses 2, 2 misses 1: a deadlock, which no
//                                                third channel can resolve
//   arrived   1: M501 {1,2}   2: M502 {2,3}   -> 1 misses 2, 2 misses 3; 3 is still coming: no
//                                                deadlock
//
// I1  An arrival is consumed by its release; a fast channel is never counted for an earlier
//     rendezvous.
// I2  An arrival counts only in the run of the program that made it, and only while that program is
//     live: no alarm, reset or death has to take it away, and none can forget to.
// I3  Only like meets like: a cut a cut, a dry run a dry run, a block by hand another one, a search
//     one of the same restart.
//
// Pure arithmetic on 16 channels: no clock, no image. A library of its own: the kernel asks it each
// tick, `check` asks the same one without time (supervisor/check/wait_match.hpp). Tested against
// plain models.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/capacities.hpp"
#include "ipc/model/languages/wait_name.hpp"

namespace polyturn::kernel {

using ChannelSet = std::uint32_t;  // bit 0 is channel 1

// What has led a channel to its code. Dry: while the key is on, also of one that has come without
// it.
enum class WaitKind : std::uint8_t { Cut, Dry, ByHand, Search };
struct WaitPhase {
    WaitKind kind = WaitKind::Cut;
    std::uint32_t group = 0;  // of a search: channels that restart together
    bool operator==(const WaitPhase&) const = default;
};

class WaitBoard {
public:
    using Kind = WaitKind;
    using Phase = WaitPhase;
    struct Arrival {
        bool here = false;
        std::int32_t code = 0;
        ChannelSet set = 0;
        std::uint64_t run = 0;
        Phase phase;
    };
    // State of a channel, set each tick before release().
    struct Standing {
        std::uint64_t run = 0;  // grows with each start and each reset
        bool live = false;      // its program runs: no alarm, reset or death ends it
        bool dry = false;
        // no program of it is under way, and the last one was not cut off by the death of its
        // process
        bool ended = false;
    };
    enum class Fault : std::uint8_t { None, OtherSet, Circle };
    struct Verdict {
        Fault fault = Fault::None;
        ChannelSet with = 0;  // the channels concerned besides the one that arrived
    };
    // Channels that wait for each other: each misses the next one, the last one the first.
    struct Ring {
        std::array<std::uint8_t, kMaxChannels> channel{};
        unsigned count = 0;  // 0: no deadlock
    };

    // Code of a wait for the end of the programs of its set, whatever those wait for themselves.
    static constexpr std::int32_t kProgramEnd = kWaitAtProgramEnd;

    // Channels count from 0 here.
    void tell(unsigned channel, const Standing& standing) noexcept {
        standing_[channel] = standing;
    }
    void arrive(unsigned channel, std::int32_t code, ChannelSet set, std::uint64_t run = 0,
                Phase phase = {}) noexcept {
        arrivals_[channel] = {true, code, set, run, phase};
        // it is there from now on, visible in this very tick
        standing_[channel].run = run;
        standing_[channel].live = true;
    }
    void leave(unsigned channel) noexcept { arrivals_[channel].here = false; }
    // A marker of the channel (0 to 99): while it is set, the channel counts as arrived at that
    // code, whatever the set. A release of the channel itself at that code clears it. code -1: all.
    void mark(unsigned channel, std::int32_t code, bool on) noexcept {
        mark(marks_, channel, code, on);
    }
    bool marked(unsigned channel, std::int32_t code) const noexcept {
        return marked(marks_, channel, code);
    }
    // What a search sets counts in that search, and for everybody when its channel starts at the
    // block.
    void begin_search(unsigned channel) noexcept { searched_[channel] = marks_[channel]; }
    void mark_in_search(unsigned channel, std::int32_t code, bool on) noexcept {
        mark(searched_, channel, code, on);
    }
    void take_search(unsigned channel) noexcept { marks_[channel] = searched_[channel]; }
    const Arrival& at(unsigned channel) const noexcept { return arrivals_[channel]; }
    // It is at a code now; others may rendezvous with it there.
    bool counts(unsigned channel) const noexcept {
        return arrivals_[channel].here && standing_[channel].live &&
               arrivals_[channel].run == standing_[channel].run;
    }
    Phase phase(unsigned channel) const noexcept {
        return phase(arrivals_[channel].phase, channel);
    }

    // Channels of its set that `channel` still misses.
    ChannelSet missing(unsigned channel, ChannelSet no_wait) const noexcept;
    // Of these, the channels that are at the same code with the same set but do not count as
    // arrived, because another operation (restart, MDI) has led them there.
    ChannelSet unlike(unsigned channel, ChannelSet no_wait) const noexcept;
    // Would a channel that came to (code, set) now pass at once? Flying waits ask before they
    // arrive.
    bool open_for(unsigned channel, std::int32_t code, ChannelSet set, ChannelSet no_wait,
                  Phase as = {}) const noexcept;
    // The channels that leave now. Call once a tick, after all arrivals of the tick; their arrivals
    // are consumed.
    ChannelSet release(ChannelSet no_wait) noexcept;
    // Is what `channel` just arrived at impossible? Ask after release().
    Verdict judge(unsigned channel, ChannelSet no_wait) const noexcept;
    // The shortest deadlock through `channel`, beginning with it.
    Ring deadlock(unsigned channel, ChannelSet no_wait) const noexcept;

private:
    static constexpr std::int32_t kMarkers = 100;
    using Marks = std::array<std::array<bool, kMarkers>, kMaxChannels>;
    static void mark(Marks& marks, unsigned channel, std::int32_t code, bool on) noexcept;
    static bool marked(const Marks& marks, unsigned channel, std::int32_t code) noexcept;
    Phase phase(const Phase& came_as, unsigned channel) const noexcept {
        return came_as.kind == Kind::Cut && standing_[channel].dry ? Phase{Kind::Dry, 0} : came_as;
    }
    bool meets(std::int32_t code, ChannelSet set, const Phase& as, unsigned other) const noexcept;
    // that are at a code and have come to it in the same phase
    ChannelSet alike(unsigned channel) const noexcept;
    std::array<Arrival, kMaxChannels> arrivals_{};
    std::array<Standing, kMaxChannels> standing_{};
    Marks marks_{}, searched_{};
};

}  // namespace polyturn::kernel
