// Looking for something in a text that is being run, by the same source: the window moves, and
// comes back.
#pragma once
#include <optional>
#include <string_view>

#include "channels/text/line_source.hpp"

namespace polyturn::channels::engine {

// The source reads on where it stood when this is gone. A line that was read before must have been
// copied: the window may have moved.
class KeepPosition {
public:
    explicit KeepPosition(LineSource& source) : source_(source), back_(source.next_position()) {}
    ~KeepPosition() { source_.seek(back_); }
    KeepPosition(const KeepPosition&) = delete;
    KeepPosition& operator=(const KeepPosition&) = delete;

private:
    LineSource& source_;
    TextPosition back_;
};

struct FoundLine {
    TextPosition at, behind;
};

// The first line of the text that is the one; the source stays where it was.
template <class Wanted>
std::optional<FoundLine> first_line(LineSource& source, Wanted is_the_one) {
    const KeepPosition keep(source);
    source.seek({0, 1});
    for (std::string_view line; source.next(line) == LineSource::Status::Line;)
        if (is_the_one(line)) return FoundLine{source.position(), source.next_position()};
    return std::nullopt;
}

}  // namespace polyturn::channels::engine
