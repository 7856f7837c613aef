#include "hmi/widgets/sheet.hpp"

#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPaintEvent>

namespace polyturn::hmi {
namespace {

bool fits(const Item& item) {
    const QFontMetricsF metrics(item.font);
    if (item.wraps) return metrics.boundingRect(item.box, item.align | Qt::TextWordWrap, item.text).height() <= item.box.height() + 1.5;
    return metrics.horizontalAdvance(item.text) <= item.box.width() + 0.5;
}

void paint(QPainter& p, const Item& item) {
    switch (item.kind) {
        case Item::Kind::Text:
            p.setPen(item.colour);
            p.setFont(item.font);
            if (item.wraps) p.drawText(item.box, item.align | Qt::TextWordWrap, item.text);
            else if (QFontMetricsF(item.font).horizontalAdvance(item.text) <= item.box.width() + 0.5) p.drawText(item.box, item.align | Qt::TextSingleLine, item.text);
            else p.drawText(item.box, item.align | Qt::TextSingleLine, QFontMetricsF(item.font).elidedText(item.text, Qt::ElideRight, item.box.width()));
            break;
        case Item::Kind::Fill:
            p.setPen(Qt::NoPen);
            p.setBrush(item.colour);
            if (item.value > 0) p.drawRoundedRect(item.box, item.value, item.value);
            else p.fillRect(item.box, item.colour);
            break;
        case Item::Kind::Frame: {
            const double width = item.align;
            p.setPen(QPen(item.colour, width));
            p.setBrush(Qt::NoBrush);
            p.drawRoundedRect(item.box.adjusted(width / 2, width / 2, -width / 2, -width / 2), item.value, item.value);
            break;
        }
        case Item::Kind::Sign: drawSign(p, item.box, item.sign, item.colour); break;
        case Item::Kind::Bar: {
            p.setPen(Qt::NoPen);
            p.setBrush(item.second);
            const double r = item.box.height() / 2;
            p.drawRoundedRect(item.box, r, r);
            const double part = std::clamp(item.value, 0.0, 1.0);
            if (part <= 0) break;
            p.setBrush(item.colour);
            p.drawRoundedRect(QRectF(item.box.topLeft(), QSizeF(std::max(item.box.height(), item.box.width() * part), item.box.height())), r, r);
            break;
        }
        case Item::Kind::Line:
            p.setPen(QPen(item.colour, item.value, Qt::SolidLine, Qt::RoundCap));
            p.drawLine(item.box.topLeft(), item.box.bottomRight());
            break;
    }
}

QRect covered(const Item& item) { return item.box.normalized().adjusted(-2, -2, 2, 2).toAlignedRect(); }

}  // namespace

bool Item::operator==(const Item& o) const {
    return kind == o.kind && box == o.box && value == o.value && sign == o.sign && align == o.align && colour == o.colour && second == o.second && wraps == o.wraps &&
           text == o.text && font == o.font;
}

Item& Writer::add(Item::Kind kind, const QRectF& box) {
    items_->emplace_back();
    items_->back().kind = kind;
    items_->back().box = box;
    return items_->back();
}
Item& Writer::text(const QRectF& box, const QString& text, const QFont& font, const QColor& colour, int align) {
    Item& item = add(Item::Kind::Text, box);
    item.text = text, item.font = font, item.colour = colour, item.align = align;
    return item;
}
void Writer::data(const QRectF& box, const QString& words, const QFont& font, const QColor& colour, int align) { text(box, words, font, colour, align).data = true; }
void Writer::fill(const QRectF& box, const QColor& colour, double radius) {
    Item& item = add(Item::Kind::Fill, box);
    item.colour = colour, item.value = radius;
}
void Writer::frame(const QRectF& box, const QColor& colour, double radius, double width) {
    Item& item = add(Item::Kind::Frame, box);
    item.colour = colour, item.value = radius, item.align = std::max(1, static_cast<int>(width + 0.5));
}
void Writer::line(const QPointF& from, const QPointF& to, const QColor& colour, double width) {
    Item& item = add(Item::Kind::Line, QRectF(from, to));
    item.colour = colour, item.value = width;
}
void Writer::sign(const QRectF& box, Sign sign, const QColor& colour) {
    Item& item = add(Item::Kind::Sign, box);
    item.sign = sign, item.colour = colour;
}
void Writer::bar(const QRectF& box, double part, const QColor& colour, const QColor& behind) {
    Item& item = add(Item::Kind::Bar, box);
    item.value = part, item.colour = colour, item.second = behind;
}

Sheet::Sheet(QWidget* parent) : QWidget(parent) { setAttribute(Qt::WA_OpaquePaintEvent); }

void Sheet::refresh() {
    next_.clear();
    hits_.clear();
    Writer writer(next_, hits_);
    compose(writer);
    // A different number of items: what follows has moved on.
    if (next_.size() != items_.size()) {
        update();
    } else {
        for (std::size_t i = 0; i < next_.size(); ++i)
            if (!(next_[i] == items_[i])) update(covered(next_[i]) | covered(items_[i]));
    }
    items_.swap(next_);
}

void Sheet::paintEvent(QPaintEvent* event) {
    QPainter p(this);
    p.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const QRegion region = event->region();
    p.setClipRegion(region);
    for (const QRect& one : region) p.fillRect(one, theme().window);
    for (const Item& item : items_)
        if (region.intersects(covered(item))) paint(p, item);
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

void Sheet::mouseReleaseEvent(QMouseEvent*) {
    if (pressed_ >= 0) released(std::exchange(pressed_, -1));
}

std::vector<QString> Sheet::shortened() const {
    std::vector<QString> out;
    for (const Item& item : items_)
        if (item.kind == Item::Kind::Text && !item.data && !item.text.isEmpty() && !fits(item)) out.push_back(item.text);
    return out;
}

QRectF Sheet::boxOf(int number) const {
    for (auto hit = hits_.rbegin(); hit != hits_.rend(); ++hit)
        if (hit->second == number) return hit->first;
    return {};
}

}  // namespace polyturn::hmi
