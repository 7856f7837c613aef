// Programs of the B axis: what G101 to G103 have registered, and what the block under way has
// started (b_axis.cpp).
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace polyturn::channels::fanuc {

struct BStep {
    int motion = 0;                  // 0 none, 1 G0, 2 G1
    int feed_mode = 0;               // 0 none, 1 G98, 2 G99
    int one_shot = 0, drilling = 0;  // G number times ten
    bool absolute = false, has_b = false, has_r = false, has_p = false;
    double b = 0, r = 0, q = 0, p = 0, code = 0;
    double feed = 0, feed_turn = 0;  // F read as a feed per minute, and as one per revolution; mm
    char letter = 0;                 // M S T
};

struct BPrograms {
    std::array<std::vector<BStep>, 3> programs;
    std::vector<BStep> draft;
    unsigned registering = 0;  // 1 to 3
    bool single_before = false, single_now = false;
    std::uint64_t ways = 0;  // handed over in this block: G66 does not follow them
};

}  // namespace polyturn::channels::fanuc
