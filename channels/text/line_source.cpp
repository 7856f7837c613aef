#include "channels/text/line_source.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "ipc/model/files/regular_file.hpp"

namespace polyturn::channels {
namespace {

Diagnosis file_fault(Alarm alarm, const std::string& name, std::string detail) {
    return {alarm, {name, 0, 0, 0}, {}, std::move(detail)};
}

}  // namespace

LineSource::~LineSource() { close(); }

LineSource::LineSource(LineSource&& other) noexcept { *this = std::move(other); }

LineSource& LineSource::operator=(LineSource&& other) noexcept {
    if (this == &other) return *this;
    close();
    const bool in_buffer = other.data_ == other.buffer_.data();
    fd_ = std::exchange(other.fd_, -1);
    open_ = std::exchange(other.open_, false);
    at_end_ = other.at_end_;
    read_error_ = other.read_error_;
    name_ = std::move(other.name_);
    buffer_ = std::move(other.buffer_);
    data_ = in_buffer ? buffer_.data() : other.data_;
    size_ = other.size_;
    cursor_ = other.cursor_;
    base_ = other.base_;
    first_ = other.first_;
    next_line_ = other.next_line_;
    at_ = other.at_;
    other.data_ = nullptr;
    other.size_ = other.cursor_ = 0;
    return *this;
}

void LineSource::close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
    open_ = false;
}

Result<void> LineSource::open(const std::string& path) {
    close();
    name_ = path;
    auto file = text::RegularFile::open(path, text::kLargestProgram);
    if (!file) return file.diagnosis();
    fd_ = file->release();
    buffer_.resize(kWindow);
    data_ = buffer_.data();
    size_ = cursor_ = 0;
    base_ = first_ = 0;
    next_line_ = 1;
    at_ = {};
    at_end_ = read_error_ = false;
    open_ = true;
    refill();
    if (read_error_) {
        close();
        return file_fault(Alarm::FileUnreadable, path, "reading failed");
    }
    return check_head();
}

Result<void> LineSource::open_text(std::string_view text, std::string_view name) {
    close();
    name_ = name;
    data_ = text.data();
    size_ = text.size();
    cursor_ = 0;
    base_ = first_ = 0;
    next_line_ = 1;
    at_ = {};
    at_end_ = true;
    read_error_ = false;
    open_ = true;
    return check_head();
}

Result<void> LineSource::check_head() {
    const auto byte = [this](std::size_t i) {
        return i < size_ ? static_cast<unsigned char>(data_[i]) : 0u;
    };
    const bool mark16 =
        (byte(0) == 0xFF && byte(1) == 0xFE) || (byte(0) == 0xFE && byte(1) == 0xFF);
    // ASCII saved as UTF-16 without a mark: every second byte is zero.
    const bool bare16 = size_ >= 4 && ((byte(0) == 0 && byte(1) != 0 && byte(2) == 0) ||
                                       (byte(1) == 0 && byte(0) != 0 && byte(3) == 0));
    if (mark16 || bare16) {
        close();
        return file_fault(Alarm::FileUtf16, name_, name_);
    }
    const std::size_t look = size_ < 4096 ? size_ : 4096;
    if (const void* zero = look ? std::memchr(data_, 0, look) : nullptr) {
        const auto at = static_cast<std::size_t>(static_cast<const char*>(zero) - data_);
        close();
        return file_fault(Alarm::FileBinary, name_, "a zero byte at offset " + std::to_string(at));
    }
    if (byte(0) == 0xEF && byte(1) == 0xBB && byte(2) == 0xBF) cursor_ = first_ = 3;
    return {};
}

// Moves what is left to the front of the window and reads behind it. False when nothing came.
bool LineSource::refill() {
    if (at_end_ || fd_ < 0) return false;
    const std::size_t left = size_ - cursor_;
    std::memmove(buffer_.data(), buffer_.data() + cursor_, left);
    base_ += cursor_;
    cursor_ = 0;
    size_ = left;
    while (size_ < buffer_.size()) {
        const ssize_t got = ::pread(fd_, buffer_.data() + size_, buffer_.size() - size_,
                                    static_cast<off_t>(base_ + size_));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) read_error_ = true;
        if (got <= 0) {
            at_end_ = true;
            break;
        }
        size_ += static_cast<std::size_t>(got);
    }
    return size_ > left;
}

LineSource::Status LineSource::next(std::string_view& line) {
    for (;;) {
        const char* from = data_ + cursor_;
        const std::size_t left = size_ - cursor_;
        const char* end = left ? static_cast<const char*>(std::memchr(from, '\n', left)) : nullptr;
        if (!end && refill()) continue;
        if (read_error_) return Status::ReadError;
        if (!left) return Status::End;
        std::size_t length = end ? static_cast<std::size_t>(end - from) : left;
        std::size_t taken = end ? length + 1 : length;
        if (const void* cr = std::memchr(from, '\r', length)) {
            const auto at = static_cast<std::size_t>(static_cast<const char*>(cr) - from);
            if (at + 1 < length || !end) taken = at + 1;  // a CR of its own ends the line too
            length = at;
        }
        at_ = {base_ + cursor_, next_line_};
        cursor_ += taken;
        ++next_line_;
        if (length > kLongestLine) return Status::TooLong;
        line = {from, length};
        return Status::Line;
    }
}

void LineSource::seek(TextPosition to) {
    next_line_ = to.line;
    if (to.offset < first_) to.offset = first_;
    if (to.offset >= base_ && to.offset <= base_ + size_) {
        cursor_ = static_cast<std::size_t>(to.offset - base_);
        return;
    }
    base_ = to.offset;
    cursor_ = size_ = 0;
    at_end_ = false;
    refill();
}

}  // namespace polyturn::channels
