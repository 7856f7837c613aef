// Every word of a block must be used: one that nobody takes is a mistake of the program.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;

bool length_word(const Execution& x);
bool check_words(Execution& x);

}  // namespace polyturn::channels::fanuc
