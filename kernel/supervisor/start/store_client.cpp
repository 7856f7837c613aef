#include "kernel/supervisor/start/store_client.hpp"

#include <algorithm>
#include <limits>

#include "ipc/requests/store_requests.hpp"

namespace polyturn::supervisor {

namespace {
constexpr std::size_t kPiece = sizeof(StoreRequest{}.name) - 1;
constexpr unsigned kLineBits = 32;  // of RequestServer::Client
}  // namespace

std::chrono::seconds timeout_of(std::string_view operation) {
    // users: a hash takes its time, and others may come first
    for (const std::string_view head :
         {"backup.", "restore.", "history.", "alarms.", "stops.", "users."})
        if (operation.starts_with(head)) return StoreClient::kLongTimeout;
    return operation.ends_with(".import") || operation.ends_with(".export")
               ? StoreClient::kLongTimeout
               : StoreClient::kTimeout;
}

bool StoreClient::room(std::uint64_t connection, std::int64_t uid) const {
    std::size_t all = 0, his = 0, here = 0;
    for (const Open& open : errands_) {
        if (open.errand.client == 0 || open.told) continue;
        ++all;
        his += open.errand.uid == uid;
        here += open.errand.client >> kLineBits == connection;
    }
    return all < kMostOutstanding && his < kOfOneUser && here < kOfOneClient;
}

bool StoreClient::logging_in() const {
    return std::any_of(errands_.begin(), errands_.end(),
                       [](const Open& open) { return open.errand.hashes; });
}

void StoreClient::add(Errand errand) {
    Open open;
    open.since = Clock::now();
    open.errand = std::move(errand);
    errands_.push_back(std::move(open));
}

// A store that shows no life is given no more than kTimeout, whatever it was asked; one that works
// on a long errand, or takes its lines, has the errand's.
bool StoreClient::late(const Open& open, Clock::time_point now, std::uint64_t taken) const {
    if (open.told || open.errand.client == 0 || now - open.since < kTimeout) return false;
    if (now - open.since >= open.errand.timeout) return true;
    const bool under_work = &open == &errands_.front() && open.all_sent() && open.last_id <= taken;
    return !under_work && now - alive_ >= kTimeout;
}

void StoreClient::tell(Open& open, End end, const std::string& text, const Told& told) {
    if (!open.told) told(open.errand, end, text);
    open.told = true;
}

bool StoreClient::send(Controller& controller, Open& open) {
    const Errand& errand = open.errand;
    while (!open.all_sent()) {
        StoreRequest request{};
        bool last = true;
        if (!errand.lines.empty()) {
            last = open.sent + 1 == errand.lines.size();
            request = parameter_request(errand.lines[open.sent], !last);
        } else if (errand.operation.empty()) {
            request = errand.value;
        } else {
            const std::size_t next = std::min(open.sent + kPiece, errand.operation.size());
            last = next == errand.operation.size();
            request =
                store_request(StoreRequestKind::Operation, 0, static_cast<std::int32_t>(open.sent),
                              last ? 0 : kMoreFollows, 0.0);
            put_name(request, std::string_view(errand.operation).substr(open.sent, kPiece));
        }
        request.level = static_cast<std::uint32_t>(errand.level);
        request.user = errand.user;
        if (!controller.ask_store(request)) return false;
        open.sent += errand.operation.empty() ? 1 : kPiece;
        if (open.first_id == 0) open.first_id = controller.asked();
        if (last) open.last_id = controller.asked();
    }
    return true;
}

void StoreClient::take(Controller& controller, const Told& told) {
    StoreAnswer answer;
    while (controller.next_answer(answer)) {
        alive_ = Clock::now();
        // Answers come in the order of what was asked.
        while (!errands_.empty() && errands_.front().all_sent() &&
               errands_.front().last_id < answer.id) {
            tell(errands_.front(), End::Died, {}, told);
            errands_.pop_front();
        }
        if (errands_.empty() || errands_.front().first_id == 0 ||
            answer.id < errands_.front().first_id)
            continue;
        Open& first = errands_.front();
        if (first.errand.operation.empty()) {
            if (!answer.ok && first.refused.empty()) first.refused = answer.text.data();
            if (answer.id != first.last_id) continue;
            tell(first, first.refused.empty() ? End::Answered : End::Refused, first.refused, told);
        } else {
            if (answer.id != first.last_id) continue;
            first.text += answer.text.data();
            if (answer.more) continue;
            controller.forget_taken_requests();
            tell(first, End::Answered, first.text, told);
        }
        errands_.pop_front();
    }
}

void StoreClient::move(Controller& controller, Clock::time_point now, const Told& told) {
    take(controller, told);
    const std::uint64_t taken = controller.taken();
    if (taken != taken_ || errands_.empty()) {
        taken_ = taken;
        alive_ = now;
    }
    for (Open& open : errands_)
        if (late(open, now, taken)) tell(open, End::Late, {}, told);
    // What has not begun need not be done any more. What has begun and cannot go on is broken off
    // where the store sees it: the next operation begins at 0, and lines of an import do not mix
    // with those of the next one.
    for (auto at = errands_.begin(); at != errands_.end();) {
        if (!at->told || at->all_sent()) {
            ++at;
            continue;
        }
        if (at->first_id != 0) {
            const StoreRequest off =
                store_request(StoreRequestKind::Operation, 0,
                              std::numeric_limits<std::int32_t>::max(), kMoreFollows, 0.0);
            if (!controller.ask_store(off)) break;
        }
        at = errands_.erase(at);
    }
    for (Open& open : errands_)
        if (!open.all_sent() && (open.told || !send(controller, open))) break;
}

void StoreClient::store_died(Controller& controller, const Told& told) {
    take(controller, told);  // its last words
    controller.forget_requests();
    std::deque<Open> again;
    bool first = true;
    for (Open& open : errands_) {
        const bool may_go_again = open.errand.client == 0 && !(first && open.first_id != 0);
        first = false;
        if (may_go_again) {
            Open fresh;
            fresh.errand = std::move(open.errand);
            fresh.since = open.since;
            again.push_back(std::move(fresh));
        } else {
            tell(open, End::Died, {}, told);
        }
    }
    errands_ = std::move(again);
}

void StoreClient::forget_all(const Told& told) {
    for (Open& open : errands_) tell(open, End::Died, {}, told);
    errands_.clear();
}

}  // namespace polyturn::supervisor
