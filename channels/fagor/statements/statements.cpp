#include "channels/fagor/statements/statements.hpp"

#include <fmt/format.h>

#include <cmath>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/calls.hpp"
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

constexpr std::string_view kCustomizing[] = {"PAGE", "SYMBOL", "IB",   "ODW",  "DW",    "DWH",
                                             "DWB",  "SK",     "WKEY", "WBUF", "SYSTEM"};

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
            x.line.fault.column = static_cast<std::uint32_t>(at - x.line.text.data()) + 1;
            x.line.fault.length = 1;
            return Flow::Fault;
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

Flow if_statement(Execution& x, const char*& at, const char* end) {
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

Flow message_statement(Execution& x, const char*& at, const char* end) {
    const char* const begin = at;
    std::string text;
    if (!quoted(at, end, text)) return flow_fault(x, Alarm::FagorStatement, begin, 1, "MSG");
    x.facts.message = with_parameters(x, text, true);
    x.core.mark_emitted();
    x.core.sink().message(x.facts.message, x.core.at);
    return Flow::Done;
}

// A number, a text, or both: the program ends with this error.
Flow error_statement(Execution& x, const char*& at, const char* end) {
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

Flow run_statement(Execution& x, const char*& at, const char* end, bool inside_if) {
    blanks(at, end);
    if (at == end) return flow_fault(x, Alarm::FagorStatement, at, 1, "()");
    const std::string_view word = letters_at(at, end);
    const char* const begin = at;
    const auto is = [&](std::string_view name) {
        if (word != name) return false;
        at += name.size();
        blanks(at, end);
        return true;
    };
    // The count behind IF belongs to the RPT in it.
    const bool counts =
        word == "RPT" || inside_if ||
        (word == "IF" && std::string_view(at, end).find("RPT") != std::string_view::npos);
    if (x.line.block.repeat >= 0 && !counts)
        return flow_fault(x, Alarm::FagorRepeat, begin, word.size());
    if (inside_if && (word == "IF" || word == "SUB"))
        return flow_fault(x, Alarm::FagorStatement, begin, word.size(),
                          std::string(word) + " in IF");
    if (is("IF")) return if_statement(x, at, end);
    if (is("MSG")) return message_statement(x, at, end);
    if (is("ERROR")) return error_statement(x, at, end);
    if (word.starts_with("GOTO")) {
        at += 4;
        return goto_statement(x, at, end);
    }
    if (is("RPT")) return rpt_statement(x, at, end);
    if (is("CALL")) return call_statement(x, at, end, "CALL");
    if (is("PCALL")) return call_statement(x, at, end, "PCALL");
    if (is("MCALL")) return call_statement(x, at, end, "MCALL");
    if (is("MDOFF")) {
        x.modal.modal_call = {};
        return Flow::Done;
    }
    if (is("SUB")) return skip_definition(x, at, end);
    if (is("RET")) {
        if (x.calls.here().kind != CallFrame::Kind::Subroutine)
            return flow_fault(x, Alarm::FagorReturn, begin, 3);
        if (const Flow flow = nothing_follows(x, at, end); flow != Flow::Done) return flow;
        x.run.called = true;
        return return_from_frame(x) ? Flow::Done : Flow::Fault;
    }
    if (is("EXEC")) return exec_statement(x, at, end, false);
    if (is("MEXEC")) return exec_statement(x, at, end, true);
    if (is("OPEN")) return open_statement(x, at, end);
    if (is("WRITE")) return write_statement(x, at, end);
    if (is("REPOS")) return repos_statement(x, at, end);
    if (is("ESBLK") || is("DSBLK")) {
        x.modal.one_block = word == "ESBLK";
        tell_control(x, !x.modal.one_block);
        return Flow::Done;
    }
    if (is("DSTOP") || is("ESTOP")) {
        x.modal.stop_disabled = word == "DSTOP";
        tell_control(x, false);
        return Flow::Done;
    }
    if (is("DFHOLD") || is("EFHOLD")) {
        x.modal.hold_disabled = word == "DFHOLD";
        tell_control(x, false);
        return Flow::Done;
    }
    if (is("DGWZ")) {  // what the screen shows; the values must be right all the same
        for (int k = 0; k < 4; ++k) {
            double value = 0.0;
            if (const Flow flow = evaluate(x, at, end, value); flow != Flow::Done) return flow;
            blanks(at, end);
            if (k < 3 && (at == end || *at++ != ','))
                return flow_fault(x, Alarm::FagorStatement, begin, 4, "DGWZ");
        }
        return Flow::Done;
    }
    for (const std::string_view name : kCustomizing)
        if (word == name)
            return flow_fault(x, Alarm::FagorUserChannel, begin, word.size(), std::string(word));
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
