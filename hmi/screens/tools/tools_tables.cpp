// The tables of the screen of tools: one tool's data, lives with their forecast, pallets.
#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

#include "hmi/screens/tools/tools.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"

namespace polyturn::hmi {

// A column of the tool table as it is shown; of the others the command line tells (tools fields).
struct Tools::Shown {
    const char* field;
    const char* title;
    const char* unit;
};
const Tools::Shown Tools::kShown[] = {
    {"name", WORD("Name"), ""},
    {"type", WORD("Type number: the T that calls it"), ""},
    {"duplo", WORD("Order among sisters"), ""},
    {"kind", WORD("Kind: 500 roughing, 510 finishing, 200 drill ..."), ""},
    {"h", WORD("Offset number"), ""},
    {"life_kind", WORD("Life measured in"), ""},
    {"life", WORD("Tool life (0: not monitored)"), "life"},
    {"counter", WORD("Used up"), "life"},
    {"warning", WORD("So much left is a warning"), "life"},
    {"enabled", WORD("May be used"), ""},
    {"locked", WORD("Locked"), ""},
    {"worn", WORD("Worn"), ""},
    {"broken", WORD("Broken"), ""},
    {"measured", WORD("Measured"), ""},
    {"group", WORD("Life group of programs"), ""},
    {"unit", WORD("Tool unit, 0 all"), ""},
    {"d", WORD("Offset number of the radius"), ""},
    {"place_type", WORD("Kind of place that it needs, 0 any"), ""},
    {"home_magazine", WORD("Own magazine"), ""},
    {"home_pot", WORD("Own place"), ""},
    {"fixed", WORD("Goes back to its own place"), ""},
    {"size_left", WORD("Room to the left, half places"), ""},
    {"size_right", WORD("Room to the right, half places"), ""},
    {"size_up", WORD("Room above, half places"), ""},
    {"size_down", WORD("Room below, half places"), ""},
    {"length", WORD("Length"), "mm"},
    {"diameter", WORD("Diameter"), "mm"},
    {"weight", WORD("Weight"), "kg"},
    {"speed", WORD("Largest speed"), "1/min"},
    {"outline", WORD("Outline that protection guards: X -60:0 Z -20:5"), "mm"}};

namespace {

const char* kindWord(unsigned kind) {
    static constexpr const char* kWords[] = {
        WORD("nothing"), WORD("minutes of cutting"), WORD("pieces"),
        WORD("uses"),    WORD("metres of cutting"),  WORD("wear")};
    return kWords[std::min<std::size_t>(kind, std::size(kWords) - 1)];
}

}  // namespace

int Tools::shownFields() { return static_cast<int>(std::size(kShown)); }

bool Tools::rowOfOffsets() const {
    const int row = table_->row();
    return page_ == Page::Data && chosen() &&
           (row >= shownFields()
                ? row < table_->rows()
                : std::string_view(kShown[row].field) == "h" && chosen()->h_cell > 0);
}

bool Tools::textField() const {
    return page_ == Page::Data && table_->row() < static_cast<int>(std::size(kShown)) &&
           tool_field(kShown[table_->row()].field).is_text();
}

void Tools::fillData() {
    version_ = context_.live.toolsVersion();
    table_->columns = {{word("What"), 3}, {word("Value"), 1.6, kRight}, {word("Unit"), 0.6}};
    table_->rowUnits = 34;
    table_->nothing = word("No tool is chosen.");
    table_->rows = [this] {
        takeEdgeRows();
        return chosen() ? static_cast<int>(std::size(kShown) + edgeRows_.size()) : 0;
    };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        const ToolRow* tool = chosen();
        if (!tool) return {};
        if (row >= static_cast<int>(std::size(kShown)))
            return edgeCell(static_cast<std::size_t>(row) - std::size(kShown), column);
        const Shown& one = kShown[row];
        const ToolField& field = tool_field(one.field);
        if (column == 0) return {word(one.title), t.text};
        const bool length =
            std::string_view(one.unit) == "mm" &&
            (field.type == ToolFieldType::Number || field.type == ToolFieldType::Outline);
        const LengthUnit unit = length ? context_.live.commonUnit() : LengthUnit{};
        if (column == 2)
            return {std::string_view(one.unit) == "life" ? lifeUnit(tool->life_kind)
                    : length                             ? unit.name()
                                                         : unitWord(one.unit),
                    t.dim};
        const bool here = row == table_->row() && textField() && !typed_.isEmpty();
        if (here) return {typed_ + QString::fromUtf8("▏"), t.accent, Sign::None, true};
        if (field.type == ToolFieldType::Flag) {
            const bool on = tool_number(*tool, field) != 0;
            return {on ? word("yes") : word("no"), on ? t.text : t.dim,
                    on ? Sign::Good : Sign::None, on};
        }
        if (field.type == ToolFieldType::Life)
            return {word(kindWord(tool->life_kind)), t.text, Sign::None, true};
        if (field.is_text()) {
            const QString text = QString::fromStdString(tool_text(*tool, field));
            return {unit.inch() ? scaledNumbers(text, 1 / unit.size()) : text, t.text, Sign::None,
                    true};
        }
        const double value = tool_number(*tool, field);
        return {numberText(unit.of(value), unit.inch() ? 4 : 3),
                value == field.fallback ? t.dim : t.text, Sign::None, value != field.fallback};
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const ToolRow* tool = chosen();
        if (page_ != Page::Data || !tool || table_->row() >= static_cast<int>(std::size(kShown)))
            return std::nullopt;
        const Shown& one = kShown[table_->row()];
        const ToolField& field = tool_field(one.field);
        if (field.type != ToolFieldType::Number && field.type != ToolFieldType::Whole)
            return std::nullopt;
        if (std::string_view(one.unit) == "mm") {
            const LengthUnit unit = context_.live.commonUnit();
            return NumberPad::Field{word(one.title), unit.name(), tool_number(*tool, field),
                                    unit.digits(3),  false,       unit.size()};
        }
        return NumberPad::Field{
            word(one.title),
            std::string_view(one.unit) == "life" ? lifeUnit(tool->life_kind) : unitWord(one.unit),
            tool_number(*tool, field),
            field.type == ToolFieldType::Whole ? 0u : 3u,
            false,
            1,
            field.type != ToolFieldType::Whole};
    };
    pad_->onInput = [this](double now) {
        if (page_ == Page::Data) setField(kShown[table_->row()].field, numberText(now, 6));
    };
    // The store adds: the machine counts lives up while they are looked at.
    pad_->onAdded = [this](double delta) {
        if (page_ == Page::Data) addToField(kShown[table_->row()], delta);
    };
}

void Tools::addToField(const Shown& one, double delta) {
    if (!tool_) return;
    const std::int32_t tool = tool_;
    const ToolField& field = tool_field(one.field);
    const bool length = std::string_view(one.unit) == "mm" && field.type == ToolFieldType::Number;
    const LengthUnit unit = length ? context_.live.commonUnit() : LengthUnit{};
    const QJsonObject entry{{"delta", std::round(delta * 1e9) / 1e9}};
    context_.requests.store(
        {{"do", "tools.set"}, {"tool", tool}, {"fields", QJsonObject{{one.field, entry}}}},
        [this, tool, unit, title = one.title](const Answer& answer) {
            if (!answer.ok) return;
            const QJsonObject told = answer.object.value("entries").toArray().at(0).toObject();
            const auto number = [&](const char* name) {
                return numberText(unit.of(told.value(name).toDouble()), unit.inch() ? 4 : 3);
            };
            context_.tell(QString::fromUtf8("T%1  %2: %3 → %4")
                              .arg(tool)
                              .arg(word(title), number("old"), number("new")),
                          Told::Good);
        });
}

// The edges of the tool, read only: they are entered where offsets are. What an edge has no value
// of is left out, but for its lengths.
void Tools::takeEdgeRows() {
    edgeRows_.clear();
    if (!chosen()) return;
    const ToolEdgeTable& table = context_.live.edges();
    const auto* const end = table.edges.data() + std::min<std::size_t>(table.count, kToolEdges);
    const auto* at =
        std::lower_bound(table.edges.data(), end, tool_,
                         [](const ToolEdge& edge, std::int32_t tool) { return edge.tool < tool; });
    for (; at != end && at->tool == tool_; ++at)
        for (int dp = 1; dp < static_cast<int>(at->dp.size()); ++dp)
            if (at->dp[static_cast<std::size_t>(dp)] != 0 || dp == kDpLength || dp == kDpLength + 1)
                edgeRows_.push_back({{tool_, at->number}, dp});
}

Table::Cell Tools::edgeCell(std::size_t row, int column) const {
    const Theme& t = theme();
    if (row >= edgeRows_.size()) return {};
    const auto& [line, dp] = edgeRows_[row];
    const bool length =
        isLength(dp) || dp == kDpRadius || dp == kDpWearRadius || dp == kDpBaseRadius;
    const LengthUnit unit = length ? context_.live.commonUnit() : LengthUnit{};
    const double value = edgeValue(context_.live, line, dp);
    if (column == 0) return {QString("D%1  %2").arg(line.edge).arg(edgeParameterTitle(dp)), t.dim};
    if (column == 2) return {length ? unit.name() : QString(), t.dim};
    if (dp == kDpType)
        return {kindText(static_cast<std::int32_t>(value)) + QString("  %1").arg(value, 0, 'f', 0),
                t.dim};
    return {length ? unit.text(value, 3) : numberText(value, 4), value == 0 ? t.faint : t.dim};
}

// Enter: a switch turns over, what its life counts goes on to the next, a text is taken.
void Tools::fieldActivated() {
    const ToolRow* tool = chosen();
    if (tool && table_->row() >= shownFields()) return toOffsets();
    if (!tool) return;
    const Shown& one = kShown[table_->row()];
    const ToolField& field = tool_field(one.field);
    if (field.type == ToolFieldType::Flag)
        setField(one.field, tool_number(*tool, field) != 0 ? "0" : "1");
    else if (field.type == ToolFieldType::Life)
        setField(one.field, fromView(kLifeKinds[(tool->life_kind + 1) % std::size(kLifeKinds)]));
    else if (field.is_text() && !typed_.isEmpty()) {
        const QString text = std::exchange(typed_, QString());
        const LengthUnit unit = context_.live.commonUnit();
        setField(one.field, field.type == ToolFieldType::Outline && unit.inch()
                                ? scaledNumbers(text, unit.size())
                                : text);
    }
}

void Tools::fillLife() {
    table_->columns = {{word("Called by"), 1.1},
                       {word("No."), 0.6, kRight},
                       {word("Tool"), 1.9},
                       {word("Life left"), 1.8},
                       {word("State"), 1.8},
                       {word("Parts left"), 1.25, kRight},
                       {word("Time left"), 1.15, kRight}};
    table_->rowUnits = 38;
    table_->nothing = word("There are no tools yet: «New tool» on the page of tool data.");
    table_->rows = [this] { return static_cast<int>(life_.size()); };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        const LifeLine& line = life_[static_cast<std::size_t>(row)];
        const ToolRow* tool = toolOf(context_.live, line.tool);
        if (!tool) return {};
        // no forecast yet, or a life that is not watched
        const Table::Cell none{QString::fromUtf8("–"), t.faint};
        // the first of its sisters tells of all
        const bool opens = row == 0 || life_[static_cast<std::size_t>(row - 1)].group != line.group;
        switch (column) {
            case 0:
                return opens ? Table::Cell{line.group, line.first ? t.warn : t.text,
                                           line.first ? Sign::Warning : Sign::None, true}
                             : Table::Cell{};
            case 1:
                return {QString::number(line.tool), t.dim};
            case 2:
                return {toolName(*tool, line.tool), t.text};
            case 3: {
                Table::Cell cell{lifeText(*tool), colourOf(lifeTone(*tool))};
                cell.bar = lifeLeft(*tool);
                return cell.bar < 0 ? Table::Cell{word("not monitored"), t.dim} : cell;
            }
            case 4: {
                const StateWords state = toolWords(*tool);
                return {state.text, colourOf(state.tone), state.sign};
            }
            case 5:
                return opens && line.parts >= 0
                           ? Table::Cell{QString::number(line.parts, 'f', 0),
                                         line.first ? t.warn : t.text, Sign::None, true}
                       : opens ? none
                               : Table::Cell{};
            default:
                return opens && line.minutes >= 0 ? Table::Cell{timeText(line.minutes * 60), t.dim}
                       : opens                    ? none
                                                  : Table::Cell{};
        }
    };
    detail_->refresh();
}

void Tools::fillPallets() {
    table_->columns = {{word("Station"), 2}, {word("Pallet"), 1, kRight}, {word("Program"), 3}};
    table_->rowUnits = 40;
    table_->nothing = whyNoPallets_.isEmpty() ? word("The pallets are being asked for ...")
                                              : word("This machine has no pallets (N3300).");
    table_->rows = [this] { return static_cast<int>(pallets_.size()); };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        const Pallet& one = pallets_[static_cast<std::size_t>(row)];
        if (column == 0) {
            const QString title = one.station == "working area" ? word("Working area")
                                  : one.station == "loading station"
                                      ? word("Loading station")
                                      : word("Pool %1").arg(one.station.mid(5));
            return {title, one.row == taken_ ? t.accent : t.text,
                    one.row == taken_ ? Sign::Right : Sign::None, one.row == 1};
        }
        if (column == 1)
            return {one.number > 0 ? numberText(one.number) : QString::fromUtf8("–"),
                    one.number > 0 ? t.text : t.dim, Sign::None, true};
        return {one.program, t.text, Sign::None, false, Face::Program};
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        if (page_ != Page::Pallets || table_->row() >= static_cast<int>(pallets_.size()))
            return std::nullopt;
        return NumberPad::Field{word("Pallet number, 0: no pallet"),
                                {},
                                pallets_[static_cast<std::size_t>(table_->row())].number,
                                0,
                                false,
                                1,
                                false};
    };
    pad_->onInput = [this](double now) {
        if (page_ != Page::Pallets || table_->row() >= static_cast<int>(pallets_.size())) return;
        context_.requests.store({{"do", "pallets.set"},
                                 {"row", pallets_[static_cast<std::size_t>(table_->row())].row},
                                 {"fields", QJsonObject{{"pallet", numberText(now)}}}},
                                [this](const Answer& answer) {
                                    if (answer.ok) context_.tell(word("Written"), Told::Good);
                                    lookAt_ = 0;
                                });
    };
}

// The program that goes with the chosen pallet.
void Tools::askProgram() {
    if (table_->row() >= static_cast<int>(pallets_.size())) return;
    const Pallet pallet = pallets_[static_cast<std::size_t>(table_->row())];
    context_.ask(
        {word("Program of the pallet"),
         pallet.program,
         {},
         [this, row = pallet.row](const QString& text) {
             context_.requests.store(
                 {{"do", "pallets.set"}, {"row", row}, {"fields", QJsonObject{{"program", text}}}},
                 [this](const Answer& answer) {
                     if (answer.ok) context_.tell(word("Written"), Told::Good);
                     lookAt_ = 0;
                 });
         }});
}

// How the chosen field is entered.
void Tools::composeSide(Writer& w) {
    const Theme& t = theme();
    const double wide = side_->width(), high = side_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    QString words;
    if (page_ == Page::Pallets)
        words = word(
            "The pallet in a row goes with its program. «Exchange»: choose a row, press, "
            "choose the other row, press again.");
    else if (textField())
        words = word("Type, then Enter.");
    else if (pad_->field && pad_->field())
        words = word("Type a number or touch it, then Input.");
    else
        words = word("Enter, or a second touch, changes it.");
    // what is typed, in the place of a number's keys
    if (const ToolRow* tool = chosen(); tool && textField()) {
        const Shown& one = kShown[table_->row()];
        const ToolField& field = tool_field(one.field);
        const QString present = QString::fromStdString(tool_text(*tool, field));
        const LengthUnit unit =
            field.type == ToolFieldType::Outline ? context_.live.commonUnit() : LengthUnit{};
        w.data(QRectF(px(14), px(6), wide - px(28), px(24)), word(one.title), lettering(15, true),
               t.text);
        w.field(QRectF(px(12), px(34), wide - px(24), px(44)), typed_, QString(), true, 0);
        w.data(QRectF(px(14), px(80), wide - px(28), px(24)),
               unit.inch() ? scaledNumbers(present, 1 / unit.size()) : present, lettering(15),
               t.dim, kRight);
        w.text(QRectF(px(14), px(108), wide - px(28), px(48)), words, lettering(15), t.dim,
               Qt::AlignLeft | Qt::AlignTop)
            .wraps = true;
        return;
    }
    Item& item = w.text(QRectF(px(14), px(10), wide - px(28), high - px(20)), words, lettering(15),
                        t.dim, Qt::AlignLeft | Qt::AlignTop);
    item.wraps = true;
    if (page_ == Page::Pallets && table_->row() < static_cast<int>(pallets_.size()))
        w.field(QRectF(px(12), high - px(54), wide - px(24), px(44)),
                pallets_[static_cast<std::size_t>(table_->row())].program,
                word("Program of the pallet"), false, 1, Face::Program);
}

}  // namespace polyturn::hmi
