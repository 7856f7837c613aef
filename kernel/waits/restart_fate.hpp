// The result of a channel that restarts at a block together with others (restart_groups.hpp).
#pragma once
#include <cstdint>

namespace polyturn::kernel {

// Of several that end in one tick the later word is the cause: a death resets partners.
enum class RestartFate : std::uint8_t {
    Searching,
    AtBlock,
    Started,
    Reset,
    Ended,
    Alarm,
    Dead,
    Refused,
    NotAsked
};

}  // namespace polyturn::kernel
