// What the screens cost: frames, computing time, the longest time in which a touch had to wait, for
// each page of each screen in turn (`--measure`).
#pragma once
#include "hmi/app/main_window.hpp"

namespace polyturn::hmi {

// Prints one JSON object a page and one for the start. Exit status 1: a bound of
// docs/design/screens.md was passed.
int measureScreens(const Choices& choices, QSize size, double seconds);

}  // namespace polyturn::hmi
