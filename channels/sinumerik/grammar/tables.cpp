#include "channels/sinumerik/grammar/tables.hpp"

#include <deque>
#include <unordered_map>

namespace polyturn::channels::sinumerik {
namespace {

// All rows in one place, with what is written as a range in the specification expanded.
struct Tables {
    std::deque<std::string> names;  // of expanded rows
    std::vector<GCode> codes;
    std::vector<Address> addresses;
    std::unordered_map<std::string_view, Symbol> symbols;
    std::array<std::array<const GCode*, 102>, kGroups> by_number{};

    Tables() {
        for (const auto rows : {geometry_g_codes(), program_g_codes()})
            codes.insert(codes.end(), rows.begin(), rows.end());
        GCode zero, grinding;
        for (const GCode& row : codes) {
            if (row.name == "G505") zero = row;
            if (row.name == "GFRAME0") grinding = row;
        }
        for (unsigned n = 506; n <= 599; ++n) {
            zero.name = names.emplace_back("G" + std::to_string(n));
            zero.number = static_cast<std::uint8_t>(n - 499);
            codes.push_back(zero);
        }
        grinding.preset = false;
        for (unsigned n = 1; n <= 100; ++n) {
            grinding.name = names.emplace_back("GFRAME" + std::to_string(n));
            grinding.number = static_cast<std::uint8_t>(n + 1);
            codes.push_back(grinding);
        }
        for (const auto rows : {geometry_addresses(), program_addresses()})
            addresses.insert(addresses.end(), rows.begin(), rows.end());
        for (const std::string_view name : reserved_words())
            symbols[name] = {Symbol::Kind::Reserved, nullptr};
        for (const GCode& row : codes) {
            symbols[row.name] = {Symbol::Kind::G, &row};
            if (row.number < 102) by_number[row.group][row.number] = &row;
        }
        for (const Address& row : addresses) symbols[row.name] = {Symbol::Kind::Address, &row};
        for (const auto rows : {geometry_commands(), program_commands()})
            for (const Command& row : rows) symbols[row.name] = {Symbol::Kind::Command, &row};
        for (const Statement& row : statements())
            symbols[row.name] = {Symbol::Kind::Statement, &row};
        for (const char* name : {"AND", "OR", "XOR", "NOT", "B_AND", "B_OR", "B_XOR", "B_NOT",
                                 "DIV", "MOD", "TRUE", "FALSE"})
            symbols[name] = {Symbol::Kind::Operator, nullptr};
    }
};

const Tables& tables() {
    static const Tables all;
    return all;
}

}  // namespace

Symbol find_symbol(std::string_view name) {
    const auto& symbols = tables().symbols;
    const auto found = symbols.find(name);
    return found == symbols.end() ? Symbol{} : found->second;
}

const std::vector<GCode>& g_codes() { return tables().codes; }
const GCode* find_g(unsigned group, unsigned number) {
    return group < kGroups && number < 102 ? tables().by_number[group][number] : nullptr;
}
const std::vector<Address>& addresses() { return tables().addresses; }

}  // namespace polyturn::channels::sinumerik
