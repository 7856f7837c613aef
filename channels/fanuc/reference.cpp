#include "channels/fanuc/reference.hpp"

#include "channels/fanuc/g_codes.hpp"

namespace polyturn::channels::fanuc {
namespace {

std::string_view group_name(GGroup group) {
    switch (group) {
        case GGroup::Units:
            return "units";
        case GGroup::Plane:
            return "plane";
        case GGroup::Polar:
            return "polar points";
        case GGroup::Distance:
            return "absolute, incremental";
        case GGroup::FeedMode:
            return "feed";
        case GGroup::ReturnLevel:
            return "return level";
        case GGroup::ExactStop:
            return "exact stop";
        case GGroup::Surface:
            return "surface speed";
        case GGroup::Comp:
            return "compensation";
        case GGroup::Length:
            return "length offset";
        case GGroup::Scale:
            return "scaling";
        case GGroup::Mirror:
            return "mirror";
        case GGroup::Rotation:
            return "rotation";
        case GGroup::StrokeArea:
            return "stroke area";
        case GGroup::SpindleWatch:
            return "spindle watch";
        case GGroup::Zero:
            return "work zero";
        case GGroup::Drilling:
            return "drilling";
        case GGroup::MacroModal:
            return "modal macro";
        case GGroup::Transform:
            return "polar plane";
        case GGroup::OneShot:
            return "in its block";
        case GGroup::Motion:
            return "motion";
        case GGroup::Count:
            break;
    }
    return "";
}

std::string words_of(const GCode& row, const ReferenceWords& words) {
    std::string text;
    for (const char letter : row.takes) {
        if (!text.empty()) text += ' ';
        if (letter == 'x')
            text += words("axes");
        else
            text += letter;
    }
    return text;
}

}  // namespace

std::string reference_page(const ReferenceWords& words) {
    std::string page =
        "# " + words("G and M codes of the fanuc family") + "\n" +
        words(
            "This page is printed from the table in `channels/fanuc/g_codes.cpp` "
            "(`tools/update_references.sh`); a test sees to it that both agree.") +
        "\n" +
        words(
            "A, B, C are the systems of F3401, N is nct, M is mefi. *Holds at cycle start* "
            "unless a parameter says otherwise.") +
        "\n" +
        words(
            "A code that is *refused* is known and stops the program with alarm PT1032 and its "
            "name; every other code that stands not here is alarm 010.") +
        "\n\n";
    page += "## " + words("G codes") + "\n" +
            reference_head(words, {"code", "systems", "group", "words of its own", "at cycle start",
                                   "what it does"});
    for (const GCode& row : g_codes()) {
        static constexpr std::pair<GSystem, char> kSystems[] = {
            {kA, 'A'}, {kB, 'B'}, {kC, 'C'}, {kN, 'N'}, {kM, 'M'}};
        std::string systems;
        for (const auto& [bit, letter] : kSystems)
            if (row.systems & bit)
                systems += systems.empty() ? std::string(1, letter) : std::string(" ") + letter;
        page += "| " + std::string(row.name) + " | " + systems + " | " +
                words(group_name(row.group)) + " | " + words_of(row, words) + " | " +
                (row.at_reset ? words("holds") : "") + " | " +
                (row.act ? "" : "*" + words("refused") + "*: ") + words(row.text) + " |\n";
    }
    return page + m_code_section(words, text::own_m_codes(Dialect::Fanuc));
}

}  // namespace polyturn::channels::fanuc
