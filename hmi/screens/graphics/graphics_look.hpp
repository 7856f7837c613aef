// How the picture distinguishes channels.
#pragma once
#include <QColor>

#include "hmi/widgets/theme.hpp"

namespace polyturn::hmi {

inline constexpr std::size_t kFewChannels = 4;  // whose legend leaves room for a note

inline QColor colourOf(unsigned channel) {
    static const QColor kDark[] = {"#4ea6ff", "#ff9d5c", "#42c883", "#e57bd8",
                                   "#f2d14c", "#46d3dc", "#b79cff", "#ff7f78"};
    static const QColor kLight[] = {"#0a63bd", "#b84e00", "#127c3e", "#9a2d8d",
                                    "#7d6400", "#00707f", "#5b35c4", "#b3261e"};
    return (theme().dark ? kDark : kLight)[(channel - 1) % 8];
}

}  // namespace polyturn::hmi
