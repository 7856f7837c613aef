// Words that are set (shaped, broken into lines, shortened) once and painted many times: the same
// pixels as QPainter::drawText, which shapes them anew each time
// (tests/unit/hmi/widgets/set_words_test.cpp compares both). What changes with each frame are
// numbers, and those need no shaping (sheet.cpp).
#pragma once
#include <QFont>
#include <QGlyphRun>
#include <QList>
#include <QRectF>
#include <QString>

#include "hmi/widgets/theme.hpp"

class QPainter;

namespace polyturn::hmi {

struct SetWords {
    struct Line {
        double advance = 0;       // as it is aligned
        QList<QGlyphRun> glyphs;  // from the place of the first line on
    };
    QList<Line> lines;
    double width = 0, height = 0;
    bool fits = true;  // in the width it was set for; else shortened
};

// Of a font, for a box that is so wide; wraps: on several lines. Good until the next call.
const SetWords& setWords(const QString& text, const QFont& font, double wide, bool wraps);
// Where they stand in a box.
QRectF wordsBox(const QRectF& box, int align, const SetWords& words);
void paintSetLines(QPainter& painter, const QRectF& box, int align, const SetWords& words);
// With the painter's pen. align: Qt::Alignment. Without wrapping, what does not fit is shortened.
void paintSetWords(QPainter& painter, const QRectF& box, int align, const QString& text,
                   const QFont& font, bool wraps = false);
// How wide a line is.
double wordsWidth(const QString& text, const QFont& font);
// On several lines, all of it.
bool wordsFit(const QString& text, const QFont& font, const QSizeF& room);
// The largest lettering from `units` down to `least` with which all of a text has room on several
// lines; where none has, the least.
QFont letteringThatFits(const QString& text, const QSizeF& room, double units, double least,
                        Face face, bool bold = false);
// As much of a text, set on several lines, as there is room for; with three dots where words had to
// go.
QString wordsCutTo(const QString& text, const QFont& font, const QSizeF& room);

}  // namespace polyturn::hmi
