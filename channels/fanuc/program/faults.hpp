// A fault becomes an alarm with its place: the word that is to blame, or the earlier block.
#pragma once
#include <cstdint>
#include <string>

#include "channels/language.hpp"
#include "channels/state/core.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

// A fault found from here on stands at this word.
void blame(Execution& x, const Word& word);

Step report_at(Execution& x, Alarm alarm, std::uint32_t column, std::uint32_t length,
               std::string detail = {}, double v0 = 0, double v1 = 0);
Step report(Execution& x, Fault fault);

}  // namespace polyturn::channels::fanuc
