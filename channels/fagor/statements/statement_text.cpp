#include "channels/fagor/statements/statement_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "channels/fagor/execution.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fagor {
namespace {

Flow flow_of(Execution& x, Expression::Status status) {
    if (status == Expression::Status::Ok) return Flow::Done;
    if (status == Expression::Status::NeedsBarrier) return Flow::NeedsBarrier;
    const ExpressionFault& f = x.parsers.expression.fault();
    if (f.alarm == Alarm{}) return Flow::Fault;  // reported by read()
    return flow_fault(x, f.alarm, f.at ? f.at : x.line.text.data(), f.length, f.detail);
}

}  // namespace

Flow flow_fault(Execution& x, Alarm alarm, const char* at, std::size_t length, std::string detail,
                double value) {
    x.line.fault.column = static_cast<std::uint32_t>(at - x.line.text.data()) + 1;
    x.line.fault.length = static_cast<std::uint32_t>(length);
    x.fail(alarm, 0, std::move(detail), value);
    return Flow::Fault;
}

Flow fault_stands_at(Execution& x, const char* at) {
    x.line.fault.column = static_cast<std::uint32_t>(at - x.line.text.data()) + 1;
    x.line.fault.length = 1;
    return Flow::Fault;
}

Flow evaluate(Execution& x, const char*& at, const char* end, double& value) {
    return flow_of(x, x.parsers.expression.evaluate(at, end, value));
}

Flow read_target(Execution& x, const char*& at, const char* end, Target& to) {
    return flow_of(x, x.parsers.expression.target(at, end, to));
}

// One statement in a block (12). What jumps or calls asks before it does so: of a block that cannot
// be read nothing is done.
Flow nothing_follows(Execution& x, const char*& at, const char* end) {
    blanks(at, end);
    return at == end ? Flow::Done
                     : flow_fault(x, Alarm::FagorStatement, at, static_cast<std::size_t>(end - at),
                                  std::string(at, end));
}

Flow number_of_statement(Execution& x, const char*& at, const char* end, char letter,
                         std::int64_t& number) {
    blanks(at, end);
    if (letter) {
        if (at == end || *at != letter)
            return flow_fault(x, Alarm::FagorStatement, at == end ? at - 1 : at, 1,
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
    } else if (const Flow flow = evaluate(x, at = begin, end, value); flow != Flow::Done) {
        return flow;
    }
    if (value < 0 || value != std::nearbyint(value))
        return flow_fault(x, Alarm::FagorValueRange, begin, 1,
                          letter ? std::string(1, letter) : "the number", value);
    number = static_cast<std::int64_t>(value);
    return Flow::Done;
}

bool quoted(const char*& at, const char* end, std::string& text) {
    blanks(at, end);
    if (at == end || *at != '"') return false;
    const char* const begin = ++at;
    while (at != end && *at != '"') ++at;
    if (at == end) return false;
    text.assign(begin, at++);
    return true;
}

// ?P12 becomes the value; with only_marked false P12 behind a letter becomes it too.
std::string with_parameters(Execution& x, std::string_view text, bool only_marked) {
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
        std::string digits = fmt::format("{:.5f}", x.values.parameter(number));
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

}  // namespace polyturn::channels::fagor
