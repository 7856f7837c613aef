// A running controller: the loop of its supervisor.
#pragma once
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ipc/machine/load_machine.hpp"
#include "ipc/machine/machine_config.hpp"
#include "ipc/text/builder_messages.hpp"
#include "ipc/text/job.hpp"
#include "kernel/supervisor/access.hpp"
#include "kernel/supervisor/controller.hpp"
#include "kernel/supervisor/event_joiner.hpp"
#include "kernel/supervisor/options.hpp"
#include "kernel/supervisor/request_socket.hpp"
#include "kernel/supervisor/screens.hpp"
#include "kernel/supervisor/stop_watch.hpp"

namespace polyturn::supervisor {

std::int64_t utc_ms();   // now, since 1970
std::string default_store(const std::string& instance);   // the folder of a controller that is started without --store

class StartSession {
public:
    StartSession(const StartOptions& options, LoadedMachine machine, RequestServer server);
    int run();

private:
    Result<void> launch();
    void loop();
    void drain();
    void take(const KernelEvent& event);
    std::string with_when(std::string event_text) const;
    std::string builder_words(int number) const;
    std::string program_of(const KernelEvent& event) const;
    void note_alarm(std::string event_text, Dialect dialect, bool tell);
    void process_died(std::size_t slot, int status);
    void revive();
    void handle(RequestServer::Client client, const std::string& line);
    bool serve_commands(RequestServer::Client client, const Result<std::vector<Command>>& commands, const Who& who, const std::function<std::vector<std::string>()>& notes = {});   // false: refused
    Result<void> in_reach(std::string_view words, const std::string& folder, UserLevel level) const;
    std::vector<std::string> differences(const text::Job& job) const;
    void serve_parameters(RequestServer::Client client, const std::vector<std::string>& lines, bool import, const Who& who);
    void serve_value(RequestServer::Client client, StoreRequest request, const Who& who);
    // start_session_store.cpp: operations of the store (tools, offsets, users, backups), logins.
    Who who_asks(RequestServer::Client client, const std::string& token);
    bool may(RequestServer::Client client, const Who& who, UserLevel least, const std::string& what);
    void serve_operation(RequestServer::Client client, const std::string& operation, bool login, const Who& who);
    bool push_request(const StoreRequest& request);
    void forget_requests();
    std::vector<Diagnosis> faults_of(const std::vector<std::string>& lines, bool import) const;
    void take_answers();
    Dialect dialect(unsigned channel) const;
    bool runs(unsigned channel) const;   // a program: running, held, waiting, stopped in it
    std::array<Dialect, kMaxChannels> job_language_{};   // of what is selected, where its job says one; Polyturn: PT_LANGUAGE
    // start_session_stops.cpp: the log of stops.
    void watch_stops();
    void keep_stops(std::vector<Stop> stops);
    void keep_alarms();

    // A client that waits for the store: so many answers are still to come.
    struct Waiting {
        RequestServer::Client client = 0;
        std::uint64_t last_id = 0;
        std::string refused;
        bool operation = false, login = false;
        std::string text;        // of the answer so far
    };

    const StartOptions& options_;
    LoadedMachine loaded_;
    text::BuilderMessages messages_;
    MachineConfig machine_;
    RequestServer server_;
    std::unique_ptr<Controller> controller_;
    std::unique_ptr<RingConsumer<RingHead<KernelEvent, 16384>>> log_;
    EventJoiner joiner_;
    Access access_;
    std::uint64_t generation_ = new_generation(), asked_ = 0;
    std::deque<std::string> alarms_;  // event objects, the newest last
    std::uint64_t alarms_noted_ = 0;  // since this supervisor started
    std::deque<Waiting> waiting_;
    StopWatch stops_;
    Screens screens_;
    std::deque<Stop> untold_stops_;   // the store does not take them now
    std::deque<std::string> unkept_alarms_;   // on their way to the store
    std::chrono::steady_clock::time_point next_stop_look_{};
    std::map<std::size_t, std::deque<std::chrono::steady_clock::time_point>> deaths_;
    std::vector<std::size_t> to_revive_;
    bool kernel_dead_ = false, ask_to_end_ = false;
};

}  // namespace polyturn::supervisor
