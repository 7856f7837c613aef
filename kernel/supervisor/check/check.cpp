#include "kernel/supervisor/check/check.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "ipc/model/languages/wait_name.hpp"
#include "ipc/model/files/read_file.hpp"
#include "kernel/supervisor/base/child.hpp"
#include "kernel/supervisor/base/event_text.hpp"
#include "kernel/supervisor/base/output.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/check/spindles_known.hpp"
#include "kernel/supervisor/check/wait_match.hpp"
#include "kernel/supervisor/run/scenario_player.hpp"

namespace polyturn::supervisor {

namespace {

// A program that runs round a wait for ever can only be followed so far once its partner has left
// it.
constexpr std::size_t kMostWaitsBehind = 10'000;
// of programs by programs, which may start each other for ever
constexpr std::size_t kMostStarts = 100;

// One channel's interpreter.
struct Interpreter {
    unsigned channel = 0;
    std::string file;
    Child child;
    std::string buffer;
    bool ended = false, alarmed = false, killed = false;
    // for people; an interpreter that refuses its input (status 2) has reported them itself
    std::string alarm_to_tell;
    std::size_t waits_behind = 0;

    // The next line without its end; false at the end of the output.
    bool read_line(std::string& line) {
        for (;;) {
            if (const auto end = buffer.find('\n', scanned); end != std::string::npos) {
                line.assign(buffer, start, end - start);
                scanned = start = end + 1;
                return true;
            }
            if (start > 0) {
                buffer.erase(0, start);
                start = 0;
            }
            scanned = buffer.size();
            char block[1 << 16];
            const auto got = read(child.output_fd(), block, sizeof block);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) break;
            buffer.append(block, static_cast<std::size_t>(got));
        }
        if (start >= buffer.size()) return false;
        line = buffer.substr(start);
        start = scanned = buffer.size();
        return true;
    }
    // With variables or offsets in common the order counts: it goes on when it is read next, the
    // others stand meanwhile.
    // `turning`: the spindles that others have started for certain, bit 0 is S1.
    void go(std::uint32_t turning) {
        release = fmt::format("go {}\n", turning);
        if (in_turn)
            due = true;
        else
            send();
    }
    void send() const {
        // it has ended: the next read says so
        if (write(child.input_fd(), release.data(), release.size()) < 0) {}
    }

    bool in_turn = false, due = false;
    std::string release = "go 0\n";
    WaitPoint stands_at;  // where it came to last
    // buffer: the next line begins at start; no end of line in [start, scanned)
    std::size_t start = 0, scanned = 0;
};

class CheckRun {
public:
    CheckRun(const JobOptions& options, JobPlan plan, std::set<unsigned> not_waited_for)
        : options_(options), plan_(std::move(plan)), not_waited_for_(std::move(not_waited_for)) {}

    int run() {
        if (plan_.programs.size() > 1 && shares_values()) make_shared_cells();
        for (const auto& [channel, program] : plan_.programs)
            if (!begin(channel, program)) return 2;
        interleave();
        if (interpreters_.size() > 1) {
            for (const WaitFault& fault : matcher_.find_faults()) report_fault(fault);
            const bool all_right = !alarms_;
            if (all_right)
                output_.write(
                    std::move(EventText("sync")
                                  .raw("ok", "true")
                                  .number("meetings", static_cast<double>(matcher_.meetings())))
                        .line());
        }
        output_.flush();
        return unreadable_ ? 2 : alarms_ ? 1 : 0;
    }

private:
    bool shares_values() const {
        bool any = params::get(*plan_.table, params::n1700_no_of_common_100) > 0 ||
                   params::get(*plan_.table, params::n1701_no_of_common_500) > 0 ||
                   params::get(*plan_.table, params::n1401_no_of_common_tool_offsets_m) > 0 ||
                   params::get(*plan_.table, params::n1412_no_of_common_tool_offsets_t) > 0;
        for (const auto& [channel, program] : plan_.programs)
            any = any || params::get(*plan_.table, params::f6036, channel) > 0 ||
                  params::get(*plan_.table, params::f6037, channel) > 0;
        return any;
    }
    // Empty variables (NaN) in a file without a name, which the interpreters map and lengthen by
    // the offsets.
    void make_shared_cells() {
        const int file = memfd_create("polyturn-variables", MFD_CLOEXEC);
        if (file < 0) return;
        const std::vector<double> cells(900, std::numeric_limits<double>::quiet_NaN());
        if (write(file, cells.data(), cells.size() * sizeof(double)) !=
            static_cast<ssize_t>(cells.size() * sizeof(double)))
            return;
        shared_path_ = fmt::format("/proc/{}/fd/{}", getpid(), file);
    }

    Result<Child> start(unsigned channel, const PlannedProgram& program) {
        std::vector<std::string> arguments = {"--check", "--channel", std::to_string(channel),
                                              "--language", program.language};
        for (auto& argument : plan_.machine_arguments()) arguments.push_back(std::move(argument));
        if (options_.variables) arguments.push_back("--variables");
        arguments.insert(arguments.end(), {"--most-blocks", std::to_string(options_.most_blocks)});
        if (!shared_path_.empty()) arguments.insert(arguments.end(), {"--shared", shared_path_});
        // no other channel can have started its spindle
        if (plan_.programs.size() == 1) arguments.push_back("--alone");
        arguments.push_back(program.file);
        return Child::start("polyturn-channel", arguments, {true, true});
    }

    bool begin(unsigned channel, const PlannedProgram& program) {
        auto started = start(channel, program);
        if (!started) {
            report(started.diagnosis(), Dialect::Polyturn, 0);
            return false;
        }
        Interpreter& interpreter = interpreters_[channel] = {};
        interpreter.channel = channel;
        interpreter.file = program.file;
        interpreter.child = std::move(*started);
        interpreter.in_turn = interpreter.due = !shared_path_.empty();
        matcher_.begin(channel);
        return true;
    }

    // INIT and START of a program. Without time a channel counts as running until its program has
    // been read to its end; one that is chosen meanwhile follows it.
    void note_selection(const Interpreter& by, const std::string& line) {
        const auto event = nlohmann::json::parse(line, nullptr, false);
        if (event.is_discarded()) return;
        const unsigned channel = event.value("channel", 0u);
        const auto planned = plan_.programs.find(channel),
                   starter = plan_.programs.find(by.channel);
        PlannedProgram& program = selected_[channel];
        program.file = event.value("program", "");
        program.language = planned != plan_.programs.end()
                               ? planned->second.language
                               : plan_.started_language(channel, starter != plan_.programs.end()
                                                                     ? starter->second
                                                                     : selected_[by.channel]);
        program.language_chosen = true;
        program.dialect = dialect_of(program.language);
    }
    void start_others(const std::string& line) {
        const auto event = nlohmann::json::parse(line, nullptr, false);
        const auto channels = event.find("channels");
        if (event.is_discarded() || channels == event.end()) return;
        for (const auto& one : *channels) {
            if (++starts_ > kMostStarts)
                return report(Diagnosis{Alarm::LoopEndless, {}, {}, {}}, Dialect::Polyturn,
                              one.get<unsigned>());
            const unsigned channel = one.get<unsigned>();
            const auto selected = selected_.find(channel);
            const auto planned = plan_.programs.find(channel);
            if (const auto runs = interpreters_.find(channel);
                runs != interpreters_.end() && !runs->second.ended) {
                if (selected != selected_.end() && selected->second.file != runs->second.file)
                    follows_.insert(channel);
            } else if (selected != selected_.end())
                begin(channel, selected->second);
            else if (planned != plan_.programs.end())
                begin(channel, planned->second);
            else
                report(Diagnosis{Alarm::FileUnreadable, {}, {}, "no program is selected"},
                       plan_.dialect(channel), channel);
        }
    }

    // In channel number order, each to its next wait; complete sets go on. When none can, the
    // rest is read without regard to waits, so that a fault is named with what follows it.
    void interleave() {
        bool behind = false;
        for (bool again = true; again;) {
            again = false;
            for (auto& [channel, interpreter] : interpreters_) {
                while (!interpreter.ended && (behind || !matcher_.stands(channel))) {
                    again = true;
                    to_next_wait(interpreter);
                    if (behind && !interpreter.ended) {
                        if (++interpreter.waits_behind > kMostWaitsBehind) {
                            interpreter.child.kill_and_reap();
                            interpreter.ended = interpreter.killed = true;
                            matcher_.end(channel, true);
                        } else {
                            let_go(interpreter);
                        }
                    } else if (!interpreter.ended && interpreters_.size() == 1) {
                        let_go(interpreter);
                        matcher_ = {};  // one program alone: no partner
                    }
                }
            }
            if (interpreters_.size() == 1) continue;
            if (behind) break;
            const auto released = matcher_.meet();
            for (const unsigned channel : released) learn_at_meeting(channel, released);
            for (const unsigned channel : released) let_go(interpreters_[channel]);
            again = again || !released.empty();
            if (!again) {
                for (auto& [channel, interpreter] : interpreters_)
                    if (!interpreter.ended) {
                        behind = true;
                        let_go(interpreter);
                    }
                again = behind;
            }
        }
    }

    void let_go(Interpreter& interpreter) {
        interpreter.go(spindles_.turning(interpreter.channel));
    }

    // All that were let go at the same wait have met there.
    void learn_at_meeting(unsigned channel, const std::vector<unsigned>& released) {
        const WaitPoint& here = interpreters_[channel].stands_at;
        std::vector<unsigned> together;
        for (const unsigned other : released)
            if (const WaitPoint& there = interpreters_[other].stands_at;
                there.code == here.code && there.set == here.set)
                together.push_back(other);
        spindles_.met(together);
    }

    void note_spindle(unsigned channel, const std::string& line) {
        const auto event = nlohmann::json::parse(line, nullptr, false);
        if (!event.is_object()) return;
        const auto mode = event.find("mode");
        const bool speed = mode != event.end() && (*mode == "rpm" || *mode == "css");
        const auto spindle = event.find("spindle");
        if (spindle != event.end() && spindle->is_number_unsigned())
            spindles_.commanded(channel, spindle->get<unsigned>(),
                                speed && event.contains("direction"));
    }

    void to_next_wait(Interpreter& interpreter) {
        if (interpreter.due) {
            interpreter.send();
            interpreter.due = false;
        }
        std::string line;
        while (interpreter.read_line(line)) {
            if (line.empty()) continue;
            const std::string_view kind = event_kind(line);
            if (!options_.quiet || passes_quiet(kind)) {
                output_.write(line);
                output_.write("\n");
            }
            tell_alarm(interpreter);
            if (kind == "alarm") note_alarm(interpreter, line);
            if (kind == "marker") {
                const auto event = nlohmann::json::parse(line, nullptr, false);
                if (!event.is_discarded() && event.value("value", 0) != 0)
                    matcher_.mark(interpreter.channel, event.value("code", -1));
            }
            if (kind == "select") note_selection(interpreter, line);
            if (kind == "start") start_others(line);
            if (kind == "spindle") note_spindle(interpreter.channel, line);
            if (kind == "wait") {
                interpreter.stands_at = wait_point(interpreter.channel, line);
                matcher_.arrive(interpreter.channel, interpreter.stands_at);
                return;
            }
        }
        interpreter.ended = true;
        interpreter.child.close_input();
        interpreter.child.end_within(10'000);
        const int status = interpreter.child.status();
        if (status < 0 || status > 2) {
            report(Diagnosis{Alarm::ProcessDied,
                             {},
                             {},
                             fmt::format("the interpreter of channel {} {}", interpreter.channel,
                                         describe_end(status))},
                   Dialect::Polyturn, interpreter.channel);
            interpreter.alarmed = true;
        }
        if (status == 2)
            unreadable_ = true;
        else
            tell_alarm(interpreter);
        if (status != 0) ++alarms_;
        matcher_.end(interpreter.channel, interpreter.alarmed || status != 0);
        if (follows_.erase(interpreter.channel))
            begin(interpreter.channel, selected_.at(interpreter.channel));
    }

    void tell_alarm(Interpreter& interpreter) {
        if (interpreter.alarm_to_tell.empty()) return;
        output_.flush();  // in the right order where both go to one screen
        print_alarm_event(interpreter.alarm_to_tell, plan_.dialect(interpreter.channel));
        interpreter.alarm_to_tell.clear();
    }

    void note_alarm(Interpreter& interpreter, const std::string& line) {
        interpreter.alarm_to_tell = line;
        if (line.find("\"severity\":\"error\"") == std::string::npos) return;
        interpreter.alarmed = true;
        ++alarms_;
    }

    WaitPoint wait_point(unsigned channel, const std::string& line) {
        WaitPoint wait;
        const auto event = nlohmann::json::parse(line, nullptr, false);
        if (event.is_discarded()) return wait;
        if (const auto code = event.find("code"); code != event.end()) {
            if (code->is_string()) {
                wait.written = code->get<std::string>();
                wait.code = wait_code_of(wait.written).value_or(0);
            } else if (code->is_number_integer()) {
                wait.code = code->get<std::int32_t>();
                wait.written = wait_name(
                    waits_at_markers(channel) ? Dialect::Sinumerik : Dialect::Fanuc, wait.code);
            }
        }
        if (const auto channels = event.find("channels");
            channels != event.end() && channels->is_array())
            for (const auto& one : *channels)
                if (one.is_number_integer() && one.get<int>() >= 1 &&
                    one.get<int>() <= static_cast<int>(kMaxChannels))
                    wait.set |= 1u << (one.get<int>() - 1);
        // For whom the scenario says that nobody waits, neither does he: the wait is his alone and
        // passes at once.
        if (not_waited_for_.count(channel)) wait.set = 1u << (channel - 1);
        for (const unsigned other : not_waited_for_)
            if (other != channel) wait.set &= ~(1u << (other - 1));
        wait.file = event.value("file", "");
        wait.line = event.value("line", 0u);
        return wait;
    }

    // The others number their waits as M codes.
    bool waits_at_markers(unsigned channel) const {
        const auto selected = selected_.find(channel);
        return (plan_.programs.count(channel) || selected == selected_.end()
                    ? plan_.dialect(channel)
                    : selected->second.dialect) == Dialect::Sinumerik;
    }

    void report(const Diagnosis& diagnosis, Dialect dialect, unsigned channel) {
        print_diagnosis(diagnosis, dialect);
        output_.write(alarm_event(diagnosis, dialect, channel));
        ++alarms_;
    }

    // Both programs with their lines, because the mistake may stand in either.
    void report_fault(const WaitFault& fault) {
        const Dialect dialect = plan_.dialect(fault.channel);
        output_.write(alarm_event(fault.diagnosis, dialect, fault.channel));
        ++alarms_;
        std::string out = render(fault.diagnosis, dialect, {});
        const auto remedy_at = out.find('\n');
        std::string places;
        for (const auto& [channel, wait] : fault.places) {
            const auto content = text::read_text_file(wait.file);
            places += fmt::format(
                "   channel {}, {}:{}\n{:5} | {}\n", channel, wait.file, wait.line, wait.line,
                content ? text::line_of(*content, wait.line) : std::string_view());
        }
        out.insert(remedy_at + 1, places);
        std::fwrite(out.data(), 1, out.size(), stderr);
    }

    const JobOptions& options_;
    JobPlan plan_;
    std::set<unsigned> not_waited_for_;
    std::map<unsigned, Interpreter> interpreters_;
    std::map<unsigned, PlannedProgram> selected_;  // by INIT
    // channels that begin it when what they run has ended
    std::set<unsigned> follows_;
    WaitMatcher matcher_;
    SpindlesKnown spindles_;
    Output output_;
    std::string shared_path_;
    std::size_t alarms_ = 0, starts_ = 0;
    bool unreadable_ = false;
};

}  // namespace

int check_programs(const JobOptions& options) {
    PlanFailure failure;
    auto plan = plan_job(options, JobWork::Check, failure);
    std::set<unsigned> not_waited_for;
    if (plan && !options.scenario.empty()) {
        const auto scenario = text::load_scenario(options.scenario);
        if (!scenario)
            failure.diagnoses.push_back(scenario.diagnosis());
        else if (const auto player =
                     ScenarioPlayer::make(*scenario, *plan->machine, failure.diagnoses))
            not_waited_for = player->channels_not_waited_for();
    }
    if (!failure.diagnoses.empty()) {
        Output output;
        for (const Diagnosis& diagnosis : failure.diagnoses) {
            print_diagnosis(diagnosis, Dialect::Polyturn);
            output.write(alarm_event(diagnosis, Dialect::Polyturn, 0));
        }
        return failure.exit_status;
    }
    return CheckRun(options, std::move(*plan), std::move(not_waited_for)).run();
}

}  // namespace polyturn::supervisor
