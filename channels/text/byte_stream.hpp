// Bytes from or to something outside: a file, tcp:HOST:PORT or unix:PATH. For data that a program
// takes while it runs (G05, M198) and for what it prints. Nothing here waits longer than it is
// told.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace polyturn::channels {

class ByteStream {
public:
    enum class Open : unsigned char { ToRead, ToAppend };  // of a file; a socket is both
    enum class Got : unsigned char { Data, Nothing, End, Error };

    ByteStream() = default;
    ~ByteStream() { close(); }
    ByteStream(const ByteStream&) = delete;
    ByteStream& operator=(const ByteStream&) = delete;

    static bool is_socket(std::string_view name) {
        return name.starts_with("tcp:") || name.starts_with("unix:");
    }
    // False: why() says in words of the system what is wrong.
    bool open(std::string_view name, Open how, int timeout_ms);
    bool is_open() const { return fd_ >= 0; }
    // Up to `size` bytes, as soon as there are any; Nothing: none came in this time.
    Got read(char* to, std::size_t size, std::size_t& got, int timeout_ms);
    bool write(std::string_view bytes, int timeout_ms);
    void close();
    const std::string& why() const { return why_; }

private:
    bool fail(const char* what);
    bool ready(short events, int timeout_ms);
    bool connect_to(int family, const void* address, unsigned length, int timeout_ms);

    int fd_ = -1;
    bool socket_ = false;
    std::string why_;
};

}  // namespace polyturn::channels
