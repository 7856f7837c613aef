// How the picture tells channels apart.
#pragma once
#include <QColor>

#include "hmi/widgets/theme.hpp"

namespace polyturn::hmi {

inline constexpr std::size_t kFewChannels = 4;   // whose legend leaves room for a note

inline QColor colourOf(unsigned channel) {
    static const QColor kDark[] = {"#4ea6ff", "#ff9d5c", "#42c883", "#e57bd8"}, kLight[] = {"#0a63bd", "#b84e00", "#127c3e", "#9a2d8d"};
    return (theme().dark ? kDark : kLight)[(channel - 1) % 4];
}

}  // namespace polyturn::hmi
