#include "hmi/machine/tools/offset_table.hpp"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/tools/tool_words.hpp"
#include "hmi/text/search.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

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
const QString kDiameterSign = QString::fromUtf8(" ⌀");
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
constexpr int kEdgeColumns[] = {kDpType,   kDpTip,  kDpLength,   kDpLength + 1, kDpLength + 2,
                                kDpRadius, kDpWear, kDpWear + 1, kDpWear + 2,   kDpWearRadius};
constexpr int kBaseColumns[] = {kDpType,   kDpTip,  kDpLength,   kDpLength + 1, kDpLength + 2,
                                kDpRadius, kDpBase, kDpBase + 1, kDpBase + 2,   kDpBaseRadius};

}  // namespace

QString OffsetValue::text(double held) const { return lengthText(unit.of(held), decimals); }
QString OffsetValue::unitText() const {
    return angle      ? QString(QChar(0xB0))
           : decimals ? unit.name() + (diameter ? kDiameterSign : QString())
                      : QString();
}

// The present value, whichever table is shown.
double presentOf(const Live& live, const OffsetValue& value) {
    if (!value.gone.empty()) return edgeOf(live, value.edge) ? 1 : 0;
    if (value.ofEdge()) return edgeValue(live, value.edge, value.dp);
    const ChannelStore& store = live.store(value.channel);
    return value.zero
               ? store.zeros[value.row * kChannelAxes + static_cast<std::size_t>(value.place)]
               : cellValue(store.offsets[value.row], value.field);
}

bool OffsetTable::isOf(unsigned channel) const {
    return channel_ == channel && edged_ == usesEdges(live_, channel);
}

void OffsetTable::build(unsigned channel, Kind kind, bool base) {
    channel_ = channel;
    kind_ = kind;
    edged_ = usesEdges(live_, channel);
    columns_ = {{zeros()  ? word("Zero")
                 : edged_ ? word("Tool")
                          : word("No."),
                 zeros()  ? 1.3
                 : edged_ ? 2.6
                          : 0.8}};
    fields_ = {' '};
    parameters_ = {0};
    zeroRows_.clear();
    rows_.clear();
    if (!live_.connected() || live_.channels().empty()) return;
    if (zeros())
        addZeroColumns();
    else if (edged_)
        addEdgeColumns(base);
    else
        addOffsetColumns();
}

void OffsetTable::addZeroColumns() {
    for (std::size_t row = 0; row < kWorkZeros; ++row)
        if (!work_zero_name(row).empty() &&
            (row <= kZeroShift || row - kZeroG541 <= kMostZeros || row > kZeroG541 + 300))
            zeroRows_.push_back(row);
    for (const std::uint16_t number : live_.config().channel(channel_).axis_numbers()) {
        const AxisConfig& axis = live_.config().axis(number);
        columns_.push_back({fromView(axis.name_text()) + (axis.rotary     ? QString::fromUtf8(" °")
                                                          : axis.diameter ? kDiameterSign
                                                                          : QString()),
                            1.2, true});
    }
}

void OffsetTable::addEdgeColumns(bool base) {
    takeEdges();
    columns_.push_back({"D", 0.5});
    parameters_.push_back(0);
    const bool third = placeOf(live_, channel_, 'Y') >= 0 ||
                       std::any_of(edges_.begin(), edges_.end(),
                                   [&](EdgeLine one) { return sumOfLength(live_, one, 2) != 0; });
    for (const int dp : base ? kBaseColumns : kEdgeColumns) {
        if (isLength(dp) && lengthOf(dp) == 2 && !third) continue;
        columns_.push_back({edgeParameterTitle(dp),
                            dp == kDpTip                       ? 1.0
                            : dp == kDpType                    ? 0.75
                            : dp >= kDpWear || dp == kDpRadius ? 1.1
                                                               : 1.25,
                            true});
        parameters_.push_back(dp);
    }
}

void OffsetTable::addOffsetColumns() {
    const auto named = [&](const QString& what, char letter) {
        return QString("%1 %2").arg(what).arg(letter) +
               (inDiameter(live_, channel_, letter) ? kDiameterSign : QString());
    };
    const auto add = [&](const QString& title, char field, double share) {
        columns_.push_back({title, share, true});
        fields_.push_back(field);
    };
    for (const char letter : {'X', 'Y', 'Z'})
        if (placeOf(live_, channel_, letter) >= 0) add(named(word("Geom."), letter), letter, 1.25);
    add(word("Radius"), 'R', 1.0);
    add(word("Tip"), 'T', 0.65);
    for (const char letter : {'X', 'Y', 'Z'})
        if (placeOf(live_, channel_, letter) >= 0)
            add(named(word("Wear"), letter), static_cast<char>(letter + 32), 1.05);
    add(word("Wear R"), 'r', 1.0);
}

bool OffsetTable::edgesOutdated() const { return byEdges() && edgesOf_ != live_.toolsVersion(); }

void OffsetTable::takeEdges() {
    edgesOf_ = live_.toolsVersion();
    edges_ = toolsManaged(live_) ? edgeLines(live_, channel_) : std::vector<EdgeLine>();
}

EdgeLine OffsetTable::edgeAt(int row) const {
    return row >= 0 && row < static_cast<int>(edges_.size()) ? edges_[static_cast<std::size_t>(row)]
                                                             : EdgeLine{};
}

int OffsetTable::rowOf(const EdgeLine& edge) const {
    const auto found = std::find(edges_.begin(), edges_.end(), edge);
    return found == edges_.end() ? -1 : static_cast<int>(found - edges_.begin());
}

int OffsetTable::rowsInAll() const {
    if (!live_.connected()) return 0;
    return zeros()  ? static_cast<int>(zeroRows_.size())
           : edged_ ? static_cast<int>(edges_.size())
                    : std::max<int>(0, live_.config().channel(channel_).offset_count);
}

// A number is a whole one: «1» finds T1 and D1, not 11; anything else may be a part of a name.
bool OffsetTable::found(int row) const {
    const QString typed = search_.trimmed();
    if (typed.isEmpty()) return true;
    const auto same = [&](const QString& text) {
        return text.compare(typed, Qt::CaseInsensitive) == 0;
    };
    bool numeric = false;
    typed.toInt(&numeric);
    if (zeros()) {
        const QString name = zeroTitle(
            QString::fromStdString(work_zero_name(zeroRows_[static_cast<std::size_t>(row)])));
        return numeric ? same(QString(name).remove(QRegularExpression("^\\D*"))) ||
                             name.endsWith('P' + typed) || name.endsWith(' ' + typed)
                       : holds(name, typed);
    }
    const auto ofTool = [&](std::int32_t number) {
        const ToolRow* tool = toolOf(live_, number);
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
        if (const ToolRow& tool = live_.tools().rows[i];
            tool.used && tool.h_cell == row + 1 && ofTool(static_cast<std::int32_t>(i + 1)))
            return true;
    return false;
}

void OffsetTable::filter() {
    rows_.clear();
    foundFor_ = live_.toolsVersion();
    for (int row = 0; row < rowsInAll(); ++row)
        if (found(row)) rows_.push_back(row);
}

bool OffsetTable::outdated() const {
    return !search_.isEmpty() && foundFor_ != live_.toolsVersion();
}

QString OffsetTable::nothing() const {
    return !search_.isEmpty() ? word("Nothing is like this. Escape shows all.")
           : !byEdges()       ? word("This channel has no offsets.")
           : toolsManaged(live_)
               ? word("This channel has no tools: enter them on the page of tools.")
               : word("Without tool management (N2900) programs bring their own tools and edges.");
}

int OffsetTable::at(int shown) const {
    return shown >= 0 && shown < static_cast<int>(rows_.size())
               ? rows_[static_cast<std::size_t>(shown)]
               : -1;
}

int OffsetTable::placeOfRow(int row) const {
    const auto here = std::lower_bound(rows_.begin(), rows_.end(), row);
    return std::min(static_cast<int>(here - rows_.begin()),
                    std::max(0, static_cast<int>(rows_.size()) - 1));
}

QString OffsetTable::rowTitle(int row) const {
    return zeros() ? zeroTitle(QString::fromStdString(
                         work_zero_name(zeroRows_[static_cast<std::size_t>(row)])))
                   : QString::number(row + 1);
}

// Where keys go to at the beginning: of an edge its first length, not its type.
int OffsetTable::firstColumn() const {
    if (!byEdges()) return 1;
    const auto length = std::find(parameters_.begin(), parameters_.end(), kDpLength);
    return length == parameters_.end() ? 2 : static_cast<int>(length - parameters_.begin());
}

bool OffsetTable::active(int row) const {
    const ChannelView& view = live_.view(channel_);
    const BlockPicture& p = view.picture;
    if (!view.known || row < 0 || row >= rowsInAll()) return false;
    if (zeros())
        return p.zero_row == static_cast<std::int32_t>(zeroRows_[static_cast<std::size_t>(row)]);
    if (edged_)
        return p.tool == edges_[static_cast<std::size_t>(row)].tool &&
               p.edge == edges_[static_cast<std::size_t>(row)].edge;
    return p.geometry == row + 1 || p.wear == row + 1;
}

std::optional<OffsetValue> OffsetTable::value(int shown, int column) const {
    const int row = at(shown);
    if (!live_.connected() || column < 1 || column >= static_cast<int>(columns_.size()) ||
        row < 0 || row >= rowsInAll())
        return std::nullopt;
    const auto place = static_cast<std::size_t>(column);
    if (zeros()) return zeroValue(zeroRows_[static_cast<std::size_t>(row)], column - 1);
    if (edged_) return edgeCell(edges_[static_cast<std::size_t>(row)], parameters_[place]);
    return offsetValue(row, fields_[place]);
}

std::optional<OffsetValue> OffsetTable::zeroValue(std::size_t zero, int place) const {
    OffsetValue out;
    const ChannelConfig& config = live_.config().channel(channel_);
    out.place = place;
    if (out.place >= config.axis_count) return std::nullopt;
    const AxisConfig& axis = live_.config().axis(config.axes[static_cast<std::size_t>(out.place)]);
    const QString name = QString::fromStdString(work_zero_name(zero)),
                  axisName = fromView(axis.name_text());
    out.words = QString("zero L%1 %2 %3").arg(channel_).arg(name, axisName);
    out.title = QString("L%1  %2  %3").arg(channel_).arg(zeroTitle(name), axisName);
    out.channel = channel_;
    out.zero = true;
    out.row = zero;
    out.present = presentOf(live_, out);
    out.unit = live_.unit(axis);
    out.decimals = out.unit.decimals;
    out.angle = axis.rotary;
    out.diameter = axis.diameter && !axis.rotary;
    return out;
}

std::optional<OffsetValue> OffsetTable::edgeCell(const EdgeLine& edge, int dp) const {
    OffsetValue out;
    out.unit = live_.unit(channel_);
    out.decimals = out.unit.decimals;
    out.edge = edge;
    out.dp = dp;
    if (out.dp == 0) return std::nullopt;
    out.words = QString("edge L%1 T%2 D%3 DP%4")
                    .arg(channel_)
                    .arg(out.edge.tool)
                    .arg(out.edge.edge)
                    .arg(out.dp);
    out.title = QString("%1  %2").arg(edgeTitle(live_, out.edge), edgeParameterTitle(out.dp));
    if (isLength(out.dp)) out.place = placeOfLength(live_, channel_, out.edge, lengthOf(out.dp));
    // a length of the tool: never a diameter
    if (out.place >= 0)
        out.title += QString(" (%1)").arg(fromView(
            live_.config()
                .axis(live_.config().channel(channel_).axes[static_cast<std::size_t>(out.place)])
                .name_text()));
    out.present = edgeValue(live_, out.edge, out.dp);
    if (out.dp == kDpType || out.dp == kDpTip) {
        out.decimals = 0;
        out.unit = {};
    }
    return out;
}

OffsetValue OffsetTable::offsetValue(int row, char field) const {
    OffsetValue out;
    out.unit = live_.unit(channel_);
    out.decimals = out.unit.decimals;
    const bool wear = field >= 'a';
    const char letter = static_cast<char>(wear ? field - 32 : field);
    out.words = QString("offset L%1 %2 %3 %4")
                    .arg(channel_)
                    .arg(row + 1)
                    .arg(wear ? "wear" : "geometry")
                    .arg(letter);
    const QString column_title =
        letter == 'R'   ? (wear ? word("Wear R") : word("Radius"))
        : letter == 'T' ? word("Tip")
                        : QString("%1 %2").arg(wear ? word("Wear") : word("Geom.")).arg(letter);
    out.title =
        QString("L%1  %2 %3  %4").arg(channel_).arg(word("Offset")).arg(row + 1).arg(column_title);
    out.channel = channel_;
    out.row = static_cast<std::size_t>(row) + 1;
    out.field = field;
    out.present = presentOf(live_, out);
    if (letter == 'T') {
        out.decimals = 0;
        out.unit = {};
    }
    out.place = letter == 'R' || letter == 'T' ? -1 : placeOf(live_, channel_, letter);
    out.diameter = out.place >= 0 && inDiameter(live_, channel_, letter);
    return out;
}

bool OffsetTable::appliedNow(const OffsetValue& value, double& applied, double& sum) const {
    const ChannelView& view = live_.view(channel_);
    if (!view.known || value.place < 0) return false;
    const BlockPicture& p = view.picture;
    const auto place = static_cast<std::size_t>(value.place);
    const AxisConfig& axis = live_.config().axis(live_.config().channel(channel_).axes[place]);
    const ChannelStore& store = live_.store(channel_);
    if (zeros()) {
        if (p.flags & kPictureNoShift) return false;
        sum = shown(axis, live_.tableZero(channel_, static_cast<unsigned>(place), p.zero_row));
        // without what the program adds: G52, G92
        applied = live_.rests(channel_) ? sum : shown(axis, view.zeroTaken[place]);
        return true;
    }
    if (value.ofEdge()) {
        // true lengths
        applied = p.tool_shift[place];
        sum = sumOfLength(live_, value.edge, lengthOf(value.dp));
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

}  // namespace polyturn::hmi
