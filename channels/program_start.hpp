// How a program says which programs other channels shall run: the names of two signals
// (Sink::signal).
//   SELECT <channel> <file>   that channel runs this file when it is started next
//   START                     value: set of channels (bit 0 is channel 1) whose selected programs
//                             begin
#pragma once
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace polyturn::channels {

inline constexpr std::string_view kStartSignal = "START", kSelectSignal = "SELECT ";

struct ProgramSelection {
    unsigned channel = 0;
    std::string_view file;
};

inline std::string select_signal(unsigned channel, std::string_view file) {
    return std::string(kSelectSignal) + std::to_string(channel) + " " + std::string(file);
}

inline std::optional<ProgramSelection> selection_of(std::string_view signal) {
    if (!signal.starts_with(kSelectSignal)) return std::nullopt;
    signal.remove_prefix(kSelectSignal.size());
    ProgramSelection selection;
    const char* const end = signal.data() + signal.size();
    const char* const behind = std::from_chars(signal.data(), end, selection.channel).ptr;
    if (behind == end || *behind != ' ') return std::nullopt;
    selection.file = signal.substr(static_cast<std::size_t>(behind - signal.data()) + 1);
    return selection;
}

}  // namespace polyturn::channels
