// The position of an encoder that reports only the last bits of it (nct_parameters_part1 7.2
// N0524, 10.3).
//
//   raw  0 ........ 2^bits-1 | 0 ........ 2^bits-1 | 0 ...        what the drive delivers
//        round -1            | round 0             | round 1      counted here
//
// While it is on, a jump of more than half counts a round. At power-on the round is not known. With
// N0900 CIR it was saved (N0908); without it the nearest position to N0907 is meant, so that an
// encoder may roll over within the work area.
#pragma once
#include <cstdint>

namespace polyturn::kernel {

class EncoderCount {
public:
    // bits 0 or above 62: the drive reports the whole position, nothing is counted.
    void begin(unsigned bits, bool keeps_rounds, std::int64_t rounds, std::int64_t near) noexcept {
        bits_ = bits > 62 ? 0 : bits;
        keeps_ = keeps_rounds && bits_ != 0;
        rounds_ = kept_ = keeps_ ? rounds : 0;
        near_ = near;
        known_ = false;
    }
    bool limited() const noexcept { return bits_ != 0; }
    bool known() const noexcept { return known_; }
    std::int64_t range() const noexcept { return std::int64_t{1} << bits_; }
    // The drive's report of this exchange.
    std::int64_t take(std::int64_t position) noexcept {
        if (!limited()) {
            known_ = true;
            return full_ = position;
        }
        const std::int64_t raw = position & (range() - 1);
        if (!known_) {
            known_ = true;
            // raw alone, in the round that lies nearest to N0907
            if (!keeps_) rounds_ = (near_ - raw + range() / 2) >> bits_;
        } else if (raw - raw_ > range() / 2) {
            --rounds_;
        } else if (raw_ - raw > range() / 2) {
            ++rounds_;
        }
        raw_ = raw;
        return full_ = rounds_ * range() + raw;
    }
    std::int64_t full() const noexcept { return full_; }
    // N0908 is to be written: read once for each round.
    bool take_store_changes(std::int64_t& rounds) noexcept {
        if (!keeps_ || rounds_ == kept_) return false;
        rounds = kept_ = rounds_;
        return true;
    }
    // the store had no room: again in the next tick
    void not_kept() noexcept { kept_ = rounds_ + 1; }

private:
    unsigned bits_ = 0;
    bool keeps_ = false, known_ = false;
    std::int64_t rounds_ = 0, kept_ = 0, near_ = 0, raw_ = 0, full_ = 0;
};

}  // namespace polyturn::kernel
