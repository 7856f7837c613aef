#include "kernel/supervisor/run/run_session.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ipc/diagnosis/display_language.hpp"
#include "ipc/image/positioning_step.hpp"
#include "kernel/supervisor/base/event_text.hpp"
#include "kernel/supervisor/base/json_fields.hpp"
#include "kernel/supervisor/press/press_words.hpp"
#include "kernel/supervisor/take_notes.hpp"

namespace polyturn::supervisor {

namespace {
using Clock = std::chrono::steady_clock;

// a programmed stop is answered by cycle start so much later
constexpr double kStopAnswer_s = 1.0;
// of virtual time, before the run is given up
constexpr auto kNoProgress = std::chrono::seconds(15);

std::string_view reason_text(StopReason reason) {
    switch (reason) {
        case StopReason::M00:
            return "M00";
        case StopReason::M01:
            return "M01";
        case StopReason::M02:
            return "M02";
        case StopReason::M30:
            return "M30";
        case StopReason::Held:
            return "held";
        case StopReason::Waiting:
            return "waiting";
        case StopReason::SingleBlock:
            return "single_block";
        case StopReason::Alarm:
            return "alarm";
        case StopReason::Reset:
            return "reset";
        case StopReason::Death:
            return "death";
        case StopReason::Restart:
            return "restart";
        case StopReason::FirstPart:
            return "first_part";
        case StopReason::Retrace:
            return "retrace";
        case StopReason::Dialogue:
            return "dialogue";
        default:
            return "end";
    }
}
}  // namespace

RunSession::RunSession(const JobOptions& options, JobPlan& plan, RunRequests wishes)
    : options_(options),
      plan_(plan),
      wishes_(std::move(wishes)),
      output_(1, !options.virtual_time) {
    record_.wanted = options.report || !options.plot_file.empty();
    joiner_.measure_all(record_.wanted);
    sink_ = [this](const EventJoiner::Event& event) { give_out(event); };
    for (const auto& [channel, program] : plan_.programs) tracks_[channel];
}

RunSession::~RunSession() = default;

int RunSession::run() {
    catch_signals();
    if (auto started = start(); !started) {
        print_diagnosis(started.diagnosis(), Dialect::Polyturn);
        output_.write(alarm_event(started.diagnosis(), Dialect::Polyturn, 0));
        return started.diagnosis().alarm == Alarm::OutputFile ? 2 : 1;
    }
    send_start();
    loop();
    finish();
    return alarms_ || stopped_short_ ? 1 : 0;
}

void RunSession::loop() {
    progress_at_ = still_since_ = checked_at_ = Clock::now();
    while (!done_) {
        const std::uint32_t seen = controller_->bell();
        // Everything of the last tick is in the log once the kernel shows the next one.
        // P1: the log of the ticks before it is complete
        const bool complete = ending() && static_cast<std::int64_t>(controller_->kernel().tick.load(
                                              std::memory_order_acquire)) > end_tick_;
        const bool moved = drain();
        if (done_ || complete) break;
        controller_->beat();
        const auto now = Clock::now();
        if (now - checked_at_ > std::chrono::milliseconds(10)) {
            checked_at_ = now;
            controller_->watch(
                [this](std::size_t slot, int status) { process_died(slot, status); });
            if (!stands_on_purpose()) {
                if (!options_.virtual_time) watch_real_time();
                watch_progress();
            }
            if (end_requested()) done_ = stopped_short_ = true;
        }
        if (!moved)
            controller_->wait(seen, 5'000, follow_log_ ? 4'000 : 0);
        else if (!follow_log_ && options_.virtual_time)
            usleep(300);  // a batch at a time: each wake-up costs the kernel a tick
    }
}

bool RunSession::drain() {
    // Events of the ticks before this one are all in the log, so that the end, once it is among
    // them, is known before the samples of those ticks are written.
    // P1: log and trace of the ticks before this one are complete
    const auto shown =
        static_cast<std::int64_t>(controller_->kernel().tick.load(std::memory_order_acquire));
    bool moved = drain_log();
    moved = drain_trace(shown - 1) || moved;
    if (moved) {
        joiner_.drain(static_cast<double>(log_tick_ - origin_) * tick_s_, sink_);
        controller_->own().bell.ring();
    }
    return moved;
}

void RunSession::drain_notes() {
    // its process sends what cannot be, and ends
    take_notes(*controller_, joiner_, [this](unsigned channel) {
        report(
            Diagnosis{Alarm::ChannelHostile, {}, {}, fmt::format("channel {}: its notes", channel)},
            channel, std::max(0.0, static_cast<double>(log_tick_ - origin_) * tick_s_));
        ProcessAction end;
        end.slot = kProcessChannel + channel - 1;
        controller_->act(end, [this](std::size_t slot, int status) { process_died(slot, status); });
    });
}

bool RunSession::drain_log() {
    drain_notes();
    bool moved = false;
    while (const KernelEvent* event = log_->front()) {
        // The note of a record is in its ring before the record, and so before this event.
        if (static_cast<KernelEventKind>(event->kind) == KernelEventKind::RecordBegin)
            drain_notes();
        if (event->tick > end_tick_) {  // after the end
            done_ = true;
            break;
        }
        const KernelEvent copy = *event;
        log_->pop();
        moved = true;
        take(copy);
        // Always said: the kernel does not leave «idle» before it, so a batch of commands (the
        // start) acts as one.
        // P1: «nothing more to say»: what was sent before is visible
        controller_->own().log_seen.store(copy.seq, std::memory_order_release);
        if (follow_log_) controller_->own().bell.ring();
        if (done_) break;
    }
    return moved;
}

bool RunSession::drain_trace(std::int64_t last_tick) {
    bool moved = false;
    while (const TraceSample* sample = trace_->front()) {
        if (sample->tick > last_tick) break;
        moved = true;
        if (trace_file_ && sample->tick >= origin_ && sample->tick <= end_tick_)
            trace_file_->write(*sample, static_cast<double>(sample->tick - origin_) * tick_s_);
        trace_->pop();
    }
    return moved;
}

void RunSession::take(const KernelEvent& event) {
    log_tick_ = std::max(log_tick_, event.tick);
    sent_ticks_.erase(sent_ticks_.begin(), sent_ticks_.lower_bound(event.tick));
    starts_planned_.erase(starts_planned_.begin(), starts_planned_.lower_bound(event.tick));
    const double t_s = seconds(event);
    const auto track = tracks_.find(event.channel);
    switch (static_cast<KernelEventKind>(event.kind)) {
        case KernelEventKind::RecordBegin:
            if (event.code == kStepHandedOver)
                joiner_.hold(event.channel, event.note);
            else
                take_begin(event, t_s);
            break;
        case KernelEventKind::RecordEnd:
            joiner_.end(event.channel, event.note, t_s);
            break;
        case KernelEventKind::CycleStarted:
            if (track != tracks_.end()) {
                track->second.started = true;
                track->second.over = false;
            }
            break;
        case KernelEventKind::CycleEnded:
            // A dead channel's axes still come to rest; Stopped says when.
            if (static_cast<StopReason>(event.code) == StopReason::Death) break;
            if (track != tracks_.end())
                track->second.alarmed = track->second.alarmed ||
                                        static_cast<StopReason>(event.code) == StopReason::Alarm;
            end_if_over(event, t_s);
            break;
        case KernelEventKind::Signal: {
            for (const WatchedSignal& watched : wishes_.watch)
                if (watched.slot == static_cast<std::uint32_t>(event.code) &&
                    watched.side == event.line) {
                    std::string text = std::move(EventText("flag")
                                                     .text("name", watched.name)
                                                     .number("value", event.value))
                                           .line();
                    text.pop_back();
                    react(joiner_.plain(event.channel, t_s, std::move(text)), t_s);
                }
            break;
        }
        case KernelEventKind::PositioningBegin:
        case KernelEventKind::PositioningEnd: {
            const bool begins =
                static_cast<KernelEventKind>(event.kind) == KernelEventKind::PositioningBegin;
            std::string text = std::move(EventText("beside")
                                             .text("axis", fmt::format("A{}", event.code))
                                             .text("state", begins ? "begin" : "end")
                                             .number("value", event.value))
                                   .line();
            text.pop_back();
            react(joiner_.plain(event.channel, t_s, std::move(text)), t_s);
            break;
        }
        case KernelEventKind::MachineState:
            react(joiner_.plain(0, t_s, machine_event(event)), t_s);
            break;
        case KernelEventKind::Message:
            if (event.code < 0) break;  // the program's own words: its note has reported them
            take_alarm(event, t_s);
            break;
        case KernelEventKind::Alarm:
            take_alarm(event, t_s);
            break;
        case KernelEventKind::Stopped:
            take_stopped(event, t_s);
            break;
        case KernelEventKind::ActionDue:
            take_action(event);
            break;
        case KernelEventKind::Idle:
            take_idle(t_s);
            break;
        default:
            break;
    }
}

void RunSession::take_begin(const KernelEvent& event, double t_s) {
    const std::string_view text = joiner_.begin(event.channel, event.note, t_s);
    if (text.empty()) return;
    if (event_kind(text) == "alarm") {
        if (text.find("\"severity\":\"warning\"") == std::string_view::npos) ++alarms_;
        print_alarm_event(text, plan_.dialect(event.channel));
    }
    if (event_kind(text) == "start") expect_started(text);
    react(text, t_s);
}

// Channels that a program starts belong to the run from then on.
void RunSession::expect_started(std::string_view event_text) {
    const auto event = nlohmann::json::parse(event_text, nullptr, false);
    const auto channels = event.is_object() ? event.find("channels") : event.end();
    if (channels == event.end() || !channels->is_array()) return;
    for (const auto& one : *channels)
        if (one.is_number_unsigned() && one.get<std::uint64_t>() >= 1 &&
            one.get<std::uint64_t>() <= kMaxChannels)
            tracks_[one.get<unsigned>()];
}

// Stimuli that wait for this event.
void RunSession::react(std::string_view event_text, double t_s) {
    if (!wishes_.scenario || !wishes_.scenario->waits_for_events()) return;
    for (const Planned& planned : wishes_.scenario->match(event_text, t_s)) {
        Planned later = planned;
        // At the next tick's start at the earliest, even when the event lies within this tick.
        later.t_s = std::max(later.t_s, static_cast<double>(log_tick_ + 1 - origin_) * tick_s_);
        send_planned(later);
    }
}

void RunSession::take_stopped(const KernelEvent& event, double t_s) {
    const auto track = tracks_.find(event.channel);
    const auto reason = static_cast<StopReason>(event.code);
    const bool answered = reason == StopReason::M00 || reason == StopReason::M01 ||
                          reason == StopReason::Restart || reason == StopReason::FirstPart;
    const std::vector<unsigned> starts = to_start(event.channel, reason);
    if (answered && !(wishes_.scenario && wishes_.scenario->presses_cycle_start()))
        for (const unsigned channel : starts) {
            Command start{};
            start.kind = static_cast<std::uint32_t>(CommandKind::CycleStart);
            start.channel = channel;
            send_at(start, t_s + kStopAnswer_s);
        }
    if ((reason == StopReason::Alarm || reason == StopReason::Death) && track != tracks_.end()) {
        track->second.alarmed = true;
        end_if_over(event, t_s);
    }
    if (reason == StopReason::Death) replace_channel(event.channel);
}

// The channels that are started when a channel is stopped: itself; at the block of a restart all
// that restart with it, when the last of them is there.
std::vector<unsigned> RunSession::to_start(unsigned channel, StopReason reason) {
    const std::uint32_t bit = 1u << (channel - 1);
    at_block_ &= ~bit;
    if (reason != StopReason::Restart) return {channel};
    at_block_ |= bit;
    const std::uint32_t together = restarts_[channel] | bit;
    std::vector<unsigned> out;
    for (unsigned l = 1; l <= kMaxChannels; ++l)
        if (together >> (l - 1) & 1u) out.push_back(l);
    return (at_block_ & together) == together ? out : std::vector<unsigned>{};
}

// It is started anew in reset state (architecture 3), its program selected still. In virtual time
// only where the kernel waits for what is said to its events: otherwise two runs would differ.
void RunSession::replace_channel(unsigned channel) {
    if (ending() || (options_.virtual_time && !follow_log_)) return;
    drain_notes();
    joiner_.forget_notes(channel);
    if (auto started = controller_->restart(kProcessChannel + channel - 1); !started)
        return report(started.diagnosis(), channel,
                      std::max(0.0, static_cast<double>(log_tick_ - origin_) * tick_s_));
    // the kernel takes the successor before its next tick
    if (options_.virtual_time)
        select_again(channel, log_tick_ + 1);
    else
        to_select_[channel] = log_tick_;
}

void RunSession::select_again(unsigned channel, std::int64_t tick) {
    const auto program = plan_.programs.find(channel);
    if (program == plan_.programs.end()) return;
    Command select{};
    select.kind = static_cast<std::uint32_t>(CommandKind::Select);
    select.channel = channel;
    if (put_text(select, program->second.file))
        send_at(select, static_cast<double>(tick - origin_) * tick_s_);
}

// In real time the kernel takes the successor when it is there: what is said to a channel that is
// still dead gets lost.
void RunSession::select_in_successors(const MachineStatus& status) {
    std::erase_if(to_select_, [&](const auto& waiting) {
        const auto& [channel, died] = waiting;
        const auto state = static_cast<ChannelState>(status.channels[channel - 1].state);
        if (status.tick <= died || state == ChannelState::Dead || state == ChannelState::Absent)
            return false;
        select_again(channel, status.tick + 1);
        return true;
    });
}

// The channel's program is over. When all are, so is the run; after an alarm it goes on until the
// machine rests.
void RunSession::end_if_over(const KernelEvent& event, double t_s) {
    joiner_.close_channel(event.channel, t_s);
    const auto track = tracks_.find(event.channel);
    if (track == tracks_.end() || track->second.over) return;
    track->second.over = true;
    end_s_ = std::max(end_s_, t_s);
    const bool calm = std::none_of(tracks_.begin(), tracks_.end(),
                                   [](const auto& one) { return one.second.alarmed; });
    if (calm && all_over() && !start_is_planned()) end_at(event.tick);
}

void RunSession::take_alarm(const KernelEvent& event, double t_s) {
    Diagnosis diagnosis;
    diagnosis.alarm = event.code >= 0 && event.code < kAlarmCount ? static_cast<Alarm>(event.code)
                                                                  : Alarm::NoProgress;
    diagnosis.values[0] = event.value;
    diagnosis.detail = event.text.data();
    diagnosis.place.line = event.line;
    // logs are English
    if (diagnosis.alarm == Alarm::BuilderMessage || diagnosis.alarm == Alarm::BuilderNote)
        diagnosis.detail = plan_.messages.explain(static_cast<int>(event.value));
    if (event.line) {
        // The kernel knows lines, the channel's last block knows the file: a subprogram's, perhaps.
        const auto program = plan_.programs.find(event.channel);
        if (program != plan_.programs.end()) diagnosis.place.file = program->second.file;
        if (std::string file = joiner_.file_of(event.channel, event.line); !file.empty())
            diagnosis.place.file = std::move(file);
    }
    report(diagnosis, event.channel, t_s);
}

void RunSession::report(const Diagnosis& diagnosis, unsigned channel, double t_s) {
    const Dialect dialect = channel ? plan_.dialect(channel) : Dialect::Polyturn;
    if (!options_.quiet || diagnosis.severity() != Severity::Message) {
        Diagnosis read = diagnosis;
        if (read.alarm == Alarm::BuilderMessage || read.alarm == Alarm::BuilderNote)
            read.detail =
                plan_.messages.explain(static_cast<int>(read.values[0]),
                                       static_cast<text::MessageLanguage>(display_language_now()));
        print_diagnosis(read, dialect);
    }
    std::string text = alarm_event(diagnosis, dialect, channel);
    text.pop_back();
    if (diagnosis.severity() == Severity::Error) ++alarms_;
    react(joiner_.plain(channel, t_s, std::move(text)), t_s);
}

void RunSession::take_action(const KernelEvent& event) {
    const auto found = actions_.find(static_cast<std::uint64_t>(event.code));
    if (found == actions_.end()) return;
    const ProcessAction action = found->second;
    actions_.erase(found);
    if (action.slot == kProcessKernel && action.kind == ProcessAction::Kind::Stop &&
        action.for_s > 0)
        thaw_at_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(action.for_s));
    controller_->act(action, [this](std::size_t slot, int status) { process_died(slot, status); });
}

// A kernel that a scenario has stopped for a while goes on by itself: meanwhile nothing is expected
// of it. True while it is stopped.
bool RunSession::stands_on_purpose() {
    if (!thaw_at_) return false;
    if (Clock::now() < *thaw_at_) return true;
    thaw_at_.reset();
    ProcessAction on;
    on.kind = ProcessAction::Kind::Continue;
    on.slot = kProcessKernel;
    controller_->act(on, [this](std::size_t slot, int status) { process_died(slot, status); });
    progress_at_ = still_since_ = Clock::now();
    return false;
}

// Nothing can go on. Commands that the kernel has not looked at yet may change that: it says so
// again.
void RunSession::take_idle(double t_s) {
    if (sent_ticks_.upper_bound(log_tick_) != sent_ticks_.end()) return;
    // P4: own head. P3: only whether all are taken
    if (controller_->kernel().command_tail.tail.load(std::memory_order_acquire) !=
        controller_->own().commands.head.load(std::memory_order_relaxed))
        return;
    if (!all_over()) end_s_ = std::max(end_s_, t_s);
    end_at(log_tick_);
    done_ = true;
    MachineStatus status;
    if (!controller_->kernel().status.read(status)) return;
    for (auto& [number, track] : tracks_) {
        if (track.over) continue;
        const ChannelStatus& channel = status.channels[number - 1];
        StopReason reason = static_cast<StopReason>(channel.stop_reason);
        switch (static_cast<ChannelState>(channel.state)) {
            case ChannelState::Held:
                reason = StopReason::Held;
                break;
            case ChannelState::Waiting:
                reason = StopReason::Waiting;
                break;
            case ChannelState::ProgramStop:
                break;
            case ChannelState::Reset:
            case ChannelState::Ended:
                continue;
            case ChannelState::Interrupted:
            case ChannelState::Dead:
                track.alarmed = true;
                continue;
            // it asks for a value that nothing changes any more, unless its feed is switched off
            case ChannelState::Running:
                if (request_fails(number)) reason = StopReason::Waiting;
                break;
            default:
                break;
        }
        stopped_short_ = true;
        std::string text =
            std::move(
                EventText("stop")
                    .number("ch", number)
                    .text("reason", reason == StopReason::None ? "stopped" : reason_text(reason)))
                .line();
        text.pop_back();
        joiner_.plain(number, t_s, std::move(text));
    }
}

bool RunSession::request_fails(unsigned number) {
    const ChannelSegment* channel = controller_->channel(number);
    const std::uint64_t at =
        // P1: the record at the tail is complete
        controller_->kernel().path_tail[number - 1].tail.load(std::memory_order_acquire);
    return channel && at < channel->path.head.load(std::memory_order_acquire) &&
           static_cast<RecordKind>(channel->path.slot(at).kind) == RecordKind::Barrier;
}

bool RunSession::all_over() const {
    return std::all_of(tracks_.begin(), tracks_.end(),
                       [](const auto& track) { return track.second.over; });
}

bool RunSession::start_is_planned() const {
    return starts_planned_.upper_bound(log_tick_) != starts_planned_.end();
}

void RunSession::process_died(std::size_t slot, int status) {
    const double t_s = std::max(0.0, static_cast<double>(log_tick_ - origin_) * tick_s_);
    const bool channel = slot >= kProcessChannel;
    if (slot == kProcessKernel) {
        kernel_dead_ = done_ = true;
        drain_log();
        done_ = true;
    }
    // The kernel names channel and PLC in its own alarm, at the tick at which it acts.
    if (channel || slot == kProcessPlc) return;
    report(Diagnosis{Alarm::ProcessDied,
                     {},
                     {},
                     fmt::format("the process {} {}", process_name(slot), describe_end(status))},
           0, t_s);
}

void RunSession::watch_progress() {
    // P3: numbers for a text, they announce nothing (the orders are stronger than needed)
    const std::uint64_t tick = controller_->kernel().tick.load(std::memory_order_acquire);
    const auto now = Clock::now();
    if (tick != progress_tick_) {
        progress_tick_ = tick;
        progress_at_ = now;
        return;
    }
    if (now - progress_at_ < kNoProgress) return;
    std::string who = fmt::format("the kernel stands at tick {}", tick);
    for (const auto& [number, track] : tracks_) {
        const ChannelSegment* channel = controller_->channel(number);
        if (!channel) continue;
        const std::uint64_t sent =
            // P3: as above
            controller_->kernel().events[number - 1].head.load(std::memory_order_acquire);
        who += fmt::format(
            "; channel {} has answered {} of {} events, {} records", number,
            // P3: as above
            channel->quiet.load(std::memory_order_acquire), sent,
            channel->path.head.load(std::memory_order_acquire) -
                controller_->kernel().path_tail[number - 1].tail.load(std::memory_order_acquire));
    }
    who += fmt::format("; PLC cycle {}", controller_->kernel().plc_inputs.version());
    report(Diagnosis{Alarm::NoProgress, {}, {}, std::move(who)}, 0,
           std::max(0.0, static_cast<double>(log_tick_ - origin_) * tick_s_));
    done_ = stopped_short_ = true;
}

// In real time no process reports that nothing can go on: when no channel has run for a while and
// nothing is planned, it is so.
void RunSession::watch_real_time() {
    const auto now = Clock::now();
    MachineStatus status;
    if (!controller_->kernel().status.read(status)) return;
    select_in_successors(status);
    bool stands =
        status.tick > origin_ && sent_ticks_.upper_bound(status.tick) == sent_ticks_.end();
    for (const auto& [number, track] : tracks_)
        stands = stands && static_cast<ChannelState>(status.channels[number - 1].state) !=
                               ChannelState::Running;
    for (const AxisStatus& axis : status.axes) stands = stands && !(axis.flags & kMoving);
    if (!stands) still_since_ = now;
    if (now - still_since_ < std::chrono::milliseconds(500)) return;
    log_tick_ = std::max(log_tick_, status.tick);
    take_idle(static_cast<double>(status.tick - origin_) * tick_s_);
}

void RunSession::give_out(const EventJoiner::Event& event) {
    const std::string_view kind = event_kind(event.text);
    if (record_.wanted) record_.add(event.text, event.t_s, event.end_s, true);
    if (options_.quiet && !passes_quiet(kind)) return;
    output_.write(event.text);
    output_.write("\n");
}

}  // namespace polyturn::supervisor
