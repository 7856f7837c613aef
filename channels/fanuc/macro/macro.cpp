// Statements of custom macro B: assignments, IF, WHILE, DO, END, GOTO.
#include "channels/fanuc/macro/macro.hpp"

#include <cmath>
#include <utility>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/macro/flow.hpp"
#include "channels/fanuc/macro/loops.hpp"
#include "channels/fanuc/macro/printing.hpp"
#include "channels/fanuc/macro/statement_words.hpp"
#include "channels/fanuc/macro/variable_writes.hpp"
#include "channels/fanuc/program/barriers.hpp"
#include "channels/fanuc/program/faults.hpp"
#include "channels/fanuc/program/search.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Word of output statements and names that `letters` is, or is the beginning of.
std::string_view statement_name(std::string_view letters) {
    for (const std::string_view name : {"POPEN", "PCLOS", "DPRNT", "BPRNT", "SETVN"})
        if (letters.size() >= 2 && name.starts_with(letters)) return name;
    return {};
}

// The text of a comment that begins at `at`, for #3000=1(TEXT).
std::string_view comment_text(const char*& at, const char* end) {
    blanks(at, end);
    if (at == end || *at != '(') return {};
    const char* const begin = ++at;
    while (at != end && *at != ')') ++at;
    const std::string_view text(begin, static_cast<std::size_t>(at - begin));
    if (at != end) ++at;
    return text;
}

Flow goto_statement(Execution& x, const char*& at, const char* end) {
    gap(at, end);
    const char* const begin = at;
    double value = 0.0;
    const Flow flow = evaluate_expression(x, at, end, value);
    if (flow != Flow::Done) return flow;
    const double number = std::nearbyint(value);
    if (is_null(value) || number < 1 || number > static_cast<double>(x.settings.goto_max))
        return flow_fault(x, Alarm::GotoNumberIllegal, begin, {}, is_null(value) ? 0.0 : value);
    x.words.culprit.column = static_cast<std::uint32_t>(begin - x.text.line.data()) + 1;
    x.words.culprit.length = 1;
    const auto found = find_block(x, static_cast<std::int64_t>(number));
    if (!found) {  // 128 also when it cannot be found
        x.core.fail(Alarm::GotoNumberIllegal, 0, {}, value);
        return Flow::Fault;
    }
    go_to(x, *found);
    return Flow::Done;
}

Flow assignment_statement(Execution& x, const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t number = 0;
    if (const Flow flow = flow_of(x, x.macro.expression.variable_number(at, end, number));
        flow != Flow::Done)
        return flow;
    gap(at, end);
    if (at == end || *at != '=')
        return flow_fault(x, Alarm::MacroFormat, at == end ? begin : at, "= is missing");
    ++at;
    // a clock is set when the machine has come here
    if ((number == 3001 || number == 3002) && !x.run.fresh && !x.reading.inputs_fresh)
        return Flow::NeedsBarrier;
    double value = 0.0;
    if (const Flow flow = evaluate_expression(x, at, end, value); flow != Flow::Done) return flow;
    const std::string_view comment = comment_text(at, end);
    x.words.culprit.column = static_cast<std::uint32_t>(begin - x.text.line.data()) + 1;
    x.words.culprit.length = static_cast<std::uint32_t>(at - begin);
    // the call writes them (nct_parameters_part2 38)
    const bool of_letter_call =
        x.settings.policy.macro.letters_keep_theirs && number >= 191 && number <= 199;
    if (of_letter_call) {
        x.core.fail(Alarm::VariableReadOnly, 0, variable_name(number));
        return Flow::Fault;
    }
    if (!write_variable(x, number, value, comment)) return Flow::Fault;
    x.words.culprit.column = x.words.culprit.length = 0;
    return Flow::Done;
}

// SETVN 510[TOOL_NO,COUNT]
Flow name_statement(Execution& x, const char*& at, const char* end) {
    blanks(at, end);
    const char* const begin = at;
    double value = 0.0;
    if (const Flow flow = evaluate_expression(x, at, end, value); flow != Flow::Done) return flow;
    blanks(at, end);
    if (at == end || *at != '[') return flow_fault(x, Alarm::BracketMissing, at);
    auto number = static_cast<std::int64_t>(is_null(value) ? 0 : std::nearbyint(value));
    VariableNames given = x.macro.names;
    do {
        ++at;
        blanks(at, end);
        const char* const from = at;
        while (at != end && VariableNames::goes_on(*at)) ++at;
        const std::string_view name(from, static_cast<std::size_t>(at - from));
        if (name.empty() || name.size() > VariableNames::kLongest ||
            !VariableNames::begins(name[0]))
            return flow_fault(x, Alarm::MacroFormat, from,
                              "a name has 1 to 8 letters, digits and _, a letter first");
        if (!x.macro.variables.is_common(number))
            return flow_fault(x, Alarm::VariableUnknown, begin, variable_name(number));
        given.name(number++, name);
        blanks(at, end);
    } while (at != end && *at == ',');
    if (at == end || *at != ']') return flow_fault(x, Alarm::BracketMissing, at);
    ++at;
    x.macro.names = std::move(given);
    if (!x.reading.contour && !x.core.port().keep(kNamesKept, x.macro.names.text()))
        return flow_fault(x, Alarm::OutputFile, begin, "SETVN");
    return Flow::Done;
}

Flow run_statement(Execution& x, const char*& at, const char* end) {
    gap(at, end);
    if (at == end) return Flow::Done;
    if (*at == '#' || *at == '[') return assignment_statement(x, at, end);
    const char* const begin = at;
    if (take(at, end, "IF")) {
        bool holds = false;
        if (const Flow flow = bracketed_condition(x, at, end, holds); flow != Flow::Done)
            return flow;
        if (take(at, end, "GOTO")) {
            if (holds) return goto_statement(x, at, end);
            double ignored = 0.0;
            gap(at, end);
            return at != end && (*at == '#' || *at == '[')
                       ? flow_of(x, x.macro.expression.operand(at, end, ignored))
                       : evaluate_expression(x, at, end, ignored);
        }
        if (!take(at, end, "THEN"))
            return flow_fault(x, Alarm::MacroFormat, at, "IF without GOTO or THEN");
        if (!holds) {
            at = end;
            return Flow::Done;
        }
        gap(at, end);
        const char* word = at;
        if (at == end || take(word, end, "IF") || take(word, end, "WHILE") ||
            take(word, end, "DO") || take(word, end, "END"))
            return flow_fault(x, Alarm::MacroFormat, at, "THEN takes one statement, and no loop");
        return run_statement(x, at, end);
    }
    if (take(at, end, "GOTO")) return goto_statement(x, at, end);
    if (take(at, end, "WHILE")) {
        bool holds = false;
        const TextPlace here(x.text.source->position(), x.text.column);
        if (const Flow flow = bracketed_condition(x, at, end, holds); flow != Flow::Done)
            return flow;
        if (!take(at, end, "DO")) return flow_fault(x, Alarm::MacroFormat, at, "WHILE without DO");
        std::uint8_t number = 0;
        if (const Flow flow = loop_number(x, at, end, number); flow != Flow::Done) return flow;
        // A loop that is entered again (jumped out of, or the next round) replaces its old entry
        // and what was inside.
        while (x.calls.loops.size() > x.calls.frames.back().loops &&
               x.calls.loops.back().number == number)
            x.calls.loops.pop_back();
        if (!holds) return skip_loop(x, number, begin);
        x.calls.loops.push_back({number, here});
        return Flow::Done;
    }
    if (take(at, end, "DO")) {
        std::uint8_t number = 0;
        if (const Flow flow = loop_number(x, at, end, number); flow != Flow::Done) return flow;
        while (x.calls.loops.size() > x.calls.frames.back().loops &&
               x.calls.loops.back().number == number)
            x.calls.loops.pop_back();
        x.calls.loops.push_back({number, TextPlace(x.text.source->position(), x.text.column)});
        return Flow::Done;
    }
    if (take(at, end, "END")) {
        std::uint8_t number = 0;
        if (const Flow flow = loop_number(x, at, end, number); flow != Flow::Done) return flow;
        std::size_t found = x.calls.loops.size();
        while (found > x.calls.frames.back().loops && x.calls.loops[found - 1].number != number)
            --found;
        if (found == x.calls.frames.back().loops) return flow_fault(x, Alarm::DoEndMismatch, begin);
        const Loop loop = x.calls.loops[found - 1];
        x.calls.loops.resize(found - 1);  // loops inside were left by a jump
        x.run.fresh = false;              // the condition is asked of the machine anew
        go_on_at(x, loop.at);
        return Flow::Done;
    }
    std::string letters;
    for (const char* p = at; p != end && is_letter(*p); ++p) letters += capital(*p);
    const std::string_view name = statement_name(letters);
    if (name.empty() || (name == "SETVN" && !x.settings.policy.macro.variable_names))
        return flow_fault(x, Alarm::WordUnknown, at, letters);
    if (name == "SETVN") return name_statement(x, at += letters.size(), end);
    return print_statement(x, name, at, end);
}

}  // namespace

Step macro_statement(Execution& x, std::size_t from) {
    x.run.jumped = x.run.called = x.run.wants_barrier = false;
    x.core.at.statement = !x.settings.stops_at_macros;  // fanuc_lathe 6.7
    bool ends = false;
    if (const std::uint8_t number = loop_word(x.text.line.substr(from), ends);
        number && !ends && !loops_nest(x, number, from))
        return report(x, x.core.fault());
    const char* at = x.text.line.data() + from;
    const char* const end = x.text.line.data() + x.text.line.size();
    const std::size_t next = next_block(x.text.line, from);
    x.text.line_left = next != std::string_view::npos;
    x.text.behind = next;
    Flow flow = run_statement(x, at, end);
    if (flow == Flow::Done && !x.run.jumped) {
        gap(at, end);
        if (at != end && *at == '(')
            flow = flow_fault(x, Alarm::CommentOpen, at);
        else if (at != end && *at != ';')
            flow = flow_fault(x, Alarm::MacroFormat, at, std::string(at, end));
        else
            x.text.column = next;
    }
    if (flow == Flow::NeedsBarrier) {
        read_value_barrier(x);
        return Step::AtBarrier;
    }
    if (flow == Flow::Fault) return report(x, x.core.fault());
    if (x.core.emitted()) {
        x.run.fresh = false;
        x.core.end_block();
    }
    if (x.run.ended) return Step::Ended;
    // the machine comes here, so that it can stand here
    if (x.settings.stops_at_macros && !x.core.reads_ahead() && x.run.keeps_states) {
        x.core.sink().block_end(x.core.at);
        x.run.wants_barrier = true;
    }
    return x.run.wants_barrier ? Step::AtBarrier : Step::Continue;
}

}  // namespace polyturn::channels::fanuc
