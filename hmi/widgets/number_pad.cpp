#include "hmi/widgets/number_pad.hpp"

#include <QKeyEvent>
#include <array>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/text/display_languages.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kColumns = 5;
constexpr std::array<const char*, 20> kKeys{"7", "8", "9", "/", "<", "4", "5", "6", "*", "C",
                                            "1", "2", "3", "-", "(", "0", ".", "",  "+", ")"};
constexpr int kInput = 100, kAdd = 101;

// what is added to
double counted(const NumberPad::Field& field) {
    return std::isnan(field.present) ? 0.0 : field.present / field.size;
}
QString padNumber(const NumberPad::Field& field, double held) {
    return field.bits && held >= 0 && held <= 255 ? bitDigits(static_cast<unsigned>(held))
                                                  : lengthText(held / field.size, field.decimals);
}
QString presentText(const NumberPad::Field& field) {
    return std::isnan(field.present) ? QString::fromUtf8("–") : padNumber(field, field.present);
}

// The control reads 00000011 of a parameter of bits so on every other way: as typed here it must
// not become eleven.
std::optional<double> patternOf(const QString& text) {
    bool read = false;
    const unsigned pattern = text.size() == 8 ? text.toUInt(&read, 2) : 0;
    return read && text[0].isDigit() ? std::optional<double>(pattern) : std::nullopt;
}

}  // namespace

QString bitDigits(unsigned bits) { return QString("%1").arg(bits & 0xffu, 8, 2, QChar('0')); }

std::optional<Entry> NumberPad::entry() const {
    if (const auto now = field ? field() : std::nullopt; now && now->bits)
        if (const auto pattern = patternOf(text_)) return Entry{false, *pattern};
    return calculate(text_.toStdString());
}

std::optional<double> NumberPad::result(const Field& now, bool added) const {
    const auto typed = entry();
    if (!typed) return std::nullopt;
    const double value = !now.adds ? typed->value
                         : added   ? counted(now) + typed->value
                                   : typed->over(counted(now));
    // rounded in silence it would be another number than the typed one
    return now.decimals == 0 && value != std::floor(value) ? std::nullopt
                                                           : std::optional(value * now.size);
}

std::optional<double> NumberPad::held() const {
    const auto now = field ? field() : std::nullopt;
    const auto typed = entry();
    return typed ? std::optional(typed->value * (now ? now->size : 1.0)) : std::nullopt;
}

bool NumberPad::ready() const {
    const auto now = field ? field() : std::nullopt;
    return now && result(*now, false);
}

void NumberPad::clear() {
    text_.clear();
    refresh();
}

void NumberPad::type(const QString& text) {
    if (text_.size() + text.size() <= 40) text_ += text;
    refresh();
}

void NumberPad::enter(bool added) {
    const auto now = field ? field() : std::nullopt;
    const auto value = now ? result(*now, added) : std::nullopt;
    if (!value || !onInput) return;
    const auto typed = entry();
    const bool adds = onAdded && now->adds && typed && (added || typed->added);
    text_.clear();
    if (adds)
        onAdded(typed->value * now->size);
    else
        onInput(*value);
    refresh();
}

bool NumberPad::key(QKeyEvent* event) {
    if (event->key() == Qt::Key_Backspace) {
        text_.chop(1);
        refresh();
        return true;
    }
    if (event->key() == Qt::Key_Escape && !text_.isEmpty()) {
        clear();
        return true;
    }
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && !text_.isEmpty()) {
        enter(false);
        return true;
    }
    const QString text = event->text();
    if (text.size() != 1 || !QString("0123456789.,+-*/()").contains(text[0])) return false;
    type(text);
    return true;
}

void NumberPad::touched(int number) {
    if (number == kInput || number == kAdd) return enter(number == kAdd);
    const QString key = kKeys[static_cast<std::size_t>(number)];
    if (key == "C")
        clear();
    else if (key == "<") {
        text_.chop(1);
        refresh();
    } else
        type(key);
}

void NumberPad::compose(Writer& w) {
    const Theme& t = theme();
    const double wide = width(), high = height(), gap = px(6);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const auto now = field ? field() : std::nullopt;
    w.data(QRectF(px(12), px(6), wide - px(24), px(24)), now ? now->title : word("Choose a field"),
           lettering(15, true), now ? t.text : t.dim);
    // typed, and what it comes to
    const QRectF line(px(12), px(34), wide - px(24), px(44));
    w.fill(line, t.entry(), px(6));
    w.frame(line, text_.isEmpty() ? t.entryEdge() : t.accent, px(6), text_.isEmpty() ? 1 : px(2));
    const auto typed = entry();
    w.data(line.adjusted(px(10), 0, -px(10), 0), text_ + QString::fromUtf8("▏"),
           lettering(21, true), t.text, Qt::AlignRight | Qt::AlignVCenter);
    const auto becomes = now ? result(*now, false) : std::nullopt;
    const QRectF below(px(12), px(80), wide - px(24), px(24));
    if (now && text_.isEmpty()) {
        w.text(below, QString("%1 %2").arg(presentText(*now), now->unit), lettering(15), t.dim,
               Qt::AlignRight | Qt::AlignVCenter);
    } else if (becomes) {
        w.text(below,
               QString::fromUtf8("%1 → %2 %3")
                   .arg(presentText(*now), padNumber(*now, *becomes), now->unit),
               lettering(15, true), t.good, Qt::AlignRight | Qt::AlignVCenter);
    } else if (now && typed) {
        w.text(below, word("wanted: a whole number"), lettering(15), t.warn,
               Qt::AlignRight | Qt::AlignVCenter);
    } else if (!text_.isEmpty()) {
        w.text(below, word("not a number yet"), lettering(15), t.warn,
               Qt::AlignRight | Qt::AlignVCenter);
    }
    const double top = px(108), foot = px(54);
    const int rows = static_cast<int>(kKeys.size()) / kColumns;
    const double each = (wide - px(24) - gap * (kColumns - 1)) / kColumns,
                 tall = (high - top - foot - px(10) - gap * rows) / rows;
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
        const QString key = kKeys[i];
        if (key.isEmpty()) continue;
        const auto column = static_cast<double>(i % kColumns),
                   row = static_cast<double>(i / kColumns);
        const QRectF box(px(12) + column * (each + gap), top + row * (tall + gap), each, tall);
        w.fill(box, t.raised, px(6));
        w.frame(box, t.edge, px(6), 1);
        w.text(box,
               key == "<"   ? QString::fromUtf8("⌫")
               : key == "*" ? QString::fromUtf8("×")
               : key == "/" ? QString::fromUtf8("÷")
               : key == "-" ? QString::fromUtf8("−")
                            : key,
               lettering(20, true), key[0].isDigit() || key == "." ? t.text : t.accent,
               Qt::AlignCenter);
        w.hit(box, static_cast<int>(i));
    }
    const bool ready = becomes.has_value();
    const bool adds = !now || now->adds;
    const double half = adds ? (wide - px(24) - gap) / 2 : wide - px(24);
    for (int i = 0; i < (adds ? 2 : 1); ++i) {
        const QRectF box(px(12) + i * (half + gap), high - foot - px(6), half, foot);
        w.fill(box, ready ? (i ? t.mark : t.accent) : t.raised, px(6));
        w.frame(box, ready ? t.accent : t.edge, px(6), 1);
        w.text(box, i ? word("+ Input") : word("Input"), lettering(17, true),
               ready ? (i ? t.text : t.onAccent) : t.faint, Qt::AlignCenter);
        w.hit(box, i ? kAdd : kInput);
    }
}

}  // namespace polyturn::hmi
