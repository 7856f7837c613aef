#include "ipc/image/beside_step.hpp"
#include "kernel/supervisor/start_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ipc/diagnosis/tongue.hpp"
#include "ipc/machine/command_levels.hpp"
#include "ipc/machine/config_check.hpp"
#include "ipc/machine/job_differences.hpp"
#include "ipc/machine/machine_step.hpp"
#include "ipc/machine/store_requests.hpp"
#include "ipc/params/param_file.hpp"
#include "ipc/text/machine_path.hpp"
#include "kernel/supervisor/start_position.hpp"
#include "kernel/supervisor/event_text.hpp"
#include "kernel/supervisor/job_plan.hpp"

#include "kernel/supervisor/phrases.hpp"
#include "kernel/supervisor/reach.hpp"
#include "kernel/supervisor/refusal.hpp"
#include "kernel/supervisor/teach_thread.hpp"
#include "kernel/supervisor/press_words.hpp"
#include "kernel/supervisor/store_words.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::size_t kKeptAlarms = 1000;
constexpr std::size_t kMostDeaths = 5;  // of one process within kDeathWindow: then it stays dead
constexpr auto kDeathWindow = std::chrono::seconds(30);

void tell_words(const std::string& words) { std::fwrite(words.data(), 1, words.size(), stderr); }

}  // namespace

std::string default_store(const std::string& instance) {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state) return std::string(state) + "/polyturn/" + instance;
    const char* home = std::getenv("HOME");
    return std::string(home && *home ? home : "/var/lib") + "/.local/state/polyturn/" + instance;
}

StartSession::StartSession(const StartOptions& options, LoadedMachine machine, RequestServer server)
    : options_(options), loaded_(std::move(machine)), machine_(derive_machine_config(*loaded_.table)), server_(std::move(server)) {
    choose_tongue(params::get_text(*loaded_.table, params::pt_display_language));
    for (const Diagnosis& wrong : messages_.add_file((std::filesystem::path(loaded_.params_file).parent_path() / "messages.csv").string())) print_diagnosis(wrong, Dialect::Polyturn);
}

Dialect StartSession::dialect(unsigned channel) const {
    if (channel >= 1 && channel <= kMaxChannels && job_language_[channel - 1] != Dialect::Polyturn) return job_language_[channel - 1];
    return channel >= 1 && channel <= kMaxChannels ? dialect_of(language_of(*loaded_.table, channel)) : Dialect::Polyturn;
}

bool StartSession::runs(unsigned channel) const {
    const auto status = std::make_unique<MachineStatus>();
    if (channel < 1 || channel > kMaxChannels || !controller_->kernel().status.read(*status)) return false;
    const auto state = static_cast<ChannelState>(status->channels[channel - 1].state);
    return state == ChannelState::Running || state == ChannelState::Held || state == ChannelState::Waiting || state == ChannelState::ProgramStop;
}

Result<void> StartSession::launch() {
    ControllerPlan plan;
    plan.instance = options_.instance;
    plan.generation = generation_;
    plan.options.notes = 1;
    plan.options.parts = 1;
    for (auto& factor : plan.options.feed_override) factor = 1.0;
    if (const auto path = text::resolve_machine(options_.machine)) {
        plan.plc_library = path->plc;
        plan.drives_program = path->drives;
        tell_machine_files(path->params, plan.options);
    }
    if (!options_.machine.empty()) plan.machine_arguments = {"--machine", options_.machine};
    for (const auto& file : options_.param_files) plan.machine_arguments.insert(plan.machine_arguments.end(), {"--param-file", file});
    for (const auto& line : options_.sets) plan.machine_arguments.insert(plan.machine_arguments.end(), {"--set", line});
    const std::string store = options_.store.empty() ? default_store(options_.instance) : options_.store;
    std::error_code error;
    std::filesystem::create_directories(store, error);
    if (error) return Diagnosis{Alarm::OutputFile, {}, {}, fmt::format("{} ({})", store, error.message())};
    plan.store_arguments = {"--store", store};
    for (unsigned number = 1; number <= kMaxChannels; ++number)
        if (machine_.channel(number).exists()) plan.channels.push_back(number);
    controller_.reset();
    auto controller = Controller::start(std::move(plan));
    if (!controller) return controller.diagnosis();
    controller_ = std::move(*controller);
    log_ = std::make_unique<RingConsumer<RingHead<KernelEvent, 16384>>>(controller_->kernel().log, controller_->own().log_tail);
    joiner_ = {};
    asked_ = 0;
    kernel_dead_ = false;
    return {};
}

int StartSession::run() {
    if (auto launched = launch(); !launched) {
        if (end_requested()) return 0;  // asked to end while it started: nothing went wrong
        print_diagnosis(launched.diagnosis(), Dialect::Polyturn);
        return 1;
    }
    tell_words(fmt::format(fmt::runtime(say("polyturn: the controller \"{}\" runs with {} channels, {} axes, {} spindles. End it with Ctrl-C or SIGTERM.\n")), options_.instance,
                     machine_.channel_count, machine_.axis_count, machine_.spindle_count));
    if (!options_.no_hmi) screens_.open(options_.instance);
    server_.set_guests([this](std::int64_t uid) {
        const auto users = std::make_unique<UserTable>();
        if (!controller_->store().users.read(*users)) return false;
        const UserRow* const begin = users->rows.data();
        return std::any_of(begin, begin + std::min<std::size_t>(users->count, kUsers), [&](const UserRow& row) { return row.uid == uid; });
    });
    loop();
    screens_.close();
    keep_stops(stops_.close(utc_ms()));
    keep_alarms();
    controller_->stop(5'000);
    tell_words(fmt::format(fmt::runtime(say("polyturn: the controller \"{}\" has ended.\n")), options_.instance));
    return 0;
}

void StartSession::loop() {
    while (!end_requested() && !ask_to_end_) {
        controller_->beat();
        controller_->watch([this](std::size_t slot, int status) { process_died(slot, status); });
        drain();
        take_answers();
        watch_stops();
        revive();
        screens_.look();
        server_.serve(10, [this](RequestServer::Client client, const std::string& line) { handle(client, line); });
    }
}

void StartSession::drain() {
    bool moved = false;
    const auto notes = [&] {
        for (unsigned number = 1; number <= kMaxChannels; ++number) {
            const ChannelSegment* channel = controller_->channel(number);
            if (!channel) continue;
            NoteReader reader(channel->notes, controller_->own().note_tail[number - 1]);
            std::uint64_t note = 0;
            std::string_view words;
            while (reader.front(note, words)) joiner_.note(number, note, words), reader.pop(), moved = true;
        }
    };
    notes();
    while (const KernelEvent* event = log_->front()) {
        if (static_cast<KernelEventKind>(event->kind) == KernelEventKind::RecordBegin) notes();
        const KernelEvent copy = *event;
        log_->pop();
        moved = true;
        take(copy);
        controller_->own().log_seen.store(copy.seq, std::memory_order_release);
    }
    if (moved) controller_->own().bell.ring();
    joiner_.drain(1e300, [](const EventJoiner::Event&) {});
}

void StartSession::take(const KernelEvent& event) {
    const double t_s = static_cast<double>(event.tick) * static_cast<double>(controller_->kernel().tick_ns.load(std::memory_order_relaxed)) * 1e-9;
    switch (static_cast<KernelEventKind>(event.kind)) {
        case KernelEventKind::RecordBegin: {
            if (event.code == kStepHandedOver) {
                joiner_.hold(event.channel, event.note);
                break;
            }
            const std::string words(joiner_.begin(event.channel, event.note, t_s));
            const std::string_view kind = event_kind(words);
            if (kind == "alarm" || kind == "message") note_alarm(words, dialect(event.channel), true);
            break;
        }
        case KernelEventKind::RecordEnd:
            joiner_.end(event.channel, event.note, t_s);
            break;
        case KernelEventKind::CycleEnded:
            joiner_.close_channel(event.channel, t_s);
            break;
        case KernelEventKind::MachineState:
            std::fprintf(stderr, "%s\n", std::string(machine_step_text(static_cast<std::uint32_t>(event.code)).text).c_str());
            break;
        case KernelEventKind::Message:
        case KernelEventKind::Alarm: {
            if (event.code < 0) break;   // the program's own words: its note has told them
            Diagnosis diagnosis;
            diagnosis.alarm = event.code >= 0 && event.code < kAlarmCount ? static_cast<Alarm>(event.code) : Alarm::NoProgress;
            diagnosis.values[0] = event.value;
            diagnosis.detail = event.text.data();
            diagnosis.place.line = event.line;
            if (event.line) diagnosis.place.file = program_of(event);
            const bool builders = diagnosis.alarm == Alarm::BuilderMessage || diagnosis.alarm == Alarm::BuilderNote;
            const int number = static_cast<int>(event.value);
            if (builders) diagnosis.detail = messages_.explain(number, static_cast<text::MessageLanguage>(tongue_now()));
            print_diagnosis(diagnosis, dialect(event.channel));
            if (builders) diagnosis.detail = messages_.explain(number);   // logs are English
            std::string words = alarm_event(diagnosis, dialect(event.channel), event.channel, t_s);
            words.pop_back();
            if (builders && messages_.find(number) && words.back() == '}') words.insert(words.size() - 1, ",\"builder\":" + builder_words(number));
            note_alarm(std::move(words), dialect(event.channel), false);
            break;
        }
        default:
            break;
    }
}

// In which program the line of an event stands: the channel's last block knows it, a subprogram's perhaps; else the
// image does while it is still the running one, and the selected program is the best that is known.
std::string StartSession::program_of(const KernelEvent& event) const {
    if (std::string file = joiner_.file_of(event.channel, event.line); !file.empty()) return file;
    const ChannelSegment* channel = controller_->channel(event.channel);
    const auto names = std::make_unique<ProgramNames>();
    const auto status = std::make_unique<MachineStatus>();
    if (!channel || !channel->programs.read(*names) || names->count == 0 || !controller_->kernel().status.read(*status)) return {};
    const ChannelStatus& now = status->channels[event.channel - 1];
    const std::size_t file = now.line == event.line && now.file < std::min<std::uint64_t>(names->count, 32) ? now.file : 0;
    return &names->name[file * 256];
}

// The machine builder's message in every language: the screens show it in theirs, whichever the controller speaks.
std::string StartSession::builder_words(int number) const {
    static constexpr const char* kCodes[] = {"en", "ru", "cs", "hu"};
    Json out{{"told", messages_.explain(number)}};
    for (std::size_t i = 0; i < std::size(kCodes); ++i) {
        const auto language = static_cast<text::MessageLanguage>(i);
        out[kCodes[i]] = {{"text", messages_.explain(number, language, false)}, {"remedy", text::BuilderMessage::own(messages_.find(number)->remedy, language)}};
    }
    return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// The wall's time, and how many resets its channel has had: an alarm stands until the next one.
std::string StartSession::with_when(std::string event_text) const {
    if (event_text.empty() || event_text.back() != '}') return event_text;
    unsigned channel = 0;
    if (const auto at = event_text.find("\"ch\":"); at != std::string::npos) channel = static_cast<unsigned>(std::strtoul(event_text.c_str() + at + 5, nullptr, 10));
    event_text.pop_back();
    auto inputs = std::make_unique<PlcInputs>();
    if (channel >= 1 && channel <= kMaxChannels && controller_->kernel().plc_inputs.read(*inputs))
        event_text += fmt::format(",\"resets\":{}", inputs->signal[signals::cn_reset(channel)]);
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char written[32];
    std::strftime(written, sizeof written, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return event_text + ",\"utc\":\"" + written + "\"}";
}

void StartSession::note_alarm(std::string event_text, Dialect language, bool tell) {
    if (tell) print_alarm_event(event_text, language);
    if (const Json event = Json::parse(event_text.back() == '}' ? event_text : event_text + "}", nullptr, false); event.is_object() && event.value("severity", "") == "error")
        stops_.alarm(event.value("ch", 0u), event["number"].is_string() ? event["number"].get<std::string>() : event["number"].dump(), event.value("text", ""));
    alarms_.push_back(with_when(std::move(event_text)));
    if (alarms_.back().find("\"severity\":\"error\"") != std::string::npos || alarms_.back().find("\"severity\":\"warning\"") != std::string::npos) unkept_alarms_.push_back(alarms_.back());
    ++alarms_noted_;
    if (alarms_.size() > kKeptAlarms) alarms_.pop_front();
}

void StartSession::process_died(std::size_t slot, int status) {
    const Diagnosis diagnosis{Alarm::ProcessDied, {}, {}, fmt::format("the process {} {}", process_name(slot), describe_end(status))};
    print_diagnosis(diagnosis, Dialect::Polyturn);
    std::string words = alarm_event(diagnosis, Dialect::Polyturn, 0);
    words.pop_back();
    note_alarm(std::move(words), Dialect::Polyturn, false);
    auto& times = deaths_[slot];
    const auto now = Clock::now();
    while (!times.empty() && now - times.front() > kDeathWindow) times.pop_front();
    times.push_back(now);
    if (times.size() > kMostDeaths) {
        tell_words(fmt::format(fmt::runtime(say("polyturn: {} has died {} times in {} s and stays dead.\n")), process_name(slot), times.size(), kDeathWindow.count()));
        if (slot == kProcessKernel) ask_to_end_ = true;
        return;
    }
    if (slot == kProcessKernel)
        kernel_dead_ = true;
    else
        to_revive_.push_back(slot);
}

void StartSession::revive() {
    if (kernel_dead_) {
        // A new kernel makes a new generation: everybody else starts anew and attaches to it.
        generation_ = new_generation();
        to_revive_.clear();
        job_language_.fill(Dialect::Polyturn);   // nothing is selected any more
        for (const Waiting& one : std::exchange(waiting_, {})) server_.answer(one.client, refusal({Alarm::NotServed, {}, {}, "the machine was started anew"}));
        if (auto launched = launch(); !launched) {
            print_diagnosis(launched.diagnosis(), Dialect::Polyturn);
            ask_to_end_ = true;
        }
        return;
    }
    for (const std::size_t slot : std::exchange(to_revive_, {}))
        if (auto done = controller_->restart(slot); !done) print_diagnosis(done.diagnosis(), Dialect::Polyturn);
}

void StartSession::handle(RequestServer::Client client, const std::string& line) {
    const Json request = Json::parse(line, nullptr, false);
    if (request.is_discarded() || !request.is_object() || !request.contains("do") || !request["do"].is_string())
        return server_.answer(client, refusal({Alarm::PressUnknown, {}, {}, line.substr(0, 100)}));
    const std::string what = request["do"];
    const auto text_at = [&](const char* key) { return request.contains(key) && request[key].is_string() ? request[key].get<std::string>() : std::string(); };
    const Who who = who_asks(client, text_at("token"));
    if (what == "store") {
        const auto op = request.find("op");
        const std::string name = op != request.end() && op->is_object() && op->contains("do") && (*op)["do"].is_string() ? (*op)["do"].get<std::string>() : std::string();
        if (name == "stops.note" || name == "alarms.note") return server_.answer(client, refusal({Alarm::PressUnknown, {}, {}, name}));   // only from here
        return serve_operation(client, op != request.end() ? op->dump(-1, ' ', false, Json::error_handler_t::replace) : "{}", name == "users.login", who);
    }
    if (what == "logout") return server_.answer(client, access_.close(text_at("token")) ? R"({"ok":true})" : R"({"ok":true,"nobody":true})");
    if (what == "who") {
        return server_.answer(client, Json{{"ok", true}, {"name", who.name}, {"level", kLevelWords[static_cast<std::size_t>(who.level)]}}.dump());
    }
    if (what == "set" || what == "release" || what == "parameters")
        if (!may(client, who, UserLevel::Operator, what)) return;
    if (what == "press" && is_teach_thread(text_at("words"))) {
        if (!may(client, who, UserLevel::Operator, what)) return;
        const auto lines = teach_thread(text_at("words"), options_.instance);
        return lines ? serve_parameters(client, *lines, false, who) : server_.answer(client, refusal(lines.diagnosis()));
    }
    if (what == "press") {
        if (const auto reached = in_reach(text_at("words"), text_at("folder"), who.level); !reached) return server_.answer(client, refusal(reached.diagnosis()));
        const auto commands = parse_press(text_at("words"), machine_, text_at("folder"));
        // Refused before anything of it is kept: the parts wanted and the language would be those of the program that runs. A reset that was
        // pressed just before has some ticks to be seen.
        const auto meets_a_program = [&] {
            return commands && std::any_of(commands->begin(), commands->end(), [&](const Command& one) { return one.kind == static_cast<std::uint32_t>(CommandKind::Select) && runs(one.channel); });
        };
        for (int look = 0; look < 20 && meets_a_program(); ++look) sleep_ms(10);
        if (meets_a_program())
            return server_.answer(client, refusal({Alarm::NotReady, {}, {}, "another program is selected only in reset or after the end"}));
        const auto job = selected_job(text_at("words"), text_at("folder"));
        if (!serve_commands(client, commands, who, [&] { return job ? differences(*job) : std::vector<std::string>(); })) return;
        for (const Command& command : *commands)
            if (command.kind == static_cast<std::uint32_t>(CommandKind::Select)) job_language_[command.channel - 1] = static_cast<Dialect>(command.value);
        if (const auto lines = job ? parts_wanted(*job) : std::vector<std::string>(); !lines.empty()) serve_parameters(0, lines, false, who);
        return;
    }
    if (what == "release") return void(serve_commands(client, parse_release(text_at("words"), machine_), who));
    if (what == "set") {
        const auto commands = parse_set(text_at("words"), machine_);
        // A parameter is set when it is on disk, not when the kernel has heard of it.
        if (commands && commands->size() == 1 && commands->front().kind == static_cast<std::uint32_t>(CommandKind::SetParameter))
            return serve_parameters(client, {text_at("words")}, false, who);
        if (commands && commands->size() == 1 && commands->front().kind == static_cast<std::uint32_t>(CommandKind::StoreValue))
            return serve_value(client, store_request_of(commands->front()), who);
        return void(serve_commands(client, commands, who));
    }
    if (what == "parameters") {
        std::vector<std::string> lines;
        if (request.contains("lines") && request["lines"].is_array())
            for (const auto& one : request["lines"])
                if (one.is_string()) lines.push_back(one.get<std::string>());
        return serve_parameters(client, lines, request.value("import", false), who);
    }
    if (what == "alarms") {   // since: only those behind so many; `next` is what to ask with the next time
        const std::uint64_t since = request.contains("since") && request["since"].is_number_unsigned() ? request["since"].get<std::uint64_t>() : 0;
        const std::uint64_t first = alarms_noted_ - alarms_.size();
        std::string out = "{\"ok\":true,\"next\":" + std::to_string(alarms_noted_) + ",\"alarms\":[";
        const char* comma = "";
        for (std::uint64_t i = std::max(since, first); i < alarms_noted_; ++i, comma = ",") out += comma + alarms_[i - first];
        return server_.answer(client, out + "]}");
    }
    if (what == "end") {
        if (!may(client, who, UserLevel::Setter, what)) return;
        ask_to_end_ = true;
        return server_.answer(client, "{\"ok\":true}");
    }
    server_.answer(client, refusal({Alarm::PressUnknown, {}, {}, what}));
}

// Of `select`: the file that is named, and those that a job names. Asked before anything of them is read.
Result<void> StartSession::in_reach(std::string_view words, const std::string& folder, UserLevel level) const {
    const std::string named = selected_file(words, folder);
    if (named.empty()) return {};
    auto now = std::make_unique<params::Table>();   // PT_PROGRAM_FOLDERS may have changed since the start
    const bool known = controller_->store().parameters.read(*now);
    const Reach reach = reach_of(known ? *now : *loaded_.table, std::filesystem::path(loaded_.params_file).parent_path().string());
    if (auto good = reach.may_read(named, level); !good || !text::is_job_file(named)) return good;
    const auto job = text::load_job(named);
    if (!job) return {};   // told where it is carried out
    for (const auto& [channel, program] : job->programs)
        if (auto good = reach.may_read(program.file, level); !good) return good;
    return job->setup.empty() ? Result<void>() : reach.may_read(job->setup, level);
}

// What a job has otherwise than this controller, which goes on with its own.
std::vector<std::string> StartSession::differences(const text::Job& job) const {
    std::vector<std::string> out;
    const std::string base = std::filesystem::absolute(std::filesystem::path(loaded_.params_file).replace_extension()).string();
    if (for_another_machine(job, base)) out.push_back(fmt::format(fmt::runtime(say("the job is for the machine {}, and this controller runs {}")), job.machine, loaded_.params_file));
    text::Setup setup;
    if (!job.setup.empty()) {
        auto read = text::load_setup(job.setup);
        if (read) setup = std::move(*read);
        else out.push_back(text_in(read.diagnosis(), tongue_now()));
    }
    const auto store = std::make_unique<ChannelStore>();
    const StoreOf store_of = [&](unsigned channel) { return controller_->store().channels[channel - 1].read(*store) ? store.get() : nullptr; };
    for (const JobZero& zero : job_zeros(job, setup, machine_, store_of)) {
        if (zero.same()) continue;
        const std::string what = fmt::format("L{} {} {}", zero.channel, zero.system, zero.axis);
        out.push_back(std::isnan(zero.entered) ? fmt::format(fmt::runtime(say("the job has {} = {:.4f}, which this machine does not have")), what, zero.wanted)
                                               : fmt::format(fmt::runtime(say("the job has {} = {:.4f}, entered is {:.4f}, and that holds")), what, zero.wanted, zero.entered));
    }
    std::map<unsigned, std::string> others;   // the screens' sheet and `status` show the numbers
    for (const JobOffset& one : job_offsets(setup, machine_, store_of))
        if (!one.same()) others[one.channel] += (others[one.channel].empty() ? "" : ", ") + std::to_string(one.number);
    for (const auto& [channel, numbers] : others) out.push_back(fmt::format(fmt::runtime(say("L{}: other offsets than in the job's setup are entered, and those hold: {}")), channel, numbers));
    return out;
}

bool StartSession::serve_commands(RequestServer::Client client, const Result<std::vector<Command>>& commands, const Who& who, const std::function<std::vector<std::string>()>& notes) {
    if (!commands) return server_.answer(client, refusal(commands.diagnosis())), false;
    for (const Command& command : *commands)
        if (const UserLevel least = level_of(command); !may(client, who, least, std::string(level_words(command)))) return false;
    for (Command command : *commands) {
        command.level = static_cast<std::uint32_t>(who.level) + 1;
        command.user = who.user;
        controller_->send(command);
    }
    const auto told = notes ? notes() : std::vector<std::string>();   // may read files: behind the permission and what was wanted
    server_.answer(client, told.empty() ? std::string("{\"ok\":true}") : Json{{"ok", true}, {"notes", told}}.dump(-1, ' ', false, Json::error_handler_t::replace));
    return true;
}

// An offset or a zero: set when it is on disk.
void StartSession::serve_value(RequestServer::Client client, StoreRequest request, const Who& who) {
    request.level = static_cast<std::uint32_t>(who.level);
    request.user = who.user;
    if (!controller_->running(kProcessStore)) return server_.answer(client, refusal({Alarm::NotServed, {}, {}, "the store does not run"}));
    if (!controller_->ask_store(request)) return server_.answer(client, refusal({Alarm::NotServed, {}, {}, "the store does not answer"}));
    waiting_.push_back({client, ++asked_, {}, false, false, {}});
}

// Everything that is wrong with the lines; of an import also what they would make contradict itself.
std::vector<Diagnosis> StartSession::faults_of(const std::vector<std::string>& lines, bool import) const {
    std::vector<Diagnosis> out;
    std::vector<params::Assignment> assignments;
    for (const std::string& words : lines) {
        auto assignment = params::parse_assignment(words);
        if (!assignment) {
            out.push_back(assignment.diagnosis());
            out.back().detail += " (" + words + ")";
        } else if (words.size() >= sizeof(StoreRequest{}.name)) {
            out.push_back({Alarm::PressArgument, {}, {}, "the line is too long: " + words});
        } else {
            assignments.push_back(std::move(*assignment));
        }
    }
    if (!out.empty() || !import) return out;
    auto table = std::make_unique<params::Table>();
    if (!controller_->store().parameters.read(*table)) return out;
    const auto before = check_machine_config(*table);
    for (const params::Assignment& one : assignments)
        if (const auto done = params::apply(*table, {&one, 1}); !done) out.push_back(done.diagnosis());
    for (Diagnosis& wrong : check_machine_config(*table))
        if (wrong.severity() == Severity::Error && std::none_of(before.begin(), before.end(), [&](const Diagnosis& d) { return d.alarm == wrong.alarm && d.text() == wrong.text(); }))
            out.push_back(std::move(wrong));
    return out;
}

void StartSession::serve_parameters(RequestServer::Client client, const std::vector<std::string>& lines, bool import, const Who& who) {
    if (const auto faults = faults_of(lines, import); !faults.empty()) return server_.answer(client, refusal(faults));   // all or none
    if (!controller_->running(kProcessStore)) return server_.answer(client, refusal({Alarm::NotServed, {}, {}, "the store does not run"}));
    for (const std::string& words : lines) {
        StoreRequest request = parameter_request(words, &words != &lines.back());
        request.level = static_cast<std::uint32_t>(who.level);
        request.user = who.user;
        if (!push_request(request)) return server_.answer(client, refusal({Alarm::NotServed, {}, {}, "the store does not answer"}));
    }
    if (lines.empty()) return server_.answer(client, "{\"ok\":true}");
    waiting_.push_back({client, asked_, {}, false, false, {}});
}

}  // namespace polyturn::supervisor
