// CALL, PCALL, EXTCALL, MCALL: subprograms that are not called by their bare name.
#include "channels/sinumerik/flow/call_statements.hpp"

#include <algorithm>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/calls.hpp"
#include "channels/sinumerik/flow/jumps.hpp"
#include "channels/sinumerik/grammar/arguments.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/grammar/words.hpp"

namespace polyturn::channels::sinumerik {

// The name in a path: /_N_WKS_DIR/_N_SHAFT_WPD/PART.SPF, _N_PART_SPF
std::string program_of_path(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\:");
    std::string name = upper(slash == std::string_view::npos ? path : path.substr(slash + 1));
    if (name.starts_with("_N_")) name.erase(0, 3);
    if (name.ends_with("_SPF") || name.ends_with("_MPF")) name.erase(name.size() - 4);
    return name;
}
// CALL "name", CALL name BLOCK first TO last, CALL BLOCK first TO last
bool st_call(Execution& x) {
    std::string name;
    if (upper(x.line.cursor.name_ahead()) != "BLOCK") {
        const char* const at = x.line.cursor.at();
        Value value;
        if (!expression(x, value)) return false;
        if (value.type != Type::String)
            return fail_at(x, Alarm::OperandTypeIllegal, at, 1,
                           "CALL: " + std::string(type_name(value.type)));
        name = program_of_path(value.text);
    }
    if (upper(x.line.cursor.name_ahead()) == "BLOCK") {
        x.line.cursor.advance(5);
        std::string first, last;
        if (!jump_target(x, first)) return false;
        if (upper(x.line.cursor.name_ahead()) != "TO") return syntax(x, x.line.cursor.at(), "TO");
        x.line.cursor.advance(2);
        if (!jump_target(x, last) || !rest_must_be_empty(x)) return false;
        if (!name.empty()) return call_section(x, name, first, last);
        auto begin = find_label(x, first, -1);
        if (!begin) begin = find_label(x, first, 1);
        if (!begin) return fail(x, Alarm::JumpTargetMissing, first);
        std::optional<TextPosition> stop;
        if (const auto* places = index_of(x, x.calls.levels.back().file).label(last))
            for (const TextPosition& place : *places)
                if (!stop && place.offset >= begin->offset) stop = place;
        if (!stop) return fail(x, Alarm::JumpTargetMissing, last);
        const TextPosition back = x.calls.source->next_position();
        std::string_view text;
        x.calls.source->seek(*stop);
        const bool read = x.calls.source->next(text) == LineSource::Status::Line;
        const std::uint64_t end = read ? x.calls.source->next_position().offset : stop->offset + 1;
        x.calls.source->seek(back);
        if (begin->offset <= x.line.here.offset && x.line.here.offset < end)
            return fail(x, Alarm::StructureNesting, "CALL BLOCK");
        return run_section(x, *begin, end, 1, false);
    }
    if (!rest_must_be_empty(x)) return false;
    return call_program(x, name, {}, 1, false);
}
// PCALL path/name(arguments)
bool st_pcall(Execution& x) {
    x.line.cursor.skip();
    const char* const from = x.line.cursor.at();
    while (x.line.cursor.at() != x.line.cursor.end() && *x.line.cursor.at() != '(' &&
           !is_blank(*x.line.cursor.at()))
        x.line.cursor.advance(1);
    const std::string name =
        program_of_path({from, static_cast<std::size_t>(x.line.cursor.at() - from)});
    if (name.empty()) return syntax(x, from);
    std::vector<Argument> arguments;
    if (x.line.cursor.peek() == '(' && !read_program_arguments(x, name, arguments)) return false;
    return rest_must_be_empty(x) && call_program(x, name, std::move(arguments), 1, false);
}
// EXTCALL("path"), EXTCALL "path": run from where it lies
bool st_extcall(Execution& x) {
    const char* const at = x.line.cursor.at();
    Value value;
    if (!expression(x, value)) return false;
    if (value.type != Type::String)
        return fail_at(x, Alarm::OperandTypeIllegal, at, 1,
                       "EXTCALL: " + std::string(type_name(value.type)));
    return rest_must_be_empty(x) && call_program(x, program_of_path(value.text), {}, 1, false);
}
// MCALL name(arguments): behind each block that moves; MCALL alone ends it.
bool st_mcall(Execution& x) {
    if (x.line.cursor.at_end()) {
        x.modal.call.reset();
        return true;
    }
    const char* const at = x.line.cursor.at();
    const std::string name = upper(x.line.cursor.name_ahead());
    const Symbol symbol = find_symbol(name);
    if (name.empty() || symbol.kind == Symbol::Kind::Reserved)
        return fail_at(x, Alarm::NotBuilt, at, std::max<std::size_t>(1, name.size()),
                       "MCALL " + name);
    x.line.cursor.advance(name.size());
    ModalCall call{name, {}, nullptr};
    if (symbol.kind == Symbol::Kind::Command) {
        const Command& cycle = symbol.command();
        if (!cycle.name.starts_with("CYCLE8") || name == "CYCLE800")
            return fail_at(x, Alarm::NotBuilt, at, name.size(), "MCALL " + name);
        Call given;
        if (!read_arguments(x, cycle, given) || !rest_must_be_empty(x)) return false;
        call.arguments = std::move(given.arguments);
        call.cycle = &cycle;
        x.modal.call = std::move(call);
        return true;
    }
    if (x.line.cursor.peek() == '(' && !read_program_arguments(x, name, call.arguments))
        return false;
    if (!rest_must_be_empty(x)) return false;
    if (!x.files.find_name(name) && !x.files.find_name(name + ".SPF"))
        return fail_at(x, names_cycle(name) ? Alarm::NotBuilt : Alarm::SubprogramMissing, at,
                       name.size(), names_cycle(name) ? "MCALL " + name : name);
    x.modal.call = std::move(call);
    return true;
}
}  // namespace polyturn::channels::sinumerik
