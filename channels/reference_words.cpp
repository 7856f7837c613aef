#include "channels/reference_words.hpp"

namespace polyturn::channels {

std::string reference_head(const ReferenceWords& words,
                           std::initializer_list<std::string_view> columns) {
    std::string head = "|", rule = "|";
    for (const std::string_view one : columns) {
        head += " " + words(one) + " |";
        rule += " --- |";
    }
    return head + "\n" + rule + "\n";
}

std::string m_code_section(const ReferenceWords& words, std::span<const text::OwnMCode> codes) {
    std::string page =
        "\n## " + words("M codes") + "\n" +
        words(
            "All other M codes are waits (N2201, N2202) or go to the PLC, which says "
            "what they do.") +
        "\n\n";
    page += reference_head(words, {"code", "what it does"});
    for (const text::OwnMCode& one : codes)
        page += "| " + std::string(one.name) + " | " + words(one.text) + " |\n";
    return page;
}

}  // namespace polyturn::channels
