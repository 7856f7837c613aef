#include "kernel/supervisor/check/job_plan.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "ipc/diagnosis/display_language.hpp"
#include "ipc/model/languages/fagor_diameter.hpp"
#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/setup_text.hpp"
#include "kernel/supervisor/base/json_fields.hpp"
#include "kernel/supervisor/check/like.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/run/setup_sensors.hpp"

namespace polyturn::supervisor {

namespace {

// "2=fanuc": channel and rest; without a number the channel is 0. A file name may hold a '=' of its
// own.
std::pair<unsigned, std::string> program_of_channel(const std::string& words) {
    const auto at = words.find('=');
    if (at == std::string::npos || at == 0 || at > 2 ||
        words.find_first_not_of("0123456789") != at) {
        const bool letter = at != std::string::npos && at >= 2 && at <= 3 && words[0] == 'L' &&
                            words.find_first_not_of("0123456789", 1) == at;
        if (!letter) return {0, words};
        return {static_cast<unsigned>(std::stoul(words.substr(1, at - 1))), words.substr(at + 1)};
    }
    return {static_cast<unsigned>(std::stoul(words.substr(0, at))), words.substr(at + 1)};
}

class Planner {
public:
    Planner(const JobOptions& options, JobWork work, PlanFailure& failure)
        : options_(options), work_(work), failure_(failure) {}

    std::optional<JobPlan> plan() {
        programs();
        if (!load_machine_table()) return std::nullopt;
        languages();
        check_channels();
        load_setup();
        if (!failure_.diagnoses.empty()) return std::nullopt;
        return std::move(plan_);
    }

private:
    void fault(Alarm alarm, std::string detail, double value = 0.0, Place place = {}) {
        failure_.diagnoses.push_back(
            Diagnosis{alarm, std::move(place), {value, 0.0}, std::move(detail)});
    }

    void programs() {
        for (const std::string& argument : options_.programs) {
            if (text::is_job_file(argument)) {
                read_job(argument);
                continue;
            }
            auto [channel, file] = program_of_channel(argument);
            if (channel == 0) {
                channel = 1;
                while (plan_.programs.count(channel)) ++channel;
            }
            if (channel > kMaxChannels)
                fault(Alarm::SetupChannelUnknown, argument, channel);
            else if (plan_.programs.count(channel))
                fault(Alarm::ProgramArgument,
                      fmt::format("channel {} has two programs: {} and {}", channel,
                                  plan_.programs[channel].file, file));
            else
                plan_.programs[channel].file = file;
        }
    }

    void read_job(const std::string& path) {
        if (plan_.job) {
            fault(Alarm::ProgramArgument, "two jobs at once: " + path);
            return;
        }
        const auto content = text::read_text_file(path);
        if (!content) {
            failure_.diagnoses.push_back(content.diagnosis());
            return;
        }
        plan_.job = text::parse_job(*content, path, failure_.diagnoses);
        for (const auto& [channel, program] : plan_.job->programs) {
            if (plan_.programs.count(channel))
                fault(Alarm::ProgramArgument,
                      fmt::format("channel {} has a program from the job and one of its own",
                                  channel));
            plan_.programs[channel].file = read_instead(program.file);
            plan_.programs[channel].language = program.language;
            plan_.programs[channel].language_chosen = !program.language.empty();
        }
    }

    std::string read_instead(const std::string& file) const {
        std::error_code none;
        for (const std::string& one : options_.instead)
            if (const auto at = one.rfind('=');
                at != std::string::npos &&
                std::filesystem::equivalent(one.substr(0, at), file, none))
                return one.substr(at + 1);
        return file;
    }

    bool load_machine_table() {
        plan_.source.machine =
            options_.machine.empty() && plan_.job ? plan_.job->machine : options_.machine;
        plan_.source.param_files = options_.param_files;
        plan_.source.sets = options_.sets;
        if (!options_.like.empty() && !take_likeness()) return false;
        LoadedMachine loaded = load_machine(plan_.source);
        plan_.table = std::move(loaded.table);
        plan_.room_file = loaded.room_file;
        for (const Diagnosis& wrong : plan_.messages.add_file(
                 (std::filesystem::path(loaded.params_file).parent_path() / "messages.csv")
                     .string()))
            print_diagnosis(wrong, Dialect::Polyturn);
        if (!loaded.ok()) {
            // A contradiction (PT09xx) means that every line could be read: the machine is wrong,
            // not the input.
            const bool unreadable =
                !failure_.diagnoses.empty() ||
                std::any_of(loaded.diagnoses.begin(), loaded.diagnoses.end(),
                            [](const Diagnosis& d) {
                                return d.severity() == Severity::Error &&
                                       alarm_row(d.alarm).number[0].substr(0, 4) != "PT09";
                            });
            failure_.exit_status = unreadable ? 2 : 1;
            for (auto& diagnosis : loaded.diagnoses)
                failure_.diagnoses.push_back(std::move(diagnosis));
            return false;
        }
        // warnings
        for (const auto& diagnosis : loaded.diagnoses)
            print_diagnosis(diagnosis, Dialect::Polyturn);
        choose_display_language(params::get_text(*plan_.table, params::pt_display_language));
        plan_.machine = std::make_unique<MachineConfig>(derive_machine_config(*plan_.table));
        return true;
    }

    bool take_likeness() {
        auto like = values_of_controller(options_.like);
        if (!like) {
            failure_.diagnoses.push_back(like.diagnosis());
            return false;
        }
        const std::string path = in_memory("like.params", like->parameter_lines);
        plan_.source.param_files.insert(plan_.source.param_files.begin(), path);
        // PLC, machine model and messages too are those that would be driven with
        if (options_.machine.empty() && !like->machine.empty())
            plan_.source.machine = like->machine;
        like_ = std::move(like->setup);
        like_tools_ = std::move(like->tools);
        if (work_ == JobWork::Check)
            for (const auto& [channel, tools] : like_tools_) like_.channels[channel].tools = tools;
        return true;
    }

    // A file for the other processes that goes with this one.
    std::string in_memory(const char* name, const std::string& content) {
        const int fd = memfd_create(name, MFD_CLOEXEC);
        if (fd >= 0) plan_.memory_files.push_back(fd);
        if (fd < 0 ||
            write(fd, content.data(), content.size()) != static_cast<ssize_t>(content.size()))
            fault(Alarm::OutputFile, name);
        return fmt::format("/proc/{}/fd/{}", getpid(), fd);
    }

    void languages() {
        for (const std::string& option : options_.languages) {
            const auto [channel, name] = program_of_channel(option);
            if (dialect_of(name) == Dialect::Polyturn) {
                fault(Alarm::LanguageUnknown, option);
                continue;
            }
            for (unsigned number = 1; number <= kMaxChannels; ++number)
                if (channel == 0 || channel == number) plan_.chosen_languages[number] = name;
            for (auto& [number, program] : plan_.programs)
                if (channel == 0 || channel == number) {
                    program.language = name;
                    program.language_chosen = true;
                }
        }
        for (auto& [number, program] : plan_.programs) {
            if (program.language.empty()) program.language = language_of(*plan_.table, number);
            program.dialect = dialect_of(program.language);
            if (program.dialect == Dialect::Polyturn)
                fault(Alarm::LanguageUnknown, program.language);
        }
    }

    void check_channels() {
        for (const auto& [number, program] : plan_.programs)
            if (!plan_.machine->channel(number).exists())
                fault(Alarm::SetupChannelUnknown, program.file, number);
    }

    void load_setup() {
        std::string path = options_.setup;
        if (path.empty() && plan_.job) path = plan_.job->setup;
        if (!path.empty()) {
            const auto content = text::read_text_file(path);
            if (!content) {
                failure_.diagnoses.push_back(content.diagnosis());
                return;
            }
            plan_.setup = text::parse_setup(*content, path, failure_.diagnoses);
            plan_.setup_path = path;
        }
        for (const auto& [number, channel] : plan_.setup.channels)
            check_setup_axes(number, channel);
        check_sensors(plan_.setup, *plan_.machine, failure_.diagnoses);
        compare_tools();
        const bool job_zeros = plan_.job && !plan_.job->zeros.empty();
        if (!job_zeros && options_.like.empty()) return;
        // Zeros of the job and what --like copies come to the setup's; the other processes read the
        // whole from one file. The state of the controller that --like names is what would be
        // driven there, so the job's own files do not speak of it; a setup that the command line
        // names is said for this run.
        if (options_.setup.empty())
            for (const auto& [number, copied] : like_.channels) {
                text::ChannelSetup& own = plan_.setup.channels[number];
                own.work.clear();
                own.offsets.clear();
                if (like_tools_.count(number)) own.tools.clear();
                for (const auto& variable : copied.variables)
                    std::erase_if(own.variables,
                                  [&](const auto& one) { return one.name == variable.name; });
            }
        if (job_zeros)
            for (const auto& [number, systems] : plan_.job->zeros) {
                if (like_.channels.count(number)) continue;
                for (const auto& [system, axes] : systems)
                    for (const auto& [axis, value] : axes)
                        plan_.setup.channels[number].work[system].try_emplace(axis, value);
            }
        fill_up(plan_.setup, like_);
        plan_.setup_path = in_memory("setup.toml", text::setup_text(plan_.setup));
    }

    // What the job needs against what is mounted (the tools of the setup, or those of the
    // controller that --like names). Warnings: the operator may know better.
    void compare_tools() {
        if (!plan_.job) return;
        std::set<unsigned> unknown;
        for (const text::JobTool& wanted : plan_.job->tools) {
            const auto live = like_tools_.find(wanted.channel);
            const auto& tools = live != like_tools_.end() && options_.setup.empty()
                                    ? live->second
                                    : plan_.setup.channel(wanted.channel).tools;
            if (tools.empty()) {
                unknown.insert(wanted.channel);
                continue;
            }
            const auto mounted = tools.find(wanted.station);
            const std::string there = mounted == tools.end() ? std::string() : mounted->second.name;
            if (there == wanted.name) continue;
            tell_tool(Alarm::JobTool,
                      fmt::format("L{} T{}: \"{}\"{}", wanted.channel, wanted.station, wanted.name,
                                  there.empty() ? std::string() : fmt::format(" / \"{}\"", there)));
        }
        for (const unsigned channel : unknown)
            tell_tool(Alarm::JobToolsUnknown, fmt::format("L{}", channel));
    }
    void tell_tool(Alarm alarm, std::string detail) {
        const Diagnosis wrong{alarm, {plan_.job->file, 0, 0, 0}, {}, std::move(detail)};
        if (!options_.quiet || wrong.severity() != Severity::Message)
            print_diagnosis(wrong, Dialect::Polyturn);
    }

    void check_setup_axes(unsigned number, const text::ChannelSetup& channel) {
        const Place place{plan_.setup.file, 0, 0, 0};
        if (number > kMaxChannels || !plan_.machine->channel(number).exists()) {
            fault(Alarm::SetupChannelUnknown, {}, number, place);
            return;
        }
        const auto check = [&](const text::AxisValues& values, std::string_view what) {
            for (const auto& [axis, value] : values)
                if (!find_axis(*plan_.machine, number, axis))
                    fault(Alarm::SetupAxisUnknown,
                          fmt::format("channel {} has no axis {} ({})", number, axis, what), 0.0,
                          place);
        };
        check(channel.machine, "machine");
        check(channel.pos, "pos");
    }

    const JobOptions& options_;
    JobWork work_;
    PlanFailure& failure_;
    JobPlan plan_;
    text::Setup like_;
    std::map<unsigned, std::map<int, text::ToolSetup>> like_tools_;
};

}  // namespace

JobPlan::JobPlan(JobPlan&& other) noexcept
    : source(std::move(other.source)),
      table(std::move(other.table)),
      machine(std::move(other.machine)),
      room_file(std::move(other.room_file)),
      messages(std::move(other.messages)),
      programs(std::move(other.programs)),
      chosen_languages(std::move(other.chosen_languages)),
      setup(std::move(other.setup)),
      setup_path(std::move(other.setup_path)),
      job(std::move(other.job)),
      memory_files(std::exchange(other.memory_files, {})) {}

JobPlan::~JobPlan() {
    for (const int fd : memory_files) close(fd);
}

Dialect JobPlan::dialect(unsigned channel) const {
    const auto found = programs.find(channel);
    if (found != programs.end()) return found->second.dialect;
    if (const auto chosen = chosen_languages.find(channel); chosen != chosen_languages.end())
        return dialect_of(chosen->second);
    return channel >= 1 && channel <= kMaxChannels ? dialect_of(language_of(*table, channel))
                                                   : Dialect::Polyturn;
}

std::string JobPlan::started_language(unsigned channel, const PlannedProgram& by) const {
    if (const auto chosen = chosen_languages.find(channel); chosen != chosen_languages.end())
        return chosen->second;
    return by.language_chosen ? by.language : language_of(*table, channel);
}

bool JobPlan::shows_diameter(unsigned channel, const AxisConfig& axis) const {
    return dialect(channel) == Dialect::Fagor
               ? fagor_shows_diameter(*table, axis.number, axis.diameter)
               : axis.diameter;
}

std::vector<std::string> JobPlan::machine_arguments() const {
    std::vector<std::string> out;
    const auto add = [&](const char* option, const std::string& value) {
        out.push_back(option);
        out.push_back(value);
    };
    if (!source.machine.empty()) add("--machine", source.machine);
    for (const auto& file : source.param_files) add("--param-file", file);
    for (const auto& line : source.sets) add("--set", line);
    if (!setup_path.empty()) add("--setup", setup_path);
    return out;
}

std::optional<JobPlan> plan_job(const JobOptions& options, JobWork work, PlanFailure& failure) {
    return Planner(options, work, failure).plan();
}

std::string language_of(const params::Table& table, unsigned channel) {
    return std::string(params::get_text(table, params::pt_language, channel));
}

void print_diagnosis(const Diagnosis& diagnosis, Dialect dialect) {
    std::string content, line;
    if (diagnosis.place.line) {
        if (auto read = text::read_text_file(diagnosis.place.file)) content = std::move(*read);
        line = std::string(text::line_of(content, diagnosis.place.line));
    }
    const std::string rendered = render(diagnosis, dialect, line);
    std::fwrite(rendered.data(), 1, rendered.size(), stderr);
}

void print_alarm_event(std::string_view event_text, Dialect dialect) {
    const auto event = nlohmann::json::parse(event_text, nullptr, false);
    if (!event.is_object()) return;
    const std::string words = text_field(event, "text");
    std::string number = word_field(event, "number");
    if (dialect == Dialect::Fanuc && number.size() < 3 &&
        number.find_first_not_of("0123456789") == std::string::npos)
        number.insert(0, 3 - number.size(), '0');
    const std::string file = text_field(event, "file");
    const auto line = count_field(event, "line"),
               column = std::min(count_field(event, "column"), 10'000u);
    std::string out = file;
    if (line) out += fmt::format(":{}", line);
    if (column) out += fmt::format(":{}", column);
    if (out.empty() && event.contains("ch"))
        out = fmt::format(fmt::runtime(say("channel {}")), count_field(event, "ch"));
    const std::string severity = text_field(event, "severity", "error");
    const DisplayLanguage display_language = display_language_now();
    const std::string_view what = severity_word(
        text_field(event, "ev") == "message" || severity == "message" ? Severity::Message
        : severity == "warning"                                       ? Severity::Warning
                                                                      : Severity::Error,
        display_language);
    const auto told = retell(number, dialect, words, display_language);
    out += fmt::format("{}{}{}{}: {}\n", out.empty() ? "" : ": ", what, number.empty() ? "" : " ",
                       number, told ? told->text : retold_restart(words));
    if (line)
        if (const auto content = text::read_text_file(file)) {
            out += fmt::format("{:5} | {}\n", line, text::line_of(*content, line));
            if (column) out += fmt::format("      | {}^\n", std::string(column - 1, ' '));
        }
    const std::string remedy = told && display_language != DisplayLanguage::English
                                   ? std::string(told->remedy)
                                   : text_field(event, "remedy");
    if (!remedy.empty()) out += fmt::format("   {}\n", remedy);
    std::fwrite(out.data(), 1, out.size(), stderr);
}

}  // namespace polyturn::supervisor
