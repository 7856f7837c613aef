// POPEN, DPRNT, BPRNT, PCLOS: what a macro sends to an external device (fanuc_lathe 6.12, nct part
// 2 18.6).
//
//   DPRNT[X#101[53] END]   ->   "X   12.500END"   a letter as it stands, then sign, 5 integer digits, 3 decimals
//
// The text is one event; the port keeps it (a file). Blanks between the items are not sent, an
// asterisk is a blank.
#include "channels/fanuc/macro/printing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/macro/flow.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
namespace {

bool is_sent(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '*' || c == '/' || c == '+' ||
           c == '-' || c == '.' || c == ',';
}

// Sign, whole digits (the lowest `whole`), point and decimals. compact: neither plus sign nor
// leading zeros.
std::string decimal_text(double value, int whole, int decimals, bool compact) {
    const double scale = std::pow(10.0, decimals);
    const double rounded = std::round(std::fabs(value) * scale);
    std::string digits = fmt::format("{:.0f}", rounded);
    if (digits.size() <= static_cast<std::size_t>(decimals))
        digits.insert(0, static_cast<std::size_t>(decimals) + 1 - digits.size(), '0');
    std::string before = digits.substr(0, digits.size() - static_cast<std::size_t>(decimals));
    const std::string behind = digits.substr(digits.size() - static_cast<std::size_t>(decimals));
    if (before.size() > static_cast<std::size_t>(whole))
        before = before.substr(before.size() - static_cast<std::size_t>(whole));
    if (before.find_first_not_of('0') == std::string::npos)
        before = whole > 0 ? "0" : "";
    else
        before = before.substr(before.find_first_not_of('0'));
    std::string text;
    if (value < 0 && rounded != 0)
        text = "-";
    else if (!compact)
        text = " ";
    if (!compact) text.append(static_cast<std::size_t>(whole) - before.size(), ' ');
    text += before;
    if (decimals > 0) text += "." + behind;
    return text;
}

// #n[cd] or #[..][cd]: c integer digits and d decimals; binary: c decimals.
Flow print_item(Execution& x, bool binary, const char*& at, const char* end, std::string& text) {
    const char* const begin = at;
    double value = 0.0;
    if (const Flow flow = flow_of(x, x.macro.expression.operand(at, end, value));
        flow != Flow::Done)
        return flow;
    blanks(at, end);
    if (at == end || *at != '[')
        return flow_fault(x, Alarm::BracketMissing, at == end ? begin : at);
    ++at;
    int format[3] = {0, 0, 0}, count = 0;
    for (blanks(at, end); at != end && *at >= '0' && *at <= '9' && count < 3; ++at)
        format[count++] = *at - '0';
    blanks(at, end);
    if (at == end || *at != ']')
        return flow_fault(x, Alarm::BracketMissing, at == end ? begin : at);
    ++at;
    if (count == 0 || count > (binary ? 1 : 2) || (!binary && format[0] + format[1] > 8) ||
        (!binary && format[0] + format[1] == 0))
        return flow_fault(x, Alarm::PrintFormat, begin, std::string(begin, at));
    if (is_null(value)) value = 0.0;
    if (!binary) {
        text += decimal_text(value, format[0], format[1], !x.macro.printing.blanks);
        return Flow::Done;
    }
    const double scaled = std::round(value * std::pow(10.0, format[0]));
    if (scaled < -2147483648.0 || scaled > 2147483647.0)
        return flow_fault(x, Alarm::ResultOutOfRange, begin, "BPRNT");
    const auto bits = static_cast<std::uint32_t>(static_cast<std::int32_t>(scaled));
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(bits >> shift & 0xFF);
    return Flow::Done;
}

}  // namespace

Flow print_statement(Execution& x, std::string_view name, const char*& at, const char* end) {
    const char* const begin = at;
    // the word, or its beginning
    while (at != end && ((*at >= 'A' && *at <= 'Z') || (*at >= 'a' && *at <= 'z'))) ++at;
    if (name == "POPEN") {
        // DC2
        if (!x.macro.printing.open && !x.reading.contour &&
            !x.core.port().print(x.core.view(), "\x12", true))
            return flow_fault(x, Alarm::OutputFile, begin, "POPEN");
        x.macro.printing.open = true;
        return Flow::Done;
    }
    if (!x.macro.printing.open) return flow_fault(x, Alarm::PrintClosed, begin, std::string(name));
    if (name == "PCLOS") {
        // DC4
        if (!x.reading.contour && !x.core.port().print(x.core.view(), "\x14", true))
            return flow_fault(x, Alarm::OutputFile, begin, "PCLOS");
        x.macro.printing.open = false;
        return Flow::Done;
    }
    x.macro.printing.blanks = !x.settings.print_compact;
    blanks(at, end);
    if (at == end || *at != '[') return flow_fault(x, Alarm::BracketMissing, begin);
    ++at;
    std::string text, shown;
    for (;;) {
        blanks(at, end);
        if (at == end) return flow_fault(x, Alarm::BracketMissing, begin);
        if (*at == ']') break;
        if (*at == '#') {
            const std::size_t before = text.size();
            if (const Flow flow = print_item(x, name[0] == 'B', at, end, text); flow != Flow::Done)
                return flow;
            if (name[0] == 'D')
                shown += text.substr(before);
            else
                for (std::size_t i = before; i < text.size(); ++i)
                    shown += fmt::format("\\{:02X}", static_cast<unsigned char>(text[i]));
            continue;
        }
        const char c = *at >= 'a' && *at <= 'z' ? static_cast<char>(*at - 32) : *at;
        if (!is_sent(c)) return flow_fault(x, Alarm::CharacterUnknown, at, std::string(1, c));
        text += c == '*' ? ' ' : c;
        shown += c == '*' ? ' ' : c;
        ++at;
    }
    ++at;
    x.core.mark_emitted();
    x.core.sink().print(shown, x.core.at);
    text += x.settings.print_line_end;
    if (x.settings.print_parity && name[0] == 'D')  // even parity in the highest bit
        for (char& c : text)
            c = static_cast<char>(
                static_cast<unsigned char>(c) |
                (__builtin_popcount(static_cast<unsigned char>(c) & 0x7Fu) & 1 ? 0x80u : 0u));
    if (!x.reading.contour && !x.core.port().print(x.core.view(), text, false))
        return flow_fault(x, Alarm::OutputFile, begin, std::string(name));
    return Flow::Done;
}

}  // namespace polyturn::channels::fanuc
