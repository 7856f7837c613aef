// Programs that programs write: OPEN, WRITE (fagor_8037t part 2, 12.4).
#pragma once
#include "channels/fagor/statements/statement_text.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// The name of the folder in which a program lies: all of them are one place here.
bool folder(const char*& at, const char* end);

Flow open_statement(Execution& x, std::string_view, const char*& at, const char* end);
Flow write_statement(Execution& x, std::string_view, const char*& at, const char* end);
// The program that was open is complete: it goes into the program memory, where there is one.
bool keep_written(Execution& x);

}  // namespace polyturn::channels::fagor
