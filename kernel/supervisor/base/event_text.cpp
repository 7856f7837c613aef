#include "kernel/supervisor/base/event_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "ipc/model/machine/machine_step.hpp"

namespace polyturn::supervisor {

void append_json_text(std::string& out, std::string_view words) {
    out += '"';
    for (const char c : words) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n')
            out += "\\n";
        else if (c == '\t')
            out += "\\t";
        else if (byte < 0x20)
            fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(byte));
        else
            out += c;
    }
    out += '"';
}

void append_json_number(std::string& out, double value) {
    if (!std::isfinite(value)) {
        out += "null";
        return;
    }
    char buffer[64];
    const double rounded = std::round(value * 1e6) / 1e6;
    if (std::abs(value) >= 1e15) {
        const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
        out.append(buffer, end.ptr);
        return;
    }
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, rounded == 0.0 ? 0.0 : rounded,
                                   std::chars_format::fixed, 6);
    std::string_view digits(buffer, static_cast<std::size_t>(end.ptr - buffer));
    while (digits.back() == '0') digits.remove_suffix(1);
    if (digits.back() == '.') digits.remove_suffix(1);
    out += digits;
}

EventText::EventText(std::string_view ev) : out_("{") { text("ev", ev); }

void EventText::key(std::string_view name) {
    if (out_.size() > 1) out_ += ',';
    out_ += '"';
    out_ += name;
    out_ += "\":";
}

EventText& EventText::text(std::string_view name, std::string_view value) {
    key(name);
    append_json_text(out_, value);
    return *this;
}

EventText& EventText::number(std::string_view name, double value) {
    key(name);
    append_json_number(out_, value);
    return *this;
}

EventText& EventText::raw(std::string_view name, std::string_view json) {
    key(name);
    out_ += json;
    return *this;
}

EventText& EventText::alarm_number(std::string_view value) {
    const bool digits = !value.empty() && value.size() < 10 &&
                        value.find_first_not_of("0123456789") == std::string_view::npos;
    if (!digits) return text("number", value);
    const auto first = value.find_first_not_of('0');
    return raw("number", first == std::string_view::npos ? "0" : value.substr(first));
}

std::string EventText::line() && {
    out_ += "}\n";
    return std::move(out_);
}

std::string alarm_event(const Diagnosis& diagnosis, Dialect dialect, unsigned channel,
                        double seconds) {
    EventText event(diagnosis.severity() == Severity::Message ? "message" : "alarm");
    if (channel) event.number("ch", channel);
    if (seconds >= 0) event.number("t", seconds);
    if (!diagnosis.place.file.empty()) event.text("file", diagnosis.place.file);
    if (diagnosis.place.line) event.number("line", diagnosis.place.line);
    if (diagnosis.place.column) event.number("column", diagnosis.place.column);
    if (diagnosis.severity() != Severity::Message)
        event.alarm_number(alarm_number(diagnosis.alarm, dialect));
    event.text("text", diagnosis.text());
    if (diagnosis.severity() != Severity::Message)
        event.text("severity", diagnosis.severity() == Severity::Error ? "error" : "warning");
    if (!diagnosis.remedy().empty()) event.text("remedy", diagnosis.remedy());
    return std::move(event).line();
}

std::string machine_event(const KernelEvent& event) {
    const MachineStepText& step = machine_step_text(static_cast<std::uint32_t>(event.code));
    EventText text("machine");
    text.text("state", step.name).text("text", step.text);
    if (!step.next.empty()) text.text("remedy", step.next);
    std::string line = std::move(text).line();
    line.pop_back();
    return line;
}

std::string_view event_kind(std::string_view line) {
    constexpr std::string_view kKey = "\"ev\":\"";
    const auto at = line.find(kKey);
    if (at == std::string_view::npos) return {};
    const auto from = at + kKey.size();
    const auto to = line.find('"', from);
    return to == std::string_view::npos ? std::string_view() : line.substr(from, to - from);
}

bool passes_quiet(std::string_view kind) {
    return kind == "alarm" || kind == "message" || kind == "summary" || kind == "sync";
}

}  // namespace polyturn::supervisor
