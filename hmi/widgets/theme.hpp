// Colours, fonts and signs of the screens, in a light and a dark dress. Colour is never the only
// signal: each state has its sign.
#pragma once
#include <QColor>
#include <QFont>
#include <QPainter>

#include "hmi/machine/live/tone.hpp"

namespace polyturn::hmi {

struct Theme {
    bool dark;
    QColor window, bar, card, raised, edge, text, dim, faint, accent, onAccent, good, warn, bad,
        wait, mark;
    // Of a field where something is entered: unlike that of keys.
    const QColor& entry() const { return dark ? window : card; }
    const QColor& entryEdge() const { return dark ? edge : faint; }
};

const Theme& theme();
QColor colourOf(Tone tone);
void dress(bool dark);

// Sizes are written for 1280 x 800; px() scales them to the panel.
void setPanelScale(double scale);
double panelScale();
inline int px(double units) { return static_cast<int>(units * panelScale() + 0.5); }
enum class Face : std::uint8_t { Text, Condensed, Program };
QFont lettering(double units, bool bold = false, Face face = Face::Text);

void drawSign(QPainter& painter, const QRectF& box, Sign sign, const QColor& colour);

}  // namespace polyturn::hmi
