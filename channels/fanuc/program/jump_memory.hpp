// Where jumps have led: a GOTO, a loop that is left or a call searches the text once and costs
// nothing from then on, also in a program of 200 MB.
//
// A program text does not change while it runs, and what a search finds depends on nothing but the
// place where it begins, the program's begin and the number. Bounded: when it is full it begins
// anew.
#pragma once
#include <cstdint>
#include <unordered_map>

#include "channels/fanuc/program/text_place.hpp"

namespace polyturn::channels::fanuc {

class JumpMemory {
public:
    struct Place {
        std::uint32_t file = 0;
        std::uint64_t from = 0, begin = 0;  // bytes of the text
        std::int64_t number = 0;            // of the block or program; a loop's END: negative
        bool operator==(const Place&) const = default;
    };
    const TextPlace* find(const Place& place) const {
        const auto found = known_.find(place);
        return found == known_.end() ? nullptr : &found->second;
    }
    void remember(const Place& place, TextPlace to) {
        if (known_.size() >= kMost) known_.clear();
        known_.emplace(place, to);
    }
    static constexpr std::size_t kMost = 16'384;

private:
    struct Hash {
        std::size_t operator()(const Place& p) const {
            std::uint64_t h =
                p.from * 0x9E3779B97F4A7C15ull ^ (p.begin + 0x7F4A7C15ull) * 0xC2B2AE3D27D4EB4Full;
            h ^= (static_cast<std::uint64_t>(p.number) +
                  (static_cast<std::uint64_t>(p.file) << 40)) *
                 0xD6E8FEB86659FD93ull;
            return static_cast<std::size_t>(h ^ h >> 29);
        }
    };
    std::unordered_map<Place, TextPlace, Hash> known_;
};

}  // namespace polyturn::channels::fanuc
