#include "channels/check/round_watch.hpp"

#include <bit>
#include <functional>

namespace polyturn::channels {
namespace {

// splitmix64: one bit of difference reaches all of them.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15ull;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
    return x ^ (x >> 31);
}

}  // namespace

void RoundWatch::put(std::uint64_t key, std::uint64_t value) {
    std::uint64_t& cell = written_[key];
    values_ ^= mixed(key ^ cell);  // the sum of all cells, whatever their order
    cell = mixed(value);
    values_ ^= mixed(key ^ cell);
}

void RoundWatch::wrote(std::string_view name, double value, std::string_view text) {
    put(std::hash<std::string_view>{}(name),
        text.empty() ? std::bit_cast<std::uint64_t>(value) : std::hash<std::string_view>{}(text));
}

void RoundWatch::wrote_offset(const OffsetWrite& o) {
    std::uint64_t key =
        std::hash<std::string_view>{}(o.table) ^ mixed(std::hash<std::string_view>{}(o.axis));
    for (const auto part : {static_cast<std::int64_t>(o.number), static_cast<std::int64_t>(o.row),
                            static_cast<std::int64_t>(o.place), static_cast<std::int64_t>(o.work)})
        key = mixed(key ^ static_cast<std::uint64_t>(part));
    put(key, std::bit_cast<std::uint64_t>(o.value));
}

RoundWatch::Verdict RoundWatch::look(const Core& core) {
    if (++blocks_ > most_ && most_ > 0) return Verdict::TooLong;
    const bool onward = core.at.file == file_ && core.at.line > line_;
    file_ = core.at.file;
    line_ = core.at.line;
    if (onward) return Verdict::GoesOn;
    const SpindleState& spindle = core.path.spindle;
    const State now{values_,
                    line_,
                    file_,
                    core.at.stack_depth,
                    spindle.turn,
                    core.path.feed_mode,
                    core.path.feed,
                    spindle.rpm,
                    core.path.machine,
                    core.path.programmed};
    if (++jumps_ >= until_) {
        remembered_ = now;
        until_ *= 2;
        rounds_ = 0;
    } else if (now == remembered_ && ++rounds_ >= kMostRounds) {
        return Verdict::Round;
    }
    return Verdict::GoesOn;
}

}  // namespace polyturn::channels
