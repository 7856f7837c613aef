// Control structures: IF ELSE ENDIF, WHILE, FOR, LOOP, REPEAT UNTIL. They need no memory but the
// text: where a structure's partners stand the index of the program knows, so jumps in and out of
// them leave nothing behind.
#include <algorithm>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

// The structure of this line, or the alarm why there is none.
const Structure* Interpreter::structure_needed() {
    const TextIndex& index = index_of(levels_.back().file);
    if (const auto& lonely = index.lonely()) {
        fault_line_ = lonely->position.line;
        fault_column_ = 0;
        fail(Alarm::StructureNesting, lonely->keyword);
        return nullptr;
    }
    const Structure* structure = index.at(here_.offset);
    if (!structure) fail(Alarm::StructureNesting, std::string(statement_->name));
    return structure;
}

bool Interpreter::condition(bool& holds) {
    const char* const from = cursor_.at();
    Value value;
    if (!expression(value)) return false;
    if (value.type == Type::Axis || value.type == Type::Frame || value.type == Type::String)
        return fail_at(Alarm::OperandTypeIllegal, from, 1, std::string(type_name(value.type)));
    holds = value.is_true();
    return true;
}

bool Interpreter::st_if() {
    bool holds = false;
    if (!condition(holds)) return false;
    if (!cursor_.at_end()) {  // IF condition GOTOF label
        const std::string_view name = cursor_.name_ahead();
        const Symbol symbol = find_symbol(upper(name));
        if (symbol.kind != Symbol::Kind::Statement ||
            symbol.statement().act != &Interpreter::st_goto)
            return syntax(cursor_.at(), std::string(name));
        cursor_.advance(name.size());
        if (!holds) {  // its target is read nevertheless; another IF may stand behind it
            std::string label;
            if (symbol.statement().name != "GOTOS" &&
                (cursor_.at_end() ? !syntax(cursor_.at(), std::string(symbol.statement().name))
                                  : !jump_target(label)))
                return false;
            if (upper(cursor_.name_ahead()) != "IF") return rest_must_be_empty();
            cursor_.advance(2);
            return st_if();
        }
        statement_ = &symbol.statement();
        return st_goto();
    }
    const Structure* structure = structure_needed();
    if (!structure) return false;
    if (!holds) seek(structure->has_middle ? structure->behind_middle : structure->behind_tail);
    return true;
}

bool Interpreter::st_else() {  // reached from above: the IF held
    const Structure* structure = structure_needed();
    if (!structure || !rest_must_be_empty()) return false;
    seek(structure->behind_tail);
    return true;
}

bool Interpreter::st_end_marker() { return structure_needed() && rest_must_be_empty(); }

bool Interpreter::st_while() {
    const Structure* structure = structure_needed();
    bool holds = false;
    if (!structure || !condition(holds) || !rest_must_be_empty()) return false;
    if (!holds) seek(structure->behind_tail);
    return true;
}

bool Interpreter::st_end_while() {  // ENDWHILE, ENDLOOP
    const Structure* structure = structure_needed();
    if (!structure || !rest_must_be_empty()) return false;
    seek(structure->kind == Structure::Kind::While ? structure->head : structure->behind_head);
    return true;
}

// EXECSTRING(text): the text is read next, as if it replaced this block.
bool Interpreter::st_execstring() {
    const char* const from = cursor_.at();
    Value text;
    if (!cursor_.eat('(')) return syntax(cursor_.at(), "(");
    if (!expression(text)) return false;
    if (text.type != Type::String && text.type != Type::Char)
        return fail_at(Alarm::ArgumentTypeIllegal, from, 1,
                       "EXECSTRING: " + std::string(type_name(text.type)), 1);
    if (!cursor_.eat(')')) return syntax(cursor_.at(), ")");
    execute_ = to_text(text);
    return rest_must_be_empty();
}

bool Interpreter::st_loop() { return structure_needed() && rest_must_be_empty(); }
bool Interpreter::st_end_loop() { return st_end_while(); }

bool Interpreter::st_until() {
    const Structure* structure = structure_needed();
    bool holds = false;
    if (!structure || !condition(holds) || !rest_must_be_empty()) return false;
    if (!holds) seek(structure->behind_head);
    return true;
}

// FOR variable = first TO last: counted up by 1, the loop runs while variable <= last.
bool Interpreter::for_head(Reference& variable, double& last, bool first_time) {
    const char* const from = cursor_.at();
    if (!reference_ahead(variable)) return false;
    if (!variable || !variable.cell().is_number())
        return fail_at(Alarm::ForVariableIllegal, from, 1, upper(cursor_.name_ahead()));
    if (!cursor_.at_assign()) return syntax(cursor_.at(), "=");
    cursor_.advance(1);
    Value first;
    if (!expression(first)) return false;
    if (upper(cursor_.name_ahead()) != "TO") return syntax(cursor_.at(), "TO");
    cursor_.advance(2);
    const char* const at = cursor_.at();
    Value value;
    if (!expression(value) || !number_of(value, at, last) || !rest_must_be_empty()) return false;
    return !first_time || assign(variable, std::move(first), from);
}

bool Interpreter::st_for() {
    const Structure* structure = structure_needed();
    Reference variable;
    double last = 0;
    if (!structure || !for_head(variable, last, true)) return false;
    if (variable.cell().number > last) seek(structure->behind_tail);
    return true;
}

bool Interpreter::st_end_for() {
    const Structure* structure = structure_needed();
    if (!structure || !rest_must_be_empty()) return false;
    const TextPosition back = source_->next_position();
    source_->seek(structure->head);
    std::string_view head;
    if (source_->next(head) != LineSource::Status::Line) return fail(Alarm::FileUnreadable);
    const std::string own = line_;
    line_ = head;
    source_->seek(back);
    cursor_ = Cursor(line_);
    bool skipped = false;
    Reference variable;
    double last = 0;
    const std::int64_t number = core_.at.block;
    bool ok = parse_head(skipped);
    core_.at.block = number;
    if (ok) {
        cursor_.advance(cursor_.name_ahead().size());  // FOR
        ok = for_head(variable, last, false);
    }
    if (ok)
        ok = assign(variable, Value{variable.variable->type, variable.cell().number + 1, {}, {}},
                    cursor_.at());
    line_ = own;
    if (!ok) return false;
    if (variable.cell().number <= last) seek(structure->behind_head);
    return true;
}

// M17 has no place here: RET, without a function to the PLC.
bool Interpreter::st_return() {
    std::string target;
    bool has_target = false, behind_target = false, to_main_begin = false;
    std::int64_t levels = 1;
    if (cursor_.eat('(') && !cursor_.eat(')')) {
        for (unsigned i = 0;; ++i) {
            const char next = cursor_.peek();
            if (next != ',' && next != ')') {
                const char* const at = cursor_.at();
                Value value;
                if (!expression(value)) return false;
                if (i == 0) {
                    has_target = true;
                    if (value.type == Type::String)
                        target = upper(value.text);
                    else if (value.is_number())
                        target = "N" + to_text(Value::of_int(value.number));
                    else
                        return fail_at(Alarm::ArgumentTypeIllegal, at, 1,
                                       std::string(statement_->name), 1);
                    if (target.empty()) has_target = false;
                } else if (!value.is_number() || i > 3) {
                    return fail_at(i > 3 ? Alarm::ArgumentCountIllegal : Alarm::ArgumentTypeIllegal,
                                   at, 1, std::string(statement_->name), i + 1);
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
            if (cursor_.eat(')')) break;
            if (!cursor_.eat(',')) return syntax(cursor_.at(), ")");
        }
    }
    if (!rest_must_be_empty()) return false;
    std::size_t programs = 0;
    for (const Level& level : levels_) programs += !level.section;
    if (programs == 1) {  // a main program ends with it
        core_.mark_emitted();
        core_.sink().part(++parts_, core_.at);
        finish(StopReason::M30);
        return true;
    }
    if (to_main_begin) levels = static_cast<std::int64_t>(programs) - 1;
    // runs still to come are given up
    const bool leaves = has_target || to_main_begin || levels > 1;
    for (; levels > 0 && programs > 1; --levels, --programs) {
        while (levels_.back().section) levels_.pop_back();
        if (leaves) levels_.back().repeats = 0;
        if (!return_from_level()) return false;
    }
    if (to_main_begin) {
        seek({0, 1});
        return true;
    }
    if (!has_target) return true;
    // From the block behind the call: RET towards the end first, RETB towards the beginning.
    const bool backwards = statement_->name == "RETB";
    std::string_view text;
    auto found = find_label(target, backwards ? -1 : 1);
    if (!found) found = find_label(target, backwards ? 1 : -1);
    if (!found) return fail(Alarm::JumpTargetMissing, target);
    leave_sections(found->offset);
    seek(*found);
    if (behind_target) (void)source_->next(text);
    return true;
}

}  // namespace polyturn::channels::sinumerik
