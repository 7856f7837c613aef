// Source position of a record: its kind, and where in a program it comes from (file, line, block,
// and the point that a resume goes back to: serial, part).
#pragma once
#include "channels/records/record_sink.hpp"

namespace polyturn::channels {

inline std::uint8_t code_of(RecordKind kind) { return static_cast<std::uint8_t>(kind); }

inline void place(const BlockContext& at, PathRecord& r) {
    r.file = at.file;
    r.stack_depth = at.stack_depth;
    r.line = at.line;
    r.block = at.block;
    r.serial = at.serial;
    r.part = at.part;
}

}  // namespace polyturn::channels
