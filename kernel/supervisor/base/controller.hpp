// One running controller as its supervisor sees it: the processes, their segments, the commands to
// the kernel.
//
// Order of the start: supervisor's segment, toolmgmt (parameters and offsets), kernel, PLC,
// channels. Every process dies with this one. A process counts as dead only when it has been reaped
// (architecture 4.4); then the kernel is notified.
#pragma once
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ipc/memory/segment.hpp"
#include "kernel/supervisor/base/child.hpp"
#include "kernel/supervisor/run/scenario_player.hpp"

namespace polyturn::supervisor {

// Which start of a controller a segment belongs to: one that was killed leaves its own behind under
// the same names.
std::uint64_t new_generation();

struct ControllerPlan {
    std::string instance;
    std::uint64_t generation = new_generation();
    RunOptions options{};
    // for toolmgmt: --machine, --set, --param-file, --setup
    std::vector<std::string> machine_arguments;
    std::vector<std::string> store_arguments;    // --memory or --store DIR
    std::vector<std::string> channel_arguments;  // --setup FILE, --variables
    std::vector<unsigned> channels;              // that get a process
    std::string plc_library;                     // empty: the built-in one
    std::string drives_program;                  // of the machine's folder; empty: polyturn-drives
};

class Controller {
public:
    static Result<std::unique_ptr<Controller>> start(ControllerPlan plan);
    ~Controller();
    Controller(const Controller&) = delete;
    Controller& operator=(const Controller&) = delete;

    const KernelSegment& kernel() const { return **kernel_; }
    SupervisorSegment& own() { return **own_; }
    const ChannelSegment* channel(unsigned number) const;  // nullptr: it has no process
    const StoreSegment& store() const { return **store_; }
    const std::string& instance() const { return plan_.instance; }
    const ControllerPlan& plan() const { return plan_; }

    // Sends a command that acts at `tick` (0: at the next one). Returns its number. Waits for room
    // while the kernel lives: for runs.
    std::uint64_t send(Command command, std::int64_t tick = 0);
    // All of them or none, at the next tick. It does not wait: a stop has room that others
    // leave it.
    static constexpr std::size_t kKeptForStops = 16;
    [[nodiscard]] bool try_send(const std::vector<Command>& commands, bool stop);
    // What is sent between these two appears in the ring at once: virtual time cannot begin with
    // half of it.
    void begin_batch() { batching_ = true; }
    void end_batch();
    // Asks the store; the answer comes through next_answer(). False: there is no room.
    bool ask_store(const StoreRequest& request);
    bool next_answer(StoreAnswer& answer);
    std::uint64_t asked() const { return request_; }  // the number of the last request
    // of the last one that the store has taken
    std::uint64_t taken() const {
        // P2: the store has read the requests before it
        return store().request_tail.tail.load(std::memory_order_acquire);
    }
    // Of the requests that the dead store has not taken nothing is left: its successor goes on
    // behind them. Only between its death and restart().
    void forget_requests();
    void forget_taken_requests();  // passwords do not stay in shared memory

    // Reaps dead processes and notifies the kernel. on_death(slot, status) once for each.
    void watch(const std::function<void(std::size_t slot, int status)>& on_death);
    void act(const ProcessAction& action,
             const std::function<void(std::size_t slot, int status)>& on_death);
    bool running(std::size_t slot) const;
    // its successor has not shown itself
    bool awaits(unsigned channel) const { return awaited_.contains(kProcessChannel + channel - 1); }
    // a successor, after watch() has reported the death; waits until it is there
    Result<void> restart(std::size_t slot);
    // the same without waiting: look_for_successors() finds it
    Result<void> begin_restart(std::size_t slot);
    void look_for_successors(const std::function<void(const Diagnosis&)>& on_fault);
    void beat();  // "the supervisor lives"
    // Waits until the kernel rings, a child dies or the time is over.
    void wait(std::uint32_t seen, std::int64_t timeout_us, int spins) const;
    std::uint32_t bell() const { return kernel().supervisor_bell.seen(); }

    // Controlled end: the kernel brings everything to rest; then all processes end. Who does not
    // end in time is killed: the kernel and the store after `timeout_ms` each, the others after a
    // second each. One that is stopped (SIGSTOP) is woken first.
    void stop(int timeout_ms);
    void stop_kernel(int timeout_ms);  // the first half

private:
    explicit Controller(ControllerPlan plan) : plan_(std::move(plan)) {}
    Result<void> launch();
    Result<void> spawn(std::size_t slot);
    template <class Layout>
    Result<PeerSegment<Layout>> attach(std::size_t slot, std::size_t number);
    void mark(std::size_t slot, ProcessState state, int pid);
    // as send(), but what has no room is kept and sent by the next ones
    void post(const Command& command);
    bool send_kept();  // true: nothing is kept any more

    ControllerPlan plan_;
    std::unique_ptr<OwnSegment<SupervisorSegment>> own_;
    std::unique_ptr<PeerSegment<StoreSegment>> store_;
    std::unique_ptr<PeerSegment<KernelSegment>> kernel_;
    std::map<unsigned, PeerSegment<ChannelSegment>> channels_;
    std::map<std::size_t, Child> children_;
    std::unique_ptr<RingProducer<RingHead<Command, 1024>>> commands_;
    std::unique_ptr<RingProducer<RingHead<StoreRequest, 256>>> requests_;
    std::unique_ptr<RingConsumer<RingHead<StoreAnswer, 256>>> answers_;
    std::uint64_t sequence_ = 0;
    std::uint64_t request_ = 0;
    bool batching_ = false;
    std::vector<Command> batch_;
    std::deque<Command> kept_;
    // successors that have not shown themselves; until when
    std::map<std::size_t, std::chrono::steady_clock::time_point> awaited_;
};

// SIGCHLD interrupts waits, so that a death is noticed at once. SIGTERM and SIGINT ask for a
// controlled end.
void catch_signals();
bool end_requested();

// "run-4711-1": a name that no other controller has.
std::string private_instance_name();

}  // namespace polyturn::supervisor
