#include "ipc/model/files/replace_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace polyturn::text {
namespace fs = std::filesystem;
namespace {

// 0, or errno of the first thing that failed.
int write_all(const std::string& path, std::string_view bytes, mode_t mode) {
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode);
    if (fd < 0) return errno;
    int wrong = 0;
    for (std::size_t done = 0; wrong == 0 && done < bytes.size();) {
        const ssize_t wrote = ::write(fd, bytes.data() + done, bytes.size() - done);
        if (wrote > 0)
            done += static_cast<std::size_t>(wrote);
        else if (wrote == 0 || errno != EINTR)
            wrong = wrote == 0 ? ENOSPC : errno;
    }
    if (wrong == 0 && ::fchmod(fd, mode) != 0) wrong = errno;
    if (wrong == 0 && ::fsync(fd) != 0) wrong = errno;
    if (::close(fd) != 0 && wrong == 0) wrong = errno;
    return wrong;
}

void sync_folder(const fs::path& folder) {
    const int fd =
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) return;
    (void)::fsync(fd);  // some file systems have no such thing for a folder
    ::close(fd);
}

}  // namespace

Result<void> replace_file(const std::string& path, std::string_view bytes) {
    struct stat old {};
    const mode_t mode = ::stat(path.c_str(), &old) == 0 ? old.st_mode & 07777 : 0644;
    const std::string fresh = path + ".new";
    int wrong = write_all(fresh, bytes, mode);
    if (wrong == 0 && std::rename(fresh.c_str(), path.c_str()) != 0) wrong = errno;
    if (wrong != 0) {
        (void)::unlink(fresh.c_str());
        return Diagnosis{Alarm::OutputFile, {}, {}, path + " (" + std::strerror(wrong) + ")"};
    }
    sync_folder(fs::path(path).parent_path());
    return {};
}

}  // namespace polyturn::text
