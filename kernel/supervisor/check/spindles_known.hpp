// Which spindles certainly turn where a program comes to in `polyturn check`, which knows no time?
// A channel knows what it has commanded itself, and by each rendezvous all that its partners knew
// there. Of what two of them knew the later command counts.
//
//   L1  M3 S1 ---- M500 ---- M5 --- M501 ----        behind M500 L2 knows that S1 turns;
//   L2  ---------- M500 -- G1 F0.2 - M501 ----       M5 it learns at M501
//
// Weakness: a partner that stops the spindle between two rendezvous is learnt of at the next one
// only.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "ipc/capacities.hpp"

namespace polyturn::supervisor {

class SpindlesKnown {
public:
    // Channels and spindles from 1; others are passed over.
    void commanded(unsigned channel, unsigned spindle, bool turns);
    void met(std::span<const unsigned> channels);
    std::uint32_t turning(unsigned channel) const;  // bit 0 is spindle 1

private:
    struct Fact {
        std::uint64_t order = 0;  // 0: no channel has commanded it
        bool turns = false;
    };
    std::array<std::array<Fact, kMaxSpindles>, kMaxChannels> facts_{};
    std::uint64_t order_ = 0;
};

}  // namespace polyturn::supervisor
