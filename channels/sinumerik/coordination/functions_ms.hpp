// M, H and S words: what PLC and spindles are told before and behind the motion of a block.
#pragma once
#include <cstdint>

namespace polyturn::channels::sinumerik {

struct Execution;
struct Word;

void m_to_plc(Execution& x, const Word& word, std::int64_t m);
bool functions_before(Execution& x);
bool functions_after(Execution& x);

}  // namespace polyturn::channels::sinumerik
