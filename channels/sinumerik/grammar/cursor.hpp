// A place in the text of a block. Blank, tab, & and everything not printable only separate
// (sinumerik_part1 4.1); a ; outside a text ends the block.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "channels/text/chars.hpp"

namespace polyturn::channels::sinumerik {

constexpr bool is_name_start(char c) { return is_letter(c) || c == '_'; }
constexpr bool is_name(char c) { return is_name_start(c) || is_digit(c); }
constexpr bool is_blank(char c) { return c == '&' || (static_cast<unsigned char>(c) <= ' '); }
constexpr char upper(char c) { return capital(c); }
inline std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = upper(c);
    return out;
}

class Cursor {
public:
    Cursor() = default;
    explicit Cursor(std::string_view line)
        : begin_(line.data()), at_(line.data()), end_(line.data() + line.size()) {
        cut_comment();
    }

    void skip() {
        while (at_ != end_ && is_blank(*at_)) ++at_;
    }
    bool at_end() {
        skip();
        return at_ == end_;
    }
    // The next sign that is no blank; 0 at the end.
    char peek() {
        skip();
        return at_ == end_ ? '\0' : *at_;
    }
    char next_raw(std::size_t ahead = 0) const { return at_ + ahead < end_ ? at_[ahead] : '\0'; }
    bool eat(char c) {
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    // = but not ==
    bool at_assign() {
        skip();
        return at_ != end_ && *at_ == '=' && !(at_ + 1 != end_ && at_[1] == '=');
    }
    std::string_view name_ahead() {
        skip();
        if (at_ == end_ || !is_name_start(*at_)) return {};
        const char* p = at_;
        while (p != end_ && is_name(*p)) ++p;
        return {at_, static_cast<std::size_t>(p - at_)};
    }
    void advance(std::size_t count) { at_ += count; }
    const char*& at() { return at_; }
    const char* begin() const { return begin_; }
    const char* end() const { return end_; }
    std::size_t column(const char* p) const { return static_cast<std::size_t>(p - begin_) + 1; }

private:
    void cut_comment() {
        bool text = false;
        for (const char* p = begin_; p != end_; ++p) {
            if (*p == '"')
                text = !text;
            else if (*p == ';' && !text) {
                end_ = p;
                return;
            }
        }
    }
    const char* begin_ = nullptr;
    const char* at_ = nullptr;
    const char* end_ = nullptr;
};

}  // namespace polyturn::channels::sinumerik
