// What people read of a parameter, in their language: its name, what it means, what its bits mean
// and why it does not act. Sources: parameters.ru.csv, parameters.cs.csv, parameters.hu.csv
// (number, name, bits, meaning, acts), by number. A row that is not translated is shown in English;
// files, logs and the history name a parameter in English always (Row::title).
#pragma once
#include <array>
#include <span>
#include <string_view>

#include "ipc/diagnosis/display_language.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::params {

struct RowWords {
    std::string_view name, meaning, acts;
    // by the number of the bit; empty where the row names none
    std::array<std::string_view, 8> bits;
};
[[nodiscard]] RowWords words_of(const Row& row, DisplayLanguage display_language);

namespace detail {

struct TranslatedRow {
    std::string_view name, meaning, acts;    // name empty: not translated; acts empty: yes
    std::span<const std::string_view> bits;  // in the order of Row::bits
};

}  // namespace detail
}  // namespace polyturn::params
