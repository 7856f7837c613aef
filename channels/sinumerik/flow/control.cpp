// Control structures: IF ELSE ENDIF, WHILE, FOR, LOOP, REPEAT UNTIL. They need no memory but the
// text: where a structure's partners stand the index of the program knows, so jumps in and out of
// them leave nothing behind.
#include "channels/sinumerik/flow/control.hpp"

#include <algorithm>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/calls.hpp"
#include "channels/sinumerik/flow/jumps.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/grammar/head.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// FOR variable = first TO last: counted up by 1, the loop runs while variable <= last.
bool for_head(Execution& x, Reference& variable, double& last, bool first_time) {
    const char* const from = x.line.cursor.at();
    if (!reference_ahead(x, variable)) return false;
    if (!variable || !variable.cell().is_number())
        return fail_at(x, Alarm::ForVariableIllegal, from, 1, upper(x.line.cursor.name_ahead()));
    if (!x.line.cursor.at_assign()) return syntax(x, x.line.cursor.at(), "=");
    x.line.cursor.advance(1);
    Value first;
    if (!expression(x, first)) return false;
    if (upper(x.line.cursor.name_ahead()) != "TO") return syntax(x, x.line.cursor.at(), "TO");
    x.line.cursor.advance(2);
    const char* const at = x.line.cursor.at();
    Value value;
    if (!expression(x, value) || !number_of(x, value, at, last) || !rest_must_be_empty(x))
        return false;
    return !first_time || assign(x, variable, std::move(first), from);
}

}  // namespace

// The structure of this line, or the alarm why there is none.
const Structure* structure_needed(Execution& x) {
    const TextIndex& index = index_of(x, x.calls.levels.back().file);
    if (const auto& lonely = index.lonely()) {
        x.blame.line = lonely->position.line;
        x.blame.column = 0;
        fail(x, Alarm::StructureNesting, lonely->keyword);
        return nullptr;
    }
    const Structure* structure = index.at(x.line.here.offset);
    if (!structure) fail(x, Alarm::StructureNesting, std::string(x.line.statement->name));
    return structure;
}

bool condition(Execution& x, bool& holds) {
    const char* const from = x.line.cursor.at();
    Value value;
    if (!expression(x, value)) return false;
    if (value.type == Type::Axis || value.type == Type::Frame || value.type == Type::String)
        return fail_at(x, Alarm::OperandTypeIllegal, from, 1, std::string(type_name(value.type)));
    holds = value.is_true();
    return true;
}

bool st_if(Execution& x) {
    bool holds = false;
    if (!condition(x, holds)) return false;
    if (!x.line.cursor.at_end()) {  // IF condition GOTOF label
        const std::string_view name = x.line.cursor.name_ahead();
        const Symbol symbol = find_symbol(upper(name));
        if (symbol.kind != Symbol::Kind::Statement || symbol.statement().act != st_goto)
            return syntax(x, x.line.cursor.at(), std::string(name));
        x.line.cursor.advance(name.size());
        if (!holds) {  // its target is read nevertheless; another IF may stand behind it
            std::string label;
            if (symbol.statement().name != "GOTOS" &&
                (x.line.cursor.at_end()
                     ? !syntax(x, x.line.cursor.at(), std::string(symbol.statement().name))
                     : !jump_target(x, label)))
                return false;
            if (upper(x.line.cursor.name_ahead()) != "IF") return rest_must_be_empty(x);
            x.line.cursor.advance(2);
            return st_if(x);
        }
        x.line.statement = &symbol.statement();
        return st_goto(x);
    }
    const Structure* structure = structure_needed(x);
    if (!structure) return false;
    if (!holds) seek(x, structure->has_middle ? structure->behind_middle : structure->behind_tail);
    return true;
}

bool st_else(Execution& x) {  // reached from above: the IF held
    const Structure* structure = structure_needed(x);
    if (!structure || !rest_must_be_empty(x)) return false;
    seek(x, structure->behind_tail);
    return true;
}

bool st_end_marker(Execution& x) { return structure_needed(x) && rest_must_be_empty(x); }

bool st_while(Execution& x) {
    const Structure* structure = structure_needed(x);
    bool holds = false;
    if (!structure || !condition(x, holds) || !rest_must_be_empty(x)) return false;
    if (!holds) seek(x, structure->behind_tail);
    return true;
}

bool st_end_while(Execution& x) {  // ENDWHILE, ENDLOOP
    const Structure* structure = structure_needed(x);
    if (!structure || !rest_must_be_empty(x)) return false;
    seek(x, structure->kind == Structure::Kind::While ? structure->head : structure->behind_head);
    return true;
}

// EXECSTRING(text): the text is read next, as if it replaced this block.
bool st_execstring(Execution& x) {
    const char* const from = x.line.cursor.at();
    Value text;
    if (!x.line.cursor.eat('(')) return syntax(x, x.line.cursor.at(), "(");
    if (!expression(x, text)) return false;
    if (text.type != Type::String && text.type != Type::Char)
        return fail_at(x, Alarm::ArgumentTypeIllegal, from, 1,
                       "EXECSTRING: " + std::string(type_name(text.type)), 1);
    if (!x.line.cursor.eat(')')) return syntax(x, x.line.cursor.at(), ")");
    x.line.execute = to_text(text);
    return rest_must_be_empty(x);
}

bool st_loop(Execution& x) { return structure_needed(x) && rest_must_be_empty(x); }
bool st_end_loop(Execution& x) { return st_end_while(x); }

bool st_until(Execution& x) {
    const Structure* structure = structure_needed(x);
    bool holds = false;
    if (!structure || !condition(x, holds) || !rest_must_be_empty(x)) return false;
    if (!holds) seek(x, structure->behind_head);
    return true;
}

bool st_for(Execution& x) {
    const Structure* structure = structure_needed(x);
    Reference variable;
    double last = 0;
    if (!structure || !for_head(x, variable, last, true)) return false;
    if (variable.cell().number > last) seek(x, structure->behind_tail);
    return true;
}

bool st_end_for(Execution& x) {
    const Structure* structure = structure_needed(x);
    if (!structure || !rest_must_be_empty(x)) return false;
    const TextPosition back = x.calls.source->next_position();
    x.calls.source->seek(structure->head);
    std::string_view head;
    if (x.calls.source->next(head) != LineSource::Status::Line)
        return fail(x, Alarm::FileUnreadable);
    const std::string own = x.line.text;
    x.line.text = head;
    x.calls.source->seek(back);
    x.line.cursor = Cursor(x.line.text);
    bool skipped = false;
    Reference variable;
    double last = 0;
    const std::int64_t number = x.core.at.block;
    bool ok = parse_head(x, skipped);
    x.core.at.block = number;
    if (ok) {
        x.line.cursor.advance(x.line.cursor.name_ahead().size());  // FOR
        ok = for_head(x, variable, last, false);
    }
    if (ok)
        ok = assign(x, variable, Value{variable.variable->type, variable.cell().number + 1, {}, {}},
                    x.line.cursor.at());
    x.line.text = own;
    if (!ok) return false;
    if (variable.cell().number <= last) seek(x, structure->behind_head);
    return true;
}

// M17 has no place here: RET, without a function to the PLC.
bool st_return(Execution& x) {
    std::string target;
    bool has_target = false, behind_target = false, to_main_begin = false;
    std::int64_t levels = 1;
    if (x.line.cursor.eat('(') && !x.line.cursor.eat(')')) {
        for (unsigned i = 0;; ++i) {
            const char next = x.line.cursor.peek();
            if (next != ',' && next != ')') {
                const char* const at = x.line.cursor.at();
                Value value;
                if (!expression(x, value)) return false;
                if (i == 0) {
                    has_target = true;
                    if (value.type == Type::String)
                        target = upper(value.text);
                    else if (value.is_number())
                        target = "N" + to_text(Value::of_int(value.number));
                    else
                        return fail_at(x, Alarm::ArgumentTypeIllegal, at, 1,
                                       std::string(x.line.statement->name), 1);
                    if (target.empty()) has_target = false;
                } else if (!value.is_number() || i > 3) {
                    return fail_at(x,
                                   i > 3 ? Alarm::ArgumentCountIllegal : Alarm::ArgumentTypeIllegal,
                                   at, 1, std::string(x.line.statement->name), i + 1);
                } else if (i == 1) {
                    behind_target = value.number > 0;
                } else if (i == 2) {
                    // so many are passed over (7.15)
                    levels = 1 + std::clamp<std::int64_t>(static_cast<std::int64_t>(value.number),
                                                          0, 16);
                } else {
                    to_main_begin = value.is_true();
                }
            }
            if (x.line.cursor.eat(')')) break;
            if (!x.line.cursor.eat(',')) return syntax(x, x.line.cursor.at(), ")");
        }
    }
    if (!rest_must_be_empty(x)) return false;
    std::size_t programs = 0;
    for (const Level& level : x.calls.levels) programs += !level.section;
    if (programs == 1) {  // a main program ends with it
        x.core.mark_emitted();
        x.core.sink().part(++x.shown.parts, x.core.at);
        finish(x, StopReason::M30);
        return true;
    }
    if (to_main_begin) levels = static_cast<std::int64_t>(programs) - 1;
    // runs still to come are given up
    const bool leaves = has_target || to_main_begin || levels > 1;
    for (; levels > 0 && programs > 1; --levels, --programs) {
        while (x.calls.levels.back().section) x.calls.levels.pop_back();
        if (leaves) x.calls.levels.back().repeats = 0;
        if (!return_from_level(x)) return false;
    }
    if (to_main_begin) {
        seek(x, {0, 1});
        return true;
    }
    if (!has_target) return true;
    // From the block behind the call: RET towards the end first, RETB towards the beginning.
    const bool backwards = x.line.statement->name == "RETB";
    std::string_view text;
    auto found = find_label(x, target, backwards ? -1 : 1);
    if (!found) found = find_label(x, target, backwards ? 1 : -1);
    if (!found) return fail(x, Alarm::JumpTargetMissing, target);
    leave_sections(x, found->offset);
    seek(x, *found);
    if (behind_target) (void)x.calls.source->next(text);
    return true;
}

}  // namespace polyturn::channels::sinumerik
