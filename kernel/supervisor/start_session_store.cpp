// Operations of the store through the socket, and who may ask for them.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/machine/store_requests.hpp"
#include "ipc/params/registry.hpp"
#include "kernel/supervisor/refusal.hpp"
#include "kernel/supervisor/start_session.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

namespace {
constexpr std::size_t kPiece = sizeof(StoreRequest{}.name) - 1;
}  // namespace

Who StartSession::who_asks(RequestServer::Client client, const std::string& token) {
    const auto users = std::make_unique<UserTable>();
    const auto outputs = std::make_unique<PlcOutputs>();
    if (!controller_->store().users.read(*users)) return {};
    int key = 0;
    if (controller_->kernel().plc_seen.read(*outputs)) key = outputs->signal[signals::plc_key()];
    const auto table = std::make_unique<params::Table>();
    UserLevel out = UserLevel::None;
    if (controller_->store().parameters.read(*table)) out = static_cast<UserLevel>(params::get(*table, params::pt_level_out));
    return access_.who({users.get(), key, out}, token, server_.uid_of(client), Clock::now());
}

bool StartSession::may(RequestServer::Client client, const Who& who, UserLevel least, const std::string& what) {
    if (who.level >= least) return true;
    server_.answer(client, refusal({Alarm::LevelTooLow, {}, {}, fmt::format("{} ({})", what, kLevelWords[static_cast<std::size_t>(least)])}));
    return false;
}

bool StartSession::push_request(const StoreRequest& request) {
    const auto until = Clock::now() + std::chrono::seconds(5);
    while (!controller_->ask_store(request)) {   // the ring is full: let the store work
        take_answers();
        if (Clock::now() > until) return false;
        sleep_ms(1);
    }
    ++asked_;
    return true;
}

void StartSession::serve_operation(RequestServer::Client client, const std::string& operation, bool login, const Who& who) {
    if (!controller_->running(kProcessStore)) return server_.answer(client, refusal({Alarm::NotServed, {}, {}, "the store does not run"}));
    for (std::size_t at = 0; at == 0 || at < operation.size(); at += kPiece) {
        StoreRequest request = store_request(StoreRequestKind::Operation, 0, static_cast<std::int32_t>(at), at + kPiece < operation.size() ? kMoreFollows : 0, 0.0);
        request.level = static_cast<std::uint32_t>(who.level);
        request.user = who.user;
        put_name(request, std::string_view(operation).substr(at, kPiece));
        if (!push_request(request)) return server_.answer(client, refusal({Alarm::NotServed, {}, {}, "the store does not answer"}));
    }
    waiting_.push_back({client, asked_, {}, true, login, {}});
}

// Passwords do not stay in shared memory: what the store has taken is overwritten.
void StartSession::forget_requests() {
    auto& ring = controller_->own().requests;
    const auto head = ring.head.load(std::memory_order_relaxed), tail = controller_->store().request_tail.tail.load(std::memory_order_acquire);
    for (auto i = head > ring.capacity ? head - ring.capacity : 0; i < tail; ++i) ring.slot(i).name.fill(0);
}

void StartSession::take_answers() {
    StoreAnswer answer;
    while (controller_->next_answer(answer)) {
        if (waiting_.empty()) continue;
        Waiting& first = waiting_.front();
        if (first.operation) {
            if (answer.id != first.last_id) continue;
            first.text += answer.text.data();
            if (answer.more) continue;
            forget_requests();
            if (first.login) {
                Json told = Json::parse(first.text, nullptr, false);
                if (!told.is_discarded() && told.value("ok", false) && told.contains("user")) {
                    told["token"] = access_.open(told.value("user", 0u), static_cast<UserLevel>(told.value("level", 0)), told.value("name", ""), told.value("logout_min", 0.0), Clock::now());
                    first.text = told.dump();
                }
            }
            server_.answer(first.client, first.text);
            waiting_.pop_front();
            continue;
        }
        if (!answer.ok && first.refused.empty()) first.refused = answer.text.data();
        if (answer.id < first.last_id) continue;
        server_.answer(first.client, first.refused.empty() ? std::string("{\"ok\":true}") : refusal({Alarm::NotServed, {}, {}, first.refused}));
        waiting_.pop_front();
    }
}

}  // namespace polyturn::supervisor
