// The arguments of functions, procedures and programs.
#include "channels/sinumerik/grammar/arguments.hpp"

#include <algorithm>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/variables/system_names.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {

// The text between the brackets of a call. Which of the arguments are variables by reference the
// PROC line says.
bool read_program_arguments(Execution& x, const std::string&, std::vector<Argument>& arguments) {
    if (!x.line.cursor.eat('(')) return true;
    if (x.line.cursor.eat(')')) return true;
    for (;;) {
        Argument argument;
        const char next = x.line.cursor.peek();
        argument.column = x.line.cursor.column(x.line.cursor.at());
        if (next != ',' && next != ')') {
            const char* const from = x.line.cursor.at();
            if (!reference_ahead(x, argument.reference)) return false;
            const char behind = x.line.cursor.peek();
            if (argument.reference && argument.reference.component.empty() &&
                (behind == ',' || behind == ')')) {
                if (!argument.reference.whole || argument.reference.variable->dimensions.empty())
                    argument.value = argument.reference.cell();
            } else {
                argument.reference = {};
                x.line.cursor.at() = from;
                if (!expression(x, argument.value)) return false;
            }
            argument.given = true;
        }
        arguments.push_back(std::move(argument));
        if (x.line.cursor.eat(')')) return true;
        if (!x.line.cursor.eat(',')) return syntax(x, x.line.cursor.at(), ")");
        if (arguments.size() > 127)
            return fail_at(x, Alarm::ArgumentCountIllegal, x.line.cursor.at(), 1);
    }
}
// ( a, b, ) of a function or procedure; without brackets when it can do without arguments.
bool read_arguments(Execution& x, const Command& command, Call& call) {
    call.arguments.clear();
    const char* const from = x.line.cursor.at();
    if (x.line.cursor.peek() == '(') {
        x.line.cursor.advance(1);
        if (!x.line.cursor.eat(')')) {
            for (;;) {
                Argument argument;
                const char next = x.line.cursor.peek();
                argument.column = x.line.cursor.column(x.line.cursor.at());
                if (next != ',' && next != ')') {
                    const std::size_t i = call.arguments.size();
                    const std::string_view types = command.types;
                    const bool in_turn = !types.empty() && types.back() == '+';
                    const char type = types.empty() ? '*'
                                      : in_turn     ? types[i % (types.size() - 1)]
                                                    : types[std::min(i, types.size() - 1)];
                    const char* const at = x.line.cursor.at();
                    if (type == 'w' && x.line.cursor.peek() == '$' &&
                        upper(x.line.cursor.next_raw(1)) != 'R') {
                        if (!system_name(x, argument.system, argument.indices)) return false;
                    } else if (type == 'v' || type == 'w') {
                        if (!reference_ahead(x, argument.reference)) return false;
                        if (!argument.reference)
                            return fail_at(x, Alarm::ArgumentNoVariable, at, 1,
                                           std::string(command.name), static_cast<double>(i + 1));
                    } else {
                        if (!expression(x, argument.value)) return false;
                        const Type got = argument.value.type;
                        const bool fits =
                            type == '*' || (type == 'r' && argument.value.is_number()) ||
                            (type == 'b' && argument.value.is_number()) ||
                            (type == 's' && (got == Type::String || got == Type::Char)) ||
                            (type == 'a' && (got == Type::Axis || got == Type::Int)) ||
                            (type == 'c' &&
                             (got == Type::Char ||
                              (got == Type::String && argument.value.text.size() == 1))) ||
                            (type == 'f' && got == Type::Frame);
                        if (!fits)
                            return fail_at(
                                x, Alarm::ArgumentTypeIllegal, at, 1,
                                std::string(command.name) + ": " + std::string(type_name(got)),
                                static_cast<double>(i + 1));
                        if (type == 's') convert(argument.value, Type::String);
                    }
                    argument.given = true;
                }
                call.arguments.push_back(std::move(argument));
                if (x.line.cursor.eat(')')) break;
                if (!x.line.cursor.eat(',')) return syntax(x, x.line.cursor.at(), ")");
                if (call.arguments.size() > 32)
                    return fail_at(x, Alarm::ArgumentCountIllegal, from, 1,
                                   std::string(command.name));
            }
        }
    }
    if (call.arguments.size() < command.least || call.arguments.size() > command.most)
        return fail_at(x, Alarm::ArgumentCountIllegal, from, 1, std::string(command.name),
                       static_cast<double>(call.arguments.size()));
    return true;
}
}  // namespace polyturn::channels::sinumerik
