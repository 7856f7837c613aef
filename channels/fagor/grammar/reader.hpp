// One line of a fagor program, taken apart: header (skip conditions, label), then either ISO words
// or a statement in round brackets, then repetition and comment (fagor_8037t part 1, 2 and 5).
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels::fagor {

struct Word {
    char letter = 0;
    bool given = false;      // a number followed it; without one it counts as 0
    bool parameter = false;  // its number came from an arithmetic parameter
    double value = 0.0;
    std::uint16_t column = 0;  // byte in the line, from 1
    std::uint16_t length = 0;
};

struct Block {
    static constexpr unsigned kMostWords = 48;
    std::array<Word, kMostWords> words;
    unsigned count = 0;
    std::int64_t label = -1;
    std::int64_t repeat = -1;                      // N behind a statement; -1 none
    std::size_t statement = 0, statement_end = 0;  // bytes inside the round brackets
};

enum class BlockKind : std::uint8_t {
    Blank,    // nothing at all, not even a comment
    Comment,  // a comment, or a label alone
    Title,    // %name,attributes,
    Skipped,
    Iso,
    Statement,
    NeedsBarrier,
    Fault,
};

class ReaderHost {
public:
    virtual ~ReaderHost() = default;
    virtual bool block_skip(unsigned number) = 0;
    // The value of parameter P<number>; an alarm: there is no such parameter, or it is not this
    // program's.
    virtual std::optional<Alarm> parameter_value(std::int64_t number, double& value) = 0;
};

struct ReaderFault {
    Alarm alarm{};
    std::uint32_t column = 0, length = 0;
    std::string detail;
};

class Reader {
public:
    explicit Reader(ReaderHost& host) : host_(&host) {}
    BlockKind read(std::string_view line, Block& block);
    const ReaderFault& fault() const { return fault_; }

private:
    BlockKind statement(const char* at, Block& block);
    bool word(const char*& at, Block& block);
    bool fail(Alarm alarm, const char* at, std::size_t length, std::string detail = {});

    ReaderHost* host_;
    const char* begin_ = nullptr;
    const char* end_ = nullptr;
    ReaderFault fault_;
};

// The label of a line, without reading anything else of it; -1 none. For searching.
std::int64_t label_of(std::string_view line);
// The statement behind header and '(' without leading blanks, e.g. "SUB 7)"; empty: another kind of
// line.
std::string_view statement_of(std::string_view line);

}  // namespace polyturn::channels::fagor
