#include "kernel/supervisor/press/press_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "ipc/model/machine/named_inputs.hpp"
#include "kernel/supervisor/press/signal_words.hpp"

namespace polyturn::supervisor {
std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> out;
    for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
        out.push_back(line.substr(at, end - at));
        at = end;
    }
    return out;
}

std::optional<double> number_of(std::string_view word) {
    if (!word.empty() && word[0] == '+') word.remove_prefix(1);
    double value = 0;
    const auto end = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end.ec != std::errc() || end.ptr != word.data() + word.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<bool> on_off(std::string_view word) {
    if (word == "on" || word == "1" || word == "true") return true;
    if (word == "off" || word == "0" || word == "false") return false;
    return std::nullopt;
}

int input_number(std::string_view words) {
    for (const std::string_view prefix : {std::string_view("input "), std::string_view("I")})
        if (words.substr(0, prefix.size()) == prefix) {
            const auto number = number_of(trimmed(words.substr(prefix.size())));
            if (number && *number >= 0 && *number < static_cast<double>(kInputs) &&
                *number == std::floor(*number))
                return static_cast<int>(*number);
        }
    // "SKIP", "XAE L2": inputs that every channel has
    const auto blank = words.find_first_of(" \t");
    const std::string_view name = words.substr(0, blank),
                           scope = blank == std::string_view::npos ? std::string_view("L1")
                                                                   : trimmed(words.substr(blank));
    if (std::find(kInputNames.begin(), kInputNames.end(), name) != kInputNames.end() &&
        scope.size() > 1 && scope[0] == 'L')
        if (const auto channel = number_of(scope.substr(1));
            channel && *channel >= 1 && *channel <= static_cast<double>(kMaxChannels))
            if (const auto input = input_by_name(name, static_cast<unsigned>(*channel)))
                return static_cast<int>(*input);
    return -1;
}

std::optional<ProgramInput> program_input(std::string_view words) {
    words = trimmed(words);
    const auto blank = words.find_first_of(" \t");
    std::string_view name = words.substr(0, blank);
    // sinumerik counts from 1
    const bool indexed = name.starts_with("$A_IN[") && name.ends_with(']');
    if (!indexed && !name.starts_with('#')) return std::nullopt;
    name = indexed ? name.substr(6, name.size() - 7) : name.substr(1);
    const double first = indexed ? 1 : 1000;
    const auto number = number_of(name);
    if (!number || *number < first || *number > first + 31 || *number != std::floor(*number))
        return std::nullopt;
    const std::string scope =
        blank == std::string_view::npos ? "L1" : std::string(trimmed(words.substr(blank)));
    const auto signal = parse_signal("CP_UIN " + scope);
    if (!signal) return std::nullopt;
    return ProgramInput{signal->slot(), static_cast<std::uint32_t>(*number - first) + 1};
}

Result<std::vector<Command>> drive_fault(std::string_view whom, std::string_view value,
                                         const MachineConfig& machine) {
    Command command{};
    command.kind = static_cast<std::uint32_t>(CommandKind::DriveFault);
    const char letter = whom.empty() ? '\0' : whom[0];
    const double wanted = whom.size() > 1 ? number_of(whom.substr(1)).value_or(0.0) : 0.0;
    const auto number = wanted >= 1 && wanted <= static_cast<double>(kMaxAxes)
                            ? static_cast<std::size_t>(wanted)
                            : std::size_t{0};
    const bool good =
        number != 0 &&
        ((letter == 'A' && machine.axis(number).exists()) ||
         (letter == 'S' && number <= kMaxSpindles && machine.spindle(number).exists()));
    if (!good)
        return Diagnosis{
            Alarm::PressArgument, {}, {}, fmt::format("the machine has no drive {}", whom)};
    command.object = static_cast<std::uint32_t>(number);
    command.flags = letter == 'S' ? 1 : 0;
    const auto cycles = [&](std::string_view word) {  // "delay 3"; 0: it is not that
        if (value.substr(0, word.size()) != word) return 0.0;
        const double n = number_of(trimmed(value.substr(word.size()))).value_or(0.0);
        return n == std::floor(n) && n >= 1 && n <= 60 ? n : 0.0;
    };
    // The values of POLYTURN_SIMULATE_... (kernel/drives/drive.h).
    if (value == "fault" || value == "1")
        command.value = 1.0;
    else if (value == "encoder")
        command.value = 2.0;
    else if (value == "silent")
        command.value = 3.0;
    else if (value == "dead")
        command.value = 4.0;
    else if (cycles("delay ") > 0)
        command.value = 0x100 + cycles("delay ");
    else if (cycles("loses ") > 0)
        command.value = 0x200 + cycles("loses ");
    else if (value != "ok" && value != "0")
        return Diagnosis{
            Alarm::PressArgument,
            {},
            {},
            "a drive is set to fault, encoder, silent, dead, 'delay N' or 'loses N' (1 to 60 "
            "cycles) or ok"};
    return std::vector<Command>{command};
}

}  // namespace polyturn::supervisor
