// Whether a text that people read was left in English: the tables of translations fall back to it
// where a row is missing.
#pragma once
#include <algorithm>
#include <string_view>

#include "ipc/diagnosis/display_language.hpp"

namespace polyturn {

// A run of four small letters is a word of a language: what has none (N0106 #4, PLC, {d}) reads
// alike everywhere.
inline bool has_a_word(std::string_view text) {
    std::size_t run = 0;
    for (const char c : text)
        if ((run = c >= 'a' && c <= 'z' ? run + 1 : 0) == 4) return true;
    return false;
}

inline bool left_english(std::string_view english, std::string_view told,
                         DisplayLanguage display_language) {
    if (display_language == DisplayLanguage::English || !has_a_word(english)) return false;
    if (told.empty() || told == english) return true;
    const auto above_ascii = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };
    if (display_language == DisplayLanguage::Russian &&
        std::none_of(told.begin(), told.end(), above_ascii))
        return true;
    for (const std::string_view word : {" the ", " of ", " and ", " with ", " which "})
        if (told.find(word) != std::string_view::npos) return true;
    return false;
}

}  // namespace polyturn
