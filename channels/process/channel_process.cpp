#include "channels/process/channel_process.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

namespace polyturn::channels {
namespace {

// for the processes that start before this one
constexpr auto kTimeout = std::chrono::milliseconds(10'000);
constexpr std::int64_t kSleepUs = 50'000;
constexpr int kStepsBetweenLooks = 32;
constexpr auto kVariablesEvery = std::chrono::milliseconds(100);  // for screens
constexpr std::size_t kNames = 32, kNameSize = 256;

std::string_view text_of(const ChannelEvent& event) {
    return {event.text.data(), ::strnlen(event.text.data(), event.text.size())};
}

}  // namespace

Result<std::unique_ptr<ChannelProcess>> ChannelProcess::create(const std::string& instance,
                                                               unsigned channel,
                                                               ProcessServices services) {
    auto supervisor = PeerSegment<SupervisorSegment>::attach(instance, 0, kTimeout);
    if (!supervisor) return supervisor.diagnosis();
    auto store = PeerSegment<StoreSegment>::attach(instance, 0, kTimeout);
    if (!store) return store.diagnosis();
    auto kernel = PeerSegment<KernelSegment>::attach(instance, 0, kTimeout);
    if (!kernel) return kernel.diagnosis();
    auto own = OwnSegment<ChannelSegment>::create(instance, (*kernel)->header.generation, channel);
    if (!own) return own.diagnosis();
    return std::unique_ptr<ChannelProcess>(
        new ChannelProcess(std::move(*supervisor), std::move(*store), std::move(*kernel),
                           std::move(*own), channel, std::move(services)));
}

ChannelProcess::ChannelProcess(PeerSegment<SupervisorSegment> supervisor,
                               PeerSegment<StoreSegment> store, PeerSegment<KernelSegment> kernel,
                               OwnSegment<ChannelSegment> own, unsigned channel,
                               ProcessServices services)
    : supervisor_(std::move(supervisor)),
      store_(std::move(store)),
      kernel_(std::move(kernel)),
      own_(std::move(own)),
      channel_(channel),
      services_(std::move(services)),
      inbox_([&]() -> EventInbox {
          // A successor has seen no event that was sent to its predecessor, and must not.
          // P3: of the kernel's head only the value counts; own tail before own_.publish() (P1)
          own_->event_tail.tail.store(
              kernel_->events[channel - 1].head.load(std::memory_order_acquire),
              std::memory_order_relaxed);
          return {*kernel_, channel - 1, *own_};
      }()),
      notes_(own_->notes, supervisor_->note_tail[channel - 1]),
      port_(*kernel_, channel),
      pictures_(*own_),
      dialogue_(*own_) {
    // P4: own tail. P1: nobody sees the rest before own_.publish()
    seen_event_ = own_->event_tail.tail.load(std::memory_order_relaxed);
    own_->quiet.store(seen_event_, std::memory_order_relaxed);
    own_->notes.head.store(supervisor_->note_tail[channel - 1].load(std::memory_order_acquire),
                           std::memory_order_relaxed);
    // P1: seen with own_.publish()
    own_->epoch.store(1, std::memory_order_relaxed);
    own_.publish();
    auto table = std::make_unique<params::Table>();
    while (!store_->parameters.read(*table)) {}
    const auto horizon = static_cast<std::uint64_t>(params::get(*table, params::pt_horizon));
    ring_ = std::make_unique<RingOut>(*own_, *kernel_, channel - 1, horizon, inbox_);
    transformed_ = std::make_unique<TransformedOut>(*ring_, limits_);
    maker_ = std::make_unique<PathMaker>(*transformed_, limits_);
    inbox_.on_question = [this](const ChannelEvent& event) { ask_resume(event); };
    port_.keep_in(services_.kept_folder);
    own_->bell.ring();
}

void ChannelProcess::run() {
    while (turn(true)) {}
}

bool ChannelProcess::turn(bool sleep) {
    if (quit_) return false;
    const Doorbell& bell = kernel_->channel_bell[channel_ - 1];
    const std::uint32_t rings = bell.seen();
    // P3: a counter, announces nothing
    own_->heartbeat.fetch_add(1, std::memory_order_relaxed);
    inbox_.poll();
    if (!inbox_.empty()) {
        act(inbox_.take());
        return !quit_;
    }
    if (state_ == State::Reading) {
        read_program();
        return true;
    }
    say_quiet();
    if (sleep) bell.wait(rings, kSleepUs);
    return true;
}

void ChannelProcess::say_quiet() {
    // P4: own word
    if (own_->quiet.load(std::memory_order_relaxed) == seen_event_) return;
    // P1: everything pushed is visible with it
    own_->quiet.store(seen_event_, std::memory_order_release);
    own_->bell.ring();
}

void ChannelProcess::act(const ChannelEvent& event) {
    seen_event_ = event.seq;
    switch (static_cast<ChannelEventKind>(event.kind)) {
        case ChannelEventKind::CycleStart:
            if (state_ != State::Idle) break;  // the kernel starts only what rests
            parts_left_ = event.value > 1 ? event.value : 1;
            running_ = choice_;
            running_.mdi = std::string(text_of(event));
            if (!running_.mdi.empty()) running_.beside = std::exchange(running_.path, {});
            begin_program();
            break;
        case ChannelEventKind::BarrierReached:
            if (state_ == State::Standing && event.record >= sink_->drain_index()) go_on();
            break;
        case ChannelEventKind::Reset:
            reset(event);
            break;
        case ChannelEventKind::StoreChanged:
            store_changed_ = true;
            break;
        case ChannelEventKind::SelectProgram:
            choice_.path = std::string(text_of(event));
            choice_.language = static_cast<Dialect>(event.value);
            publish_choice();
            break;
        case ChannelEventKind::Quit:
            quit_ = true;
            break;
        case ChannelEventKind::Interrupt:
            if (event.record & kInterruptAhead)
                interrupt_ahead(event);
            else
                interrupt(event);
            break;
        case ChannelEventKind::Restart:
            restart(event);
            break;
        case ChannelEventKind::AskResume:
            break;  // answered when it came
        case ChannelEventKind::Resume:
            resume(event);
            break;
        case ChannelEventKind::HeldMdi:
            held_mdi(event);
            break;
        case ChannelEventKind::DialogueValue:
            if (state_ != State::Standing) break;
            port_.answers().values.emplace_back(std::string(text_of(event)), event.value);
            dialogue_.entered(text_of(event), event.value);
            break;
        case ChannelEventKind::DialogueKey:
            if (state_ == State::Standing) port_.answers().key = static_cast<int>(event.value);
            break;
        case ChannelEventKind::None:
            break;
    }
}

// What was written before is applied over there first; the program then sees all of it.
bool ChannelProcess::take_store() {
    // P1, P2: what was pushed before this head is applied and published when the tail has passed it
    const std::uint64_t asked = kernel_->persist.head.load(std::memory_order_acquire);
    const Doorbell& bell = store_->bell;
    while (store_->persist_tail.tail.load(std::memory_order_acquire) < asked) {
        const std::uint32_t rings = bell.seen();
        // P3: a counter, announces nothing
        own_->heartbeat.fetch_add(1, std::memory_order_relaxed);
        inbox_.poll();
        if (inbox_.interrupts()) return false;
        // P1, P6: checked again behind bell.seen()
        if (store_->persist_tail.tail.load(std::memory_order_acquire) < asked)
            bell.wait(rings, 5'000);
    }
    while (!store_->channels[channel_ - 1].read(*view_->store)) {}
    if (run_ && changes_.look(*view_->store)) operator_changed_ = true;
    take_shared();
    if (const CommonOffsets common = common_offsets(*view_); common.count) {
        while (!store_->channels[common.channel - 1].read(*first_store_)) {}
        take_common_offsets(*view_->store, *first_store_, common);
    }
    store_changed_ = false;
    return true;
}

// Variables of all channels lie in the first one's store. What is empty there keeps what the setup
// has given here.
void ChannelProcess::take_shared() {
    if (!first_store_) first_store_ = std::make_unique<ChannelStore>();
    while (!store_->channels[0].read(*first_store_)) {}
    for (std::size_t k = 0; k < view_->shared->size(); ++k)
        if (const double value = first_store_->variables[k < 400 ? 500 + k : k - 400];
            !std::isnan(value))
            (*view_->shared)[k] = value;
}

void ChannelProcess::begin_program() {
    auto table = std::make_unique<params::Table>();
    while (!store_->parameters.read(*table)) {}
    if (run_) carried_ = run_->carry();
    run_.reset();
    held_run_.reset();
    if (sink_) last_note_ = sink_->next_note() - 1;
    sink_.reset();
    describer_.reset();
    // made in place: its names point into itself
    view_.reset(new MachineView(make_machine_view(*table, channel_)));
    if (!take_store()) return;
    port_.configure(view_->machine, services_.setup);
    port_.tools_from(params::bit(*table, params::n2900_tool_m_config, 0) ? &*store_ : nullptr);
    port_.print_positioning(running_.path, params::get_text(*table, params::pt_print_to, channel_));
    port_.pretend({});
    port_.look();
    take_routes(*view_, port_.picture().route);
    for (unsigned i = 0; i < view_->axis_count; ++i)
        view_->start[i] = *port_.axis_command(view_->axes[i].machine_axis);
    take_limits();
    maker_->discard();
    maker_->use_limits(limits_);
    ring_->resume();
    if (supervisor_->options.notes && services_.make_describer)
        describer_ = services_.make_describer(*view_, note_text_);
    sink_ = std::make_unique<RecordSink>(
        *view_, *maker_, *ring_, describer_.get(), &note_text_,
        [this](std::uint64_t number, std::string_view text) { put_note(number, text); });
    sink_->transforms(*transformed_, limits_);
    sink_->continue_notes(last_note_);
    sink_->more_parts(parts_left_ > 1);
    sink_->tell_writes(&changes_);
    sink_->on_dialogue([this](const DialoguePage& page) {
        port_.answers() = {};
        dialogue_.show(page);
    });
    if (!looked_at_) looked_at_ = std::make_unique<ChannelStore>();
    while (!store_->channels[channel_ - 1].read(*looked_at_)) {}
    changes_.begin(*looked_at_);
    operator_changed_ = false;
    resume_sink_ = std::make_unique<ResumeSink>(*view_, *sink_);
    restart_sink_ = std::make_unique<RestartSink>(*view_, *resume_sink_);
    if (restart_to_) {
        restart_sink_->search(*restart_to_, restart_set_);
        if (port_.tools_kept())
            restart_sink_->look_up_tool = [this](const Aux& code, const BlockContext& at) {
                sink_->look_up_tool(code, at);
            };
        port_.pretend([this](unsigned axis) { return restart_sink_->position(axis); });
        restart_to_.reset();
    }
    run_ = services_.make_run(*view_, *restart_sink_, port_, running_);
    names_published_ = 0;
    pictures_.begin();
    next_part_ = false;
    if (const auto started = run_->start(); !started) {
        fail(started.diagnosis());
        return;
    }
    run_->keep_resume_states(true);
    // P3: a flag; the blocks of the program come with their push (the order is stronger than
    // needed)
    own_->starts_away.store(run_->starts_away(), std::memory_order_release);
    if (carried_.has_value()) run_->take_carry(carried_, after_reset_);
    after_reset_ = false;
    state_ = State::Reading;
}

// Limits of this channel's axes, lowered where others hang on them.
void ChannelProcess::take_limits() {
    limits_ = path_limits(view_->machine, view_->table(), channel_);
    couplings_ = couplings_of(port_.picture());
    lower_for_couplings(limits_, couplings_);
}

// The barrier has been executed: take what has changed outside, then read on.
void ChannelProcess::go_on() {
    port_.look();
    sink_->barrier_done();
    if (next_part_) {
        begin_program();
        return;
    }
    const bool shares = params::get(view_->table(), params::f6036, channel_) > 0 ||
                        params::get(view_->table(), params::f6037, channel_) > 0 ||
                        params::get(view_->table(), params::n1700_no_of_common_100) > 0 ||
                        params::get(view_->table(), params::n1701_no_of_common_500) > 0;
    if ((store_changed_ || shares || common_offsets(*view_).count) && !take_store()) return;
    take_routes(*view_, port_.picture().route);
    if (couplings_of(port_.picture()) != couplings_) {
        take_limits();
        sink_->limits_changed();
    }
    sink_->skip_ended(port_);
    take_changes();
    dialogue_.clear();
    run_->barrier_done();
    state_ = State::Reading;
}

void ChannelProcess::read_program() {
    forget_executed();
    for (int n = 0; n < kStepsBetweenLooks; ++n) {
        const Step step = run_->step();
        if (run_->file_count() != names_published_) publish_names();
        if (ring_->aborted()) return;  // the interrupt that caused it is in the inbox
        if (restart_sink_->searching()) {
            restart_sink_->block_read(run_->at());
            if (step == Step::Ended)
                return fail({Alarm::RestartNoBlock,
                             {running_.path, 0, 0, 0},
                             {},
                             "N" + std::to_string(restart_sink_->wanted())});
        }
        if (!restart_sink_->searching()) {
            port_.pretend({});
            show_block();
            show_variables(step != Step::Continue);
        }
        switch (step) {
            case Step::Continue:
                break;
            case Step::AtBarrier:
                sink_->reach_barrier();
                state_ = State::Standing;
                return;
            case Step::Ended:
                end_program(StopReason::End);
                return;
            case Step::Failed:
                end_program(StopReason::Alarm);
                return;
        }
    }
}

void ChannelProcess::end_program(StopReason reason) {
    if (reason != StopReason::Alarm && !sink_->failed() && parts_left_ > 1 && !held_run_) {
        parts_left_ -= 1;
        sink_->end_of_part();
        next_part_ = true;
        state_ = State::Standing;
        return;
    }
    sink_->finish(reason);
    if (!held_run_ && ring_->pushed() > 0 && run_->loses_offset(false))
        pictures_.offset_lost(own_->path.slot(ring_->last_index()).serial);
    state_ = State::Idle;
}

void ChannelProcess::fail(const Diagnosis& diagnosis) {
    sink_->alarm(diagnosis, {});
    sink_->finish(StopReason::Alarm);
    state_ = State::Idle;
}

// What is only read ahead has not happened (architecture 5.4): what the program leaves to the next
// one is what it had before `serial`, the first block of which nothing had begun. Blocks that wait
// for another one under compensation stay as they were read.
void ChannelProcess::forget_read_ahead(std::uint64_t serial) {
    if (serial && run_->may_resume_at(serial)) {
        sink_->forget();
        (void)run_->resume_at(serial);
    }
}

void ChannelProcess::reset(const ChannelEvent& event) {
    maker_->discard();
    ring_->resume();
    if (held_run_) run_ = std::move(held_run_);
    if (run_) forget_read_ahead(static_cast<std::uint64_t>(event.value));
    if (run_) carried_ = run_->carry();
    if (const std::uint64_t pushed = ring_->pushed(); run_ && pushed > 0)
        pictures_.reset(own_->path.slot(std::min(event.record, pushed - 1)).serial,
                        static_cast<std::uint64_t>(event.value), run_->loses_offset(true));
    run_.reset();
    after_reset_ = true;
    state_ = State::Idle;
    next_part_ = ahead_ = false;
    // P1: the picture of what holds now is there
    own_->epoch.store(event.epoch, std::memory_order_release);
    port_.answers() = {};
    dialogue_.clear();
}

// The path has stopped for the program's own interrupt signal: interpretation goes back to there.
void ChannelProcess::interrupt(const ChannelEvent& event) {
    maker_->discard();
    ring_->resume();
    // P3: a number; each record carries its own (the order is stronger than needed)
    own_->epoch.store(event.epoch, std::memory_order_release);
    if (!run_) return;
    port_.look();
    sink_->forget();
    if (std::exchange(ahead_, false)) {
        run_->interrupt_arrived();
        sink_->push_kept();
    } else if (!run_->interrupt(static_cast<std::uint64_t>(event.value), (event.record & 1) != 0,
                                static_cast<unsigned>(event.record >> 1))) {
        fail({Alarm::InterruptPlace, {}, {}, {}});
        return;
    }
    state_ = State::Reading;
}

// The path has not yet reached the start of the interrupt program: its immediate actions are
// done now.
void ChannelProcess::interrupt_ahead(const ChannelEvent& event) {
    if (run_ && !held_run_ && !next_part_ && !restart_sink_->searching()) {
        port_.look();
        sink_->at_once(true);
        ahead_ = run_->interrupt_ahead(static_cast<std::uint64_t>(event.value));
        sink_->at_once(false);
        // no barrier is pending: the path stops before the next block
        if (ahead_) state_ = State::Standing;
    }
    // P1: what was pushed ahead is visible with it
    own_->answered.store(event.seq, std::memory_order_release);
    own_->bell.ring();
}

// States from before the record that the path is at are needed no more.
void ChannelProcess::forget_executed() {
    // P3: how far, nothing is written over
    const std::uint64_t tail =
        kernel_->path_tail[channel_ - 1].tail.load(std::memory_order_acquire);
    if (tail < ring_->pushed() &&
        // P4: own word
        own_->path.slot(tail).epoch == own_->epoch.load(std::memory_order_relaxed))
        run_->executed(own_->path.slot(tail).serial);
}

void ChannelProcess::publish_names() {
    names_published_ = run_->file_count();
    ProgramNames& names = own_->programs.draft();
    names.count = static_cast<std::uint32_t>(std::min(names_published_, kNames));
    names.running = 0;
    names.name.fill(0);
    for (std::size_t i = 0; i < names.count; ++i) {
        const std::string name = run_->file_name(i);
        std::memcpy(&names.name[i * kNameSize], name.data(), std::min(name.size(), kNameSize - 1));
    }
    own_->programs.publish();
}

// A program is selected: screens show it before it is started.
void ChannelProcess::publish_choice() {
    ProgramNames& names = own_->programs.draft();
    names.count = 1;
    names.running = 0;
    names.name.fill(0);
    std::memcpy(names.name.data(), choice_.path.data(),
                std::min(choice_.path.size(), kNameSize - 1));
    own_->programs.publish();
    pictures_.begin();
}

void ChannelProcess::show_block() {
    const Core* core = run_->core();
    if (!core) return;
    codes_.clear();
    run_->active_codes(codes_);
    pictures_.look(*core, codes_);
}

// In real time only: a virtual run is not watched, and what a clock decides must not be in it.
void ChannelProcess::show_variables(bool now) {
    if (supervisor_->options.virtual_time != 0) return;
    const auto time = std::chrono::steady_clock::now();
    if (!now && time < variables_due_) return;
    variables_due_ = time + kVariablesEvery;
    VariableList& list = own_->variables.draft();
    list.count = list.more = 0;
    run_->list_variables([&](std::string_view name, double value) {
        if (list.count == list.rows.size()) return void(++list.more);
        NamedValue& row = list.rows[list.count++];
        row.name.fill(0);
        std::memcpy(row.name.data(), name.data(), std::min(name.size(), row.name.size() - 1));
        row.value = value;
    });
    own_->variables.publish();
}

void ChannelProcess::put_note(std::uint64_t number, std::string_view text) {
    while (!ring_->aborted() && !notes_.push(number, text)) {
        const std::uint32_t rings = supervisor_->bell.seen();
        if (!ring_->may_wait()) return;
        if (notes_.push(number, text)) return;
        supervisor_->bell.wait(rings, 5'000);
    }
}

}  // namespace polyturn::channels
