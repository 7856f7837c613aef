#include "hmi/widgets/painted.hpp"

#include <QFontMetricsF>
#include <QPainter>
#include <utility>

#include "hmi/widgets/set_words.hpp"

namespace polyturn::hmi {
namespace {

PaintedWords& paintedListener() {
    static PaintedWords one;
    return one;
}

}  // namespace

void hearPaintedWords(PaintedWords listener) { paintedListener() = std::move(listener); }

void paintWords(QPainter& painter, const QRectF& box, int flags, const QString& text) {
    if (flags & Qt::TextWordWrap || text.contains('\n'))
        painter.drawText(box, flags, text);
    else
        paintSetLines(painter, box, flags, setWords(text, painter.font(), -1, false));
    if (!paintedListener()) return;
    const QRectF needed = QFontMetricsF(painter.font()).boundingRect(box, flags, text);
    paintedListener()(text,
                      needed.width() <= box.width() + 1.5 && needed.height() <= box.height() + 1.5);
}

}  // namespace polyturn::hmi
