#include "channels/sinumerik/reference.hpp"

#include <array>
#include <map>

#include <fmt/format.h>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// The name of a row; that of a word that is known and refused says so.
std::string named(std::string_view name, bool built, const ReferenceWords& words) { return built ? std::string(name) : fmt::format("{} *({})*", name, words("refused")); }

// One row a group: what acts, what is only kept as a mode, and what is refused, in the order of the group's numbers.
std::string g_table(const ReferenceWords& words) {
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
    std::string page = "\n## " + words("G commands") + "\n" + reference_head(words, {"group", "acts", "kept as a mode, changes nothing", "refused"});
    for (const auto& [group, text] : groups) page += fmt::format("| {} | {} | {} | {} |\n", group, text[0], text[1], text[2]);
    return page;
}

std::string address_table(const ReferenceWords& words) {
    constexpr std::array<std::string_view, 4> kIndex{"", "a number", "an axis", "a spindle"};
    std::string page = "\n## " + words("Addresses") + "\n" + reference_head(words, {"address", "in brackets or as extension", "negative values"});
    for (const Address& row : addresses())
        page += fmt::format("| {} | {} | {} |\n", named(row.name, row.use != Address::Use::Refused, words), words(kIndex[static_cast<std::size_t>(row.index)]), words(row.is_signed ? "yes" : "no"));
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

std::string command_rows(std::span<const Command> rows, const ReferenceWords& words) {
    std::string page;
    for (const Command& row : rows) {
        std::string arguments;
        const std::string_view types = row.types.ends_with('+') ? row.types.substr(0, row.types.size() - 1) : row.types;
        for (std::size_t i = 0; i < row.most && !types.empty(); ++i) {
            if (i >= types.size()) {
                arguments += ", ...";
                break;
            }
            arguments += fmt::format("{}{}", i ? ", " : "", words(type_name(types[i])));
        }
        const std::string count = row.least == row.most ? fmt::format("{}", row.most) : fmt::format("{} {} {}", row.least, words("to"), row.most);
        page += fmt::format("| {} | {} | {} | {} | {} |\n", named(row.name, row.act, words), words(row.function ? "function" : "procedure"), count, arguments, row.own_block ? words("own block") : "");
    }
    return page;
}

}  // namespace

std::string reference_page(const ReferenceWords& words) {
    std::string page = "# " + words("Words of the language sinumerik") + "\n" +
                       words("This page is printed from the tables in `channels/sinumerik/rows_*.cpp` and `geo_rows.cpp` (`tools/update_references.sh`); a test sees to it that both agree.") + "\n" +
                       words("*Refused*: the word is known and stops the program with alarm PT1032 and its name. Groups and their numbers are those of $P_GG and MD20150; a star marks what is active when the control is delivered; a code in italics acts in its block only.") + "\n";
    page += g_table(words) + m_code_section(words, text::own_m_codes(Dialect::Sinumerik)) + address_table(words);
    page += "\n## " + words("Functions and procedures") + "\n" + reference_head(words, {"name", "kind", "arguments", "their types", "block"});
    page += command_rows(program_commands(), words) + command_rows(geometry_commands(), words);
    page += "\n## " + words("Words that begin a statement") + "\n";
    std::string list;
    for (const Statement& row : statements()) list += (list.empty() ? "" : ", ") + named(row.name, row.act, words);
    page += list + "\n";
    return page;
}

}  // namespace polyturn::channels::sinumerik
