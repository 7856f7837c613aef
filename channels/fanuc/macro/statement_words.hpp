// Words and gaps of macro statements.
#pragma once
#include <string_view>

#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {

// Past blanks and comments, which may stand in a statement wherever blanks may (fanuc_lathe 6.4).
inline void gap(const char*& at, const char* end) {
    blanks(at, end);
    if (at != end && *at == '(') skip_comments(at, end);
}

// Takes the word at `at` if it is `name`, or two and more of its first letters where no further
// letter stands (WH for WHILE).
inline bool take(const char*& at, const char* end, std::string_view name) {
    gap(at, end);
    const char* p = at;
    std::size_t letters = 0;
    while (letters < name.size() && p != end && capital(*p) == name[letters]) {
        ++p;
        ++letters;
    }
    if (letters < name.size() && (letters < 2 || (p != end && is_letter(*p)))) return false;
    at = p;
    return true;
}

}  // namespace polyturn::channels::fanuc
