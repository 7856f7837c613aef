// What one block says: its words, G commands, procedures and the program that it calls.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"

namespace polyturn::channels::sinumerik {

// How a value counts: X=IC(5).
enum class Mode : std::uint8_t {
    Plain,
    AC,
    IC,
    DC,
    ACP,
    ACN,
    CAC,
    CIC,
    CDC,
    CACP,
    CACN,
    DAC,
    DIC,
    RAC,
    RIC,
    QU,
    PM,
    PR,
    GP
};

struct Word {
    const Address* address = nullptr;
    int axis = -1;            // place in the channel: of an axis word, or in NAME[axis]
    std::int32_t index = -1;  // numeric extension or index; -1 none
    bool spindle = false;     // the index names a spindle: S2, SPI(2)
    bool has_value = false;
    Mode mode = Mode::Plain;
    Value value;
    std::vector<Value> further;            // POSP[X]=(a, b, c)
    std::uint16_t column = 0, length = 0;  // bytes, column from 1
    double number() const { return value.number; }
};

// What a block says, gathered before anything acts.
struct Block {
    std::vector<Word> words;
    std::vector<const GCode*> codes;            // in the order of the text
    std::vector<std::uint16_t> code_columns;    // where they stand, bytes from 1
    std::array<const GCode*, kGroups> coded{};  // by group
    std::vector<std::pair<const Command*, Call>> procedures;
    struct ProgramCall {
        std::string name;
        std::vector<Argument> arguments;
        bool wanted = false;
    } program;
    bool assigns = false;  // it has assignments
    void clear() {
        words.clear();
        codes.clear();
        code_columns.clear();
        coded.fill(nullptr);
        procedures.clear();
        program = {};
        assigns = false;
    }
    const GCode* group(unsigned number) const { return coded[number]; }
};

}  // namespace polyturn::channels::sinumerik
