#include "kernel/supervisor/start/start_session.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ipc/diagnosis/display_language.hpp"
#include "ipc/image/positioning_step.hpp"
#include "ipc/model/machine/machine_step.hpp"
#include "ipc/model/files/machine_path.hpp"
#include "kernel/supervisor/base/event_text.hpp"
#include "kernel/supervisor/base/json_fields.hpp"
#include "kernel/supervisor/base/refusal.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/run/start_position.hpp"
#include "kernel/supervisor/take_notes.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::size_t kKeptAlarms = 1000;
constexpr std::size_t kMostDeaths = 5;  // of one process within kDeathWindow: then it stays dead
constexpr auto kDeathWindow = std::chrono::seconds(30);
// then the kernel is killed, and so is the store (docs: operator, "end")
constexpr int kEndTimeout_ms = 5'000;
constexpr auto kLastWords = std::chrono::seconds(2);  // for the store, before it is asked to end
constexpr int kNice = -10;                            // of this thread alone
constexpr auto kEventsAtOnce = std::chrono::milliseconds(2);

void tell_words(const std::string& words) { std::fwrite(words.data(), 1, words.size(), stderr); }

}  // namespace

std::string default_store(const std::string& instance) {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state)
        return std::string(state) + "/polyturn/" + instance;
    const char* home = std::getenv("HOME");
    return std::string(home && *home ? home : "/var/lib") + "/.local/state/polyturn/" + instance;
}

StartSession::StartSession(const StartOptions& options, LoadedMachine machine, RequestServer server)
    : options_(options),
      loaded_(std::move(machine)),
      machine_(derive_machine_config(*loaded_.table)),
      shared_machine_(std::make_shared<const MachineConfig>(machine_)),
      server_(std::move(server)) {
    choose_display_language(params::get_text(*loaded_.table, params::pt_display_language));
    for (const Diagnosis& wrong : messages_.add_file(
             (std::filesystem::path(loaded_.params_file).parent_path() / "messages.csv").string()))
        print_diagnosis(wrong, Dialect::Polyturn);
}

Dialect StartSession::dialect(unsigned channel) const {
    if (channel >= 1 && channel <= kMaxChannels && job_language_[channel - 1] != Dialect::Polyturn)
        return job_language_[channel - 1];
    return channel >= 1 && channel <= kMaxChannels
               ? dialect_of(language_of(*loaded_.table, channel))
               : Dialect::Polyturn;
}

bool StartSession::runs(unsigned channel) const {
    const auto status = std::make_unique<MachineStatus>();
    if (channel < 1 || channel > kMaxChannels || !controller_->kernel().status.read(*status))
        return false;
    const auto state = static_cast<ChannelState>(status->channels[channel - 1].state);
    return state == ChannelState::Running || state == ChannelState::Held ||
           state == ChannelState::Waiting || state == ChannelState::ProgramStop;
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
        set_machine_files(path->params, plan.options);
    }
    if (!options_.machine.empty()) plan.machine_arguments = {"--machine", options_.machine};
    for (const auto& file : options_.param_files)
        plan.machine_arguments.insert(plan.machine_arguments.end(), {"--param-file", file});
    for (const auto& line : options_.sets)
        plan.machine_arguments.insert(plan.machine_arguments.end(), {"--set", line});
    const std::string store =
        options_.store.empty() ? default_store(options_.instance) : options_.store;
    std::error_code error;
    std::filesystem::create_directories(store, error);
    if (error)
        return Diagnosis{Alarm::OutputFile, {}, {}, fmt::format("{} ({})", store, error.message())};
    plan.store_arguments = {"--store", store};
    for (unsigned number = 1; number <= kMaxChannels; ++number)
        if (machine_.channel(number).exists()) plan.channels.push_back(number);
    controller_.reset();
    auto controller = Controller::start(std::move(plan));
    if (!controller) return controller.diagnosis();
    controller_ = std::move(*controller);
    log_ = std::make_unique<RingConsumer<RingHead<KernelEvent, 16384>>>(
        controller_->kernel().log, controller_->own().log_tail);
    joiner_ = {};
    users_version_ = parameters_version_ = 0;
    users_.reset();
    parameters_.reset();
    kernel_dead_ = false;
    return {};
}

int StartSession::run() {
    if (auto launched = launch(); !launched) {
        if (end_requested()) return 0;  // asked to end while it started: nothing went wrong
        print_diagnosis(launched.diagnosis(), Dialect::Polyturn);
        return 1;
    }
    tell_words(fmt::format(
        fmt::runtime(
            say("polyturn: the controller \"{}\" runs with {} channels, {} axes, {} spindles. End "
                "it with Ctrl-C or SIGTERM.\n")),
        options_.instance, machine_.channel_count, machine_.axis_count, machine_.spindle_count));
    if (!options_.no_hmi) screens_.open(options_.instance);
    server_.set_guests([this](std::int64_t uid) {
        const UserTable* const table = users();
        if (!table) return false;
        const UserRow* const begin = table->rows.data();
        return std::any_of(begin, begin + std::min<std::size_t>(table->count, kUsers),
                           [&](const UserRow& row) { return row.uid == uid; });
    });
    server_.set_decoder([this](std::string line, std::function<void(Result<Request>)> done) {
        return workers_.offer([line = std::move(line), done = std::move(done)]() -> Workers::Done {
            auto request = std::make_shared<Result<Request>>(decode_request(line));
            return [request, done] { done(std::move(*request)); };
        });
    });
    // it runs all the same
    if (server_.name_is_foreign())
        print_diagnosis(Diagnosis{Alarm::InstanceForeign, {}, {}, "@polyturn." + options_.instance},
                        Dialect::Polyturn);
    loop();
    screens_.close();
    end();
    tell_words(fmt::format(fmt::runtime(say("polyturn: the controller \"{}\" has ended.\n")),
                           options_.instance));
    return 0;
}

// Nothing in here waits: not for a process, not for a file, not for room in a ring
// (kernel/supervisor/README.md). serve() is where it rests.
void StartSession::loop() {
    const RequestServer::Handler handler = [this](RequestServer::Client client,
                                                  const Request& request) {
        return handle(client, request);
    };
    // Feed hold comes through here: in front of what else the computer has to do, where that is
    // allowed (a service: LimitNICE).
    (void)setpriority(PRIO_PROCESS, 0, kNice);
    while (!end_requested() && !ask_to_end_) {
        controller_->beat();
        controller_->watch([this](std::size_t slot, int status) { process_died(slot, status); });
        drain();
        context_.move(*controller_, Clock::now(), teller());
        watch_stops();
        revive();
        screens_.look();
        if (!controller_) return;  // the machine could not be started anew
        controller_->look_for_successors(
            [](const Diagnosis& why) { print_diagnosis(why, Dialect::Polyturn); });
        workers_.finish();
        printer_.finish();
        move_selections();
        server_.serve(more_events_ ? 0 : context_.waiting() ? 2 : 10, handler, workers_.fd());
    }
}

// The machine first: it comes to rest while the log of stops may still be in transit to a slow
// disk.
void StartSession::end() {
    if (!controller_) return;
    keep_stops(stops_.close(utc_ms()));
    keep_alarms();
    controller_->stop_kernel(kEndTimeout_ms);
    for (const auto until = Clock::now() + kLastWords;
         context_.waiting() && controller_->running(kProcessStore) && Clock::now() < until;
         sleep_ms(2))
        context_.move(*controller_, Clock::now(), teller());
    controller_->stop(kEndTimeout_ms);
    for (const auto until = Clock::now() + kLastWords; printer_.busy() && Clock::now() < until;
         sleep_ms(2))
        printer_.finish();
}

bool StartSession::stuck() const { return workers_.busy() || printer_.busy(); }

// Messages for people show the line of a program, and a terminal may have been halted: not in the
// loop.
void StartSession::printed(std::function<void()> print) {
    (void)printer_.offer([print = std::move(print)]() -> Workers::Done {
        print();
        return {};
    });
}

void StartSession::drain() {
    bool moved = false;
    const auto notes = [&] {
        moved = take_notes(*controller_, joiner_, [this](unsigned channel) { put_out(channel); }) ||
                moved;
    };
    notes();
    const auto until = Clock::now() + kEventsAtOnce;
    more_events_ = false;
    while (const KernelEvent* event = log_->front()) {
        // requests in between
        if (more_events_ = Clock::now() > until; more_events_) break;
        if (static_cast<KernelEventKind>(event->kind) == KernelEventKind::RecordBegin) notes();
        const KernelEvent copy = *event;
        log_->pop();
        moved = true;
        take(copy);
        // P1: what was sent before is visible
        controller_->own().log_seen.store(copy.seq, std::memory_order_release);
    }
    if (moved) controller_->own().bell.ring();
    joiner_.discard();
}

// Its process sends what cannot be: it is ended, and its axes come to rest on their path. Its
// successor has as many tries as any other.
void StartSession::put_out(unsigned channel) {
    const Diagnosis diagnosis{
        Alarm::ChannelHostile, {}, {}, fmt::format("channel {}: its notes", channel)};
    printed([diagnosis] { print_diagnosis(diagnosis, Dialect::Polyturn); });
    std::string words = alarm_event(diagnosis, Dialect::Polyturn, channel);
    words.pop_back();
    note_alarm(std::move(words), Dialect::Polyturn, false);
    ProcessAction end;
    end.slot = kProcessChannel + channel - 1;
    controller_->act(end, [this](std::size_t slot, int status) { process_died(slot, status); });
}

void StartSession::take(const KernelEvent& event) {
    // P3: constant since the segment was published
    const double t_s =
        static_cast<double>(event.tick) *
        static_cast<double>(controller_->kernel().tick_ns.load(std::memory_order_relaxed)) * 1e-9;
    switch (static_cast<KernelEventKind>(event.kind)) {
        case KernelEventKind::RecordBegin: {
            if (event.code == kStepHandedOver) {
                joiner_.hold(event.channel, event.note);
                break;
            }
            const std::string words(joiner_.begin(event.channel, event.note, t_s));
            const std::string_view kind = event_kind(words);
            if (kind == "alarm" || kind == "message")
                note_alarm(words, dialect(event.channel), true);
            break;
        }
        case KernelEventKind::RecordEnd:
            joiner_.end(event.channel, event.note, t_s);
            break;
        case KernelEventKind::CycleEnded:
            joiner_.close_channel(event.channel, t_s);
            break;
        case KernelEventKind::MachineState:
            printed([text = std::string(
                         machine_step_text(static_cast<std::uint32_t>(event.code)).text)] {
                std::fprintf(stderr, "%s\n", text.c_str());
            });
            break;
        case KernelEventKind::Message:
        case KernelEventKind::Alarm: {
            if (event.code < 0) break;  // the program's own words: its note has reported them
            Diagnosis diagnosis;
            diagnosis.alarm = event.code >= 0 && event.code < kAlarmCount
                                  ? static_cast<Alarm>(event.code)
                                  : Alarm::NoProgress;
            diagnosis.values[0] = event.value;
            diagnosis.detail = event.text.data();
            diagnosis.place.line = event.line;
            if (event.line) diagnosis.place.file = program_of(event);
            const bool builders =
                diagnosis.alarm == Alarm::BuilderMessage || diagnosis.alarm == Alarm::BuilderNote;
            const int number = static_cast<int>(event.value);
            if (builders)
                diagnosis.detail = messages_.explain(
                    number, static_cast<text::MessageLanguage>(display_language_now()));
            printed([diagnosis, language = dialect(event.channel)] {
                print_diagnosis(diagnosis, language);
            });
            if (builders) diagnosis.detail = messages_.explain(number);  // logs are English
            std::string words = alarm_event(diagnosis, dialect(event.channel), event.channel, t_s);
            words.pop_back();
            if (builders && messages_.find(number) && words.back() == '}')
                words.insert(words.size() - 1, ",\"builder\":" + builder_words(number));
            note_alarm(std::move(words), dialect(event.channel), false);
            break;
        }
        default:
            break;
    }
}

// The program that the line of an event belongs to: the channel's last block knows it, a
// subprogram's perhaps; else the image does while it is still the running one, and the selected
// program is the best that is known.
std::string StartSession::program_of(const KernelEvent& event) const {
    if (std::string file = joiner_.file_of(event.channel, event.line); !file.empty()) return file;
    const ChannelSegment* channel = controller_->channel(event.channel);
    const auto names = std::make_unique<ProgramNames>();
    const auto status = std::make_unique<MachineStatus>();
    if (!channel || !channel->programs.read(*names) || names->count == 0 ||
        !controller_->kernel().status.read(*status))
        return {};
    const ChannelStatus& now = status->channels[event.channel - 1];
    const std::size_t file =
        now.line == event.line && now.file < std::min<std::uint64_t>(names->count, 32) ? now.file
                                                                                       : 0;
    return &names->name[file * 256];
}

// The machine builder's message in every language: the screens show it in theirs, whichever the
// controller speaks.
std::string StartSession::builder_words(int number) const {
    static constexpr const char* kCodes[] = {"en", "ru", "cs", "hu"};
    Json out{{"told", messages_.explain(number)}};
    for (std::size_t i = 0; i < std::size(kCodes); ++i) {
        const auto language = static_cast<text::MessageLanguage>(i);
        out[kCodes[i]] = {
            {"text", messages_.explain(number, language, false)},
            {"remedy", text::BuilderMessage::own(messages_.find(number)->remedy, language)}};
    }
    return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// The wall's time, and how many resets its channel has had: an alarm is active until the next one.
std::string StartSession::with_when(std::string event_text) const {
    if (event_text.empty() || event_text.back() != '}') return event_text;
    unsigned channel = 0;
    if (const auto at = event_text.find("\"ch\":"); at != std::string::npos)
        channel = static_cast<unsigned>(std::strtoul(event_text.c_str() + at + 5, nullptr, 10));
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
    if (tell) printed([event_text, language] { print_alarm_event(event_text, language); });
    if (const Json event =
            Json::parse(event_text.back() == '}' ? event_text : event_text + "}", nullptr, false);
        text_field(event, "severity") == "error")
        stops_.alarm(count_field(event, "ch"), word_field(event, "number"),
                     text_field(event, "text"));
    alarms_.push_back(with_when(std::move(event_text)));
    if (alarms_.back().find("\"severity\":\"error\"") != std::string::npos ||
        alarms_.back().find("\"severity\":\"warning\"") != std::string::npos)
        unkept_alarms_.push_back(alarms_.back());
    ++alarms_noted_;
    if (alarms_.size() > kKeptAlarms) alarms_.pop_front();
}

void StartSession::process_died(std::size_t slot, int status) {
    const Diagnosis diagnosis{
        Alarm::ProcessDied,
        {},
        {},
        fmt::format("the process {} {}", process_name(slot), describe_end(status))};
    printed([diagnosis] { print_diagnosis(diagnosis, Dialect::Polyturn); });
    std::string words = alarm_event(diagnosis, Dialect::Polyturn, 0);
    words.pop_back();
    note_alarm(std::move(words), Dialect::Polyturn, false);
    if (slot == kProcessStore) context_.store_died(*controller_, teller());
    auto& times = deaths_[slot];
    const auto now = Clock::now();
    while (!times.empty() && now - times.front() > kDeathWindow) times.pop_front();
    times.push_back(now);
    if (times.size() > kMostDeaths) {
        tell_words(fmt::format(
            fmt::runtime(say("polyturn: {} has died {} times in {} s and stays dead.\n")),
            process_name(slot), times.size(), kDeathWindow.count()));
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
        job_language_.fill(Dialect::Polyturn);  // nothing is selected any more
        context_.forget_all(teller());
        for (const Selection& one : std::exchange(selections_, {}))
            server_.answer(one.client,
                           refusal({Alarm::NotServed, {}, {}, "the machine was started anew"}));
        if (auto launched = launch(); !launched) {
            print_diagnosis(launched.diagnosis(), Dialect::Polyturn);
            ask_to_end_ = true;
        }
        return;
    }
    for (const std::size_t slot : std::exchange(to_revive_, {}))
        if (auto done = controller_->begin_restart(slot); !done)
            print_diagnosis(done.diagnosis(), Dialect::Polyturn);
}

}  // namespace polyturn::supervisor
