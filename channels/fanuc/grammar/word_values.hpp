// What the number of a word means: lengths, angles, times, whole numbers.
#pragma once
#include <cstdint>
#include <string_view>

#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

// The text of a word as it is written.
std::string_view text_of(const Execution& x, const Word& word);

struct AxisOf {
    int place;
    bool incremental;
};

double length_of(const Execution& x, const Word& word, int place);
double radius_length_of(const Execution& x, char letter);
double fine_length_of(const Execution& x, char letter);
AxisOf axis_of(const Execution& x, const Word& word);
bool whole_number(Execution& x, char letter, std::int64_t& value);
double seconds_of(const Execution& x, const Word& word);

}  // namespace polyturn::channels::fanuc
