#include "hmi/machine/programs/critical_path.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::hmi {
namespace {

constexpr double kTogether = 0.02;  // s: a rendezvous ends for all of its channels within some
                                    // ticks

// The last wait of the channel that ended by then and made it stand; nullptr: it has not stood.
const RunWait* stoodLast(const RunChannel& channel, double until) {
    const RunWait* last = nullptr;
    for (const RunWait& wait : channel.waits)
        if (wait.to <= until + kTogether && wait.from < until - kTogether &&
            wait.to - wait.from > kTogether && (!last || wait.to > last->to))
            last = &wait;
    return last;
}

// The channel that came last to the rendezvous, when it ended; 0: none, it went on for another
// reason.
unsigned cameLast(const std::map<unsigned, RunChannel>& channels, const RunWait& meeting) {
    unsigned out = 0;
    double latest = meeting.to - kTogether;
    for (const auto& [number, channel] : channels)
        for (const RunWait& wait : channel.waits)
            if (&wait != &meeting && wait.code == meeting.code &&
                std::abs(wait.to - meeting.to) <= kTogether && wait.from >= latest) {
                out = number;
                latest = wait.from;
            }
    return out;
}

}  // namespace

std::vector<RunStretch> criticalPath(const std::map<unsigned, RunChannel>& channels) {
    std::vector<RunStretch> out;
    unsigned now = 0;
    double until = 0;
    std::size_t waits = 0;
    for (const auto& [number, channel] : channels) {
        waits += channel.waits.size();
        if (channel.end > until) {
            now = number;
            until = channel.end;
        }
    }
    const auto add = [&](double from) {
        if (!out.empty() && out.back().channel == now)
            out.back().from = from;
        else
            out.push_back({now, from, until});
    };
    while (now && until > 0) {
        // each wait is passed once
        const RunWait* stood = waits-- > 0 ? stoodLast(channels.at(now), until) : nullptr;
        if (!stood) {
            add(0);
            break;
        }
        const unsigned last = cameLast(channels, *stood);
        const double from = std::min(until, last ? stood->to : stood->from);
        add(from);
        until = from;
        if (last) now = last;
    }
    std::reverse(out.begin(), out.end());
    return out;
}

}  // namespace polyturn::hmi
