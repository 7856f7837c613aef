// The line under way: its text, what the reader has found in it, and the place in it that a fault
// points to. The text is a copy: a block that waits at a barrier is read again from it, and a
// search for a label meanwhile moves the window of the source.
#pragma once
#include <string>
#include <string_view>

#include "channels/engine/fault_place.hpp"
#include "channels/fagor/grammar/reader.hpp"
#include "channels/text/line_source.hpp"

namespace polyturn::channels::fagor {

struct TextLine {
    std::string kept;
    std::string_view text;  // all of `kept`; empty behind the end of the text
    TextPosition at;
    bool is_first = false;  // of its text: a title may stand there
    Block block;
    engine::FaultPlace fault;

    void take(std::string_view line) {
        kept.assign(line);
        text = kept;
    }
};

}  // namespace polyturn::channels::fagor
