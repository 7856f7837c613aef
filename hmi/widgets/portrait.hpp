// Portrait panels: pieces that lie side by side elsewhere are stacked there. Asked
// of the window, so that all of it agrees.
#pragma once
#include <QRect>
#include <QWidget>

namespace polyturn::hmi {

inline bool upright(const QWidget& of) { return of.window()->height() > of.window()->width(); }

// A part with the main thing, and what belongs to it: `wide` at the right, on a portrait panel
// `high` at the foot.
struct Parted {
    QRect main, side;
};
inline Parted parted(const QWidget& of, const QRect& all, int wide, int high, int gap) {
    if (!upright(of))
        return {all.adjusted(0, 0, -wide - gap, 0),
                QRect(all.right() + 1 - wide, all.top(), wide, all.height())};
    return {all.adjusted(0, 0, 0, -high - gap),
            QRect(all.left(), all.bottom() + 1 - high, all.width(), high)};
}
// That side with the number pad in it: the pad at its foot, on a portrait panel at its right.
struct Padded {
    QRect rest, pad;
};
inline Padded padded(const QWidget& of, const QRect& side, int padWide, int padHigh, int gap) {
    if (!upright(of))
        return {side.adjusted(0, 0, 0, -padHigh - gap),
                QRect(side.left(), side.bottom() + 1 - padHigh, side.width(), padHigh)};
    return {side.adjusted(0, 0, -padWide - gap, 0),
            QRect(side.right() + 1 - padWide, side.top(), padWide, side.height())};
}

}  // namespace polyturn::hmi
