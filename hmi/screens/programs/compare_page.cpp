#include "hmi/screens/programs/compare_page.hpp"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

namespace polyturn::hmi {
namespace {

constexpr int kLeastLetters = 10;
QFont face() { return lettering(13.5, false, Face::Program); }

}  // namespace

// At a blank where there is one in its second half.
QStringList ComparePage::pieces(const QString& text, int letters) {
    QStringList out;
    qsizetype from = 0;
    while (text.size() - from > letters) {
        const auto blank = text.lastIndexOf(' ', from + letters - 1);
        const auto to = blank > from + letters / 2 ? blank + 1 : from + letters;
        out << text.mid(from, to - from);
        from = to;
    }
    return out << text.mid(from);
}

int ComparePage::letters() const {
    return std::max(kLeastLetters,
                    static_cast<int>(std::floor((view_->width() / 2.0 - px(80)) /
                                                QFontMetricsF(face()).horizontalAdvance('0'))));
}

int ComparePage::rowsOf(std::size_t line) const {
    const PairedLine& one = difference_.lines[line];
    const int letters = this->letters();
    const auto rows = [&](int number, const QStringList& text) {
        return number < 0
                   ? 1
                   : static_cast<int>(
                         text[number].size() <= letters ? 1 : pieces(text[number], letters).size());
    };
    return std::max(rows(one.left, difference_.left), rows(one.right, difference_.right));
}

int ComparePage::lastFirst() const {
    int first = static_cast<int>(difference_.lines.size());
    for (int left = room(); first > 0; --first)
        if ((left -= rowsOf(static_cast<std::size_t>(first - 1))) < 0) break;
    return first;
}

ComparePage::ComparePage(Context& context, QWidget* parent)
    : QWidget(parent), context_(context), view_(new FreeSheet(this)) {
    view_->onCompose = [this](Writer& w) { compose(w); };
}

void ComparePage::compare(const QString& left, const QString& right) {
    left_ = left;
    right_ = right;
    difference_ = {};
    first_ = 0;
    place_ = -1;
    work_.start(
        [left, right](const std::atomic<bool>& stop) { return compareFiles(left, right, stop); });
    refresh();
}

void ComparePage::refresh() {
    if (auto done = work_.take()) {
        difference_ = std::move(*done);
        go(1);
        if (context_.keysChanged) context_.keysChanged();
    }
    view_->refresh();
}

void ComparePage::go(int step) {
    const auto& lines = difference_.lines;
    const int count = static_cast<int>(lines.size());
    const auto begins = [&](int i) {
        return i >= 0 && i < count && !lines[static_cast<std::size_t>(i)].same &&
               (i == 0 || lines[static_cast<std::size_t>(i - 1)].same);
    };
    for (int i = place_ + step; i >= 0 && i < count; i += step)
        if (begins(i)) {
            place_ = i;
            first_ = std::clamp(i - room() / 3, 0, std::max(0, lastFirst()));
            break;
        }
    view_->refresh();
}

void ComparePage::scroll(int by) {
    first_ = std::clamp(first_ + by, 0, std::max(0, lastFirst()));
    view_->refresh();
}

void ComparePage::compose(Writer& w) {
    const Theme& t = theme();
    const double wide = view_->width(), high = view_->height(), half = wide / 2, row = px(22);
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    if (work_.busy()) {
        w.text(QRectF(0, 0, wide, px(44)), word("The programs are being compared ..."),
               lettering(16), t.dim, Qt::AlignCenter);
        return;
    }
    if (!difference_.fault.isEmpty()) {
        w.data(QRectF(px(16), 0, wide - px(32), px(44)),
               word("It cannot be read: %1").arg(difference_.fault), lettering(16), t.bad);
        return;
    }
    const bool same = difference_.places == 0;
    w.sign(QRectF(px(12), px(8), px(20), px(20)), same ? Sign::Good : Sign::Warning,
           same ? t.good : t.warn);
    w.text(QRectF(px(40), 0, wide - px(60), px(36)),
           same                ? word("They are the same")
           : difference_.rough ? word("They are very different")
                               : word("Differences: %1").arg(difference_.places),
           lettering(16, true), t.text);
    w.data(QRectF(px(12), px(36), half - px(24), px(28)), left_, lettering(14), t.accent);
    w.data(QRectF(half + px(12), px(36), half - px(24), px(28)), right_, lettering(14), t.accent);
    w.line(QPointF(half, px(40)), QPointF(half, high - px(6)), t.edge, 1);
    double y = px(68), tall = 0;
    const int letters = this->letters();
    for (std::size_t i = static_cast<std::size_t>(first_);
         i < difference_.lines.size() && y + row < high; ++i, y += tall) {
        const PairedLine& one = difference_.lines[i];
        tall = row * rowsOf(i);
        const auto side = [&](double x, int line, const QStringList& text, bool other) {
            if (!one.same)
                w.fill(QRectF(x + px(4), y, half - px(8), tall), line >= 0 ? t.mark : t.window,
                       px(3));
            if (line < 0) return;
            // A sign too, colour is never the only one: minus is not there, plus is only here, a
            // wave is another text.
            if (!one.same)
                w.text(QRectF(x + px(50), y, px(16), row),
                       other   ? QString::fromUtf8("≠")
                       : x > 0 ? "+"
                               : QString::fromUtf8("−"),
                       lettering(14, true), t.warn, Qt::AlignCenter);
            w.text(QRectF(x + px(4), y, px(42), row), QString::number(line + 1), lettering(12),
                   t.faint, Qt::AlignRight | Qt::AlignVCenter);
            double at = y;
            for (const QString& piece : pieces(text[line], letters)) {
                w.data(QRectF(x + px(70), at, half - px(76), row), piece, face(),
                       one.same ? t.dim : t.text);
                at += row;
            }
        };
        side(0, one.left, difference_.left, one.right >= 0);
        side(half, one.right, difference_.right, one.left >= 0);
    }
}

void ComparePage::addKeys(std::vector<SoftKey>& keys) {
    const bool any = difference_.places > 0;
    keys.push_back({word("Next difference"), [this] { go(1); }, Sign::Down, any});
    keys.push_back({word("Previous difference"), [this] { go(-1); }, Sign::Up, any});
    keys.push_back({word("Page up"), [this] { scroll(-room()); }, Sign::None, first_ > 0});
    keys.push_back(
        {word("Page down"), [this] { scroll(room()); }, Sign::None, first_ < lastFirst()});
}

bool ComparePage::key(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Up:
            scroll(-1);
            return true;
        case Qt::Key_Down:
            scroll(1);
            return true;
        case Qt::Key_PageUp:
            scroll(-room());
            return true;
        case Qt::Key_PageDown:
            scroll(room());
            return true;
        case Qt::Key_Home:
            scroll(-1 << 24);
            return true;
        case Qt::Key_End:
            scroll(1 << 24);
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Right:
            go(1);
            return true;
        case Qt::Key_Left:
            go(-1);
            return true;
        default:
            return false;
    }
}

}  // namespace polyturn::hmi
