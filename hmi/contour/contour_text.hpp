// A contour in a program: its description as comment lines, so that it can be read back and edited
// again, and the blocks computed from it.
//
//   (CONTOUR DIA Z0 X20 G1 FIRST100 LAST200)
//   (LINE A180 CH1)
//   (CW T R5 Z-30 X40)
//   (BLOCKS)
//   N100 G1 X20. Z0.
//   ...
//   (CONTOUR END)
//
// Numbers in a description are as the operator entered them: X is a diameter where DIA stands. A
// semicolon instead of the brackets where the language writes its comments so.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "hmi/contour/contour.hpp"

namespace polyturn::contour {

// How the channel's programs are written.
struct Writing {
    enum class Language : unsigned char { Family, Fagor, Sinumerik } language = Language::Family;
    bool diameter = true;        // X words count so
    bool says_absolute = false;  // G90 is a distance mode: the first block says it
    bool inch = false;           // lengths are inches, as the program counts them
    int decimals = 3;
};

// The contour with what belongs to its blocks and is no geometry.
struct Description {
    Contour contour;
    int approach = 1;          // to the start point: 0 not at all, 1 with the feed, 2 in rapid
    long first = 0, last = 0;  // block numbers of the first and last block; 0: none
};

struct Place {
    // lines from the description to its end, both included; to < from: none
    int from = 0, to = -1;
    bool complete = false;  // the end stands there
};

// The description that contains the line, or that begins there.
Place find_contour(const std::vector<std::string>& lines, int line);
// Nothing: the description cannot be read (somebody has edited it); `fault_line` says where.
std::optional<Description> read_contour(const std::vector<std::string>& lines, const Place& place,
                                        const Writing& writing, int* fault_line = nullptr);
// Description and blocks. The blocks are those of what is known; the caller writes only what is
// complete.
std::vector<std::string> write_contour(const Description& description, const Solved& solved,
                                       const Writing& writing);
std::vector<std::string> blocks_of(const Description& description, const Solved& solved,
                                   const Writing& writing);

}  // namespace polyturn::contour
