// The words of the printed references (docs/reference_*.md) in a reader's language, and what the
// pages of all languages share.
#pragma once
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "ipc/model/languages/own_m_codes.hpp"

namespace polyturn::channels {

// An English text of the tables in the language of the page; as it is where that is English. A
// table of them: channels/reference_words.txt.
class ReferenceWords {
public:
    virtual ~ReferenceWords() = default;
    virtual std::string operator()(std::string_view english) const { return std::string(english); }
};

// of a table
std::string reference_head(const ReferenceWords& words,
                           std::initializer_list<std::string_view> columns);
// M codes that the language itself acts on.
std::string m_code_section(const ReferenceWords& words, std::span<const text::OwnMCode> codes);

}  // namespace polyturn::channels
