// Scroll bars that a finger can take, in the colours of the screens: of what Qt itself scrolls
// (handbook, editor).
#pragma once
class QAbstractScrollArea;

namespace polyturn::hmi {
inline constexpr int kFingerBar = 30;           // units: its width
void setFingerBars(QAbstractScrollArea& area);  // again when the theme has changed
}  // namespace polyturn::hmi
