#include "hmi/screens/machine/stops_page.hpp"

#include <algorithm>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/text/dates.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/pictures/time_shape.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kPeriods[] = {1, 8, 24, 168};  // hours

// Of a cause, where there is no room for its sign: what is broken is full, what somebody has
// stopped half, a wait hollow, all else hatched.
TimeShape shapeOfCause(const StateWords& why) {
    switch (why.sign) {
        case Sign::Alarm:
            return TimeShape::Full;
        case Sign::Hold:
        case Sign::Stop:
            return TimeShape::Half;
        case Sign::Wait:
            return TimeShape::Hollow;
        default:
            return TimeShape::Hatched;
    }
}

QString placeOfStop(const StopEntry& stop) {
    return stop.line && !stop.program.isEmpty() ? stop.program + QString(":%1").arg(stop.line)
                                                : stop.program;
}

// Together, and how often.
QString timesText(double seconds, int count) {
    return QString::fromUtf8("%1 · %2×").arg(timeText(seconds)).arg(count);
}

}  // namespace

StopsPage::StopsPage(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      book_(context.live, context.requests),
      table_(new Table(this)),
      picture_(new FreeSheet(this)) {
    table_->columns = {{word("Since"), 1.7},
                       {word("How long"), 1.1, kRight},
                       {"", 0.55},
                       {word("Cause"), 2.3},
                       {"", 4}};
    table_->rowUnits = 34;
    table_->textUnits = 14;
    table_->rows = [this] { return static_cast<int>(book_.all().size()); };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const StopEntry& stop = book_.all()[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        const StateWords why = stopWords(stop.cause);
        switch (column) {
            case 0:
                return {shortMomentText(stop.begin, "HH:mm:ss"), t.dim};
            // "…": it goes on
            case 1:
                return {(stop.seconds < 0 ? QString::fromUtf8("–") : timeText(stop.seconds)) +
                            (stop.stands ? QString::fromUtf8(" …") : QString()),
                        t.text, Sign::None, stop.stands};
            case 2:
                return {QString("L%1").arg(stop.channel), t.text, Sign::None, true};
            case 3:
                return {why.text, colourOf(why.tone), why.sign};
            default: {
                const QString place = placeOfStop(stop), detail = stopDetail(stop);
                return {detail.isEmpty()  ? place
                        : place.isEmpty() ? detail
                                          : detail + "   " + place,
                        t.dim};
            }
        }
    };
    picture_->onCompose = [this](Writer& w) { composePicture(w); };
}

QString StopsPage::title() const { return word("Log of stops"); }

void StopsPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), right = px(440);
    const Parted all =
        parted(*this, rect().adjusted(edge, 0, -edge, -edge), right, height() / 2, edge);
    table_->setGeometry(all.main);
    picture_->setGeometry(all.side);
}

void StopsPage::refresh() {
    book_.poll();
    table_->nothing =
        !book_.whyNot().isEmpty() ? book_.whyNot() : word("No channel has stood in this time.");
    table_->refresh();
    picture_->refresh();
}

// Above: a bar for each cause, the longest first. Below: what the chosen line has no room for, and
// a line for each channel over the period, its stops in the colours and shapes of their causes.
void StopsPage::composePicture(Writer& w) {
    const Theme& t = theme();
    const double wide = picture_->width(), high = picture_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const auto sums = book_.sums();
    double all = 0;
    int count = 0;
    for (const StopSum& one : sums) {
        all += one.seconds;
        count += one.count;
    }
    w.text(QRectF(px(14), px(8), wide * 0.6, px(28)),
           book_.hours() < 48 ? word("The last %1 h").arg(book_.hours())
                              : word("The last %1 days").arg(book_.hours() / 24),
           lettering(16, true), t.text);
    w.text(QRectF(wide * 0.5, px(8), wide * 0.5 - px(14), px(28)), timesText(all, count),
           lettering(15, true), t.dim, kRight);
    const auto& channels = context_.live.channels();
    const std::size_t lines = book_.channel() ? 1 : channels.size();
    // sixteen, too
    const double pitch = std::clamp<double>(
        px(176) / std::max<double>(1, static_cast<double>(lines)), px(12), px(22));
    const double chosen = px(92), foot = px(40) + static_cast<double>(lines) * pitch + chosen;
    double y = px(44);
    for (const StopSum& one : sums) {
        if (y + px(42) > high - foot) break;
        const StateWords why = stopWords(one.cause);
        w.sign(QRectF(px(14), y + px(2), px(18), px(18)), why.sign, colourOf(why.tone));
        w.text(QRectF(px(40), y, wide * 0.52, px(22)), why.text, lettering(14.5), t.text);
        w.text(QRectF(wide * 0.6, y, wide * 0.4 - px(14), px(22)),
               timesText(one.seconds, one.count), lettering(14.5, true), t.text, kRight);
        const QRectF room(px(40), y + px(24), wide - px(54), px(12));
        w.fill(room, t.window, px(2));
        if (sums.front().seconds > 0)
            drawTimeShape(
                w, shapeOfCause(why),
                QRectF(room.left(), room.top(),
                       std::max<double>(px(4), room.width() * one.seconds / sums.front().seconds),
                       room.height()),
                colourOf(why.tone));
        y += px(43);
    }
    if (const auto row = static_cast<std::size_t>(std::max(0, table_->row()));
        row < book_.all().size()) {
        const StopEntry& stop = book_.all()[row];
        const StateWords why = stopWords(stop.cause);
        const double top = high - foot;
        w.line(QPointF(px(14), top), QPointF(wide - px(14), top), t.edge, 1);
        w.sign(QRectF(px(14), top + px(9), px(18), px(18)), why.sign, colourOf(why.tone));
        w.text(QRectF(px(40), top + px(7), px(60), px(22)), QString("L%1").arg(stop.channel),
               lettering(14.5, true), t.text);
        w.data(QRectF(px(100), top + px(7), wide - px(114), px(22)), placeOfStop(stop),
               lettering(14), t.dim, kRight);
        const QString detail = stopDetail(stop);
        Item& item = w.text(QRectF(px(14), top + px(31), wide - px(28), px(57)),
                            detail.isEmpty() ? why.text : detail, lettering(14), t.text,
                            Qt::AlignLeft | Qt::AlignTop);
        item.wraps = true;
        item.data = true;
    }
    if (lines == 0) return;
    const double left = px(46), right = wide - px(14), period = 3600.0 * book_.hours();
    y = high - foot + chosen;
    const QDateTime now = QDateTime::currentDateTime();
    const auto x = [&](const QDateTime& when) {
        return left +
               (right - left) *
                   std::clamp(1.0 - static_cast<double>(when.secsTo(now)) / period, 0.0, 1.0);
    };
    for (std::size_t i = 0; i < lines; ++i, y += pitch) {
        const unsigned channel = book_.channel() ? book_.channel() : channels[i];
        const double bar = std::min<double>(px(14), pitch - px(3));
        w.text(QRectF(px(14), y, px(30), bar + px(3)), QString("L%1").arg(channel),
               lettering(pitch < px(16) ? 11 : 13, true), t.dim);
        w.fill(QRectF(left, y + px(2), right - left, bar), t.window, px(2));
        int drawn = 0;
        for (const StopEntry& stop : book_.all()) {
            if (stop.channel != channel || stop.seconds <= 0) continue;
            const double from = x(stop.begin),
                         to = std::max(
                             from + 1.5,
                             x(stop.begin.addMSecs(static_cast<qint64>(stop.seconds * 1e3))));
            const StateWords why = stopWords(stop.cause);
            drawTimeShape(w, shapeOfCause(why), QRectF(from, y + px(2), to - from, bar),
                          colourOf(why.tone));
            if (++drawn == 300) break;
        }
    }
    w.text(QRectF(left, y + px(2), px(140), px(20)),
           now.addSecs(-static_cast<qint64>(period))
               .toString(book_.hours() < 48 ? QString("HH:mm") : shortDayForm()),
           lettering(12.5), t.dim);
    w.text(QRectF(right - px(140), y + px(2), px(140), px(20)), now.toString("HH:mm"),
           lettering(12.5), t.dim, kRight);
}

void StopsPage::addKeys(std::vector<SoftKey>& keys) {
    keys.push_back({word("Period"), [this] {
                        std::size_t at = 0;
                        while (at < std::size(kPeriods) && kPeriods[at] != book_.hours()) ++at;
                        book_.setHours(kPeriods[(at + 1) % std::size(kPeriods)]);
                        refresh();
                    }});
    keys.push_back({word("Only L%1").arg(context_.channel),
                    [this] {
                        book_.setChannel(book_.channel() ? 0 : context_.channel);
                        table_->choose(0);
                        refresh();
                    },
                    Sign::None, true, book_.channel() != 0});
}

}  // namespace polyturn::hmi
