// What an operator may type into any number field: 50/2, 2*(3+1.5), -0,02; and +0.05, which is
// added to the present value.
#pragma once
#include <optional>
#include <string_view>

namespace polyturn::hmi {

struct Entry {
    bool added = false;  // began with «+»: is added to the present value
    double value = 0.0;
    double over(double present) const { return added ? present + value : value; }
};

// Nothing: it is no number (unfinished, unknown characters, a division by zero).
std::optional<Entry> calculate(std::string_view text);

}  // namespace polyturn::hmi
