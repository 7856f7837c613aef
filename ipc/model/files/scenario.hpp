// What happens while a program runs (cli.md 5): stimuli at a time or after an event, in the file's
// order.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::text {

enum class StimulusKind { Press, Set, Release, Kill, Stop };

struct Stimulus {
    StimulusKind kind = StimulusKind::Press;
    // "feed_hold L2", "AP_SYNCR A3=1", "channel 2": still to be understood
    std::string words;
    std::optional<double> at_s;   // seconds since cycle start; or
    std::string when;             // a part of an event object, as JSON ...
    double after_s = 0.0;         // ... and seconds after it
    std::optional<double> for_s;  // Stop: continues after so many seconds
    Place place;                  // of the words
};

struct Scenario {
    std::string file;
    std::vector<Stimulus> stimuli;
};

Scenario parse_scenario(std::string_view content, std::string_view filename,
                        std::vector<Diagnosis>& diagnoses);
Result<Scenario> load_scenario(const std::string& path);

}  // namespace polyturn::text
