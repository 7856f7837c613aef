// Statements that go elsewhere: GOTO, RPT, CALL, PCALL, MCALL, SUB, EXEC, MEXEC, REPOS (fagor_8037t
// part 2, 12.4 to 12.7).
#pragma once
#include <string_view>

#include "channels/fagor/statements/statement_text.hpp"

namespace polyturn::channels::fagor {

struct Execution;

Flow goto_statement(Execution& x, const char*& at, const char* end);
Flow rpt_statement(Execution& x, const char*& at, const char* end);
Flow call_statement(Execution& x, const char*& at, const char* end, std::string_view how);
// SUB: a definition that the program comes to is passed over.
Flow skip_definition(Execution& x, const char*& at, const char* end);
Flow exec_statement(Execution& x, const char*& at, const char* end, bool modal);
Flow repos_statement(Execution& x, const char*& at, const char* end);

}  // namespace polyturn::channels::fagor
