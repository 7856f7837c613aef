#include "hmi/screens/programs/contour_page.hpp"

#include <QKeyEvent>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {
namespace {

using contour::Element;
using contour::Kind;
using contour::State;

enum class Special : std::uint8_t {
    None,
    StartZ,
    StartX,
    Approach,
    First,
    Last,
    Tangent,
    Chamfer,
    Round
};

}  // namespace

struct ContourPage::Datum {
    const char* name;
    const char* meaning;
    const char* unit;
    std::optional<double> Element::*value = nullptr;
    Special special = Special::None;
    bool x = false;  // shown as the channel counts X
};

const std::vector<ContourPage::Datum>& ContourPage::dataOf(int kind) {
    static const std::vector<Datum> kStart{
        {"Z", WORD("Start point Z"), "mm", nullptr, Special::StartZ},
        {"X", WORD("Start point X"), "mm", nullptr, Special::StartX, true},
        {"G", WORD("To the start: 0 not, 1 feed, 2 rapid"), "", nullptr, Special::Approach},
        {"P", WORD("Number of its first block"), "N", nullptr, Special::First},
        {"Q", WORD("Number of its last block"), "N", nullptr, Special::Last}};
    static const Datum kEnd[] = {{"Z", WORD("End point Z"), "mm", &Element::z},
                                 {"X", WORD("End point X"), "mm", &Element::x, Special::None, true},
                                 {"dZ", WORD("Increment in Z"), "mm", &Element::dz},
                                 {"dX", WORD("Increment in X (radius)"), "mm", &Element::dx}};
    static const Datum kBetween[] = {
        {"T", WORD("Tangential to the one before (1: yes)"), "", nullptr, Special::Tangent},
        {"CH", WORD("Chamfer to the next one"), "mm", nullptr, Special::Chamfer},
        {"RD", WORD("Rounding to the next one"), "mm", nullptr, Special::Round}};
    static const std::vector<Datum> kLine = [] {
        std::vector<Datum> out(std::begin(kEnd), std::end(kEnd));
        out.push_back({"L", WORD("Length"), "mm", &Element::length});
        out.push_back({"A", WORD("Angle to +Z"), "°", &Element::angle});
        out.insert(out.end(), std::begin(kBetween), std::end(kBetween));
        return out;
    }();
    static const std::vector<Datum> kArc = [] {
        std::vector<Datum> out{{"R", WORD("Radius"), "mm", &Element::radius}};
        out.insert(out.end(), std::begin(kEnd), std::end(kEnd));
        out.push_back({"CZ", WORD("Centre Z"), "mm", &Element::centre_z});
        out.push_back({"CX", WORD("Centre X"), "mm", &Element::centre_x, Special::None, true});
        out.push_back({"A", WORD("Angle at its start to +Z"), "°", &Element::angle});
        out.push_back({"E", WORD("Angle at its end to +Z"), "°", &Element::end_angle});
        out.push_back({"S", WORD("Angle it turns through"), "°", &Element::sweep});
        out.insert(out.end(), std::begin(kBetween), std::end(kBetween));
        return out;
    }();
    return kind < 0 ? kStart : kind == static_cast<int>(Kind::Line) ? kLine : kArc;
}

contour::Writing contourWriting(const Live& live, unsigned channel, const QString& language) {
    contour::Writing out;
    using Language = contour::Writing::Language;
    out.language = language == "sinumerik" ? Language::Sinumerik
                   : language == "fagor"   ? Language::Fagor
                                           : Language::Family;
    if (live.connected())
        for (std::size_t i = 0; i < live.config().last_axis; ++i)
            if (const auto& axis = live.config().axes[i];
                axis.exists() && axis.channel == channel && axis.name_text() == "X")
                out.diameter = axis.diameter;
    if (live.connected())
        out.decimals =
            std::clamp(static_cast<int>(live.config().channel(channel).decimals()), 1, 6);
    const params::Table& t = live.table();
    const bool system_a = language == "fanuc" && !params::bit(t, params::f3401, channel, 6) &&
                          !params::bit(t, params::f3401, channel, 7);
    out.says_absolute = !system_a;
    return out;
}

ContourPage::ContourPage(Context& context, QWidget* parent)
    : EditorOverlay(parent),
      context_(context),
      elements_(new Table(this)),
      data_(new Table(this)),
      pad_(new NumberPad(this)),
      picture_(new ContourPicture(this)),
      note_(new FreeSheet(this)) {
    elements_->columns = {{word("Contour"), 1}, {word("Given"), 1.7}};
    elements_->rowUnits = 42;
    elements_->textUnits = 15;
    elements_->rows = [this] { return static_cast<int>(now_.contour.elements.size()) + 1; };
    elements_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        if (row == 0) {
            if (column == 0) return {word("Start"), t.text, Sign::Good, true};
            return {QString("Z%1 X%2")
                        .arg(now_.contour.start.z)
                        .arg(now_.contour.start.x * (writing_.diameter ? 2 : 1)),
                    t.dim};
        }
        const auto i = static_cast<std::size_t>(row - 1);
        const Element& e = now_.contour.elements[i];
        if (column == 1) return {summary(e), t.dim, Sign::None, false, Face::Text, {}, 13.5};
        const State state = i < solved_.states.size() ? solved_.states[i] : State::Open;
        const QString kind = e.kind == Kind::Line    ? word("Line")
                             : e.kind == Kind::ArcCw ? word("Arc G2")
                                                     : word("Arc G3");
        return {QString("%1  %2").arg(row).arg(kind),
                state == State::Known  ? t.text
                : state == State::Open ? t.warn
                                       : t.bad,
                state == State::Known  ? Sign::Good
                : state == State::Open ? Sign::Wait
                                       : Sign::Alarm,
                true};
    };
    elements_->onChosen = [this] {
        pad_->clear();
        data_->choose(0);
        refresh();
    };
    data_->columns = {{word("Field"), 0.7},
                      {word("Meaning"), 2.8},
                      {word("Value"), 1.2, Qt::AlignRight | Qt::AlignVCenter}};
    data_->rowUnits = 34;
    data_->textUnits = 15;
    data_->rows = [this] {
        return static_cast<int>(
            dataOf(elements_->row() == 0
                       ? -1
                       : static_cast<int>(
                             now_.contour.elements[static_cast<std::size_t>(elements_->row() - 1)]
                                 .kind))
                .size());
    };
    data_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        const Datum& one =
            dataOf(elements_->row() == 0
                       ? -1
                       : static_cast<int>(
                             now_.contour.elements[static_cast<std::size_t>(elements_->row() - 1)]
                                 .kind))[static_cast<std::size_t>(row)];
        const auto held = value(one);
        if (column == 0) return {one.name, t.accent, Sign::None, true};
        if (column == 1)
            return {word(one.meaning) +
                        (one.x && writing_.diameter ? QString::fromUtf8(" ⌀") : QString()),
                    held ? t.text : t.dim,
                    Sign::None,
                    false,
                    Face::Text,
                    {},
                    14};
        return {held ? QString("%1 %2").arg(*held, 0, 'g', 9).arg(unitOf(one)).trimmed()
                     : QString::fromUtf8("–"),
                held ? t.text : t.faint, Sign::None, held.has_value()};
    };
    data_->onChosen = [this] { pad_->clear(); };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const Datum* one = datum();
        if (!one) return std::nullopt;
        return NumberPad::Field{QString(one->name) + "  " + word(one->meaning), unitOf(*one),
                                value(*one).value_or(0.0), writing_.inch ? 4u : 3u};
    };
    pad_->onInput = [this](double number) { input(number); };
    picture_->onChosen = [this](std::size_t choice, std::size_t solution) {
        choose(choice, solution);
    };
    note_->onCompose = [this](Writer& w) { composeNote(w); };
}

void ContourPage::open(const QStringList& lines, int cursor, contour::Writing writing) {
    lines_.clear();
    for (const QString& line : lines) lines_.push_back(line.toStdString());
    cursor_ = cursor;
    // What the program has said above decides: diameters, the distance mode.
    static const QRegularExpression kDiameter("\\b(?:DIAMON|DIAM90|G151)\\b"),
        kRadius("\\b(?:DIAMOF|G152)\\b");
    for (int at = std::min(cursor, static_cast<int>(lines.size()) - 1); at >= 0; --at) {
        if (lines[at].contains(kDiameter))
            writing.diameter = true;
        else if (lines[at].contains(kRadius))
            writing.diameter = false;
        else
            continue;
        break;
    }
    writing_ = writing;
    place_ = contour::find_contour(lines_, cursor);
    hint_.clear();
    edited_ = false;
    now_ = {};
    now_.contour.start = {0.0, writing.inch ? 0.5 : 10.0};
    if (place_.to >= place_.from) {
        int fault = -1;
        if (const auto found = contour::read_contour(lines_, place_, writing_, &fault)) {
            now_ = *found;
            const std::vector<std::string> there(lines_.begin() + place_.from,
                                                 lines_.begin() + place_.to + 1);
            edited_ = there != contour::write_contour(now_, contour::solve(now_.contour), writing_);
        } else {
            hint_ = word("Line %1 of the description cannot be read: a new contour begins here.")
                        .arg(fault + 1);
            place_ = {};
        }
    }
    before_ = now_;
    solved_ = contour::solve(now_.contour);  // choosing an element shows its state at once
    elements_->choose(now_.contour.elements.empty() ? 0 : 1);
    data_->choose(0);
    pad_->clear();
    changed();
}

void ContourPage::load(const contour::Description& description) {
    now_ = description;
    solved_ = contour::solve(now_.contour);
    elements_->choose(static_cast<int>(now_.contour.elements.size()));
    changed();
}

// Lengths as the program counts them, whatever the screens show.
QString ContourPage::unitOf(const Datum& datum) const {
    return unitWord(writing_.inch && std::string_view(datum.unit) == "mm" ? "inch" : datum.unit);
}

const ContourPage::Datum* ContourPage::datum() const {
    const auto& all = dataOf(
        elements_->row() == 0
            ? -1
            : static_cast<int>(
                  now_.contour.elements[static_cast<std::size_t>(elements_->row() - 1)].kind));
    const auto row = static_cast<std::size_t>(std::max(0, data_->row()));
    return row < all.size() ? &all[row] : nullptr;
}

int ContourPage::rowOf(const char* name) const {
    const auto& all = dataOf(
        elements_->row() == 0
            ? -1
            : static_cast<int>(
                  now_.contour.elements[static_cast<std::size_t>(elements_->row() - 1)].kind));
    for (std::size_t i = 0; i < all.size(); ++i)
        if (QString(all[i].name) == name) return static_cast<int>(i);
    return -1;
}

Element* ContourPage::element() {
    return elements_->row() == 0
               ? nullptr
               : &now_.contour.elements[static_cast<std::size_t>(elements_->row() - 1)];
}

std::optional<double> ContourPage::value(const Datum& one) const {
    const double scale = one.x && writing_.diameter ? 2.0 : 1.0;
    const Element* e = const_cast<ContourPage*>(this)->element();
    const auto over0 = [](double v) { return v > 0 ? std::optional(v) : std::nullopt; };
    switch (one.special) {
        case Special::StartZ:
            return now_.contour.start.z;
        case Special::StartX:
            return now_.contour.start.x * scale;
        case Special::Approach:
            return now_.approach;
        case Special::First:
            return over0(static_cast<double>(now_.first));
        case Special::Last:
            return over0(static_cast<double>(now_.last));
        case Special::Tangent:
            return e->tangent ? std::optional(1.0) : std::nullopt;
        case Special::Chamfer:
            return over0(e->chamfer);
        case Special::Round:
            return over0(e->round);
        case Special::None:
            break;
    }
    const auto held = e->*one.value;
    return held ? std::optional(*held * scale) : std::nullopt;
}

void ContourPage::put(const Datum& one, std::optional<double> number) {
    const double scale = one.x && writing_.diameter ? 0.5 : 1.0;
    const double v = number.value_or(0.0);
    Element* e = element();
    switch (one.special) {
        case Special::StartZ:
            now_.contour.start.z = v;
            return;
        case Special::StartX:
            now_.contour.start.x = v * scale;
            return;
        case Special::Approach:
            now_.approach = std::clamp(static_cast<int>(v), 0, 2);
            return;
        case Special::First:
            now_.first = std::max(0L, std::lround(v));
            return;
        case Special::Last:
            now_.last = std::max(0L, std::lround(v));
            return;
        case Special::Tangent:
            e->tangent = v != 0;
            return;
        case Special::Chamfer:
            e->chamfer = std::max(0.0, v);
            e->round = v > 0 ? 0.0 : e->round;
            return;
        case Special::Round:
            e->round = std::max(0.0, v);
            e->chamfer = v > 0 ? 0.0 : e->chamfer;
            return;
        case Special::None:
            break;
    }
    e->*one.value = number ? std::optional(v * scale) : std::nullopt;
    e->solution = 0;
}

void ContourPage::input(std::optional<double> number) {
    const Datum* one = datum();
    if (!one) return;
    const bool positive = one->value == &Element::radius || one->value == &Element::length ||
                          one->value == &Element::sweep || one->special == Special::Chamfer ||
                          one->special == Special::Round;
    if (number && positive && *number <= 0)
        return context_.tell(word("Only more than 0 is possible here."), Told::Refused);
    if (number && one->value == &Element::sweep && *number >= 360)
        return context_.tell(word("An arc turns through less than 360°."), Told::Refused);
    put(*one, number);
    changed();
    if (number && data_->row() + 1 < data_->rows()) data_->choose(data_->row() + 1);
    refresh();
}

void ContourPage::add(Kind kind) {
    const int row = elements_->row();
    Element fresh;
    fresh.kind = kind;
    now_.contour.elements.insert(now_.contour.elements.begin() + row, fresh);
    changed();
    elements_->choose(row + 1);
    refresh();
}

void ContourPage::remove() {
    if (elements_->row() == 0) return;
    now_.contour.elements.erase(now_.contour.elements.begin() + (elements_->row() - 1));
    solved_ = contour::solve(now_.contour);
    elements_->choose(std::min(elements_->row(), static_cast<int>(now_.contour.elements.size())));
    data_->choose(0);
    changed();
}

void ContourPage::choose(std::size_t choice, std::size_t solution) {
    if (choice >= solved_.choices.size()) return;
    now_.contour.elements[solved_.choices[choice].last].solution = static_cast<int>(solution);
    changed();
}

void ContourPage::changed() {
    solved_ = contour::solve(now_.contour);
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

QString ContourPage::stateText(std::size_t i) const {
    switch (solved_.states[i]) {
        case State::Known:
            return {};
        case State::Open:
            return solved_.missing[i] > 0
                       ? word("Open: %1 more data are needed, here or in the next elements.")
                             .arg(solved_.missing[i])
                       : word("Open: what lies before it is not known yet.");
        case State::Contradiction:
            return word("Its data contradict each other, or nothing fits them.");
        case State::NoRoom:
            return word("Chamfer or rounding has no room here.");
        case State::NothingBefore:
            return word("Tangential to what? Nothing lies before it.");
    }
    return {};
}

QString ContourPage::summary(const Element& e) const {
    QString out;
    for (const Datum& one : dataOf(static_cast<int>(e.kind))) {
        std::optional<double> v;
        if (one.value && e.*one.value)
            v = *(e.*one.value) * (one.x && writing_.diameter ? 2.0 : 1.0);
        else if (one.special == Special::Chamfer && e.chamfer > 0)
            v = e.chamfer;
        else if (one.special == Special::Round && e.round > 0)
            v = e.round;
        if (one.special == Special::Tangent && e.tangent) out += "T ";
        if (v) out += QString(one.name) + QString::number(*v, 'g', 7) + " ";
    }
    return out.trimmed();
}

void ContourPage::write() {
    if (!solved_.complete() || now_.contour.elements.empty() || !onWrite) return;
    const std::vector<std::string> text = contour::write_contour(now_, solved_, writing_);
    std::vector<forms::LineChange> changes;
    const bool replaces = place_.to >= place_.from;
    const int from = replaces ? place_.from : cursor_,
              there = replaces ? place_.to - place_.from + 1 : 0;
    for (int i = 0; i < static_cast<int>(text.size()); ++i) {
        if (i >= there)
            changes.push_back({from + there, true, text[static_cast<std::size_t>(i)]});
        else if (lines_[static_cast<std::size_t>(from + i)] != text[static_cast<std::size_t>(i)])
            changes.push_back({from + i, false, text[static_cast<std::size_t>(i)]});
    }
    for (int i = static_cast<int>(text.size()); i < there; ++i)
        changes.push_back({from + i, false, {}, true});
    onWrite(changes);
    if (onClose) onClose();
}

void ContourPage::composeNote(Writer& w) {
    const Theme& t = theme();
    w.fill(QRectF(0, 0, note_->width(), note_->height()), t.window);
    w.fill(QRectF(0, px(6), note_->width(), note_->height() - px(6)), t.card, px(8));
    const QRectF line(px(42), px(6), note_->width() - px(54), note_->height() - px(6));
    const int row = elements_->row();
    QString text;
    Sign sign = Sign::Note;
    QColor colour = t.accent;
    if (!hint_.isEmpty()) {
        text = hint_;
        sign = Sign::Warning;
        colour = t.warn;
    } else if (row > 0 && solved_.states[static_cast<std::size_t>(row - 1)] != State::Known) {
        text = stateText(static_cast<std::size_t>(row - 1));
        sign = Sign::Warning;
        colour = t.warn;
    } else if (now_.contour.elements.empty())
        text = word("Enter the start point, then add lines and arcs with what the drawing says.");
    else if (!solved_.choices.empty())
        text = word("Several solutions: touch the one that is meant, or «Next solution».");
    else if (edited_) {
        text = word("Its blocks were edited by hand: writing replaces them.");
        sign = Sign::Warning;
        colour = t.warn;
    } else if (solved_.complete()) {
        text = word("The contour is complete.");
        sign = Sign::Good;
        colour = t.good;
    } else {
        text = word("Some elements are still open.");
        sign = Sign::Wait;
        colour = t.warn;
    }
    w.sign(QRectF(px(12), note_->height() / 2.0 - px(7), px(20), px(20)), sign, colour);
    w.text(line, text, lettering(15), t.text).wraps = true;
}

void ContourPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), left = px(430), pad = px(320), foot = px(48);
    const int high = height() - 2 * edge;
    // of what lies below the picture there
    const int top = upright(*this) ? height() * 36 / 100 : 0;
    const int upper = std::max(px(160), (high - top) * 44 / 100);
    elements_->setGeometry(edge, top, left, upper);
    data_->setGeometry(edge, top + upper + edge, left, height() - top - upper - 2 * edge);
    const int from = left + 2 * edge, wide = width() - from - edge;
    const int padWide = std::min(px(330), wide / 2);
    if (top > 0) {
        picture_->setGeometry(edge, 0, width() - 2 * edge, top - edge);
        note_->setGeometry(from, top, wide, foot + px(60));
        pad_->setGeometry(from, height() - pad - edge, wide, pad);
        return;
    }
    picture_->setGeometry(from, 0, wide, height() - pad - 2 * edge);
    pad_->setGeometry(width() - padWide - edge, height() - pad - edge, padWide, pad);
    note_->setGeometry(from, height() - pad - edge - px(6), wide - padWide - edge, foot + px(60));
}

void ContourPage::refresh() {
    for (Sheet* one : sheets()) one->refresh();
    picture_->show(now_.contour, solved_, elements_->row() - 1);
}

bool ContourPage::key(QKeyEvent* event) {
    if (pad_->key(event)) return true;
    switch (event->key()) {
        case Qt::Key_Delete:
            input(std::nullopt);
            return true;
        case Qt::Key_Escape:
            if (onClose) onClose();
            return true;
        case Qt::Key_Left:
        case Qt::Key_PageUp:
            elements_->choose(std::max(0, elements_->row() - 1));
            data_->choose(0);
            refresh();
            return true;
        case Qt::Key_Right:
        case Qt::Key_PageDown:
            elements_->choose(
                std::min(static_cast<int>(now_.contour.elements.size()), elements_->row() + 1));
            data_->choose(0);
            refresh();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            data_->choose(std::min(data_->rows() - 1, data_->row() + 1));
            refresh();
            return true;
        default:
            return data_->key(event);
    }
}

void ContourPage::addKeys(std::vector<SoftKey>& keys) {
    const auto next = [this] {
        if (solved_.choices.empty()) return;
        std::size_t which = solved_.choices.size() - 1;
        for (std::size_t k = 0; k < solved_.choices.size(); ++k)
            if (const auto row = elements_->row() - 1;
                row >= static_cast<int>(solved_.choices[k].first) &&
                row <= static_cast<int>(solved_.choices[k].last))
                which = k;
        choose(which,
               (solved_.choices[which].chosen + 1) % solved_.choices[which].solutions.size());
    };
    keys.resize(std::min<std::size_t>(keys.size(), 2));
    keys.push_back({word("Add a line"), [this] { add(Kind::Line); }, Sign::Right});
    keys.push_back({word("Add an arc G2"), [this] { add(Kind::ArcCw); }, Sign::Right});
    keys.push_back({word("Add an arc G3"), [this] { add(Kind::ArcCcw); }, Sign::Right});
    keys.push_back(
        {word("Delete the element"), [this] { remove(); }, Sign::Bin, elements_->row() > 0});
    keys.push_back({word("Empty the field"), [this] { input(std::nullopt); }, Sign::None,
                    datum() && value(*datum()).has_value() && elements_->row() > 0});
    keys.push_back({word("Next solution"), next, Sign::Note, !solved_.choices.empty()});
    keys.push_back({word("Write into the program"), [this] { write(); }, Sign::Good,
                    solved_.complete() && !now_.contour.elements.empty()});
    keys.push_back({word("Back to the text"),
                    [this] {
                        if (onClose) onClose();
                    },
                    Sign::Left});
}

}  // namespace polyturn::hmi
