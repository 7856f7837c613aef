#include "ipc/model/files/regular_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace polyturn::text {
namespace {

Diagnosis fault(Alarm alarm, const std::string& path, std::string detail) {
    return Diagnosis{alarm, Place{path, 0, 0, 0}, {}, std::move(detail)};
}

const char* kind_of(mode_t mode) {
    return S_ISDIR(mode)    ? "it is a folder"
           : S_ISFIFO(mode) ? "it is a pipe"
           : S_ISSOCK(mode) ? "it is a socket"
                            : "it is a device";
}

std::string size_text(std::uint64_t bytes) {
    constexpr std::uint64_t kMegabyte = 1u << 20;
    return std::to_string(bytes / kMegabyte) + " MB";
}

}  // namespace

Result<RegularFile> RegularFile::open(const std::string& path, std::uint64_t largest) {
    RegularFile out;
    out.path_ = path;
    out.largest_ = largest;
    // the system would read half of the name
    if (path.find('\0') != std::string::npos)
        return fault(Alarm::FileUnreadable, path, std::strerror(ENOENT));
    do out.fd_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    while (out.fd_ < 0 && errno == EINTR);
    if (out.fd_ < 0) {
        // what open() says of one
        if (errno == ENXIO) return fault(Alarm::FileKind, path, "it is a socket");
        return fault(Alarm::FileUnreadable, path, std::strerror(errno));
    }
    struct stat info {};
    if (::fstat(out.fd_, &info) != 0)
        return fault(Alarm::FileUnreadable, path, std::strerror(errno));
    if (!S_ISREG(info.st_mode)) return fault(Alarm::FileKind, path, kind_of(info.st_mode));
    out.size_ = static_cast<std::uint64_t>(info.st_size);
    if (out.size_ > largest)
        return fault(
            Alarm::FileTooLarge, path,
            "it has " + size_text(out.size_) + ", at most " + size_text(largest) + " are read");
    return out;
}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : path_(std::move(other.path_)),
      size_(other.size_),
      largest_(other.largest_),
      fd_(std::exchange(other.fd_, -1)) {}

RegularFile& RegularFile::operator=(RegularFile&& other) noexcept {
    if (this == &other) return *this;
    if (fd_ >= 0) ::close(fd_);
    path_ = std::move(other.path_);
    size_ = other.size_;
    largest_ = other.largest_;
    fd_ = std::exchange(other.fd_, -1);
    return *this;
}

RegularFile::~RegularFile() {
    if (fd_ >= 0) ::close(fd_);
}

int RegularFile::release() { return std::exchange(fd_, -1); }

Result<std::string> RegularFile::read_all() const {
    std::string out;
    out.reserve(static_cast<std::size_t>(std::min(size_, largest_)));
    std::array<char, 1 << 16> block;
    for (;;) {
        const ssize_t got =
            ::pread(fd_, block.data(), block.size(), static_cast<off_t>(out.size()));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return fault(Alarm::FileUnreadable, path_, std::strerror(errno));
        if (got == 0) return out;
        out.append(block.data(), static_cast<std::size_t>(got));
        if (out.size() > largest_)
            return fault(Alarm::FileTooLarge, path_,
                         "at most " + size_text(largest_) + " are read");
    }
}

}  // namespace polyturn::text
