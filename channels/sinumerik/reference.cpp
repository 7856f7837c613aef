#include "channels/sinumerik/reference.hpp"

#include <array>
#include <map>

#include <fmt/format.h>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::string_view kHead =
    "# Words of the language sinumerik\n"
    "This page is printed from the tables in `channels/sinumerik/rows_*.cpp` and `geo_rows.cpp` (`tools/update_references.sh`); a test sees to\n"
    "it that both agree. *Refused*: the word is known and stops the program with alarm PT1032 and its name. Groups and their numbers are those\n"
    "of $P_GG and MD20150; a star marks what is active when the control is delivered; a code in italics acts in its block only.\n";

std::string_view built(bool yes) { return yes ? "built" : "refused"; }

// One row a group: what acts, what is only kept as a mode, and what is refused, in the order of the group's numbers.
std::string g_table() {
    std::map<unsigned, std::array<std::string, 3>> groups;
    const auto collect = [&](std::span<const GCode> rows) {
        for (const GCode& row : rows) {
            std::string& text = groups[row.group][!row.act || row.act == &Interpreter::geo_not_built ? 2 : row.act == &Interpreter::g_nothing ? 1 : 0];
            if (!text.empty()) text += ' ';
            text += row.modal ? std::string(row.name) : fmt::format("*{}*", row.name);
            if (row.preset) text += "\\*";
        }
    };
    collect(program_g_codes());
    collect(geometry_g_codes());
    std::string page = "\n## G commands\n| group | acts | kept as a mode, changes nothing | refused |\n| --- | --- | --- | --- |\n";
    for (const auto& [group, text] : groups) page += fmt::format("| {} | {} | {} | {} |\n", group, text[0], text[1], text[2]);
    return page;
}

std::string address_table() {
    constexpr std::array<std::string_view, 4> kIndex{"", "a number", "an axis", "a spindle"};
    std::string page = "\n## Addresses\n| address | in brackets or as extension | negative values | state |\n| --- | --- | --- | --- |\n";
    for (const Address& row : addresses())
        page += fmt::format("| {} | {} | {} | {} |\n", row.name, kIndex[static_cast<std::size_t>(row.index)], row.is_signed ? "yes" : "no", built(row.use != Address::Use::Refused));
    return page;
}

std::string_view type_name(char letter) {
    switch (letter) {
        case 'r': return "number";
        case 's': return "text";
        case 'a': return "axis";
        case 'b': return "bool";
        case 'c': return "character";
        case 'f': return "frame";
        case 'v': case 'w': return "variable";
        default: return "any";
    }
}

std::string command_rows(std::span<const Command> rows) {
    std::string page;
    for (const Command& row : rows) {
        std::string arguments;
        const std::string_view types = row.types.ends_with('+') ? row.types.substr(0, row.types.size() - 1) : row.types;
        for (std::size_t i = 0; i < row.most && !types.empty(); ++i) {
            if (i >= types.size()) {
                arguments += ", ...";
                break;
            }
            arguments += fmt::format("{}{}", i ? ", " : "", type_name(types[i]));
        }
        const std::string count = row.least == row.most ? fmt::format("{}", row.most) : fmt::format("{} to {}", row.least, row.most);
        page += fmt::format("| {} | {} | {} | {} | {} | {} |\n", row.name, row.function ? "function" : "procedure", count, arguments, row.own_block ? "own block" : "", built(row.act));
    }
    return page;
}

}  // namespace

std::string reference_page() {
    std::string page(kHead);
    page += g_table() + address_table();
    page += "\n## Functions and procedures\n| name | kind | arguments | their types | block | state |\n| --- | --- | --- | --- | --- | --- |\n";
    page += command_rows(program_commands()) + command_rows(geometry_commands());
    page += "\n## Words that begin a statement\n| word | state |\n| --- | --- |\n";
    for (const Statement& row : statements()) page += fmt::format("| {} | {} |\n", row.name, built(row.act));
    return page;
}

}  // namespace polyturn::channels::sinumerik
