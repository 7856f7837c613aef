// Words that begin a statement.
#include "channels/sinumerik/actions/synchronized.hpp"
#include "channels/sinumerik/flow/call_statements.hpp"
#include "channels/sinumerik/flow/control.hpp"
#include "channels/sinumerik/flow/interrupts.hpp"
#include "channels/sinumerik/flow/jumps.hpp"
#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/variables/declarations.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr Statement kStatementRows[] = {
    {"IF", st_if},
    {"ELSE", st_else},
    {"ENDIF", st_end_marker},
    {"WHILE", st_while},
    {"ENDWHILE", st_end_while},
    {"FOR", st_for},
    {"ENDFOR", st_end_for},
    {"LOOP", st_loop},
    {"ENDLOOP", st_end_loop},
    {"REPEAT", st_repeat},
    {"REPEATB", st_repeat},
    {"UNTIL", st_until},
    {"CASE", st_case},
    {"GOTO", st_goto},
    {"GOTOF", st_goto},
    {"GOTOB", st_goto},
    {"GOTOC", st_goto},
    {"GOTOS", st_goto},
    {"RET", st_return},
    {"RETB", st_return},
    {"DEF", st_def},
    {"REDEF", st_redef},
    {"DEFINE", st_define},
    {"PROC", st_proc},
    {"ENDPROC", st_return},
    {"EXTERN", st_extern},
    {"CALL", st_call},
    {"PCALL", st_pcall},
    {"EXTCALL", st_extcall},
    {"MCALL", st_mcall},
    {"EXECSTRING", st_execstring},
    {"ISOCALL", nullptr},
    {"SETINT", st_setint},
    {"DO", st_synchronized},
    {"WHEN", st_synchronized},
    {"WHENEVER", st_synchronized},
    {"EVERY", st_synchronized},
    {"FROM", st_synchronized},
    {"ID", st_synchronized},
    {"IDS", st_synchronized},
};

}  // namespace

std::span<const Statement> statements() { return kStatementRows; }

}  // namespace polyturn::channels::sinumerik
