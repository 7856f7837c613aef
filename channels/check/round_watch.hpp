// Tells a program that goes round for ever from a long one. Each jump back compares what decides
// how the program goes on (place, calls, variables, offsets, positions, feed, spindle) with what it
// was at a remembered jump:
//
//   same as remembered  -> one round in which nothing has changed. kMostRounds of them: it does not
//   end jumps 1, 2, 4, 8 .. -> the remembered one is replaced (Brent 1980), so that a circle of any
//   length is met, and the memory is one state
//
// So many, because repeats (L9999) and the 65535 blocks of a B-axis program are counted where
// they are not visible outside the language. What changes a variable in each round and still never
// ends is stopped by the number of blocks alone.
#pragma once
#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "channels/state/core.hpp"

namespace polyturn::channels {

class RoundWatch {
public:
    enum class Verdict : std::uint8_t { GoesOn, Round, TooLong };
    // 0: as many as there are
    explicit RoundWatch(std::uint64_t most_blocks) : most_(most_blocks) {}
    void wrote(std::string_view name, double value, std::string_view text = {});
    void wrote_offset(const OffsetWrite& offset);
    // Behind each block.
    [[nodiscard]] Verdict look(const Core& core);

private:
    struct State {
        std::uint64_t values = 0;  // of everything that was written
        std::uint32_t line = 0;
        std::uint16_t file = 0;
        std::uint8_t depth = 0;
        SpindleTurn turn = SpindleTurn::Stop;
        FeedMode feed_mode = FeedMode::PerMinute;
        double feed = 0.0, rpm = 0.0;
        AxisValues machine{}, programmed{};
        bool operator==(const State&) const = default;
    };
    void put(std::uint64_t key, std::uint64_t value);

    static constexpr std::uint64_t kMostRounds = 70'000;
    std::unordered_map<std::uint64_t, std::uint64_t> written_;  // name to value, both as hashes
    std::uint64_t values_ = 0, most_, blocks_ = 0;
    std::uint64_t jumps_ = 0, until_ = 1, rounds_ = 0;
    std::uint32_t line_ = 0;
    std::uint16_t file_ = 0;
    State remembered_;
};

}  // namespace polyturn::channels
