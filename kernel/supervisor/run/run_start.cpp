// The beginning of a run: the processes, their first rest, and the commands of time 0.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ipc/image/commands.hpp"
#include "ipc/model/files/machine_path.hpp"
#include "kernel/supervisor/check/program_stops.hpp"
#include "kernel/supervisor/press/press_words.hpp"
#include "kernel/supervisor/run/run_session.hpp"
#include "kernel/supervisor/run/setup_sensors.hpp"
#include "kernel/supervisor/run/start_position.hpp"

namespace polyturn::supervisor {

namespace {
using Clock = std::chrono::steady_clock;

constexpr std::int64_t kLeadTicks = 10;  // from the kernel's rest to the cycle start
// in real time the PLC has answered a few cycles by then
constexpr std::int64_t kRealLeadTicks = 200;

bool is(std::uint32_t kind, CommandKind wanted) {
    return kind == static_cast<std::uint32_t>(wanted);
}
}  // namespace

Result<void> RunSession::start() {
    if (!options_.trace_file.empty()) {
        auto file = TraceFile::create(options_.trace_file, *plan_.machine);
        if (!file) return file.diagnosis();
        trace_file_ = std::move(*file);
    }
    ControllerPlan plan;
    plan.instance = options_.instance.empty() ? private_instance_name() : options_.instance;
    plan.options.virtual_time = options_.virtual_time ? 1 : 0;
    plan.options.trace_every = trace_file_ ? options_.trace_every : 0;
    plan.options.notes = 1;
    plan.options.parts = options_.parts ? options_.parts : 1;
    plan.options.ready = 1;
    for (unsigned number = 1; number <= kMaxChannels; ++number) {
        const auto found = wishes_.feed_override.find(number);
        plan.options.feed_override[number - 1] =
            found == wishes_.feed_override.end() ? 1.0 : found->second;
    }
    set_start_positions(plan_, plan.options);
    const bool reacts =
        wishes_.scenario && (wishes_.scenario->has_when() || wishes_.scenario->has_actions());
    follow_log_ =
        options_.virtual_time && (reacts || programs_may_stop() || !wishes_.restart_at.empty());
    plan.options.follow_log = follow_log_ ? 1 : 0;
    plan.machine_arguments = plan_.machine_arguments();
    if (const auto path = text::resolve_machine(plan_.source.machine)) {
        plan.plc_library = path->plc;
        plan.drives_program = path->drives;
        set_machine_files(path->params, plan.options);
    }
    for (const auto& [channel, program] : plan_.programs)
        if (program.language_chosen)
            plan.machine_arguments.insert(
                plan.machine_arguments.end(),
                {"--set", fmt::format("PT_LANGUAGE L{}={}", channel, program.language)});
    if (options_.store.empty())
        plan.store_arguments = {"--memory"};
    else
        plan.store_arguments = {"--store", options_.store};
    if (!options_.like.empty())
        plan.store_arguments.insert(plan.store_arguments.end(), {"--like", options_.like});
    if (!plan_.setup_path.empty()) plan.channel_arguments = {"--setup", plan_.setup_path};
    if (options_.variables) plan.channel_arguments.push_back("--variables");
    for (const auto& [channel, program] : plan_.programs) plan.channels.push_back(channel);
    // Programs that a program may start.
    const auto starter =
        std::find_if(plan_.programs.begin(), plan_.programs.end(),
                     [](const auto& one) { return one.second.language == "sinumerik"; });
    if (starter != plan_.programs.end() && may_start_programs(program_files())) {
        const PlannedProgram& first = starter->second;
        for (unsigned channel = 1; channel <= kMaxChannels; ++channel) {
            if (plan_.programs.count(channel) || !plan_.machine->channel(channel).exists())
                continue;
            plan.channels.push_back(channel);
            plan.machine_arguments.insert(
                plan.machine_arguments.end(),
                {"--set", fmt::format("PT_LANGUAGE L{}={}", channel,
                                      plan_.started_language(channel, first))});
        }
    }
    if (wishes_.scenario)
        for (const unsigned channel : wishes_.scenario->channels_that_read())
            if (std::find(plan.channels.begin(), plan.channels.end(), channel) ==
                plan.channels.end())
                plan.channels.push_back(channel);

    auto controller = Controller::start(std::move(plan));
    if (!controller) return controller.diagnosis();
    controller_ = std::move(*controller);
    log_ = std::make_unique<RingConsumer<RingHead<KernelEvent, 16384>>>(
        controller_->kernel().log, controller_->own().log_tail);
    trace_ = std::make_unique<RingConsumer<RingHead<TraceSample, 1024>>>(
        controller_->kernel().trace, controller_->own().trace_tail);
    // P3: numbers alone count (the orders are stronger than needed)
    tick_s_ =
        static_cast<double>(controller_->kernel().tick_ns.load(std::memory_order_acquire)) * 1e-9;
    if (options_.virtual_time) return await_first_idle();
    // P3: as above
    origin_ =
        static_cast<std::int64_t>(controller_->kernel().tick.load(std::memory_order_acquire)) +
        kRealLeadTicks;
    return {};
}

// A new machine ticks until PLC and drives have come to rest, always equally long. There virtual
// time is stopped, and from there the cycle start is counted, so that all runs are alike however
// long the processes took to start.
Result<void> RunSession::await_first_idle() {
    const auto until = Clock::now() + std::chrono::seconds(30);
    std::vector<KernelEvent> early;
    while (idle_seq_ == 0) {
        const std::uint32_t seen = controller_->bell();
        const KernelEvent* event = log_->front();
        if (!event) {
            std::optional<std::size_t> dead;
            controller_->watch([&](std::size_t slot, int) { dead = slot; });
            if (dead)
                return Diagnosis{
                    Alarm::ProcessDied,
                    {},
                    {},
                    fmt::format("the process {} died while it started", process_name(*dead))};
            if (end_requested() || Clock::now() > until)
                return Diagnosis{
                    Alarm::NoProgress, {}, {}, "the machine does not come to rest after its start"};
            drain_trace(INT64_MAX);
            controller_->own().bell.ring();
            controller_->wait(seen, 5'000, 0);
            continue;
        }
        const KernelEvent copy = *event;
        log_->pop();
        if (static_cast<KernelEventKind>(copy.kind) == KernelEventKind::Idle) {
            idle_seq_ = copy.seq;
            origin_ = copy.tick + kLeadTicks;
            log_tick_ = copy.tick;
        } else {
            early.push_back(copy);
            // P1: what was sent before is visible
            controller_->own().log_seen.store(copy.seq, std::memory_order_release);
            controller_->own().bell.ring();
        }
    }
    for (KernelEvent& event : early) {  // an alarm of the start belongs to the run's beginning
        event.tick = origin_;
        event.offset_s = 0;
        if (static_cast<KernelEventKind>(event.kind) == KernelEventKind::Alarm ||
            static_cast<KernelEventKind>(event.kind) == KernelEventKind::Message)
            take_alarm(event, 0.0);
    }
    return {};
}

// Programs whose text holds a programmed stop: its answer must come at an exact tick, so the kernel
// has to wait for us.
bool RunSession::programs_may_stop() const {
    if (wishes_.scenario && wishes_.scenario->presses_cycle_start()) return false;
    return may_hold_program_stop(program_files());
}

std::vector<std::string> RunSession::program_files() const {
    std::vector<std::string> files;
    for (const auto& [channel, program] : plan_.programs) files.push_back(program.file);
    for (const auto& [channel, setup] : plan_.setup.channels)
        files.insert(files.end(), setup.subprograms.begin(), setup.subprograms.end());
    return files;
}

void RunSession::send_at(const Command& command, double t_s) {
    // Rounded up: what is asked for at t does not act before t.
    const auto ticks = static_cast<std::int64_t>(std::ceil(t_s / tick_s_ - 1e-6));
    const std::int64_t tick = origin_ + std::max<std::int64_t>(ticks, 0);
    sent_ticks_.insert(tick);
    if (is(command.kind, CommandKind::CycleStart) || is(command.kind, CommandKind::HandKey) ||
        is(command.kind, CommandKind::Restart))
        starts_planned_.insert(tick);
    if (is(command.kind, CommandKind::Restart)) restarts_[command.channel] = command.flags;
    controller_->send(command, tick);
}

void RunSession::send_planned(const Planned& planned) {
    if (!planned.action) return send_at(planned.command, planned.t_s);
    const auto ticks = static_cast<std::int64_t>(std::ceil(planned.t_s / tick_s_ - 1e-6));
    const std::int64_t tick = origin_ + std::max<std::int64_t>(ticks, 0);
    sent_ticks_.insert(tick);
    actions_[controller_->send(planned.command, tick)] = *planned.action;
}

void RunSession::send_start() {
    const auto make = [](CommandKind kind, unsigned channel, double value) {
        Command command{};
        command.kind = static_cast<std::uint32_t>(kind);
        command.channel = channel;
        command.value = value;
        return command;
    };
    controller_->begin_batch();
    for (const WatchedSignal& watched : wishes_.watch) {
        Command command = make(CommandKind::Watch, 0, 0);
        command.object = watched.slot;
        command.flags = watched.side | (watched.is_double ? kSlotOfDouble : 0u);
        send_at(command, 0.0);
    }
    for (const Command& sensor : sensor_commands(plan_)) send_at(sensor, 0.0);
    for (const auto& [channel, setup] : plan_.setup.channels) {
        const text::KeySetup& keys = setup.keys;
        if (keys.single_block) send_at(make(CommandKind::SingleBlock, channel, 1), 0.0);
        if (keys.optional_stop) send_at(make(CommandKind::OptionalStop, channel, 1), 0.0);
        if (keys.dry_run) send_at(make(CommandKind::DryRun, channel, 1), 0.0);
        if (keys.machine_lock) send_at(make(CommandKind::MachineLock, channel, 1), 0.0);
        for (const int level : keys.block_skip) {
            Command command = make(CommandKind::BlockSkip, channel, 1);
            command.flags = static_cast<std::uint32_t>(std::max(level, 1));
            send_at(command, 0.0);
        }
    }
    for (const auto& [channel, program] : plan_.programs) {
        Command select = make(CommandKind::Select, channel, 0);
        if (!put_text(select, program.file)) {
            report(Diagnosis{Alarm::FileUnreadable,
                             Place{program.file, 0, 0, 0},
                             {},
                             fmt::format("its name is longer than {} characters",
                                         select.text.size() - 1)},
                   channel, 0.0);
            tracks_[channel].over = true;
            continue;
        }
        send_at(select, 0.0);
    }
    // What a scenario sets at time 0 is there when the programs start.
    std::vector<Planned> timed;
    if (wishes_.scenario) timed = wishes_.scenario->timed();
    const auto is_key = [](const Planned& planned) {
        return !planned.action && planned.t_s <= 0.0 &&
               (!is(planned.command.kind, CommandKind::CycleStart) ||
                (planned.command.flags & kStartByHand)) &&
               !is(planned.command.kind, CommandKind::FeedHold) &&
               !is(planned.command.kind, CommandKind::Reset);
    };
    for (const Planned& planned : timed)
        if (is_key(planned)) send_planned(planned);
    std::uint32_t together = 0;  // channels that restart: their waits are replayed
    for (const auto& [channel, block] : wishes_.restart_at) together |= 1u << (channel - 1);
    const auto restart_command = [&](unsigned channel, double block) {
        Command command = make(CommandKind::Restart, channel, block);
        command.flags = together;
        return command;
    };
    for (const auto& [channel, program] : plan_.programs) {
        const auto restart = wishes_.restart_at.find(channel);
        send_at(restart == wishes_.restart_at.end() ? make(CommandKind::CycleStart, channel, 1)
                                                    : restart_command(channel, restart->second),
                0.0);
    }
    for (const Planned& planned : timed)
        if (!is_key(planned)) send_planned(planned);
    controller_->end_batch();
    if (idle_seq_) {
        // P1: the batch is visible before it
        controller_->own().log_seen.store(idle_seq_, std::memory_order_release);
        controller_->own().bell.ring();
    }
}

}  // namespace polyturn::supervisor
