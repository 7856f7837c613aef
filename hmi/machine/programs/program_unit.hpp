// The unit of lengths of a program at the cursor: forms show and write its unit, whatever
// the screens show elsewhere.
#pragma once
#include <QStringList>

#include "hmi/machine/live/live.hpp"

namespace polyturn::hmi {

// Inches: the last of its language's codes at or above the line (from 0) says so; where there is
// none, what its channel begins with.
bool countsInches(const Live& live, unsigned channel, const QString& language,
                  const QStringList& lines, int cursor);

}  // namespace polyturn::hmi
