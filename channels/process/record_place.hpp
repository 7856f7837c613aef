// Where in a program a record comes from: file, line, block, and the place that a resume goes back to (serial, part).
#pragma once
#include "channels/process/record_sink.hpp"

namespace polyturn::channels {

inline void place(const BlockContext& at, PathRecord& r) {
    r.file = at.file;
    r.stack_depth = at.stack_depth;
    r.line = at.line;
    r.block = at.block;
    r.serial = at.serial;
    r.part = at.part;
}

}  // namespace polyturn::channels
