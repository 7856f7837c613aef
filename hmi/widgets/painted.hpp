// Words that a picture carries beside the sheets (plots, drawings). All of them are written here,
// so that tests hear them as they read the items of sheets: none in another language, none that
// does not fit.
#pragma once
#include <QRectF>
#include <QString>
#include <functional>

class QPainter;

namespace polyturn::hmi {

void paintWords(QPainter& painter, const QRectF& box, int flags, const QString& text);

// For tests: called with each text, and whether it fits its box. Empty: nobody listens.
using PaintedWords = std::function<void(const QString& text, bool fits)>;
void hearPaintedWords(PaintedWords listener);

}  // namespace polyturn::hmi
