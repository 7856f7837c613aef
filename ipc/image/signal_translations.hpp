// What a signal of NC or PLC means, in the reader's language. Sources: signals.ru.csv,
// signals.cs.csv, signals.hu.csv (name, meaning), by the name as signals.csv writes it. What is not
// translated is shown in English.
#pragma once
#include <string_view>

#include "ipc/diagnosis/display_language.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn {

// a row of signal_rows()
std::string_view meaning_of(const SignalRow& row, DisplayLanguage display_language);

}  // namespace polyturn
