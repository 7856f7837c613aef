// One block of an address language (fanuc, nct, mefi; parts of fagor) as words, each with its
// column.
//
//   /1 N20 G01 Z#101 F[#3*2] (comment)
//
// The scanner knows letters, numbers, comments and block skip signs; what a word means is the
// language's business. Values that are no plain number (#101, [..]) are read by the language's
// hook, so that the hot path stays a straight loop.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels {

struct Word {
    // capital letter; small letter: the word had a comma before it (,R ,C)
    char address = 0;
    bool has_point = false;
    bool from_expression = false;  // not written as a plain number
    std::int8_t axis = -1;         // place of the axis where a name of several letters was written
    std::uint16_t column = 0;      // from 1, in bytes; character_column() turns it into characters
    std::uint16_t length = 0;
    double value = 0.0;
};

constexpr std::uint32_t letter_bit(char letter) { return 1u << (letter - 'A'); }
constexpr std::uint32_t letter_set(std::string_view letters) {
    std::uint32_t set = 0;
    for (const char letter : letters) set |= letter_bit(letter);
    return set;
}

// The words of a block. Cleared cheaply: only `letters` and `count` say what is valid.
struct Block {
    static constexpr std::size_t kMaxWords = 128;
    std::array<Word, kMaxWords> words;
    // index of the last word with that letter, valid where `letters` has the bit
    std::array<std::uint8_t, 26> last;
    std::uint32_t letters = 0;  // capital letters that occur
    std::uint16_t count = 0;
    // <NAME> of a program: its first byte, from 0; without the signs
    std::uint16_t name_from = 0, name_length = 0;
    // P1.12.16: several points, read by who expects a list from the text
    bool has_list = false;
    struct Empty {
        char address;
        std::uint8_t before;  // so many words stand before it
    };
    // words whose variable is empty: they are none, but arguments of a macro all the same
    std::array<Empty, 33> empties;
    std::uint16_t empty_count = 0;

    void clear() {
        letters = 0;
        count = 0;
        has_list = false;
        name_length = 0;
        empty_count = 0;
    }
    bool has(char letter) const { return (letters & letter_bit(letter)) != 0; }
    const Word& word(char letter) const {
        return words[last[static_cast<std::size_t>(letter - 'A')]];
    }
    double value(char letter) const { return word(letter).value; }
};

// Where the scanner stopped and why.
enum class ScanStop : std::uint8_t {
    EndOfLine,   // the line is used up
    EndOfBlock,  // at a ';': what follows is the next block
    // at '#' or a control word, before any word but N: the language reads the rest of the line
    Macro,
    TapeMark,      // at '%'
    Skipped,       // a block skip sign that is switched on
    NeedsBarrier,  // a value must be read from the machine first; scan the block again then
    Fault,         // see fault
};

// What the language adds to the scanner.
class ScanHook {
public:
    virtual ~ScanHook() = default;
    enum class Read : std::uint8_t { Value, Null, NeedsBarrier, Fault };
    // A value that begins with # or [ (behind an optional sign). `at` is moved behind it.
    virtual Read read_value(const char*& at, const char* end, double& value) = 0;
    virtual bool block_skip(unsigned number) = 0;
    // the switch is read when all before the sign is executed
    virtual bool skip_sign_waits() { return false; }
    // Longest axis name of several characters that begins at `at`; its length, and the place in
    // `axis`. 0: none.
    virtual std::size_t axis_name(const char* at, const char* end, int& axis) = 0;
    bool has_long_names = false;
    bool names_in_brackets = false;    // [#NAME] begins a macro statement, as # does
    bool takes_program_names = false;  // <NAME> means a program
};

struct ScanFault {
    Alarm alarm{};
    std::uint16_t column = 0, length = 0;  // bytes, from 1
    char letter = 0;                       // quoted in the text; 0 none
};

class WordScanner {
public:
    explicit WordScanner(ScanHook& hook) : hook_(&hook) {}
    // Words of `line` from byte `from` on are appended to the cleared block.
    ScanStop scan(std::string_view line, std::size_t from, Block& block);
    std::size_t stopped_at() const { return stopped_at_; }  // byte in the line
    const ScanFault& fault() const { return fault_; }

private:
    ScanStop fail(Alarm alarm, const char* line, const char* at, std::size_t length,
                  char letter = 0);

    ScanHook* hook_;
    std::size_t stopped_at_ = 0;
    ScanFault fault_;
};

// Characters before byte column `column` (from 1) of a UTF-8 line, plus one.
std::uint32_t character_column(std::string_view line, std::uint32_t column);

}  // namespace polyturn::channels
