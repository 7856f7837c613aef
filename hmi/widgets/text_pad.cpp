#include "hmi/widgets/text_pad.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "hmi/text/tongues.hpp"

namespace polyturn::hmi {
namespace {

constexpr std::array<const char*, 4> kRows{"1234567890-=/", "qwertyuiop+*#", "asdfghjkl.,()", "zxcvbnm_:;[]<"};
constexpr int kSpace = 1001, kBack = 1002, kEnter = 1003;
// With shift these keys give other signs: MSG("..."), $AA_IM, IF R1 >= 5 are written by touch too.
constexpr std::string_view kUnshifted = "1234567890-=/<#", kShifted = "!\"@$%^&'{}~|?>\\";
static_assert(kUnshifted.size() == kShifted.size());
QChar otherOf(QChar key) {
    const auto at = kUnshifted.find(key.toLatin1());
    return at == std::string_view::npos ? QChar() : QChar(kShifted[at]);
}

}  // namespace

int TextPad::hitOf(QChar key) const {
    for (const char* row : kRows)
        for (const char* c = row; *c; ++c)
            if (*c == key.toLower().toLatin1()) return *c;
    return -1;
}

QChar TextPad::shifted(QChar key) { return otherOf(key).isNull() ? key.toUpper() : otherOf(key); }

void TextPad::touched(int number) {
    switch (number) {
        case kShift: shift_ = !shift_, refresh(); return;
        case kBack: if (onBackspace) onBackspace(); return;
        case kEnter: if (onEnter) onEnter(); return;
        case kSpace: if (onText) onText(" "); return;
        default: break;
    }
    const QChar key = QChar(static_cast<char16_t>(number));
    if (onText) onText(shift_ ? shifted(key) : capitals ? key.toUpper() : key);
    if (shift_) shift_ = false, refresh();
}

void TextPad::compose(Writer& w) {
    const Theme& t = theme();
    const double gap = px(5), tall = (height() - gap * 6) / 5.0;
    w.fill(QRectF(0, 0, width(), height()), t.window);
    w.fill(QRectF(0, 0, width(), height()), t.card, px(8));
    const auto key = [&](const QRectF& box, const QString& text, int hit, bool bright, QChar beside = {}) {
        w.fill(box, bright ? t.mark : t.raised, px(6));
        w.frame(box, bright ? t.accent : t.edge, px(6), 1);
        if (beside.isNull()) {
            w.text(box, text, lettering(17, true), t.text, Qt::AlignCenter);
        } else {
            w.text(QRectF(box.left(), box.top(), box.width() * 0.66, box.height()), text, lettering(17, true), t.text, Qt::AlignCenter);
            w.text(QRectF(box.left() + box.width() * 0.66, box.top() + px(2), box.width() * 0.34, box.height() * 0.5), beside, lettering(12), t.dim, Qt::AlignCenter);
        }
        w.hit(box, hit);
    };
    const double each = (width() - gap * 14) / 13.0;
    for (std::size_t r = 0; r < kRows.size(); ++r)
        for (int c = 0; kRows[r][c]; ++c) {
            const QChar one = QChar(kRows[r][c]);
            key(QRectF(gap + c * (each + gap), gap + static_cast<double>(r) * (tall + gap), each, tall), shift_ ? shifted(one) : capitals ? one.toUpper() : one, one.unicode(), false, otherOf(one).isNull() ? QChar() : shift_ ? one : otherOf(one));
        }
    const double y = gap + 4 * (tall + gap), unit = (width() - gap * 5) / 10.0;
    key(QRectF(gap, y, unit * 1.5, tall), QString::fromUtf8("⇧"), kShift, shift_);
    key(QRectF(2 * gap + unit * 1.5, y, unit * 4.5, tall), QString::fromUtf8("␣"), kSpace, false);
    key(QRectF(3 * gap + unit * 6, y, unit * 1.5, tall), QString::fromUtf8("⌫"), kBack, false);
    key(QRectF(4 * gap + unit * 7.5, y, unit * 2.5, tall), enterText.isEmpty() ? word("Enter") : enterText, kEnter, true);
}

}  // namespace polyturn::hmi
