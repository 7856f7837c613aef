// What comes through the socket, one request at a time, decoded already (request.hpp). Nothing in
// here waits: file work and long computing go to a worker, store requests to the store client; what
// finds no room is offered again.
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/check/config_check.hpp"
#include "ipc/requests/command_levels.hpp"
#include "ipc/params/param_file.hpp"
#include "kernel/supervisor/base/refusal.hpp"
#include "kernel/supervisor/press/press_words.hpp"
#include "kernel/supervisor/press/store_words.hpp"
#include "kernel/supervisor/start/start_session.hpp"
#include "kernel/supervisor/start/teach_thread.hpp"

namespace polyturn::supervisor {

namespace {

// Everything that is wrong with the lines.
std::vector<Diagnosis> faults_of(const std::vector<std::string>& lines,
                                 std::vector<params::Assignment>& assignments) {
    std::vector<Diagnosis> out;
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
    return out;
}

// Of an import also what it would make contradict itself. Takes its time: for a worker.
std::vector<Diagnosis> faults_of_import(const std::vector<std::string>& lines,
                                        std::unique_ptr<params::Table> table) {
    std::vector<params::Assignment> assignments;
    auto out = faults_of(lines, assignments);
    if (!out.empty() || !table) return out;
    const auto before = check_machine_config(*table);
    for (const params::Assignment& one : assignments)
        if (const auto done = params::apply(*table, {&one, 1}); !done)
            out.push_back(done.diagnosis());
    for (Diagnosis& wrong : check_machine_config(*table))
        if (wrong.severity() == Severity::Error &&
            std::none_of(before.begin(), before.end(), [&](const Diagnosis& d) {
                return d.alarm == wrong.alarm && d.text() == wrong.text();
            }))
            out.push_back(std::move(wrong));
    return out;
}

bool is(const Command& command, CommandKind kind) {
    return command.kind == static_cast<std::uint32_t>(kind);
}

}  // namespace

StartSession::Taken StartSession::refuse(RequestServer::Client client, const Diagnosis& why) {
    server_.answer(client, refusal(why));
    return Taken::Yes;
}

StartSession::Taken StartSession::handle(RequestServer::Client client, const Request& request) {
    const Who who = who_asks(client, request.token);
    switch (request.verb) {
        case RequestVerb::Press:
            return press(client, request, who);
        case RequestVerb::Set:
            return set(client, request, who);
        case RequestVerb::Release:
            return may(client, who, UserLevel::Operator, "release")
                       ? serve_commands(client, parse_release(request.words, machine_), who, false)
                       : Taken::Yes;
        case RequestVerb::Parameters:
            if (!may(client, who, UserLevel::Operator, "parameters")) return Taken::Yes;
            return request.import ? import_lines(client, request.lines, who)
                                  : serve_lines(client, request.lines, who);
        case RequestVerb::Store:
            return serve_operation(client, request, who);
        case RequestVerb::Alarms:
            return alarms_since(client, request.since);
        case RequestVerb::Who:
            server_.answer(
                client, nlohmann::json{{"ok", true},
                                       {"name", who.name},
                                       {"level", kLevelWords[static_cast<std::size_t>(who.level)]}}
                            .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
            return Taken::Yes;
        case RequestVerb::Logout:
            server_.answer(client, access_.close(request.token) ? R"({"ok":true})"
                                                                : R"({"ok":true,"nobody":true})");
            return Taken::Yes;
        case RequestVerb::End:
            if (!may(client, who, UserLevel::Setter, "end")) return Taken::Yes;
            ask_to_end_ = true;
            server_.answer(client, R"({"ok":true})");
            return Taken::Yes;
    }
    return refuse(client, {Alarm::RequestBad, {}, {}, {}});
}

// Only those behind so many; `next` is what to ask with the next time.
StartSession::Taken StartSession::alarms_since(RequestServer::Client client, std::uint64_t since) {
    const std::uint64_t first = alarms_noted_ - alarms_.size();
    std::string out = "{\"ok\":true,\"next\":" + std::to_string(alarms_noted_) + ",\"alarms\":[";
    const char* comma = "";
    for (std::uint64_t i = std::max(since, first); i < alarms_noted_; ++i, comma = ",")
        out += comma + alarms_[i - first];
    server_.answer(client, out + "]}");
    return Taken::Yes;
}

StartSession::Taken StartSession::press(RequestServer::Client client, const Request& request,
                                        const Who& who) {
    if (request.rank == RequestClass::Files) return select(client, request, who);
    if (is_teach_thread(request.words)) {
        if (!may(client, who, UserLevel::Operator, "press")) return Taken::Yes;
        const auto status = std::make_unique<MachineStatus>();
        if (!controller_->kernel().status.read(*status) || !parameters_)
            return refuse(client, {Alarm::SegmentNotReady, {}, {}, options_.instance});
        const auto lines =
            teach_thread(request.words, *status, derive_machine_config(*parameters_), *parameters_);
        return lines ? serve_lines(client, *lines, who) : refuse(client, lines.diagnosis());
    }
    return serve_commands(client, parse_press(request.words, machine_, request.folder), who,
                          request.rank == RequestClass::Stop);
}

StartSession::Taken StartSession::set(RequestServer::Client client, const Request& request,
                                      const Who& who) {
    if (!may(client, who, UserLevel::Operator, "set")) return Taken::Yes;
    auto commands = parse_set(request.words, machine_);
    // A parameter, an offset or a zero is set when it is on disk, not when the kernel has heard of
    // it.
    if (commands && commands->size() == 1 && is(commands->front(), CommandKind::SetParameter))
        return serve_lines(client, {request.words}, who);
    if (commands && commands->size() == 1 && is(commands->front(), CommandKind::StoreValue)) {
        Errand one;
        one.value = store_request_of(commands->front());
        return errand(client, std::move(one), who);
    }
    return serve_commands(client, std::move(commands), who, false);
}

bool StartSession::may_send(RequestServer::Client client, std::vector<Command>& commands,
                            const Who& who) {
    for (const Command& command : commands)
        if (!may(client, who, level_of(command), std::string(level_words(command)))) return false;
    for (Command& command : commands) {
        command.level = static_cast<std::uint32_t>(who.level) + 1;
        command.user = who.user;
    }
    return true;
}

StartSession::Taken StartSession::serve_commands(RequestServer::Client client,
                                                 Result<std::vector<Command>> commands,
                                                 const Who& who, bool stop) {
    if (!commands) return refuse(client, commands.diagnosis());
    if (!may_send(client, *commands, who)) return Taken::Yes;
    if (!controller_->try_send(*commands, stop)) return Taken::Later;
    server_.answer(client, R"({"ok":true})");
    return Taken::Yes;
}

StartSession::Taken StartSession::serve_lines(RequestServer::Client client,
                                              const std::vector<std::string>& lines,
                                              const Who& who) {
    std::vector<params::Assignment> assignments;
    // all or none
    if (const auto faults = faults_of(lines, assignments); !faults.empty()) {
        server_.answer(client, refusal(faults));
        return Taken::Yes;
    }
    if (lines.empty()) {
        server_.answer(client, R"({"ok":true})");
        return Taken::Yes;
    }
    Errand one;
    one.lines = lines;
    return errand(client, std::move(one), who);
}

StartSession::Taken StartSession::import_lines(RequestServer::Client client,
                                               const std::vector<std::string>& lines,
                                               const Who& who) {
    if (!controller_->running(kProcessStore))
        return refuse(client, {Alarm::NotServed, {}, {}, "the store does not run"});
    auto table =
        std::make_shared<std::unique_ptr<params::Table>>(std::make_unique<params::Table>());
    if (!controller_->store().parameters.read(**table)) table->reset();
    const bool offered = workers_.offer([this, client, who, lines, table]() -> Workers::Done {
        auto faults =
            std::make_shared<std::vector<Diagnosis>>(faults_of_import(lines, std::move(*table)));
        return [this, client, who, lines, faults] {
            if (!faults->empty()) return server_.answer(client, refusal(*faults));  // all or none
            if (lines.empty()) return server_.answer(client, R"({"ok":true})");
            Errand one;
            one.client = client;
            one.uid = server_.uid_of(client);
            one.lines = lines;
            one.level = who.level;
            one.user = who.user;
            one.timeout = StoreClient::kLongTimeout;
            context_.add(std::move(one));
        };
    });
    return offered ? Taken::Holds : Taken::Later;
}

}  // namespace polyturn::supervisor
