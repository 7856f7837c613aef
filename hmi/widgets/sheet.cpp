#include "hmi/widgets/sheet.hpp"

#include <QFontMetricsF>
#include <QGlyphRun>
#include <QMouseEvent>
#include <QPaintEvent>
#include <QRawFont>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "hmi/widgets/set_words.hpp"

namespace polyturn::hmi {
namespace {

// Numbers are most of what changes from frame to frame. They need no shaping: their glyphs are
// looked up once for each font.
class NumberGlyphs {
public:
    explicit NumberGlyphs(const QFont& font) : raw_(QRawFont::fromFont(font)) {
        if (!raw_.isValid()) return;
        const QString all = QStringLiteral("0123456789.+-:/ %");
        const auto glyphs = raw_.glyphIndexesForString(all);
        const auto advances = raw_.advancesForGlyphIndexes(glyphs);
        if (glyphs.size() != all.size() || advances.size() != all.size()) return;
        for (int i = 0; i < all.size(); ++i) {
            glyph_[all[i].unicode()] = glyphs[i];
            advance_[all[i].unicode()] = advances[i].x();
            has_[all[i].unicode()] = true;
        }
    }
    // Negative: there is more in it than a number, or it does not fit.
    double width(const Item& item) const {
        if (item.text.size() > kMost) return -1;
        double width = 0;
        for (const QChar c : item.text) {
            if (c.unicode() >= has_.size() || !has_[c.unicode()]) return -1;
            width += advance_[c.unicode()];
        }
        return width > item.box.width() + 0.5 ? -1 : width;
    }
    // Where it begins: left, and its line.
    QPointF begin(const Item& item, double width) const {
        const double left = item.align & Qt::AlignRight     ? item.box.right() - width
                            : item.align & Qt::AlignHCenter ? item.box.center().x() - width / 2
                                                            : item.box.left();
        const double high = raw_.ascent() + raw_.descent();
        const double top = item.align & Qt::AlignTop      ? item.box.top()
                           : item.align & Qt::AlignBottom ? item.box.bottom() - high
                                                          : item.box.center().y() - high / 2;
        return {std::round(left), std::round(top + raw_.ascent())};
    }
    // What of it has ink in the area.
    void paint(QPainter& p, const Item& item, double width, const QRect& area) const {
        const QPointF at = begin(item, width);
        if (at.y() + raw_.descent() + 1 < area.top() ||
            at.y() - raw_.ascent() - 1 > area.bottom() + 1)
            return;
        std::array<quint32, kMost> glyphs;
        std::array<QPointF, kMost> places;
        const double aside = beside(item);
        double x = 0;
        int count = 0;
        for (const QChar c : item.text) {
            const double advance = advance_[c.unicode()];
            if (at.x() + x + advance + aside >= area.left() &&
                at.x() + x - aside <= area.right() + 1) {
                glyphs[static_cast<std::size_t>(count)] = glyph_[c.unicode()];
                places[static_cast<std::size_t>(count++)] = QPointF(x, 0);
            }
            x += advance;
        }
        if (count == 0) return;
        QGlyphRun run;
        run.setRawFont(raw_);
        run.setRawData(glyphs.data(), places.data(), count);
        p.drawGlyphRun(at, run);
    }
    // What is other ink when one number stands where another one stood: from the first digit that
    // differs on.
    QRectF changed(const Item& before, double widthBefore, const Item& now, double widthNow) const {
        const QPointF a = begin(before, widthBefore), b = begin(now, widthNow);
        double from = std::min(a.x(), b.x());
        if (a == b)
            for (qsizetype i = 0;
                 i < std::min(before.text.size(), now.text.size()) && before.text[i] == now.text[i];
                 ++i)
                from += advance_[now.text[i].unicode()];
        const double margin = beside(now);
        return QRectF(QPointF(from - margin, std::min(a.y(), b.y()) - raw_.ascent() - 1),
                      QPointF(std::max(a.x() + widthBefore, b.x() + widthNow) + margin,
                              std::max(a.y(), b.y()) + raw_.descent() + 1));
    }

private:
    static constexpr int kMost = 24;
    // ink beyond the advance
    static double beside(const Item& item) { return item.font.pixelSize() / 8.0 + 2; }
    QRawFont raw_;
    std::array<quint32, 128> glyph_{};
    std::array<double, 128> advance_{};
    std::array<bool, 128> has_{};
};

// Null: it does not begin like a number.
const NumberGlyphs* numberGlyphs(const Item& item) {
    if (item.text.isEmpty()) return nullptr;
    const QChar first = item.text[0];
    if (!first.isDigit() && first != '-' && first != '+' && first != '.') return nullptr;
    static std::map<std::tuple<int, int, QString>, NumberGlyphs> made;
    const std::tuple<int, int, QString> key{item.font.pixelSize(), item.font.weight(),
                                            item.font.family()};
    auto at = made.find(key);
    if (at == made.end()) at = made.emplace(key, NumberGlyphs(item.font)).first;
    return &at->second;
}

bool fits(const Item& item) {
    if (item.wraps) return wordsFit(item.text, item.font, item.box.size());
    return setWords(item.text, item.font, item.box.width(), false).fits;
}

// All of the area lies where a rounded box has its full width or its full height: no corner is in
// it.
bool inside(const QRectF& box, double radius, const QRectF& area) {
    return box.adjusted(radius, 0, -radius, 0).contains(area) ||
           box.adjusted(0, radius, 0, -radius).contains(area);
}

// Nothing below it is seen there.
bool hides(const Item& item, const QRectF& area) {
    return item.kind == Item::Kind::Fill && item.colour.alpha() == 255 &&
           inside(item.box, item.value, area);
}

// In an area that is clipped already.
void paint(QPainter& p, const Item& item, const QRect& area) {
    switch (item.kind) {
        case Item::Kind::Text: {
            p.setPen(item.colour);
            if (!item.wraps)
                if (const NumberGlyphs* glyphs = numberGlyphs(item))
                    if (const double width = glyphs->width(item); width >= 0) {
                        glyphs->paint(p, item, width, area);
                        break;
                    }
            if (item.text.isEmpty()) break;
            const SetWords& words = setWords(item.text, item.font, item.box.width(), item.wraps);
            if (wordsBox(item.box, item.align, words)
                    .adjusted(-item.font.pixelSize(), -3, item.font.pixelSize(), 3)
                    .intersects(area))
                paintSetWords(p, item.box, item.align, item.text, item.font, item.wraps);
            break;
        }
        case Item::Kind::Fill:
            if (item.value <= 0) {
                p.fillRect(item.box, item.colour);
            } else if (inside(item.box, item.value, area)) {
                p.fillRect(area, item.colour);
            } else {
                p.setPen(Qt::NoPen);
                p.setBrush(item.colour);
                p.drawRoundedRect(item.box, item.value, item.value);
            }
            break;
        case Item::Kind::Frame: {
            const double width = item.align;
            if (inside(item.box.adjusted(width, width, -width, -width), item.value, area)) break;
            p.setPen(QPen(item.colour, width));
            p.setBrush(Qt::NoBrush);
            p.drawRoundedRect(item.box.adjusted(width / 2, width / 2, -width / 2, -width / 2),
                              item.value, item.value);
            break;
        }
        case Item::Kind::Hatch: {
            p.save();
            p.setClipRect(item.box, Qt::IntersectClip);
            p.setPen(QPen(item.colour, std::max(1.0, px(3) / 2.0)));
            const double step = px(6), high = item.box.height();
            for (double x = std::floor((item.box.left() - high) / step) * step;
                 x < item.box.right(); x += step)
                p.drawLine(QPointF(x, item.box.bottom()), QPointF(x + high, item.box.top()));
            p.setBrush(Qt::NoBrush);
            p.drawRect(item.box.adjusted(0.5, 0.5, -0.5, -0.5));
            p.restore();
            break;
        }
        case Item::Kind::Sign:
            drawSign(p, item.box, item.sign, item.colour);
            break;
        case Item::Kind::Bar: {
            p.setPen(Qt::NoPen);
            p.setBrush(item.second);
            const double r = item.box.height() / 2;
            p.drawRoundedRect(item.box, r, r);
            const double part = std::clamp(item.value, 0.0, 1.0);
            if (part <= 0) break;
            p.setBrush(item.colour);
            p.drawRoundedRect(QRectF(item.box.topLeft(),
                                     QSizeF(std::max(item.box.height(), item.box.width() * part),
                                            item.box.height())),
                              r, r);
            break;
        }
        case Item::Kind::Line:
            p.setPen(QPen(item.colour, item.value, Qt::SolidLine, Qt::RoundCap));
            p.drawLine(item.box.topLeft(), item.box.bottomRight());
            break;
    }
}

QRect covered(const Item& item) {
    return item.box.normalized().adjusted(-2, -2, 2, 2).toAlignedRect();
}

// As covered(), and rather too much; asked for each item and each area.
bool mayTouch(const Item& item, const QRect& area) {
    const double x0 = item.box.x(), x1 = x0 + item.box.width(), y0 = item.box.y(),
                 y1 = y0 + item.box.height();
    return std::min(x0, x1) - 3 <= area.right() + 1 && std::max(x0, x1) + 3 >= area.left() &&
           std::min(y0, y1) - 3 <= area.bottom() + 1 && std::max(y0, y1) + 3 >= area.top();
}

// What must be painted again: of a number the digits that differ, else all of both.
QRect differing(const Item& before, const Item& now) {
    const QRect all = covered(before) | covered(now);
    if (before.kind != Item::Kind::Text || now.kind != Item::Kind::Text || before.wraps ||
        now.wraps || before.colour != now.colour || before.box != now.box ||
        before.align != now.align || before.font != now.font)
        return all;
    const NumberGlyphs *a = numberGlyphs(before), *b = numberGlyphs(now);
    if (!a || a != b) return all;
    const double widthBefore = a->width(before), widthNow = a->width(now);
    if (widthBefore < 0 || widthNow < 0) return all;
    return a->changed(before, widthBefore, now, widthNow).toAlignedRect();
}

}  // namespace

bool Item::operator==(const Item& o) const {
    return kind == o.kind && box == o.box && value == o.value && sign == o.sign &&
           align == o.align && colour == o.colour && second == o.second && wraps == o.wraps &&
           text == o.text && font == o.font;
}

Item& Writer::add(Item::Kind kind, const QRectF& box) {
    items_->emplace_back();
    items_->back().kind = kind;
    items_->back().box = box;
    return items_->back();
}
Item& Writer::text(const QRectF& box, const QString& text, const QFont& font, const QColor& colour,
                   int align) {
    Item& item = add(Item::Kind::Text, box);
    item.text = text;
    item.font = font;
    item.colour = colour;
    item.align = align;
    return item;
}
Item& Writer::data(const QRectF& box, const QString& words, const QFont& font, const QColor& colour,
                   int align) {
    Item& item = text(box, words, font, colour, align);
    item.data = true;
    return item;
}
void Writer::fill(const QRectF& box, const QColor& colour, double radius) {
    Item& item = add(Item::Kind::Fill, box);
    item.colour = colour;
    item.value = radius;
}
void Writer::frame(const QRectF& box, const QColor& colour, double radius, double width) {
    Item& item = add(Item::Kind::Frame, box);
    item.colour = colour;
    item.value = radius;
    item.align = std::max(1, static_cast<int>(width + 0.5));
}
void Writer::hatch(const QRectF& box, const QColor& colour) {
    add(Item::Kind::Hatch, box).colour = colour;
}
void Writer::line(const QPointF& from, const QPointF& to, const QColor& colour, double width) {
    Item& item = add(Item::Kind::Line, QRectF(from, to));
    item.colour = colour;
    item.value = width;
}
void Writer::sign(const QRectF& box, Sign sign, const QColor& colour) {
    Item& item = add(Item::Kind::Sign, box);
    item.sign = sign;
    item.colour = colour;
}
void Writer::bar(const QRectF& box, double part, const QColor& colour, const QColor& behind) {
    Item& item = add(Item::Kind::Bar, box);
    item.value = part;
    item.colour = colour;
    item.second = behind;
}

void Writer::field(const QRectF& box, const QString& words, const QString& purpose, bool here,
                   int number, Face face, qsizetype caret) {
    const Theme& t = theme();
    fill(box, t.entry(), px(6));
    frame(box, here ? t.accent : t.entryEdge(), px(6), here ? px(2) : 1);
    const QRectF inside = box.adjusted(px(10), 0, -px(10), 0);
    if (words.isEmpty() && !here)
        text(inside, purpose, lettering(15), t.dim);
    else
        data(inside,
             here ? QString(words).insert(caret < 0 ? words.size() : caret, QString::fromUtf8("▏"))
                  : words,
             lettering(16.5, face == Face::Text, face), t.text);
    if (number) {
        hit(box, number);
        fields_->push_back({box, number, words});
    }
}

Sheet::Sheet(QWidget* parent) : QWidget(parent) { setAttribute(Qt::WA_OpaquePaintEvent); }

void Sheet::refresh() {
    next_.clear();
    hits_.clear();
    fields_.clear();
    Writer writer(next_, hits_, fields_);
    compose(writer);
    // A different number of items: what follows has moved on.
    if (next_.size() != items_.size()) {
        update();
    } else {
        QRegion changed;
        for (std::size_t i = 0; i < next_.size(); ++i)
            if (!(next_[i] == items_[i])) changed |= differing(items_[i], next_[i]);
        if (!changed.isEmpty()) update(changed);
    }
    items_.swap(next_);
}

// Rectangle by rectangle: a clip of many is slow, and one lies mostly within a single area, so that
// what is below needs no painting.
void Sheet::paintEvent(QPaintEvent* event) {
    QPainter p(this);
    p.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    for (const QRect& one : event->region()) {
        p.setClipRect(one);
        std::size_t from = items_.size();
        while (from > 0 && !hides(items_[from - 1], one)) --from;
        if (from == 0)
            p.fillRect(one, theme().window);
        else
            --from;
        for (; from < items_.size(); ++from)
            if (mayTouch(items_[from], one)) paint(p, items_[from], one);
    }
}

void Sheet::resizeEvent(QResizeEvent*) { refresh(); }

void Sheet::mousePressEvent(QMouseEvent* event) {
    pressed_ = -1;
    for (auto hit = hits_.rbegin(); hit != hits_.rend(); ++hit)
        if (hit->first.contains(event->position())) {
            pressed_ = hit->second;
            touched(pressed_);
            return;
        }
}

void Sheet::mouseReleaseEvent(QMouseEvent*) { Sheet::forgetTouch(); }

void Sheet::forgetTouch() {
    if (pressed_ >= 0) released(std::exchange(pressed_, -1));
}

void FreeSheet::forgetTouch() {
    finger_.reset();
    Sheet::forgetTouch();
}

void FreeSheet::mousePressEvent(QMouseEvent* event) {
    if (onScroll) finger_ = event->position().y();
    Sheet::mousePressEvent(event);
}

void FreeSheet::mouseMoveEvent(QMouseEvent* event) {
    if (!finger_ || !onScroll) return;
    const double way = *finger_ - event->position().y();
    finger_ = event->position().y();
    onScroll(way);
}

void FreeSheet::mouseReleaseEvent(QMouseEvent* event) {
    finger_.reset();
    Sheet::mouseReleaseEvent(event);
}

void FreeSheet::wheelEvent(QWheelEvent* event) {
    if (!onScroll) return event->ignore();
    onScroll(-event->angleDelta().y() / 120.0 * px(72));  // a click: three rows
}

std::vector<QString> Sheet::shortened() const {
    std::vector<QString> out;
    for (const Item& item : items_)
        if (item.kind == Item::Kind::Text && !item.data && !item.text.isEmpty() && !fits(item))
            out.push_back(item.text);
    return out;
}

std::vector<QString> Sheet::shortenedData() const {
    std::vector<QString> out;
    for (const Item& item : items_)
        if (item.kind == Item::Kind::Text && item.data && !item.text.isEmpty() && !fits(item))
            out.push_back(item.text);
    return out;
}

std::vector<QString> Sheet::fixedWords() const {
    std::vector<QString> out;
    for (const Item& item : items_)
        if (item.kind == Item::Kind::Text && !item.data && !item.text.isEmpty())
            out.push_back(item.text);
    return out;
}

// Capital letters count, not the room between lines; what a fill between two words has covered is
// not seen.
std::vector<QString> Sheet::overlapping() const {
    const auto ink = [](const Item& item) {
        const QFontMetricsF metrics(item.font);
        if (item.wraps)
            return metrics.boundingRect(item.box, item.align | Qt::TextWordWrap, item.text)
                .intersected(item.box);
        const double wide = std::min(metrics.horizontalAdvance(item.text), item.box.width()),
                     high = metrics.capHeight();
        const double left = item.align & Qt::AlignRight     ? item.box.right() - wide
                            : item.align & Qt::AlignHCenter ? item.box.center().x() - wide / 2
                                                            : item.box.left();
        const double top = item.align & Qt::AlignTop ? item.box.top() + metrics.ascent() - high
                                                     : item.box.center().y() - high / 2;
        return QRectF(left, top, wide, high);
    };
    std::vector<QString> out;
    const auto words = [](const Item& item) {
        return item.kind == Item::Kind::Text && !item.text.trimmed().isEmpty();
    };
    for (std::size_t j = 0; j < items_.size(); ++j) {
        if (!words(items_[j])) continue;
        const QRectF upper = ink(items_[j]);
        if (!QRectF(rect()).adjusted(-1.5, -1.5, 1.5, 1.5).contains(upper))
            out.push_back(items_[j].text + " (beyond the edge)");
        for (std::size_t i = 0; i < j; ++i) {
            if (!words(items_[i])) continue;
            const QRectF both = ink(items_[i]).intersected(upper);
            if (both.width() <= 2 || both.height() <= 2) continue;
            const bool covered =
                std::any_of(items_.begin() + static_cast<std::ptrdiff_t>(i),
                            items_.begin() + static_cast<std::ptrdiff_t>(j), [&](const Item& item) {
                                return item.kind == Item::Kind::Fill && item.box.contains(both);
                            });
            if (!covered) out.push_back(items_[i].text + " / " + items_[j].text);
        }
    }
    return out;
}

QRectF Sheet::boxOf(int number) const {
    for (auto hit = hits_.rbegin(); hit != hits_.rend(); ++hit)
        if (hit->second == number) return hit->first;
    return {};
}

}  // namespace polyturn::hmi
