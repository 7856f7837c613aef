// Whether a text holds what was typed, whatever the case and the accents: «otacky» finds «otáčky»,
// for the letters of the screen have no accents.
#pragma once
#include <QString>

namespace polyturn::hmi {

// ё and й stay: in Russian they are letters of their own
QString withoutAccents(const QString& text);
bool holds(const QString& text, const QString& typed);

}  // namespace polyturn::hmi
