// Event objects as text (cli.md 3): one JSON object a line, numbers with 6 decimals at the most.
#pragma once
#include <string>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

// Builds `{"ev":"...",...}` key by key.
class EventText {
public:
    explicit EventText(std::string_view ev);
    EventText& text(std::string_view key, std::string_view value);
    EventText& number(std::string_view key, double value);  // NaN becomes null
    EventText& raw(std::string_view key, std::string_view json);
    // The alarm's number: a number where it has only digits ("034" is 34), otherwise a text
    // ("PT0320").
    EventText& alarm_number(std::string_view value);
    std::string line() &&;  // with its end of line

private:
    void key(std::string_view name);
    std::string out_;
};

void append_json_text(std::string& out, std::string_view words);
void append_json_number(std::string& out, double value);

// The alarm event of a diagnosis; channel 0: none, seconds below 0: none.
std::string alarm_event(const Diagnosis& diagnosis, Dialect dialect, unsigned channel,
                        double seconds = -1.0);

// The value of "ev" of an event line, without parsing it: lines are made by our own programs and
// begin with it. {"ev":"machine","state":…,"text":…}: the machine is one step nearer to ready, or
// back. Without its end of line.
std::string machine_event(const KernelEvent& event);

std::string_view event_kind(std::string_view line);
// Events that --quiet leaves.
bool passes_quiet(std::string_view kind);

}  // namespace polyturn::supervisor
