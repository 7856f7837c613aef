// Do the waits of several programs fit together? (architecture 7). Works on what each channel does
// in order, without time: a wait is met when every channel of its set is at the same code with
// the same set.
//
//   Meeting   all channels of a set at the same (code, set): they go on together.
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
#include <set>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::supervisor {

struct WaitPoint {
    std::string code;       // "M501" or a marker's name; the same in every language
    std::uint32_t set = 0;  // bit 0 is channel 1
    std::string file;
    std::uint32_t line = 0;
    std::string written = {};  // as the channel's language writes the code; empty: as it is
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
    void mark(unsigned channel, const std::string& code);
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
        std::set<std::string> markers;
        std::uint64_t arrived = 0;  // order of arrival at `next`
    };
    const WaitPoint* standing(unsigned channel) const;
    bool comes_to(unsigned channel, const std::string& code) const;
    void advance(unsigned channel);
    bool report_different_sets(std::vector<WaitFault>& faults);
    bool report_missing(std::vector<WaitFault>& faults);
    bool report_cycle(std::vector<WaitFault>& faults);
    bool drop_open_end();

    std::map<unsigned, Track> tracks_;
    std::size_t meetings_ = 0;
    std::uint64_t clock_ = 0;
};

}  // namespace polyturn::supervisor
