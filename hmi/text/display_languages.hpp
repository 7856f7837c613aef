// The words of the HMI in four languages: English in the source, the others from translations/*.ts
// (Qt Linguist).
//   word("Cycle start")      in the chosen language; every literal is collected by
//                            tools/update_translations.py
//   WORD("Cycle start")      marks a literal that is translated later, by word(it)
// Alarms and their remedies come from ipc/diagnosis in the same language.
#pragma once
#include <QString>
#include <string_view>

#include "ipc/diagnosis/display_language.hpp"

#define WORD(text) text

namespace polyturn::hmi {

// a literal: it must not change; of the screens' own thread
QString word(const char* english);
QString word(std::string_view english);  // of a table of ipc
// mm/min as people write it in this language; a unit that has no other way to be written stays
QString unitWord(std::string_view unit);
// The language of everything from now on; screens are made anew.
void speak(DisplayLanguage display_language);
DisplayLanguage spoken();
const char* codeOf(DisplayLanguage display_language);  // en, ru, cs, hu
const char* nameOf(DisplayLanguage display_language);  // in itself: Čeština
inline QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

}  // namespace polyturn::hmi
