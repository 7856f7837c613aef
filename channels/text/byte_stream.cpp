#include "channels/text/byte_stream.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace polyturn::channels {

void ByteStream::close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
}

bool ByteStream::fail(const char* what) {
    why_ = what;
    close();
    return false;
}

bool ByteStream::ready(short events, int timeout_ms) {
    pollfd one{fd_, events, 0};
    for (;;) {
        const int n = ::poll(&one, 1, timeout_ms);
        if (n < 0 && errno == EINTR) continue;
        return n > 0;
    }
}

bool ByteStream::connect_to(int family, const void* address, unsigned length, int timeout_ms) {
    close();
    fd_ = ::socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (fd_ < 0) return fail(std::strerror(errno));
    socket_ = true;
    if (::connect(fd_, static_cast<const sockaddr*>(address), length) == 0) return true;
    if (errno != EINPROGRESS) return fail(std::strerror(errno));
    if (!ready(POLLOUT, timeout_ms)) return fail("no answer");
    int error = 0;
    socklen_t size = sizeof error;
    if (::getsockopt(fd_, SOL_SOCKET, SO_ERROR, &error, &size) != 0 || error != 0)
        return fail(std::strerror(error ? error : errno));
    return true;
}

bool ByteStream::open(std::string_view name, Open how, int timeout_ms) {
    close();
    why_.clear();
    socket_ = false;
    if (name.starts_with("unix:")) {
        const std::string_view path = name.substr(5);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        if (path.empty() || path.size() >= sizeof address.sun_path)
            return fail("the path of the socket is empty or too long");
        std::memcpy(address.sun_path, path.data(), path.size());
        return connect_to(AF_UNIX, &address, sizeof address, timeout_ms);
    }
    if (name.starts_with("tcp:")) {
        const std::string_view rest = name.substr(4);
        const std::size_t colon = rest.rfind(':');
        if (colon == std::string_view::npos || colon == 0 || colon + 1 == rest.size())
            return fail("tcp:HOST:PORT is wanted");
        // Numbers only: a name server that does not answer would hold the whole channel.
        const std::string host(rest.substr(0, colon) == "localhost" ? std::string_view("127.0.0.1")
                                                                    : rest.substr(0, colon)),
            port(rest.substr(colon + 1));
        addrinfo hints{}, *found = nullptr;
        hints.ai_socktype = SOCK_STREAM;
        hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV;
        if (const int error = ::getaddrinfo(host.c_str(), port.c_str(), &hints, &found); error != 0)
            return fail(::gai_strerror(error));
        bool good = false;
        for (const addrinfo* one = found; one && !good; one = one->ai_next)
            good = connect_to(one->ai_family, one->ai_addr, one->ai_addrlen, timeout_ms);
        ::freeaddrinfo(found);
        return good;
    }
    const std::string path(name);
    fd_ = how == Open::ToRead
              ? ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)
              : ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0644);
    return fd_ >= 0 || fail(std::strerror(errno));
}

ByteStream::Got ByteStream::read(char* to, std::size_t size, std::size_t& got, int timeout_ms) {
    got = 0;
    if (fd_ < 0) return Got::Error;
    for (;;) {
        const ssize_t n = ::read(fd_, to, size);
        if (n > 0) {
            got = static_cast<std::size_t>(n);
            return Got::Data;
        }
        if (n == 0) return Got::End;
        if (errno == EINTR) continue;
        if (errno != EAGAIN && errno != EWOULDBLOCK) {
            why_ = std::strerror(errno);
            return Got::Error;
        }
        if (timeout_ms <= 0 || !ready(POLLIN, timeout_ms)) return Got::Nothing;
        timeout_ms = 0;
    }
}

bool ByteStream::write(std::string_view bytes, int timeout_ms) {
    while (!bytes.empty()) {
        if (fd_ < 0) return false;
        const ssize_t n = socket_ ? ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                  : ::write(fd_, bytes.data(), bytes.size());
        if (n > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(n));
            continue;
        }
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK) && ready(POLLOUT, timeout_ms))
            continue;
        return fail(n < 0 ? std::strerror(errno) : "it takes nothing more");
    }
    return true;
}

}  // namespace polyturn::channels
