// One run from the start of the processes to the summary. Time 0 is the cycle start.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kernel/supervisor/base/controller.hpp"
#include "kernel/supervisor/base/event_joiner.hpp"
#include "kernel/supervisor/base/output.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/run/run_record.hpp"
#include "kernel/supervisor/run/scenario_player.hpp"
#include "kernel/supervisor/run/trace_file.hpp"

namespace polyturn::supervisor {

struct WatchedSignal {
    std::string name;  // as it was asked for
    std::uint32_t slot = 0, side = 0;
    bool is_double = false;
};

// What is wanted besides the job itself, already understood.
struct RunRequests {
    std::vector<WatchedSignal> watch;
    std::map<unsigned, double> feed_override;  // 1 is 100 %
    std::map<unsigned, double> restart_at;     // block number
    std::optional<ScenarioPlayer> scenario;
};

class RunSession {
public:
    RunSession(const JobOptions& options, JobPlan& plan, RunRequests wishes);
    ~RunSession();
    int run();  // exit status
    const RunRecord& record() const { return record_; }

private:
    struct Track {
        bool started = false, over = false;
        bool alarmed = false;
    };

    Result<void> start();
    Result<void> await_first_idle();
    void send_start();
    void send_planned(const Planned& planned);
    void send_at(const Command& command, double t_s);
    void loop();
    bool drain();
    void drain_notes();
    bool drain_log();
    bool drain_trace(std::int64_t last_tick);
    void take(const KernelEvent& event);
    void end_at(std::int64_t tick) { end_tick_ = std::min(end_tick_, tick); }
    bool ending() const { return end_tick_ != INT64_MAX; }
    void take_begin(const KernelEvent& event, double t_s);
    void take_stopped(const KernelEvent& event, double t_s);
    std::vector<unsigned> to_start(unsigned channel, StopReason reason);
    void replace_channel(unsigned channel);
    void select_again(unsigned channel, std::int64_t tick);
    void select_in_successors(const MachineStatus& status);
    void take_alarm(const KernelEvent& event, double t_s);
    void take_action(const KernelEvent& event);
    bool stands_on_purpose();
    void take_idle(double t_s);
    void report(const Diagnosis& diagnosis, unsigned channel, double t_s);
    void react(std::string_view event_text, double t_s);
    void give_out(const EventJoiner::Event& event);
    void process_died(std::size_t slot, int status);
    void watch_progress();
    void end_if_over(const KernelEvent& event, double t_s);
    void watch_real_time();
    bool request_fails(unsigned number);
    bool all_over() const;
    bool start_is_planned() const;
    bool programs_may_stop() const;
    std::vector<std::string> program_files() const;
    void expect_started(std::string_view event_text);
    void finish();
    void write_pictures();
    double seconds(const KernelEvent& event) const {
        return static_cast<double>(event.tick - origin_) * tick_s_ + event.offset_s;
    }

    const JobOptions& options_;
    JobPlan& plan_;
    RunRequests wishes_;
    std::unique_ptr<Controller> controller_;
    std::unique_ptr<RingConsumer<RingHead<KernelEvent, 16384>>> log_;
    std::unique_ptr<RingConsumer<RingHead<TraceSample, 1024>>> trace_;
    std::unique_ptr<TraceFile> trace_file_;
    EventJoiner joiner_;
    EventJoiner::Sink sink_;
    Output output_;
    RunRecord record_;
    std::map<unsigned, Track> tracks_;
    // channels whose successor the kernel has not taken yet: tick of the death
    std::map<unsigned, std::int64_t> to_select_;
    std::map<std::uint64_t, ProcessAction> actions_;  // by the sequence of their Action command
    // channels that restart: with whom (bit 0 is channel 1)
    std::map<unsigned, std::uint32_t> restarts_;
    std::uint32_t at_block_ = 0;                  // of these, the ones at their blocks
    std::multiset<std::int64_t> sent_ticks_;      // of commands that have not acted yet
    std::multiset<std::int64_t> starts_planned_;  // cycle starts still to come
    // origin: tick of the cycle start, once it is known
    std::int64_t origin_ = INT64_MAX, log_tick_ = 0;
    // the kernel's first Idle: it is stopped until it is answered
    std::uint64_t idle_seq_ = 0;
    std::int64_t end_tick_ = INT64_MAX;  // the last tick of the run, once it is known
    double tick_s_ = 0.001, end_s_ = 0.0;
    bool follow_log_ = false, done_ = false, stopped_short_ = false, kernel_dead_ = false;
    std::size_t alarms_ = 0;
    std::uint64_t progress_tick_ = 0;
    std::chrono::steady_clock::time_point progress_at_{}, still_since_{}, checked_at_{};
    // of a kernel that a scenario has stopped for a while
    std::optional<std::chrono::steady_clock::time_point> thaw_at_;
};

}  // namespace polyturn::supervisor
