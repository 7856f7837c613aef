// Do the waits of several programs fit together? (architecture 7). Works on what each channel does
// in order, without time. Who meets whom is the kernel's own board (kernel/waits): each channel is
// put there at the wait that it comes to next, and what the board releases goes on to the one
// behind. Only what needs the future is added here.
//
//   Faults, found when no channel can go on (each named once; then matching goes on as if it were
//   repaired):
//     different sets   two channels stand at, or will come to, the same code with different sets
//     absent           a channel of the set has no program
//     unpaired         a channel of the set never comes to the code
//     cycle            everybody will come, but each waits for another first
//
// The order of rendezvous does not matter: releasing one set never hinders another, so the result
// is unique.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "kernel/waits/waits.hpp"

namespace polyturn::supervisor {

struct WaitPoint {
    std::int32_t code = 0;  // M code, marker or one of ipc/model/languages/wait_name.hpp
    std::uint32_t set = 0;  // bit 0 is channel 1
    std::string file;
    std::uint32_t line = 0;
    std::string written = {};  // as the channel's language writes the code; empty: M code
};

struct WaitFault {
    Diagnosis diagnosis;                                 // place: the wait of `channel`
    unsigned channel = 0;                                // the channel that arrived last
    std::vector<std::pair<unsigned, WaitPoint>> places;  // every wait that takes part
};

class WaitMatcher {
public:
    // Its program begins, or another one behind it (START).
    void begin(unsigned channel);
    // The channel has come to its next wait. Arrivals may run ahead of rendezvous.
    void arrive(unsigned channel, WaitPoint wait);
    // A marker that the channel sets counts as its arrival at that code, until it waits there
    // itself. When it clears the marker again is not known without time: a partner is taken to have
    // come before.
    void mark(unsigned channel, std::int32_t code);
    // The program has ended; `broken`: with an alarm, so nothing can be said about the rest of it.
    void end(unsigned channel, bool broken);

    // Releases every set that is complete. Channels that may go on are returned (each as often as
    // it was released).
    std::vector<unsigned> meet();
    bool stands(unsigned channel) const;  // at a wait that is not met yet
    // Nothing can go on and all that will come is known: what is wrong? Ends with everybody past
    // his last wait.
    std::vector<WaitFault> find_faults();
    std::size_t meetings() const { return meetings_; }

private:
    struct Track {
        std::vector<WaitPoint> waits;
        std::size_t next = 0;  // waits[next] is its position
        bool ended = false, broken = false;
        std::uint64_t arrived = 0;  // order of arrival at `next`
        auto here() { return waits.begin() + static_cast<std::ptrdiff_t>(next); }
        auto here() const { return waits.begin() + static_cast<std::ptrdiff_t>(next); }
        // the next wait at this code, waits.end(): it comes to none
        std::vector<WaitPoint>::iterator coming(std::int32_t code);
        std::vector<WaitPoint>::const_iterator coming(std::int32_t code) const;
    };
    const WaitPoint* standing(unsigned channel) const;
    bool comes_to(unsigned channel, std::int32_t code) const;
    void place(unsigned channel);
    void advance(unsigned channel);
    void take_out(unsigned channel, std::int32_t code);
    bool report_different_sets(std::vector<WaitFault>& faults);
    bool report_missing(std::vector<WaitFault>& faults);
    bool report_cycle(std::vector<WaitFault>& faults);
    bool drop_open_end();

    std::map<unsigned, Track> tracks_;
    kernel::WaitBoard board_;  // where each of them stands
    std::size_t meetings_ = 0;
    std::uint64_t clock_ = 0;
};

}  // namespace polyturn::supervisor
