#include "kernel/cyclic/waits.hpp"

namespace polyturn::kernel {

void WaitBoard::mark(unsigned channel, std::int32_t code, bool on) noexcept {
    if (code < 0) marks_[channel].fill(on);
    else if (code < kMarkers) marks_[channel][static_cast<std::size_t>(code)] = on;
}

bool WaitBoard::marked(unsigned channel, std::int32_t code) const noexcept {
    return code >= 0 && code < kMarkers && marks_[channel][static_cast<std::size_t>(code)];
}

ChannelSet WaitBoard::missing(unsigned channel, ChannelSet no_wait) const noexcept {
    const Arrival& mine = arrivals_[channel];
    ChannelSet out = 0;
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        const ChannelSet bit = ChannelSet{1} << k;
        if (k == channel || !(mine.set & bit) || (no_wait & bit)) continue;
        const Arrival& other = arrivals_[k];
        const bool meets = mine.code == kProgramEnd ? ended(k, mine.code) : (other.here && other.code == mine.code && other.set == mine.set) || marked(k, mine.code);
        if (!meets) out |= bit;
    }
    return out;
}

bool WaitBoard::open_for(unsigned channel, std::int32_t code, ChannelSet set, ChannelSet no_wait) const noexcept {
    if (no_wait >> channel & 1u) return true;
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        const ChannelSet bit = ChannelSet{1} << k;
        if (k == channel || !(set & bit) || (no_wait & bit)) continue;
        const Arrival& other = arrivals_[k];
        if (!(other.here && other.code == code && other.set == set) && !marked(k, code)) return false;
    }
    return true;
}

ChannelSet WaitBoard::release(ChannelSet no_wait) noexcept {
    ChannelSet out = 0;
    for (unsigned c = 0; c < kMaxChannels; ++c)
        if (arrivals_[c].here && ((no_wait >> c & 1u) || missing(c, no_wait) == 0)) out |= ChannelSet{1} << c;
    // Decided for all before anybody leaves: the partners of one meeting see each other.
    for (unsigned c = 0; c < kMaxChannels; ++c)
        if (out >> c & 1u) {
            arrivals_[c].here = false;
            if (marked(c, arrivals_[c].code)) mark(c, arrivals_[c].code, false);
        }
    return out;
}

WaitBoard::Verdict WaitBoard::judge(unsigned channel, ChannelSet no_wait) const noexcept {
    const Arrival& mine = arrivals_[channel];
    if (!mine.here) return {};
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        const Arrival& other = arrivals_[k];
        if (mine.code != kProgramEnd && k != channel && other.here && other.code == mine.code && other.set != mine.set && (other.set & mine.set))
            return {Fault::OtherSet, ChannelSet{1} << k};
    }
    // A channel leaves only when all that it misses have come, so one stuck partner suffices: walk from this channel along
    // «misses, and that one waits elsewhere»; coming back to it closes a circle. Only circles through the newcomer are new.
    ChannelSet reached = 0, frontier = ChannelSet{1} << channel;
    std::array<std::uint8_t, kMaxChannels> from{};
    while (frontier) {
        ChannelSet next = 0;
        for (unsigned c = 0; c < kMaxChannels; ++c) {
            if (!(frontier >> c & 1u)) continue;
            const ChannelSet lacks = missing(c, no_wait);
            for (unsigned k = 0; k < kMaxChannels; ++k) {
                const ChannelSet bit = ChannelSet{1} << k;
                if (!(lacks & bit) || !arrivals_[k].here || (reached & bit)) continue;
                from[k] = static_cast<std::uint8_t>(c);
                reached |= bit;
                next |= bit;
            }
        }
        if (reached >> channel & 1u) {
            ChannelSet circle = 0;
            for (unsigned c = from[channel]; c != channel; c = from[c]) circle |= ChannelSet{1} << c;
            return {Fault::Circle, circle};
        }
        frontier = next;
    }
    return {};
}

}  // namespace polyturn::kernel
