// Statements that go elsewhere: GOTO, RPT, CALL, PCALL, MCALL, MDOFF, SUB, RET, EXEC, MEXEC, REPOS
// (fagor_8037t part 2, 12.4 to 12.7).
#pragma once
#include <string_view>

#include "channels/fagor/statements/statement_text.hpp"

namespace polyturn::channels::fagor {

struct Execution;

Flow goto_statement(Execution& x, std::string_view, const char*& at, const char* end);
Flow rpt_statement(Execution& x, std::string_view, const char*& at, const char* end);
Flow call_statement(Execution& x, std::string_view word, const char*& at, const char* end);
// SUB: a definition that the program comes to is passed over.
Flow skip_definition(Execution& x, std::string_view, const char*& at, const char* end);
Flow exec_statement(Execution& x, std::string_view word, const char*& at, const char* end);
Flow ret_statement(Execution& x, std::string_view word, const char*& at, const char* end);
Flow mdoff_statement(Execution& x, std::string_view, const char*&, const char*);
Flow repos_statement(Execution& x, std::string_view, const char*& at, const char* end);

}  // namespace polyturn::channels::fagor
