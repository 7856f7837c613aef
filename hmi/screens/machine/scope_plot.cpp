#include "hmi/screens/machine/scope_plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "hmi/text/display_languages.hpp"
#include "hmi/widgets/painted.hpp"
#include "hmi/widgets/theme.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kParts = 10;  // of the time

// Ink of 24 columns; a spike is drawn in any of them.
constexpr std::array<std::uint32_t, kScopeTraces> kInk{0xFFFFFF, 0x03FFFF, 0x0FF0FF, 0x1C71C7,
                                                       0x070FFF, 0x000FFF, 0x0C63FF, 0x007007};

// One pixel that a line covers by this part.
void cover(uchar* pixel, QRgb colour, double part) {
    const int share = static_cast<int>(part * 256);
    // as QRgb lies in memory: blue first
    for (int i = 0; i < 3; ++i)
        pixel[i] = static_cast<uchar>(
            pixel[i] + (static_cast<int>(colour >> 8 * i & 0xFF) - pixel[i]) * share / 256);
}

}  // namespace

QColor colourOfTrace(std::size_t trace) {
    static const char* kDark[] = {"#4ea6ff", "#f5b83d", "#42c883", "#ff635c",
                                  "#b896ff", "#4fd8d8", "#ff9ed1", "#d5dde5"};
    static const char* kLight[] = {"#0a63bd", "#a06200", "#127c3e", "#c42723",
                                   "#6d38b5", "#007a7a", "#b0307a", "#404a54"};
    return QColor(theme().dark ? kDark[trace] : kLight[trace]);
}

bool traceHasInk(std::size_t trace, std::int64_t column) {
    return kInk[trace] >> static_cast<unsigned>(column % 24) & 1u;
}

QString ScopePlot::valueText(double value, double division) {
    const int digits =
        division > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(division) - 1e-9)), 0, 6)
                     : 3;
    const QString text = QString::number(value, 'f', digits);
    // no minus before nothing
    return text.toDouble() == 0 ? QString::number(0.0, 'f', digits) : text;
}

QRectF ScopePlot::box() const {
    return QRectF(QPointF(px(70), px(28)),
                  QPointF(size_.width() - px(14), size_.height() - px(28)));
}

double ScopePlot::y(std::size_t trace, double value) const {
    return box().bottom() - scales_[trace].part(value) * box().height();
}

void ScopePlot::take(const ScopeRecord& record, const ScopeLook& look, QSize size) {
    if (size != size_) {
        size_ = size;
        behindKey_.clear();
    }
    look_ = look;
    trigger_ = record.trigger;
    triggeredAt_ = record.triggeredAt();
    stands_ = record.mode() == ScopeRecord::Mode::Stopped;
    armed_ = record.mode() != ScopeRecord::Mode::Runs && look.on[trigger_.trace];
    end_ = record.samples().empty() ? 0 : record.samples().back().tick;
    empty_ = record.samples().empty() ||
             std::none_of(look.on.begin(), look.on.end(), [](bool on) { return on; });
    const double wide = std::max(2.0, std::floor(box().width()));
    columns_.take(record, look.seconds / look.tick_s / wide, static_cast<std::size_t>(wide));
    for (std::size_t trace = 0; trace < kScopeTraces; ++trace)
        scales_[trace] = look.on[trace] ? scopeScale(columns_.whole(trace), scales_[trace], trace)
                                        : ScopeScale{};
}

void ScopePlot::paint(QPainter& p, const QRect& room) {
    if (empty_) {
        p.setPen(Qt::NoPen);
        p.setBrush(theme().card);
        p.drawRoundedRect(room, px(8), px(8));
        p.setPen(theme().dim);
        p.setFont(lettering(16));
        paintWords(p, QRectF(room).adjusted(px(20), 0, -px(20), 0),
                   Qt::AlignCenter | Qt::TextWordWrap,
                   word("No trace is chosen: Enter on a line, or touch it twice"));
        return;
    }
    paintBehind();
    std::memcpy(picture_.bits(), behind_.constBits(),
                static_cast<std::size_t>(behind_.sizeInBytes()));
    for (std::size_t trace = 0; trace < kScopeTraces; ++trace)
        if (look_.on[trace]) draw(trace);
    {
        QPainter over(&picture_);
        over.setRenderHint(QPainter::Antialiasing);
        if (armed_) paintTrigger(over);
        paintNumbers(over);
    }
    p.drawImage(room.topLeft(), picture_);
}

void ScopePlot::paintBehind() {
    const Theme& t = theme();
    const ScopeScale& scale = scales_[look_.chosen];
    // where the trigger has ended the record, the time counts from it
    const double end =
        stands_ && triggeredAt_ ? static_cast<double>(end_ - triggeredAt_) * look_.tick_s : 0.0;
    const QString head = QString("%1  %2  %3")
                             .arg(look_.chosen + 1)
                             .arg(look_.title, unitWord(look_.unit.toStdString()));
    const QString key = QString("%1 %2 %3 %4 %5 %6")
                            .arg(scale.bottom)
                            .arg(scale.division)
                            .arg(look_.seconds)
                            .arg(end)
                            .arg(t.dark)
                            .arg(panelScale()) +
                        head;
    if (key == behindKey_) return;
    behindKey_ = key;
    behind_ = QImage(size_, QImage::Format_RGB32);
    behind_.fill(t.window);
    const QRectF room = box();
    {
        QPainter p(&behind_);
        p.setRenderHint(QPainter::Antialiasing);
        p.setPen(Qt::NoPen);
        p.setBrush(t.card);
        p.drawRoundedRect(QRectF(QPointF(0, 0), QSizeF(size_)), px(8), px(8));
        p.setPen(QPen(t.edge, 1, Qt::DotLine));
        for (int i = 0; i <= kParts; ++i)
            p.drawLine(QPointF(room.left() + room.width() * i / kParts, room.top()),
                       QPointF(room.left() + room.width() * i / kParts, room.bottom()));
        for (int i = 0; i <= ScopeScale::kDivisions; ++i)
            p.drawLine(
                QPointF(room.left(), room.top() + room.height() * i / ScopeScale::kDivisions),
                QPointF(room.right(), room.top() + room.height() * i / ScopeScale::kDivisions));
        p.setFont(lettering(12, false, Face::Condensed));
        p.setPen(t.dim);
        for (int i = 0; i <= kParts; i += 2) {
            const double seconds = look_.seconds * (static_cast<double>(i) / kParts - 1) + end;
            const QString text = valueText(seconds, look_.seconds / 5) +
                                 (i == kParts ? " " + unitWord("s") : QString());
            const double middle = room.left() + room.width() * i / kParts;
            paintWords(p,
                       QRectF(i == kParts ? room.right() - px(70) : middle - px(40),
                              room.bottom() + px(5), i == kParts ? px(74) : px(80), px(18)),
                       i == kParts ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignCenter, text);
        }
        if (look_.on[look_.chosen] && scale.division > 0) {
            p.setPen(colourOfTrace(look_.chosen));
            for (int i = 0; i <= ScopeScale::kDivisions; ++i)
                paintWords(
                    p,
                    QRectF(px(4),
                           room.bottom() - room.height() * i / ScopeScale::kDivisions - px(9),
                           room.left() - px(10), px(18)),
                    Qt::AlignRight | Qt::AlignVCenter,
                    valueText(scale.bottom + i * scale.division, scale.division));
            p.setFont(lettering(13, true));
            paintWords(p, QRectF(room.left(), px(2), room.width(), px(20)),
                       Qt::AlignLeft | Qt::AlignVCenter, head);
        }
    }
    picture_ = QImage(size_, QImage::Format_RGB32);
}

void ScopePlot::draw(std::size_t trace) {
    const QRectF room = box();
    const QRgb colour = colourOfTrace(trace).rgb();
    const int wide = static_cast<int>(room.width()), left = static_cast<int>(room.left()),
              lowest = static_cast<int>(room.top()), highest = static_cast<int>(room.bottom());
    // a line is 1.6 units thick
    const double half = std::max(0.6, px(16) / 20.0), flat = 4 * half;
    const int dash = std::max(1, px(1));
    uchar* const bits = picture_.bits();
    const auto stride = picture_.bytesPerLine();
    const ScopeScale& scale = scales_[trace];
    // y() without the many calls
    const double each = room.height() / (ScopeScale::kDivisions * scale.division),
                 zero = room.bottom() + scale.bottom * each;
    std::int64_t column = columns_.newest() - wide + 1;
    for (int x = 0; x < wide; ++x, ++column) {
        const ScopeSpan span = columns_.at(trace, column);
        if (!span.any()) continue;
        const double high = zero - span.most * each - half, low = zero - span.least * each + half;
        if (low - high < flat && !traceHasInk(trace, column / dash)) continue;
        const double from = std::clamp<double>(high, lowest, highest),
                     to = std::clamp<double>(low, lowest, highest);
        if (to <= from) continue;
        uchar* pixel = bits + stride * static_cast<int>(from) + 4 * (left + x);
        for (int row = static_cast<int>(from); row < to; ++row, pixel += stride) {
            if (const double part = std::min<double>(to, row + 1) - std::max<double>(from, row);
                part < 1)
                cover(pixel, colour, part);
            else
                std::memcpy(pixel, &colour, sizeof colour);
        }
    }
}

// Each at a place of its own along the time, so that they do not cover each other where traces
// meet.
void ScopePlot::paintNumbers(QPainter& p) {
    const QRectF room = box();
    const int wide = static_cast<int>(room.width());
    p.setFont(lettering(12, true));
    for (std::size_t trace = 0; trace < kScopeTraces; ++trace) {
        if (!look_.on[trace]) continue;
        int x = wide * (static_cast<int>(2 * trace) + 1) / static_cast<int>(2 * kScopeTraces);
        ScopeSpan span = columns_.at(trace, columns_.newest() - wide + 1 + x);
        // the record is shorter than that
        if (!span.any()) {
            x = wide - px(12) - static_cast<int>(trace) * px(16);
            span = columns_.at(trace, columns_.newest() - wide + 1 + x);
        }
        if (!span.any()) {
            span = columns_.at(trace, columns_.newest());
            x = wide - px(10);
        }
        if (!span.any()) continue;
        const double middle = std::clamp(y(trace, (span.least + span.most) / 2), room.top() + px(8),
                                         room.bottom() - px(8));
        const QRectF badge(room.left() + x - px(8), middle - px(8), px(16), px(16));
        p.setPen(Qt::NoPen);
        p.setBrush(colourOfTrace(trace));
        p.drawRoundedRect(badge, px(4), px(4));
        p.setPen(theme().card);
        paintWords(p, badge, Qt::AlignCenter, QString::number(trace + 1));
    }
}

void ScopePlot::paintTrigger(QPainter& p) {
    const QRectF room = box();
    p.setPen(QPen(colourOfTrace(trigger_.trace), 1, Qt::DashLine));
    const double at = std::clamp(y(trigger_.trace, trigger_.level), room.top(), room.bottom());
    p.drawLine(QPointF(room.left(), at), QPointF(room.right(), at));
    if (!triggeredAt_) return;
    const double ticks = look_.seconds / look_.tick_s / std::floor(room.width());
    const double x = std::floor(room.width()) - 1 -
                     (static_cast<double>(columns_.newest()) -
                      std::floor(static_cast<double>(triggeredAt_) / ticks));
    if (x >= 0)
        p.drawLine(QPointF(room.left() + x, room.top()), QPointF(room.left() + x, room.bottom()));
}

}  // namespace polyturn::hmi
