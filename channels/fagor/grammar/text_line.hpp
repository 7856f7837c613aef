// The line under way: its text, what the reader has found in it, and the place in it that a fault
// points to. The text is a copy: a block that waits at a barrier is read again from it, and a
// search for a label meanwhile moves the window of the source.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "channels/fagor/grammar/reader.hpp"
#include "channels/text/line_source.hpp"

namespace polyturn::channels::fagor {

// Where the fault lies, when the code that refuses knows better than the letter in Fault says.
struct FaultPlace {
    std::uint32_t column = 0, length = 0;  // byte in the line, from 1; 0: by the letter
    std::uint32_t line = 0;                // another line of the file; 0: the line under way
};

struct TextLine {
    std::string kept;
    std::string_view text;  // all of `kept`; empty behind the end of the text
    TextPosition at;
    bool is_first = false;  // of its text: a title may stand there
    Block block;
    FaultPlace fault;

    void take(std::string_view line) {
        kept.assign(line);
        text = kept;
    }
};

}  // namespace polyturn::channels::fagor
