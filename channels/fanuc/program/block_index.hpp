// Where the blocks and programs of a text begin, so that a jump costs the same wherever it leads in
// a program of 200 MB. Made in one pass when the text's first jump or call looks for something; a
// text without jumps never has one.
//
//   marks_    %  O100      O200         %        lines that begin or end a program
//   blocks_      N10 N20   N10 N20 N30           by number, then by place
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "channels/fanuc/program/text_place.hpp"

namespace polyturn::channels::fanuc {

// The number behind `letter` at the beginning of a block, behind blanks and block skip signs; -1:
// another block.
std::int64_t leading_number(std::string_view line, char letter, bool colon);

class BlockIndex {
public:
    // Reads the whole text; the source's position is unchanged.
    void build(LineSource& source);
    bool built() const { return built_; }
    // Block N of the program that begins at `begin`: the next one from `here` on, else the first
    // one before it.
    std::optional<TextPlace> block(std::int64_t number, std::uint64_t begin,
                                   std::uint64_t here) const;
    std::optional<TextPosition> program(std::int64_t number) const;

private:
    struct Block {
        std::uint32_t number, line;
        std::uint64_t byte : 48, column : 16;  // of the block; LineSource::kLongestLine
        auto operator<=>(const Block& other) const {
            return number != other.number ? number <=> other.number : byte <=> other.byte;
        }
        bool operator==(const Block& other) const {
            return number == other.number && byte == other.byte;
        }
    };
    struct Mark {
        std::uint64_t offset;
        std::uint32_t line;
        std::int64_t program;         // O number; -1: a % line
        std::uint64_t blocks_before;  // how many blocks stand before it
    };
    std::uint64_t end_of(std::uint64_t begin) const;  // where the program that begins there ends
    const Mark* next_mark(std::uint64_t from) const;

    std::vector<Block> blocks_;
    std::vector<Mark> marks_;
    bool built_ = false;
};

}  // namespace polyturn::channels::fanuc
