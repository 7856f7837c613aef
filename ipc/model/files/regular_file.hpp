// The door through which every file comes in that somebody names: programs, jobs, set-ups,
// machines, parameters, compensation, backups, pictures, libraries of the PLC. What it lets in is
// an ordinary file of a bounded size, opened without waiting.
//
// A name says nothing about what is behind it: a pipe without a writer holds its reader for ever, a
// device never ends, and both can take the name between a look at it and the opening. So the file
// is opened first, without blocking, and what was opened is looked at: the open descriptor cannot
// become something else. Links are followed.
#pragma once
#include <cstdint>
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::text {

// Sizes in bytes, each far above what people or machines write, and small enough to be held in
// memory several times over.
// read by windows, never held whole
inline constexpr std::uint64_t kLargestProgram = std::uint64_t{4} << 30;
// parameters, compensation tables, lists of tools
inline constexpr std::uint64_t kLargestText = std::uint64_t{64} << 20;
// jobs, set-ups, scenarios: a parsed one takes forty times as much
inline constexpr std::uint64_t kLargestToml = std::uint64_t{4} << 20;
// a PLC or drives as a shared object
inline constexpr std::uint64_t kLargestLibrary = std::uint64_t{256} << 20;

class RegularFile {
public:
    // FileUnreadable with the system's words, FileKind for what is no file, FileTooLarge above
    // `largest` bytes.
    static Result<RegularFile> open(const std::string& path, std::uint64_t largest = kLargestText);
    RegularFile(RegularFile&& other) noexcept;
    RegularFile& operator=(RegularFile&& other) noexcept;
    ~RegularFile();

    int fd() const { return fd_; }
    int release();                                // the descriptor is the caller's from here on
    std::uint64_t size() const { return size_; }  // when it was opened
    // What the file holds now, never more than `largest` of open(): it may grow while it is read.
    Result<std::string> read_all() const;

private:
    RegularFile() = default;
    std::string path_;
    std::uint64_t size_ = 0, largest_ = 0;
    int fd_ = -1;
};

}  // namespace polyturn::text
