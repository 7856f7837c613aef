// The handbook in the language of the screens: operator.ru.md lies next to operator.md and has the
// same headings in the same order. A screen asks for a place by the English words; the same place
// of the other page is the heading, or the name at the head of an item, of the same number.
#pragma once
#include <QString>
#include <QStringList>

namespace polyturn::hmi {

struct HelpPlace {
    QString page, find;
};

// Headings, and names of items («- **Offsets**: …»), as they are shown.
QStringList placesOfPage(const QString& markdown);
// The page in this language (ru, cs, hu) and what is looked for in its words; where there is none,
// what was asked for.
HelpPlace placeInLanguage(const QString& folder, const HelpPlace& english, const QString& language);

}  // namespace polyturn::hmi
