// Words that change nothing here: accepted as they are, or with a warning once a program.
#pragma once
#include <cstddef>
#include <string>

namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;
struct GCode;
struct Word;

bool p_as_machine(Execution&, Call&);
bool a_without_effect(Execution& x, const Word& word);
// warns, once a program
bool without_effect(Execution& x, std::string name, std::size_t column, std::size_t length);
bool g_mode(Execution&, const GCode&);
bool g_as_machine(Execution&, const GCode&);
bool g_without_effect(Execution& x, const GCode& code);
bool g_as_continuous(Execution& x, const GCode& code);
bool geo_not_built(Execution& x, const GCode& code);
bool a_elsewhere(Execution&, const Word&);
bool a_as_machine(Execution&, const Word&);
bool a_rounding(Execution& x, const Word& word);
bool a_no_holder(Execution& x, const Word& word);
bool p_profile_without_effect(Execution& x, Call& c);
bool p_without_effect(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
