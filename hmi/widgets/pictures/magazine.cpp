#include "hmi/widgets/pictures/magazine.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

namespace polyturn::hmi {
namespace {

// What is smaller cannot be read from where one stands: a place too small for such letters has its
// number and its colour, and the name is read where the places about the chosen one are drawn
// large.
constexpr double kLeastLetters = 12;     // pixels
constexpr double kNameShare = 0.135;     // of a place's side: the letters of a name
constexpr std::size_t kMostOfLoop = 40;  // places of a chain that a loop can show; more are rows
constexpr int kScrolled = 10;            // pixels beside rows of which not all are shown
constexpr double kTurn = 6.283185307179586;

bool readable(double side) { return side * kNameShare * 1.05 >= kLeastLetters; }
// Too small for the sizes of the large ones, yet a name in the least letters has room across its
// middle.
bool named(double side) { return side >= kLeastLetters * 5.2; }

std::vector<const ToolPlace*> placesOf(const Live& live, std::int32_t magazine) {
    std::vector<const ToolPlace*> out;
    for (std::size_t i = 0; i < live.places().count; ++i)
        if (live.places().places[i].magazine == magazine) out.push_back(&live.places().places[i]);
    return out;
}

}  // namespace

void Magazine::show(std::int32_t magazine) {
    if (magazine_ == magazine) return;
    magazine_ = magazine;
    pot_ = 0;
    refresh();
}

const ToolPlace* Magazine::chosen() const {
    const auto places = placesOf(live_, magazine_);
    for (const ToolPlace* one : places)
        if (one->pot == pot_) return one;
    return places.empty() ? nullptr : places.front();
}

void Magazine::choose(std::int32_t pot) {
    pot_ = pot;
    if (onChosen) onChosen();
    refresh();
}

void Magazine::turret(std::vector<Spot>& out, const std::vector<const ToolPlace*>& places) const {
    double ring = 0;  // half places all round
    bool halves = false;
    for (const ToolPlace* one : places) {
        if (!(one->state & kPlaceHalf))
            ring += 2;
        else
            halves = true;
    }
    const double side = std::min<double>(width(), height()), count = halves ? ring : ring / 2;
    const double most = side * 0.5 * std::sin(kTurn / 2 / std::max(count, 4.0)) /
                        (1 + std::sin(kTurn / 2 / std::max(count, 4.0))),
                 size = std::min<double>(most * 2 * 0.94, px(118));
    const double radius = side / 2 - size / 2 - px(4);
    const QPointF middle(width() / 2.0, height() / 2.0);
    for (const ToolPlace* one : places) {
        // the first one on top, clockwise
        const double angle = one->column / std::max(ring, 1.0) * kTurn - kTurn / 4;
        const QPointF at = middle + QPointF(std::cos(angle), std::sin(angle)) * radius;
        out.push_back({one, QRectF(at.x() - size / 2, at.y() - size / 2, size, size), true});
    }
}

// A loop of two straights and two ends: places at even distances along it.
void Magazine::chain(std::vector<Spot>& out, const std::vector<const ToolPlace*>& places) const {
    const double count = static_cast<double>(places.size());
    double size = px(96);
    const auto length = [&](double s) {
        return 2 * std::max<double>(0.0, width() - height()) +
               kTurn / 2 * (std::min<double>(width(), height()) - s);
    };
    while (size > px(30) && size * 1.06 * count > length(size)) size -= 1;
    const double r = (std::min<double>(width(), height()) - size) / 2 - px(2),
                 straight = std::max(0.0, width() - 2.0 * r - size - px(4)),
                 all = 2 * straight + kTurn * r;
    const QPointF middle(width() / 2.0, height() / 2.0);
    for (std::size_t i = 0; i < places.size(); ++i) {
        double s = all * static_cast<double>(i) / count;
        QPointF at;
        if (s < straight)
            at = {-straight / 2 + s, -r};
        else if ((s -= straight) < kTurn / 2 * r)
            at = QPointF(straight / 2, 0) + QPointF(std::sin(s / r), -std::cos(s / r)) * r;
        else if ((s -= kTurn / 2 * r) < straight)
            at = {straight / 2 - s, r};
        else {
            s -= straight;
            at = QPointF(-straight / 2, 0) + QPointF(-std::sin(s / r), std::cos(s / r)) * r;
        }
        at += middle;
        // round ones do not touch in the bends
        out.push_back({places[i], QRectF(at.x() - size / 2, at.y() - size / 2, size, size), true});
    }
}

// Within a loop whose places are too small for names: the chosen one and its neighbours, large.
void Magazine::lens(std::vector<Spot>& out, const std::vector<const ToolPlace*>& places) const {
    if (out.empty() || readable(out.front().box.width())) return;
    const double edge = out.front().box.width() + px(10), wide = width() - 2 * edge,
                 high = height() - 2 * edge;
    const double side = std::min<double>(px(130), high);
    if (!readable(side)) return;
    const auto all = static_cast<std::ptrdiff_t>(places.size()),
               count = std::min(all, static_cast<std::ptrdiff_t>(wide / (side + px(6))));
    const auto at = static_cast<std::ptrdiff_t>(std::find(places.begin(), places.end(), chosen()) -
                                                places.begin());
    const double left = width() / 2.0 - static_cast<double>(count) * (side + px(6)) / 2,
                 top = (height() - side) / 2.0;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const ToolPlace* place =
            places[static_cast<std::size_t>(((at + i - (count - 1) / 2) % all + all) % all)];
        out.push_back(
            {place, QRectF(left + static_cast<double>(i) * (side + px(6)) + px(3), top, side, side),
             false, true});
    }
}

// Rows and columns, as large as all of them have room; where that would be too small for names,
// those about the chosen place.
QRectF Magazine::grid(std::vector<Spot>& out, const std::vector<const ToolPlace*>& places) const {
    const bool matrix = static_cast<PlaceKind>(places.front()->kind) == PlaceKind::Matrix;
    const double least = std::max<double>(px(58), kLeastLetters * 5.2 + px(4)), most = px(118),
                 all = static_cast<double>(places.size());
    double columns = 1;
    if (matrix) {
        for (const ToolPlace* one : places) columns = std::max(columns, one->column / 2 + 1);
    } else {  // as few in a row as have room: large ones
        columns = std::clamp(std::floor(width() / most), 1.0, all);
        while (columns < all && width() / (columns + 1) >= least &&
               std::ceil(all / columns) * (width() / columns) > height())
            ++columns;
    }
    const auto rowOf = [&](std::size_t i) {
        return matrix ? places[i]->row / 2 : std::floor(static_cast<double>(i) / columns);
    };
    const auto columnOf = [&](std::size_t i) {
        return matrix ? places[i]->column / 2 : std::fmod(static_cast<double>(i), columns);
    };
    std::size_t at = 0;
    double rows = 1;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i]->pot == pot_) at = i;
        rows = std::max(rows, rowOf(i) + 1);
    }
    double size = std::min({most, width() / columns, height() / rows}), wide = width(),
           high = height();
    if (size < least) {  // beside it and beneath it: where those that are shown lie among all
        if (std::floor(high / least) < rows) wide -= kScrolled;
        if (std::floor(wide / least) < columns) high -= kScrolled;
        size = std::max(least, std::min(most, wide / columns));
    }
    const double shownColumns = std::clamp(std::floor(wide / size + 1e-9), 1.0, columns),
                 shownRows = std::clamp(std::floor(high / size + 1e-9), 1.0, rows);
    const auto first = [](double chosen, double shown, double every) {
        return std::clamp(std::floor(chosen - shown / 2 + 0.5), 0.0, std::max(0.0, every - shown));
    };
    const double firstRow = first(rowOf(at), shownRows, rows),
                 firstColumn = first(columnOf(at), shownColumns, columns);
    const double left = (wide - size * shownColumns) / 2,
                 top = std::max(0.0, (high - size * shownRows) / 2);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double row = rowOf(i) - firstRow, column = columnOf(i) - firstColumn;
        if (row < 0 || row >= shownRows || column < 0 || column >= shownColumns) continue;
        out.push_back({places[i],
                       QRectF(left + column * size + px(2), top + row * size + px(2), size - px(4),
                              size - px(4)),
                       false});
    }
    return QRectF(firstColumn / columns, firstRow / rows, shownColumns / columns, shownRows / rows);
}

// What part of all of them is shown.
QRectF Magazine::arrange(std::vector<Spot>& out) const {
    const QRectF whole(0, 0, 1, 1);
    const auto places = placesOf(live_, magazine_);
    if (places.empty()) return whole;
    const auto kind = static_cast<PlaceKind>(places.front()->kind);
    if (kind == PlaceKind::Turret && places.size() <= 48)
        turret(out, places);
    else if (kind == PlaceKind::Chain && places.size() <= kMostOfLoop && places.size() > 2) {
        chain(out, places);
        lens(out, places);
        // no room in the loop
        if (!named(out.front().box.width()) && !out.back().large) {
            out.clear();
            return grid(out, places);
        }
    } else {
        return grid(out, places);
    }
    return whole;
}

void Magazine::composeSpot(Writer& w, const Spot& spot) const {
    const Theme& t = theme();
    const ToolPlace& place = *spot.place;
    const QRectF& box = spot.box;
    const double side = box.width(), round = spot.round ? side / 2 : px(8);
    const ToolRow* tool = toolOf(live_, place.tool);
    const ToolPlace* bright = chosen();
    const bool here = bright == spot.place, locked = (place.state & kPlaceLocked) != 0;
    const StateWords state = tool ? toolWords(*tool) : StateWords{};
    unsigned works = 0;
    for (unsigned l = 0; l < kMaxChannels; ++l)
        if (place.tool && live_.tools().in_channel[l] == place.tool) works = l + 1;
    w.fill(box, here ? t.mark : tool ? t.raised : t.window, round);
    w.frame(box,
            here && focused ? t.accent
            : tool          ? colourOf(state.tone)
                            : t.edge,
            round,
            here   ? px(4)
            : tool ? px(2)
                   : 1);
    const double line = side * 0.2, inner = side * (spot.round ? 0.74 : 0.9),
                 left = box.center().x() - inner / 2;
    // across: number, name, sign beneath each other
    const bool full = readable(side), across = !full && named(side), small = !full && !across;
    const double number = std::max(kLeastLetters, side * (small    ? 0.3
                                                          : across ? 0.2
                                                                   : 0.16)) /
                          panelScale();
    w.text(QRectF(box.left(), box.top() + side * 0.05, side,
                  across ? side * 0.29 : std::max(line * 1.1, number * panelScale() * 1.25)),
           QString::number(place.pot), lettering(number, true), works ? t.good : t.dim,
           Qt::AlignCenter);
    if (works && full)
        w.text(QRectF(box.center().x() + side * 0.08, box.top() + side * 0.05, side * 0.34,
                      line * 1.1),
               QString("L%1").arg(works),
               lettering(std::max(kLeastLetters, side * 0.13) / panelScale(), true), t.good,
               Qt::AlignCenter);
    if (locked)
        w.sign(QRectF(box.center().x() - side * 0.12,
                      box.center().y() - side * (across && tool ? -0.12 : 0.12), side * 0.24,
                      side * 0.24),
               Sign::Lock, t.bad);
    if (!tool) return;
    const double sign = side * (small ? 0.32 : 0.22);
    const double part = lifeLeft(*tool);
    if (across) {
        const double room = side * 0.94, lines = kLeastLetters * 1.3;
        w.data(QRectF(box.center().x() - room / 2, box.center().y() - lines / 2 - side * 0.02, room,
                      lines),
               toolName(*tool, place.tool),
               lettering(kLeastLetters / panelScale(), false, Face::Condensed), t.text,
               Qt::AlignCenter);
        if (!locked)
            w.sign(QRectF(box.center().x() - sign / 2, box.top() + side * 0.61, sign, sign),
                   state.sign, colourOf(state.tone));
        if (part >= 0)
            w.bar(
                QRectF(box.center().x() - side * 0.22, box.top() + side * 0.86, side * 0.44, px(5)),
                part, colourOf(lifeTone(*tool)), t.edge);
        return;
    }
    if (!small)
        w.data(QRectF(left, box.top() + side * 0.27, inner, line), toolName(*tool, place.tool),
               lettering(std::max(kLeastLetters, side * kNameShare) / panelScale(), false,
                         Face::Condensed),
               t.text, Qt::AlignCenter);
    if (!locked)
        w.sign(QRectF(box.center().x() - sign / 2, box.top() + side * (small ? 0.42 : 0.47), sign,
                      sign),
               state.sign, colourOf(state.tone));
    if (part >= 0)
        w.bar(QRectF(box.center().x() - side * 0.27, box.top() + side * 0.76, side * 0.54,
                     std::max<double>(px(5), side * 0.06)),
              part, colourOf(lifeTone(*tool)), t.edge);
}

void Magazine::compose(Writer& w) {
    const Theme& t = theme();
    w.fill(QRectF(0, 0, width(), height()), t.window);
    std::vector<Spot> spots;
    const QRectF part = arrange(spots);
    // as a list has it
    if (part.height() < 1)
        w.fill(QRectF(width() - px(6), height() * part.top(), px(6), height() * part.height()),
               t.edge, px(3));
    if (part.width() < 1)
        w.fill(QRectF(width() * part.left(), height() - px(6), width() * part.width(), px(6)),
               t.edge, px(3));
    if (spots.empty()) {
        Item& item =
            w.text(QRectF(px(20), height() / 2.0 - px(60), width() - px(40), px(120)),
                   live_.connected()
                       ? word("This machine has no magazine: PT_TURRET_MAGAZINE and N2905 to N2922 "
                              "describe it.")
                       : QString(),
                   lettering(16), t.dim, Qt::AlignCenter);
        item.wraps = true;
        return;
    }
    // in the middle of a turret and of a chain: the chosen place, in letters that are read from
    // afar
    if (spots.front().round) {
        const double side = std::min<double>(width(), height()), size = spots.front().box.width(),
                     hub = side / 2 - size - px(10);
        const QPointF middle(width() / 2.0, height() / 2.0);
        if (static_cast<PlaceKind>(spots.front().place->kind) == PlaceKind::Turret) {
            w.fill(QRectF(middle.x() - side / 2, middle.y() - side / 2, side, side), t.card,
                   side / 2);
            w.fill(QRectF(middle.x() - hub, middle.y() - hub, 2 * hub, 2 * hub), t.window, hub);
        }
        const ToolPlace* bright = chosen();
        const ToolRow* tool = bright ? toolOf(live_, bright->tool) : nullptr;
        const auto large =
            std::find_if(spots.begin(), spots.end(), [](const Spot& one) { return one.large; });
        const double below = large == spots.end() ? 0 : large->box.bottom();
        if (below == 0) {
            w.text(QRectF(middle.x() - hub, middle.y() - px(62), 2 * hub, px(50)),
                   bright ? QString::number(bright->pot) : QString(), lettering(40, true), t.text,
                   Qt::AlignCenter);
            w.data(QRectF(middle.x() - hub * 0.9, middle.y() - px(8), 1.8 * hub, px(26)),
                   tool ? toolName(*tool, bright->tool) : word("empty"), lettering(17, true),
                   tool ? t.text : t.dim, Qt::AlignCenter);
        }
        if (tool && below > 0) {  // the name stands in the large place
            const StateWords state = toolWords(*tool);
            const QString life = lifeText(*tool);
            if (below + px(28) < height() - size)
                w.text(QRectF(size, below + px(2), width() - 2 * size, px(24)),
                       state.text + (life.isEmpty() ? QString() : "   " + life), lettering(15),
                       colourOf(state.tone), Qt::AlignCenter);
        } else if (tool) {
            const StateWords state = toolWords(*tool);
            w.sign(QRectF(middle.x() - px(11), middle.y() + px(22), px(22), px(22)), state.sign,
                   colourOf(state.tone));
            w.text(QRectF(middle.x() - hub * 0.9, middle.y() + px(46), 1.8 * hub, px(24)),
                   state.text, lettering(15), colourOf(state.tone), Qt::AlignCenter);
            w.text(QRectF(middle.x() - hub * 0.9, middle.y() + px(70), 1.8 * hub, px(24)),
                   lifeText(*tool), lettering(15), t.dim, Qt::AlignCenter);
        }
    }
    for (const Spot& spot : spots) {
        composeSpot(w, spot);
        w.hit(spot.box, placeHit(spot.place->pot));
    }
    if (spots.size() == 1) {  // a spindle's place, or one for a tool of another size
        const ToolRow* tool = toolOf(live_, spots.front().place->tool);
        if (static_cast<PlaceKind>(spots.front().place->kind) == PlaceKind::Spindle)
            w.text(QRectF(0, spots.front().box.top() - px(38), width(), px(28)), word("Spindle"),
                   lettering(17, true), t.text, Qt::AlignCenter);
        w.text(QRectF(0, spots.front().box.bottom() + px(10), width(), px(28)),
               tool ? toolWords(*tool).text : word("empty"), lettering(17, true),
               tool ? colourOf(toolWords(*tool).tone) : t.dim, Qt::AlignCenter);
    }
    if (carried) {
        const ToolRow* tool = toolOf(live_, carried);
        const QRectF box(px(8), height() - px(40), width() - px(16), px(34));
        w.fill(box, t.mark, px(6));
        w.frame(box, t.accent, px(6), px(2));
        w.data(box.adjusted(px(10), 0, -px(10), 0),
               word("%1: choose its place, Enter puts it there, Escape leaves it")
                   .arg(tool ? toolName(*tool, carried) : QString()),
               lettering(14.5, true), t.text, Qt::AlignCenter);
    }
}

const ToolPlace* Magazine::placeAt(const QPointF& point) const {
    std::vector<Spot> spots;
    arrange(spots);
    for (const Spot& spot : spots)
        if (spot.box.contains(point)) return spot.place;
    return nullptr;
}

bool Magazine::key(QKeyEvent* event) {
    const auto places = placesOf(live_, magazine_);
    if (places.empty()) return false;
    const ToolPlace* now = chosen();
    const auto at = static_cast<std::ptrdiff_t>(std::find(places.begin(), places.end(), now) -
                                                places.begin()),
               all = static_cast<std::ptrdiff_t>(places.size());
    std::ptrdiff_t row = 1;  // places in a row of a matrix
    if (static_cast<PlaceKind>(now->kind) == PlaceKind::Matrix)
        row = std::count_if(places.begin(), places.end(),
                            [&](const ToolPlace* one) { return one->row == places.front()->row; });
    const auto go = [&](std::ptrdiff_t step) {
        choose(places[static_cast<std::size_t>(((at + step) % all + all) % all)]->pot);
    };
    switch (event->key()) {
        case Qt::Key_Right:
            go(1);
            return true;
        case Qt::Key_Left:
            go(-1);
            return true;
        case Qt::Key_Down:
            go(row);
            return true;
        case Qt::Key_Up:
            go(-row);
            return true;
        case Qt::Key_Home:
            choose(places.front()->pot);
            return true;
        case Qt::Key_End:
            choose(places.back()->pot);
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (onActivated) onActivated();
            return true;
        default:
            return false;
    }
}

void Magazine::mousePressEvent(QMouseEvent* event) {
    down_ = event->position();
    pressed_ = true;
    dragging_ = false;
    const ToolPlace* place = placeAt(down_);
    lifted_ = place ? place->tool : 0;
}

void Magazine::mouseMoveEvent(QMouseEvent* event) {
    if (!lifted_ || dragging_ || (event->position() - down_).manhattanLength() < px(14)) return;
    dragging_ = true;
    if (onLifted) onLifted(lifted_);
    refresh();
}

void Magazine::mouseReleaseEvent(QMouseEvent* event) {
    if (!std::exchange(pressed_, false)) return;
    const std::int32_t tool = std::exchange(lifted_, 0);
    if (std::exchange(dragging_, false)) {
        if (onDropped) onDropped(tool, event->globalPosition().toPoint());
        return;
    }
    const ToolPlace* place = placeAt(event->position());
    if (!place) return;
    const ToolPlace* before = chosen();
    const bool again = focused && before == place;
    choose(place->pot);
    if (carried || again)
        if (onActivated) onActivated();
}

}  // namespace polyturn::hmi
