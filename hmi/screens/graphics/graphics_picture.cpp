// What the screen of graphics paints (see graphics.hpp): the part and the paths in a picture that
// is kept, what moves over it.
#include <QLinearGradient>
#include <QPaintEvent>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "hmi/machine/tools/tool_in_work.hpp"
#include "hmi/screens/graphics/graphics.hpp"
#include "hmi/screens/graphics/graphics_look.hpp"
#include "hmi/widgets/painted.hpp"
#include "hmi/widgets/set_words.hpp"

namespace polyturn::hmi {
namespace {
constexpr double kSketchWide = 0.45;  // of the reach: a turret of which only that is known
// mm: what is farther out (the head behind a chuck) does not make the picture smaller
constexpr double kLargest = 2500;
constexpr double kFarthest = 1e5;                      // mm: drawn instead of infinity
constexpr double kNameEvery = 220, kNamesApart = 110;  // of channels on their paths

// A label that would lie on another one goes up or down until it does not, as far as there is room.
// `outwards`, -1 up, 1 down: first all the way there, for a name that goes past the tip of another
// tool looks like that one's; 0: whatever is nearer.
void keepClear(QRectF& label, const std::vector<QRectF>& taken, const QRectF& area, int outwards) {
    const double step = label.height() + px(2);
    constexpr int kFarthestStep = 16;  // as many as there are channels
    for (int i = 0; i <= 2 * kFarthestStep; ++i) {
        const int nearest = i % 2 ? (i + 1) / 2 : -(i / 2);  // 0, 1, -1, 2, ...
        const int steps = outwards == 0        ? nearest
                          : i <= kFarthestStep ? outwards * i
                                               : -outwards * (i - kFarthestStep);
        const QRectF there = label.translated(0, steps * step);
        if ((steps && !area.contains(there)) ||
            std::any_of(taken.begin(), taken.end(),
                        [&](const QRectF& one) { return one.intersects(there); }))
            continue;
        label = there;
        return;
    }
}
}  // namespace

// The part of the work area that is shown: the blank with what is around it, or all bodies. In
// pixels: z to the right, x up.
void Graphics::measure() {
    const CuttingScene& scene = shown();
    const CuttingScene::Zero zero = scene.stock.any() || context_.live.channels().empty()
                                        ? scene.zero()
                                        : zeroOf(context_.live.channels().front(), dry_);
    double from = zero.z - 120, to = zero.z + 40, low = zero.x - 60, high = zero.x + 60;
    if (scene.stock.any()) {
        const double a = zero.z + zero.sense * (scene.stock.left() - 30),
                     b = zero.z + zero.sense * (scene.stock.right() + 20);
        from = std::min(a, b);
        to = std::max(a, b);
        low = zero.x - scene.stock.outer() - 30;
        high = zero.x + scene.stock.outer() + 30;
    }
    if (machine_)
        for (const ShownBody& body : room_.bodies(now_)) {
            const auto take = [&](double z, double x) {
                if (std::abs(z) < kLargest && std::abs(x) < kLargest) {
                    from = std::min(from, z);
                    to = std::max(to, z);
                    low = std::min(low, x);
                    high = std::max(high, x);
                }
            };
            take(body.at.z, body.at.x);
            if (!body.barrier)
                for (const auto& box : body.boxes) {
                    take(box.z_low, box.x_low);
                    take(box.z_high, box.x_high);
                }
            if (body.boxes.empty() && body.reach > 0) {
                if (body.alongX)
                    take(body.at.z, body.at.x + body.axisAt - body.outwards * body.reach);
                else
                    take(body.at.z + body.axisAt - body.outwards * body.reach, body.at.x);
            }
        }
    if (machine_)
        for (const ShownStroke& stroke : strokes_) {
            const auto take = [](double value, double& least, double& most) {
                if (std::abs(value) < kLargest) {
                    least = std::min(least, value);
                    most = std::max(most, value);
                }
            };
            take(stroke.allowed.zLow, from, to);
            take(stroke.allowed.zHigh, from, to);
            take(stroke.allowed.xLow, low, high);
            take(stroke.allowed.xHigh, low, high);
        }
    const double top = head_->height();
    // whose lines say what the lines of the picture mean: it lies over none of them
    const double room = height() - top - legend().height();
    scale_ = std::min((width() - px(60)) / std::max(1.0, to - from),
                      (room - px(40)) / std::max(1.0, high - low)) *
             zoom_;
    centre_ = QPointF((from + to) / 2, (low + high) / 2);
    origin_ = QPointF(width() * (0.5 + moved_.x()), top + room / 2.0 + height() * moved_.y());
}

// Where the lines at the foot stand: one, or two where both do not fit beside each other.
QRectF Graphics::legend() const {
    const QRectF area(px(8), head_->height(), width() - px(16), height() - head_->height() - px(8));
    const Notes notes = this->notes();
    const double high = (notes.two ? 2 : 1) * QFontMetricsF(lettering(13.5)).height() + px(14);
    return {area.left(), area.bottom() - high, area.width(), high};
}

// What the lines mean; and where there is no part, why.
Graphics::Notes Graphics::notes() const {
    Notes out;
    out.lines = word("Solid outline: monitored; dashed: drawn only");
    // no room for it on top
    if (context_.live.channels().size() > kFewChannels && !dry_)
        out.lines = word("Paths since these screens started; tips drawn as points");
    const CuttingScene& scene = dry_ ? drySide_ : live_;
    if (!scene.stock.any()) out.none = word("No job names the stock of the running program");
    const QFont font = lettering(13.5);
    out.two = !out.none.isEmpty() &&
              wordsWidth(out.lines, font) + wordsWidth(out.none, font) + px(16) > width() - px(48);
    return out;
}

QPointF Graphics::place(double z, double x) const {
    return {origin_.x() + (z - centre_.x()) * scale_, origin_.y() - (x - centre_.y()) * scale_};
}
QRectF Graphics::boxOf(const RoomBodies::Box& box) const {
    return QRectF(place(box.z_low, box.x_high), place(box.z_high, box.x_low));
}

double Graphics::aside(unsigned channel) const {
    const AxisConfig* x = find_axis(context_.live.config(), channel, PlaneRole::BasicX);
    const Room* room = room_.room();
    const auto axis =
        x && room ? room->axes.find(x->number) : std::map<unsigned, RoomPlace>::const_iterator{};
    return x && room && axis != room->axes.end() && axis->second.direction.x < 0 ? -1 : 1;
}

QString Graphics::nameOf(const ShownBody& body) const {
    switch (body.kind) {
        case RoomBodies::Kind::Chuck:
            return body.barrier ? word("Chuck zone of L%1").arg(body.number)
                                : word("Chuck S%1").arg(body.number);
        case RoomBodies::Kind::Tailstock:
            return body.barrier ? word("Tailstock zone of L%1").arg(body.number)
                                : word("Tailstock %1").arg(body.number);
        case RoomBodies::Kind::Carrier:
            break;
    }
    return word("Turret L%1").arg(body.number);
}

// From the last point that is in the picture on.
QRectF Graphics::drawTrail(QPainter& p, unsigned channel, Trail& trail) {
    if (trail.points.empty()) return {};
    const auto at = [&](std::size_t i) { return place(trail.points[i].z, trail.points[i].x); };
    const QRectF area(px(8), head_->height(), width() - px(16), height() - head_->height() - px(8));
    PathNames& names = names_[channel];
    if (trail.drawn == 0) names.clear();
    const std::size_t named = names.places().size();
    std::size_t i = std::max<std::size_t>(1, trail.drawn);
    QPainterPath cut, rapid;
    for (QPointF last = at(i - 1); i < trail.points.size(); ++i) {
        const TrailPoint& point = trail.points[i];
        const QPointF now = at(i);
        QPainterPath& path = point.rapid ? rapid : cut;
        if (!point.begins) {
            path.moveTo(last);
            path.lineTo(now);
            names.goOn(last, now, px(kNameEvery), px(kNamesApart), area);
        }
        last = now;
    }
    const QColor colour = colourOf(channel);
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(colour, 1, Qt::DotLine));
    p.drawPath(rapid);
    p.setPen(QPen(colour, px(1.6)));
    p.drawPath(cut);
    trail.drawn = trail.points.size();
    QRectF out = (cut.boundingRect() | rapid.boundingRect()).adjusted(-px(4), -px(4), px(4), px(4));
    for (std::size_t n = named; n < names.places().size(); ++n)
        out |= nameBox(channel, names.places()[n]);
    return out;
}

QRectF Graphics::nameBox(unsigned channel, const QPointF& place) const {
    const QFont font = lettering(11, true);
    QRectF box(0, 0, wordsWidth(QString("L%1").arg(channel), font) + px(6),
               QFontMetricsF(font).height());
    box.moveCenter(place);
    return box;
}

// Which channel a path belongs to: over the paths, where they have been drawn within the area.
QRectF Graphics::drawNames(QPainter& p, const QRectF& within) {
    QRectF out;
    for (const auto& [channel, names] : names_)
        for (const QPointF& place : names.places()) {
            const QRectF box = nameBox(channel, place);
            if (!box.intersects(within)) continue;
            p.setPen(QPen(colourOf(channel), 1));
            p.setBrush(theme().card);
            p.drawRoundedRect(box, px(3), px(3));
            p.setFont(lettering(11, true));
            paintWords(p, box, Qt::AlignCenter, QString("L%1").arg(channel));
            out |= box.adjusted(-1, -1, 1, 1);
        }
    return out;
}

double Graphics::BodyLook::pen() const { return held ? px(3) : px(1.6); }

QRegion Graphics::BodyLook::pixels() const {
    QRegion out;
    const auto margin = static_cast<int>(pen()) + 2;
    for (const Filled& one : boxes)
        out |= one.box.toAlignedRect().adjusted(-margin, -margin, margin, margin);
    if (!seat.isNull()) out |= seat.toAlignedRect().adjusted(-margin, -margin, margin, margin);
    if (from != to)
        out |= QRectF(from, to).normalized().toAlignedRect().adjusted(-px(4), -px(4), px(4), px(4));
    if (!label.isNull()) out |= label.toAlignedRect().adjusted(-1, -1, 1, 1);
    return out;
}

// A box that has moved by little is filled as before in its middle: there is nothing to paint
// again.
QRegion Graphics::BodyLook::differing(const BodyLook& before) const {
    if (*this == before) return {};
    if (colour != before.colour || ink != before.ink || hatched != before.hatched ||
        broken != before.broken || held != before.held || boxes.size() != before.boxes.size())
        return pixels() | before.pixels();
    const auto margin = static_cast<int>(pen()) + px(2) + 2;  // the line and its round corners
    BodyLook now = *this, then = before;
    QRegion out;
    now.boxes.clear();
    then.boxes.clear();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i] == before.boxes[i]) continue;
        const QRect a = boxes[i].box.toAlignedRect(), b = before.boxes[i].box.toAlignedRect();
        QRegion own = QRegion(a.adjusted(-margin, -margin, margin, margin)) |
                      b.adjusted(-margin, -margin, margin, margin);
        if (boxes[i].opacity == before.boxes[i].opacity)
            own -= a.adjusted(margin, margin, -margin, -margin) &
                   b.adjusted(margin, margin, -margin, -margin);
        out |= own;
    }
    if (seat == before.seat) now.seat = then.seat = {};
    if (from == before.from && to == before.to) now.from = now.to = then.from = then.to = {};
    if (label == before.label && text == before.text) now.label = then.label = {};
    return out | now.pixels() | then.pixels();
}

// What is guarded has a whole outline, what is only drawn a broken one; a zone of N1900 to N1914 is
// hatched; what protection holds is red and says so.
Graphics::BodyLook Graphics::lookOf(const ShownBody& body) const {
    const Theme& t = theme();
    BodyLook out;
    out.carrier = body.kind == RoomBodies::Kind::Carrier;
    out.hatched = body.barrier;
    out.broken = !body.guarded && !body.barrier;
    out.held = body.held;
    out.colour = body.held ? t.bad : out.carrier ? colourOf(body.number) : t.dim;
    out.ink = body.held ? t.bad : out.carrier ? out.colour : t.text;
    const int filled = body.barrier ? 70 : 48;
    QRectF all;
    const auto add = [&](const QRectF& box, int opacity) {
        out.boxes.push_back({box, opacity});
        all |= box;
    };
    bool drawn = false;
    for (const auto& one : body.boxes) {
        const bool inWork = one.station != 0 && one.station == body.inWork;
        drawn |= inWork;
        add(boxOf(one).normalized(), out.carrier && inWork ? 130 : filled);
    }
    if (out.carrier && body.boxes.empty() && body.reach > 0) {
        // Only its axis and its seats are known: a disc, seen from the side, behind the seat in
        // work.
        const double axis = body.axisAt, wide = body.reach * kSketchWide;
        const double a = axis + body.outwards * body.reach, b = axis - body.outwards * body.reach;
        const QRectF disc = body.alongX
                                ? QRectF(place(body.at.z, body.at.x + std::max(a, b)),
                                         place(body.at.z + wide, body.at.x + std::min(a, b)))
                                : QRectF(place(body.at.z + std::min(a, b), body.at.x + wide),
                                         place(body.at.z + std::max(a, b), body.at.x));
        add(disc.normalized(), filled);
    }
    if (out.carrier) {
        const QPointF seat = place(body.at.z, body.at.x);
        out.seat = QRectF(seat, QSizeF(0, 0)).adjusted(-px(5), -px(5), px(5), px(5));
        all |= out.seat;
        if (body.tipKnown && !drawn) {
            out.from = seat;
            out.to = place(body.tip.z, body.tip.x);
        }
    }
    const QRectF area(px(8), head_->height(), width() - px(16), legend().top() - head_->height()),
        seen = all.intersected(area);
    if (all.isEmpty() || seen.isEmpty()) return out;
    out.text = nameOf(body);
    if (body.held) out.text += "  " + word("held by protection");
    const QFont font = lettering(13.5, true);
    const double wide = wordsWidth(out.text, font) + px(12),
                 high = QFontMetricsF(font).height() + px(2);
    out.label = QRectF(
        std::clamp(seen.center().x() - wide / 2, area.left() + px(4), area.right() - wide - px(4)),
        0, wide, high);
    out.label.moveTop(out.carrier && aside(body.number) < 0 ? seen.bottom() - high - px(4)
                                                            : seen.top() + px(4));
    return out;
}

void Graphics::drawBody(QPainter& p, const BodyLook& body) {
    for (const auto& [box, opacity] : body.boxes) {
        QColor filled = body.colour;
        filled.setAlpha(opacity);
        p.setPen(QPen(body.colour, body.pen(), body.broken ? Qt::DashLine : Qt::SolidLine));
        p.setBrush(QBrush(filled, body.hatched ? Qt::BDiagPattern : Qt::SolidPattern));
        p.drawRoundedRect(box, px(2), px(2));
    }
    if (!body.seat.isNull()) {
        p.setPen(QPen(body.colour, px(1.6)));
        p.setBrush(Qt::NoBrush);
        p.drawEllipse(body.seat);
    }
    if (body.from != body.to) {
        p.setPen(QPen(body.colour, px(4), Qt::SolidLine, Qt::RoundCap));
        p.drawLine(body.from, body.to);
    }
    if (body.label.isNull()) return;
    QColor paper = theme().card;
    paper.setAlpha(225);
    p.setPen(Qt::NoPen);
    p.setBrush(paper);
    p.drawRoundedRect(body.label, px(4), px(4));
    p.setPen(body.ink);
    p.setFont(lettering(13.5, true));
    paintWords(p, body.label, Qt::AlignCenter, body.text);
}

Graphics::TipLook Graphics::lookOf(unsigned channel, const Trail& trail) const {
    TipLook out;
    out.at = place(trail.points.back().z, trail.points.back().x);
    out.side = aside(channel);
    const std::int64_t tool = dry_ ? static_cast<std::int64_t>(now_.turrets[channel - 1].station)
                                   : toolAtWork(context_.live, channel).number;
    out.text = tool > 0 ? QString("L%1 T%2").arg(channel).arg(tool) : QString("L%1").arg(channel);
    const QFont font = lettering(15, true);
    out.label = QRectF(0, 0, wordsWidth(out.text, font) + px(10), QFontMetricsF(font).height());
    // on the side where no tool is
    out.label.moveCenter(out.at + QPointF(px(20) + out.label.width() / 2, out.side * px(16)));
    return out;
}

QRect Graphics::TipLook::pixels() const {
    const double size = px(13);
    return (QRectF(at, at + QPointF(size, -side * size)).normalized() | label)
        .toAlignedRect()
        .adjusted(-2, -2, 2, 2);
}

QRegion Graphics::takeLooks() {
    QRegion out;
    // Names of tips keep clear of each other, those of bodies of all that are there already.
    const QRectF area(px(8), head_->height(), width() - px(16), legend().top() - head_->height());
    std::vector<QRectF> taken;
    std::map<unsigned, TipLook> tips;
    for (const auto& [channel, trail] : shown().trails)
        if (!trail.points.empty()) {
            TipLook& tip = tips.emplace(channel, lookOf(channel, trail)).first->second;
            keepClear(tip.label, taken, area, tip.side < 0 ? 1 : -1);
            taken.push_back(tip.label);
        }
    std::vector<BodyLook> bodies;
    for (const bool carriers : {false, true})  // carriers are drawn over what is at standstill
        for (const ShownBody& body : bodies_)
            if ((body.kind == RoomBodies::Kind::Carrier) == carriers)
                bodies.push_back(lookOf(body));
    for (BodyLook& body : bodies)
        if (!body.label.isNull()) {
            keepClear(body.label, taken, area, 0);
            taken.push_back(body.label);
        }
    for (std::size_t i = 0; i < std::max(bodies.size(), bodyLooks_.size()); ++i)
        out |= i >= bodies.size()       ? bodyLooks_[i].pixels()
               : i >= bodyLooks_.size() ? bodies[i].pixels()
                                        : bodies[i].differing(bodyLooks_[i]);
    bodyLooks_ = std::move(bodies);
    for (const auto& [channel, tip] : tips)
        if (const auto before = tipLooks_.find(channel);
            before == tipLooks_.end() || !(before->second == tip))
            out |= tip.pixels();
    for (const auto& [channel, tip] : tipLooks_)
        if (const auto now = tips.find(channel); now == tips.end() || !(now->second == tip))
            out |= tip.pixels();
    tipLooks_ = std::move(tips);
    return out;
}

std::vector<QRectF> Graphics::labels() const {
    std::vector<QRectF> out;
    for (const auto& [channel, tip] : tipLooks_) out.push_back(tip.label);
    for (const BodyLook& body : bodyLooks_)
        if (!body.label.isNull()) out.push_back(body.label);
    return out;
}

// What moves, over the picture, where something has changed.
void Graphics::paintEvent(QPaintEvent* event) {
    const Theme& t = theme();
    const QRegion& region = event->region();
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    if (picture_.isNull()) return p.fillRect(rect(), t.window);
    const double ratio = picture_.devicePixelRatio();
    // one by one: a large piece under a clip of many would go through all of it
    for (const QRect& one : region) {
        p.setClipRect(one);
        p.drawPixmap(
            one, picture_,
            QRectF(one.x() * ratio, one.y() * ratio, one.width() * ratio, one.height() * ratio)
                .toAlignedRect());
    }
    p.setClipRegion(region.intersected(
        QRect(px(8), head_->height(), width() - px(16), height() - head_->height() - px(8))));
    for (const BodyLook& body : bodyLooks_)
        if (region.intersects(body.pixels().boundingRect())) drawBody(p, body);
    for (const auto& [channel, tip] : tipLooks_) {
        if (!region.intersects(tip.pixels())) continue;
        const double size = px(13);
        p.setPen(QPen(t.window, 1));
        p.setBrush(colourOf(channel));
        p.drawPolygon(QPolygonF({tip.at, tip.at + QPointF(size * 0.35, -tip.side * size),
                                 tip.at + QPointF(size, -tip.side * size * 0.35)}));
        QColor paper = t.card;
        paper.setAlpha(215);
        p.setPen(QPen(colourOf(channel), px(1.4)));
        p.setBrush(paper);
        p.drawRoundedRect(tip.label, px(3), px(3));
        p.setPen(t.text);
        p.setFont(lettering(15, true));
        paintWords(p, tip.label, Qt::AlignCenter, tip.text);
    }
    drawNotes(p, region);
}

// The blank as it was, the part as it is.
void Graphics::drawPart(QPainter& p) {
    const Theme& t = theme();
    const CuttingScene& scene = shown();
    const TurnedStock& stock = scene.stock;
    const CuttingScene::Zero& zero = scene.zero();
    const auto at = [&](double z, double x) { return place(zero.z + zero.sense * z, zero.x + x); };
    const double outer = stock.outer(), left = stock.left();
    p.setPen(Qt::NoPen);
    p.setBrush(t.raised);
    p.drawRect(QRectF(at(left, outer), at(stock.right(), -outer)).normalized());
    QPainterPath part(at(left, 0));
    for (double z = left; z < stock.right(); z += 2 * TurnedStock::kStep)
        part.lineTo(at(z, stock.radiusAt(z)));
    part.lineTo(at(stock.right(), 0));
    for (double z = stock.right() - TurnedStock::kStep; z > left; z -= 2 * TurnedStock::kStep)
        part.lineTo(at(z, -stock.radiusAt(z)));
    part.closeSubpath();
    QLinearGradient steel(at(0, outer), at(0, -outer));
    const QColor bright = t.dark ? QColor("#8fa3b5") : QColor("#dfe6ec"),
                 dull = t.dark ? QColor("#3c4a57") : QColor("#8d9aa6");
    steel.setColorAt(0, dull);
    steel.setColorAt(0.35, bright);
    steel.setColorAt(0.55, bright);
    steel.setColorAt(1, dull);
    p.setBrush(steel);
    p.setPen(QPen(t.edge, 1));
    p.drawPath(part);
    if (!stock.hollow()) return;
    // Cut open: the hole in the colour behind the part.
    QPainterPath hole(at(left, 0));
    for (double z = left; z < stock.right(); z += 2 * TurnedStock::kStep)
        hole.lineTo(at(z, stock.boreAt(z)));
    hole.lineTo(at(stock.right(), 0));
    for (double z = stock.right() - TurnedStock::kStep; z > left; z -= 2 * TurnedStock::kStep)
        hole.lineTo(at(z, -stock.boreAt(z)));
    hole.closeSubpath();
    p.setBrush(t.window);
    p.drawPath(hole);
}

// How far the tips may go, in the colour of their channel: a frame of dashes with its name, and
// hatched what a tip must stay out of. The names stand one behind the other, above the frames of
// carriers that work from above, below those of the others.
void Graphics::drawStrokes(QPainter& p, const QRectF& area) {
    const Theme& t = theme();
    p.setFont(lettering(13, true));
    const QFontMetricsF metrics(p.font());
    // what is infinite ends beyond the picture
    const auto boxed = [&](const ShownStroke::Area& of) {
        const QPointF a = place(std::clamp(of.zLow, -kFarthest, kFarthest),
                                std::clamp(of.xHigh, -kFarthest, kFarthest)),
                      b = place(std::clamp(of.zHigh, -kFarthest, kFarthest),
                                std::clamp(of.xLow, -kFarthest, kFarthest));
        return QRectF(a, b).normalized();
    };
    const auto name = [&](const QString& text, QPointF at, const QColor& colour) {
        const QRectF label(at, QSizeF(metrics.horizontalAdvance(text) + px(10), metrics.height()));
        QColor paper = t.card;
        paper.setAlpha(215);
        p.setPen(Qt::NoPen);
        p.setBrush(paper);
        p.drawRoundedRect(label, px(3), px(3));
        p.setPen(colour);
        paintWords(p, label, Qt::AlignCenter, text);
        return label.right() + px(4);
    };
    double next[2] = {0, 0};
    frames_.clear();
    for (const ShownStroke& stroke : strokes_) {
        const QColor colour = colourOf(stroke.channel);
        for (const auto& [range, forbidden] : stroke.forbidden) {
            const QRectF box = boxed(forbidden);
            QColor paint = colour;
            paint.setAlpha(90);
            p.setPen(QPen(colour, px(1.4), Qt::DashDotDotLine));
            p.setBrush(QBrush(paint, Qt::FDiagPattern));
            p.drawRect(box);
            const QRectF seen = box.intersected(area);
            if (!seen.isEmpty())
                name(word("Range %1 of L%2").arg(range).arg(stroke.channel),
                     seen.topLeft() + QPointF(px(4), px(4)), colour);
        }
        const QRectF frame = frames_.emplace_back(boxed(stroke.allowed));
        p.setPen(QPen(colour, px(1.4), Qt::DashDotDotLine));
        p.setBrush(Qt::NoBrush);
        p.drawRect(frame);
        const QRectF seen = frame.intersected(area);
        if (seen.isEmpty() || frame.contains(area)) continue;  // no line of it can be seen
        const bool below = aside(stroke.channel) < 0;
        const double x = std::max({seen.left() + px(6), area.left() + px(6), next[below]});
        next[below] =
            name(word("Travel of L%1").arg(stroke.channel),
                 QPointF(x, below ? seen.bottom() - metrics.height() - px(3) : seen.top() + px(3)),
                 colour);
    }
}

void Graphics::drawRoom() {
    const Theme& t = theme();
    QPainter p(&picture_);
    p.setRenderHint(QPainter::Antialiasing);
    p.fillRect(rect(), t.window);
    const QRectF area(px(8), head_->height(), width() - px(16), height() - head_->height() - px(8));
    p.setPen(Qt::NoPen);
    p.setBrush(t.card);
    p.drawRoundedRect(area, px(8), px(8));
    p.setClipRect(area);
    CuttingScene& scene = shown();
    if (scene.stock.any()) drawPart(p);
    p.setPen(QPen(t.faint, 1, Qt::DashDotLine));
    const double axis = place(0, scene.zero().x).y();
    p.drawLine(QPointF(area.left(), axis), QPointF(area.right(), axis));
    drawStrokes(p, area);
    std::erase_if(names_, [&](const auto& one) { return !scene.trails.contains(one.first); });
    for (auto& [channel, trail] : scene.trails) drawTrail(p, channel, trail);
    drawNames(p, area);
}

// At the foot, over everything: bodies may reach down there where somebody has made the picture
// larger.
void Graphics::drawNotes(QPainter& p, const QRegion& region) {
    const Theme& t = theme();
    if (!region.intersects(legend().toAlignedRect())) return;
    const QRectF area(px(8), head_->height(), width() - px(16), height() - head_->height() - px(8)),
        foot = area.adjusted(px(16), 0, -px(16), -px(10));
    const QFont font = lettering(13.5);
    const double high = QFontMetricsF(font).height();
    QColor paper = t.card;
    paper.setAlpha(225);
    const auto note = [&](const QString& text, const QRectF& box) {
        p.fillRect(box.adjusted(-px(4), 0, px(4), 0), paper);
        p.setPen(t.dim);
        p.setFont(font);
        paintWords(p, box, Qt::AlignLeft | Qt::AlignBottom, text);
    };
    const Notes notes = this->notes();
    note(notes.lines,
         QRectF(foot.left(), foot.bottom() - high, wordsWidth(notes.lines, font), high));
    if (notes.none.isEmpty()) return;
    const double wide = wordsWidth(notes.none, font);
    note(notes.none, QRectF(foot.right() - wide,
                            foot.bottom() - high - (notes.two ? high + px(2) : 0), wide, high));
}

}  // namespace polyturn::hmi
