#include "kernel/supervisor/press/press_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>

#include "ipc/image/commands.hpp"
#include "ipc/params/param_file.hpp"
#include "ipc/model/files/job.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/press/press_targets.hpp"
#include "kernel/supervisor/press/scope_words.hpp"
#include "kernel/supervisor/press/signal_words.hpp"
#include "kernel/supervisor/press/store_words.hpp"

namespace polyturn::supervisor {

namespace {

using Commands = std::vector<Command>;

enum class Form {
    Alone,           // stop_after_part
    MaybeChannel,    // cycle_start, cycle_start L1, cycle_start 1, cycle_start T2 (machine group)
    Channel,         // return L1
    ChannelOnOff,    // single_block L1=on, single_block T2=on
    ChannelPercent,  // feed_override L1=50
    ChannelSeconds,  // warm_up L1=600
    SpindlePercent,  // spindle_override S1=80
    ChannelMode,     // mode L1=jog
    SkipLevel,       // block_skip L1=1
    Select,          // select L1=FILE, select JOB
    Block,           // mdi L1 G0 X50.
    Jog,             // jog A3+ 0.5s
    Step,            // step A3- 0.01
    Wheel,           // handwheel 1 A3 +120
    Reference,       // reference A3, reference all
    Restart,         // restart L1=N120 L2=N340
    Scope,           // scope 1 measured A3, scope 1 off
    Answer,          // answer L1 #500=12.5 #501=3 key=1
};

struct PressWord {
    std::string_view name;
    CommandKind kind;
    Form form;
    std::string_view shape;  // what a diagnosis shows
};

constexpr PressWord kWords[] = {
    {"cycle_start", CommandKind::CycleStart, Form::MaybeChannel, "cycle_start [L1|T1]"},
    {"feed_hold", CommandKind::FeedHold, Form::MaybeChannel, "feed_hold [L1|T1]"},
    {"reset", CommandKind::Reset, Form::MaybeChannel, "reset [L1|T1]"},
    {"emergency_stop", CommandKind::EmergencyStop, Form::Alone, "emergency_stop"},
    {"release_emergency_stop", CommandKind::ReleaseStop, Form::Alone, "release_emergency_stop"},
    {"machine_on", CommandKind::MachineOn, Form::Alone, "machine_on"},
    {"mode", CommandKind::Mode, Form::ChannelMode, "mode L1=auto|mdi|jog|handwheel|reference"},
    {"select", CommandKind::Select, Form::Select, "select L1=FILE or select NAME.job.toml"},
    {"mdi", CommandKind::Mdi, Form::Block,
     "mdi L1 G0 X50. (enters a block; cycle_start L1 runs it)"},
    {"mdi_clear", CommandKind::MdiClear, Form::Channel, "mdi_clear L1"},
    {"hand_key", CommandKind::HandKey, Form::Block,
     "hand_key L1 T0101 (a key that is a start: the block runs at once)"},
    {"jog", CommandKind::Jog, Form::Jog, "jog A3+ 0.5s"},
    {"step", CommandKind::Step, Form::Step, "step A3- 0.01"},
    {"handwheel", CommandKind::Handwheel, Form::Wheel,
     "handwheel 1 A3 +120 or handwheel 1 L1 +120 (time of its program)"},
    {"reference", CommandKind::Reference, Form::Reference, "reference A3 or reference all"},
    {"home", CommandKind::Reference, Form::Reference, "home A3 or home all"},
    {"feed_override", CommandKind::FeedOverride, Form::ChannelPercent, "feed_override L1=50"},
    {"override", CommandKind::FeedOverride, Form::ChannelPercent, "override L1=50"},
    {"rapid_override", CommandKind::RapidOverride, Form::ChannelPercent, "rapid_override L1=25"},
    {"spindle_override", CommandKind::SpindleOverride, Form::SpindlePercent,
     "spindle_override S1=80"},
    {"single_block", CommandKind::SingleBlock, Form::ChannelOnOff, "single_block L1=on"},
    {"optional_stop", CommandKind::OptionalStop, Form::ChannelOnOff, "optional_stop L1=on"},
    {"block_skip", CommandKind::BlockSkip, Form::SkipLevel,
     "block_skip L1=1 (level; -1 off; 0 all off)"},
    {"dry_run", CommandKind::DryRun, Form::ChannelOnOff, "dry_run L1=on"},
    {"machine_lock", CommandKind::MachineLock, Form::ChannelOnOff, "machine_lock L1=on"},
    {"restart", CommandKind::Restart, Form::Restart, "restart L1=N120 L2=N340"},
    {"retrace", CommandKind::Retrace, Form::ChannelOnOff, "retrace L1=on"},
    {"program_wheel", CommandKind::ProgramHandwheel, Form::ChannelOnOff, "program_wheel L1=on"},
    {"jog_in_hold", CommandKind::JogInHold, Form::Channel, "jog_in_hold L1"},
    {"return", CommandKind::Return, Form::Channel, "return L1"},
    {"ignore_waits", CommandKind::IgnoreWaits, Form::ChannelOnOff, "ignore_waits L2=on"},
    {"superpose", CommandKind::Superpose, Form::ChannelOnOff,
     "superpose L1=on (a handwheel adds its way to the running program)"},
    {"rapid_key", CommandKind::RapidKey, Form::ChannelOnOff, "rapid_key L1=on"},
    {"first_part", CommandKind::FirstPart, Form::ChannelOnOff, "first_part L1=on"},
    {"warm_up", CommandKind::WarmUp, Form::ChannelSeconds, "warm_up L1=600 (seconds; 0: none)"},
    {"scope", CommandKind::Scope, Form::Scope, kScopeShape},
    {"answer", CommandKind::DialogueKey, Form::Answer,
     "answer L1 [VARIABLE=VALUE ...] [key=NUMBER]"},
    {"stop_after_part", CommandKind::StopAfterPart, Form::Alone,
     "stop_after_part, stop_after_part off"},
};

// What a person can mean by one press. Beyond it is a slip of the hand or a program's mistake: it
// is refused before a machine hears of it.
constexpr double kLongestStep = 10'000;       // mm or degrees
constexpr double kLongestPress = 3'600;       // s
constexpr double kMostClicks = 100'000;       // of a handwheel, at once
constexpr double kLongestWarmUp = 86'400;     // s
constexpr double kHighestBlock = 99'999'999;  // N
constexpr double kHighestKey = 1'000'000;     // of a dialogue

// order of ChannelMode
constexpr std::string_view kModes[] = {"auto", "mdi", "jog", "handwheel", "reference"};

Diagnosis fault(Alarm alarm, std::string detail) {
    return Diagnosis{alarm, {}, {}, std::move(detail)};
}

Command command_of(CommandKind kind) {
    Command command{};
    command.kind = static_cast<std::uint32_t>(kind);
    return command;
}

// One press, with what it needs to know the machine's parts.
class Press {
public:
    Press(const PressWord& word, std::string_view rest, const MachineConfig& machine,
          const std::string& folder)
        : word_(word),
          rest_(trimmed(rest)),
          parts_(words_of(rest_)),
          machine_(machine),
          folder_(folder) {}

    Result<Commands> parse() {
        switch (word_.form) {
            case Form::Alone:
                if (word_.kind == CommandKind::StopAfterPart && parts_.size() == 1 &&
                    (parts_[0] == "on" || parts_[0] == "off"))
                    return one(command_of(word_.kind), parts_[0] == "on" ? 1.0 : 0.0);
                return parts_.empty() ? one(command_of(word_.kind), 1.0) : shape();
            case Form::MaybeChannel:
                return maybe_channel();
            case Form::Channel:
                return channel_only();
            case Form::ChannelOnOff:
                return each_assignment(
                    'L', [&](Command& c, std::string_view value) { return flag(c, value); });
            case Form::ChannelPercent:
                return each_assignment(
                    'L', [&](Command& c, std::string_view value) { return percent(c, value); });
            case Form::SpindlePercent:
                return each_assignment(
                    'S', [&](Command& c, std::string_view value) { return percent(c, value); });
            case Form::ChannelMode:
                return each_assignment(
                    'L', [&](Command& c, std::string_view value) { return mode(c, value); });
            case Form::ChannelSeconds:
                return each_assignment(
                    'L', [&](Command& c, std::string_view value) { return seconds(c, value); });
            case Form::SkipLevel:
                return each_assignment(
                    'L', [&](Command& c, std::string_view value) { return level(c, value); });
            case Form::Restart:
                return restart();
            case Form::Scope:
                return scope();
            case Form::Answer:
                return answer();
            case Form::Select:
                return select();
            case Form::Block:
                return block_of_text();
            case Form::Jog:
                return jog();
            case Form::Step:
                return step();
            case Form::Wheel:
                return wheel();
            case Form::Reference:
                return reference();
        }
        return shape();
    }

private:
    Diagnosis shape() const {
        return fault(Alarm::PressArgument,
                     fmt::format("'{} {}' is not of the form: {}", word_.name, rest_, word_.shape));
    }

    Diagnosis out_of_range(std::string_view what, double most, std::string_view unit) const {
        return fault(Alarm::PressArgument,
                     fmt::format("{} {}: {} is out of range (at most {:g}{}{})", word_.name, rest_,
                                 what, most, unit.empty() ? "" : " ", unit));
    }

    Result<Commands> one(Command command, double value) const {
        command.value = value;
        return Commands{command};
    }

    // "L2", "A3", "S1" or a bare number; 0 when it is none, or the machine has none such (then a
    // diagnosis is kept).
    std::uint32_t instance(std::string_view word, char letter) {
        if (!word.empty() && (word[0] == letter || word[0] == letter + 32)) word.remove_prefix(1);
        std::uint32_t number = 0;
        const auto end = std::from_chars(word.data(), word.data() + word.size(), number);
        if (end.ec != std::errc() || end.ptr != word.data() + word.size()) return 0;
        const bool exists =
            letter == 'L'
                ? number >= 1 && number <= kMaxChannels && machine_.channel(number).exists()
            : letter == 'A'
                ? number >= 1 && number <= kMaxAxes && machine_.axis(number).exists()
                : number >= 1 && number <= kMaxSpindles && machine_.spindle(number).exists();
        if (!exists) missing_ = fmt::format("the machine has no {}{}", letter, number);
        return exists ? number : 0;
    }
    // "T2": the channels of a machine group; none: it is no such word, or the machine has no such
    // group (then a diagnosis is kept).
    std::uint32_t group(std::string_view word, std::vector<std::uint32_t>& channels) {
        if (word.size() < 2 || (word[0] != 'T' && word[0] != 't')) return 0;
        std::uint32_t number = 0;
        const auto end = std::from_chars(word.data() + 1, word.data() + word.size(), number);
        if (end.ec != std::errc() || end.ptr != word.data() + word.size()) return 0;
        for (std::uint32_t l = 1; l <= kMaxChannels; ++l)
            if (machine_.channel(l).exists() && machine_.channel(l).group == number)
                channels.push_back(l);
        if (!channels.empty()) return number;
        missing_ = fmt::format("the machine has no group {}", word);
        return 0;
    }
    Diagnosis why() const {
        return missing_.empty() ? shape() : fault(Alarm::PressArgument, missing_);
    }

    Result<Commands> maybe_channel() {
        if (parts_.empty()) return one(command_of(word_.kind), 1.0);
        Commands out;
        for (const auto part : parts_) {
            Command command = command_of(word_.kind);
            std::vector<std::uint32_t> channels;
            if (const std::uint32_t number = group(part, channels)) {
                // A start is one command: the kernel knows which of them have something to begin,
                // and begins them in one tick.
                if (word_.kind == CommandKind::CycleStart) {
                    command.object = number;
                    channels = {0};
                }
                for (const std::uint32_t channel : channels) {
                    command.channel = channel;
                    out.push_back(command);
                }
                continue;
            }
            command.channel = instance(part, 'L');
            if (!command.channel) return why();
            out.push_back(command);
        }
        return out;
    }

    Result<Commands> channel_only() {
        if (parts_.size() != 1) return shape();
        Command command = command_of(word_.kind);
        command.channel = instance(parts_[0], 'L');
        if (!command.channel) return why();
        return Commands{command};
    }

    // "L1=on L2=off"; `take` fills in the value and says whether it was one.
    template <class Take>
    Result<Commands> each_assignment(char letter, Take take) {
        if (parts_.empty()) return shape();
        Commands out;
        for (const auto part : parts_) {
            const auto equals = part.find('=');
            if (equals == std::string_view::npos) return shape();
            Command command = command_of(word_.kind);
            const std::string_view whom = part.substr(0, equals);
            if (std::vector<std::uint32_t> channels;
                letter == 'L' && word_.form == Form::ChannelOnOff && group(whom, channels)) {
                if (!take(command, part.substr(equals + 1))) return shape();
                for (const std::uint32_t channel : channels) {
                    command.channel = channel;
                    out.push_back(command);
                }
                continue;
            }
            std::uint32_t number = 0;
            if (whom != "all") {
                number = instance(whom, letter);
                if (!number) return why();
            }
            (letter == 'S' ? command.object : command.channel) = number;
            if (!take(command, part.substr(equals + 1))) return shape();
            out.push_back(command);
        }
        return out;
    }

    static bool flag(Command& command, std::string_view value) {
        const auto on = on_off(value);
        command.value = on.value_or(false) ? 1.0 : 0.0;
        return on.has_value();
    }
    static bool seconds(Command& command, std::string_view value) {
        if (!value.empty() && value.back() == 's') value.remove_suffix(1);
        const auto number = number_of(value);
        command.value = number.value_or(0);
        return number.has_value() && *number >= 0 && *number <= kLongestWarmUp;
    }
    static bool percent(Command& command, std::string_view value) {
        if (!value.empty() && value.back() == '%') value.remove_suffix(1);
        const auto number = number_of(value);
        if (!number || *number < 0 || *number > 200) return false;
        command.value = *number / 100.0;
        return true;
    }
    static bool mode(Command& command, std::string_view value) {
        const auto found = std::find(std::begin(kModes), std::end(kModes), value);
        command.value = static_cast<double>(found - std::begin(kModes));
        return found != std::end(kModes);
    }
    static bool level(Command& command, std::string_view value) {
        // on, off: the plain "/"
        if (const auto on = on_off(value); on && value != "1" && value != "0") {
            command.flags = 1;
            command.value = *on ? 1.0 : 0.0;
            return true;
        }
        const auto number = number_of(value);
        if (!number || *number != std::floor(*number) || std::abs(*number) > 10) return false;
        command.flags = static_cast<std::uint32_t>(std::abs(*number));
        command.value = *number > 0 ? 1.0 : 0.0;
        return true;
    }
    static bool block(Command& command, std::string_view value) {
        if (!value.empty() && (value[0] == 'N' || value[0] == 'n')) value.remove_prefix(1);
        const auto number = number_of(value);
        if (!number || *number < 0 || *number > kHighestBlock || *number != std::floor(*number))
            return false;
        command.value = *number;
        return true;
    }

    // All that are named restart together: their waits are replayed.
    Result<Commands> restart() {
        auto out = each_assignment('L', [&](Command& c, std::string_view value) {
            return c.channel != 0 && block(c, value);
        });
        if (!out) return out;
        std::uint32_t set = 0;
        for (const Command& command : *out) set |= 1u << (command.channel - 1);
        for (Command& command : *out) command.flags = set;
        return out;
    }

    // What a dialogue of the program is answered: values of its fields, the key that ends it last.
    Result<Commands> answer() {
        constexpr std::size_t kMostAtOnce = 10;
        if (parts_.size() < 2) return shape();
        const std::uint32_t channel = instance(parts_[0], 'L');
        if (!channel) return why();
        if (parts_.size() - 1 > kMostAtOnce)
            return fault(Alarm::PressArgument,
                         fmt::format("more than {} answers at a time", kMostAtOnce));
        Commands out;
        for (std::size_t i = 1; i < parts_.size(); ++i) {
            const auto equals = parts_[i].rfind('=');
            if (equals == std::string_view::npos || equals == 0) return shape();
            const std::string_view name = parts_[i].substr(0, equals);
            const auto number = number_of(parts_[i].substr(equals + 1));
            const bool ends = name == "key";
            if (!number || (ends && (i + 1 != parts_.size() || *number < 1 ||
                                     *number > kHighestKey || *number != std::floor(*number))))
                return shape();
            Command command =
                command_of(ends ? CommandKind::DialogueKey : CommandKind::DialogueValue);
            command.channel = channel;
            command.value = *number;
            if (!ends && !put_text(command, name)) return too_long(name);
            out.push_back(command);
        }
        return out;
    }

    Result<Commands> scope() {
        const auto command = parse_scope(rest_, machine_);
        return command ? Result<Commands>(Commands{*command})
                       : Result<Commands>(command.diagnosis());
    }

    Result<Commands> select() {
        if (rest_.empty()) return shape();
        if (text::is_job_file(rest_)) {
            const auto job =
                text::load_job((std::filesystem::path(folder_) / std::string(rest_)).string());
            if (!job) return job.diagnosis();
            Commands out;
            for (const auto& [channel, program] : job->programs) {
                Command command = command_of(CommandKind::Select);
                command.channel = channel;
                if (channel > kMaxChannels || !machine_.channel(channel).exists())
                    return fault(Alarm::PressArgument,
                                 fmt::format("the machine has no L{}", channel));
                if (!put_text(command, program.file)) return path_too_long(program.file);
                const Dialect language =
                    program.language.empty() ? Dialect::Polyturn : dialect_of(program.language);
                if (!program.language.empty() && language == Dialect::Polyturn)
                    return Diagnosis{
                        Alarm::LanguageUnknown, {job->file, 0, 0, 0}, {}, program.language};
                command.value = static_cast<double>(language);
                out.push_back(command);
            }
            return out;
        }
        const auto equals = rest_.find('=');
        if (equals == std::string_view::npos) return shape();
        Command command = command_of(CommandKind::Select);
        command.channel = instance(trimmed(rest_.substr(0, equals)), 'L');
        if (!command.channel) return why();
        const std::string file =
            (std::filesystem::path(folder_) / std::string(trimmed(rest_.substr(equals + 1))))
                .string();
        if (!put_text(command, file)) return path_too_long(file);
        return Commands{command};
    }

    Result<Commands> block_of_text() {
        if (parts_.size() < 2) return shape();
        Command command = command_of(word_.kind);
        command.channel = instance(parts_[0], 'L');
        if (!command.channel) return why();
        const std::string_view block_text = trimmed(rest_.substr(parts_[0].size()));
        if (!put_text(command, block_text)) return too_long(block_text);
        return Commands{command};
    }

    static Diagnosis too_long(std::string_view what) {
        return fault(Alarm::PressArgument, fmt::format("longer than {} characters: {}",
                                                       sizeof(Command{}.text) - 1, what));
    }

    // By its end: the whole of it would leave no room for what to do.
    static Diagnosis path_too_long(const std::string& file) {
        return fault(Alarm::PathTooLong,
                     fmt::format("{} ({}, {})", std::filesystem::path(file).filename().string(),
                                 file.size(), sizeof(Command{}.text) - 1));
    }

    // "A3+" or "A3-".
    std::uint32_t signed_axis(std::string_view word, double& sign) {
        if (word.size() < 2 || (word.back() != '+' && word.back() != '-')) return 0;
        sign = word.back() == '+' ? 1.0 : -1.0;
        return instance(word.substr(0, word.size() - 1), 'A');
    }

    Result<Commands> jog() {
        double sign = 0;
        Command command = command_of(CommandKind::Jog);
        if (parts_.size() != 2) return shape();
        command.object = signed_axis(parts_[0], sign);
        if (!command.object) return why();
        std::string_view time = parts_[1];
        if (!time.empty() && time.back() == 's') time.remove_suffix(1);
        const auto seconds = number_of(time);
        if (!seconds || *seconds < 0) return shape();
        if (*seconds > kLongestPress) return out_of_range(time, kLongestPress, "s");
        return one(command, sign * *seconds);
    }

    Result<Commands> step() {
        double sign = 0;
        Command command = command_of(CommandKind::Step);
        if (parts_.size() != 2) return shape();
        command.object = signed_axis(parts_[0], sign);
        if (!command.object) return why();
        const auto distance = number_of(parts_[1]);
        if (!distance || *distance < 0) return shape();
        if (*distance > kLongestStep) return out_of_range(parts_[1], kLongestStep, "mm");
        return one(command, sign * *distance);
    }

    Result<Commands> wheel() {
        if (parts_.size() != 3) return shape();
        Command command = command_of(CommandKind::Handwheel);
        const auto number = number_of(parts_[0]), clicks = number_of(parts_[2]);
        if (!number || !clicks || *number < 1 || *number > 4 || *number != std::floor(*number))
            return shape();
        if (std::abs(*clicks) > kMostClicks) return out_of_range(parts_[2], kMostClicks, "");
        command.flags = static_cast<std::uint32_t>(*number);
        if (parts_[1][0] == 'L') {  // the time of its program
            command.channel = instance(parts_[1], 'L');
            return command.channel ? one(command, *clicks) : why();
        }
        command.object = instance(parts_[1], 'A');
        if (!command.object) return why();
        return one(command, *clicks);
    }

    Result<Commands> reference() {
        if (parts_.empty()) return shape();
        Commands out;
        for (const auto part : parts_) {
            Command command = command_of(CommandKind::Reference);
            if (part != "all") {
                command.object = instance(part, 'A');
                if (!command.object) return why();
            }
            out.push_back(command);
        }
        return out;
    }

    const PressWord& word_;
    std::string_view rest_;
    std::vector<std::string_view> parts_;
    const MachineConfig& machine_;
    const std::string& folder_;
    std::string missing_;
};

const PressWord* find_word(std::string_view name) {
    const auto found = std::find_if(std::begin(kWords), std::end(kWords),
                                    [&](const PressWord& word) { return word.name == name; });
    return found == std::end(kWords) ? nullptr : &*found;
}

}  // namespace

bool put_text(Command& command, std::string_view words) {
    if (words.size() >= command.text.size()) return false;
    command.text.fill(0);
    std::memcpy(command.text.data(), words.data(), words.size());
    return true;
}

std::vector<std::string_view> press_names() {
    std::vector<std::string_view> out;
    for (const PressWord& word : kWords) out.push_back(word.name);
    return out;
}

Result<Commands> parse_press(std::string_view words, const MachineConfig& machine,
                             const std::string& folder) {
    words = trimmed(words);
    const std::string_view name = words.substr(0, words.find_first_of(" \t"));
    const PressWord* word = find_word(name);
    if (!word) return fault(Alarm::PressUnknown, std::string(words));
    return Press(*word, words.substr(name.size()), machine, folder).parse();
}

namespace {
// What follows the name of the word, if the words are of that name.
std::optional<std::string_view> argument_of(std::string_view words, std::string_view wanted) {
    words = trimmed(words);
    const std::string_view name = words.substr(0, words.find_first_of(" \t"));
    return name == wanted ? std::optional(trimmed(words.substr(name.size()))) : std::nullopt;
}
}  // namespace

std::string selected_file(std::string_view words, const std::string& folder) {
    const auto selects = argument_of(words, "select");
    if (!selects) return {};
    std::string_view file = *selects;
    if (!text::is_job_file(file)) {
        const auto equals = file.find('=');
        if (equals == std::string_view::npos) return {};
        file = trimmed(file.substr(equals + 1));
    }
    return (std::filesystem::path(folder) / std::string(file)).string();
}

std::optional<text::Job> selected_job(std::string_view words, const std::string& folder) {
    const auto file = argument_of(words, "select");
    if (!file || !text::is_job_file(*file)) return std::nullopt;
    auto job = text::load_job((std::filesystem::path(folder) / std::string(*file)).string());
    return job ? std::optional(std::move(*job)) : std::nullopt;
}

std::vector<std::string> parts_wanted(const text::Job& job) {
    std::vector<std::string> lines;
    if (job.parts_wanted == 0) return lines;
    for (const auto& [channel, program] : job.programs)
        lines.push_back(fmt::format("N2308 L{}={}", channel, job.parts_wanted));
    return lines;
}

Result<Commands> parse_set(std::string_view words, const MachineConfig& machine) {
    words = trimmed(words);
    const auto equals = words.rfind('=');
    if (equals == std::string_view::npos)
        return fault(Alarm::PressArgument,
                     fmt::format("'{}' is not of the form: NAME [SCOPE]=VALUE", words));
    const std::string_view name = trimmed(words.substr(0, equals)),
                           value = trimmed(words.substr(equals + 1));
    if (name.substr(0, 7) == "offset " || name.substr(0, 5) == "zero ") {
        const auto command = parse_store_value(name, value, machine);
        return command ? Result<Commands>(Commands{*command})
                       : Result<Commands>(command.diagnosis());
    }
    if (name.substr(0, 6) == "drive ") return drive_fault(trimmed(name.substr(6)), value, machine);
    // Overrides and keys are set as well as pressed.
    if (const PressWord* word = find_word(name.substr(0, name.find_first_of(" \t")));
        word && name.find_first_of(" \t") != std::string_view::npos)
        return parse_press(words, machine);
    if (const int input = input_number(name); input >= 0) {
        const auto on = on_off(value);
        if (!on) return fault(Alarm::PressArgument, "an input is 0 or 1");
        Command command = command_of(CommandKind::SetInput);
        command.object = static_cast<std::uint32_t>(input);
        command.value = *on ? 1.0 : 0.0;
        return Commands{command};
    }
    if (const auto bit = program_input(name)) {
        const auto on = on_off(value);
        if (!on)
            return fault(Alarm::PressArgument,
                         fmt::format("{} is an input of the program: 0 or 1", name));
        Command command = command_of(CommandKind::SetSignal);
        command.object = bit->slot;
        command.channel = bit->bit;
        command.flags = kSlotOfPlc;
        command.value = *on ? 1.0 : 0.0;
        return Commands{command};
    }
    if (const auto signal = parse_signal(name);
        signal || signal.diagnosis().alarm != Alarm::SignalUnknown) {
        if (!signal) return signal.diagnosis();
        if (signal->row->kind == SignalKind::Double)
            return fault(
                Alarm::PressArgument,
                fmt::format("{} shows a parameter: set N1241 to N1272 instead", signal->row->name));
        const auto truth = on_off(value);
        const auto number = number_of(value);
        if (!number && !truth)
            return fault(Alarm::PressArgument,
                         fmt::format("{} is no value of {}", value, signal->row->name));
        if (number && std::abs(*number) > std::numeric_limits<std::int32_t>::max())
            return fault(Alarm::PressArgument,
                         fmt::format("{}: {} is out of range", signal->row->name, value));
        Command command = command_of(CommandKind::SetSignal);
        command.object = signal->slot();
        command.flags = signal->row->writer == SignalWriter::Plc ? kSlotOfPlc : kSlotOfNc;
        command.value = number ? *number : *truth ? 1.0 : 0.0;
        if (!signal->row->is_register && command.value != 0.0 && command.value != 1.0)
            return fault(Alarm::PressArgument,
                         fmt::format("{} is a flag: 0 or 1", signal->row->name));
        return Commands{command};
    }
    if (const auto assignment = params::parse_assignment(words); !assignment) {
        if (assignment.diagnosis().alarm == Alarm::ParamUnknown)
            return parse_signal(name).diagnosis();
        return assignment.diagnosis();
    }
    Command command = command_of(CommandKind::SetParameter);
    if (!put_text(command, words))
        return fault(Alarm::PressArgument,
                     fmt::format("longer than {} characters: {}", command.text.size() - 1, words));
    return Commands{command};
}

Result<Commands> parse_release(std::string_view words, const MachineConfig&) {
    words = trimmed(words);
    Command command = command_of(CommandKind::ReleaseSignal);
    if (const int input = input_number(words); input >= 0) {
        command.kind = static_cast<std::uint32_t>(CommandKind::SetInput);
        command.object = static_cast<std::uint32_t>(input);
        command.flags = 1;
        return Commands{command};
    }
    if (const auto bit = program_input(words)) {  // all of them: the PLC writes one register
        command.object = bit->slot;
        command.flags = kSlotOfPlc;
        return Commands{command};
    }
    const auto signal = parse_signal(words);
    if (!signal) return signal.diagnosis();
    command.object = signal->slot();
    command.flags = signal->row->writer == SignalWriter::Plc ? kSlotOfPlc : kSlotOfNc;
    return Commands{command};
}

}  // namespace polyturn::supervisor
