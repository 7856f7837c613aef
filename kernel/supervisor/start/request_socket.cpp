#include "kernel/supervisor/start/request_socket.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "ipc/memory/segment.hpp"
#include "kernel/supervisor/base/refusal.hpp"

namespace polyturn::supervisor {

namespace {

constexpr unsigned kLineBits = 32;
constexpr std::size_t kReadAtOnce = 16 * 1024;
constexpr int kAcceptAtOnce = 16;
constexpr std::size_t kMostSkipped = 16 * 1024 * 1024;  // of one line

std::int64_t asker(int fd) {
    ucred who{};
    socklen_t size = sizeof who;
    return getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &who, &size) == 0
               ? static_cast<std::int64_t>(who.uid)
               : -1;
}

}  // namespace

bool RateLimit::take(Clock::time_point now) {
    if (last_ != Clock::time_point{})
        left_ = std::min(at_once_,
                         left_ + std::chrono::duration<double>(now - last_).count() * a_second_);
    last_ = now;
    if (left_ < 1) return false;
    left_ -= 1;
    return true;
}

Result<RequestServer> RequestServer::open(const std::string& instance) {
    auto door = ControllerDoor::open(instance);
    if (!door) return door.diagnosis();
    return RequestServer(std::move(*door));
}

RequestServer::RequestServer(RequestServer&& other) noexcept
    : door_(std::move(other.door_)),
      next_(other.next_),
      connections_(std::move(other.connections_)),
      guests_(std::move(other.guests_)),
      decoder_(std::move(other.decoder_)) {
    other.connections_.clear();
}

RequestServer::~RequestServer() {
    for (auto& [client, connection] : connections_) close(connection.fd);
}

void RequestServer::accept_all(int listener) {
    for (int i = 0; i < kAcceptAtOnce; ++i) {
        const int fd = accept4(listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (fd < 0) return;
        const std::int64_t uid = asker(fd), owner = static_cast<std::int64_t>(geteuid());
        const bool guest = uid != owner && uid != 0;
        const bool may = uid >= 0 && (!guest || (guests_ && guests_(uid)));
        const auto his = std::count_if(connections_.begin(), connections_.end(),
                                       [&](const auto& one) { return one.second.uid == uid; });
        const std::size_t most = kConnections - (uid == 0 ? 0
                                                 : guest  ? kKeptForOwner
                                                          : kKeptForRoot);
        const bool room =
            connections_.size() < most && (!guest || his < static_cast<std::ptrdiff_t>(kOfGuest));
        if (!may || !room) {  // reported before it is closed, so that the client knows why
            const std::string why =
                (may ? refusal({Alarm::RequestTooMany,
                                {},
                                {},
                                fmt::format("{} programs",
                                            guest && his >= static_cast<std::ptrdiff_t>(kOfGuest)
                                                ? kOfGuest
                                                : most)})
                     : refusal({Alarm::LevelTooLow,
                                {},
                                {},
                                fmt::format(
                                    "user {} of this computer is no user of the controller (users "
                                    "add NAME LEVEL uid={})",
                                    uid, uid)})) +
                "\n";
            (void)!send(fd, why.data(), why.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
            close(fd);
            continue;
        }
        Connection& fresh = connections_[next_++];
        fresh.fd = fd;
        fresh.uid = uid;
    }
}

bool RequestServer::wants_to_read(const Connection& connection) {
    return !connection.closing && !connection.ended && !connection.dead &&
           connection.unread <= kMostUnread && connection.lines.size() < kMostLines &&
           connection.queued <= kLongestImport;
}

// At most so much of one, then the others have their turn.
void RequestServer::read_from(std::uint64_t number, Connection& connection) {
    char block[kReadAtOnce];
    const auto got = read(connection.fd, block, sizeof block);
    if (got < 0) {
        connection.dead = errno != EINTR && errno != EAGAIN;
    } else if (got == 0) {
        connection.ended = true;  // what he has said is still done and answered
    } else {
        connection.in.append(block, static_cast<std::size_t>(got));
        split(number, connection);
    }
}

void RequestServer::split(std::uint64_t number, Connection& connection) {
    if (connection.skipped) {  // the rest of a line that is refused already
        const auto end = connection.in.find('\n');
        connection.skipped += std::min(end, connection.in.size());
        connection.in.erase(0, end == std::string::npos ? end : end + 1);
        if (end != std::string::npos)
            connection.skipped = 0;
        else if (connection.skipped > kMostSkipped)
            connection.closing = true;
        if (connection.skipped) return;
    }
    std::size_t begin = 0;
    while (connection.lines.size() < kMostLines) {
        const auto end = connection.in.find('\n', std::max(begin, connection.looked));
        if (end == std::string::npos) {
            connection.looked = connection.in.size();
            break;
        }
        Line line;
        line.number = connection.asked++;
        line.text = connection.in.substr(begin, end - begin);
        line.size = line.text.size();
        line.stop = is_stop(line.text);
        connection.queued += line.size;
        connection.lines.push_back(std::move(line));
        begin = connection.looked = end + 1;
    }
    connection.in.erase(0, begin);
    connection.looked = connection.looked > begin ? connection.looked - begin : 0;
    if (connection.in.size() <= kLongestImport || connection.looked < connection.in.size()) return;
    // No end of it in sight: refused, and passed over up to its end.
    connection.skipped = connection.in.size();
    connection.in = {};
    connection.looked = 0;
    answer(number << kLineBits | connection.asked++,
           refusal({Alarm::RequestBad,
                    {},
                    {},
                    fmt::format("a line longer than {} bytes", kLongestImport)}));
}

void RequestServer::decoded(Client client, Line& line, Result<Request> done) {
    line.text = {};
    line.state = done ? Line::State::Decoded : Line::State::Refused;
    if (done)
        line.request = std::move(*done);
    else
        answer(client, refusal(done.diagnosis()));
}

// Long ones elsewhere: only their own connection waits for them.
void RequestServer::decode(std::uint64_t number, Line& line) {
    const Client client = number << kLineBits | line.number;
    if (line.size <= kDecodedAtOnce || !decoder_)
        return decoded(client, line, decode_request(line.text));
    const bool taken = decoder_(line.text, [this, client](Result<Request> done) {
        const auto found = connections_.find(client >> kLineBits);
        if (found == connections_.end()) return;
        for (Line& one : found->second.lines)
            if (one.number == static_cast<std::uint32_t>(client))
                return decoded(client, one, std::move(done));
    });
    if (taken) line.state = Line::State::Decoding;
}

// Whoever can stop a machine does so before anything else is looked at. A client that sends nothing
// but stops cannot keep the others from theirs: it has so many a second.
void RequestServer::stops_first(const Handler& handler, Clock::time_point now) {
    for (auto& [number, connection] : connections_)
        for (Line& line : connection.lines) {
            if (!line.stop || line.acted || line.state == Line::State::Refused) continue;
            if (line.state == Line::State::Raw) {
                if (!connection.stop_rate.take(now)) break;
                decode(number, line);
            }
            if (line.state != Line::State::Decoded) continue;
            if (handler(number << kLineBits | line.number, line.request) == Taken::Later) break;
            line.acted = true;
            line.acted_after = connection.acts;
        }
}

bool RequestServer::turn(std::uint64_t number, Connection& connection, const Handler& handler,
                         Clock::time_point now) {
    if (connection.lines.empty() || connection.held_by >= 0 || connection.dead ||
        connection.unread > kMostUnread)
        return false;
    Line& line = connection.lines.front();
    if (line.state == Line::State::Raw) {
        if (!connection.rate.take(now)) return false;
        decode(number, line);
        if (line.state == Line::State::Raw) connection.rate.give_back();
    }
    if (line.state == Line::State::Raw || line.state == Line::State::Decoding) return false;
    if (line.state == Line::State::Decoded &&
        !(line.acted && line.acted_after == connection.acts)) {
        const Taken taken = handler(number << kLineBits | line.number, line.request);
        if (taken == Taken::Later) {
            if (line.offered == Clock::time_point{}) line.offered = now;
            if (now - line.offered < kOffered) return false;
            answer(number << kLineBits | line.number,
                   refusal({Alarm::RequestTooMany,
                            {},
                            {},
                            fmt::format("no room for it within {} s", kOffered.count())}));
        } else {
            ++connection.acts;
        }
        const bool answered =
            line.number < connection.told || connection.early.contains(line.number);
        if (taken == Taken::Holds && !answered) connection.held_by = line.number;
    }
    connection.queued -= line.size;
    connection.lines.pop_front();
    // more of what has come already
    if (connection.lines.size() + 1 == kMostLines) split(number, connection);
    return true;
}

// One line of each connection, again and again, as long as the time lasts. The next turn begins
// behind the last one's.
void RequestServer::turns(const Handler& handler, Clock::time_point now) {
    const auto until = now + kTurn;
    more_ = false;
    bool any = true;
    while (any && !connections_.empty()) {
        any = false;
        std::vector<std::uint64_t> order;
        for (auto at = connections_.upper_bound(first_); at != connections_.end(); ++at)
            order.push_back(at->first);
        for (auto at = connections_.begin(); at != connections_.end() && at->first <= first_; ++at)
            order.push_back(at->first);
        for (const std::uint64_t number : order) {
            Connection& connection = connections_.at(number);
            const auto before = Clock::now();
            if (before > until) {
                more_ = true;
                return;
            }
            if (!turn(number, connection, handler, before)) continue;
            any = true;
            first_ = number;
        }
    }
}

void RequestServer::serve(int timeout_ms, const Handler& handler, int other) {
    std::vector<pollfd> fds;
    for (const int listener : door_.listeners()) fds.push_back({listener, POLLIN, 0});
    const std::size_t behind_listeners = fds.size();
    fds.push_back({other, POLLIN, 0});
    std::vector<std::uint64_t> clients;
    for (const auto& [client, connection] : connections_) {
        const auto events = static_cast<short>((wants_to_read(connection) ? POLLIN : 0) |
                                               (connection.out.empty() ? 0 : POLLOUT));
        // who has said all and waits for nothing would wake us for ever
        fds.push_back({events || !connection.ended ? connection.fd : -1, events, 0});
        clients.push_back(client);
    }
    (void)poll(fds.data(), fds.size(), more_ ? 0 : timeout_ms);
    for (std::size_t i = 0; i < clients.size(); ++i) {
        Connection& connection = connections_.at(clients[i]);
        const short seen = fds[behind_listeners + 1 + i].revents;
        if (seen & POLLIN)
            read_from(clients[i], connection);
        else if (seen & (POLLHUP | POLLERR))
            connection.dead = true;
        if (!connection.out.empty() && !connection.dead) write_to(connection);
    }
    for (std::size_t i = 0; i < behind_listeners; ++i)
        if (fds[i].revents & POLLIN) accept_all(fds[i].fd);
    const auto now = Clock::now();
    stops_first(handler, now);
    turns(handler, Clock::now());
    close_ended(now);
}

void RequestServer::write_to(Connection& connection) {
    const auto wrote = send(connection.fd, connection.out.data(), connection.out.size(),
                            MSG_NOSIGNAL | MSG_DONTWAIT);
    if (wrote > 0) {
        connection.out.erase(0, static_cast<std::size_t>(wrote));
        connection.unread -= static_cast<std::size_t>(wrote);
        connection.over_since = {};
    } else if (wrote < 0 && errno != EAGAIN && errno != EINTR) {
        connection.dead = true;
    }
}

void RequestServer::close_ended(Clock::time_point now) {
    for (auto at = connections_.begin(); at != connections_.end();) {
        Connection& connection = at->second;
        const bool told = connection.out.empty();
        const bool over = connection.unread > kMostUnread || (connection.closing && !told);
        if (!over)
            connection.over_since = {};
        else if (connection.over_since == Clock::time_point{})
            connection.over_since = now;
        const bool silent = over && now - connection.over_since > kUnreadTimeout;
        const bool done =
            (connection.closing && told) || (connection.ended && connection.lines.empty() &&
                                             connection.asked == connection.told && told);
        if (connection.dead || silent || done) {
            close(connection.fd);
            at = connections_.erase(at);
        } else {
            ++at;
        }
    }
}

std::int64_t RequestServer::uid_of(Client client) const {
    const auto found = connections_.find(client >> kLineBits);
    return found == connections_.end() ? -1 : found->second.uid;
}

bool RequestServer::is_guest(Client client) const {
    const std::int64_t uid = uid_of(client);
    return uid != 0 && uid != static_cast<std::int64_t>(geteuid());
}

void RequestServer::answer(Client client, std::string line) {
    const auto found = connections_.find(client >> kLineBits);
    if (found == connections_.end()) return;  // it did not wait
    Connection& connection = found->second;
    const auto number = static_cast<std::uint32_t>(client);
    if (connection.held_by == number) connection.held_by = -1;
    if (number < connection.told) return;  // reported already
    if (line.empty() || line.back() != '\n') line += '\n';
    const std::size_t size = line.size();
    if (!connection.early.try_emplace(number, std::move(line)).second) return;
    connection.unread += size;
    for (auto next = connection.early.find(connection.told); next != connection.early.end();
         next = connection.early.find(connection.told)) {
        connection.out += next->second;
        connection.early.erase(next);
        ++connection.told;
    }
    if (!connection.out.empty() && !connection.dead) write_to(connection);
}

Result<std::string> ask_controller(const std::string& instance, std::string_view line,
                                   int timeout_ms) {
    auto connected = connect_to_controller(instance, true);
    if (!connected) return connected.diagnosis();
    const int fd = *connected;
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
        if (poll(&ready, 1, timeout_ms) <= 0) break;
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
