// Program text line by line through a window of fixed size, so that a 200 MB program needs no more
// memory than a small one.
//
//   file  |....................[ window ][.............|
//                                  ^ next_offset()
//
// next() hands out lines inside the window; seek() goes to any line that was handed out before.
//
// Lines end with LF, CRLF or CR. A byte order mark is skipped, UTF-16 and files with zero bytes are
// refused at once: a machine must not drive what is no text.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels {

struct TextPosition {
    std::uint64_t offset = 0;  // of the line's first byte
    std::uint32_t line = 1;
};

class LineSource {
public:
    static constexpr std::size_t kWindow = 256 * 1024;
    static constexpr std::size_t kLongestLine = 32 * 1024;

    LineSource() = default;
    ~LineSource();
    LineSource(LineSource&&) noexcept;
    LineSource& operator=(LineSource&&) noexcept;

    Result<void> open(const std::string& path);
    // Text that is in memory already (MDI, tests); it must outlive the source.
    Result<void> open_text(std::string_view text, std::string_view name);

    enum class Status : std::uint8_t { Line, End, TooLong, ReadError };
    // The next line without its end; good until the next call.
    Status next(std::string_view& line);
    // of the line that next() handed out last
    TextPosition position() const { return at_; }
    TextPosition next_position() const { return {base_ + cursor_, next_line_}; }
    void seek(TextPosition to);
    const std::string& name() const { return name_; }
    bool is_open() const { return open_; }

private:
    bool refill();
    Result<void> check_head();
    void close();

    int fd_ = -1;
    bool open_ = false, at_end_ = false, read_error_ = false;
    std::string name_;
    std::vector<char> buffer_;
    const char* data_ = nullptr;  // the window
    std::size_t size_ = 0;        // bytes in it
    std::size_t cursor_ = 0;      // next byte to hand out
    std::uint64_t base_ = 0;      // file offset of data_[0]
    std::uint64_t first_ = 0;     // file offset behind the byte order mark
    std::uint32_t next_line_ = 1;
    TextPosition at_;
};

}  // namespace polyturn::channels
