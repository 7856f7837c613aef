// What becomes of a word of the language: the row's handler says it, so that the tables are the
// only place where it is declared. The reference page prints it and one test walks all words of the
// specification by it.
#pragma once
#include <cstdint>

#include "channels/sinumerik/grammar/tables.hpp"

namespace polyturn::channels::sinumerik {

enum class Fate : std::uint8_t {
    Acts,       // it changes path, feed, a limit, a value or what the PLC hears
    AsMachine,  // it asks for what this machine does anyway, or takes only the value that does
    Warns,      // it is kept and changes nothing, and the program is warned of it once (PT1576)
    Refused,    // it stops the program with its name (PT1032)
};

Fate fate_of(const GCode& row);
Fate fate_of(const Address& row);
Fate fate_of(const Command& row);
Fate fate_of(const Statement& row);

}  // namespace polyturn::channels::sinumerik
