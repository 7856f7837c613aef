// A picture of each screen in each language and theme (or the one that is asked for), as the manual
// and reviews use them.
#pragma once
#include "hmi/app/main_window.hpp"

namespace polyturn::hmi {

// DIR/<screen>-<language>-<theme>.png; exit status.
int saveScreenshots(Choices choices, QSize size, const QString& folder, const QString& only = {});

}  // namespace polyturn::hmi
