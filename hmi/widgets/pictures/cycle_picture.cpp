#include "hmi/widgets/pictures/cycle_picture.hpp"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <vector>

#include "hmi/text/display_languages.hpp"
#include "hmi/widgets/painted.hpp"
#include "hmi/widgets/theme.hpp"

namespace polyturn::hmi {
namespace {

void arrowHead(QPainter& painter, QPointF at, QPointF from, double size) {
    const QPointF d = at - from;
    const double l = std::hypot(d.x(), d.y());
    if (l < 1e-6) return;
    const QPointF u = d / l, n(-u.y(), u.x());
    QPainterPath path(at);
    path.lineTo(at - u * size + n * size * 0.4);
    path.lineTo(at - u * size - n * size * 0.4);
    path.closeSubpath();
    painter.fillPath(path, painter.pen().color());
}

}  // namespace

void CyclePicture::show(const forms::Form* form) {
    form_ = form;
    scene_ = form ? sceneOf(form->picture) : Scene{};
    field_ = -1;
    value_.clear();
    update();
}

void CyclePicture::point(int field, const QString& value) {
    if (field == field_ && value == value_) return;
    field_ = field;
    value_ = value;
    update();
}

void CyclePicture::paintEvent(QPaintEvent*) {
    const Theme& t = theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), t.window);
    QPainterPath card;
    card.addRoundedRect(rect(), px(8), px(8));
    painter.fillPath(card, t.card);
    if (!form_) return;
    const double scale =
        std::min((width() - px(24)) / kSceneWidth, (height() - px(20)) / kSceneHeight);
    const QPointF origin((width() - kSceneWidth * scale) / 2,
                         (height() + kSceneHeight * scale) / 2);
    const auto at = [&](QPointF p) {
        return QPointF(origin.x() + p.x() * scale, origin.y() - p.y() * scale);
    };
    const auto all = [&](const QPolygonF& line) {
        QPolygonF out;
        for (const QPointF& p : line) out << at(p);
        return out;
    };
    const auto pen = [&](const QColor& colour, double wide, Qt::PenStyle style = Qt::SolidLine) {
        QPen one(colour, wide, style);
        one.setCapStyle(Qt::RoundCap);
        one.setJoinStyle(Qt::RoundJoin);
        painter.setPen(one);
    };
    // What is cut away, then the part.
    QColor stock = t.faint;
    stock.setAlpha(50);
    QPainterPath blank;
    blank.addPolygon(all(scene_.blank));
    blank.closeSubpath();
    painter.fillPath(blank, QBrush(stock, Qt::SolidPattern));
    pen(t.faint, px(1), Qt::DashLine);
    painter.drawPath(blank);
    QPainterPath part;
    part.addPolygon(all(scene_.part));
    part.closeSubpath();
    painter.fillPath(part, t.raised);
    pen(t.text, px(2));
    painter.drawPolyline(all(scene_.part.size() > 2 ? scene_.part.mid(1) : scene_.part));
    pen(t.dim, px(1));
    for (const QPolygonF& line : scene_.detail) painter.drawPolyline(all(line));
    pen(t.dim, px(1), Qt::DashDotLine);
    if (!scene_.front) painter.drawLine(at({2, kCentre}), at({98, kCentre}));
    // The tool's way: rapid dashed, feed with arrows.
    for (const Scene::Path& path : scene_.paths) {
        pen(path.rapid ? t.warn : t.good, px(path.rapid ? 1 : 2),
            path.rapid ? Qt::DashLine : Qt::SolidLine);
        const QPolygonF line = all(path.points);
        painter.drawPolyline(line);
        if (!path.rapid && line.size() >= 2)
            arrowHead(painter, line.back(), line[line.size() - 2], px(9));
    }
    // The tool itself.
    const double d = 3.0 * scale;
    const QPointF tool = at(scene_.tool);
    QPainterPath insert;
    if (scene_.drill && scene_.front) {
        insert.addEllipse(tool, d * 0.6, d * 0.6);
    } else if (scene_.drill) {
        const QPointF along = scene_.across ? QPointF(0, -1) : QPointF(1, 0),
                      aside(along.y(), along.x());
        insert.moveTo(tool);
        insert.lineTo(tool + along * d * 0.5 + aside * d * 0.6);
        insert.lineTo(tool + along * d * 2.4 + aside * d * 0.6);
        insert.lineTo(tool + along * d * 2.4 - aside * d * 0.6);
        insert.lineTo(tool + along * d * 0.5 - aside * d * 0.6);
    } else {
        insert.moveTo(tool);
        insert.lineTo(tool + QPointF(d * 0.5, -d * 1.3));
        insert.lineTo(tool + QPointF(d * 1.8, -d * 1.1));
        insert.lineTo(tool + QPointF(d * 1.3, d * 0.2));
    }
    insert.closeSubpath();
    painter.fillPath(insert, t.warn);
    // Dimensions: those of the form faint, that of the chosen field at last and bright.
    // by plates: letters that stand on each other are read by nobody
    std::vector<QRectF> taken;
    const auto plateOf = [&](const SceneDim& dim, const QString& label, bool chosen) {
        const QPointF a = at(dim.from), b = at(dim.to), middle = (a + b) / 2, v = b - a;
        QPointF text = middle;
        if (dim.kind == SceneDim::Kind::Point) text = a + QPointF(px(8), -px(12));
        if (dim.kind == SceneDim::Kind::Way) text = middle + QPointF(0, -px(12));
        if (dim.kind == SceneDim::Kind::Angle) text = b;
        if (dim.kind == SceneDim::Kind::Length)
            text = middle +
                   (std::fabs(v.x()) > std::fabs(v.y()) ? QPointF(0, -px(12)) : QPointF(px(12), 0));
        QRectF box = QFontMetricsF(lettering(chosen ? 18 : 13.5, chosen))
                         .boundingRect(label)
                         .adjusted(-px(4), -px(1), px(4), px(1));
        box.moveCenter(text);
        if (std::fabs(v.y()) > std::fabs(v.x()) && dim.kind == SceneDim::Kind::Length)
            box.moveLeft(middle.x() + px(5));
        const auto within = [&](QRectF one) {
            one.moveLeft(std::clamp(one.left(), double(px(4)),
                                    std::max<double>(px(4), width() - one.width() - px(4))));
            one.moveTop(std::clamp(one.top(), double(px(4)),
                                   std::max<double>(px(4), height() - one.height() - px(4))));
            return one;
        };
        // Aside where another one stands, as near as there is room.
        for (const double far : {0.0, 1.0, 1.6, 2.4, 3.4, 5.0, 7.0})
            for (const QPointF& way :
                 {QPointF(0, -1), QPointF(1, 0), QPointF(0, 1), QPointF(-1, 0), QPointF(1, -1),
                  QPointF(-1, -1), QPointF(1, 1), QPointF(-1, 1)}) {
                const QRectF there = within(
                    box.translated(way.x() * far * box.width(), way.y() * far * box.height()));
                if (std::none_of(taken.begin(), taken.end(),
                                 [&](const QRectF& one) { return one.intersects(there); }))
                    return there;
            }
        return within(box);
    };
    const auto draw = [&](const SceneDim& dim, const QString& label, const QRectF& box,
                          bool chosen) {
        const QColor colour = chosen ? t.accent : t.dim;
        const double size = px(chosen ? 10 : 6);
        pen(colour, chosen ? px(3) : px(1));
        const QPointF a = at(dim.from), b = at(dim.to);
        switch (dim.kind) {
            case SceneDim::Kind::Point:
                painter.setBrush(chosen ? colour : t.card);
                painter.drawEllipse(a, px(chosen ? 7 : 4), px(chosen ? 7 : 4));
                painter.setBrush(Qt::NoBrush);
                break;
            case SceneDim::Kind::Way:
                painter.drawLine(a, b);
                arrowHead(painter, b, a, size * 1.4);
                break;
            case SceneDim::Kind::Angle: {
                const double half = 0.52, l = std::hypot(b.x() - a.x(), b.y() - a.y()),
                             main = std::atan2(b.y() - a.y(), b.x() - a.x());
                const QPointF left = a + QPointF(std::cos(main - half), std::sin(main - half)) * l,
                              right = a + QPointF(std::cos(main + half), std::sin(main + half)) * l;
                painter.drawLine(a, left);
                painter.drawLine(a, right);
                QPainterPath arc;
                const double r = l * 0.75;
                arc.arcMoveTo(QRectF(a.x() - r, a.y() - r, 2 * r, 2 * r),
                              -(main + half) * 180 / M_PI);
                arc.arcTo(QRectF(a.x() - r, a.y() - r, 2 * r, 2 * r), -(main + half) * 180 / M_PI,
                          2 * half * 180 / M_PI);
                painter.drawPath(arc);
                break;
            }
            case SceneDim::Kind::Length: {
                painter.drawLine(a, b);
                arrowHead(painter, a, b, size);
                arrowHead(painter, b, a, size);
                const QPointF v = b - a;
                const double l = std::hypot(v.x(), v.y());
                if (l > 1e-6) {  // ticks at its ends
                    const QPointF n(-v.y() / l, v.x() / l);
                    painter.drawLine(a - n * size, a + n * size);
                    painter.drawLine(b - n * size, b + n * size);
                }
            }
        }
        QColor behind = chosen ? t.accent : t.card;
        if (!chosen) behind.setAlpha(200);
        QPainterPath plate;
        plate.addRoundedRect(box, px(4), px(4));
        painter.fillPath(plate, behind);
        painter.setFont(lettering(chosen ? 18 : 13.5, chosen));
        painter.setPen(chosen ? t.onAccent : t.dim);
        paintWords(painter, box, Qt::AlignCenter, label);
    };
    const auto fields = form_->fields;
    const forms::Mark wanted = field_ >= 0 && field_ < static_cast<int>(fields.size())
                                   ? fields[static_cast<std::size_t>(field_)].mark
                                   : forms::Mark::None;
    struct Shown {
        const SceneDim* dim;
        QString label;
        QRectF plate;
        bool chosen;
    };
    std::vector<Shown> shown;
    // that of the chosen field stands where it belongs, the others beside it
    for (const bool chosen : {true, false})
        for (std::size_t i = 0; i < fields.size(); ++i) {
            const bool mine = static_cast<int>(i) == field_;
            if (mine != chosen || fields[i].mark == forms::Mark::None ||
                (!chosen && fields[i].mark == wanted && fields[i].mark != forms::Mark::Contour &&
                 fields[i].mark != forms::Mark::Place))
                continue;
            int seen = 0, nth = 0;  // P and Q of a contour are its two points
            for (std::size_t k = 0; k < i; ++k) nth += fields[k].mark == fields[i].mark;
            const SceneDim* found = nullptr;
            for (const SceneDim& dim : scene_.dims)
                if (dim.mark == fields[i].mark && (!found || seen++ < nth)) found = &dim;
            if (!found) continue;
            const QString label = fromView(fields[i].address) +
                                  (chosen && !value_.isEmpty() ? "  " + value_ : QString());
            taken.push_back(plateOf(*found, label, chosen));
            shown.push_back({found, label, taken.back(), chosen});
        }
    plates_ = std::move(taken);
    // and lies on top
    for (auto one = shown.rbegin(); one != shown.rend(); ++one)
        draw(*one->dim, one->label, one->plate, one->chosen);
}

}  // namespace polyturn::hmi
