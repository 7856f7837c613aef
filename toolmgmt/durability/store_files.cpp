#include "toolmgmt/durability/store_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <vector>

namespace polyturn::toolmgmt {
namespace fs = std::filesystem;

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
    if (this == &other) return *this;
    if (fd_ >= 0) ::close(fd_);
    fd_ = other.release();
    return *this;
}

OpenFile::~OpenFile() {
    if (fd_ >= 0) ::close(fd_);
}

unsigned private_mode(const std::string& folder) {
    struct stat about {};
    return ::stat(folder.c_str(), &about) == 0 && (about.st_mode & S_ISGID) ? 0640 : 0600;
}

namespace {

void tighten_file(const fs::path& path, unsigned mode) {
    struct stat about {};
    if (::lstat(path.c_str(), &about) != 0 || !S_ISREG(about.st_mode)) return;
    if ((about.st_mode & 07777u & ~mode) != 0) ::chmod(path.c_str(), mode);
}

}  // namespace

void tighten(const std::string& folder) {
    const unsigned mode = private_mode(folder);
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.path().filename().string().rfind("store.", 0) == 0)
            tighten_file(entry.path(), mode);
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / "backups", none))
        tighten_file(entry.path(), mode);
}

std::string make_folder(const std::string& folder) {
    std::error_code none;
    fs::path at = fs::absolute(folder, none).lexically_normal();
    std::vector<fs::path> missing;
    for (; !at.empty() && !fs::exists(at, none); at = at.parent_path()) {
        missing.push_back(at);
        if (at == at.parent_path()) break;
    }
    for (auto one = missing.rbegin(); one != missing.rend(); ++one) {
        if (one->filename().empty()) continue;  // a slash at the end
        if (::mkdir(one->c_str(), 0755) != 0 && errno != EEXIST) return std::strerror(errno);
        sync_folder(one->parent_path().string());
    }
    if (!fs::is_directory(folder, none)) return "not a folder";
    return {};
}

bool sync_folder(const std::string& folder) {
    const OpenFile file(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    // some file systems have no such thing for a folder
    return file && (::fsync(file.get()) == 0 || errno == EINVAL);
}

bool sync_file(const std::string& path) {
    const OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    return file && ::fsync(file.get()) == 0;
}

bool read_whole_file(const std::string& path, std::string& out) {
    out.clear();
    const OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat about {};
    if (!file || ::fstat(file.get(), &about) != 0 || !S_ISREG(about.st_mode)) return false;
    out.resize(static_cast<std::size_t>(about.st_size));
    for (std::size_t done = 0; done < out.size();) {
        const ssize_t got =
            ::pread(file.get(), out.data() + done, out.size() - done, static_cast<off_t>(done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        done += static_cast<std::size_t>(got);
    }
    return true;
}

bool write_at(int fd, std::string_view bytes, std::uint64_t offset) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t wrote = ::pwrite(fd, bytes.data() + done, bytes.size() - done,
                                       static_cast<off_t>(offset + done));
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) return false;
        done += static_cast<std::size_t>(wrote);
    }
    return true;
}

bool replace_private(const std::string& path, std::string_view bytes) {
    const std::string fresh = path + ".new", folder = fs::path(path).parent_path().string();
    bool good = false;
    {
        const unsigned mode = private_mode(folder);
        const OpenFile file(
            ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, mode));
        good = file && ::fchmod(file.get(), mode) == 0 && write_at(file.get(), bytes, 0) &&
               ::fsync(file.get()) == 0;
    }
    good = good && std::rename(fresh.c_str(), path.c_str()) == 0 && sync_folder(folder);
    if (!good) ::unlink(fresh.c_str());
    return good;
}

std::uint64_t check_sum(std::string_view bytes, std::uint64_t seed) {
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15u;
    std::uint64_t sum = (seed + 1) * kOdd;
    const auto take = [&](std::uint64_t word) {
        sum = (sum ^ word) * kOdd;
        sum ^= sum >> 32;
    };
    std::size_t at = 0;
    for (; at + 8 <= bytes.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + at, 8);
        take(word);
    }
    std::uint64_t rest = 0;
    if (at < bytes.size()) std::memcpy(&rest, bytes.data() + at, bytes.size() - at);
    take(rest);
    take(bytes.size());
    return sum;
}

}  // namespace polyturn::toolmgmt
