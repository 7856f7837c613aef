#include "hmi/widgets/text_pad.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "hmi/text/display_languages.hpp"

namespace polyturn::hmi {
namespace {

using Rows = std::array<QString, 4>;
const Rows& latinRows() {
    static const Rows rows{"1234567890-=/", "qwertyuiop+*#", "asdfghjkl.,()", "zxcvbnm_:;[]<"};
    return rows;
}
// As they stand on keyboards there, where thirteen in a row allow that; nothing: the Latin ones are
// all.
const Rows* nationalRows() {
    static const Rows russian{QString("1234567890-=/"), QString::fromUtf8("йцукенгшщзхъё"),
                              QString::fromUtf8("фывапролджэ.,"),
                              QString::fromUtf8("ячсмитьбю()_:")};
    static const Rows czech{QString::fromUtf8("1234567890ďťň"), QString::fromUtf8("qwertzuiopúěó"),
                            QString::fromUtf8("asdfghjklůáéí"), QString::fromUtf8("yxcvbnmščřžý.")};
    static const Rows hungarian{QString("1234567890-=/"), QString::fromUtf8("qwertzuiopőú."),
                                QString::fromUtf8("asdfghjkléáűó"),
                                QString::fromUtf8("íyxcvbnmöü,_:")};
    switch (spoken()) {
        case DisplayLanguage::Russian:
            return &russian;
        case DisplayLanguage::Czech:
            return &czech;
        case DisplayLanguage::Hungarian:
            return &hungarian;
        case DisplayLanguage::English:
            break;
    }
    return nullptr;
}
QString nationalName() {
    return QString::fromUtf8(spoken() == DisplayLanguage::Russian ? "РУС"
                             : spoken() == DisplayLanguage::Czech ? "ČES"
                                                                  : "MAG");
}
constexpr int kSpace = 1001, kBack = 1002, kEnter = 1003;
// With shift these keys give other signs: MSG("..."), $AA_IM, IF R1 >= 5 are written by touch too.
constexpr std::string_view kUnshifted = "1234567890-=/<#", kShifted = "!\"@$%^&'{}~|?>\\";
static_assert(kUnshifted.size() == kShifted.size());
QChar otherOf(QChar key) {
    const auto at = kUnshifted.find(key.toLatin1());
    return at == std::string_view::npos ? QChar() : QChar(kShifted[at]);
}

}  // namespace

const std::array<QString, 4>& TextPad::rows() const {
    const Rows* own = national && !latin ? nationalRows() : nullptr;
    return own ? *own : latinRows();
}

int TextPad::hitOf(QChar key) const {
    for (const QString& row : rows())
        if (row.contains(key.toLower())) return key.toLower().unicode();
    return -1;
}

QChar TextPad::shifted(QChar key) { return otherOf(key).isNull() ? key.toUpper() : otherOf(key); }

void TextPad::touched(int number) {
    switch (number) {
        case kShift:
            shift_ = !shift_;
            refresh();
            return;
        case kLetters:
            latin = !latin;
            refresh();
            return;
        case kLeft:
        case kRight:
            if (onMove) onMove(number == kLeft ? -1 : 1);
            return;
        case kBack:
            if (onBackspace) onBackspace();
            return;
        case kEnter:
            if (onEnter) onEnter();
            return;
        case kSpace:
            if (onText) onText(" ");
            return;
        default:
            break;
    }
    const QChar key = QChar(static_cast<char16_t>(number));
    if (onText) onText(shift_ ? shifted(key) : capitals ? key.toUpper() : key);
    if (shift_) {
        shift_ = false;
        refresh();
    }
}

void TextPad::compose(Writer& w) {
    const Theme& t = theme();
    const double gap = px(5), tall = (height() - gap * 6) / 5.0;
    w.fill(QRectF(0, 0, width(), height()), t.window);
    w.fill(QRectF(0, 0, width(), height()), t.card, px(8));
    const auto key = [&](const QRectF& box, const QString& text, int hit, bool bright,
                         QChar beside = {}, bool name = false) {
        w.fill(box, bright ? t.mark : t.raised, px(6));
        w.frame(box, bright ? t.accent : t.edge, px(6), 1);
        if (beside.isNull()) {
            w.text(box, text, lettering(17, true), t.text, Qt::AlignCenter).data = name;
        } else {
            w.text(QRectF(box.left(), box.top(), box.width() * 0.66, box.height()), text,
                   lettering(17, true), t.text, Qt::AlignCenter);
            w.text(QRectF(box.left() + box.width() * 0.66, box.top() + px(2), box.width() * 0.34,
                          box.height() * 0.5),
                   beside, lettering(12), t.dim, Qt::AlignCenter);
        }
        w.hit(box, hit);
    };
    const double each = (width() - gap * 14) / 13.0;
    for (std::size_t r = 0; r < rows().size(); ++r)
        for (int c = 0; c < rows()[r].size(); ++c) {
            const QChar one = rows()[r][c];
            key(QRectF(gap + c * (each + gap), gap + static_cast<double>(r) * (tall + gap), each,
                       tall),
                shift_     ? shifted(one)
                : capitals ? one.toUpper()
                           : one,
                one.unicode(), false,
                otherOf(one).isNull() ? QChar()
                : shift_              ? one
                                      : otherOf(one));
        }
    const double y = gap + 4 * (tall + gap);
    struct Foot {
        QString text;
        int hit;
        double share;
        bool bright;
    };
    std::vector<Foot> foot{{QString::fromUtf8("⇧"), kShift, 1.5, shift_}};
    if (national && nationalRows())
        foot.push_back({latin ? nationalName() : QString("ABC"), kLetters, 1.3, false});
    foot.push_back({QString::fromUtf8("␣"), kSpace, 4.5, false});
    if (onMove) {
        foot.push_back({QString::fromUtf8("←"), kLeft, 1, false});
        foot.push_back({QString::fromUtf8("→"), kRight, 1, false});
    }
    foot.push_back({QString::fromUtf8("⌫"), kBack, 1.5, false});
    foot.push_back({enterText.isEmpty() ? word("Enter") : enterText, kEnter, 2.5, true});
    double shares = 0, x = gap;
    for (const Foot& one : foot) shares += one.share;
    for (const Foot& one : foot) {
        const double wide =
            (width() - gap * static_cast<double>(foot.size() + 1)) * one.share / shares;
        key(QRectF(x, y, wide, tall), one.text, one.hit, one.bright, {}, one.hit == kLetters);
        x += wide + gap;
    }
}

}  // namespace polyturn::hmi
