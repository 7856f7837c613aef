// The words of a block: read with their values, before anything acts.
#pragma once
#include <string_view>

#include "channels/sinumerik/execution.hpp"

namespace polyturn::channels::sinumerik {

// what a word that names an axis has as its address
inline const Address kAxisAddress{"axis", Address::Index::Number, Address::Use::Block, nullptr};

// What may stand before a value: X=AC(10), C=DC(90).
struct ModeName {
    std::string_view name;
    Mode mode;
};
inline constexpr ModeName kModes[] = {
    {"AC", Mode::AC},     {"IC", Mode::IC},     {"DC", Mode::DC},   {"ACP", Mode::ACP},
    {"ACN", Mode::ACN},   {"CAC", Mode::CAC},   {"CIC", Mode::CIC}, {"CDC", Mode::CDC},
    {"CACP", Mode::CACP}, {"CACN", Mode::CACN}, {"DAC", Mode::DAC}, {"DIC", Mode::DIC},
    {"RAC", Mode::RAC},   {"RIC", Mode::RIC},   {"QU", Mode::QU},   {"PM", Mode::PM},
    {"PR", Mode::PR},     {"GP", Mode::GP}};

bool names_cycle(std::string_view upper_name);
bool parse_words(Execution& x);
// the last one with this name; nullptr none
const Word* word(const Execution& x, std::string_view name);

inline bool has(const Execution& x, std::string_view name) { return word(x, name) != nullptr; }

}  // namespace polyturn::channels::sinumerik
