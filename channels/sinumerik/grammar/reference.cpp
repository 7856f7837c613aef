#include "channels/sinumerik/grammar/reference.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

#include "channels/sinumerik/grammar/fate.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::array<std::string_view, 4> kFates{"acts", "as the machine does anyway", "warns",
                                                 "refused"};
std::string fate_text(Fate fate, const ReferenceWords& words) {
    return words(kFates[static_cast<std::size_t>(fate)]);
}

// One row a group, in the order of the group's numbers: a column for each fate.
std::string g_table(const ReferenceWords& words) {
    std::map<unsigned, std::array<std::string, kFates.size()>> groups;
    const auto collect = [&](std::span<const GCode> rows) {
        for (const GCode& row : rows) {
            std::string& text = groups[row.group][static_cast<std::size_t>(fate_of(row))];
            if (!text.empty()) text += ' ';
            text += row.modal ? std::string(row.name) : fmt::format("*{}*", row.name);
            if (row.preset) text += "\\*";
        }
    };
    collect(program_g_codes());
    collect(geometry_g_codes());
    std::string page = "\n## " + words("G commands") + "\n" +
                       reference_head(words, {"group", kFates[0], kFates[1], kFates[2], kFates[3]});
    for (const auto& [group, text] : groups)
        page +=
            fmt::format("| {} | {} | {} | {} | {} |\n", group, text[0], text[1], text[2], text[3]);
    return page;
}

std::string address_table(const ReferenceWords& words) {
    constexpr std::array<std::string_view, 4> kIndex{"", "a number", "an axis", "a spindle"};
    std::string page = "\n## " + words("Addresses") + "\n" +
                       reference_head(words, {"address", "in brackets or as extension",
                                              "negative values", "what becomes of it"});
    for (const Address& row : addresses())
        page += fmt::format("| {} | {} | {} | {} |\n", row.name,
                            words(kIndex[static_cast<std::size_t>(row.index)]),
                            words(row.is_signed ? "yes" : "no"), fate_text(fate_of(row), words));
    return page;
}

std::string_view type_name(char letter) {
    switch (letter) {
        case 'r':
            return "number";
        case 's':
            return "text";
        case 'a':
            return "axis";
        case 'b':
            return "bool";
        case 'c':
            return "character";
        case 'f':
            return "frame";
        case 'v':
        case 'w':
            return "variable";
        default:
            return "any";
    }
}

std::string command_rows(std::span<const Command> rows, const ReferenceWords& words) {
    std::string page;
    for (const Command& row : rows) {
        std::string arguments;
        const std::string_view types =
            row.types.ends_with('+') ? row.types.substr(0, row.types.size() - 1) : row.types;
        for (std::size_t i = 0; i < row.most && !types.empty(); ++i) {
            if (i >= types.size()) {
                arguments += ", ...";
                break;
            }
            arguments += fmt::format("{}{}", i ? ", " : "", words(type_name(types[i])));
        }
        const std::string count = row.least == row.most
                                      ? fmt::format("{}", row.most)
                                      : fmt::format("{} {} {}", row.least, words("to"), row.most);
        page +=
            fmt::format("| {} | {} | {} | {} | {} | {} |\n", row.name,
                        words(row.function ? "function" : "procedure"), count, arguments,
                        row.own_block ? words("own block") : "", fate_text(fate_of(row), words));
    }
    return page;
}

// Names of the language that no table gives a meaning: procedures, cycles, addresses.
std::string refused_names(const ReferenceWords& words) {
    std::string list;
    const auto add = [&](std::string_view name) {
        list += (list.empty() ? "" : ", ") + std::string(name);
    };
    for (const std::string_view name : reserved_words())
        if (find_symbol(name).kind == Symbol::Kind::Reserved) add(name);
    for (const Statement& row : statements())
        if (fate_of(row) == Fate::Refused) add(row.name);
    return "\n## " + words("Names that are refused") + "\n" +
           words(
               "Some of them are keywords that stand inside a statement (PRIO, BLSYNC, SAVE, "
               "TO) and act there; as a word of a block all of them are refused. A cycle of "
               "the control that is not here (CYCLE93) is refused by its name too.") +
           "\n\n" + list + "\n";
}

}  // namespace

std::string reference_page(const ReferenceWords& words) {
    std::string page =
        "# " + words("Words of the language sinumerik") + "\n" +
        words(
            "This page is printed from the tables in `channels/sinumerik/rows_*.cpp` and "
            "`geo_rows.cpp` (`tools/update_references.sh`); a test sees to it that both agree.") +
        "\n" +
        words(
            "Groups and their numbers are those of $P_GG and MD20150; a star marks what is "
            "active when the control is delivered; a code in italics acts in its block only.") +
        "\n" +
        words(
            "*Acts*: the word changes the path, the feed, a limit, a value, or what the PLC "
            "hears. *As the machine does anyway*: it asks for what this machine does without "
            "it, or takes only the value that does; nothing is said.") +
        "\n" +
        words(
            "*Warns*: the word is kept, $P_GG shows it, and it changes nothing; the first one "
            "of its kind in a program is told as the warning PT1576 with its name. G641 to "
            "G645 cut as G64, their rounding stays within PT_PATH_TOL.") +
        "\n" +
        words(
            "*Refused*: the word is known and stops the program; the alarm with its name has "
            "the number 12140 in a channel of this language (PT1032 elsewhere).") +
        "\n";
    page += g_table(words) + m_code_section(words, text::own_m_codes(Dialect::Sinumerik)) +
            address_table(words);
    page += "\n## " + words("Functions and procedures") + "\n" +
            reference_head(
                words, {"name", "kind", "arguments", "their types", "block", "what becomes of it"});
    page += command_rows(program_commands(), words) + command_rows(geometry_commands(), words);
    page += "\n## " + words("Words that begin a statement") + "\n";
    std::string list;
    for (const Statement& row : statements())
        if (fate_of(row) == Fate::Acts) list += (list.empty() ? "" : ", ") + std::string(row.name);
    page += list + "\n" + refused_names(words);
    return page;
}

}  // namespace polyturn::channels::sinumerik
