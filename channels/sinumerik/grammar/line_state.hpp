// The line under way: where it stands in its text, what it says after DEFINE has been expanded or
// EXECSTRING has replaced it, and how far it has been read. Columns count in `text`.
#pragma once
#include <cstddef>
#include <string>

#include "channels/sinumerik/grammar/cursor.hpp"
#include "channels/text/line_source.hpp"

namespace polyturn::channels::sinumerik {

struct Statement;

struct LineState {
    TextPosition here;  // of the block being read
    std::string text;
    Cursor cursor;
    unsigned depth = 0;                    // of nested brackets
    const Statement* statement = nullptr;  // behind the words of the block
    std::size_t statement_at = 0;          // its column
    std::size_t program_column = 0;        // of the name of a program that the block calls
    std::string execute;                   // EXECSTRING: the line that comes next
};

// Which part of the line a fault blames; 0: not known (yet).
struct Blame {
    std::size_t column = 0, length = 0;
    std::uint32_t line = 0;
};

}  // namespace polyturn::channels::sinumerik
