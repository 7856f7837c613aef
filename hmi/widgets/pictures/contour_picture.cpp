#include "hmi/widgets/pictures/contour_picture.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "hmi/widgets/painted.hpp"
#include "hmi/widgets/theme.hpp"

namespace polyturn::hmi {
namespace {

using contour::Kind;
using contour::Piece;
using contour::Point;

constexpr int kArcSteps = 40;

std::vector<Point> pointsOf(const Piece& p) {
    if (p.kind == Kind::Line) return {p.from, p.to};
    std::vector<Point> out;
    const double from = std::atan2(p.from.x - p.centre.x, p.from.z - p.centre.z),
                 turn = (p.kind == Kind::ArcCcw ? 1 : -1) * p.sweep * M_PI / 180;
    for (int i = 0; i <= kArcSteps; ++i) {
        const double a = from + turn * i / kArcSteps;
        out.push_back({p.centre.z + p.radius * std::cos(a), p.centre.x + p.radius * std::sin(a)});
    }
    return out;
}

Point middleOf(const Piece& p) {
    const auto points = pointsOf(p);
    return p.kind == Kind::Line ? Point{(p.from.z + p.to.z) / 2, (p.from.x + p.to.x) / 2}
                                : points[points.size() / 2];
}

}  // namespace

void ContourPicture::show(const contour::Contour& contour, const contour::Solved& solved,
                          int element) {
    contour_ = contour;
    solved_ = solved;
    element_ = element;
    update();
}

ContourPicture::View ContourPicture::view() const {
    double low[2] = {contour_.start.z - 1, std::min(0.0, contour_.start.x)},
           high[2] = {contour_.start.z + 1, contour_.start.x + 1};
    const auto look = [&](const Piece& p) {
        for (const Point& q : pointsOf(p)) {
            low[0] = std::min(low[0], q.z);
            high[0] = std::max(high[0], q.z);
            low[1] = std::min(low[1], q.x);
            high[1] = std::max(high[1], q.x);
        }
    };
    for (const Piece& p : solved_.pieces) look(p);
    for (const auto& choice : solved_.choices)
        for (const auto& one : choice.solutions)
            for (const Piece& p : one) look(p);
    const double edge = px(44);
    View v;
    v.scale = std::max(1e-6, std::min((width() - 2 * edge) / std::max(1.0, high[0] - low[0]),
                                      (height() - 2 * edge) / std::max(1.0, high[1] - low[1])));
    v.z = (low[0] + high[0]) / 2;
    v.x = (low[1] + high[1]) / 2;
    return v;
}

QPointF ContourPicture::at(const View& v, Point p) const {
    return {width() / 2.0 + (p.z - v.z) * v.scale, height() / 2.0 - (p.x - v.x) * v.scale};
}

void ContourPicture::paintEvent(QPaintEvent*) {
    const Theme& t = theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), t.window);
    QPainterPath card;
    card.addRoundedRect(rect(), px(8), px(8));
    painter.fillPath(card, t.card);
    painter.setClipPath(card);
    const View v = view();
    const auto pen = [&](const QColor& colour, double wide, Qt::PenStyle style = Qt::SolidLine) {
        QPen one(colour, wide, style);
        one.setCapStyle(Qt::RoundCap);
        one.setJoinStyle(Qt::RoundJoin);
        painter.setPen(one);
    };
    const auto draw = [&](const Piece& p) {
        QPolygonF line;
        for (const Point& q : pointsOf(p)) line << at(v, q);
        painter.drawPolyline(line);
    };
    const auto plate = [&](QPointF centre, const QString& text, const QColor& behind,
                           const QColor& colour, double units = 15) {
        painter.setFont(lettering(units, true));
        QRectF box =
            QFontMetricsF(painter.font()).boundingRect(text).adjusted(-px(6), -px(2), px(6), px(2));
        box.moveCenter(centre);
        QPainterPath path;
        path.addRoundedRect(box, px(5), px(5));
        painter.fillPath(path, behind);
        painter.setPen(colour);
        paintWords(painter, box, Qt::AlignCenter, text);
    };
    // Axes through the zero.
    pen(t.edge, px(1), Qt::DashDotLine);
    painter.drawLine(QPointF(0, at(v, {0, 0}).y()), QPointF(width(), at(v, {0, 0}).y()));
    painter.drawLine(QPointF(at(v, {0, 0}).x(), 0), QPointF(at(v, {0, 0}).x(), height()));
    // The other solutions, numbered.
    for (const auto& choice : solved_.choices)
        for (std::size_t k = 0; k < choice.solutions.size(); ++k) {
            if (k == choice.chosen) continue;
            pen(t.wait, px(2), Qt::DotLine);
            for (const Piece& p : choice.solutions[k]) draw(p);
            plate(at(v, middleOf(choice.solutions[k].back())), QString::number(k + 1), t.raised,
                  t.wait);
        }
    for (const Piece& p : solved_.pieces) {
        const bool chosen =
            static_cast<int>(p.element) == element_ && p.role == Piece::Role::Element;
        pen(chosen                           ? t.accent
            : p.role == Piece::Role::Element ? t.text
                                             : t.good,
            px(chosen ? 5 : 3));
        draw(p);
    }
    for (const auto& choice : solved_.choices)
        plate(at(v, middleOf(choice.solutions[choice.chosen].back())),
              QString::number(choice.chosen + 1), t.accent, t.onAccent);
    // Where it begins, its corners, where it is open.
    painter.setBrush(t.card);
    for (const Piece& p : solved_.pieces) {
        pen(t.dim, px(1));
        painter.drawEllipse(at(v, p.to), px(3), px(3));
    }
    const QPointF start = at(v, contour_.start);
    pen(element_ < 0 ? t.accent : t.good, px(3));
    painter.drawEllipse(start, px(6), px(6));
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < solved_.states.size(); ++i) {
        if (solved_.states[i] == contour::State::Known) continue;
        const Point from = solved_.pieces.empty() ? contour_.start : solved_.pieces.back().to;
        const contour::Element& e = contour_.elements[i];
        QPointF open = at(v, from) + QPointF(-px(34), -px(30));
        if (e.kind == Kind::Line && e.angle) {  // its direction at least is known
            const QPointF way(std::cos(*e.angle * M_PI / 180) * px(70),
                              -std::sin(*e.angle * M_PI / 180) * px(70));
            open = at(v, from) + way;
        }
        pen(t.warn, px(2), Qt::DashLine);
        painter.drawLine(at(v, from), open);
        plate(open, "?", t.warn, t.window, 17);
        break;
    }
}

std::optional<QPointF> ContourPicture::placeOf(std::size_t choice, std::size_t solution) const {
    if (choice >= solved_.choices.size() || solution >= solved_.choices[choice].solutions.size())
        return std::nullopt;
    return at(view(), middleOf(solved_.choices[choice].solutions[solution].back()));
}

void ContourPicture::mousePressEvent(QMouseEvent* event) {
    double best = px(40);
    std::optional<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t c = 0; c < solved_.choices.size(); ++c)
        for (std::size_t k = 0; k < solved_.choices[c].solutions.size(); ++k) {
            if (k == solved_.choices[c].chosen) continue;
            for (const Piece& p : solved_.choices[c].solutions[k])
                for (const Point& q : pointsOf(p)) {
                    const QPointF d = at(view(), q) - event->position();
                    if (const double away = std::hypot(d.x(), d.y()); away < best) {
                        best = away;
                        found = {c, k};
                    }
                }
            const QPointF d = *placeOf(c, k) - event->position();
            if (const double away = std::hypot(d.x(), d.y()); away < best) {
                best = away;
                found = {c, k};
            }
        }
    if (found && onChosen) onChosen(found->first, found->second);
}

}  // namespace polyturn::hmi
