// The one door through which short-lived programs ask a running controller for something: a Unix socket, one JSON object a
// line each way. The socket is abstract ("@polyturn.NAME"): it goes with the supervisor and leaves no file behind. Who
// asks is told by the kernel of the operating system (SO_PEERCRED): the owner of the controller and root may, and
// users of the controller who are known by their number in the operating system.
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

struct pollfd;

namespace polyturn::supervisor {

class RequestServer {
public:
    using Client = std::uint64_t;          // one line of one connection
    // Answers now by answer(), or later: once for each line. Whoever asks several things on one connection gets the answers in the
    // order of his lines, whichever is known first.
    using Handler = std::function<void(Client client, const std::string& line)>;

    static Result<RequestServer> open(const std::string& instance);
    RequestServer(RequestServer&& other) noexcept;
    RequestServer& operator=(RequestServer&&) = delete;
    ~RequestServer();

    // Waits at most so long for somebody, takes what has come.
    void serve(int timeout_ms, const Handler& handler);
    void answer(Client client, std::string line);
    // The operating system's user who asks; -1 when he has gone.
    std::int64_t uid_of(Client client) const;
    // Whom to let in besides the owner of the controller and root.
    void set_guests(std::function<bool(std::int64_t uid)> guests) { guests_ = std::move(guests); }

private:
    struct Connection {
        int fd = -1;
        std::string in, out;
        bool closing = false;
        std::int64_t uid = -1;
        std::uint32_t asked = 0, told = 0;           // lines that have come, answers that have gone
        std::map<std::uint32_t, std::string> early;  // answers whose turn has not come
    };
    RequestServer() = default;
    void accept_all();
    bool read_from(std::uint64_t number, Connection& connection, const Handler& handler);  // false: gone

    int fd_ = -1;
    std::uint64_t next_ = 1;
    std::map<std::uint64_t, Connection> connections_;
    std::function<bool(std::int64_t)> guests_;
};

// Sends one line to the controller and returns its answer.
Result<std::string> ask_controller(const std::string& instance, std::string_view line, int patience_ms = 30'000);

}  // namespace polyturn::supervisor
