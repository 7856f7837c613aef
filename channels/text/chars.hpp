// What a character of a program is, and how to get past blanks. Each reader turns small letters
// into capitals, or not, as its language has it.
#pragma once

namespace polyturn::channels {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
constexpr bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
constexpr char capital(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr void blanks(const char*& at, const char* end) {
    while (at != end && (*at == ' ' || *at == '\t')) ++at;
}

// Past comments in round brackets and the blanks around them; one that does not end stays.
constexpr void skip_comments(const char*& at, const char* end) {
    while (at != end && *at == '(') {
        const char* p = at;
        while (p != end && *p != ')') ++p;
        if (p == end) return;
        at = p + 1;
        blanks(at, end);
    }
}

}  // namespace polyturn::channels
