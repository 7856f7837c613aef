#include "channels/fagor/statements/statements.hpp"

#include <fmt/format.h>

#include <cmath>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/fault.hpp"
#include "channels/fagor/flow/step.hpp"
#include "channels/fagor/statements/call_statements.hpp"
#include "channels/fagor/statements/control.hpp"
#include "channels/fagor/statements/statement_text.hpp"
#include "channels/fagor/statements/written_programs.hpp"
#include "channels/fagor/variables/live_values.hpp"
#include "channels/fagor/variables/named.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fagor {
namespace {

// Position of ELSE outside of quotes and brackets; `end` where there is none.
const char* else_in(const char* at, const char* end) {
    bool quoted = false;
    int depth = 0;
    for (const char* p = at; p != end; ++p) {
        if (*p == '"') quoted = !quoted;
        if (quoted) continue;
        depth += *p == '(' ? 1 : *p == ')' ? -1 : 0;
        if (depth == 0 && end - p >= 4 && std::string_view(p, 4) == "ELSE" &&
            (p == at || !is_capital(p[-1])))
            return p;
    }
    return end;
}

Flow run_statement(Execution& x, const char*& at, const char* end, bool inside_if);

Flow assign(Execution& x, const Target& to, double value, const char* at) {
    switch (write_value(x, to, value)) {
        case Access::Ok:
            break;
        case Access::NeedsBarrier:
            return Flow::NeedsBarrier;
        case Access::ReadOnly:
            return flow_fault(x, Alarm::VariableReadOnly, at, 1, target_name(to));
        case Access::Unknown:
            return flow_fault(x, Alarm::VariableUnknown, at, 1, target_name(to));
        case Access::Fault:
            return fault_stands_at(x, at);
    }
    return Flow::Done;
}

// destination = expression, several separated by commas; a letter and a number do without the sign
// of equality.
Flow assignments(Execution& x, const char*& at, const char* end) {
    for (int count = 0;; ++count) {
        blanks(at, end);
        const char* const begin = at;
        if (count == 26) return flow_fault(x, Alarm::WordsTooMany, begin);
        Target to;
        if (const Flow flow = read_target(x, at, end, to); flow != Flow::Done) {
            if (flow == Flow::Fault && x.core.fault().alarm == Alarm::VariableUnknown &&
                count == 0) {
                const std::string_view word = letters_at(begin, end);
                return flow_fault(x, Alarm::FagorStatement, begin, word.size(), std::string(word));
            }
            return flow;
        }
        blanks(at, end);
        double value = 0.0;
        if (at != end && *at == '=') {
            ++at;
        } else if (!(to.by_letter && at != end &&
                     (is_digit(*at) || *at == '.' || *at == '-' || *at == '+' || *at == '$'))) {
            return flow_fault(x, Alarm::FagorStatement, begin,
                              static_cast<std::size_t>(end - begin), std::string(begin, end));
        }
        if (const Flow flow = evaluate(x, at, end, value); flow != Flow::Done) return flow;
        if (const Flow flow = assign(x, to, value, begin); flow != Flow::Done) return flow;
        blanks(at, end);
        if (at == end || *at != ',') return Flow::Done;
        ++at;
    }
}

Flow if_statement(Execution& x, std::string_view, const char*& at, const char* end) {
    double value = 0.0;
    if (const Flow flow = evaluate(x, at, end, value); flow != Flow::Done) return flow;
    const char* const otherwise = else_in(at, end);
    blanks(at, otherwise);
    // nothing to do: a mistake whether it holds or not
    if (at == otherwise) return flow_fault(x, Alarm::FagorStatement, at - 1, 1, "IF");
    if (otherwise != end) {
        const char* second = else_in(otherwise + 4, end);
        if (const Flow flow = nothing_follows(x, second, end); flow != Flow::Done) return flow;
    }
    if (value == 0.0) {
        at = otherwise;
        if (at == end) return Flow::Done;
        at += 4;
        return run_statement(x, at, end, true);
    }
    Flow flow = run_statement(x, at, otherwise, true);
    if (flow == Flow::Done) flow = nothing_follows(x, at, otherwise);
    if (flow != Flow::Done) return flow;
    at = end;
    return Flow::Done;
}

Flow message_statement(Execution& x, std::string_view, const char*& at, const char* end) {
    const char* const begin = at;
    std::string text;
    if (!quoted(at, end, text)) return flow_fault(x, Alarm::FagorStatement, begin, 1, "MSG");
    x.facts.message = with_parameters(x, text, true);
    x.core.mark_emitted();
    x.core.sink().message(x.facts.message, x.core.at);
    return Flow::Done;
}

// A number, a text, or both: the program ends with this error.
Flow error_statement(Execution& x, std::string_view, const char*& at, const char* end) {
    const char* const begin = at;
    std::string text;
    double number = 0.0;
    if (!quoted(at, end, text)) {
        if (const Flow flow = evaluate(x, at, end, number); flow != Flow::Done) return flow;
        blanks(at, end);
        if (at != end && *at == ',') {
            ++at;
            if (!quoted(at, end, text))
                return flow_fault(x, Alarm::FagorStatement, at == end ? begin : at, 1, "ERROR");
        }
    }
    x.facts.message = text.empty() ? fmt::format("error {:.0f}", std::nearbyint(number))
                                   : with_parameters(x, text, true);
    return x.core.program_alarm(x.facts.message, std::nearbyint(number)) ? Flow::Done : Flow::Fault;
}

// What the screen shows; the values must be right all the same.
Flow dgwz_statement(Execution& x, std::string_view word, const char*& at, const char* end) {
    for (int k = 0; k < 4; ++k) {
        double value = 0.0;
        if (const Flow flow = evaluate(x, at, end, value); flow != Flow::Done) return flow;
        blanks(at, end);
        if (k < 3 && (at == end || *at++ != ','))
            return flow_fault(x, Alarm::FagorStatement, word.data(), word.size(), "DGWZ");
    }
    return Flow::Done;
}

// Statements of the user's own screens.
Flow customizing_statement(Execution& x, std::string_view word, const char*&, const char*) {
    return flow_fault(x, Alarm::FagorUserChannel, word.data(), word.size(), std::string(word));
}

struct StatementRow {
    std::string_view word;
    StatementAct act;
};
constexpr StatementRow kStatements[] = {
    {"IF", if_statement},
    {"MSG", message_statement},
    {"ERROR", error_statement},
    {"RPT", rpt_statement},
    {"CALL", call_statement},
    {"PCALL", call_statement},
    {"MCALL", call_statement},
    {"MDOFF", mdoff_statement},
    {"SUB", skip_definition},
    {"RET", ret_statement},
    {"EXEC", exec_statement},
    {"MEXEC", exec_statement},
    {"OPEN", open_statement},
    {"WRITE", write_statement},
    {"REPOS", repos_statement},
    {"ESBLK", control_statement},
    {"DSBLK", control_statement},
    {"DSTOP", control_statement},
    {"ESTOP", control_statement},
    {"DFHOLD", control_statement},
    {"EFHOLD", control_statement},
    {"DGWZ", dgwz_statement},
    {"PAGE", customizing_statement},
    {"SYMBOL", customizing_statement},
    {"IB", customizing_statement},
    {"ODW", customizing_statement},
    {"DW", customizing_statement},
    {"DWH", customizing_statement},
    {"DWB", customizing_statement},
    {"SK", customizing_statement},
    {"WKEY", customizing_statement},
    {"WBUF", customizing_statement},
    {"SYSTEM", customizing_statement},
};

Flow run_statement(Execution& x, const char*& at, const char* end, bool inside_if) {
    blanks(at, end);
    if (at == end) return flow_fault(x, Alarm::FagorStatement, at, 1, "()");
    const std::string_view word = letters_at(at, end);
    // The count behind IF belongs to the RPT in it.
    const bool counts =
        word == "RPT" || inside_if ||
        (word == "IF" && std::string_view(at, end).find("RPT") != std::string_view::npos);
    if (x.line.block.repeat >= 0 && !counts)
        return flow_fault(x, Alarm::FagorRepeat, at, word.size());
    if (inside_if && (word == "IF" || word == "SUB"))
        return flow_fault(x, Alarm::FagorStatement, at, word.size(), std::string(word) + " in IF");
    if (word.starts_with("GOTO")) {  // the letter of the label follows without a blank
        at += 4;
        return goto_statement(x, word, at, end);
    }
    for (const StatementRow& row : kStatements) {
        if (word != row.word) continue;
        at += word.size();
        blanks(at, end);
        return row.act(x, word, at, end);
    }
    return assignments(x, at, end);
}

}  // namespace

Step statement_block(Execution& x) {
    x.run.jumped = x.run.called = x.run.wants_barrier = false;
    x.words.repeats = x.line.block.repeat;
    const std::uint64_t ways_before = x.core.ways();
    const char* at = x.line.text.data() + x.line.block.statement;
    const char* const end = x.line.text.data() + x.line.block.statement_end;
    const bool asks = !x.run.fresh && mentions_live_value(at, end),
               settles = !asks && axes_settle(x, at, end);
    Flow flow = asks || settles ? Flow::NeedsBarrier : run_statement(x, at, end, false);
    if (flow == Flow::Done) flow = nothing_follows(x, at, end);
    if (flow == Flow::NeedsBarrier) {
        x.run.reread = true;
        if (!settles) x.core.asks_at(x.calls.here().file, x.line.at.offset);
        live_value_barrier(x);
        if (x.core.reads_ahead() && !x.core.end_compensated_block(false, true, false))
            return fault(x, x.core.fault());
        return Step::AtBarrier;
    }
    if (flow == Flow::Fault) return fault(x, x.core.fault());
    return end_block(x, true, ways_before);
}

}  // namespace polyturn::channels::fagor
