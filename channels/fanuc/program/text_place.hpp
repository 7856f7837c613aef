// Where a block begins. Several may stand in one line, each behind the EOB of the one before: "N10
// G0 X10.; N20 G1 Z-5.".
#pragma once
#include <algorithm>
#include <cstdint>
#include <string_view>

#include "channels/text/line_source.hpp"

namespace polyturn::channels::fanuc {

struct TextPlace : TextPosition {  // offset and line are those of the line
    TextPlace() = default;
    TextPlace(TextPosition line_at, std::size_t column_at = 0)
        : TextPosition(line_at), column(static_cast<std::uint32_t>(column_at)) {}
    std::uint32_t column = 0;  // byte of the line; 0: its first block
    std::uint64_t byte() const { return offset + column; }
};

// Byte behind the EOB that ends the block at `from`; npos: the line ends with that block. An EOB
// within a comment is none.
inline std::size_t next_block(std::string_view line, std::size_t from) {
    if (line.find(';', from) == std::string_view::npos) return std::string_view::npos;
    for (std::size_t i = from; i < line.size(); ++i) {
        if (line[i] == ';') return i + 1;
        if (line[i] == '(') i = std::min(line.find(')', i), line.size() - 1);
    }
    return std::string_view::npos;
}

}  // namespace polyturn::channels::fanuc
