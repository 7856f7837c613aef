#include "kernel/supervisor/base/controller.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <limits>

#include "ipc/model/machine/drive_sources.hpp"
#include "ipc/requests/store_requests.hpp"

namespace polyturn::supervisor {

namespace {

// a loaded computer that starts sanitised programs
constexpr auto kAttachTimeout = std::chrono::seconds(20);

// P3: a flag, announces nothing
std::atomic<bool> g_end{false};

std::string program_of(std::size_t slot) {
    switch (slot) {
        case kProcessKernel:
            return "polyturn-kernel";
        case kProcessPlc:
            return "polyturn-plc";
        case kProcessStore:
            return "polyturn-toolmgmt";
        case kProcessHmi:
            return "polyturn-hmi";
        case kProcessCell:
            return "polyturn-cell";
        case kProcessDrives:
            return "polyturn-drives";
        default:
            return "polyturn-channel";
    }
}

}  // namespace

void catch_signals() {
    struct sigaction action {};
    action.sa_handler = [](int) {};  // no SA_RESTART: waits return
    sigaction(SIGCHLD, &action, nullptr);
    action.sa_handler = [](int) { g_end = true; };
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGHUP, &action, nullptr);
}

bool end_requested() { return g_end; }

std::string private_instance_name() {
    std::uint32_t random = 0;
    if (getrandom(&random, sizeof random, GRND_NONBLOCK) < 0)
        random = static_cast<std::uint32_t>(getpid());
    return fmt::format("run-{}-{:08x}", getpid(), random);
}

std::uint64_t new_generation() {
    std::uint64_t random = 0;
    if (getrandom(&random, sizeof random, GRND_NONBLOCK) != sizeof random)
        random =
            static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
    return random | 1;  // never 0
}

Result<std::unique_ptr<Controller>> Controller::start(ControllerPlan plan) {
    std::unique_ptr<Controller> out(new Controller(std::move(plan)));
    if (auto launched = out->launch(); !launched) return launched.diagnosis();
    return out;
}

Controller::~Controller() {
    children_.clear();  // SIGKILL and reaped
    if (own_) remove_instance(plan_.instance);
}

void Controller::mark(std::size_t slot, ProcessState state, int pid) {
    ProcessEntry& entry = own().processes[slot];
    entry.pid = pid;
    // P1: whoever sees the state sees this pid
    entry.state.store(static_cast<std::uint32_t>(state), std::memory_order_release);
}

namespace {
// A controller of this name whose supervisor was killed: its kernel brings the machine to rest
// before it ends, and its store holds the disk until then (ipc/memory/life_line.hpp). Two must
// never drive the same machine.
Result<void> wait_for_predecessor(const std::string& instance) {
    constexpr auto kMost = std::chrono::seconds(150);
    auto before = PeerSegment<SupervisorSegment>::attach(instance, 0, std::chrono::milliseconds(1));
    // none, or one that lives: that is somebody else's question
    if (!before || kill((*before)->header.writer_pid, 0) == 0) return {};
    const auto until = std::chrono::steady_clock::now() + kMost;
    for (std::size_t slot = 0; slot < kProcesses; ++slot) {
        const int pid = (*before)->processes[slot].pid;
        std::error_code none;
        const auto ours = [&] {
            return pid > 0 &&
                   std::filesystem::read_symlink("/proc/" + std::to_string(pid) + "/exe", none)
                       .filename()
                       .string()
                       .starts_with("polyturn-");
        };
        while (ours()) {
            if (std::chrono::steady_clock::now() > until)
                return Diagnosis{Alarm::ProcessStart,
                                 {},
                                 {},
                                 "a process of an earlier controller of this name has not ended: " +
                                     std::to_string(pid)};
            sleep_ms(10);
        }
    }
    return {};
}
}  // namespace

Result<void> Controller::launch() {
    if (auto waited = wait_for_predecessor(plan_.instance); !waited) return waited;
    remove_instance(plan_.instance);  // what one that was killed has left in memory
    auto own = OwnSegment<SupervisorSegment>::create(plan_.instance, plan_.generation);
    if (!own) return own.diagnosis();
    own_ = std::make_unique<OwnSegment<SupervisorSegment>>(std::move(*own));
    (*own_)->options = plan_.options;
    // Who will take part is said before the kernel starts: virtual time does not begin without
    // them.
    for (const std::size_t slot : {kProcessStore, kProcessKernel, kProcessPlc})
        mark(slot, ProcessState::Starting, 0);
    for (const unsigned number : plan_.channels)
        mark(kProcessChannel + number - 1, ProcessState::Starting, 0);
    own_->publish();

    if (auto done = spawn(kProcessStore); !done) return done;
    auto store = attach<StoreSegment>(kProcessStore, 0);
    if (!store) return store.diagnosis();
    store_ = std::make_unique<PeerSegment<StoreSegment>>(std::move(*store));
    requests_ = std::make_unique<RingProducer<RingHead<StoreRequest, 256>>>(
        (*own_)->requests, (*store_)->request_tail);
    answers_ = std::make_unique<RingConsumer<RingHead<StoreAnswer, 256>>>((*store_)->answers,
                                                                          (*own_)->answer_tail);

    if (auto done = spawn(kProcessKernel); !done) return done;
    auto kernel = attach<KernelSegment>(kProcessKernel, 0);
    if (!kernel) return kernel.diagnosis();
    kernel_ = std::make_unique<PeerSegment<KernelSegment>>(std::move(*kernel));
    commands_ = std::make_unique<RingProducer<RingHead<Command, 1024>>>((*own_)->commands,
                                                                        (*kernel_)->command_tail);

    const auto table = std::make_unique<params::Table>();
    if ((*store_)->parameters.read(*table) && wanted_drives(*table).process)
        if (auto done = spawn(kProcessDrives); !done) return done;
    if (auto done = spawn(kProcessPlc); !done) return done;
    for (const unsigned number : plan_.channels)
        if (auto done = spawn(kProcessChannel + number - 1); !done) return done;
    for (const unsigned number : plan_.channels) {
        auto channel = attach<ChannelSegment>(kProcessChannel + number - 1, number);
        if (!channel) return channel.diagnosis();
        channels_.insert_or_assign(number, std::move(*channel));
    }
    return {};
}

Result<void> Controller::spawn(std::size_t slot) {
    std::vector<std::string> arguments = {"--instance", plan_.instance};
    const auto store =
        std::find(plan_.store_arguments.begin(), plan_.store_arguments.end(), "--store");
    const std::string retained =
        store != plan_.store_arguments.end() && store + 1 != plan_.store_arguments.end()
            ? *(store + 1)
            : std::string();
    if (slot == kProcessStore) {
        arguments.insert(arguments.end(), plan_.store_arguments.begin(),
                         plan_.store_arguments.end());
        arguments.insert(arguments.end(), plan_.machine_arguments.begin(),
                         plan_.machine_arguments.end());
    } else if (slot == kProcessPlc) {
        if (!plan_.plc_library.empty())
            arguments.insert(arguments.end(), {"--library", plan_.plc_library});
        if (!retained.empty())
            arguments.insert(arguments.end(), {"--retained", retained + "/plc.retained"});
    } else if (slot >= kProcessChannel) {
        arguments.insert(arguments.end(),
                         {"--channel", std::to_string(slot - kProcessChannel + 1)});
        arguments.insert(arguments.end(), plan_.channel_arguments.begin(),
                         plan_.channel_arguments.end());
        if (!retained.empty()) arguments.insert(arguments.end(), {"--retained", retained});
    }
    const bool own_drives = slot == kProcessDrives && !plan_.drives_program.empty();
    // nothing of the machine hangs on them
    const bool shows = slot == kProcessHmi || slot == kProcessCell;
    auto child =
        Child::start(own_drives ? plan_.drives_program : program_of(slot), arguments, {},
                     shows ? Child::WhenLeftAlone::Dies : Child::WhenLeftAlone::EndsInOrder);
    if (!child) return child.diagnosis();
    const int pid = child->pid();
    children_.insert_or_assign(slot, std::move(*child));
    mark(slot, ProcessState::Running, pid);
    return {};
}

template <class Layout>
Result<PeerSegment<Layout>> Controller::attach(std::size_t slot, std::size_t number) {
    const auto until = std::chrono::steady_clock::now() + kAttachTimeout;
    for (;;) {
        beat();  // a kernel that is there already watches whether this process lives
        auto peer =
            PeerSegment<Layout>::attach(plan_.instance, number, std::chrono::milliseconds(5));
        if (peer) {
            // A segment that a dead predecessor left is not this one's.
            if ((*peer)->header.writer_pid == children_[slot].pid()) return peer;
        } else if (peer.diagnosis().alarm == Alarm::SegmentLayout) {
            return peer.diagnosis();
        }
        if (children_[slot].reap())
            return Diagnosis{Alarm::ProcessDied,
                             {},
                             {},
                             fmt::format("{} {} while it started", program_of(slot),
                                         describe_end(children_[slot].status()))};
        if (std::chrono::steady_clock::now() > until)
            return Diagnosis{
                Alarm::NoProgress, {}, {}, fmt::format("{} does not get ready", program_of(slot))};
        if (end_requested())
            return Diagnosis{Alarm::ProcessDied, {}, {}, "stopped while it started"};
    }
}

const ChannelSegment* Controller::channel(unsigned number) const {
    const auto found = channels_.find(number);
    return found == channels_.end() ? nullptr : &*found->second;
}

std::uint64_t Controller::send(Command command, std::int64_t tick) {
    command.tick = tick;
    command.seq = ++sequence_;
    if (batching_) {
        batch_.push_back(command);
        return command.seq;
    }
    while (!send_kept() || !commands_->push(command)) {
        own().bell.ring();
        // it will not be read
        if (end_requested() || children_[kProcessKernel].reap() ||
            !children_[kProcessKernel].running())
            return command.seq;
        sleep_ms(1);
    }
    own().bell.ring();
    return command.seq;
}

bool Controller::try_send(const std::vector<Command>& commands, bool stop) {
    if (!send_kept()) return false;
    // P4: own head. P3: how much room; push() looks itself (P2)
    const auto used = own().commands.head.load(std::memory_order_relaxed) -
                      kernel().command_tail.tail.load(std::memory_order_acquire);
    if (used + commands.size() + (stop ? 0 : kKeptForStops) > own().commands.capacity) return false;
    for (Command command : commands) {
        command.tick = 0;
        command.seq = ++sequence_;
        if (!commands_->push(command)) return false;  // cannot be: there was room
    }
    own().bell.ring();
    return true;
}

void Controller::post(const Command& command) {
    Command next = command;
    next.tick = 0;
    next.seq = ++sequence_;
    kept_.push_back(next);
    (void)send_kept();
    own().bell.ring();
}

bool Controller::send_kept() {
    for (; !kept_.empty(); kept_.pop_front())
        if (!commands_->push(kept_.front())) return false;
    return true;
}

void Controller::end_batch() {
    batching_ = false;
    auto& ring = own().commands;
    // P4: own head. P2: the kernel has read what lay in the free slots
    const auto head = ring.head.load(std::memory_order_relaxed);
    const auto tail = kernel().command_tail.tail.load(std::memory_order_acquire);
    // Earliest first: if they do not all fit, the rest is due late enough to come singly.
    std::stable_sort(batch_.begin(), batch_.end(),
                     [](const Command& a, const Command& b) { return a.tick < b.tick; });
    const std::size_t fit = std::min<std::size_t>(batch_.size(), ring.capacity - (head - tail));
    for (std::size_t i = 0; i < fit; ++i) ring.slot(head + i) = batch_[i];
    // P1: all of the batch at once
    ring.head.store(head + fit, std::memory_order_release);
    own().bell.ring();
    std::vector<Command> rest(batch_.begin() + static_cast<std::ptrdiff_t>(fit), batch_.end());
    batch_.clear();
    for (const Command& command : rest)
        while (!commands_->push(command)) {
            own().bell.ring();
            if (end_requested() || !children_[kProcessKernel].running() ||
                children_[kProcessKernel].reap())
                return;
            sleep_ms(1);
        }
    if (!rest.empty()) own().bell.ring();
}

bool Controller::ask_store(const StoreRequest& request) {
    StoreRequest copy = request;
    copy.id = request_ + 1;
    if (!requests_->push(copy)) return false;
    ++request_;
    own().store_bell.ring();
    return true;
}

bool Controller::next_answer(StoreAnswer& answer) {
    const StoreAnswer* next = answers_->front();
    if (!next) return false;
    answer = *next;
    answers_->pop();
    return true;
}

bool Controller::running(std::size_t slot) const {
    const auto found = children_.find(slot);
    return found != children_.end() && found->second.running();
}

void Controller::watch(const std::function<void(std::size_t, int)>& on_death) {
    for (auto& [slot, child] : children_) {
        if (!child.running() || !child.reap()) continue;
        mark(slot, ProcessState::Dead, 0);
        if (slot != kProcessKernel && running(kProcessKernel)) {
            Command died{};
            died.kind = static_cast<std::uint32_t>(CommandKind::ProcessDied);
            died.object = static_cast<std::uint32_t>(slot);
            post(died);
        }
        on_death(slot, child.status());
    }
}

void Controller::act(const ProcessAction& action,
                     const std::function<void(std::size_t, int)>& on_death) {
    const auto found = children_.find(action.slot);
    if (found == children_.end() || !found->second.running()) return;
    Command told{};
    told.object = static_cast<std::uint32_t>(action.slot);
    switch (action.kind) {
        case ProcessAction::Kind::Kill: {
            found->second.kill_and_reap();
            mark(action.slot, ProcessState::Dead, 0);
            if (action.slot != kProcessKernel) {
                told.kind = static_cast<std::uint32_t>(CommandKind::ProcessDied);
                post(told);
            }
            on_death(action.slot, found->second.status());
            return;
        }
        case ProcessAction::Kind::Stop:
            found->second.signal(SIGSTOP);
            mark(action.slot, ProcessState::Stopped, found->second.pid());
            told.kind = static_cast<std::uint32_t>(CommandKind::ProcessStopped);
            break;
        case ProcessAction::Kind::Continue:
            found->second.signal(SIGCONT);
            mark(action.slot, ProcessState::Running, found->second.pid());
            told.kind = static_cast<std::uint32_t>(CommandKind::ProcessContinued);
            break;
    }
    if (action.slot != kProcessKernel) post(told);
}

// What a request that is passed over looks like: a piece of an operation whose beginning is not
// there. The store takes it and says nothing.
void Controller::forget_requests() {
    auto& ring = own().requests;
    // P4: own head. P2: behind the tail the dead store has taken nothing
    const auto head = ring.head.load(std::memory_order_relaxed);
    for (auto i = (*store_)->request_tail.tail.load(std::memory_order_acquire); i < head; ++i) {
        const std::uint64_t id = ring.slot(i).id;
        ring.slot(i) = store_request(StoreRequestKind::Operation, 0,
                                     std::numeric_limits<std::int32_t>::max(), kMoreFollows, 0.0);
        ring.slot(i).id = id;
    }
}

void Controller::forget_taken_requests() {
    auto& ring = own().requests;
    // P4: own head. P2: the store has read what lies before its tail
    const auto head = ring.head.load(std::memory_order_relaxed),
               tail = (*store_)->request_tail.tail.load(std::memory_order_acquire);
    for (auto i = head > ring.capacity ? head - ring.capacity : 0; i < tail; ++i)
        ring.slot(i).name.fill(0);
}

Result<void> Controller::restart(std::size_t slot) {
    if (auto done = spawn(slot); !done) return done;
    if (slot < kProcessChannel) return {};
    const unsigned number = static_cast<unsigned>(slot - kProcessChannel + 1);
    auto channel = attach<ChannelSegment>(slot, number);
    if (!channel) return channel.diagnosis();
    channels_.insert_or_assign(number, std::move(*channel));
    return {};
}

Result<void> Controller::begin_restart(std::size_t slot) {
    if (auto done = spawn(slot); !done) return done;
    if (slot >= kProcessChannel) awaited_[slot] = std::chrono::steady_clock::now() + kAttachTimeout;
    return {};
}

void Controller::look_for_successors(const std::function<void(const Diagnosis&)>& on_fault) {
    std::erase_if(awaited_, [&](const auto& one) {
        const auto& [slot, until] = one;
        Child& child = children_[slot];
        if (!child.running()) return true;  // watch() reports it
        const auto number = static_cast<unsigned>(slot - kProcessChannel + 1);
        auto peer = PeerSegment<ChannelSegment>::attach(plan_.instance, number,
                                                        std::chrono::milliseconds(0));
        if (peer && (*peer)->header.writer_pid == child.pid()) {
            channels_.insert_or_assign(number, std::move(*peer));
            return true;
        }
        const bool wrong = !peer && peer.diagnosis().alarm == Alarm::SegmentLayout;
        if (!wrong && std::chrono::steady_clock::now() < until) return false;
        on_fault(wrong ? peer.diagnosis()
                       : Diagnosis{Alarm::NoProgress,
                                   {},
                                   {},
                                   fmt::format("{} does not get ready", program_of(slot))});
        child.signal(SIGKILL);  // its death is seen, and counted
        return true;
    });
}

void Controller::beat() {
    // P3: a counter, announces nothing (the order is stronger than needed)
    own().heartbeat.fetch_add(1, std::memory_order_release);
    if (!kept_.empty()) (void)send_kept();
}

void Controller::wait(std::uint32_t seen, std::int64_t timeout_us, int spins) const {
    kernel().supervisor_bell.wait(seen, timeout_us, spins);
}

void Controller::stop_kernel(int timeout_ms) {
    if (!kernel_ || !running(kProcessKernel)) return;
    Child& kernel = children_[kProcessKernel];
    // a stopped one could neither take the command nor stop an axis
    kernel.signal(SIGCONT);
    Command end{};
    end.kind = static_cast<std::uint32_t>(CommandKind::EndRun);
    end.seq = ++sequence_;
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
    bool sent = false;
    while (!(sent = send_kept() && commands_->push(end)) && !kernel.reap() &&
           std::chrono::steady_clock::now() < until) {
        own().bell.ring();
        sleep_ms(1);
    }
    own().bell.ring();
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
                          until - std::chrono::steady_clock::now())
                          .count();
    kernel.end_within(sent ? static_cast<int>(std::max<std::int64_t>(left, 1)) : 1);
}

void Controller::stop(int timeout_ms) {
    stop_kernel(timeout_ms);
    mark(kProcessKernel, ProcessState::Dead, 0);
    for (auto& [slot, child] : children_)
        if (child.running()) {
            child.signal(SIGCONT);
            child.signal(SIGTERM);
        }
    // The store last: what the others still wrote must reach the disk.
    for (auto& [slot, child] : children_)
        if (slot != kProcessStore) child.end_within(1000);
    children_[kProcessStore].end_within(timeout_ms);
}

}  // namespace polyturn::supervisor
