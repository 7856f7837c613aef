#include "hmi/widgets/soft_keys.hpp"

#include <QFontMetricsF>
#include <algorithm>

#include "hmi/widgets/portrait.hpp"
#include "hmi/widgets/set_words.hpp"

namespace polyturn::hmi {

SoftKeyBar::SoftKeyBar(QWidget* parent) : Sheet(parent) {
    forget_.setSingleShot(true);
    forget_.setInterval(4'000);
    QObject::connect(&forget_, &QTimer::timeout, this, [this] {
        asked_ = -1;
        refresh();
    });
}

void SoftKeyBar::show(std::vector<SoftKey> keys) {
    keys.resize(kKeys);
    // another key at its place (another channel, another screen), or the same one for something
    // else, has not been asked for
    if (asked_ >= 0) {
        const SoftKey &before = keys_[static_cast<std::size_t>(asked_)],
                      &now = keys[static_cast<std::size_t>(asked_)];
        if (!now.enabled || now.text != before.text || now.confirm != before.confirm ||
            now.subject != before.subject)
            asked_ = -1;
    }
    keys_ = std::move(keys);
    refresh();
}

void SoftKeyBar::press(int number) {
    if (number < 0 || number >= static_cast<int>(keys_.size()) ||
        (resting_.isValid() && resting_.elapsed() < restMs_))
        return;
    // what it does may show other keys
    const SoftKey key = keys_[static_cast<std::size_t>(number)];
    if (key.text.isEmpty() || !key.enabled) return;
    if (!key.confirm.isEmpty() && asked_ != number) {
        asked_ = number;
        askedSince_.start();
        forget_.start();
        refresh();
        return;
    }
    // a double tap has not read the question
    if (asked_ == number && !key.confirm.isEmpty() && askedSince_.elapsed() < kReadMs) return;
    asked_ = -1;
    down_ = key.release ? number : -1;
    if (key.act) key.act();
    refresh();
}

int SoftKeyBar::waits() const {
    return asked_ < 0 ? 0 : std::max(0, kReadMs - static_cast<int>(askedSince_.elapsed()));
}

void SoftKeyBar::letGo(int number) {
    if (down_ != number || number < 0) return;
    down_ = -1;
    if (const auto release = keys_[static_cast<std::size_t>(number)].release) release();
    refresh();
}

QRectF SoftKeyBar::place(int key, const QSizeF& bar, bool upright) {
    const int columns = upright ? kKeys / 2 : kKeys, rows = kKeys / columns;
    const double gap = px(5), each = (bar.width() - gap * (columns + 1)) / columns,
                 high = (bar.height() - gap * (rows + 1)) / rows;
    return {gap + key % columns * (each + gap), gap + key / columns * (high + gap), each, high};
}

void SoftKeyBar::compose(Writer& w) {
    const Theme& t = theme();
    w.fill(QRectF(0, 0, width(), height()), t.bar);
    for (int i = 0; i < kKeys && i < static_cast<int>(keys_.size()); ++i) {
        const SoftKey& key = keys_[static_cast<std::size_t>(i)];
        const QRectF box = place(i, QSizeF(size()), upright(*this));
        if (key.text.isEmpty()) {
            w.frame(box, t.raised, px(7), 1);
            continue;
        }
        const bool asked = asked_ == i;
        const QColor face = asked ? t.warn : down_ == i ? t.accent : key.on ? t.mark : t.card;
        const QColor ink = !key.enabled ? t.faint
                           : asked      ? (t.dark ? QColor("#201400") : QColor("#ffffff"))
                           : down_ == i ? t.onAccent
                                        : t.text;
        w.fill(box, face, px(7));
        w.frame(box, key.on ? t.accent : asked ? t.warn : t.edge, px(7), key.on ? px(2) : 1);
        if (key.on && !asked)
            w.fill(QRectF(box.left() + px(8), box.bottom() - px(6), box.width() - px(16), px(3)),
                   t.accent, px(1.5));
        // a question has it in the place of the sign
        const bool plain = key.confirm.isEmpty(), named = !key.object.isEmpty() && (asked || plain);
        // The words go below the sign. A question that is longer than that has the whole key: what
        // is asked goes before what the key is called.
        const QString& words = asked ? key.confirm : key.text;
        QRectF room(box.left() + px(7), box.top() + px(19), box.width() - px(13),
                    box.height() - px(24));
        QFont font = lettering(14.5, false, Face::Condensed);
        bool whole = false;
        if (!wordsFit(words, font, room.size())) {
            whole = asked && !named;
            room = box.adjusted(px(4), px(whole ? 3 : 18), -px(4), -px(2));
            font = letteringThatFits(words, room.size(), 14.5, 10.5, Face::Condensed);
        }
        if (!whole)
            w.text(QRectF(box.right() - px(30), box.top() + px(3), px(25), px(15)),
                   QString("F%1").arg(i + 1), lettering(11),
                   !key.enabled ? t.faint
                   : asked      ? ink
                                : t.dim,
                   Qt::AlignRight | Qt::AlignVCenter);
        if (named) {
            const double from = box.left() + px(plain ? 26 : 7);
            const QRectF line(from, box.top() + px(3), box.right() - px(30) - from, px(15));
            const QFont small = lettering(12, true, Face::Condensed);
            w.data(
                line,
                QFontMetricsF(small).elidedText(key.object, Qt::ElideMiddle, line.width() - px(2)),
                small, ink);
        }
        if (key.sign != Sign::None && !whole && (!asked || key.object.isEmpty())) {
            w.sign(QRectF(box.left() + px(6), box.top() + px(5), px(16), px(16)), key.sign,
                   !key.enabled            ? t.faint
                   : asked                 ? ink
                   : key.danger            ? t.bad
                   : key.sign == Sign::Run ? t.good
                                           : t.accent);
        }
        w.text(room, words, font, ink, Qt::AlignHCenter | Qt::AlignVCenter).wraps = true;
        w.hit(box, i);
    }
}

}  // namespace polyturn::hmi
