#include "kernel/supervisor/run/scenario_player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ipc/image/commands.hpp"
#include "ipc/image/segments.hpp"
#include "kernel/supervisor/press/press_words.hpp"
#include "kernel/supervisor/press/signal_words.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;

namespace {

constexpr double kTolerance = 0.001;  // of numbers in a `when`, as in the acceptance cases

// Every key of the part is in the event with the same value; objects likewise inside.
bool matches(const Json& part, const Json& event) {
    if (part.is_object()) {
        if (!event.is_object()) return false;
        for (auto it = part.begin(); it != part.end(); ++it) {
            const auto found = event.find(it.key());
            if (found == event.end() || !matches(it.value(), *found)) return false;
        }
        return true;
    }
    if (part.is_array()) {
        if (!event.is_array() || event.size() != part.size()) return false;
        for (std::size_t i = 0; i < part.size(); ++i)
            if (!matches(part[i], event[i])) return false;
        return true;
    }
    if (part.is_number())
        return event.is_number() &&
               std::abs(part.get<double>() - event.get<double>()) <= kTolerance;
    return part == event;
}

// Of a scenario, «mdi» means what the operator does until a block by hand runs (cli.md 8): the
// mode, the block alone in the list, the start; all in one tick.
std::vector<Command> spelled_out(const Command& command) {
    const auto kind = static_cast<CommandKind>(command.kind);
    if (kind != CommandKind::Mdi) return {command};
    std::vector<Command> out(4, Command{});
    for (Command& one : out) one.channel = command.channel;
    out[0].kind = static_cast<std::uint32_t>(CommandKind::Mode);
    out[0].value = static_cast<double>(ChannelMode::Mdi);
    out[0].flags = kStartByHand;
    out[1].kind = static_cast<std::uint32_t>(CommandKind::MdiClear);
    out[2] = command;
    out[3].kind = static_cast<std::uint32_t>(CommandKind::CycleStart);
    out[3].flags = kStartByHand;
    out[3].value = 1;
    return out;
}

struct When {
    Json part;
    double after_s = 0.0;
    bool happened = false;
    std::vector<Planned> planned;  // t_s relative to the event
};

}  // namespace

struct ScenarioPlayer::Parts {
    std::vector<Planned> timed;
    std::vector<When> whens;
    bool actions = false, cycle_start = false;
};

ScenarioPlayer::ScenarioPlayer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ScenarioPlayer::ScenarioPlayer(ScenarioPlayer&&) noexcept = default;
ScenarioPlayer& ScenarioPlayer::operator=(ScenarioPlayer&&) noexcept = default;
ScenarioPlayer::~ScenarioPlayer() = default;

std::optional<std::size_t> process_slot(std::string_view words) {
    words = trimmed(words);
    if (words == "kernel") return kProcessKernel;
    if (words == "plc") return kProcessPlc;
    if (words == "toolmgmt") return kProcessStore;
    if (words == "hmi") return kProcessHmi;
    if (words == "cell") return kProcessCell;
    if (words == "drives") return kProcessDrives;
    if (words.substr(0, 7) != "channel") return std::nullopt;
    words = trimmed(words.substr(7));
    if (!words.empty() && words[0] == 'L') words.remove_prefix(1);
    std::size_t number = 0;
    const auto end = std::from_chars(words.data(), words.data() + words.size(), number);
    if (end.ec != std::errc() || end.ptr != words.data() + words.size() || number < 1 ||
        number > kMaxChannels)
        return std::nullopt;
    return kProcessChannel + number - 1;
}

std::string process_name(std::size_t slot) {
    static constexpr const char* kNames[] = {"kernel", "plc", "toolmgmt", "hmi", "cell", "drives"};
    if (slot < std::size(kNames)) return kNames[slot];
    return fmt::format("channel {}", slot - kProcessChannel + 1);
}

std::optional<ScenarioPlayer> ScenarioPlayer::make(const text::Scenario& scenario,
                                                   const MachineConfig& machine,
                                                   std::vector<Diagnosis>& diagnoses) {
    auto parts = std::make_unique<Parts>();
    const std::string folder = std::filesystem::path(scenario.file).parent_path().string();
    const std::size_t faults_before = diagnoses.size();
    for (const text::Stimulus& stimulus : scenario.stimuli) {
        std::vector<Planned> planned;
        Result<std::vector<Command>> commands = std::vector<Command>{};
        switch (stimulus.kind) {
            case text::StimulusKind::Press:
                commands = parse_press(stimulus.words, machine, folder);
                break;
            case text::StimulusKind::Set:
                commands = parse_set(stimulus.words, machine);
                break;
            case text::StimulusKind::Release:
                commands = parse_release(stimulus.words, machine);
                break;
            case text::StimulusKind::Kill:
            case text::StimulusKind::Stop: {
                const auto slot = process_slot(stimulus.words);
                if (!slot) {
                    commands = Diagnosis{
                        Alarm::PressArgument,
                        {},
                        {},
                        fmt::format(
                            "'{}' is no process: channel L, plc, toolmgmt, hmi, cell, drives, "
                            "kernel",
                            stimulus.words)};
                    break;
                }
                const bool kill = stimulus.kind == text::StimulusKind::Kill;
                Planned one;
                one.command.kind = static_cast<std::uint32_t>(CommandKind::Action);
                one.action = ProcessAction{
                    kill ? ProcessAction::Kind::Kill : ProcessAction::Kind::Stop, *slot};
                if (stimulus.for_s && *slot == kProcessKernel) one.action->for_s = *stimulus.for_s;
                planned.push_back(one);
                if (stimulus.for_s && *slot != kProcessKernel) {
                    one.action->kind = ProcessAction::Kind::Continue;
                    one.t_s = *stimulus.for_s;
                    planned.push_back(one);
                }
                parts->actions = true;
                break;
            }
        }
        if (!commands) {
            Diagnosis diagnosis = commands.diagnosis();
            diagnosis.place = stimulus.place;
            diagnoses.push_back(std::move(diagnosis));
            continue;
        }
        for (const Command& pressed : *commands) {
            if (pressed.kind == static_cast<std::uint32_t>(CommandKind::CycleStart))
                parts->cycle_start = true;
            for (const Command& command : spelled_out(pressed)) {
                Planned one;
                one.command = command;
                planned.push_back(one);
            }
        }
        if (stimulus.at_s) {
            for (Planned& one : planned) {
                one.t_s += *stimulus.at_s;
                parts->timed.push_back(one);
            }
            continue;
        }
        When when;
        when.part = Json::parse(stimulus.when, nullptr, false);
        if (when.part.is_discarded() || !when.part.is_object()) {
            diagnoses.push_back(
                Diagnosis{Alarm::WhenIsNoObject, stimulus.place, {}, stimulus.when});
            continue;
        }
        when.after_s = stimulus.after_s;
        when.planned = std::move(planned);
        parts->whens.push_back(std::move(when));
    }
    if (diagnoses.size() != faults_before) return std::nullopt;
    return ScenarioPlayer(std::move(parts));
}

const std::vector<Planned>& ScenarioPlayer::timed() const { return parts_->timed; }
bool ScenarioPlayer::has_when() const { return !parts_->whens.empty(); }
bool ScenarioPlayer::has_actions() const { return parts_->actions; }
bool ScenarioPlayer::presses_cycle_start() const { return parts_->cycle_start; }

std::vector<Planned> ScenarioPlayer::match(std::string_view event_text, double t_s) {
    std::vector<Planned> out;
    if (!waits_for_events()) return out;
    const Json event = Json::parse(event_text, nullptr, false);
    if (event.is_discarded()) return out;
    for (When& when : parts_->whens) {
        if (when.happened || !matches(when.part, event)) continue;
        when.happened = true;
        for (Planned one : when.planned) {
            one.t_s += t_s + when.after_s;
            out.push_back(one);
        }
    }
    return out;
}

bool ScenarioPlayer::waits_for_events() const {
    return std::any_of(parts_->whens.begin(), parts_->whens.end(),
                       [](const When& when) { return !when.happened; });
}

std::set<unsigned> ScenarioPlayer::channels_not_waited_for() const {
    std::set<unsigned> out;
    const auto look = [&](const Planned& planned) {
        const Command& command = planned.command;
        const auto kind = static_cast<CommandKind>(command.kind);
        if (planned.action || command.value == 0.0) return;
        const std::uint32_t first = signals::cp_nowt(1);
        if (kind == CommandKind::IgnoreWaits && command.channel) out.insert(command.channel);
        if (kind == CommandKind::SetSignal && command.flags && command.object >= first &&
            command.object < first + kMaxChannels)
            out.insert(command.object - first + 1);
    };
    for (const Planned& planned : parts_->timed) look(planned);
    for (const When& when : parts_->whens)
        for (const Planned& planned : when.planned) look(planned);
    return out;
}

std::set<unsigned> ScenarioPlayer::channels_that_read() const {
    std::set<unsigned> out;
    const auto look = [&](const Planned& planned) {
        const auto kind = static_cast<CommandKind>(planned.command.kind);
        if (!planned.action && planned.command.channel &&
            (kind == CommandKind::Select || kind == CommandKind::Mdi ||
             kind == CommandKind::HandKey))
            out.insert(planned.command.channel);
    };
    for (const Planned& planned : parts_->timed) look(planned);
    for (const When& when : parts_->whens)
        for (const Planned& planned : when.planned) look(planned);
    return out;
}

}  // namespace polyturn::supervisor
