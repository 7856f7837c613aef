#include "ipc/params/translations.hpp"

#include "polyturn/parameter_display_languages.hpp"

namespace polyturn::params {

RowWords words_of(const Row& row, DisplayLanguage display_language) {
    RowWords words{row.name, row.meaning, row.acts, {}};
    for (const Bit& bit : row.bits) words.bits[bit.number] = bit.meaning;
    if (display_language == DisplayLanguage::English) return words;
    const detail::TranslatedRow& own =
        detail::kDisplayLanguages[static_cast<std::size_t>(display_language) - 1]
                                 [static_cast<std::size_t>(&row - rows().data())];
    if (own.name.empty()) return words;
    words.name = own.name;
    words.meaning = own.meaning;
    if (!own.acts.empty()) words.acts = own.acts;  // empty where it acts
    // the build has compared them
    for (std::size_t i = 0; i < own.bits.size(); ++i) words.bits[row.bits[i].number] = own.bits[i];
    return words;
}

}  // namespace polyturn::params
