// One change of a file as file_recorder.cpp writes it down: this head, the path, the bytes (of
// Rename: the new name).
#pragma once
#include <cstdint>

namespace polyturn::test {

struct FileRecord {
    enum Kind : std::uint32_t { Create, Write, Truncate, Sync, Unlink, Rename };
    Kind kind;
    std::uint32_t path_size;
    std::uint64_t at;    // Write: offset; Truncate: size
    std::uint64_t size;  // of the bytes behind the path
};

}  // namespace polyturn::test
