#include "channels/fagor/grammar/reference.hpp"

#include <fmt/format.h>

#include "channels/fagor/grammar/g_codes.hpp"
#include "channels/fagor/grammar/variable_names.hpp"

namespace polyturn::channels::fagor {
namespace {

std::string_view group_name(GGroup group) {
    switch (group) {
        case GGroup::Units:
            return "units";
        case GGroup::XFormat:
            return "radius, diameter";
        case GGroup::Plane:
            return "plane";
        case GGroup::Distance:
            return "absolute, incremental";
        case GGroup::Feed:
            return "feed";
        case GGroup::Spindle:
            return "spindle";
        case GGroup::Corner:
            return "corners";
        case GGroup::Mirror:
            return "mirror";
        case GGroup::Comp:
            return "compensation";
        case GGroup::Modifier:
            return "how the arc is given";
        case GGroup::Element:
            return "end of the block";
        case GGroup::Machine:
            return "machine zero";
        case GGroup::OneShot:
            return "acts by itself";
        case GGroup::Cycle:
            return "cycle";
        case GGroup::Motion:
            return "motion";
        case GGroup::Count:
            break;
    }
    return "";
}

std::string words_of(const GCode& row, const ReferenceWords& words) {
    std::string text;
    if (row.binds) text = fmt::format("{} {}", row.binds, words("directly behind"));
    for (const char letter : row.takes) {
        if (!text.empty()) text += ' ';
        if (letter == 'x')
            text += words("axes");
        else
            text += letter;
    }
    return text;
}

std::string_view behind_name(Shape shape) {
    switch (shape) {
        case Shape::Plain:
            break;
        case Shape::Axis:
            return "axis";
        case Shape::Index:
            return "number";
        case Shape::AxisOrIndex:
            return "axis or number";
        case Shape::AxisIndex:
            return "axis and number";
        case Shape::BlockOfProgram:
            return "block of a program";
    }
    return "";
}

}  // namespace

std::string reference_page(const ReferenceWords& words) {
    std::string page =
        "# " + words("G codes, M codes and variables of the language fagor") + "\n" +
        words(
            "This page is printed from the tables in `channels/fagor/grammar/g_codes.cpp` and "
            "`variable_names.cpp` (`tools/update_references.sh`); a test sees to it that both "
            "agree.") +
        "\n" + words("A code or word that stands not here is an alarm that names it.") + "\n";
    page += "\n## " + words("G codes") + "\n" +
            reference_head(words,
                           {"code", "group", "words of its own", "block", "holds", "what it does"});
    for (const GCode& row : g_codes())
        page += fmt::format("| G{:02} | {} | {} | {} | {} | {} |\n", row.number,
                            words(group_name(row.group)), words_of(row, words),
                            row.alone ? words("alone") : "", row.modal ? words("yes") : "",
                            words(row.text));
    page += m_code_section(words, text::own_m_codes(Dialect::Fagor));
    page += "\n## " + words("Variables") + "\n" +
            words(
                "A *live* one is a value of the machine: reading it stops the preparation of "
                "blocks until the machine stands there.") +
            "\n\n";
    page += reference_head(words, {"name", "behind it", "live", "a program may write it"});
    for (std::size_t i = 0; i < variable_count(); ++i) {
        const VariableRow& row = variable_row(i);
        page += fmt::format("| {} | {} | {} | {} |\n", row.name, words(behind_name(row.shape)),
                            row.live ? words("yes") : "", row.writable ? words("yes") : "");
    }
    return page;
}

}  // namespace polyturn::channels::fagor
