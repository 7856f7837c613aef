#include "hmi/widgets/table.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <cmath>

#include "hmi/widgets/set_words.hpp"

namespace polyturn::hmi {

Table::Table(QWidget* parent) : Sheet(parent) {}

double Table::head() const {
    for (const Column& one : columns)
        if (!one.title.isEmpty()) return px(30);
    return 0;
}

double Table::left(int column) const {
    double all = 0, before = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (static_cast<int>(i) < column) before += columns[i].share;
        all += columns[i].share;
    }
    return (width() - px(14)) * before / std::max(all, 1e-9);
}

int Table::visibleRows() const {
    return std::max(1, static_cast<int>((height() - head()) / px(rowUnits)));
}

int Table::nextColumn(int from, int step) const {
    for (int at = from + step; at >= 0 && at < static_cast<int>(columns.size()); at += step)
        if (columns[static_cast<std::size_t>(at)].editable) return at;
    return from;
}

void Table::scrollTo(double first) {
    first_ = std::clamp(first, 0.0, std::max(0.0, static_cast<double>(count() - visibleRows())));
}

void Table::choose(int row, int column) {
    const int rowsNow = count();
    row_ = std::clamp(row, 0, std::max(0, rowsNow - 1));
    if (column >= 0) column_ = column;
    if (byCell && (column_ < 0 || column_ >= static_cast<int>(columns.size()) ||
                   !columns[static_cast<std::size_t>(column_)].editable))
        column_ = nextColumn(-1, 1);
    if (row_ < first_) scrollTo(row_);
    if (row_ > first_ + visibleRows() - 1) scrollTo(row_ - visibleRows() + 1);
    if (onChosen) onChosen();
    refresh();
}

bool Table::key(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Up:
            choose(row_ - 1);
            return true;
        case Qt::Key_Down:
            choose(row_ + 1);
            return true;
        case Qt::Key_PageUp:
            choose(row_ - visibleRows());
            return true;
        case Qt::Key_PageDown:
            choose(row_ + visibleRows());
            return true;
        case Qt::Key_Home:
            choose(0);
            return true;
        case Qt::Key_End:
            choose(count() - 1);
            return true;
        case Qt::Key_Left:
            if (byCell) {
                choose(row_, nextColumn(column_, -1));
                return true;
            }
            return false;
        case Qt::Key_Right:
            if (byCell) {
                choose(row_, nextColumn(column_, 1));
                return true;
            }
            return false;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (onActivated && count()) {
                onActivated();
                return true;
            }
            return false;
        default:
            return false;
    }
}

QRectF Table::cellBox(int row, int column) const {
    const double top = head() + (row - first_) * px(rowUnits);
    if (row < 0 || row >= count() || top < head() - 0.5 || top + px(rowUnits) > height() + 0.5)
        return {};
    return {left(column), top, left(column + 1) - left(column), static_cast<double>(px(rowUnits))};
}

// Words that have no room stand closer together; numbers change with each frame and are not
// measured.
QFont Table::letteringOf(const Cell& one, double room) const {
    const double units = one.units > 0 ? one.units : textUnits;
    const QFont font = lettering(units, one.bold, one.face);
    const bool word = one.face == Face::Text && !one.text.isEmpty() && one.text[0].isLetter();
    if (!word || static_cast<double>(one.text.size()) * font.pixelSize() * 0.9 <= room ||
        wordsWidth(one.text, font) <= room)
        return font;
    return lettering(units, one.bold, Face::Condensed);
}

void Table::compose(Writer& w) {
    const Theme& t = theme();
    const int all = count(), last = static_cast<int>(columns.size());
    if (row_ >= all) row_ = std::max(0, all - 1);
    scrollTo(first_);
    w.fill(QRectF(0, 0, width(), height()), t.card);
    const double row = px(rowUnits), pad = px(8);
    if (head() > 0) {
        w.fill(QRectF(0, 0, width(), head()), t.raised);
        for (int c = 0; c < last; ++c) {
            const Column& column = columns[static_cast<std::size_t>(c)];
            w.text(QRectF(left(c) + pad, 0, left(c + 1) - left(c) - 2 * pad, head()), column.title,
                   lettering(13, false, Face::Condensed), t.dim, column.align);
        }
    }
    const int first = static_cast<int>(std::lround(first_));
    for (int r = first; r < all && r < first + visibleRows(); ++r) {
        const QRectF line(0, head() + (r - first) * row, width() - px(12), row);
        const bool here = marked && r == row_;
        w.fill(line, here    ? t.mark
                     : r % 2 ? t.card
                             : (t.dark ? t.card.lighter(108) : t.card.darker(102)));
        for (int c = 0; c < last; ++c) {
            const Cell one = cell(r, c);
            const Column& column = columns[static_cast<std::size_t>(c)];
            QRectF box(left(c), line.top(), left(c + 1) - left(c), row);
            if (one.behind.isValid())
                w.fill(box.adjusted(px(2), px(2), -px(2), -px(2)), one.behind, px(4));
            if (byCell && here && c == column_)
                w.frame(box.adjusted(1, 1, -1, -1), t.accent, px(4), px(2));
            double from = box.left() + pad;
            if (one.sign != Sign::None) {
                w.sign(QRectF(from, box.center().y() - px(9), px(18), px(18)), one.sign,
                       one.colour.isValid() ? one.colour : t.dim);
                from += px(26);
            }
            if (one.bar >= 0)
                w.bar(QRectF(box.left() + pad, box.bottom() - px(8), box.width() - 2 * pad, px(5)),
                      one.bar, one.colour.isValid() ? one.colour : t.good, t.edge);
            if (!one.text.isEmpty())
                w.data(QRectF(from, box.top(), box.right() - pad - from,
                              one.bar >= 0 ? row - px(7) : row),
                       one.text, letteringOf(one, box.right() - pad - from),
                       one.colour.isValid() ? one.colour : t.text, column.align);
        }
    }
    if (const QString why = whyEmpty(); all == 0 && !why.isEmpty()) {
        Item& item = w.text(QRectF(px(20), head() + px(20), width() - px(40), px(80)), why,
                            lettering(16), t.dim, Qt::AlignHCenter | Qt::AlignTop);
        item.wraps = true;
    }
    if (focused) w.frame(QRectF(0, 0, width(), height()), t.accent, px(4), px(2));
    if (all > visibleRows()) {  // where in the list
        const double room = height() - head(),
                     part = std::max<double>(px(24), room * visibleRows() / all);
        w.fill(
            QRectF(width() - px(9),
                   head() + (room - part) * first / std::max(1, all - visibleRows()), px(6), part),
            t.edge, px(3));
    }
}

int Table::rowAt(const QPointF& point) const {
    if (point.y() < head() || !rect().contains(point.toPoint())) return -1;
    const int row = static_cast<int>(std::lround(first_)) +
                    static_cast<int>((point.y() - head()) / px(rowUnits));
    return row < count() ? row : -1;
}

void Table::mousePressEvent(QMouseEvent* event) {
    pressed_ = true;
    dragged_ = false;
    down_ = event->position();
    downFirst_ = first_;
}

void Table::mouseMoveEvent(QMouseEvent* event) {
    if (!pressed_) return;
    const double way = down_.y() - event->position().y();
    if (std::abs(way) > px(10)) dragged_ = true;
    if (!dragged_) return;
    scrollTo(std::round(downFirst_ + way / px(rowUnits)));
    refresh();
}

void Table::mouseReleaseEvent(QMouseEvent* event) {
    if (!std::exchange(pressed_, false) || dragged_ || event->position().y() < head()) return;
    const int row = static_cast<int>(std::lround(first_)) +
                    static_cast<int>((event->position().y() - head()) / px(rowUnits));
    if (row >= count()) return;
    int column = -1;
    for (int c = 0; c < static_cast<int>(columns.size()); ++c)
        if (event->position().x() >= left(c) && event->position().x() < left(c + 1)) column = c;
    if (column >= 0 && byCell && !columns[static_cast<std::size_t>(column)].editable) column = -1;
    const bool again = row == row_ && (!byCell || column == column_);
    choose(row, byCell ? column : -1);
    if (again && onActivated) onActivated();
}

void Table::wheelEvent(QWheelEvent* event) {
    scrollTo(first_ - std::round(event->angleDelta().y() / 40.0));
    refresh();
}

}  // namespace polyturn::hmi
