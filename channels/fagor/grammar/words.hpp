// One block of words: what it codes, and whether every word has a taker.
#pragma once
#include <cstdint>

#include "channels/fagor/grammar/reader.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// A whole number that is not negative; false: a fault at this word is noted.
bool whole(Execution& x, const Word& word, std::int64_t& value);
// Sorts the words: G rows by group with the words bound to them, M words, axis words.
bool classify(Execution& x);
// Every word must be used: an unused word is a mistake of the program.
bool check_words(Execution& x);

}  // namespace polyturn::channels::fagor
