#include "ipc/params/tongue.hpp"

#include "polyturn/parameter_tongues.hpp"

namespace polyturn::params {

RowWords words_of(const Row& row, Tongue tongue) {
    RowWords words{row.name, row.meaning, row.acts, {}};
    for (const Bit& bit : row.bits) words.bits[bit.number] = bit.meaning;
    if (tongue == Tongue::English) return words;
    const detail::TranslatedRow& own = detail::kTongues[static_cast<std::size_t>(tongue) - 1][static_cast<std::size_t>(&row - rows().data())];
    if (own.name.empty()) return words;
    words.name = own.name, words.meaning = own.meaning;
    if (!own.acts.empty()) words.acts = own.acts;   // empty where it acts
    for (std::size_t i = 0; i < own.bits.size(); ++i) words.bits[row.bits[i].number] = own.bits[i];   // the build has compared them
    return words;
}

}  // namespace polyturn::params
