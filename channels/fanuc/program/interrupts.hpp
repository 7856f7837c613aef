// M96, M97: a signal interrupts the program; M99 of the interrupt program goes back.
#pragma once
#include <cstdint>

#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

bool interrupt_code(Execution& x, const Word& word);
bool interrupt_program(Execution& x, std::uint64_t serial, bool within);
bool interrupt_ahead(Execution& x, std::uint64_t serial);
void interrupt_arrived(Execution& x);
bool return_from_interrupt(Execution& x, bool has_target, std::int64_t target);

}  // namespace polyturn::channels::fanuc
