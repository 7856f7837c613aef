#include "hmi/machine/bodies/scope_columns.hpp"

#include <algorithm>
#include <cmath>

#include "hmi/machine/live/round_step.hpp"

namespace polyturn::hmi {

void ScopeColumns::take(const ScopeRecord& record, double ticks, std::size_t count) {
    if (began_ != record.began() || ticks_ != ticks || count_ != count) {
        began_ = record.began();
        ticks_ = ticks;
        count_ = count;
        newest_ = taken_ = -1;
        spans_.assign(kScopeTraces * count_, ScopeSpan{});
    }
    const auto& samples = record.samples();
    if (samples.empty() || count_ == 0 || ticks_ <= 0) return;
    // Older ones than the columns can hold are not looked at.
    const std::int64_t from = std::max(
        taken_ + 1,
        samples.back().tick - static_cast<std::int64_t>(ticks_ * static_cast<double>(count_ + 1)));
    auto at =
        std::lower_bound(samples.begin(), samples.end(), from,
                         [](const ScopeSample& s, std::int64_t tick) { return s.tick < tick; });
    for (; at != samples.end(); ++at) {
        if (at == samples.begin() || taken_ < 0) {
            open(static_cast<std::int64_t>(std::floor(static_cast<double>(at->tick) / ticks_)));
            for (std::size_t trace = 0; trace < kScopeTraces; ++trace)
                spans_[place(trace, newest_)].add(at->value[trace]);
        } else {
            line(*(at - 1), *at);
        }
        taken_ = at->tick;
    }
}

void ScopeColumns::open(std::int64_t column) {
    const std::int64_t first =
        std::max(newest_ + 1, column - static_cast<std::int64_t>(count_) + 1);
    for (std::int64_t c = first; c <= column; ++c)
        for (std::size_t trace = 0; trace < kScopeTraces; ++trace) spans_[place(trace, c)] = {};
    newest_ = std::max(newest_, column);
}

void ScopeColumns::line(const ScopeSample& from, const ScopeSample& to) {
    const double t0 = static_cast<double>(from.tick), t1 = static_cast<double>(to.tick);
    const auto last = static_cast<std::int64_t>(std::floor(t1 / ticks_));
    const std::int64_t first = std::max(static_cast<std::int64_t>(std::floor(t0 / ticks_)),
                                        last - static_cast<std::int64_t>(count_) + 1);
    open(last);
    for (std::size_t trace = 0; trace < kScopeTraces; ++trace) {
        const double a = from.value[trace], b = to.value[trace];
        if (first < last) {
            const double slope = (b - a) / (t1 - t0);
            for (std::int64_t c = first; c <= last; ++c) {
                const double begins = std::max(t0, static_cast<double>(c) * ticks_),
                             ends = std::min(t1, static_cast<double>(c + 1) * ticks_);
                ScopeSpan& span = spans_[place(trace, c)];
                span.add(a + slope * (begins - t0));
                span.add(a + slope * (ends - t0));
            }
        }
        spans_[place(trace, last)].add(b);
    }
}

ScopeSpan ScopeColumns::whole(std::size_t trace) const {
    ScopeSpan out;
    for (std::size_t i = trace * count_; i < (trace + 1) * count_; ++i)
        if (spans_[i].any()) {
            out.add(spans_[i].least);
            out.add(spans_[i].most);
        }
    return out;
}

ScopeScale scopeScale(const ScopeSpan& span, const ScopeScale& before, std::size_t trace) {
    if (!span.any()) return before;
    constexpr double kUsed = ScopeScale::kDivisions - 1;  // one is for the rounding of the middle
    const double middle = (span.least + span.most) / 2, high = span.most - span.least;
    const double least = std::max(1e-4, std::abs(middle) * 2e-4);
    const double division = roundStep(std::max(high / kUsed, least));
    const bool fits =
        before.division > 0 && span.least >= before.bottom && span.most <= before.top();
    if (fits && before.division <= division * 2.6) return before;
    if (high < division / 4) {
        const double lines =
            std::floor(span.least / division) - (kUsed - static_cast<double>(trace));
        return {
            (lines + (span.most > (lines + ScopeScale::kDivisions) * division ? 1 : 0)) * division,
            division};
    }
    return {std::round(middle / division - ScopeScale::kDivisions / 2.0) * division, division};
}

}  // namespace polyturn::hmi
