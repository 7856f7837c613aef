#include "kernel/supervisor/press/scope_words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string>

#include "kernel/supervisor/press/signal_words.hpp"

namespace polyturn::supervisor {
namespace {

struct Word {
    std::string_view name;
    ScopeKind kind;
    char letter;  // of the object; 0 none
};
constexpr Word kOf[] = {
    {"command", ScopeKind::AxisCommanded, 'A'},
    {"measured", ScopeKind::AxisMeasured, 'A'},
    {"error", ScopeKind::AxisError, 'A'},
    {"velocity", ScopeKind::AxisVelocity, 'A'},
    {"torque", ScopeKind::AxisTorque, 'A'},
    {"compensation", ScopeKind::AxisCompensation, 'A'},
    {"speed", ScopeKind::SpindleSpeed, 'S'},
    {"speed_command", ScopeKind::SpindleCommanded, 'S'},
    {"angle", ScopeKind::SpindleAngle, 'S'},
    {"deviation", ScopeKind::SpindleDeviation, 'S'},
    {"path", ScopeKind::PathSpeed, 'L'},
    {"left", ScopeKind::PathLeft, 'L'},
    {"off", ScopeKind::Off, 0},
};

std::string_view next_word(std::string_view& rest) {
    rest = trimmed(rest);
    const std::string_view out = rest.substr(0, rest.find_first_of(" \t"));
    rest = trimmed(rest.substr(out.size()));
    return out;
}

// A whole number from 0, -1: it is none.
std::int64_t whole(std::string_view text) {
    std::int64_t out = -1;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), out);
    return end.ec == std::errc() && end.ptr == text.data() + text.size() ? out : -1;
}

}  // namespace

Result<Command> parse_scope(std::string_view words, const MachineConfig& machine) {
    const Diagnosis wrong{
        Alarm::PressArgument,
        {},
        {},
        "'scope " + std::string(words) + "' is not of the form: " + std::string(kScopeShape)};
    std::string_view rest = words;
    const std::int64_t trace = whole(next_word(rest));
    const std::string_view what = next_word(rest);
    if (trace < 1 || trace > static_cast<std::int64_t>(kScopeTraces)) return wrong;
    Command command{};
    command.kind = static_cast<std::uint32_t>(CommandKind::Scope);
    command.flags = static_cast<std::uint32_t>(trace - 1);
    const auto records = [&](ScopeKind kind, std::int64_t object) {
        command.value = static_cast<double>(kind);
        command.object = static_cast<std::uint32_t>(object);
        return command;
    };
    if (what == "signal" && !rest.empty()) {
        const auto signal = parse_signal(rest);
        if (!signal) return signal.diagnosis();
        return records(
            signal->row->writer == SignalWriter::Plc ? ScopeKind::PlcSignal : ScopeKind::NcSignal,
            signal->slot());
    }
    if (what == "input") {
        const std::int64_t number = whole(rest);
        return number >= 0 && number < static_cast<std::int64_t>(kInputs)
                   ? Result<Command>(records(ScopeKind::Input, number))
                   : wrong;
    }
    const auto found = std::find_if(std::begin(kOf), std::end(kOf),
                                    [&](const Word& word) { return word.name == what; });
    if (found == std::end(kOf)) return wrong;
    if (!found->letter) return rest.empty() ? Result<Command>(records(found->kind, 0)) : wrong;
    if (rest.empty() || (rest[0] != found->letter && rest[0] != found->letter + 32)) return wrong;
    const std::int64_t number = whole(rest.substr(1));
    const bool exists =
        number >= 1 &&
        (found->letter == 'A' ? number <= static_cast<std::int64_t>(kMaxAxes) &&
                                    machine.axis(static_cast<std::uint32_t>(number)).exists()
         : found->letter == 'S' ? number <= static_cast<std::int64_t>(kMaxSpindles) &&
                                      machine.spindle(static_cast<std::uint32_t>(number)).exists()
                                : number <= static_cast<std::int64_t>(kMaxChannels) &&
                                      machine.channel(static_cast<std::uint32_t>(number)).exists());
    if (!exists)
        return Diagnosis{Alarm::PressArgument, {}, {}, "the machine has no " + std::string(rest)};
    return records(found->kind, number);
}

}  // namespace polyturn::supervisor
