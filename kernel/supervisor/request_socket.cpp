#include "kernel/supervisor/request_socket.hpp"

#include "kernel/supervisor/refusal.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <utility>

namespace polyturn::supervisor {

namespace {

constexpr std::size_t kMostClients = 32;
constexpr unsigned kLineBits = 32;
constexpr std::size_t kLongestLine = 1 << 20;

socklen_t address_of(const std::string& instance, sockaddr_un& address) {
    const std::string name = "polyturn." + instance;
    address = {};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data(), name.size());  // a leading zero byte: abstract
    return static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
}

std::int64_t asker(int fd) {
    ucred who{};
    socklen_t size = sizeof who;
    return getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &who, &size) == 0 ? static_cast<std::int64_t>(who.uid) : -1;
}

}  // namespace

Result<RequestServer> RequestServer::open(const std::string& instance) {
    RequestServer out;
    out.fd_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    sockaddr_un address;
    const socklen_t size = address_of(instance, address);
    if (out.fd_ < 0 || bind(out.fd_, reinterpret_cast<sockaddr*>(&address), size) != 0 || listen(out.fd_, 16) != 0) {
        if (errno == EADDRINUSE) return Diagnosis{Alarm::InstanceRuns, {}, {}, instance};
        return Diagnosis{Alarm::ProcessStart, {}, {}, fmt::format("its socket ({})", std::strerror(errno))};
    }
    return out;
}

RequestServer::RequestServer(RequestServer&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)), next_(other.next_), connections_(std::move(other.connections_)), guests_(std::move(other.guests_)) {
    other.connections_.clear();
}

RequestServer::~RequestServer() {
    for (auto& [client, connection] : connections_) close(connection.fd);
    if (fd_ >= 0) close(fd_);
}

void RequestServer::accept_all() {
    for (;;) {
        const int fd = accept4(fd_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (fd < 0) return;
        const std::int64_t uid = asker(fd);
        const bool may = uid >= 0 && (uid == static_cast<std::int64_t>(geteuid()) || uid == 0 || (guests_ && guests_(uid)));
        if (!may || connections_.size() >= kMostClients) {   // told before it is closed, so that whoever asked knows why
            const std::string why = (may ? refusal({Alarm::NotServed, {}, {}, "too many programs ask at once"})
                                         : refusal({Alarm::LevelTooLow, {}, {}, fmt::format("user {} of this computer is no user of the controller (users add NAME LEVEL uid={})", uid, uid)})) + "\n";
            (void)!send(fd, why.data(), why.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
            close(fd);
            continue;
        }
        Connection& fresh = connections_[next_++];
        fresh.fd = fd;
        fresh.uid = uid;
    }
}

bool RequestServer::read_from(std::uint64_t number, Connection& connection, const Handler& handler) {
    char block[4096];
    for (;;) {
        const auto got = read(connection.fd, block, sizeof block);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 && errno == EAGAIN) break;
        if (got <= 0) return false;
        connection.in.append(block, static_cast<std::size_t>(got));
        if (connection.in.size() > kLongestLine) return false;
    }
    for (auto end = connection.in.find('\n'); end != std::string::npos; end = connection.in.find('\n')) {
        const std::string line = connection.in.substr(0, end);
        connection.in.erase(0, end + 1);
        handler(number << kLineBits | connection.asked++, line);
    }
    return true;
}

void RequestServer::serve(int timeout_ms, const Handler& handler) {
    std::vector<pollfd> fds{{fd_, POLLIN, 0}};
    std::vector<std::uint64_t> clients;
    for (const auto& [client, connection] : connections_) {
        fds.push_back({connection.fd, static_cast<short>(POLLIN | (connection.out.empty() ? 0 : POLLOUT)), 0});
        clients.push_back(client);
    }
    if (poll(fds.data(), fds.size(), timeout_ms) <= 0) return;
    for (std::size_t i = 0; i < clients.size(); ++i) {
        Connection& connection = connections_[clients[i]];
        bool alive = true;
        if (fds[i + 1].revents & (POLLIN | POLLHUP | POLLERR)) alive = read_from(clients[i], connection, handler);
        if (alive && !connection.out.empty()) {
            const auto wrote = send(connection.fd, connection.out.data(), connection.out.size(), MSG_NOSIGNAL);
            if (wrote > 0)
                connection.out.erase(0, static_cast<std::size_t>(wrote));
            else if (wrote < 0 && errno != EAGAIN && errno != EINTR)
                alive = false;
        }
        if (alive) continue;
        close(connection.fd);
        connections_.erase(clients[i]);
    }
    if (fds[0].revents & POLLIN) accept_all();
}

std::int64_t RequestServer::uid_of(Client client) const {
    const auto found = connections_.find(client >> kLineBits);
    return found == connections_.end() ? -1 : found->second.uid;
}

void RequestServer::answer(Client client, std::string line) {
    const auto found = connections_.find(client >> kLineBits);
    if (found == connections_.end()) return;  // it did not wait
    Connection& connection = found->second;
    if (static_cast<std::uint32_t>(client) < connection.told) return;   // told already
    if (line.empty() || line.back() != '\n') line += '\n';
    connection.early.try_emplace(static_cast<std::uint32_t>(client), std::move(line));
    for (auto next = connection.early.find(connection.told); next != connection.early.end(); next = connection.early.find(connection.told)) {
        connection.out += next->second;
        connection.early.erase(next);
        ++connection.told;
    }
    if (connection.out.empty()) return;
    const auto wrote = send(connection.fd, connection.out.data(), connection.out.size(), MSG_NOSIGNAL);
    if (wrote > 0) connection.out.erase(0, static_cast<std::size_t>(wrote));
}

Result<std::string> ask_controller(const std::string& instance, std::string_view line, int patience_ms) {
    const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address;
    const socklen_t size = address_of(instance, address);
    if (fd < 0 || connect(fd, reinterpret_cast<sockaddr*>(&address), size) != 0) {
        if (fd >= 0) close(fd);
        return Diagnosis{Alarm::SegmentMissing, {}, {}, instance};
    }
    std::string out(line), in;
    out += '\n';
    for (std::size_t done = 0; done < out.size();) {
        const auto wrote = send(fd, out.data() + done, out.size() - done, MSG_NOSIGNAL);
        if (wrote <= 0) break;
        done += static_cast<std::size_t>(wrote);
    }
    while (in.find('\n') == std::string::npos) {
        pollfd ready{fd, POLLIN, 0};
        char block[4096];
        if (poll(&ready, 1, patience_ms) <= 0) break;
        const auto got = read(fd, block, sizeof block);
        if (got <= 0) break;
        in.append(block, static_cast<std::size_t>(got));
    }
    close(fd);
    const auto end = in.find('\n');
    if (end == std::string::npos) return Diagnosis{Alarm::NotServed, {}, {}, "it gave no answer"};
    return in.substr(0, end);
}

}  // namespace polyturn::supervisor
