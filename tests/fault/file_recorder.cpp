// Preloaded into a process (LD_PRELOAD): writes down in which order it changes files below
// POLYTURN_RECORD_ROOT and when it asks for them to be on the disk, into the file POLYTURN_RECORD.
// POLYTURN_RECORD_KILL=n kills the process instead of its n-th fsync, POLYTURN_RECORD_KILL_WRITE=n
// instead of its n-th write.
// Read by store_power_test.cpp, which makes of it every state that a power cut could leave.
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <string>

#include "file_record.hpp"

namespace {

using polyturn::test::FileRecord;

const char* root() {
    static const char* const at = getenv("POLYTURN_RECORD_ROOT");
    return at;
}
bool watched(const std::string& path) { return root() && path.rfind(root(), 0) == 0; }

std::string path_of(int fd) {
    char link[64], path[PATH_MAX];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    const ssize_t size = readlink(link, path, sizeof path);
    return size > 0 ? std::string(path, static_cast<std::size_t>(size)) : std::string();
}

void note(FileRecord::Kind kind, const std::string& path, std::uint64_t at = 0,
          const void* data = nullptr, std::size_t size = 0) {
    static const int log = [] {
        const char* file = getenv("POLYTURN_RECORD");
        return file ? static_cast<int>(syscall(SYS_openat, AT_FDCWD, file,
                                               O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600))
                    : -1;
    }();
    if (log < 0 || !watched(path)) return;
    FileRecord head{kind, static_cast<std::uint32_t>(path.size()), at, size};
    std::string all(reinterpret_cast<const char*>(&head), sizeof head);
    all += path;
    if (data) all.append(static_cast<const char*>(data), size);
    (void)!syscall(SYS_write, log, all.data(), all.size());
}

template <class F>
F real(const char* name) {
    return reinterpret_cast<F>(dlsym(RTLD_NEXT, name));
}

struct Fuse {
    explicit Fuse(const char* name) : chosen(getenv(name)), left(chosen ? atoi(chosen) : 0) {}
    void look(int fd) {
        if (chosen && watched(path_of(fd)) && --left == 0) raise(SIGKILL);
    }
    const char* chosen;
    std::atomic<int> left;
};

void kill_if_due(int fd) {
    static Fuse fuse("POLYTURN_RECORD_KILL");
    fuse.look(fd);
}

void kill_at_write(int fd) {
    static Fuse fuse("POLYTURN_RECORD_KILL_WRITE");
    fuse.look(fd);
}

int opened(int fd, int flags) {
    if (fd < 0) return fd;
    const std::string path = path_of(fd);
    if (flags & O_CREAT) note(FileRecord::Create, path);
    if (flags & O_TRUNC) note(FileRecord::Truncate, path, 0);
    return fd;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    static const auto call = real<int (*)(const char*, int, ...)>("open");
    return opened(call(path, flags, mode), flags);
}
int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    static const auto call = real<int (*)(const char*, int, ...)>("open64");
    return opened(call(path, flags, mode), flags);
}
ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
    static const auto call = real<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
    kill_at_write(fd);
    const ssize_t done = call(fd, data, size, at);
    if (done > 0)
        note(FileRecord::Write, path_of(fd), static_cast<std::uint64_t>(at), data,
             static_cast<std::size_t>(done));
    return done;
}
ssize_t pwrite64(int fd, const void* data, size_t size, off64_t at) {
    static const auto call = real<ssize_t (*)(int, const void*, size_t, off64_t)>("pwrite64");
    kill_at_write(fd);
    const ssize_t done = call(fd, data, size, at);
    if (done > 0)
        note(FileRecord::Write, path_of(fd), static_cast<std::uint64_t>(at), data,
             static_cast<std::size_t>(done));
    return done;
}
ssize_t write(int fd, const void* data, size_t size) {
    static const auto call = real<ssize_t (*)(int, const void*, size_t)>("write");
    const off_t at = lseek(fd, 0, SEEK_CUR);
    const ssize_t done = call(fd, data, size);
    if (done > 0 && at >= 0)
        note(FileRecord::Write, path_of(fd), static_cast<std::uint64_t>(at), data,
             static_cast<std::size_t>(done));
    return done;
}
int fsync(int fd) {
    static const auto call = real<int (*)(int)>("fsync");
    kill_if_due(fd);
    const int done = call(fd);
    if (done == 0) note(FileRecord::Sync, path_of(fd));
    return done;
}
int fdatasync(int fd) {
    static const auto call = real<int (*)(int)>("fdatasync");
    kill_if_due(fd);
    const int done = call(fd);
    if (done == 0) note(FileRecord::Sync, path_of(fd));
    return done;
}
int ftruncate(int fd, off_t size) {
    static const auto call = real<int (*)(int, off_t)>("ftruncate");
    const int done = call(fd, size);
    if (done == 0) note(FileRecord::Truncate, path_of(fd), static_cast<std::uint64_t>(size));
    return done;
}
int ftruncate64(int fd, off64_t size) {
    static const auto call = real<int (*)(int, off64_t)>("ftruncate64");
    const int done = call(fd, size);
    if (done == 0) note(FileRecord::Truncate, path_of(fd), static_cast<std::uint64_t>(size));
    return done;
}
int unlink(const char* path) {
    static const auto call = real<int (*)(const char*)>("unlink");
    const int done = call(path);
    if (done == 0) note(FileRecord::Unlink, path);
    return done;
}
int rename(const char* from, const char* to) {
    static const auto call = real<int (*)(const char*, const char*)>("rename");
    const int done = call(from, to);
    if (done == 0) note(FileRecord::Rename, from, 0, to, strlen(to));
    return done;
}

}  // extern "C"
