#include "kernel/waits/waits.hpp"

#include "ipc/diagnosis/assert.hpp"

namespace polyturn::kernel {

void WaitBoard::mark(Marks& marks, unsigned channel, std::int32_t code, bool on) noexcept {
    if (code < 0)
        marks[channel].fill(on);
    else if (code < kMarkers)
        marks[channel][static_cast<std::size_t>(code)] = on;
}

bool WaitBoard::marked(const Marks& marks, unsigned channel, std::int32_t code) noexcept {
    return code >= 0 && code < kMarkers && marks[channel][static_cast<std::size_t>(code)];
}

// Is `other` where a channel that has come like this wants to meet it?
bool WaitBoard::meets(std::int32_t code, ChannelSet set, const Phase& as,
                      unsigned other) const noexcept {
    const bool searches = as.kind == Kind::Search;
    // one of the restart has not come to its end
    if (code == kProgramEnd) return !searches && standing_[other].ended;
    const Arrival& there = arrivals_[other];
    return (counts(other) && there.code == code && there.set == set && phase(other) == as) ||
           marked(searches ? searched_ : marks_, other, code);
}

ChannelSet WaitBoard::missing(unsigned channel, ChannelSet no_wait) const noexcept {
    const Arrival& mine = arrivals_[channel];
    const Phase as = phase(channel);
    ChannelSet out = 0;
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        const ChannelSet bit = ChannelSet{1} << k;
        if (k == channel || !(mine.set & bit) || (no_wait & bit)) continue;
        if (!meets(mine.code, mine.set, as, k)) out |= bit;
    }
    return out;
}

ChannelSet WaitBoard::unlike(unsigned channel, ChannelSet no_wait) const noexcept {
    const Arrival& mine = arrivals_[channel];
    ChannelSet out = missing(channel, no_wait);
    for (unsigned k = 0; k < kMaxChannels; ++k)
        if (!counts(k) || arrivals_[k].code != mine.code || arrivals_[k].set != mine.set ||
            phase(k) == phase(channel))
            out &= ~(ChannelSet{1} << k);
    return out;
}

bool WaitBoard::open_for(unsigned channel, std::int32_t code, ChannelSet set, ChannelSet no_wait,
                         Phase as) const noexcept {
    if (no_wait >> channel & 1u) return true;
    as = phase(as, channel);
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        const ChannelSet bit = ChannelSet{1} << k;
        if (k == channel || !(set & bit) || (no_wait & bit)) continue;
        if (!meets(code, set, as, k)) return false;
    }
    return true;
}

ChannelSet WaitBoard::release(ChannelSet no_wait) noexcept {
    ChannelSet out = 0;
    for (unsigned c = 0; c < kMaxChannels; ++c)
        if (counts(c) && ((no_wait >> c & 1u) || missing(c, no_wait) == 0))
            out |= ChannelSet{1} << c;
    // Decided for all before any channel leaves: the partners of a rendezvous see each other.
    for (unsigned c = 0; c < kMaxChannels; ++c)
        if (out >> c & 1u) {
            Marks& marks = arrivals_[c].phase.kind == Kind::Search ? searched_ : marks_;
            arrivals_[c].here = false;
            PT_ASSERT(!counts(c), "I1 an arrival is consumed by its release");
            if (marked(marks, c, arrivals_[c].code)) mark(marks, c, arrivals_[c].code, false);
        }
    return out;
}

ChannelSet WaitBoard::alike(unsigned channel) const noexcept {
    ChannelSet out = 0;
    for (unsigned k = 0; k < kMaxChannels; ++k)
        if (counts(k) && phase(k) == phase(channel)) out |= ChannelSet{1} << k;
    return out;
}

WaitBoard::Verdict WaitBoard::judge(unsigned channel, ChannelSet no_wait) const noexcept {
    const Arrival& mine = arrivals_[channel];
    if (!counts(channel)) return {};
    // a fault can only mean these; other obstacles are removed by the operator
    const ChannelSet like = alike(channel);
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        const Arrival& other = arrivals_[k];
        if (mine.code != kProgramEnd && k != channel && (like >> k & 1u) &&
            other.code == mine.code && other.set != mine.set && (other.set & mine.set))
            return {Fault::OtherSet, ChannelSet{1} << k};
    }
    const Ring ring = deadlock(channel, no_wait);
    if (ring.count == 0) return {};
    ChannelSet with = 0;
    for (unsigned i = 1; i < ring.count; ++i) with |= ChannelSet{1} << ring.channel[i];
    return {Fault::Circle, with};
}

// A channel leaves only when all that it misses have come, so one stuck partner suffices: walk from
// this channel along «misses, and that one waits elsewhere», all channels of the same distance at
// once; coming back to it closes a deadlock. Only deadlocks through the newcomer are new.
WaitBoard::Ring WaitBoard::deadlock(unsigned channel, ChannelSet no_wait) const noexcept {
    Ring ring;
    if (!counts(channel)) return ring;
    const ChannelSet like = alike(channel);
    ChannelSet reached = 0, frontier = ChannelSet{1} << channel;
    std::array<std::uint8_t, kMaxChannels> from{};  // the channel that misses it
    while (frontier) {
        ChannelSet next = 0;
        for (unsigned c = 0; c < kMaxChannels; ++c) {
            if (!(frontier >> c & 1u)) continue;
            const ChannelSet lacks = missing(c, no_wait);
            for (unsigned k = 0; k < kMaxChannels; ++k) {
                const ChannelSet bit = ChannelSet{1} << k;
                if (!(lacks & like & bit) || (reached & bit)) continue;
                from[k] = static_cast<std::uint8_t>(c);
                reached |= bit;
                next |= bit;
            }
        }
        if (reached >> channel & 1u) {
            unsigned c = channel;  // backwards from the end of the ring to its beginning
            do ring.channel[kMaxChannels - ++ring.count] = static_cast<std::uint8_t>(c = from[c]);
            while (c != channel);
            PT_ASSERT(ring.count >= 2 && ring.count <= kMaxChannels, "a deadlock has partners");
            for (unsigned i = 0; i < ring.count; ++i)
                ring.channel[i] = ring.channel[kMaxChannels - ring.count + i];
            return ring;
        }
        frontier = next;
    }
    return ring;
}

}  // namespace polyturn::kernel
