// A running controller: the loop of its supervisor.
#pragma once
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ipc/model/machine/load_machine.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/files/builder_messages.hpp"
#include "ipc/model/files/job.hpp"
#include "kernel/supervisor/base/access.hpp"
#include "kernel/supervisor/base/controller.hpp"
#include "kernel/supervisor/base/event_joiner.hpp"
#include "kernel/supervisor/base/options.hpp"
#include "kernel/supervisor/base/workers.hpp"
#include "kernel/supervisor/start/request_socket.hpp"
#include "kernel/supervisor/start/screens.hpp"
#include "kernel/supervisor/start/stop_watch.hpp"
#include "kernel/supervisor/start/store_client.hpp"

namespace polyturn::supervisor {

std::int64_t utc_ms();  // now, since 1970
// the folder of a controller that is started without --store
std::string default_store(const std::string& instance);

class StartSession {
public:
    StartSession(const StartOptions& options, LoadedMachine machine, RequestServer server);
    int run();
    bool stuck() const;  // behind run(): a thread of it hangs in a file or a halted terminal

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
    void put_out(unsigned channel);  // that sends what cannot be
    void revive();
    void end();
    void printed(std::function<void()> print);
    // start_session_requests.cpp: what comes through the socket.
    using Taken = RequestServer::Taken;
    Taken handle(RequestServer::Client client, const Request& request);
    Taken press(RequestServer::Client client, const Request& request, const Who& who);
    Taken set(RequestServer::Client client, const Request& request, const Who& who);
    Taken alarms_since(RequestServer::Client client, std::uint64_t since);
    Taken refuse(RequestServer::Client client, const Diagnosis& why);
    Taken serve_commands(RequestServer::Client client, Result<std::vector<Command>> commands,
                         const Who& who, bool stop);
    // and by whom is written into them
    bool may_send(RequestServer::Client client, std::vector<Command>& commands, const Who& who);
    Taken serve_lines(RequestServer::Client client, const std::vector<std::string>& lines,
                      const Who& who);
    Taken import_lines(RequestServer::Client client, const std::vector<std::string>& lines,
                       const Who& who);
    // start_session_select.cpp: a program or a job is selected.
    Taken select(RequestServer::Client client, const Request& request, const Who& who);
    void move_selections();
    // start_session_store.cpp: operations of the store (tools, offsets, users, backups), logins.
    const UserTable* users();
    Who who_asks(RequestServer::Client client, const std::string& token);
    bool may(RequestServer::Client client, const Who& who, UserLevel least,
             const std::string& what);
    Taken serve_operation(RequestServer::Client client, const Request& request, const Who& who);
    Taken errand(RequestServer::Client client, Errand errand, const Who& who);
    void own_operation(std::string text);
    void told_by_store(const Errand& errand, StoreClient::End end, const std::string& text);
    StoreClient::Told teller() {
        return [this](const Errand& errand, StoreClient::End end, const std::string& text) {
            told_by_store(errand, end, text);
        };
    }
    Dialect dialect(unsigned channel) const;
    bool runs(unsigned channel) const;  // a program: running, held, waiting, stopped in it
    // of what is selected, where its job says one; Polyturn: PT_LANGUAGE
    std::array<Dialect, kMaxChannels> job_language_{};
    // start_session_stops.cpp: the log of stops.
    void watch_stops();
    void keep_stops(std::vector<Stop> stops);
    void keep_alarms();

    // A program or a job that is being selected: its files are read, then the machine must be ready
    // for it, then what the job has otherwise is looked up.
    struct Selection {
        RequestServer::Client client = 0;
        Who who;
        std::vector<Command> commands;
        std::optional<text::Job> job;
        // a reset that was pressed just before has so long to be seen
        std::chrono::steady_clock::time_point until;
        bool sent = false;
    };

    const StartOptions& options_;
    LoadedMachine loaded_;
    text::BuilderMessages messages_;
    MachineConfig machine_;
    std::shared_ptr<const MachineConfig> shared_machine_;  // for the workers
    RequestServer server_;
    std::unique_ptr<Controller> controller_;
    std::unique_ptr<RingConsumer<RingHead<KernelEvent, 16384>>> log_;
    EventJoiner joiner_;
    Access access_;
    std::uint64_t generation_ = new_generation();
    std::deque<std::string> alarms_;  // event objects, the newest last
    std::uint64_t alarms_noted_ = 0;  // since this supervisor started
    StoreClient context_;
    Workers workers_, printer_{1, 1000};
    std::deque<Selection> selections_;
    std::map<std::int64_t, RateLimit> logins_;  // by user of the computer: wrong ones cost
    // as the store has them; read again when they have changed
    std::unique_ptr<UserTable> users_;
    std::unique_ptr<params::Table> parameters_;
    std::uint64_t users_version_ = 0, parameters_version_ = 0;
    bool more_events_ = false;
    StopWatch stops_;
    Screens screens_;
    std::deque<Stop> untold_stops_;          // the store does not take them now
    std::deque<std::string> unkept_alarms_;  // in transit to the store
    std::chrono::steady_clock::time_point next_stop_look_{};
    std::map<std::size_t, std::deque<std::chrono::steady_clock::time_point>> deaths_;
    std::vector<std::size_t> to_revive_;
    bool kernel_dead_ = false, ask_to_end_ = false;
};

}  // namespace polyturn::supervisor
