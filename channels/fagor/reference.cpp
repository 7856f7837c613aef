#include "channels/fagor/reference.hpp"

#include <fmt/format.h>

#include "channels/fagor/g_codes.hpp"
#include "channels/fagor/variable_names.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr std::string_view kHead =
    "# G codes and variables of the language fagor\n"
    "This page is printed from the tables in `channels/fagor/g_codes.cpp` and `variable_names.cpp` (`tools/update_references.sh`); a test sees\n"
    "to it that both agree. A code or word that stands not here is an alarm that names it.\n"
    "\n## G codes\n"
    "| code | group | words of its own | block | holds | what it does |\n"
    "| --- | --- | --- | --- | --- | --- |\n";

std::string_view group_name(GGroup group) {
    switch (group) {
        case GGroup::Units: return "units";
        case GGroup::XFormat: return "radius, diameter";
        case GGroup::Plane: return "plane";
        case GGroup::Distance: return "absolute, incremental";
        case GGroup::Feed: return "feed";
        case GGroup::Spindle: return "spindle";
        case GGroup::Corner: return "corners";
        case GGroup::Mirror: return "mirror";
        case GGroup::Comp: return "compensation";
        case GGroup::Modifier: return "how the arc is given";
        case GGroup::Element: return "end of the block";
        case GGroup::Machine: return "machine zero";
        case GGroup::OneShot: return "acts by itself";
        case GGroup::Cycle: return "cycle";
        case GGroup::Motion: return "motion";
        case GGroup::Count: break;
    }
    return "";
}

std::string words_of(const GCode& row) {
    std::string text;
    if (row.binds) text = fmt::format("{} directly behind", row.binds);
    for (const char letter : row.takes) {
        if (!text.empty()) text += ' ';
        if (letter == 'x') text += "axes";
        else text += letter;
    }
    return text;
}

std::string_view behind_name(Shape shape) {
    switch (shape) {
        case Shape::Plain: break;
        case Shape::Axis: return "axis";
        case Shape::Index: return "number";
        case Shape::AxisOrIndex: return "axis or number";
        case Shape::AxisIndex: return "axis and number";
        case Shape::BlockOfProgram: return "block of a program";
    }
    return "";
}

}  // namespace

std::string reference_page() {
    std::string page(kHead);
    for (const GCode& row : g_codes())
        page += fmt::format("| G{:02} | {} | {} | {} | {} | {} |\n", row.number, group_name(row.group), words_of(row), row.alone ? "alone" : "", row.modal ? "yes" : "", row.text);
    page +=
        "\n## Variables\nA *live* one is a value of the machine: reading it stops the preparation of blocks until the machine stands there.\n\n"
        "| name | behind it | live | a program may write it |\n| --- | --- | --- | --- |\n";
    for (std::size_t i = 0; i < variable_count(); ++i) {
        const VariableRow& row = variable_row(i);
        page += fmt::format("| {} | {} | {} | {} |\n", row.name, behind_name(row.shape), row.live ? "yes" : "", row.writable ? "yes" : "");
    }
    return page;
}

}  // namespace polyturn::channels::fagor
