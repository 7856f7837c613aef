// Whether a text holds what was typed, whatever the case and the accents: «otacky» finds «otáčky», for the letters of the screen have no accents.
#pragma once
#include <QString>

namespace polyturn::hmi {

QString withoutAccents(const QString& text);   // ё and й stay: in Russian they are letters of their own
bool holds(const QString& text, const QString& typed);

}  // namespace polyturn::hmi
