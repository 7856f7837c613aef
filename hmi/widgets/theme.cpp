#include "hmi/widgets/theme.hpp"

#include <QFontDatabase>
#include <QPainterPath>
#include <unordered_map>

namespace polyturn::hmi {
namespace {

const Theme kDark{true,      "#11161b", "#0b0f13", "#1a2128", "#252e37", "#323e4a",
                  "#eef3f7", "#b0bdc9", "#94a3b1", "#4ea6ff", "#06121e", "#42c883",
                  "#f5b83d", "#ff7d77", "#b896ff", "#1f3a55"};
const Theme kLight{false,     "#e6ebf0", "#d5dce3", "#ffffff", "#eef2f6", "#c3ccd5",
                   "#141d26", "#44525f", "#525f6b", "#0858a8", "#ffffff", "#0e6a34",
                   "#855100", "#b8221e", "#6d38b5", "#d7e8fa"};
const Theme* g_theme = &kDark;
double g_scale = 1.0;

QString family(Face face) {
    static const QStringList have = QFontDatabase::families();
    const auto first = [](std::initializer_list<const char*> wanted) {
        for (const char* one : wanted)
            if (have.contains(QString(one))) return QString(one);
        return QString("Sans");
    };
    switch (face) {
        case Face::Condensed:
            return first({"Roboto Condensed", "DejaVu Sans Condensed"});
        case Face::Program:
            return first({"DejaVu Sans Mono", "Monospace"});
        case Face::Text:
            break;
    }
    return first({"Roboto", "DejaVu Sans"});
}

}  // namespace

const Theme& theme() { return *g_theme; }

QColor colourOf(Tone tone) {
    const Theme& t = theme();
    switch (tone) {
        case Tone::Good:
            return t.good;
        case Tone::Waiting:
            return t.wait;
        case Tone::Warning:
            return t.warn;
        case Tone::Bad:
            return t.bad;
        case Tone::Note:
            return t.accent;
        case Tone::Quiet:
            return t.dim;
        case Tone::None:
            break;
    }
    return t.edge;
}
void dress(bool dark) { g_theme = dark ? &kDark : &kLight; }
void setPanelScale(double scale) { g_scale = scale; }
double panelScale() { return g_scale; }

// Made once each: a font is asked for hundreds of times a frame, and two copies of one are compared
// by a look at their address.
QFont lettering(double units, bool bold, Face face) {
    static std::unordered_map<int, QFont> made;
    const int size = std::max(6, px(units)),
              key = size * 8 + static_cast<int>(face) * 2 + (bold ? 1 : 0);
    if (const auto at = made.find(key); at != made.end()) return at->second;
    static const QString names[] = {family(Face::Text), family(Face::Condensed),
                                    family(Face::Program)};
    QFont out(names[static_cast<std::size_t>(face)]);
    out.setPixelSize(size);
    out.setWeight(bold ? QFont::Bold : QFont::Normal);
    return made.emplace(key, out).first->second;
}

// Drawn in a square of 24 units.
void drawSign(QPainter& p, const QRectF& box, Sign sign, const QColor& colour) {
    if (sign == Sign::None) return;
    p.save();
    p.setRenderHint(QPainter::Antialiasing);
    const double side = std::min(box.width(), box.height());
    p.translate(box.center().x() - side / 2, box.center().y() - side / 2);
    p.scale(side / 24, side / 24);
    const QPen line(colour, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    p.setPen(line);
    p.setBrush(Qt::NoBrush);
    const auto solid = [&] {
        p.setPen(Qt::NoPen);
        p.setBrush(colour);
    };
    const auto polygon = [&](std::initializer_list<QPointF> points) {
        p.drawPolygon(QPolygonF(QList<QPointF>(points)));
    };
    const auto polyline = [&](std::initializer_list<QPointF> points) {
        p.drawPolyline(QPolygonF(QList<QPointF>(points)));
    };
    const auto hole = [&] {
        p.setBrush(p.background());
        p.setPen(QPen(theme().card, 2.4, Qt::SolidLine, Qt::RoundCap));
    };
    switch (sign) {
        case Sign::Run:
            solid();
            polygon({{6, 3.5}, {20, 12}, {6, 20.5}});
            break;
        case Sign::Hold:
            solid();
            p.drawRect(QRectF(5.5, 4, 4.5, 16));
            p.drawRect(QRectF(14, 4, 4.5, 16));
            break;
        case Sign::Wait:
            polygon({{6, 3}, {18, 3}, {6, 21}, {18, 21}});
            break;
        case Sign::Stop:
            solid();
            polygon({{12, 3}, {21, 12}, {12, 21}, {3, 12}});
            break;
        case Sign::Ended:
            polyline({{4, 12.5}, {10, 18.5}, {20.5, 6}});
            break;
        case Sign::Good:
            polyline({{4, 12.5}, {10, 18.5}, {20.5, 6}});
            break;
        case Sign::Alarm:
            solid();
            polygon({{8, 2.5},
                     {16, 2.5},
                     {21.5, 8},
                     {21.5, 16},
                     {16, 21.5},
                     {8, 21.5},
                     {2.5, 16},
                     {2.5, 8}});
            hole();
            p.drawLine(QPointF(8, 8), QPointF(16, 16));
            p.drawLine(QPointF(16, 8), QPointF(8, 16));
            break;
        case Sign::Warning:
            solid();
            polygon({{12, 2.5}, {22.5, 21}, {1.5, 21}});
            hole();
            p.drawLine(QPointF(12, 9.5), QPointF(12, 14.5));
            p.drawPoint(QPointF(12, 18));
            break;
        case Sign::Note:
            solid();
            p.drawEllipse(QPointF(12, 12), 9.5, 9.5);
            hole();
            p.drawLine(QPointF(12, 11), QPointF(12, 17));
            p.drawPoint(QPointF(12, 7));
            break;
        case Sign::Reset:
            solid();
            p.drawRect(QRectF(5.5, 5.5, 13, 13));
            break;
        case Sign::Off:
            p.drawArc(QRectF(4, 4.5, 16, 16), 125 * 16, 290 * 16);
            p.drawLine(QPointF(12, 2.5), QPointF(12, 11));
            break;
        case Sign::Overview:
            p.drawRoundedRect(QRectF(3, 4, 8, 16), 1.5, 1.5);
            p.drawRoundedRect(QRectF(13, 4, 8, 16), 1.5, 1.5);
            p.drawLine(QPointF(5.5, 8.5), QPointF(8.5, 8.5));
            p.drawLine(QPointF(15.5, 8.5), QPointF(18.5, 8.5));
            break;
        case Sign::Manual:
            p.drawLine(QPointF(12, 3), QPointF(12, 21));
            p.drawLine(QPointF(3, 12), QPointF(21, 12));
            polyline({{9, 6}, {12, 3}, {15, 6}});
            polyline({{9, 18}, {12, 21}, {15, 18}});
            polyline({{6, 9}, {3, 12}, {6, 15}});
            polyline({{18, 9}, {21, 12}, {18, 15}});
            break;
        case Sign::Programs:
            polyline({{14, 3}, {5, 3}, {5, 21}, {19, 21}, {19, 8}, {14, 3}, {14, 8}, {19, 8}});
            p.drawLine(QPointF(8.5, 12.5), QPointF(15.5, 12.5));
            p.drawLine(QPointF(8.5, 16.5), QPointF(13, 16.5));
            break;
        case Sign::Offsets:
            polyline({{4, 3}, {4, 20}, {21, 20}});
            p.drawLine(QPointF(9, 20), QPointF(9, 17));
            p.drawLine(QPointF(14, 20), QPointF(14, 17));
            p.drawLine(QPointF(4, 15), QPointF(7, 15));
            p.drawLine(QPointF(4, 10), QPointF(7, 10));
            polygon({{11, 12}, {19, 4}, {20, 9}, {16, 13}});
            break;
        case Sign::Tools:
            p.drawEllipse(QPointF(12, 12), 4, 4);
            for (int k = 0; k < 6; ++k) {
                p.drawLine(QPointF(12, 5.5), QPointF(12, 2.5));
                p.translate(12, 12);
                p.rotate(60);
                p.translate(-12, -12);
            }
            p.drawEllipse(QPointF(12, 12), 9.5, 9.5);
            break;
        case Sign::Parameters:
            for (const double y : {6.0, 12.0, 18.0}) p.drawLine(QPointF(3, y), QPointF(21, y));
            p.setBrush(theme().bar);
            p.drawEllipse(QPointF(8, 6), 2.4, 2.4);
            p.drawEllipse(QPointF(16, 12), 2.4, 2.4);
            p.drawEllipse(QPointF(10, 18), 2.4, 2.4);
            break;
        case Sign::Graphics:
            polyline({{3, 19}, {8, 19}, {8, 14}, {13, 14}, {13, 9}, {18, 9}, {21, 5}});
            p.drawLine(QPointF(3, 22), QPointF(21, 22));
            break;
        case Sign::Bell: {
            QPainterPath path(QPointF(5, 17.5));
            path.cubicTo(8, 14, 6, 4.5, 12, 4.5);
            path.cubicTo(18, 4.5, 16, 14, 19, 17.5);
            path.closeSubpath();
            p.drawPath(path);
            p.drawArc(QRectF(9.5, 16, 5, 5), 180 * 16, 180 * 16);
            break;
        }
        case Sign::Left:
            polyline({{15, 4}, {7, 12}, {15, 20}});
            break;
        case Sign::Undo: {  // an arrow that turns back
            QPainterPath path({4, 9});
            path.lineTo(14.5, 9);
            path.arcTo(QRectF(8.5, 9, 11.5, 11.5), 90, -180);
            path.lineTo(8, 20.5);
            p.drawPath(path);
            polyline({{9, 4}, {4, 9}, {9, 14}});
            break;
        }
        case Sign::Right:
            polyline({{9, 4}, {17, 12}, {9, 20}});
            break;
        case Sign::Up:
            polyline({{4, 16}, {12, 7}, {20, 16}});
            break;
        case Sign::Down:
            polyline({{4, 8}, {12, 17}, {20, 8}});
            break;
        case Sign::Lock:
            p.drawRoundedRect(QRectF(4.5, 10.5, 15, 10.5), 2, 2);
            p.drawArc(QRectF(7.5, 3, 9, 14), 0, 180 * 16);
            break;
        case Sign::Sun:
            p.drawEllipse(QPointF(12, 12), 4.2, 4.2);
            for (int k = 0; k < 8; ++k) {
                p.drawLine(QPointF(12, 4), QPointF(12, 2));
                p.translate(12, 12);
                p.rotate(45);
                p.translate(-12, -12);
            }
            break;
        case Sign::Moon: {
            QPainterPath path;
            path.addEllipse(QPointF(12, 12), 9, 9);
            QPainterPath bite;
            bite.addEllipse(QPointF(16.5, 9), 7.5, 7.5);
            p.drawPath(path.subtracted(bite));
            break;
        }
        case Sign::DisplayLanguage:
            p.drawEllipse(QPointF(12, 12), 9.2, 9.2);
            p.drawEllipse(QPointF(12, 12), 4, 9.2);
            p.drawLine(QPointF(3, 12), QPointF(21, 12));
            break;
        case Sign::Key:
            p.drawEllipse(QPointF(7.5, 12), 4, 4);
            polyline({{11.5, 12}, {21, 12}, {21, 16}});
            p.drawLine(QPointF(17, 12), QPointF(17, 15));
            break;
        case Sign::Spindle:
            p.drawArc(QRectF(4, 4, 16, 16), 40 * 16, 280 * 16);
            polyline({{14.5, 3}, {19, 6.5}, {15, 10}});
            break;
        case Sign::Feed:
            p.drawLine(QPointF(3, 12), QPointF(20, 12));
            polyline({{14, 6}, {20.5, 12}, {14, 18}});
            break;
        case Sign::Help:
            p.drawEllipse(QPointF(12, 12), 9.5, 9.5);
            p.drawArc(QRectF(8.8, 6, 6.4, 6.4), -70 * 16, 250 * 16);
            p.drawLine(QPointF(12.6, 12.4), QPointF(12, 14.5));
            p.drawPoint(QPointF(12, 17.8));
            break;
        case Sign::Diagnosis:  // a pulse on a screen
            p.drawRoundedRect(QRectF(2, 3.5, 20, 17), 2.5, 2.5);
            polyline(
                {{4.5, 13}, {8, 13}, {10, 7.5}, {13.5, 17}, {15.5, 11}, {16.5, 13}, {19.5, 13}});
            break;
        case Sign::Bin:
            p.drawLine(QPointF(4, 6.5), QPointF(20, 6.5));
            polyline({{9, 6}, {9.5, 3}, {14.5, 3}, {15, 6}});
            polyline({{6, 7}, {7, 21}, {17, 21}, {18, 7}});
            p.drawLine(QPointF(10.3, 11), QPointF(10.6, 17));
            p.drawLine(QPointF(13.7, 11), QPointF(13.4, 17));
            break;
        case Sign::None:
            break;
    }
    p.restore();
}

}  // namespace polyturn::hmi
