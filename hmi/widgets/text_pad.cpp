#include "hmi/widgets/text_pad.hpp"

#include <algorithm>
#include <array>

#include "hmi/text/tongues.hpp"

namespace polyturn::hmi {
namespace {

constexpr std::array<const char*, 4> kRows{"1234567890-=/", "qwertyuiop+*#", "asdfghjkl.,()", "zxcvbnm_:;[]<"};
constexpr int kShift = 1000, kSpace = 1001, kBack = 1002, kEnter = 1003;

}  // namespace

int TextPad::hitOf(QChar key) const {
    for (const char* row : kRows)
        for (const char* c = row; *c; ++c)
            if (*c == key.toLower().toLatin1()) return *c;
    return -1;
}

void TextPad::touched(int number) {
    switch (number) {
        case kShift: shift_ = !shift_, refresh(); return;
        case kBack: if (onBackspace) onBackspace(); return;
        case kEnter: if (onEnter) onEnter(); return;
        case kSpace: if (onText) onText(" "); return;
        default: break;
    }
    const QChar key = QChar(static_cast<char16_t>(number));
    if (onText) onText(shift_ || capitals ? key.toUpper() : key);
    if (shift_) shift_ = false, refresh();
}

void TextPad::compose(Writer& w) {
    const Theme& t = theme();
    const double gap = px(5), tall = (height() - gap * 6) / 5.0;
    w.fill(QRectF(0, 0, width(), height()), t.window);
    w.fill(QRectF(0, 0, width(), height()), t.card, px(8));
    const auto key = [&](const QRectF& box, const QString& text, int hit, bool bright) {
        w.fill(box, bright ? t.mark : t.raised, px(6));
        w.frame(box, bright ? t.accent : t.edge, px(6), 1);
        w.text(box, text, lettering(17, true), t.text, Qt::AlignCenter);
        w.hit(box, hit);
    };
    const double each = (width() - gap * 14) / 13.0;
    for (std::size_t r = 0; r < kRows.size(); ++r)
        for (int c = 0; kRows[r][c]; ++c) {
            const QChar one = QChar(kRows[r][c]);
            key(QRectF(gap + c * (each + gap), gap + static_cast<double>(r) * (tall + gap), each, tall), shift_ || capitals ? one.toUpper() : one, one.unicode(), false);
        }
    const double y = gap + 4 * (tall + gap), unit = (width() - gap * 5) / 10.0;
    key(QRectF(gap, y, unit * 1.5, tall), QString::fromUtf8("⇧"), kShift, shift_ || capitals);
    key(QRectF(2 * gap + unit * 1.5, y, unit * 4.5, tall), QString::fromUtf8("␣"), kSpace, false);
    key(QRectF(3 * gap + unit * 6, y, unit * 1.5, tall), QString::fromUtf8("⌫"), kBack, false);
    key(QRectF(4 * gap + unit * 7.5, y, unit * 2.5, tall), enterText.isEmpty() ? word("Enter") : enterText, kEnter, true);
}

}  // namespace polyturn::hmi
