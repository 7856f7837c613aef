#include "hmi/machine/programs/aligned_job.hpp"

#include <algorithm>

namespace polyturn::hmi {

void AlignedJob::build(const std::map<unsigned, RunChannel>& channels) {
    struct At {
        unsigned number;
        const RunChannel* channel;
        std::size_t block = 0, wait = 0;
        const RunWait* next() const {
            return wait < channel->waits.size() ? &channel->waits[wait] : nullptr;
        }
    };
    std::vector<At> at;
    order_.clear();
    rows_.clear();
    blocks_.clear();
    for (const auto& [number, channel] : channels) {
        at.push_back({number, &channel});
        order_.push_back(number);
    }
    for (;;) {
        bool any = false;
        const std::size_t first = blocks_.size();
        for (At& now : at) {
            const RunWait* next = now.next();
            const std::size_t until = next ? next->before : now.channel->blocks.size();
            // the wait's own block is shown by the bridge
            const bool has = now.block + (next ? 1 : 0) < until;
            blocks_.push_back(has ? static_cast<std::uint32_t>(++now.block) : 0u);
            any |= has;
        }
        if (any) {
            rows_.push_back({first, 0, 0, 0});
            continue;
        }
        blocks_.resize(first);
        // All channels are at a wait or at the end: the first complete rendezvous opens;
        // without one, the first that waits is shown alone.
        const At *open = nullptr, *stuck = nullptr;
        for (const At& now : at) {
            const RunWait* next = now.next();
            if (!next) continue;
            if (!stuck) stuck = &now;
            const bool complete =
                std::all_of(next->channels.begin(), next->channels.end(), [&](unsigned other) {
                    const auto found = std::find_if(
                        at.begin(), at.end(), [&](const At& one) { return one.number == other; });
                    return found != at.end() && found->next() && found->next()->code == next->code;
                });
            if (complete && !open) open = &now;
        }
        const At* bridge = open ? open : stuck;
        if (!bridge) return;
        const RunWait& met = *bridge->next();
        Row row{first, bridge->number, bridge->wait, 0};
        for (At& now : at) {
            const RunWait* next = now.next();
            if (!next || (next != &met &&
                          !(open && next->code == met.code && next->channels == met.channels)))
                continue;
            row.here |= 1u << (now.number - 1);
            now.block = std::max(now.block, next->before);
            ++now.wait;
        }
        rows_.push_back(row);
    }
}

const RunLine* AlignedJob::line(const std::map<unsigned, RunChannel>& channels, const Row& row,
                                unsigned channel) const {
    const auto place = std::find(order_.begin(), order_.end(), channel);
    const auto now = channels.find(channel);
    if (row.channel || place == order_.end() || now == channels.end()) return nullptr;
    const std::uint32_t block =
        blocks_[row.first + static_cast<std::size_t>(place - order_.begin())];
    return block && block <= now->second.blocks.size() ? &now->second.blocks[block - 1] : nullptr;
}

const RunWait* AlignedJob::wait(const std::map<unsigned, RunChannel>& channels,
                                const Row& row) const {
    const auto now = channels.find(row.channel);
    return now != channels.end() && row.wait < now->second.waits.size()
               ? &now->second.waits[row.wait]
               : nullptr;
}

}  // namespace polyturn::hmi
