// Statements in round brackets: which one it is, assignments, conditions, messages (fagor_8037t
// part 2, 12.1 to 12.4).
#include <fmt/format.h>

#include <cmath>

#include "channels/fagor/interpreter.hpp"
#include "channels/text/chars.hpp"
#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::channels::fagor {
namespace {

std::string_view letters_at(const char* at, const char* end) {
    const char* q = at;
    while (q != end && is_capital(*q)) ++q;
    return {at, static_cast<std::size_t>(q - at)};
}

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

// Is there a variable in the text of which `is` holds?
bool any_variable(const char* at, const char* end, auto&& is) {
    bool quoted = false;
    for (const char* p = at; p < end;) {
        if (*p == '"') quoted = !quoted;
        if (quoted || !is_capital(*p)) {
            ++p;
            continue;
        }
        const std::string_view name = letters_at(p, end);
        char axis = 0;
        if (const VariableRow* row = find_variable(name, axis); row && is(*row, axis)) return true;
        p += name.size();
    }
    return false;
}

// Does a value of the machine stand in the text? Then the machine must have come here before
// anything of it is done.
bool mentions_live_value(const char* at, const char* end) {
    return any_variable(at, end, [](const VariableRow& row, char) { return row.live; });
}

constexpr std::string_view kCustomizing[] = {"PAGE", "SYMBOL", "IB",   "ODW",  "DW",    "DWH",
                                             "DWB",  "SK",     "WKEY", "WBUF", "SYSTEM"};

}  // namespace

Interpreter::Flow Interpreter::flow_fault(Alarm alarm, const char* at, std::size_t length,
                                          std::string detail, double value) {
    fault_column_ = static_cast<std::uint32_t>(at - line_.data()) + 1;
    fault_length_ = static_cast<std::uint32_t>(length);
    core_.fail(alarm, 0, std::move(detail), value);
    return Flow::Fault;
}

Interpreter::Flow Interpreter::flow_of(Expression::Status status) {
    if (status == Expression::Status::Ok) return Flow::Done;
    if (status == Expression::Status::NeedsBarrier) return Flow::NeedsBarrier;
    const ExpressionFault& f = expression_.fault();
    if (f.alarm == Alarm{}) return Flow::Fault;  // reported by read()
    return flow_fault(f.alarm, f.at ? f.at : line_.data(), f.length, f.detail);
}

Interpreter::Flow Interpreter::evaluate(const char*& at, const char* end, double& value) {
    return flow_of(expression_.evaluate(at, end, value));
}

Interpreter::Flow Interpreter::target(const char*& at, const char* end, Target& to) {
    return flow_of(expression_.target(at, end, to));
}

// A program that reads where an axis really is (POS, APOS) means where it has come to, not how it
// swings there behind a move: it is waited for until the axis is quiet, a fifth of a second at
// most. What a probe has touched is already at rest.
bool Interpreter::axes_settle(const char* at, const char* end) {
    constexpr double kQuietMm = 3e-4;
    constexpr unsigned kQuietLooks = 10, kMostLooks = 200;  // one look a tick
    if (core_.moves() == settled_moves_ || core_.moves() == moves_at_touch_ || core_.reads_ahead())
        return false;
    bool reads = false, swings = false;
    any_variable(at, end, [&](const VariableRow& row, char axis) {
        if ((row.var != Var::Position && row.var != Var::PartPosition) || place_of(axis) < 0)
            return false;
        const unsigned machine_axis =
            core_.view().axes[static_cast<std::size_t>(place_of(axis))].machine_axis;
        const auto command = core_.port().axis_command(machine_axis),
                   measured = core_.port().axis_measured(machine_axis);
        reads = reads || (command && measured);
        swings = swings || (command && measured && std::fabs(*command - *measured) > kQuietMm);
        return false;
    });
    if (!reads) return false;
    quiet_looks_ = swings ? 0 : quiet_looks_ + 1;
    if (quiet_looks_ < kQuietLooks && ++settle_looks_ < kMostLooks) return true;
    settled_moves_ = core_.moves();
    quiet_looks_ = settle_looks_ = 0;
    return false;
}

Step Interpreter::statement_block() {
    jumped_ = called_ = wants_barrier_ = false;
    repeats_ = block_.repeat;
    const std::uint64_t ways_before = core_.ways();
    const char* at = line_.data() + block_.statement;
    const char* const end = line_.data() + block_.statement_end;
    const bool asks = !fresh_ && mentions_live_value(at, end),
               settles = !asks && axes_settle(at, end);
    Flow flow = asks || settles ? Flow::NeedsBarrier : run_statement(at, end, false);
    if (flow == Flow::Done) flow = nothing_follows(at, end);
    if (flow == Flow::NeedsBarrier) {
        reread_ = true;
        if (!settles) core_.asks_at(frames_.back().file, line_at_.offset);
        live_value_barrier();
        if (core_.reads_ahead() && !core_.end_compensated_block(false, true, false))
            return fault(core_.fault());
        return Step::AtBarrier;
    }
    if (flow == Flow::Fault) return fault(core_.fault());
    return end_block(true, ways_before);
}

// One statement in a block (12). What jumps or calls asks before it does so: of a block that cannot
// be read nothing is done.
Interpreter::Flow Interpreter::nothing_follows(const char*& at, const char* end) {
    blanks(at, end);
    return at == end ? Flow::Done
                     : flow_fault(Alarm::FagorStatement, at, static_cast<std::size_t>(end - at),
                                  std::string(at, end));
}

Interpreter::Flow Interpreter::run_statement(const char*& at, const char* end, bool inside_if) {
    blanks(at, end);
    if (at == end) return flow_fault(Alarm::FagorStatement, at, 1, "()");
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
    if (block_.repeat >= 0 && !counts) return flow_fault(Alarm::FagorRepeat, begin, word.size());
    if (inside_if && (word == "IF" || word == "SUB"))
        return flow_fault(Alarm::FagorStatement, begin, word.size(), std::string(word) + " in IF");
    if (is("IF")) return condition(at, end);
    if (is("MSG")) return message_statement(at, end);
    if (is("ERROR")) return error_statement(at, end);
    if (word.starts_with("GOTO")) {
        at += 4;
        return go_to(at, end);
    }
    if (is("RPT")) return repeat(at, end);
    if (is("CALL")) return call(at, end, "CALL");
    if (is("PCALL")) return call(at, end, "PCALL");
    if (is("MCALL")) return call(at, end, "MCALL");
    if (is("MDOFF")) {
        modal_.modal_call = {};
        return Flow::Done;
    }
    if (is("SUB")) return skip_definition(at, end);
    if (is("RET")) {
        if (frames_.back().kind != CallFrame::Kind::Subroutine)
            return flow_fault(Alarm::FagorReturn, begin, 3);
        if (const Flow flow = nothing_follows(at, end); flow != Flow::Done) return flow;
        called_ = true;
        return return_from_frame() ? Flow::Done : Flow::Fault;
    }
    if (is("EXEC")) return execute(at, end, false);
    if (is("MEXEC")) return execute(at, end, true);
    if (is("OPEN")) return open(at, end);
    if (is("WRITE")) return write(at, end);
    if (is("REPOS")) return reposition(at, end);
    if (is("ESBLK") || is("DSBLK")) {
        modal_.one_block = word == "ESBLK";
        tell_control(!modal_.one_block);
        return Flow::Done;
    }
    if (is("DSTOP") || is("ESTOP")) {
        modal_.stop_disabled = word == "DSTOP";
        tell_control(false);
        return Flow::Done;
    }
    if (is("DFHOLD") || is("EFHOLD")) {
        modal_.hold_disabled = word == "DFHOLD";
        tell_control(false);
        return Flow::Done;
    }
    if (is("DGWZ")) {  // what the screen shows; the values must be right all the same
        for (int k = 0; k < 4; ++k) {
            double value = 0.0;
            if (const Flow flow = evaluate(at, end, value); flow != Flow::Done) return flow;
            blanks(at, end);
            if (k < 3 && (at == end || *at++ != ','))
                return flow_fault(Alarm::FagorStatement, begin, 4, "DGWZ");
        }
        return Flow::Done;
    }
    for (const std::string_view name : kCustomizing)
        if (word == name)
            return flow_fault(Alarm::FagorUserChannel, begin, word.size(), std::string(word));
    return assignments(at, end);
}

// What the program takes out of the operator's hands, in path order (12.3).
void Interpreter::tell_control(bool group_ends) {
    std::uint32_t bits = modal_.one_block ? kControlNoSingleBlock : 0u;
    if (modal_.stop_disabled || modal_.hold_disabled) bits |= kControlNoHold | kControlNoPlcStop;
    if (group_ends) bits |= kControlGroupEnds;
    if (modal_.spindle_override_program > 0) bits |= kControlOwnSpindleOverride;
    core_.tell_control(bits);
}

// destination = expression, several separated by commas; a letter and a number do without the sign
// of equality.
Interpreter::Flow Interpreter::assignments(const char*& at, const char* end) {
    for (int count = 0;; ++count) {
        blanks(at, end);
        const char* const begin = at;
        if (count == 26) return flow_fault(Alarm::WordsTooMany, begin);
        Target to;
        if (const Flow flow = target(at, end, to); flow != Flow::Done) {
            if (flow == Flow::Fault && core_.fault().alarm == Alarm::VariableUnknown &&
                count == 0) {
                const std::string_view word = letters_at(begin, end);
                return flow_fault(Alarm::FagorStatement, begin, word.size(), std::string(word));
            }
            return flow;
        }
        blanks(at, end);
        double value = 0.0;
        if (at != end && *at == '=') {
            ++at;
        } else if (!(to.by_letter && at != end &&
                     (is_digit(*at) || *at == '.' || *at == '-' || *at == '+' || *at == '$'))) {
            return flow_fault(Alarm::FagorStatement, begin, static_cast<std::size_t>(end - begin),
                              std::string(begin, end));
        }
        const char* const value_at = at;
        if (const Flow flow = evaluate(at, end, value); flow != Flow::Done) return flow;
        if (const Flow flow = assign(to, value, begin); flow != Flow::Done) return flow;
        (void)value_at;
        blanks(at, end);
        if (at == end || *at != ',') return Flow::Done;
        ++at;
    }
}

Interpreter::Flow Interpreter::assign(const Target& to, double value, const char* at) {
    switch (write_value(to, value)) {
        case Access::Ok:
            break;
        case Access::NeedsBarrier:
            return Flow::NeedsBarrier;
        case Access::ReadOnly:
            return flow_fault(Alarm::VariableReadOnly, at, 1, target_name(to));
        case Access::Unknown:
            return flow_fault(Alarm::VariableUnknown, at, 1, target_name(to));
        case Access::Fault: {
            const Fault fault = core_.fault();
            fault_column_ = static_cast<std::uint32_t>(at - line_.data()) + 1;
            fault_length_ = 1;
            return Flow::Fault;
        }
    }
    return Flow::Done;
}

Interpreter::Flow Interpreter::condition(const char*& at, const char* end) {
    double value = 0.0;
    if (const Flow flow = evaluate(at, end, value); flow != Flow::Done) return flow;
    const char* const otherwise = else_in(at, end);
    blanks(at, otherwise);
    // nothing to do: a mistake whether it holds or not
    if (at == otherwise) return flow_fault(Alarm::FagorStatement, at - 1, 1, "IF");
    if (otherwise != end) {
        const char* second = else_in(otherwise + 4, end);
        if (const Flow flow = nothing_follows(second, end); flow != Flow::Done) return flow;
    }
    if (value == 0.0) {
        at = otherwise;
        if (at == end) return Flow::Done;
        at += 4;
        return run_statement(at, end, true);
    }
    Flow flow = run_statement(at, otherwise, true);
    if (flow == Flow::Done) flow = nothing_follows(at, otherwise);
    if (flow != Flow::Done) return flow;
    at = end;
    return Flow::Done;
}

bool Interpreter::quoted(const char*& at, const char* end, std::string& text) {
    blanks(at, end);
    if (at == end || *at != '"') return false;
    const char* const begin = ++at;
    while (at != end && *at != '"') ++at;
    if (at == end) return false;
    text.assign(begin, at++);
    return true;
}

// ?P12 becomes the value; with only_marked false P12 behind a letter becomes it too.
std::string Interpreter::with_parameters(std::string_view text, bool only_marked) {
    std::string out;
    bool quotes = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"') quotes = !quotes;
        const bool marked = text[i] == '?' && i + 1 < text.size();
        const std::size_t name = marked ? i + 1 : i;
        const bool plain = !only_marked && !quotes && text[i] == 'P';
        std::size_t j = name;
        std::int64_t number = -1;
        if ((marked || plain) && j < text.size() && text[j] == 'P' && j + 1 < text.size() &&
            is_digit(text[j + 1])) {
            number = 0;
            for (++j; j < text.size() && is_digit(text[j]) && number < 100'000; ++j)
                number = number * 10 + (text[j] - '0');
        } else if (marked && j < text.size() && is_capital(text[j]) &&
                   (j + 1 == text.size() || !is_capital(text[j + 1]))) {
            number = text[j++] - 'A';  // a local parameter by its letter
        }
        if (number < 0 || !Values::exists(number)) {
            out += text[i];
            continue;
        }
        std::string digits = fmt::format("{:.5f}", values_.parameter(number));
        while (digits.find('.') != std::string::npos &&
               (digits.back() == '0' || digits.back() == '.')) {
            const bool point = digits.back() == '.';
            digits.pop_back();
            if (point) break;
        }
        if (digits == "-0") digits = "0";
        // Z-P1 of a negative P1 is a word with one sign
        if (plain && digits[0] == '-' && !out.empty() && (out.back() == '-' || out.back() == '+')) {
            if (out.back() == '-') digits.erase(0, 1);
            out.pop_back();
        }
        out += digits;
        i = j - 1;
    }
    return out;
}

Interpreter::Flow Interpreter::message_statement(const char*& at, const char* end) {
    const char* const begin = at;
    std::string text;
    if (!quoted(at, end, text)) return flow_fault(Alarm::FagorStatement, begin, 1, "MSG");
    message_ = with_parameters(text, true);
    core_.mark_emitted();
    core_.sink().message(message_, core_.at);
    return Flow::Done;
}

// A number, a text, or both: the program ends with this error.
Interpreter::Flow Interpreter::error_statement(const char*& at, const char* end) {
    const char* const begin = at;
    std::string text;
    double number = 0.0;
    if (!quoted(at, end, text)) {
        if (const Flow flow = evaluate(at, end, number); flow != Flow::Done) return flow;
        blanks(at, end);
        if (at != end && *at == ',') {
            ++at;
            if (!quoted(at, end, text))
                return flow_fault(Alarm::FagorStatement, at == end ? begin : at, 1, "ERROR");
        }
    }
    message_ = text.empty() ? fmt::format("error {:.0f}", std::nearbyint(number))
                            : with_parameters(text, true);
    return core_.program_alarm(message_, std::nearbyint(number)) ? Flow::Done : Flow::Fault;
}

Interpreter::Flow Interpreter::number_of_statement(const char*& at, const char* end, char letter,
                                                   std::int64_t& number) {
    blanks(at, end);
    if (letter) {
        if (at == end || *at != letter)
            return flow_fault(Alarm::FagorStatement, at == end ? at - 1 : at, 1,
                              std::string(1, letter) + " is missing");
        ++at;
        blanks(at, end);
    }
    double value = 0.0;
    const char* const begin = at;
    // A number stands for itself even where a constant of an expression would be too long.
    unsigned digits = 0;
    for (; at != end && is_digit(*at) && digits < 9; ++at, ++digits)
        value = value * 10 + (*at - '0');
    const char* behind = at;
    blanks(behind, end);
    if (digits &&
        (behind == end || std::string_view(".+-*/").find(*behind) == std::string_view::npos)) {
        at = behind;
    } else if (const Flow flow = evaluate(at = begin, end, value); flow != Flow::Done) {
        return flow;
    }
    if (value < 0 || value != std::nearbyint(value))
        return flow_fault(Alarm::FagorValueRange, begin, 1,
                          letter ? std::string(1, letter) : "the number", value);
    number = static_cast<std::int64_t>(value);
    return Flow::Done;
}

Interpreter::Flow Interpreter::go_to(const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t label = 0;
    if (const Flow flow = number_of_statement(at, end, 'N', label); flow != Flow::Done) return flow;
    if (const Flow flow = nothing_follows(at, end); flow != Flow::Done) return flow;
    if (!jump_to(label))
        return flow_fault(Alarm::SequenceNumberMissing, begin, 1, std::to_string(label));
    return Flow::Done;
}

}  // namespace polyturn::channels::fagor
