// As much of UTF-8 as parameter lines need: characters to count columns, and what may be stored as
// a name.
#pragma once

#include <cstddef>
#include <string_view>

namespace polyturn::params::utf8 {

// Control characters of ASCII; a name or message must not hold them.
constexpr bool is_control(char c) noexcept {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

// Bytes of the well-formed character that begins at `at`, 0 when none does (overlong forms and
// surrogates included).
constexpr std::size_t length_at(std::string_view text, std::size_t at) noexcept {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || at + length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    if (first == 0xe0 && byte(1) < 0xa0) return 0;  // overlong
    if (first == 0xed && byte(1) > 0x9f) return 0;  // surrogate
    if (first == 0xf0 && byte(1) < 0x90) return 0;  // overlong
    if (first == 0xf4 && byte(1) > 0x8f) return 0;  // above U+10FFFF
    return length;
}

// Characters of a text; a byte that begins none counts as one.
constexpr std::size_t characters(std::string_view text) noexcept {
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); ++count) {
        const std::size_t length = length_at(text, at);
        at += length == 0 ? 1 : length;
    }
    return count;
}

constexpr bool is_printable(std::string_view text) noexcept {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = length_at(text, at);
        if (length == 0 || is_control(text[at])) return false;
        at += length;
    }
    return true;
}

}  // namespace polyturn::params::utf8
