// A record of the scope as columns of pixels: of each trace the least and the greatest value within
// a column. They are kept from one look to the next, so that a look costs what is new and not what
// is seen; no spike is lost, however many ticks a column has.
//
//   column c holds the ticks [c * ticks, (c + 1) * ticks); the line from one sample to the next
//   belongs to every column it crosses
#pragma once
#include <cstdint>
#include <vector>

#include "hmi/machine/bodies/scope_record.hpp"

namespace polyturn::hmi {

struct ScopeSpan {
    double least = 1e300, most = -1e300;
    bool any() const { return least <= most; }
    void add(double value) {
        if (value < least) least = value;
        if (value > most) most = value;
    }
};

class ScopeColumns {
public:
    // What the record has more than at the last look; all of it when the record, the width or the
    // number of columns is another one.
    void take(const ScopeRecord& record, double ticks, std::size_t count);
    std::int64_t newest() const { return newest_; }  // -1: there is none
    // Of the `count` columns up to the newest one; nothing in what is older or still to come.
    ScopeSpan at(std::size_t trace, std::int64_t column) const {
        return column > newest_ - static_cast<std::int64_t>(count_) && column <= newest_ &&
                       column >= 0
                   ? spans_[place(trace, column)]
                   : ScopeSpan{};
    }
    ScopeSpan whole(std::size_t trace) const;  // of all of them

private:
    std::size_t place(std::size_t trace, std::int64_t column) const {
        return trace * count_ + static_cast<std::size_t>(column) % count_;
    }
    void open(std::int64_t column);  // and those before it
    void line(const ScopeSample& from, const ScopeSample& to);

    std::vector<ScopeSpan> spans_;
    std::size_t count_ = 0;
    double ticks_ = 0;
    std::uint64_t began_ = 0;                // of the record
    std::int64_t newest_ = -1, taken_ = -1;  // column; tick of the last sample
};

// Values of the eight divisions of the graph: the steps are 1, 2 or 5, so that one can read them,
// and stay as long as the trace fits well.
struct ScopeScale {
    static constexpr int kDivisions = 8;
    double bottom = 0, division = 0;  // division 0: none yet
    double top() const { return bottom + kDivisions * division; }
    // 0 at the bottom, 1 at the top
    double part(double value) const { return (value - bottom) / (kDivisions * division); }
};
// What hardly changes lies as a straight line in the division of its own trace, so that two of them
// do not cover each other.
ScopeScale scopeScale(const ScopeSpan& span, const ScopeScale& before, std::size_t trace);

}  // namespace polyturn::hmi
