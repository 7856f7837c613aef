#include "ipc/image/signal_translations.hpp"

#include "polyturn/signal_translations.hpp"

namespace polyturn {

std::string_view meaning_of(const SignalRow& row, DisplayLanguage display_language) {
    if (display_language == DisplayLanguage::English) return row.meaning;
    const std::string_view own =
        kSignalTranslations[static_cast<std::size_t>(display_language) - 1]
                           [static_cast<std::size_t>(&row - signal_rows().data())];
    return own.empty() ? row.meaning : own;
}

}  // namespace polyturn
