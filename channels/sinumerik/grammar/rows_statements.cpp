// Words that begin a statement.
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr Statement kStatementRows[] = {
    {"IF", &Interpreter::st_if},
    {"ELSE", &Interpreter::st_else},
    {"ENDIF", &Interpreter::st_end_marker},
    {"WHILE", &Interpreter::st_while},
    {"ENDWHILE", &Interpreter::st_end_while},
    {"FOR", &Interpreter::st_for},
    {"ENDFOR", &Interpreter::st_end_for},
    {"LOOP", &Interpreter::st_loop},
    {"ENDLOOP", &Interpreter::st_end_loop},
    {"REPEAT", &Interpreter::st_repeat},
    {"REPEATB", &Interpreter::st_repeat},
    {"UNTIL", &Interpreter::st_until},
    {"CASE", &Interpreter::st_case},
    {"GOTO", &Interpreter::st_goto},
    {"GOTOF", &Interpreter::st_goto},
    {"GOTOB", &Interpreter::st_goto},
    {"GOTOC", &Interpreter::st_goto},
    {"GOTOS", &Interpreter::st_goto},
    {"RET", &Interpreter::st_return},
    {"RETB", &Interpreter::st_return},
    {"DEF", &Interpreter::st_def},
    {"REDEF", &Interpreter::st_redef},
    {"DEFINE", &Interpreter::st_define},
    {"PROC", &Interpreter::st_proc},
    {"ENDPROC", &Interpreter::st_return},
    {"EXTERN", &Interpreter::st_extern},
    {"CALL", &Interpreter::st_call},
    {"PCALL", &Interpreter::st_pcall},
    {"EXTCALL", &Interpreter::st_extcall},
    {"MCALL", &Interpreter::st_mcall},
    {"EXECSTRING", &Interpreter::st_execstring},
    {"ISOCALL", nullptr},
    {"SETINT", &Interpreter::st_setint},
    {"DO", &Interpreter::st_synchronized},
    {"WHEN", &Interpreter::st_synchronized},
    {"WHENEVER", &Interpreter::st_synchronized},
    {"EVERY", &Interpreter::st_synchronized},
    {"FROM", &Interpreter::st_synchronized},
    {"ID", &Interpreter::st_synchronized},
    {"IDS", &Interpreter::st_synchronized},
};

}  // namespace

std::span<const Statement> statements() { return kStatementRows; }

}  // namespace polyturn::channels::sinumerik
