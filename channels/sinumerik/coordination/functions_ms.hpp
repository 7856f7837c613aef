// M, H and S words: what PLC and spindles are told before and behind the motion of a block.
#pragma once
#include <cstdint>

namespace polyturn::channels::sinumerik {

struct Execution;
struct Word;

// M3 M4 M5: the spindle turns or stops by it
inline bool is_spindle_function(std::int64_t m) { return m == 3 || m == 4 || m == 5; }

void m_to_plc(Execution& x, const Word& word, std::int64_t m);
bool functions_before(Execution& x);
bool functions_after(Execution& x);

}  // namespace polyturn::channels::sinumerik
