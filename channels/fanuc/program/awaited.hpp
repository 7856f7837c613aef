// What comes between two blocks: the second half of a measuring block behind its barrier, and data
// or a program that somebody else sends.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "channels/state/core.hpp"
#include "channels/text/byte_stream.hpp"

namespace polyturn::channels::fanuc {

struct Measuring {
    // a skip move is before its barrier; it measures the offset
    bool skipping = false, measuring = false;
    unsigned place = 0;
    double target = 0.0, range = 0.0;  // true mm
};

struct RemoteData {  // G5: blocks of binary data come
    bool active = false;
    unsigned axes = 0, filled = 0;
    double unit_minutes = 0.0;
    std::uint64_t blocks = 0;
    std::array<unsigned char, 2 * kChannelAxes + 1> block{};
    std::int64_t silent_since_ms = -1;
    bool override_was_locked = false;
    double feed_was = 0.0;
    FeedMode feed_mode_was = FeedMode::PerMinute;
    ByteStream from;
};

struct ExternalProgram {  // M198: a program text comes through a socket
    bool active = false;
    std::int64_t number = 0, repeats = 1, silent_since_ms = -1;
    std::string text, name;
};

struct Awaited {
    Measuring measuring;
    RemoteData remote;
    ExternalProgram external;
};

}  // namespace polyturn::channels::fanuc
