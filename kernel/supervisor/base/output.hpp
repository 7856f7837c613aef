// Standard output in big pieces: a virtual run prints tens of thousands of lines a second.
#pragma once
#include <string>
#include <string_view>

namespace polyturn::supervisor {

class Output {
public:
    explicit Output(int fd = 1, bool live = false) : fd_(fd), live_(live) {
        buffer_.reserve(kFull + 4096);
    }
    ~Output() { flush(); }
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    void write(std::string_view words) {
        buffer_ += words;
        if (live_ || buffer_.size() >= kFull) flush();
    }
    void flush();
    bool broken() const { return broken_; }  // the reader has gone

private:
    static constexpr std::size_t kFull = 1 << 16;
    int fd_;
    bool live_;  // each line at once: real time, somebody watches
    bool broken_ = false;
    std::string buffer_;
};

}  // namespace polyturn::supervisor
