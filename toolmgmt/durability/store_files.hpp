// Files of the store: readable by its owner only, on the disk when a function says so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::toolmgmt {

// An open file that closes itself.
class OpenFile {
public:
    OpenFile() = default;
    explicit OpenFile(int fd) : fd_(fd) {}
    OpenFile(OpenFile&& other) noexcept : fd_(other.release()) {}
    OpenFile& operator=(OpenFile&& other) noexcept;
    ~OpenFile();
    explicit operator bool() const { return fd_ >= 0; }
    int get() const { return fd_; }
    int release() { return std::exchange(fd_, -1); }

private:
    int fd_ = -1;
};

// 0600; in a folder that hands its group on (set-group-ID, made so by the administrator) 0640.
// Whatever the umask is.
unsigned private_mode(const std::string& folder);
// Store, log, witness, sums and backups of this folder that others may read become private.
void tighten(const std::string& folder);

// Makes the folder where it is missing, its parents too, each name on the disk. Empty: done; else
// the system's words.
std::string make_folder(const std::string& folder);
// The names in it are on the disk.
bool sync_folder(const std::string& folder);
bool sync_file(const std::string& path);
// False: the file is not there or cannot be read to its end. Regular files only, opened without
// waiting.
bool read_whole_file(const std::string& path, std::string& out);
bool write_at(int fd, std::string_view bytes, std::uint64_t offset);
// The new content or the old one, private, on the disk when it returns true.
bool replace_private(const std::string& path, std::string_view bytes);

// Of 8 bytes at a time, each step reversible: two texts that differ in one place never have the
// same sum. Not against forgers.
std::uint64_t check_sum(std::string_view bytes, std::uint64_t seed);

}  // namespace polyturn::toolmgmt
