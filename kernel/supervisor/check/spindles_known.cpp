#include "kernel/supervisor/check/spindles_known.hpp"

namespace polyturn::supervisor {

namespace {
bool exists(unsigned channel) { return channel >= 1 && channel <= kMaxChannels; }
}  // namespace

void SpindlesKnown::commanded(unsigned channel, unsigned spindle, bool turns) {
    if (exists(channel) && spindle >= 1 && spindle <= kMaxSpindles)
        facts_[channel - 1][spindle - 1] = {++order_, turns};
}

void SpindlesKnown::met(std::span<const unsigned> channels) {
    for (std::size_t spindle = 0; spindle < kMaxSpindles; ++spindle) {
        Fact latest;
        for (const unsigned channel : channels)
            if (exists(channel) && facts_[channel - 1][spindle].order > latest.order)
                latest = facts_[channel - 1][spindle];
        for (const unsigned channel : channels)
            if (exists(channel)) facts_[channel - 1][spindle] = latest;
    }
}

std::uint32_t SpindlesKnown::turning(unsigned channel) const {
    std::uint32_t out = 0;
    if (!exists(channel)) return out;
    for (std::size_t spindle = 0; spindle < kMaxSpindles; ++spindle)
        if (facts_[channel - 1][spindle].turns) out |= 1u << spindle;
    return out;
}

}  // namespace polyturn::supervisor
