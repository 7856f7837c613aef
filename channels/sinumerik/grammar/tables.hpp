// The words of the language, declared once: G commands, addresses, functions and procedures,
// statements. Rows stand in rows_*.cpp, those of the geometry in geo_rows.cpp; a row without a
// handler is refused by its name (architecture 5.12).
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "channels/sinumerik/grammar/value.hpp"
#include "channels/sinumerik/variables/variable.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct Word;

inline constexpr unsigned kGroups = 65;  // groups 1 to 64

// A G command. Of one group one may stand in a block.
struct GCode {
    std::string_view name;               // G1, DIAMON
    std::uint8_t group = 0, number = 0;  // number in the group: $P_GG, MD20150
    bool modal = true, preset = false;   // preset: active in the delivery state
    using Act = bool (*)(Execution&, const GCode&);
    // group 1: drives the block's axis words; other groups: when it is coded
    Act act = nullptr;
    // addresses that it reads itself, divided by blanks; "axes": axis words
    std::string_view takes = {};
};

// A word that takes a value: X10, CR=5, FA[X]=100.
struct Address {
    std::string_view name;
    // what may stand in [ ] or as extension
    enum class Index : std::uint8_t { None, Number, Axis, Spindle } index = Index::None;
    enum class Use : std::uint8_t {
        Block,    // read by the G command that has it in `takes`
        Setting,  // its own handler acts before the motion
        Refused,  // known, not built
    } use = Use::Block;
    using Act = bool (*)(Execution&, const Word&);
    Act act = nullptr;
    bool is_signed = true;
    // may stand several times in a block (M, H, and what has an index)
    bool repeats = false;
    bool valueless = false;  // has no value: DIAMONA[X]
};

// What a call of a function or procedure passes.
struct Argument {
    bool given = false;
    Value value;
    Reference reference;         // where the argument is a variable
    std::string system;          // where it is a system variable that is to be written
    std::vector<Value> indices;  // of that
    std::size_t column = 0;      // byte in the line
};
struct Call {
    std::vector<Argument> arguments;
    Value result;              // of a function
    std::uint16_t column = 0;  // byte in the line; 0: not of a block's text
    bool has(std::size_t i) const { return i < arguments.size() && arguments[i].given; }
    const Value& value(std::size_t i) const { return arguments[i].value; }
    double number(std::size_t i, double otherwise = 0.0) const {
        return has(i) ? arguments[i].value.number : otherwise;
    }
};

struct Command {
    std::string_view name;
    bool function = false;             // yields a value
    std::uint8_t least = 0, most = 0;  // arguments
    // of the arguments, the last one repeats, with + at the end all of them do: r number, s text, a
    // axis, b bool, c char, f frame, v variable, w variable or system variable, * any
    std::string_view types;
    using Act = bool (*)(Execution&, Call&);
    Act act = nullptr;
    bool own_block = false;  // nothing else may stand in its block
};

// A word that begins a statement: IF, DEF, GOTOF, CALL.
struct Statement {
    std::string_view name;
    using Act = bool (*)(Execution&);
    Act act = nullptr;
};

struct Symbol {
    enum class Kind : std::uint8_t {
        None,
        G,
        Address,
        Command,
        Statement,
        Operator,
        Reserved
    } kind = Kind::None;
    const void* row = nullptr;
    const GCode& g() const { return *static_cast<const GCode*>(row); }
    const Address& address() const { return *static_cast<const Address*>(row); }
    const Command& command() const { return *static_cast<const Command*>(row); }
    const Statement& statement() const { return *static_cast<const Statement*>(row); }
};

// By a name in capital letters.
Symbol find_symbol(std::string_view name);
// all groups, G505 to G599 and GFRAME0 to GFRAME100 expanded
const std::vector<GCode>& g_codes();
const GCode* find_g(unsigned group, unsigned number);  // nullptr: none
const std::vector<Address>& addresses();
const std::vector<std::string_view>& reserved_words();

// --- the rows, by subject
std::span<const GCode> program_g_codes();  // rows_g.cpp
// geo_rows.cpp: groups 1 2 3 7 9 16 17 18 22 23 40 43 44 48 60
std::span<const GCode> geometry_g_codes();
std::span<const Address> program_addresses();   // rows_addresses.cpp
std::span<const Address> geometry_addresses();  // geo_rows.cpp
std::span<const Command> program_commands();    // rows_commands.cpp
std::span<const Command> geometry_commands();   // geo_rows.cpp
std::span<const Statement> statements();        // rows_statements.cpp

}  // namespace polyturn::channels::sinumerik
