// The one door through which short-lived programs ask a running controller for something: a Unix
// socket (ipc/memory/controller_door), one JSON object a line each way. The asking user is given by
// the kernel of the operating system (SO_PEERCRED): the owner of the controller and root may, and
// users of the controller who are known by their number in the operating system.
//
// Nobody waits here for anybody else:
//   - A stop (RequestClass::Stop) acts as soon as its line has come, before the lines that stand in
//     front of it on its connection; its answer keeps its place. If any of those lines acts later,
//     the stop acts again in its turn: a start never has the last word.
//   - All other lines act in turn, one of each connection, as long as a turn's time lasts; the rest
//     stays in its connection.
//   - Who does not read his answers is read no more while more than kMostUnread wait for him, and
//     closed when that lasts kUnreadTimeout.
//   - Who sends faster than kRate lines a second waits, he alone.
//   - kConnections in all; a guest has kOfGuest at the most, the last kKeptForOwner are the owner's
//     and root's, the last of them root's.
#pragma once
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/memory/controller_door.hpp"
#include "kernel/supervisor/start/request.hpp"

namespace polyturn::supervisor {

// So many a second, and so many at once after a rest.
class RateLimit {
public:
    using Clock = std::chrono::steady_clock;
    constexpr RateLimit(double a_second, double at_once)
        : a_second_(a_second), at_once_(at_once), left_(at_once) {}
    bool take(Clock::time_point now);
    void give_back() { left_ = left_ + 1 > at_once_ ? at_once_ : left_ + 1; }

private:
    double a_second_, at_once_, left_;
    Clock::time_point last_{};
};

class RequestServer {
public:
    static constexpr std::size_t kConnections = 64, kOfGuest = 8, kKeptForOwner = 16,
                                 kKeptForRoot = 8;
    static constexpr std::size_t kMostUnread = 256 * 1024, kMostLines = 64;
    static constexpr double kRate = 250, kBurst = 500, kStopRate = 200, kStopBurst = 100;
    static constexpr std::chrono::seconds kUnreadTimeout{5}, kOffered{5};
    static constexpr std::chrono::milliseconds kTurn{2};

    using Client = std::uint64_t;  // one line of one connection
    enum class Taken {
        // answered now by answer(), or later: once for each line, in the order of the connection's
        // lines
        Yes,
        Holds,  // as Yes, and later lines of its connection wait for its answer
        // there is no room for it now: it waits in its connection and is offered again, for
        // kOffered
        Later,
    };
    using Handler = std::function<Taken(Client client, const Request& request)>;
    // Decodes a long line elsewhere and calls back; false: no room, again later.
    using Decoder =
        std::function<bool(std::string line, std::function<void(Result<Request>)> done)>;

    static Result<RequestServer> open(const std::string& instance);
    RequestServer(RequestServer&& other) noexcept;
    RequestServer& operator=(RequestServer&&) = delete;
    ~RequestServer();

    // Waits at most so long for somebody (not at all while lines wait for their turn) or for
    // `other` to become readable, takes what has come.
    void serve(int timeout_ms, const Handler& handler, int other = -1);
    void answer(Client client, std::string line);
    // The operating system's user who asks; -1 when he has gone.
    std::int64_t uid_of(Client client) const;
    bool is_guest(Client client) const;
    // Whom to let in besides the owner of the controller and root.
    void set_guests(std::function<bool(std::int64_t uid)> guests) { guests_ = std::move(guests); }
    void set_decoder(Decoder decoder) { decoder_ = std::move(decoder); }
    const std::string& path() const { return door_.path(); }
    bool name_is_foreign() const { return door_.name_is_foreign(); }

private:
    using Clock = std::chrono::steady_clock;
    struct Line {
        enum class State : std::uint8_t { Raw, Decoding, Decoded, Refused };
        std::uint32_t number = 0;
        std::size_t size = 0;
        std::string text;  // while it is raw
        State state = State::Raw;
        bool stop = false, acted = false;  // a stop acts before its turn
        std::uint64_t acted_after = 0;     // Connection::acts then
        Request request;
        Clock::time_point offered{};  // first; it found no room
    };
    struct Connection {
        int fd = -1;
        std::string in;
        std::size_t looked = 0;  // of `in`, without an end of line
        // bytes of a line that is too long, as long as it goes on
        std::size_t skipped = 0;
        std::string out;
        std::size_t unread = 0;  // bytes of all answers that have not gone
        std::deque<Line> lines;
        std::size_t queued = 0;                      // bytes of the lines
        std::uint32_t asked = 0, told = 0;           // lines that have come, answers that have gone
        std::map<std::uint32_t, std::string> early;  // answers whose turn has not come
        std::uint64_t acts = 0;                      // lines that have acted in their turn
        std::int64_t held_by = -1;                   // the line whose answer the others wait for
        std::int64_t uid = -1;
        // nothing more is read: we close it, he has said all, he has gone
        bool closing = false, ended = false, dead = false;
        Clock::time_point over_since{};  // too much waits for him to be read
        RateLimit rate{kRate, kBurst}, stop_rate{kStopRate, kStopBurst};
    };

    explicit RequestServer(ControllerDoor door) : door_(std::move(door)) {}
    void accept_all(int listener);
    static bool wants_to_read(const Connection& connection);
    void read_from(std::uint64_t number, Connection& connection);
    void split(std::uint64_t number, Connection& connection);
    void stops_first(const Handler& handler, Clock::time_point now);
    void turns(const Handler& handler, Clock::time_point now);
    // true: a line is done
    bool turn(std::uint64_t number, Connection& connection, const Handler& handler,
              Clock::time_point now);
    void decode(std::uint64_t number, Line& line);
    void decoded(Client client, Line& line, Result<Request> done);
    static void write_to(Connection& connection);
    void close_ended(Clock::time_point now);

    ControllerDoor door_;
    std::uint64_t next_ = 1, first_ = 0;  // first_: whose turn it is
    bool more_ = false;                   // lines wait that could act now
    std::map<std::uint64_t, Connection> connections_;
    std::function<bool(std::int64_t)> guests_;
    Decoder decoder_;
};

// Sends one line to the controller and returns its answer.
Result<std::string> ask_controller(const std::string& instance, std::string_view line,
                                   int timeout_ms = 30'000);

}  // namespace polyturn::supervisor
