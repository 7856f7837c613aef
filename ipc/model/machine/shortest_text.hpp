// A number in the fewest digits that read back exactly.
#pragma once

#include <charconv>
#include <string>

namespace polyturn {

inline std::string shortest_text(double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    return {digits, end.ptr};
}

}  // namespace polyturn
