#include "hmi/widgets/set_words.hpp"

#include <QFontMetricsF>
#include <QPainter>
#include <QTextLayout>
#include <cmath>
#include <unordered_map>

namespace polyturn::hmi {
namespace {

constexpr double kNoEnd = 0x01000000;  // as QPainter sets a single line
// texts; a screen has some hundreds, names of files and blocks come and go
constexpr std::size_t kMostKept = 4'000;

struct WordsKey {
    QString text;
    QFont font;
    double wide;  // -1: no end
    bool wraps;
    bool operator==(const WordsKey& o) const {
        return wide == o.wide && wraps == o.wraps && text == o.text && font == o.font;
    }
};
struct WordsHash {
    std::size_t operator()(const WordsKey& key) const {
        return qHashMulti(0, key.text, key.font.pixelSize(), static_cast<int>(key.font.weight()),
                          key.wide);
    }
};

SetWords setNow(const WordsKey& key) {
    SetWords out;
    QString text = key.text;
    if (!key.wraps && key.wide >= 0) {
        const QFontMetricsF metrics(key.font);
        // No letter is wider than its font is high, but for some signs.
        out.fits = static_cast<double>(text.size()) * key.font.pixelSize() * 1.1 <= key.wide ||
                   metrics.horizontalAdvance(text) <= key.wide + 0.5;
        if (!out.fits) text = metrics.elidedText(text, Qt::ElideRight, key.wide);
    }
    text.replace('\n', key.wraps ? QChar(QChar::LineSeparator) : QChar(' '));
    QTextLayout layout(text, key.font);
    QTextOption option;
    option.setWrapMode(key.wraps ? QTextOption::WordWrap : QTextOption::NoWrap);
    layout.setTextOption(option);
    const double leading = QFontMetricsF(key.font).leading();
    double height = -leading;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(key.wraps ? std::max(0.0, key.wide) : kNoEnd);
        height = std::ceil(height + leading);  // lines begin on whole pixels
        line.setPosition(QPointF(0, height));
        height += line.ascent() + line.descent();  // line.height() is rounded up
        out.width = std::max(out.width, line.horizontalAdvance());
    }
    layout.endLayout();
    out.height = height;
    for (int i = 0; i < layout.lineCount(); ++i)
        out.lines.push_back({layout.lineAt(i).horizontalAdvance(), layout.lineAt(i).glyphRuns()});
    return out;
}

}  // namespace

const SetWords& setWords(const QString& text, const QFont& font, double wide, bool wraps) {
    static std::unordered_map<WordsKey, SetWords, WordsHash> kept;
    const WordsKey key{text, font, wide, wraps};
    if (const auto at = kept.find(key); at != kept.end()) return at->second;
    if (kept.size() >= kMostKept) kept.clear();
    return kept.emplace(key, setNow(key)).first->second;
}

double wordsWidth(const QString& text, const QFont& font) {
    return setWords(text, font, -1, false).width;
}

bool wordsFit(const QString& text, const QFont& font, const QSizeF& room) {
    const SetWords& set = setWords(text, font, room.width(), true);
    // a space may hang over
    return set.height <= room.height() + 1 &&
           set.width <= room.width() + QFontMetricsF(font).horizontalAdvance(' ');
}

QFont letteringThatFits(const QString& text, const QSizeF& room, double units, double least,
                        Face face, bool bold) {
    constexpr double kStep = 0.5;
    for (; units > least; units -= kStep)
        if (QFont font = lettering(units, bold, face); wordsFit(text, font, room)) return font;
    return lettering(least, bold, face);
}

QString wordsCutTo(const QString& text, const QFont& font, const QSizeF& room) {
    const auto fits = [&](const QString& words) { return wordsFit(words, font, room); };
    if (fits(text)) return text;
    for (qsizetype end = text.lastIndexOf(' '); end > 0; end = text.lastIndexOf(' ', end - 1))
        if (const QString less = text.left(end).trimmed() + QChar(0x2026); fits(less)) return less;
    return text;
}

void paintSetWords(QPainter& painter, const QRectF& box, int align, const QString& text,
                   const QFont& font, bool wraps) {
    if (text.isEmpty()) return;
    const SetWords& words = setWords(text, font, box.width(), wraps);
    if (!wraps || (words.lines.size() == 1 && words.width <= box.width()))
        return paintSetLines(painter, box, align, words);
    // several lines are rare, and Qt's own rounding between them is its own
    painter.setFont(font);
    painter.drawText(box, align | Qt::TextWordWrap, text);
}

QRectF wordsBox(const QRectF& box, int align, const SetWords& words) {
    const double top = align & Qt::AlignBottom    ? box.height() - words.height
                       : align & Qt::AlignVCenter ? (box.height() - words.height) / 2
                                                  : 0;
    const double left = align & Qt::AlignRight     ? box.width() - words.width
                        : align & Qt::AlignHCenter ? (box.width() - words.width) / 2
                                                   : 0;
    return {box.x() + left, box.y() + top, words.width, words.height};
}

void paintSetLines(QPainter& painter, const QRectF& box, int align, const SetWords& words) {
    const QRectF place = wordsBox(box, align, words);
    const bool within = box.contains(place);
    if (!within) {
        painter.save();
        painter.setClipRect(box, Qt::IntersectClip);
    }
    for (const SetWords::Line& line : words.lines) {
        const double aside = align & Qt::AlignRight     ? box.width() - line.advance
                             : align & Qt::AlignHCenter ? (box.width() - line.advance) / 2
                                                        : 0;
        for (const QGlyphRun& run : line.glyphs)
            painter.drawGlyphRun(QPointF(box.x() + aside, place.y()), run);
    }
    if (!within) painter.restore();
}

}  // namespace polyturn::hmi
