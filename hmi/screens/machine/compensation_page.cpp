#include "hmi/screens/machine/compensation_page.hpp"

#include <QDir>
#include <QJsonArray>
#include <QJsonObject>
#include <QKeyEvent>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/live/round_step.hpp"
#include "hmi/text/retold.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/portrait.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/translations.hpp"
#include "ipc/params/unit.hpp"

namespace polyturn::hmi {
namespace {

using Kind = CompensationCurve::Kind;
constexpr int kLookMs = 1'000;                 // how often the file is looked at
constexpr int kPosition = 1, kCorrection = 2;  // columns of the points

double largest(const CompensationCurve& curve) {
    double out = 0;
    for (const auto& point : curve.points) out = std::max(out, std::abs(point.value));
    return out;
}

// A cell is a float: what its shortest digits say, or 0.025 + 0.005 would become 0.030000001.
double written(float value) {
    char digits[32];
    double out = 0;
    std::from_chars(digits, std::to_chars(digits, digits + sizeof digits, value).ptr, out);
    return out;
}
bool same(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b)) + 1e-12;
}

}  // namespace

CompensationPage::CompensationPage(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      curves_(new Table(this)),
      points_(new Table(this)),
      settings_(new Table(this)),
      graph_(new FreeSheet(this)),
      pad_(new NumberPad(this)) {
    curves_->columns = {
        {word("Table"), 3.0}, {word("Points"), 0.95, kRight}, {word("Largest"), 1.5, kRight}};
    curves_->rowUnits = 36;
    curves_->textUnits = 14;
    curves_->nothing = word("No compensation table is described (N2500 to N2808).");
    curves_->rows = [this] { return static_cast<int>(all_.size()); };
    curves_->cell = [this](int row, int column) -> Table::Cell {
        const CompensationCurve& curve = all_[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        const bool on = curve.on && curve.described();
        if (column == 0)
            return {title(curve), on ? t.text : t.dim, on ? Sign::Good : Sign::Off, on};
        if (!curve.described()) return {QString::fromUtf8("–"), t.dim};
        if (column == 1) return {QString::number(curve.count), t.dim};
        const auto axis = std::find_if(curve.grid.axis.begin(), curve.grid.axis.end(),
                                       [](unsigned one) { return one != 0; });
        return {lengthOf(curve.kind != Kind::Grid        ? curve.corrected
                         : axis == curve.grid.axis.end() ? 0
                                                         : *axis,
                         curve.largest, 4),
                t.text};
    };
    curves_->onChosen = [this] {
        if (building_) return;
        focus_ = Focus::Curves;
        building_ = true;
        points_->choose(0);
        settings_->choose(0);
        building_ = false;
        show();
        refresh();
    };
    points_->columns = {{word("No."), 1.2, kRight},
                        {word("Position"), 1.5, kRight},
                        {word("Correction"), 1.5, kRight, true},
                        {word("Difference"), 1.4, kRight}};
    points_->rowUnits = 30;
    points_->byCell = true;
    points_->rows = [this] { return shown_ ? static_cast<int>(shown_->points.size()) : 0; };
    points_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        const auto& point = shown_->points[static_cast<std::size_t>(row)];
        if (column == 0)
            return {shown_->four ? QString(QChar('A' + static_cast<int>(point.number)))
                                 : QString::number(point.number),
                    t.dim};
        if (column == kPosition) return {lengthOf(shown_->moving, point.at, 3), t.text};
        if (column == kCorrection)
            return {
                point.given ? lengthOf(shown_->corrected, point.value, 4) : QString::fromUtf8("–"),
                t.accent, Sign::None, true};
        const auto was = before(point);
        if (!was || same(*was, point.value)) return {QString()};
        return {(point.value > *was ? QString("+") : QString()) +
                    lengthOf(shown_->corrected, point.value - *was, 4),
                t.warn};
    };
    points_->onChosen = [this] {
        if (building_) return;
        focus_ = Focus::Points;
        pad_->clear();
        refresh();
    };
    settings_->columns = {
        {word("Number"), 1.2}, {word("Name"), 2.2}, {word("Value"), 1.35, kRight}};
    settings_->rowUnits = 30;
    settings_->textUnits = 14;
    settings_->rows = [this] { return static_cast<int>(describedBy_.size()); };
    settings_->cell = [this](int row, int column) -> Table::Cell {
        const ParameterPlace& one = describedBy_[static_cast<std::size_t>(row)];
        const Place place{.kind = Place::Kind::Parameter, .parameter = one};
        if (column == 0) return {nameOf(place), theme().text, Sign::None, true, Face::Condensed};
        if (column == 1)
            return {fromView(params::words_of(*one.row, spoken()).name), theme().dim, Sign::None,
                    false, Face::Condensed};
        return {textOf(place, present(place)), theme().accent, Sign::None, true};
    };
    settings_->onChosen = [this] {
        if (building_) return;
        focus_ = Focus::Settings;
        pad_->clear();
        refresh();
    };
    graph_->onCompose = [this](Writer& w) { composeGraph(w); };
    graph_->onTouched = [this](int number) {
        if (!shown_ || shown_->kind != Kind::Grid) return;
        const auto axis = static_cast<std::size_t>(number % 10);
        if (number >= kBackHit) return turn(axis, number >= kOnHit ? 1 : -1);
        (number >= kAlongHit ? row_.along : row_.component) = axis;
        show();
        refresh();
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const auto place = target();
        if (!place || !context_.live.connected()) return std::nullopt;
        if (place->kind != Place::Kind::Parameter)
            return NumberPad::Field{
                nameOf(*place), unitOf(shown_->corrected), present(*place),
                context_.live.unit(context_.live.config().axis(shown_->corrected)).digits(4)};
        const params::Row& row = *place->parameter.row;
        return NumberPad::Field{
            nameOf(*place),
            unitWord(params::unit_of(row, context_.live.table(), place->parameter.instance)),
            present(*place),
            row.type == params::Type::Real ? 4u : 0u,
            row.type == params::Type::Bits,
            1,
            row.type != params::Type::Bits};
    };
    pad_->onInput = [this](double now) {
        if (const auto place = target()) put(*place, now);
    };
    pad_->onAdded = [this](double delta) {
        if (const auto place = target()) add(*place, delta);
    };
    undo_.present = [this](const Place& place) { return present(place); };
    undo_.same = same;
    undo_.putBack = [this](const Undo::Change& change) { takeBack(change); };
    undo_.keep = [this](const Undo::Change& change, double there) {
        context_.tell(word("%1 is %2 by now: it stays")
                          .arg(nameOf(change.where), textOf(change.where, there)),
                      Told::Refused);
    };
}

void CompensationPage::begin() {
    cells_.reset();
    openedCells_.reset();
    all_.clear();
    stamp_ = {};
    rowOf_ = 0;
    show();
    read(kTimeout_ms);
    refresh();
}

// The file may lie on a network. One that is as it was is not read again.
void CompensationPage::read(int wait_ms) {
    since_.start();
    reading_.start(
        [base = context_.live.machineFolder(), known = stamp_,
         first = cells_ == nullptr](const std::atomic<bool>&) {
            Read out;
            const std::string path = base + ".compensation";
            std::error_code none;
            if (!base.empty()) {
                out.stamp.size = std::filesystem::file_size(path, none);
                out.stamp.there = !none;
                if (out.stamp.there)
                    out.stamp.when = std::filesystem::last_write_time(path, none);
                else
                    out.stamp.size = 0;
            }
            // said by who started the controller, and by the store at each change
            std::vector<Diagnosis> ignored;
            if (first || !(out.stamp == known))
                out.cells = std::make_shared<CompensationTables>(
                    out.stamp.there ? load_compensation(path, ignored) : CompensationTables());
            return out;
        },
        wait_ms);
}

void CompensationPage::take() {
    auto made = reading_.take();
    if (made && made->cells) {
        stamp_ = made->stamp;
        cells_ = made->cells;
        if (!openedCells_) {
            openedCells_ = std::make_shared<CompensationTables>(*cells_);
            openedAll_ = compensationCurves(context_.live.table(), context_.live.config(),
                                            *openedCells_, Tables::All);
        }
        (void)parametersChanged();
        return build();
    }
    if (cells_ && parametersChanged()) build();
    if (cells_ && !reading_.busy() && asked_ == 0 && since_.elapsed() > kLookMs) read(0);
}

// Those that describe tables, and where axes belong.
bool CompensationPage::parametersChanged() {
    static const std::vector<const params::Row*> kRows = [] {
        std::vector<const params::Row*> out;
        for (const params::Row& row : params::rows())
            if (row.type != params::Type::Text &&
                (row.number == "N0106" ||
                 (row.number >= "N2500" && row.number <= "N2808" && row.number.size() == 5)))
                out.push_back(&row);
        return out;
    }();
    const auto& numbers = context_.live.table().numbers;
    bool changed = false;
    std::size_t at = 0;
    for (const params::Row* row : kRows)
        for (std::size_t i = 0, count = static_cast<std::size_t>(params::instances(row->scope)) *
                                        row->array;
             i < count; ++i, ++at) {
            if (at == parameters_.size()) parameters_.push_back(std::nan(""));
            const double now = numbers[row->first_slot + i];
            if (parameters_[at] != now) {
                parameters_[at] = now;
                changed = true;
            }
        }
    return changed;
}

// The table that was chosen stays chosen.
void CompensationPage::build() {
    const CompensationCurve* before = table();
    std::optional<CompensationCurve> was;
    if (before) {
        was = *before;
        was->points.clear();
    }
    all_ = compensationCurves(context_.live.table(), context_.live.config(), *cells_,
                              everything_ ? Tables::All : Tables::Described);
    const auto found = std::find_if(all_.begin(), all_.end(), [&](const CompensationCurve& one) {
        return wanted_ ? one.kind == *wanted_ : was && one.sameTable(*was);
    });
    building_ = true;
    curves_->choose(found == all_.end() ? 0 : static_cast<int>(found - all_.begin()));
    building_ = false;
    wanted_.reset();
    show();
}

void CompensationPage::chooseKind(Kind kind) {
    wanted_ = kind;
    if (cells_) {
        build();
        refresh();
    }
}

const CompensationCurve* CompensationPage::table() const {
    const auto row = static_cast<std::size_t>(std::max(0, curves_->row()));
    return row < all_.size() ? &all_[row] : nullptr;
}

void CompensationPage::show() {
    const CompensationCurve* now = table();
    shown_.reset();
    opened_.reset();
    neighbours_.clear();
    describedBy_.clear();
    if (now) {
        shown_ = *now;
        describedBy_ = now->describedBy();
        const auto was =
            std::find_if(openedAll_.begin(), openedAll_.end(),
                         [&](const CompensationCurve& one) { return one.sameTable(*now); });
        if (was != openedAll_.end()) opened_ = *was;
        if (now->kind == Kind::Grid) {
            if (rowOf_ != now->channel) {
                row_ = firstRow(now->grid);
                rowOf_ = now->channel;
            }
            row_ = within(row_, now->grid);
            shown_ = gridRow(*now, *cells_, row_);
            if (opened_) opened_ = gridRow(*opened_, *openedCells_, within(row_, opened_->grid));
            for (int which = 0; which < 2; ++which)
                for (const std::int64_t step : {-1, 1}) {
                    GridRow near = row_;
                    const std::size_t axis = beside(which);
                    if (axis > 2) continue;
                    near.place[axis] += step;
                    if (near.place[axis] >= 0 && near.place[axis] < now->grid.count[axis])
                        neighbours_.push_back(gridRow(*now, *cells_, near));
                }
        }
        points_->columns[kPosition].editable = shown_->four;
    }
    building_ = true;
    points_->choose(points_->row(), points_->column());
    settings_->choose(settings_->row());
    building_ = false;
}

void CompensationPage::refresh() {
    take();
    undo_.goOn();
    curves_->focused = focus_ == Focus::Curves;
    points_->focused = focus_ == Focus::Points;
    settings_->focused = focus_ == Focus::Settings;
    // what a number goes to
    points_->marked = focus_ != Focus::Settings;
    settings_->marked = focus_ == Focus::Settings;
    for (Sheet* one : sheets()) one->refresh();
}

std::optional<CompensationPage::Place> CompensationPage::placeAt(int row, int column) const {
    if (!shown_ || row < 0 || row >= static_cast<int>(shown_->points.size())) return std::nullopt;
    const auto index = static_cast<std::size_t>(row);
    if (const auto parameter = shown_->parameterOf(index, column == kPosition))
        return Place{.kind = Place::Kind::Parameter, .parameter = *parameter};
    if (shown_->kind == Kind::Grid)
        return Place{.kind = Place::Kind::Point,
                     .number = shown_->points[index].number,
                     .channel = shown_->channel,
                     .component = row_.component};
    return Place{.kind = Place::Kind::Cell, .number = shown_->points[index].number};
}

std::optional<CompensationPage::Place> CompensationPage::target() const {
    if (focus_ != Focus::Settings) return placeAt(points_->row(), points_->column());
    const auto row = static_cast<std::size_t>(std::max(0, settings_->row()));
    return row < describedBy_.size() ? std::optional(Place{.kind = Place::Kind::Parameter,
                                                           .parameter = describedBy_[row]})
                                     : std::nullopt;
}

double CompensationPage::present(const Place& place) const {
    if (place.kind == Place::Kind::Parameter)
        return context_.live.table().numbers[place.parameter.slot()];
    if (!cells_) return 0;
    if (place.kind == Place::Kind::Cell)
        return written(static_cast<float>(cells_->cell(place.number)));
    const auto& points = cells_->points[place.channel - 1];
    const float value = static_cast<std::size_t>(place.number) < points.size()
                            ? points[static_cast<std::size_t>(place.number)][place.component]
                            : 0.0F;
    return std::isnan(value) ? 0.0 : written(value);
}

bool CompensationPage::bits(const Place& place) const {
    return place.kind == Place::Kind::Parameter && place.parameter.row->type == params::Type::Bits;
}

QString CompensationPage::nameOf(const Place& place) const {
    if (place.kind == Place::Kind::Cell) return word("Cell %1").arg(place.number);
    if (place.kind == Place::Kind::Point) {
        const unsigned axis =
            compensation_grid(context_.live.table(), place.channel).axis[place.component];
        return QString("L%1: ").arg(place.channel) +
               word("point %1, %2").arg(QString::number(place.number), axisName(axis));
    }
    params::Target target{place.parameter.row};
    target.instance = place.parameter.instance;
    return QString::fromStdString(params::target_text(target));
}

QString CompensationPage::textOf(const Place& place, double value) const {
    if (bits(place) && value >= 0 && value <= 255) return bitDigits(static_cast<unsigned>(value));
    return QString::number(value, 'g', place.kind == Place::Kind::Parameter ? 12 : 7);
}

// A cell is kept by the store in the machine's file, a parameter like any other.
void CompensationPage::put(const Place& place, double now) {
    if (place.kind != Place::Kind::Parameter)
        return askStore(place, now, Undo::Change{place, present(place), now}, false);
    undo_.asked();
    ++asked_;
    reading_.forget();
    const bool whole = place.parameter.row->type != params::Type::Real && !bits(place);
    const QString text = whole ? QString::number(std::llround(now))
                         : bits(place) && now >= 0 && now <= 255
                             ? bitDigits(static_cast<unsigned>(now))
                             : QString::number(now, 'g', 15);
    context_.requests.parameter(nameOf(place) + "=" + text,
                                [this, change = Undo::Change{place, present(place), now}](
                                    const Answer& answer) { answered(change, answer, false); });
}

// What is added, and what is taken back, the store works out: it knows what a program or another
// panel has entered since the file was read.
void CompensationPage::add(const Place& place, double delta) {
    askStore(place, QJsonObject{{"delta", std::round(delta * 1e9) / 1e9}}, std::nullopt, false);
}

void CompensationPage::takeBack(const Undo::Change& change) {
    askStore(change.where, QJsonObject{{"value", change.old}, {"expected", change.now}},
             Undo::Change{change.where, change.now, change.old}, true);
}

void CompensationPage::askStore(const Place& place, const QJsonValue& entry,
                                const std::optional<Undo::Change>& known, bool undone) {
    undo_.asked();
    ++asked_;
    reading_.forget();
    QJsonObject request;
    if (place.kind == Place::Kind::Parameter) {
        request = entry.toObject();
        request.insert("do", "parameters.set");
        request.insert("target", nameOf(place));
    } else {
        const bool point = place.kind == Place::Kind::Point;
        const QJsonArray where =
            point ? QJsonArray{static_cast<int>(place.channel), static_cast<double>(place.number),
                               static_cast<double>(place.component), entry}
                  : QJsonArray{static_cast<double>(place.number), entry};
        request = {{"do", "compensation.set"}, {point ? "points" : "cells", QJsonArray{where}}};
    }
    context_.requests.store(request, [this, place, known, undone](const Answer& answer) {
        const QJsonObject told = place.kind == Place::Kind::Parameter
                                     ? answer.object
                                     : answer.object.value("entries").toArray().at(0).toObject();
        answered(
            known ? *known
                  : Undo::Change{place, told.value("old").toDouble(), told.value("new").toDouble()},
            answer, undone);
    });
}

void CompensationPage::answered(const Undo::Change& change, const Answer& answer, bool undone) {
    --asked_;
    if (!answer.ok) return undo_.refused();
    taken(change.where, change.now);
    if (undone)
        undo_.takenBack(change);
    else
        undo_.entered(change);
    const QString warning = answer.object.value("warning").toString();
    if (!warning.isEmpty())
        context_.tell(
            word("Kept, but: %1")
                .arg(retold(answer.object.value("warning_number").toString(), warning).text),
            Told::Refused);
    else
        context_.tell(QString::fromUtf8("%1: %2 → %3")
                          .arg(nameOf(change.where), textOf(change.where, change.old),
                               textOf(change.where, change.now)),
                      Told::Good);
    refresh();
}

// What the store has kept is shown at once; the file is read again all the same.
void CompensationPage::taken(const Place& place, double now) {
    if (!cells_ || place.kind == Place::Kind::Parameter) return;
    const float value = static_cast<float>(now);
    if (place.kind == Place::Kind::Cell) {
        if (cells_->cells.empty())
            cells_->cells.assign(static_cast<std::size_t>(kLastCell - kFirstCell + 1),
                                 std::nanf(""));
        if (place.number >= kFirstCell && place.number <= kLastCell)
            cells_->cells[static_cast<std::size_t>(place.number - kFirstCell)] = value;
    } else {
        auto& points = cells_->points[place.channel - 1];
        if (points.size() <= static_cast<std::size_t>(place.number))
            points.resize(static_cast<std::size_t>(place.number) + 1, {0, 0, 0});
        auto& point = points[static_cast<std::size_t>(place.number)];
        for (float& one : point) one = std::isnan(one) ? 0.0F : one;
        point[place.component] = value;
    }
    build();
    read(0);
}

void CompensationPage::askImport() {
    context_.ask({word("Measured file"),
                  (context_.folder.isEmpty() ? QDir::currentPath() : context_.folder) + "/",
                  {},
                  [this](const QString& text) {
                      ++asked_;
                      reading_.forget();
                      context_.requests.store(
                          {{"do", "compensation.import"},
                           {"file", QDir::current().absoluteFilePath(text.trimmed())}},
                          [this, text](const Answer& answer) {
                              --asked_;
                              if (!answer.ok) return;
                              context_.tell(
                                  word("%1: acts as soon as the axes rest").arg(text.trimmed()),
                                  Told::Good);
                              read(0);
                          });
                  },
                  false,
                  200});
}

// The axes of the grid that the chosen row does not run along, one after the other.
std::size_t CompensationPage::beside(int which) const {
    const CompensationCurve* now = table();
    for (std::size_t i = 0; now && now->kind == Kind::Grid && i < 3; ++i)
        if (i != row_.along && now->grid.axis[i] && now->grid.count[i] > 1 && which-- == 0)
            return i;
    return 3;
}

void CompensationPage::turn(std::size_t axis, int step) {
    if (axis > 2) return;
    row_.place[axis] += step;
    show();
    refresh();
}

std::optional<double> CompensationPage::before(const CompensationCurve::Point& point) const {
    if (!opened_) return std::nullopt;
    const auto& all = opened_->points;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const auto& one) { return one.number == point.number; });
    return found == all.end() ? std::nullopt : std::optional(found->value);
}

std::vector<SoftKey> CompensationPage::keys() {
    const bool connected = context_.live.connected(), ready = connected && pad_->ready(),
               grid = shown_ && shown_->kind == Kind::Grid;
    const Undo::Change* last = undo_.newest();
    const auto next = [this](std::size_t GridRow::*which) {
        const CompensationCurve* now = table();
        if (!now) return;
        do row_.*which = (row_.*which + 1) % 3;
        while (now->grid.axis[row_.*which] == 0 && now->grid.described());
        show();
        refresh();
    };
    return {{word("Take a measured file"), [this] { askImport(); }, Sign::None,
             connected && cells_ != nullptr},
            {word("All tables"),
             [this] {
                 everything_ = !everything_;
                 if (cells_) build();
                 refresh();
             },
             Sign::None, connected, everything_},
            {word("Corrected axis"), [next] { next(&GridRow::component); }, Sign::None, grid},
            {word("Along axis"), [next] { next(&GridRow::along); }, Sign::None, grid},
            {word("Input"), [this] { pad_->enter(false); }, Sign::None, ready},
            {word("+ Input"), [this] { pad_->enter(true); }, Sign::None, ready},
            {},
            {word("Undo"),
             [this] { undo_.undo(); },
             Sign::Undo,
             last != nullptr,
             false,
             false,
             {},
             {},
             {},
             last ? nameOf(last->where) : QString()}};
}

QString CompensationPage::axisName(unsigned axis) const {
    if (axis < 1 || axis > kMaxAxes) return QString::fromUtf8("–");
    return QString("A%1 %2").arg(axis).arg(fromView(context_.live.config().axis(axis).name_text()));
}

QString CompensationPage::lengthOf(unsigned axis, double value, unsigned digits) const {
    return lengthText(value,
                      axis < 1 || axis > kMaxAxes
                          ? digits
                          : context_.live.unit(context_.live.config().axis(axis)).digits(digits));
}

// As it is stored: in the unit of the axis, X as a radius.
QString CompensationPage::unitOf(unsigned axis) const {
    if (axis < 1 || axis > kMaxAxes) return {};
    const AxisConfig& config = context_.live.config().axis(axis);
    const LengthUnit unit = context_.live.unit(config);
    return config.diameter && !config.rotary ? unit.radius() : unit.name();
}

QString CompensationPage::title(const CompensationCurve& curve) const {
    switch (curve.kind) {
        case Kind::Pitch:
            return word("%1: pitch").arg(axisName(curve.moving));
        case Kind::PitchBack:
            return word("%1: pitch, negative direction").arg(axisName(curve.moving));
        case Kind::Periodic:
            return word("%1: periodic").arg(axisName(curve.moving));
        case Kind::Gradient:
            return word("%1: gradient").arg(axisName(curve.moving));
        case Kind::Straightness:
            if (curve.moving == 0 || curve.corrected == 0)
                return word("L%1: straightness, pair %2").arg(curve.channel).arg(curve.pair);
            return word("%1 by %2: straightness")
                .arg(axisName(curve.corrected), axisName(curve.moving));
        case Kind::Grid:
            break;
    }
    return word("L%1: volume").arg(curve.channel);
}

bool CompensationPage::key(QKeyEvent* event) {
    const int pressed = event->key();
    if (pressed == Qt::Key_Tab || pressed == Qt::Key_Backtab) {
        const int step = pressed == Qt::Key_Tab ? 1 : 2;
        focus_ = static_cast<Focus>((static_cast<int>(focus_) + step) % 3);
        pad_->clear();
        refresh();
        return true;
    }
    if (pad_->key(event)) return true;
    if ((pressed == Qt::Key_Left || pressed == Qt::Key_Right) && focus_ != Focus::Settings &&
        shown_ && shown_->kind == Kind::Grid) {
        turn(beside(event->modifiers() & Qt::ShiftModifier ? 1 : 0),
             pressed == Qt::Key_Right ? 1 : -1);
        return true;
    }
    return (focus_ == Focus::Points     ? points_
            : focus_ == Focus::Settings ? settings_
                                        : curves_)
        ->key(event);
}

void CompensationPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), pad = px(330), padHigh = px(346);
    const Parted all =
        parted(*this, QRect(edge, 0, width() - 2 * edge, height() - edge), pad, padHigh, edge);
    const Padded side = padded(*this, all.side, pad, padHigh, edge);
    settings_->setGeometry(side.rest);
    pad_->setGeometry(side.pad);
    if (upright(*this)) {
        const int half = (all.main.width() - edge) / 2,
                  top = static_cast<int>(all.main.height() * 0.42);
        curves_->setGeometry(all.main.left(), 0, half, top - edge);
        points_->setGeometry(all.main.left() + half + edge, 0, half, top - edge);
        graph_->setGeometry(all.main.left(), top, all.main.width(), all.main.height() - top);
    } else {
        const int left = static_cast<int>(all.main.width() * 0.43),
                  top = static_cast<int>(height() * 0.36);
        curves_->setGeometry(all.main.left(), 0, left - edge, top - edge);
        points_->setGeometry(all.main.left(), top, left - edge, all.main.height() - top);
        graph_->setGeometry(all.main.left() + left, 0, all.main.width() - left, all.main.height());
    }
    for (Sheet* one : sheets()) one->refresh();
}

// Of a grid: which axis is corrected, along which one, and where the others stand. Where it ends.
double CompensationPage::composeRow(Writer& w, double y) {
    const Theme& t = theme();
    const CompensationGrid& grid = shown_->grid;
    const double wide = graph_->width(), tall = px(34), name = px(104), gap = px(6);
    const auto key = [&](const QRectF& box, const QString& text, bool on, int hit) {
        w.fill(box, on ? t.mark : t.raised, px(6));
        w.frame(box, on ? t.accent : t.edge, px(6), 1);
        w.data(box.adjusted(px(4), 0, -px(4), 0), text, lettering(14, on), t.text, Qt::AlignCenter);
        w.hit(box, hit);
    };
    const double each = (wide - px(28) - name - 2 * gap) / 3;
    for (const bool along : {false, true}) {
        w.text(QRectF(px(14), y, name - gap, tall), along ? word("Along") : word("Corrected"),
               lettering(13.5), t.dim);
        double x = px(14) + name;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!grid.axis[i]) continue;
            key(QRectF(x, y, each, tall), axisName(grid.axis[i]),
                i == (along ? row_.along : row_.component),
                (along ? kAlongHit : kCorrectedHit) + static_cast<int>(i));
            x += each + gap;
        }
        y += tall + gap;
    }
    for (int which = 0; which < 2; ++which) {
        const std::size_t i = beside(which);
        if (i > 2) break;
        w.data(QRectF(px(14), y, name - gap, tall), axisName(grid.axis[i]), lettering(13.5), t.dim);
        const double x = px(14) + name, step = px(54);
        key(QRectF(x, y, step, tall), QString::fromUtf8("◀"), false,
            kBackHit + static_cast<int>(i));
        w.data(QRectF(x + step + gap, y, px(150), tall),
               lengthOf(grid.axis[i],
                        static_cast<double>(row_.place[i] - grid.zero[i]) * grid.interval[i], 3) +
                   " " + unitOf(grid.axis[i]),
               lettering(15, true), t.text, Qt::AlignCenter);
        key(QRectF(x + step + px(150) + 2 * gap, y, step, tall), QString::fromUtf8("▶"), false,
            kOnHit + static_cast<int>(i));
        y += tall + gap;
    }
    return y;
}

// Straight between the points, as the kernel corrects.
void CompensationPage::composeGraph(Writer& w) {
    const Theme& t = theme();
    const double wide = graph_->width(), high = graph_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const CompensationCurve* curve = chosen();
    if (!curve) return;
    w.data(QRectF(px(14), px(8), wide - px(28), px(26)), title(*curve), lettering(16, true),
           t.text);
    const bool on = curve->on && curve->described();
    w.text(QRectF(px(14), px(34), wide - px(28), px(22)),
           on                   ? word("Active")
           : curve->described() ? word("Switched off")
                                : word("Not described: enter its parameters."),
           lettering(13.5), on ? t.good : t.warn);
    double y = px(60);
    if (curve->kind == Kind::Grid && curve->described()) y = composeRow(w, y);
    if (curve->points.size() < 2) return;
    const auto [first, last] =
        std::minmax_element(curve->points.begin(), curve->points.end(),
                            [](const auto& a, const auto& b) { return a.at < b.at; });
    const double from = first->at, span = std::max(1e-9, last->at - from);
    double highest = std::max(largest(*curve), 1e-4);
    for (const CompensationCurve& one : neighbours_) highest = std::max(highest, largest(one));
    const bool changed = opened_ && opened_->points.size() == curve->points.size() &&
                         !std::equal(curve->points.begin(), curve->points.end(),
                                     opened_->points.begin(), [](const auto& a, const auto& b) {
                                         return a.at == b.at && same(a.value, b.value);
                                     });
    if (changed) highest = std::max(highest, largest(*opened_));
    const double division = roundStep(highest * 1.05 / 4), most = 4 * division;
    const double left = px(84), right = wide - px(36), top = y + px(34), bottom = high - px(84),
                 middle = (top + bottom) / 2;
    const auto place = [&](const CompensationCurve::Point& point) {
        return QPointF(left + (right - left) * std::clamp((point.at - from) / span, 0.0, 1.0),
                       middle - (bottom - top) / 2 * point.value / most);
    };
    w.text(QRectF(px(14), y, wide - px(28), px(22)),
           QString("%1 %2 (%3)")
               .arg(word("Correction"), axisName(curve->corrected), unitOf(curve->corrected)),
           lettering(13.5), t.dim);
    const int lines = bottom - top < px(180) ? 2 : 4;
    for (int i = -lines; i <= lines; ++i) {
        const double line = middle - (bottom - top) / 2 * i / lines;
        w.line({left, line}, {right, line}, i == 0 ? t.dim : t.edge, 1);
        w.text(QRectF(px(4), line - px(10), left - px(12), px(20)),
               lengthOf(curve->corrected, most * i / lines, 4), lettering(12.5), t.dim, kRight);
    }
    const double apart = roundStep(span / 6);
    for (double at = std::ceil(from / apart - 1e-6) * apart; at <= last->at + 1e-6 * apart;
         at += apart) {
        const double x = left + (right - left) * (at - from) / span;
        w.line({x, top}, {x, bottom}, t.edge, 1);
        w.text(QRectF(x - px(40), bottom + px(6), px(80), px(20)),
               lengthText(std::round(at / apart) * apart + 0.0, apart < 1 ? 3 : 0), lettering(12.5),
               t.dim, Qt::AlignCenter);
    }
    w.text(
        QRectF(left, bottom + px(30), right - left, px(22)),
        QString("%1 %2 (%3)").arg(word("Position"), axisName(curve->moving), unitOf(curve->moving)),
        lettering(13.5), t.dim, kRight);
    const QString pale = changed               ? neighbours_.empty()
                                                     ? word("thin: before")
                                                     : word("pale: the rows beside it; thin: before")
                                       : neighbours_.empty() ? QString()
                                               : word("pale: the rows beside it");
    if (!pale.isEmpty())
        w.text(QRectF(px(14), bottom + px(54), wide - px(28), px(22)), pale, lettering(13), t.dim);
    // A graph has some hundred places; of tables with thousands of points the least and greatest of
    // each place are drawn.
    const auto draw = [&](const CompensationCurve& one, const QColor& colour, double width) {
        const std::size_t count = one.points.size(), step = std::max<std::size_t>(1, count / 400);
        QPointF before = place(one.points.front());
        for (std::size_t i = step; i < count; i += step) {
            const auto begin = one.points.begin() + static_cast<std::ptrdiff_t>(i - step + 1),
                       end = one.points.begin() + static_cast<std::ptrdiff_t>(i + 1);
            const auto [low, top_one] = std::minmax_element(
                begin, end, [](const auto& a, const auto& b) { return a.value < b.value; });
            for (const auto* point : low->at < top_one->at ? std::array{&*low, &*top_one}
                                                           : std::array{&*top_one, &*low}) {
                const QPointF now = place(*point);
                w.line(before, now, colour, width);
                before = now;
            }
        }
        w.line(before, place(one.points.back()), colour, width);
    };
    QColor besides = t.accent;
    besides.setAlpha(110);
    for (const CompensationCurve& one : neighbours_)
        if (!one.points.empty()) draw(one, besides, px(1));
    if (changed) draw(*opened_, t.warn, 1);
    draw(*curve, t.accent, px(2));
    const auto row = static_cast<std::size_t>(std::max(0, points_->row()));
    if (row < curve->points.size()) {
        const QPointF at = place(curve->points[row]);
        w.fill(QRectF(at.x() - px(5), at.y() - px(5), px(10), px(10)), t.warn, px(5));
    }
}

}  // namespace polyturn::hmi
