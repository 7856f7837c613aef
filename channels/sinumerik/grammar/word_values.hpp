// Index and value of one word.
#pragma once
namespace polyturn::channels::sinumerik {

struct Address;
struct Execution;
struct Word;

bool read_index(Execution& x, Word& word, const Address& address);
bool read_value(Execution& x, Word& word);

}  // namespace polyturn::channels::sinumerik
