#include "hmi/screens/tools/offsets.hpp"

#include <QJsonArray>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/screens/overview/channel_keys.hpp"
#include "hmi/text/dates.hpp"
#include "hmi/text/search.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/portrait.hpp"
#include "ipc/machine/store/work_zeros.hpp"

namespace polyturn::hmi {
namespace {

constexpr std::size_t kMostZeros = 48;  // of G54.1 P

PlaneRole roleOf(char letter) {
    return letter == 'X'   ? PlaneRole::BasicX
           : letter == 'Y' ? PlaneRole::BasicY
                           : PlaneRole::BasicZ;
}
int placeOf(const Live& live, unsigned channel, char letter) {
    const AxisConfig* axis = find_axis(live.config(), channel, roleOf(letter));
    return axis && axis->slot != kNoSlot ? axis->slot : -1;
}
const QString kDiameter = QString::fromUtf8(" ⌀");
bool inDiameter(const Live& live, unsigned channel, char letter) {
    const AxisConfig* axis = find_axis(live.config(), channel, roleOf(letter));
    return axis && axis->offset_diameter && !axis->rotary;
}
double cellValue(const OffsetCell& cell, char field) {
    switch (field) {
        case 'X':
            return cell.geometry[0];
        case 'Y':
            return cell.geometry[1];
        case 'Z':
            return cell.geometry[2];
        case 'R':
            return cell.geometry_r;
        case 'T':
            return cell.tip;
        case 'x':
            return cell.wear[0];
        case 'y':
            return cell.wear[1];
        case 'z':
            return cell.wear[2];
        case 'r':
            return cell.wear_r;
        default:
            return 0;
    }
}

// Columns of edges: tool, D, and these.
constexpr double kTurningTool = 500;  // of a new edge whose tool has no type
constexpr int kEdgeColumns[] = {kDpType,   kDpTip,  kDpLength,   kDpLength + 1, kDpLength + 2,
                                kDpRadius, kDpWear, kDpWear + 1, kDpWear + 2,   kDpWearRadius};
constexpr int kBaseColumns[] = {kDpType,   kDpTip,  kDpLength,   kDpLength + 1, kDpLength + 2,
                                kDpRadius, kDpBase, kDpBase + 1, kDpBase + 2,   kDpBaseRadius};

}  // namespace

QString Offsets::Value::text(double held) const { return lengthText(unit.of(held), decimals); }
QString Offsets::Value::unitText() const {
    return angle      ? QString(QChar(0xB0))
           : decimals ? unit.name() + (diameter ? kDiameter : QString())
                      : QString();
}

Offsets::Offsets(Context& context)
    : Screen(context),
      head_(new FreeSheet(this)),
      find_(new FreeSheet(this)),
      side_(new FreeSheet(this)),
      table_(new Table(this)),
      pad_(new NumberPad(this)),
      parts_(new PartsPage(context, this)) {
    parts_->hide();
    undo_.present = [this](const Value& value) { return presentOf(value); };
    undo_.same = [](double a, double b) { return std::abs(a - b) <= 5e-7; };
    undo_.putBack = [this](const Undo::Change& change) {
        Value value = change.where;
        if (!value.gone.empty()) return setEdge(value, true);
        value.present = presentOf(value);
        takeBack(value, change.old, change.now);
    };
    undo_.keep = [this](const Undo::Change& change, double there) {
        if (!change.where.gone.empty())
            return context_.tell(word("%1 has values again: they stay").arg(change.where.title),
                                 Told::Refused);
        context_.tell(
            word("%1 is %2 by now: it stays").arg(change.where.title, change.where.text(there)),
            Told::Refused);
    };
    setFocusPolicy(Qt::StrongFocus);
    table_->byCell = true;
    table_->rowUnits = 34;
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        w.text(QRectF(px(14), 0, head_->width() * 0.5, head_->height()),
               partsShown_ ? word("Measured parts")
               : zeros_    ? word("Work zeros")
               : edged_    ? word("Tool edges")
                           : word("Tool offsets"),
               lettering(20, true), t.text);
        composeChannelKeys(w, context_, head_->size());
    };
    head_->onTouched = [this](int channel) {
        context_.choose(static_cast<unsigned>(channel));
        refresh();
    };
    find_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, find_->width(), find_->height()), t.window);
        const bool any = !search_.isEmpty();
        const double count = any ? px(120) : 0;
        w.field(QRectF(0, px(1), find_->width() - count, find_->height() - px(7)), search_,
                zeros_   ? word("Search: a zero")
                : edged_ ? word("Search: number, tool, edge")
                         : word("Search: number or tool"),
                any, kFindHit);
        if (any)
            w.data(QRectF(find_->width() - count, 0, count - px(4), find_->height() - px(6)),
                   QString("%1 / %2").arg(rows_.size()).arg(rowsInAll()), lettering(15), t.dim,
                   kRight);
    };
    find_->onTouched = [this](int) {
        context_.ask({word("Search"), search_, [this](const QString& text) { find(text); }, {}});
    };
    side_->onCompose = [this](Writer& w) { composeSide(w); };
    table_->onChosen = [this] {
        if (const int row = at(table_->row()); row >= 0) wanted_ = row;
        pad_->clear();
        askHistory();
        side_->refresh();
    };
    table_->onActivated = [this] {};
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const auto value = chosen();
        if (!value) return std::nullopt;
        return NumberPad::Field{value->title, value->unitText(), value->present, value->decimals,
                                false,        value->unit.size()};
    };
    pad_->onInput = [this](double now) {
        if (const auto value = chosen()) put(*value, now);
    };
    pad_->onAdded = [this](double delta) {
        if (const auto value = chosen()) add(*value, delta);
    };
    build();
}

std::vector<Sheet*> Offsets::sheets() {
    if (!partsShown_) return {head_, find_, table_, side_, pad_};
    std::vector<Sheet*> out = parts_->sheets();
    out.push_back(head_);
    return out;
}

void Offsets::showParts(bool on) {
    partsShown_ = on;
    if (on) parts_->begin();
    table_->setVisible(!on);
    find_->setVisible(!on);
    side_->setVisible(!on);
    pad_->setVisible(!on);
    parts_->setVisible(on);
    layOut();
    if (context_.keysChanged) context_.keysChanged();
}

void Offsets::showZeros(bool zeros) {
    if (zeros_ == zeros) return;
    zeros_ = zeros;
    search_.clear();
    wanted_ = 0;
    build();
    table_->choose(0, firstColumn());
}

// The page, the row and the column; base lengths of edges, what is searched.
QString Offsets::state() const {
    return QString("%1 %2 %3 %4 %5")
        .arg(partsShown_ ? 2
             : zeros_    ? 1
                         : 0)
        .arg(wanted_)
        .arg(table_->column())
        .arg(base_ ? 1 : 0)
        .arg(search_);
}
void Offsets::restore(const QString& state) {
    const QStringList parts = state.split(' ');
    if (parts.size() < 3) return;
    showZeros(parts[0] == "1");
    showParts(parts[0] == "2");
    if (const bool base = parts.size() > 3 && parts[3] == "1"; std::exchange(base_, base) != base)
        build();
    search_ = state.section(' ', 4);
    wanted_ = parts[1].toInt();
    table_->choose(table_->row(), parts[2].toInt());
    wanted_ = parts[1].toInt();
    filter();
}

void Offsets::find(const QString& text) {
    search_ = text;
    filter();
    refresh();
}

int Offsets::rowsInAll() const {
    if (!context_.live.connected() || built_ != context_.channel) return 0;
    return zeros_ ? static_cast<int>(zeroRows_.size())
           : edged_
               ? static_cast<int>(edges_.size())
               : std::max<int>(0, context_.live.config().channel(context_.channel).offset_count);
}

// A number is a whole one: «1» finds T1 and D1, not 11; anything else may be a part of a name.
bool Offsets::found(int row) const {
    const QString typed = search_.trimmed();
    if (typed.isEmpty()) return true;
    const auto same = [&](const QString& text) {
        return text.compare(typed, Qt::CaseInsensitive) == 0;
    };
    bool numeric = false;
    typed.toInt(&numeric);
    if (zeros_) {
        const QString name = zeroTitle(
            QString::fromStdString(work_zero_name(zeroRows_[static_cast<std::size_t>(row)])));
        return numeric ? same(QString(name).remove(QRegularExpression("^\\D*"))) ||
                             name.endsWith('P' + typed) || name.endsWith(' ' + typed)
                       : holds(name, typed);
    }
    const auto ofTool = [&](std::int32_t number) {
        const ToolRow* tool = toolOf(context_.live, number);
        return tool &&
               (same(QString("T%1").arg(number)) || same(QString("T%1").arg(tool->type_number)) ||
                (numeric ? same(QString::number(number)) : holds(toolName(*tool, number), typed)));
    };
    if (edged_) {
        const EdgeLine line = edges_[static_cast<std::size_t>(row)];
        return ofTool(line.tool) || same(QString("D%1").arg(line.edge));
    }
    if (numeric) return same(QString::number(row + 1));
    // Of an offset the tools that work with it.
    for (std::size_t i = 0; i < kTools; ++i)
        if (const ToolRow& tool = context_.live.tools().rows[i];
            tool.used && tool.h_cell == row + 1 && ofTool(static_cast<std::int32_t>(i + 1)))
            return true;
    return false;
}

void Offsets::filter() {
    rows_.clear();
    foundFor_ = context_.live.toolsVersion();
    for (int row = 0; row < rowsInAll(); ++row)
        if (found(row)) rows_.push_back(row);
    const bool managed = !byEdges() || toolsManaged(context_.live);
    table_->nothing =
        !search_.isEmpty() ? word("Nothing is like this. Escape shows all.")
        : !byEdges()       ? word("This channel has no offsets.")
        : managed
            ? word("This channel has no tools: enter them on the page of tools.")
            : word("Without tool management (N2900) programs bring their own tools and edges.");
    chooseRow(wanted_);
}

// Where it is among those that are shown; if it is not, the next one is chosen, and what has
// been typed is for no other.
void Offsets::chooseRow(int row) {
    const auto here = std::lower_bound(rows_.begin(), rows_.end(), row);
    const int place = std::min(static_cast<int>(here - rows_.begin()),
                               std::max(0, static_cast<int>(rows_.size()) - 1));
    const int now = at(place);
    if (place != table_->row())
        table_->choose(place, table_->column());
    else if (now >= 0 && now != row) {
        pad_->clear();
        askHistory();
    }
    wanted_ = now >= 0 ? now : row;
}

void Offsets::build() {
    built_ = context_.channel;
    const Live& live = context_.live;
    edged_ = usesEdges(live, context_.channel);
    table_->columns = {{zeros_   ? word("Zero")
                        : edged_ ? word("Tool")
                                 : word("No."),
                        zeros_   ? 1.3
                        : edged_ ? 2.6
                                 : 0.8}};
    fields_ = {' '};
    parameters_ = {0};
    zeroRows_.clear();
    rows_.clear();
    table_->nothing = word("This channel has no offsets.");
    table_->rows = [this] { return static_cast<int>(rows_.size()); };
    if (!live.connected() || live.channels().empty()) { return; }
    const unsigned channel = context_.channel;
    if (zeros_) {
        for (std::size_t row = 0; row < kWorkZeros; ++row)
            if (!work_zero_name(row).empty() &&
                (row <= kZeroShift || row - kZeroG541 <= kMostZeros || row > kZeroG541 + 300))
                zeroRows_.push_back(row);
        for (const std::uint16_t axis : live.config().channel(channel).axis_numbers())
            table_->columns.push_back(
                {fromView(live.config().axis(axis).name_text()) +
                     (live.config().axis(axis).rotary     ? QString::fromUtf8(" °")
                      : live.config().axis(axis).diameter ? kDiameter
                                                          : QString()),
                 1.2, kRight, true});
    } else if (edged_) {
        takeEdges();
        table_->columns.push_back({"D", 0.5, kRight});
        parameters_.push_back(0);
        const bool third = placeOf(live, channel, 'Y') >= 0 ||
                           std::any_of(edges_.begin(), edges_.end(), [&](EdgeLine one) {
                               return sumOfLength(live, one, 2) != 0;
                           });
        for (const int dp : base_ ? kBaseColumns : kEdgeColumns) {
            if (isLength(dp) && lengthOf(dp) == 2 && !third) continue;
            table_->columns.push_back({edgeParameterTitle(dp),
                                       dp == kDpTip                       ? 1.0
                                       : dp == kDpType                    ? 0.75
                                       : dp >= kDpWear || dp == kDpRadius ? 1.1
                                                                          : 1.25,
                                       kRight, true});
            parameters_.push_back(dp);
        }
    } else {
        const auto named = [&](const QString& what, char letter) {
            return QString("%1 %2").arg(what).arg(letter) +
                   (inDiameter(live, channel, letter) ? kDiameter : QString());
        };
        const auto add = [&](const QString& title, char field, double share) {
            table_->columns.push_back({title, share, kRight, true});
            fields_.push_back(field);
        };
        for (const char letter : {'X', 'Y', 'Z'})
            if (placeOf(live, channel, letter) >= 0)
                add(named(word("Geom."), letter), letter, 1.25);
        add(word("Radius"), 'R', 1.0);
        add(word("Tip"), 'T', 0.65);
        for (const char letter : {'X', 'Y', 'Z'})
            if (placeOf(live, channel, letter) >= 0)
                add(named(word("Wear"), letter), static_cast<char>(letter + 32), 1.05);
        add(word("Wear R"), 'r', 1.0);
    }
    filter();
    table_->cell = [this](int shownRow, int column) -> Table::Cell {
        const Theme& t = theme();
        const int row = at(shownRow);
        if (row < 0) return {};
        const bool now = active(row);
        if (column == 0 && byEdges()) {
            const EdgeLine line = edges_[static_cast<std::size_t>(row)];
            const ToolRow* tool = toolOf(context_.live, line.tool);
            // the tool is named once
            if (!tool || (shownRow > 0 &&
                          edges_[static_cast<std::size_t>(at(shownRow - 1))].tool == line.tool))
                return {QString(), t.dim, now ? Sign::Run : Sign::None};
            QString name = QString("T%1  %2").arg(line.tool).arg(toolName(*tool, line.tool));
            if (tool->duplo > 1) name += QString(" (%1)").arg(tool->duplo);
            if (tool->magazine)
                name = placeText(context_.live, tool->magazine, tool->pot) + "  " + name;
            return {name, now ? t.good : t.text, now ? Sign::Run : Sign::None, now,
                    Face::Condensed};
        }
        if (column == 0) {
            QString name = QString::number(row + 1);
            if (zeros_)
                name = zeroTitle(QString::fromStdString(
                    work_zero_name(zeroRows_[static_cast<std::size_t>(row)])));
            return {name, now ? t.good : t.dim, now ? Sign::Run : Sign::None, now};
        }
        if (byEdges() && column == 1)
            return {QString::number(edges_[static_cast<std::size_t>(row)].edge),
                    now ? t.good : t.dim, Sign::None, now};
        const auto value = valueAt(shownRow, column);
        if (!value) return {};
        double applied = 0, sum = 0;
        const bool pending =
            now && appliedNow(*value, applied, sum) && std::abs(applied - sum) > 5e-7;
        const bool wear = !zeros_ && value->wear();
        return {value->text(value->present),
                pending               ? t.warn
                : value->present == 0 ? t.faint
                : wear                ? t.accent
                                      : t.text,
                pending ? Sign::Wait : Sign::None, now};
    };
    if (table_->column() < (byEdges() ? 2 : 1) ||
        table_->column() >= static_cast<int>(table_->columns.size()))
        table_->choose(table_->row(), firstColumn());
}

// Where keys go to at the beginning: of an edge its first length, not its type.
int Offsets::firstColumn() const {
    if (!byEdges()) return 1;
    const auto length = std::find(parameters_.begin(), parameters_.end(), kDpLength);
    return length == parameters_.end() ? 2 : static_cast<int>(length - parameters_.begin());
}

bool Offsets::active(int row) const {
    const ChannelView& view = context_.live.view(context_.channel);
    const BlockPicture& p = view.picture;
    if (!view.known || row < 0 || row >= rowsInAll()) return false;
    if (zeros_)
        return p.zero_row == static_cast<std::int32_t>(zeroRows_[static_cast<std::size_t>(row)]);
    if (edged_)
        return p.tool == edges_[static_cast<std::size_t>(row)].tool &&
               p.edge == edges_[static_cast<std::size_t>(row)].edge;
    return p.geometry == row + 1 || p.wear == row + 1;
}

// The chosen one stays chosen, wherever it stands by now; what has been typed for one that is gone
// is for no other.
void Offsets::takeEdges() {
    edgesOf_ = context_.live.toolsVersion();
    const auto row = static_cast<std::size_t>(std::max(0, wanted_));
    const EdgeLine chosen = row < edges_.size() ? edges_[row] : EdgeLine{};
    edges_ = toolsManaged(context_.live) ? edgeLines(context_.live, context_.channel)
                                         : std::vector<EdgeLine>();
    const auto found = std::find(edges_.begin(), edges_.end(), chosen);
    if (found != edges_.end()) {
        wanted_ = static_cast<int>(found - edges_.begin());
    } else {
        if (chosen.tool) pad_->clear();
        wanted_ = std::clamp(wanted_, 0, std::max(0, static_cast<int>(edges_.size()) - 1));
    }
    filter();
}

std::optional<Offsets::Value> Offsets::valueAt(int shownRow, int column) const {
    const Live& live = context_.live;
    const int row = at(shownRow);
    if (!live.connected() || built_ != context_.channel || column < 1 ||
        column >= static_cast<int>(table_->columns.size()) || row < 0 || row >= rowsInAll())
        return std::nullopt;
    const unsigned channel = context_.channel;
    Value out;
    if (zeros_) {
        const ChannelConfig& config = live.config().channel(channel);
        const std::size_t zero = zeroRows_[static_cast<std::size_t>(row)];
        out.place = column - 1;
        if (out.place >= config.axis_count) return std::nullopt;
        const AxisConfig& axis =
            live.config().axis(config.axes[static_cast<std::size_t>(out.place)]);
        const QString name = QString::fromStdString(work_zero_name(zero)),
                      axisName = fromView(axis.name_text());
        out.words = QString("zero L%1 %2 %3").arg(channel).arg(name, axisName);
        out.title = QString("L%1  %2  %3").arg(channel).arg(zeroTitle(name), axisName);
        out.channel = channel;
        out.zero = true;
        out.row = zero;
        out.present = presentOf(out);
        out.unit = live.unit(axis);
        out.decimals = out.unit.decimals;
        out.angle = axis.rotary;
        out.diameter = axis.diameter && !axis.rotary;
        return out;
    }
    out.unit = live.unit(channel);
    out.decimals = out.unit.decimals;
    if (edged_) {
        out.edge = edges_[static_cast<std::size_t>(row)];
        out.dp = parameters_[static_cast<std::size_t>(column)];
        if (out.dp == 0) return std::nullopt;
        out.words = QString("edge L%1 T%2 D%3 DP%4")
                        .arg(channel)
                        .arg(out.edge.tool)
                        .arg(out.edge.edge)
                        .arg(out.dp);
        out.title = QString("%1  %2").arg(edgeTitle(live, out.edge), edgeParameterTitle(out.dp));
        if (isLength(out.dp)) out.place = placeOfLength(live, channel, out.edge, lengthOf(out.dp));
        // a length of the tool: never a diameter
        if (out.place >= 0)
            out.title += QString(" (%1)").arg(fromView(
                live.config()
                    .axis(live.config().channel(channel).axes[static_cast<std::size_t>(out.place)])
                    .name_text()));
        out.present = edgeValue(live, out.edge, out.dp);
        if (out.dp == kDpType || out.dp == kDpTip) {
            out.decimals = 0;
            out.unit = {};
        }
        return out;
    }
    const char field = fields_[static_cast<std::size_t>(column)];
    const bool wear = field >= 'a';
    const char letter = static_cast<char>(wear ? field - 32 : field);
    out.words = QString("offset L%1 %2 %3 %4")
                    .arg(channel)
                    .arg(row + 1)
                    .arg(wear ? "wear" : "geometry")
                    .arg(letter);
    const QString column_title =
        letter == 'R'   ? (wear ? word("Wear R") : word("Radius"))
        : letter == 'T' ? word("Tip")
                        : QString("%1 %2").arg(wear ? word("Wear") : word("Geom.")).arg(letter);
    out.title =
        QString("L%1  %2 %3  %4").arg(channel).arg(word("Offset")).arg(row + 1).arg(column_title);
    out.channel = channel;
    out.row = static_cast<std::size_t>(row) + 1;
    out.field = field;
    out.present = presentOf(out);
    if (letter == 'T') {
        out.decimals = 0;
        out.unit = {};
    }
    out.place = letter == 'R' || letter == 'T' ? -1 : placeOf(live, channel, letter);
    out.diameter = out.place >= 0 && inDiameter(live, channel, letter);
    return out;
}

// What the running block works with, and what the table comes to now, both as the table shows it.
bool Offsets::appliedNow(const Value& value, double& applied, double& sum) const {
    const ChannelView& view = context_.live.view(context_.channel);
    if (!view.known || value.place < 0) return false;
    const BlockPicture& p = view.picture;
    const auto place = static_cast<std::size_t>(value.place);
    const AxisConfig& axis =
        context_.live.config().axis(context_.live.config().channel(context_.channel).axes[place]);
    const ChannelStore& store = context_.live.store(context_.channel);
    if (zeros_) {
        if (p.flags & kPictureNoShift) return false;
        sum = shown(axis, context_.live.tableZero(context_.channel, static_cast<unsigned>(place),
                                                  p.zero_row));
        // without what the program adds: G52, G92
        applied = context_.live.rests(context_.channel) ? sum : shown(axis, view.zeroTaken[place]);
        return true;
    }
    if (value.ofEdge()) {
        // true lengths
        applied = p.tool_shift[place];
        sum = sumOfLength(context_.live, value.edge, lengthOf(value.dp));
        return true;
    }
    if (p.geometry <= 0 && p.wear <= 0) return false;
    const std::size_t field = axis.role == PlaneRole::BasicX   ? 0
                              : axis.role == PlaneRole::BasicY ? 1
                                                               : 2;
    applied = inTable(axis, p.tool_shift[place]);
    sum = (p.geometry > 0 ? store.offsets[static_cast<std::size_t>(p.geometry)].geometry[field]
                          : 0.0) +
          (p.wear > 0 ? store.offsets[static_cast<std::size_t>(p.wear)].wear[field] : 0.0);
    return true;
}

void Offsets::put(const Value& value, double now) {
    const double old = value.present;
    undo_.asked();
    const auto done = [this, value, old, now](const Answer& answer) {
        if (!answer.ok) return undo_.refused();  // told already
        undo_.entered({value, old, now});
        tellEntered(value, old, now);
    };
    if (value.ofEdge())
        return askStore(
            value,
            {{"do", "offsets.set"}, {"dp", value.dp}, {"value", std::round(now * 1e9) / 1e9}},
            done);
    context_.requests.set(value.words + "=" + QString::number(now, 'f', 9), done);
}

void Offsets::tellEntered(const Value& value, double old, double now) {
    context_.tell(
        QString::fromUtf8("%1: %2 → %3").arg(value.title, value.text(old), value.text(now)),
        Told::Good);
    askHistory();
    refresh();
}

// The store adds: a measured part, another panel or the program may have written since this value
// was drawn.
void Offsets::add(const Value& value, double delta) {
    undo_.asked();
    enterInStore(value, {{"delta", std::round(delta * 1e9) / 1e9}},
                 [this, value](const Answer& answer) { entered(value, answer); });
}

// Likewise: it puts the old value back only where the entered one still stands.
void Offsets::takeBack(const Value& value, double old, double there) {
    undo_.asked();
    enterInStore(value, {{"value", std::round(old * 1e9) / 1e9}, {"expected", there}},
                 [this, value, old, there](const Answer& answer) {
                     if (!answer.ok) return undo_.refused();
                     undo_.takenBack({value, there, old});
                     tellEntered(value, there, old);
                 });
}

void Offsets::enterInStore(const Value& value, QJsonObject entry,
                           const std::function<void(const Answer&)>& done) {
    const QStringList words = value.words.split(' ');  // «offset L1 3 wear X», «zero L1 G54 Z»
    entry.insert("do", value.zero ? "zeros.set" : "offsets.set");
    if (value.zero) {
        entry.insert("channel", static_cast<int>(value.channel));
        entry.insert("zero", words[2]);
        entry.insert("field", words[3]);
        return context_.requests.store(entry, done);
    }
    if (value.ofEdge())
        entry.insert("dp", value.dp);
    else {
        entry.insert("table", words[3]);
        entry.insert("field", words[4]);
    }
    askStore(value, entry, done);
}

// An operation of the store on the chosen offset or edge; it reads table and field, an edge's also
// by the plane.
void Offsets::askStore(const Value& value, QJsonObject request,
                       const std::function<void(const Answer&)>& done) {
    const unsigned channel = value.words.section(' ', 1, 1).mid(1).toUInt();
    request.insert("channel", static_cast<int>(channel));
    if (value.ofEdge()) {
        request.insert("tool", value.edge.tool);
        request.insert("edge", value.edge.edge);
        request.insert("plane", 17 + static_cast<int>(planeNow(context_.live, channel)));
    } else {
        request.insert("number", value.words.section(' ', 2, 2).toInt());
    }
    context_.requests.store(request, done);
}

// An operation of the store has entered it: what it says counts.
void Offsets::entered(const Value& value, const Answer& answer) {
    if (!answer.ok) return undo_.refused();
    const double now = answer.object.value("new").toDouble(),
                 old = answer.object.contains("old") ? answer.object.value("old").toDouble()
                                                     : value.present;
    undo_.entered({value, old, now});
    context_.tell(
        QString::fromUtf8("%1: %2 → %3").arg(value.title, value.text(old), value.text(now)),
        Told::Good);
    askHistory();
    refresh();
}

// Whose length counts when a workpiece is touched: the probe's, that the channel works with now; 0:
// none.
int Offsets::probe() const {
    const ChannelView& view = context_.live.view(context_.channel);
    return view.known ? std::max<int>(0, static_cast<int>(view.picture.geometry)) : 0;
}

// The store knows by axis and direction what was touched; of an offset only its number and table
// are said, of a zero its name, the probe and what the surface is to be.
void Offsets::touched() {
    const auto value = chosen();
    if (!value) return;
    const QStringList words = value->words.split(' ');  // «offset L1 3 wear X», «zero L1 G54 Z»
    const auto done = [this, value = *value](const Answer& answer) {
        const auto number = [&](const char* name) {
            return value.text(answer.object.value(name).toDouble());
        };
        if (answer.ok)
            context_.tell(QString::fromUtf8("%1: %2 → %3")
                              .arg(cellTitle(answer.object.value("what").toString()), number("old"),
                                   number("new")),
                          Told::Good);
        askHistory();
        refresh();
    };
    if (!zeros_)
        return askStore(*value,
                        {{"do", "offsets.touch"}, {"table", value->wear() ? "wear" : "geometry"}},
                        done);
    QJsonObject request{{"do", "zeros.touch"}, {"channel", static_cast<int>(context_.channel)}};
    {
        request.insert("zero", words[2]);
        // else the PLC says it
        if (!params::bit(context_.live.table(), params::n3016_tool_wp_setter_config,
                         context_.channel, 0))
            request.insert("offset", probe());
        if (const auto typed = pad_->held()) request.insert("value", *typed);
        pad_->clear();
    }
    context_.requests.store(request, done);
}

void Offsets::relativeZero() {
    context_.requests.store(
        {{"do", "offsets.origin"}, {"channel", static_cast<int>(context_.channel)}},
        [this](const Answer& answer) {
            if (answer.ok)
                context_.tell(word("The relative counter of L%1 begins here").arg(context_.channel),
                              Told::Good);
        });
}

void Offsets::relativeInput() {
    const auto value = chosen();
    if (!value || zeros_ || value->place < 0) return;
    const AxisConfig& axis =
        context_.live.config().axis(context_.live.config()
                                        .channel(context_.channel)
                                        .axes[static_cast<std::size_t>(value->place)]);
    const char* const field = axis.role == PlaneRole::BasicX   ? "X"
                              : axis.role == PlaneRole::BasicY ? "Y"
                                                               : "Z";
    undo_.asked();
    askStore(*value,
             {{"do", "offsets.relative"},
              {"table", value->wear() ? "wear" : "geometry"},
              {"field", field}},
             [this, value = *value](const Answer& answer) { entered(value, answer); });
}

// Another edge of the chosen tool, of the same type.
void Offsets::newEdge() {
    const auto value = chosen();
    if (!value || !value->ofEdge()) return;
    EdgeLine fresh{value->edge.tool, 0};
    for (const EdgeLine& one : edges_)
        if (one.tool == fresh.tool && edgeOf(context_.live, one))
            fresh.edge = std::max(fresh.edge, one.edge);
    ++fresh.edge;
    const double type = edgeValue(context_.live, value->edge, kDpType);
    context_.requests.store(
        {{"do", "offsets.set"},
         {"channel", static_cast<int>(context_.channel)},
         {"tool", fresh.tool},
         {"edge", fresh.edge},
         {"dp", kDpType},
         {"value", type ? type : kTurningTool}},
        [this, fresh](const Answer& answer) {
            if (answer.ok)
                context_.tell(word("%1 is new").arg(edgeTitle(context_.live, fresh)), Told::Good);
        });
}

// Numbers of edges have no gaps: only the last one goes. Not the one that the running block works
// with.
bool Offsets::mayDelete() const {
    const auto value = chosen();
    if (!context_.live.connected() || !value || !value->ofEdge() ||
        !edgeOf(context_.live, value->edge))
        return false;
    return std::none_of(edges_.begin(), edges_.end(),
                        [&](const EdgeLine& one) {
                            return one.tool == value->edge.tool && one.edge > value->edge.edge;
                        }) &&
           !active(at(table_->row()));
}

void Offsets::deleteEdge() {
    const auto value = chosen();
    const ToolEdge* edge = value && value->ofEdge() ? edgeOf(context_.live, value->edge) : nullptr;
    if (!edge || !mayDelete()) return;
    Value whole = *value;
    whole.title = edgeTitle(context_.live, value->edge);
    whole.dp = 0;
    whole.present = 1;
    whole.words = QString("edge L%1 T%2 D%3 DP0")
                      .arg(context_.channel)
                      .arg(value->edge.tool)
                      .arg(value->edge.edge);
    for (std::size_t dp = 1; dp < edge->dp.size(); ++dp)
        if (edge->dp[dp] != 0) whole.gone.emplace_back(static_cast<int>(dp), edge->dp[dp]);
    setEdge(whole, false);
}

// In one request, so that an edge is there whole or not at all. What no value is left of is no edge
// any more.
void Offsets::setEdge(const Value& value, bool undone) {
    QJsonObject fields;
    for (const auto& [dp, held] : value.gone)
        fields.insert(QString("D%1.DP%2").arg(value.edge.edge).arg(dp), undone ? held : 0.0);
    undo_.asked();
    context_.requests.store(
        {{"do", "tools.set"}, {"tool", value.edge.tool}, {"fields", fields}},
        [this, value, undone](const Answer& answer) {
            if (!answer.ok) return undo_.refused();
            if (undone)
                undo_.takenBack({value, 0, 1});
            else
                undo_.entered({value, 1, 0});
            context_.tell(
                (undone ? word("%1 is there again") : word("%1 is deleted")).arg(value.title),
                Told::Good);
            pad_->clear();
            refresh();
        });
}

// Who has changed it before, since the store was begun.
void Offsets::askHistory() {
    const auto value = chosen();
    history_.clear();
    historyOf_ = value ? value->words : QString();
    if (!value || !context_.live.connected()) return;
    const QStringList words = value->words.split(' ');
    const QString about =
        value->ofEdge()
            ? QString("tool %1 D%2 DP%3").arg(value->edge.tool).arg(value->edge.edge).arg(value->dp)
        : zeros_ ? QString("%1 %2 place %3").arg(words[1], words[2]).arg(value->place + 1)
                 : QString("%1 offset %2 %3 %4").arg(words[1], words[2], words[3], words[4]);
    context_.requests.store(
        {{"do", "history.list"}, {"of", about}, {"most", 40}},
        [this, of = historyOf_, value = *value](const Answer& answer) {
            if (!answer.ok || historyOf_ != of) return;
            history_.clear();  // it may have been asked for twice
            for (const auto& entry : answer.object.value("history").toArray()) {
                const QJsonObject one = entry.toObject();
                const auto number = [&](const char* name) {
                    return value.text(one.value(name).toString().toDouble());
                };
                history_ << QString::fromUtf8("%1  %2: %3 → %4")
                                .arg(shortMomentText(QDateTime::fromString(
                                                         one.value("utc").toString(), Qt::ISODate)
                                                         .toLocalTime(),
                                                     "HH:mm"),
                                     one.value("who").toString(), number("old"), number("new"));
            }
            side_->refresh();
        },
        true);
}

// The present value, whichever table is shown.
double Offsets::presentOf(const Value& value) const {
    if (!value.gone.empty()) return edgeOf(context_.live, value.edge) ? 1 : 0;
    if (value.ofEdge()) return edgeValue(context_.live, value.edge, value.dp);
    const ChannelStore& store = context_.live.store(value.channel);
    return value.zero
               ? store.zeros[value.row * kChannelAxes + static_cast<std::size_t>(value.place)]
               : cellValue(store.offsets[value.row], value.field);
}

void Offsets::enter(bool added) { pad_->enter(added); }

// The tool's tip is at a measured position: geometry (with the wear that there is) follows from
// where the axis is.
void Offsets::measure() {
    const auto value = chosen();
    const auto typed = pad_->held();
    if (!value || !typed || zeros_ || value->place < 0) return;
    const ChannelView& view = context_.live.view(context_.channel);
    const auto place = static_cast<std::size_t>(value->place);
    const AxisConfig& axis =
        context_.live.config().axis(context_.live.config().channel(context_.channel).axes[place]);
    double zero = 0;
    if (!context_.live.zeroNow(context_.channel, static_cast<unsigned>(place), zero))
        zero = context_.live.tableZero(
            context_.channel, static_cast<unsigned>(place),
            view.known ? view.picture.zero_row : static_cast<std::int32_t>(kZeroG54));
    // Where the axis is and what the wear is by then, the store knows best; which zero acts,
    // the program.
    const char* const field = axis.role == PlaneRole::BasicX   ? "X"
                              : axis.role == PlaneRole::BasicY ? "Y"
                                                               : "Z";
    pad_->clear();
    undo_.asked();
    askStore(*value,
             {{"do", "offsets.measure"},
              {"table", value->ofEdge() && value->dp >= kDpBase && value->dp <= kDpBase + 2
                            ? "second"
                            : "geometry"},
              {"field", field},
              {"value", *typed},
              {"zero_at", shown(axis, zero)}},
             [this, value = *value](const Answer& answer) { entered(value, answer); });
}

// The position of the tool's tip is to be called so in this zero: its value follows from where the
// axis is.
void Offsets::zeroHere() {
    const auto value = chosen();
    if (!value || !zeros_) return;
    const auto typed = pad_->held();
    const ChannelView& view = context_.live.view(context_.channel);
    const auto place = static_cast<std::size_t>(value->place);
    const AxisConfig& axis =
        context_.live.config().axis(context_.live.config().channel(context_.channel).axes[place]);
    // also of one that a program before has left
    const double tool = shown(axis, view.toolShift[place]);
    const QStringList words = value->words.split(' ');  // «zero L1 G54 Z»
    pad_->clear();
    undo_.asked();
    context_.requests.store(
        {{"do", "zeros.here"},
         {"channel", static_cast<int>(context_.channel)},
         {"zero", words[2]},
         {"field", words[3]},
         {"value", typed.value_or(0.0)},
         {"length", tool}},
        [this, value = *value](const Answer& answer) { entered(value, answer); });
}

void Offsets::resizeEvent(QResizeEvent*) { layOut(); }

void Offsets::layOut() {
    const int top = px(46), edge = px(8), side = px(330), pad = px(380);
    head_->setGeometry(0, 0, width(), top);
    const Parted all = parted(*this, QRect(edge, top, width() - 2 * edge, height() - top - edge),
                              side, px(400), edge);
    const Padded right = padded(*this, all.side, px(346), pad, edge);
    const int search = px(44);
    find_->setGeometry(all.main.left(), all.main.top(), all.main.width(), search);
    table_->setGeometry(all.main.adjusted(0, search, 0, 0));
    side_->setGeometry(right.rest);
    pad_->setGeometry(right.pad);
    parts_->setGeometry(0, top, width(), height() - top);
    for (Sheet* one : sheets()) one->refresh();
}

void Offsets::composeSide(Writer& w) {
    const Theme& t = theme();
    const double wide = side_->width(), high = side_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    double y = px(8);
    const auto line = [&](const QString& name, const QString& value, const QColor& colour) {
        w.text(QRectF(px(12), y, wide * 0.5, px(22)), name, lettering(14), t.dim);
        w.text(QRectF(wide * 0.5, y, wide * 0.5 - px(12), px(22)), value, lettering(15, true),
               colour, kRight);
        y += px(23);
    };
    if (const auto value = chosen()) {
        double applied = 0, sum = 0;
        const ChannelView& view = context_.live.view(context_.channel);
        const BlockPicture& p = view.picture;
        if (value->ofEdge()) {
            const QString kind =
                kindText(static_cast<std::int32_t>(edgeValue(context_.live, value->edge, kDpType)));
            w.data(QRectF(px(12), y, wide - px(24), px(22)),
                   edgeTitle(context_.live, value->edge) +
                       (kind.isEmpty() ? QString() : QString::fromUtf8("  ·  ") + kind),
                   lettering(14, true), t.text);
            y += px(24);
        }
        // these act with each of the others
        const auto zeroActs = [&](std::size_t row) {
            return p.zero_row == static_cast<std::int32_t>(row) || row == kZeroExternal ||
                   row == kZeroShift;
        };
        const bool acts = zeros_ ? view.known && zeroActs(value->row) : active(at(table_->row()));
        if (acts && appliedNow(*value, applied, sum)) {
            const bool same = std::abs(applied - sum) <= 5e-7;
            line(zeros_ ? word("All zeros together") : word("Geometry + wear"), value->text(sum),
                 t.text);
            line(word("Applied now"), value->text(applied), same ? t.good : t.warn);
            w.sign(QRectF(px(12), y + px(2), px(16), px(16)), same ? Sign::Good : Sign::Wait,
                   same ? t.good : t.warn);
            w.text(QRectF(px(34), y, wide - px(44), px(22)),
                   same              ? word("Active")
                   : zeros_          ? word("Active from the next blocks")
                   : value->ofEdge() ? word("Active at the next T or D")
                                     : word("Active at the next T"),
                   lettering(14), same ? t.good : t.warn);
        } else {
            w.text(QRectF(px(12), y, wide - px(24), px(22)),
                   word("Not in use by the running program"), lettering(14), t.dim);
        }
        y += px(28);
    }
    w.line(QPointF(px(12), y), QPointF(wide - px(12), y), t.edge, 1);
    y += px(4);
    w.text(QRectF(px(12), y, wide - px(24), px(20)), word("Who has changed this value"),
           lettering(12.5, false, Face::Condensed), t.dim);
    y += px(21);
    if (history_.isEmpty() && chosen())
        w.text(QRectF(px(12), y, wide - px(24), px(44)), word("No changes recorded."),
               lettering(13, false, Face::Condensed), t.dim, Qt::AlignLeft | Qt::AlignTop)
            .wraps = true;
    for (auto entry = history_.begin(); entry != history_.end() && y + px(20) < high;
         ++entry, y += px(20))
        w.data(QRectF(px(12), y, wide - px(24), px(20)), *entry,
               lettering(13, false, Face::Condensed), t.text);
}

// Another screen leads here.
void Offsets::goTo(std::int32_t tool, std::int32_t edge) {
    showParts(false);
    showZeros(false);
    if (built_ != context_.channel || edged_ != usesEdges(context_.live, context_.channel)) build();
    if (!search_.isEmpty()) find({});
    const auto line = std::find(edges_.begin(), edges_.end(), EdgeLine{tool, edge});
    const ToolRow* row = toolOf(context_.live, tool);
    const int wanted = edged_
                           ? (line == edges_.end() ? -1 : static_cast<int>(line - edges_.begin()))
                       : row ? row->h_cell - 1
                             : -1;
    if (wanted >= 0 && wanted < rowsInAll()) table_->choose(wanted, firstColumn());
}

void Offsets::refresh() {
    undo_.goOn();
    if (const std::int32_t tool = std::exchange(context_.toolOfOffsets, 0))
        goTo(tool, context_.edgeOfOffsets);
    if (built_ != context_.channel || edged_ != usesEdges(context_.live, context_.channel))
        build();
    else if (byEdges() && edgesOf_ != context_.live.toolsVersion())
        takeEdges();
    else if (!search_.isEmpty() && foundFor_ != context_.live.toolsVersion())
        filter();
    if (partsShown_) {
        head_->refresh();
        return parts_->refresh();
    }
    for (Sheet* one : sheets()) one->refresh();
}

std::vector<SoftKey> Offsets::keys() {
    const bool ready =
        context_.live.connected() && pad_->entry().has_value() && chosen().has_value();
    const auto value = chosen();
    const Undo::Change* last = undo_.newest();
    const bool empty = pad_->text().isEmpty(), placed = value.has_value() && value->place >= 0;
    std::vector<SoftKey> keys{
        {edged_ ? word("Tool edges") : word("Tool offsets"),
         [this] {
             showParts(false);
             showZeros(false);
         },
         Sign::Tools, true, !zeros_ && !partsShown_},
        {word("Work zeros"),
         [this] {
             showParts(false);
             showZeros(true);
         },
         Sign::Offsets, true, zeros_ && !partsShown_},
        {word("Measured parts"), [this] { showParts(true); }, Sign::Parameters, true, partsShown_},
        {}};
    if (partsShown_) {
        parts_->addKeys(keys);
        return keys;
    }
    // «offset L1 3 wear X», with what is typed: another one of them is another question.
    const QStringList words = value ? value->words.split(' ') : QStringList();
    const auto brief = [](const QStringList& of) {
        return of.size() < 4 ? QString()
               : of[0] == "edge"
                   ? QString("%1 %2 %3").arg(of[2], of[3], edgeParameterTitle(of[4].mid(2).toInt()))
                   : QString("%1 %2 %3").arg(of[1], of[2], of.last());
    };
    const QString subject = value ? value->words + "=" + pad_->text() : QString(),
                  object = brief(words);
    const QString asks = !zeros_   ? word("Enters what was touched: press again")
                         : probe() ? word("Probe is offset %1: press again").arg(probe())
                                   : word("Without a probe offset: press again");
    keys.back() = {zeros_ ? word("Workpiece setter") : word("Tool setter"),
                   [this] { touched(); },
                   Sign::None,
                   context_.live.connected() && value.has_value(),
                   false,
                   false,
                   asks,
                   {},
                   subject,
                   object};
    if (empty && !zeros_)
        keys.push_back({word("Relative input"),
                        [this] { relativeInput(); },
                        Sign::None,
                        context_.live.connected() && placed,
                        false,
                        false,
                        word("Enters the relative counter: press again"),
                        {},
                        subject,
                        object});
    else
        keys.push_back({word("Input"), [this] { enter(false); }, Sign::None, ready});
    if (empty && byEdges())
        keys.push_back({word("Base lengths"),
                        [this] {
                            base_ = !base_;
                            build();
                            table_->choose(table_->row(), firstColumn());
                            refresh();
                        },
                        Sign::None, context_.live.connected(), base_});
    else
        keys.push_back({word("+ Input"), [this] { enter(true); }, Sign::None, ready});
    if (zeros_)
        keys.push_back({pad_->text().isEmpty() ? word("Zero here") : word("This is here"),
                        [this] { zeroHere(); },
                        Sign::None,
                        value.has_value() && (pad_->text().isEmpty() || ready),
                        false,
                        false,
                        word("Sets the zero: press again"),
                        {},
                        subject,
                        object});
    else if (empty)
        keys.push_back({word("Relative zero"), [this] { relativeZero(); }, Sign::None,
                        context_.live.connected()});
    else
        keys.push_back({word("Measured"),
                        [this] { measure(); },
                        Sign::None,
                        ready && value->place >= 0 && !value->wear(),
                        false,
                        false,
                        word("Tip is at this measure: press again"),
                        {},
                        subject,
                        object});
    keys.push_back({word("Undo"),
                    [this] { undo_.undo(); },
                    Sign::Undo,
                    last != nullptr,
                    false,
                    false,
                    {},
                    {},
                    {},
                    last ? brief(last->where.words.split(' ')) : QString()});
    if (byEdges()) {
        keys.push_back({word("New edge"), [this] { newEdge(); }, Sign::None,
                        context_.live.connected() && value.has_value()});
        const QString edge =
            value && value->ofEdge() ? edgeTitle(context_.live, value->edge) : QString();
        keys.push_back({word("Delete edge"),
                        [this] { deleteEdge(); },
                        Sign::Bin,
                        mayDelete(),
                        false,
                        false,
                        word("Its values go: press again"),
                        {},
                        edge,
                        value ? QString("D%1").arg(value->edge.edge) : QString()});
    }
    // The pattern menu of the fanuc family's macros: the program O9500 builds it, and its dialogue
    // comes up.
    if (keys.size() < 10 &&
        params::get_text(context_.live.table(), params::pt_language, context_.channel) == "fanuc")
        keys.push_back(
            {word("Pattern menu"),
             [this] {
                 // the mode is the operator's
                 if (static_cast<ChannelMode>(context_.live.channel(context_.channel).mode) ==
                     ChannelMode::Auto)
                     return context_.tell(
                         word("L%1 is in automatic mode: choose Jog or MDI").arg(context_.channel),
                         Told::Refused);
                 context_.requests.press(QString("hand_key L%1 M98 P9500").arg(context_.channel));
             },
             Sign::Note,
             context_.live.connected() &&
                 static_cast<ChannelState>(context_.live.channel(context_.channel).state) !=
                     ChannelState::Running});
    return keys;
}

bool Offsets::key(QKeyEvent* event) {
    if (partsShown_) return parts_->key(event);
    if (event->key() == Qt::Key_Escape && pad_->text().isEmpty() && !search_.isEmpty()) {
        find({});
        return true;
    }
    if (event->key() == Qt::Key_Backspace && pad_->text().isEmpty() && !search_.isEmpty()) {
        find(search_.chopped(1));
        return true;
    }
    if (pad_->key(event)) return true;
    return table_->key(event);
}

}  // namespace polyturn::hmi
