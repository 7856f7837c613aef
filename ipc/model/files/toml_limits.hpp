// What a TOML text must keep before the library sees it. The library makes one table in another for
// each part of a dotted key, and it walks and frees them by recursion: a key of 50 000 parts takes
// the stack of whoever reads it.
//
// The text is walked once, as far as is needed to know strings and comments from the rest; nothing
// is kept. Between two of = , [ ] { } and the end of the line stand a key or a value: dots there
// are parts of a key, or the one of a number.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace polyturn::text {

// bytes; a setup with all variables of a channel in one line has 40 000
inline constexpr std::size_t kLongestTomlLine = 256 << 10;
// a.b.c has 3; the deepest of ours has 5
inline constexpr unsigned kMostKeyParts = 16;
// brackets within brackets; ours have 3
inline constexpr unsigned kDeepestToml = 32;

struct TomlExcess {
    std::uint32_t line = 0, column = 0;  // from 1, in bytes
    std::string what;
};

// The first place that is beyond a limit; nothing when the library may read it. A text that is no
// TOML at all may pass: the library says what is wrong with it.
std::optional<TomlExcess> beyond_toml_limits(std::string_view content);

}  // namespace polyturn::text
