// Requests to the store and answers from it. Nothing waits here: what the
// ring has no room for stays in its errand, and an errand that is not answered in its time is
// answered for the store.
//
//   added -> its pieces go into the ring, in the order of the errands -> the last one is answered:
//   the errand is done out of time: its asker is notified; the errand stays until the store has
//   answered it after all, or has died the store dies: what it had not taken is taken back
//   (Controller::forget_requests) and refused. It is never read again: the first of it may be what
//   the store died of. Errands of the supervisor's own (the log of stops, alarms) go again, but for
//   that first one.
#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "kernel/supervisor/base/controller.hpp"

namespace polyturn::supervisor {

struct Errand {
    std::uint64_t client = 0;        // of the request server; 0: the supervisor's own
    std::int64_t uid = -1;           // who asks
    std::string operation;           // the text of an operation,
    std::vector<std::string> lines;  // or parameter lines: all or none,
    StoreRequest value{};            // or an offset, a zero
    UserLevel level = UserLevel::None;
    std::uint32_t user = 0;
    // its answer becomes a token; the store computes a password's hash for it
    bool login = false, hashes = false;
    // while the store works on it; 5 s are enough for it to begin
    std::chrono::seconds timeout{5};
};

class StoreClient {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::size_t kMostOutstanding = 16, kOfOneUser = 8, kOfOneClient = 4;
    // operations that copy or read much (long_operation)
    static constexpr std::chrono::seconds kTimeout{5}, kLongTimeout{28};
    enum class End { Answered, Refused, Late, Died };  // Refused: `text` is the diagnosis' detail
    using Told = std::function<void(const Errand& errand, End end, const std::string& text)>;

    // Has it room for another errand of this connection (Client >> 32) and user?
    bool room(std::uint64_t connection, std::int64_t uid) const;
    void add(Errand errand);
    std::size_t waiting() const { return errands_.size(); }
    bool logging_in() const;
    // Sends what has room, takes what has been answered, reports who waited too long.
    void move(Controller& controller, Clock::time_point now, const Told& told);
    void store_died(Controller& controller, const Told& told);
    void forget_all(const Told& told);  // everybody starts anew

private:
    struct Open {
        Errand errand;
        Clock::time_point since;
        std::size_t sent = 0;  // characters or lines
        // of its pieces; 0: none is sent, the last is not
        std::uint64_t first_id = 0, last_id = 0;
        std::string text, refused;  // of the answer so far
        bool told = false;
        bool all_sent() const { return last_id != 0; }
    };
    bool send(Controller& controller, Open& open);  // false: no room
    void take(Controller& controller, const Told& told);
    bool late(const Open& open, Clock::time_point now, std::uint64_t taken) const;
    static void tell(Open& open, End end, const std::string& text, const Told& told);

    std::deque<Open> errands_;  // in the order of their pieces
    std::uint64_t taken_ = 0;
    // when the store last took or answered something
    Clock::time_point alive_{};
};

// An operation that may take long: backups, long lists, imports.
std::chrono::seconds timeout_of(std::string_view operation);

}  // namespace polyturn::supervisor
