// Operations of the store through the socket, and who may ask for them.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/params/registry.hpp"
#include "kernel/supervisor/base/refusal.hpp"
#include "kernel/supervisor/start/start_session.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

namespace {

// wrong ones of one user of the computer: each costs the store a hash
constexpr double kLogins_s = 1, kLoginsAtOnce = 10;

// A copy that is made anew only when the store has published another one.
template <class Published, class Copy>
const Copy* seen(const Published& published, std::unique_ptr<Copy>& copy, std::uint64_t& version) {
    const std::uint64_t now = published.version();
    if (copy && version == now) return copy.get();
    if (!copy) copy = std::make_unique<Copy>();
    if (!published.read(*copy)) {
        copy.reset();
        return nullptr;
    }
    version = now;
    return copy.get();
}

}  // namespace

const UserTable* StartSession::users() {
    return seen(controller_->store().users, users_, users_version_);
}

Who StartSession::who_asks(RequestServer::Client client, const std::string& token) {
    const auto outputs = std::make_unique<PlcOutputs>();
    const UserTable* const table = users();
    const params::Table* const parameters =
        seen(controller_->store().parameters, parameters_, parameters_version_);
    if (!table) return {};
    int key = 0;
    if (controller_->kernel().plc_seen.read(*outputs)) key = outputs->signal[signals::plc_key()];
    const UserLevel out =
        parameters ? static_cast<UserLevel>(params::get(*parameters, params::pt_level_out))
                   : UserLevel::None;
    return access_.who({table, key, out}, token, server_.uid_of(client), Clock::now());
}

bool StartSession::may(RequestServer::Client client, const Who& who, UserLevel least,
                       const std::string& what) {
    if (who.level >= least) return true;
    server_.answer(
        client,
        refusal({Alarm::LevelTooLow,
                 {},
                 {},
                 fmt::format("{} ({})", what, kLevelWords[static_cast<std::size_t>(least)])}));
    return false;
}

StartSession::Taken StartSession::errand(RequestServer::Client client, Errand one, const Who& who) {
    if (!controller_->running(kProcessStore))
        return refuse(client, {Alarm::NotServed, {}, {}, "the store does not run"});
    one.client = client;
    one.uid = server_.uid_of(client);
    if (client && !context_.room(client >> 32, one.uid)) return Taken::Later;
    one.level = who.level;
    one.user = who.user;
    context_.add(std::move(one));
    return Taken::Yes;
}

StartSession::Taken StartSession::serve_operation(RequestServer::Client client,
                                                  const Request& request, const Who& who) {
    const std::string& name = request.operation;
    // only from here
    if (name == "stops.note" || name == "alarms.note")
        return refuse(client, {Alarm::PressUnknown, {}, {}, name});
    Errand one;
    one.operation = request.operation_text;
    one.login = name == "users.login";
    one.hashes = one.login || name == "users.password";
    one.timeout = timeout_of(name);
    if (one.hashes) {
        // One hash at a time, and who is wrong again and again waits for his next one, he alone.
        if (context_.logging_in()) return Taken::Later;
        if (!logins_.try_emplace(server_.uid_of(client), RateLimit{kLogins_s, kLoginsAtOnce})
                 .first->second.take(Clock::now()))
            return Taken::Later;
    }
    return errand(client, std::move(one), who);
}

void StartSession::own_operation(std::string text) {
    Errand one;
    one.operation = std::move(text);
    (void)errand(0, std::move(one), Who{});
}

void StartSession::told_by_store(const Errand& errand, StoreClient::End end,
                                 const std::string& text) {
    switch (end) {
        case StoreClient::End::Late:
            return server_.answer(
                errand.client,
                refusal({Alarm::NotServed,
                         {},
                         {},
                         "the store does not answer; what was asked may still be done"}));
        case StoreClient::End::Died:
            return server_.answer(
                errand.client,
                refusal({Alarm::NotServed,
                         {},
                         {},
                         "the store has died; look whether what was asked was done"}));
        case StoreClient::End::Refused:
            return server_.answer(errand.client, refusal({Alarm::NotServed, {}, {}, text}));
        case StoreClient::End::Answered:
            break;
    }
    if (errand.operation.empty()) return server_.answer(errand.client, R"({"ok":true})");
    if (!errand.hashes) return server_.answer(errand.client, text);
    Json told = Json::parse(text, nullptr, false);
    const auto number = [&](const char* key) {
        return told.contains(key) && told[key].is_number() ? told[key].get<double>() : 0.0;
    };
    const bool good = told.is_object() && told.contains("ok") && told["ok"].is_boolean() &&
                      told["ok"].get<bool>();
    if (good)
        if (const auto limit = logins_.find(errand.uid); limit != logins_.end())
            limit->second.give_back();
    if (!good || !errand.login || !told.contains("user"))
        return server_.answer(errand.client, text);
    const std::string name = told.contains("name") && told["name"].is_string()
                                 ? told["name"].get<std::string>()
                                 : std::string();
    told["token"] =
        access_.open(static_cast<std::uint32_t>(number("user")),
                     static_cast<UserLevel>(static_cast<std::uint32_t>(number("level"))), name,
                     number("logout_min"), Clock::now());
    server_.answer(errand.client, told.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace polyturn::supervisor
