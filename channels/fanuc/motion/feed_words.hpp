// F and E: what their numbers count, and the ranges that the series 15 format gives them
// (fanuc_lathe 8.1).
#pragma once
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

// A feed per revolution or a lead, mm or inches as programmed: without a point it counts small
// steps.
inline double fine_feed(const Word& word, bool plain, bool series15, bool inch) {
    const double small = series15 ? 0.01 : 0.0001;
    return plain ? word.value : word.value * (inch ? small * 0.01 : small);
}

struct FeedRange {
    double low, high;  // mm or inches, a minute or a revolution
    bool holds(double value) const {
        constexpr double kSame = 1e-9;
        return value >= low - kSame && value <= high + kSame;
    }
};

enum class FeedKind : unsigned char { PerMinute, PerRevolution, Lead };

inline FeedRange series15_range(FeedKind kind, bool has_point, bool inch, bool fine_axes) {
    if (kind == FeedKind::Lead && has_point)
        return inch ? FeedRange{0.000001, 9.999999} : FeedRange{0.0001, 500.0};
    if (kind != FeedKind::PerMinute)
        return inch ? FeedRange{0.0001, 9.9999} : FeedRange{0.01, 500.0};
    if (fine_axes) return inch ? FeedRange{0.01, 4800.0} : FeedRange{1.0, 100'000.0};  // IS-C
    return inch ? FeedRange{0.01, 9600.0} : FeedRange{1.0, 240'000.0};
}

}  // namespace polyturn::channels::fanuc
