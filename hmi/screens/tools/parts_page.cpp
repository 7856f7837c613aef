#include "hmi/screens/tools/parts_page.hpp"

#include <QDateTime>
#include <QJsonArray>
#include <algorithm>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/tools/tool_words.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kNameHit = 1;

QString signedText(const LengthUnit& unit, double held) {
    return (held > 0 ? "+" : "") + unit.text(held, 3);
}
QString signedWithUnit(const LengthUnit& unit, double held) {
    return QString("%1 %2").arg(signedText(unit, held), unit.name());
}

struct Verdict {
    QString text;
    Sign sign;
    QColor colour;
};
Verdict verdictOf(const QJsonObject& one) {
    const QString verdict = one.value("verdict").toString();
    const Theme& t = theme();
    if (verdict == "good") return {word("good"), Sign::Good, t.good};
    if (verdict == "too large") return {word("too large"), Sign::Up, t.bad};
    if (verdict == "too small") return {word("too small"), Sign::Down, t.bad};
    return {word("not measured"), Sign::None, t.dim};
}

}  // namespace

PartsPage::PartsPage(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      table_(new Table(this)),
      curve_(new FreeSheet(this)),
      pad_(new NumberPad(this)) {
    table_->columns = {{word("No."), 0.6, kRight},
                       {word("Dimension"), 2.0, Qt::AlignLeft | Qt::AlignVCenter, true},
                       {word("Axis"), 0.85, Qt::AlignCenter, true},
                       {word("Tool"), 1.15, kRight, true},
                       {word("Nominal"), 1.25, kRight, true},
                       {word("Upper"), 0.95, kRight, true},
                       {word("Lower"), 0.95, kRight, true},
                       {word("Measured"), 1.45, kRight, true},
                       {word("Deviation"), 1.05, kRight},
                       {word("Proposal"), 1.1, kRight, true}};
    table_->byCell = true;
    table_->rowUnits = 38;
    table_->textUnits = 14;
    table_->rows = [this] { return static_cast<int>(all_.size()); };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const QJsonObject& one = all_[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        const bool measured = one.contains("last");
        const LengthUnit unit = unitOf(one);
        switch (column) {
            case kNumber:
                return {QString::number(one.value("dimension").toInt()), t.dim};
            case kName:
                return {one.value("name").toString(), t.text, Sign::None, true};
            case kAxis:
                return {one.value("axis").toString(), t.text};
            case kTool:
                return {one.value("tool").toInt() ? QString::number(one.value("tool").toInt())
                                                  : QString::fromUtf8("–"),
                        t.text};
            case kNominal:
                return {unit.text(one.value("nominal").toDouble(), 3), t.text, Sign::None, true};
            case kUpper:
                return {signedText(unit, one.value("upper").toDouble()), t.dim};
            case kLower:
                return {signedText(unit, one.value("lower").toDouble()), t.dim};
            case kMeasured:
                return measured ? Table::Cell{unit.text(one.value("last").toDouble(), 3),
                                              verdictOf(one).colour, verdictOf(one).sign, true}
                                : Table::Cell{QString::fromUtf8("–"), t.dim};
            case kDeviation:
                return measured ? Table::Cell{signedText(unit, one.value("deviation").toDouble()),
                                              verdictOf(one).colour}
                                : Table::Cell{};
            default:
                return measured
                           ? Table::Cell{signedText(unit, one.value("proposal").toDouble()),
                                         t.accent,
                                         one.value("limited").toBool() ? Sign::Warning : Sign::None,
                                         true}
                           : Table::Cell{};
        }
    };
    table_->onChosen = [this] {
        pad_->clear();
        curve_->refresh();
        if (context_.keysChanged) context_.keysChanged();
    };
    table_->onActivated = [this] { changeText(); };
    curve_->onCompose = [this](Writer& w) { composeCurve(w); };
    curve_->onTouched = [this](int) {
        table_->choose(table_->row(), kName);
        changeText();
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const QJsonObject* one = chosen();
        const int column = table_->column();
        if (!one || column == kName || column == kAxis) return std::nullopt;
        static constexpr const char* kFields[] = {"",      "",      "",     "", "nominal",
                                                  "upper", "lower", "last", "", "proposal"};
        const QString title =
            QString("%1  %2").arg(one->value("dimension").toInt()).arg(columnTitle(column));
        if (column == kTool)
            return NumberPad::Field{title, {}, one->value("tool").toDouble(), 0u, false, 1, false};
        const LengthUnit unit = unitOf(*one);
        // A new measurement has nothing to do with the one before.
        return NumberPad::Field{title,
                                unit.name(),
                                one->value(kFields[column]).toDouble(),
                                unit.digits(3),
                                false,
                                unit.size(),
                                column != kMeasured};
    };
    pad_->onInput = [this](double value) { entered(value); };
    pad_->onAdded = [this](double delta) { added(delta); };
    table_->choose(0, kMeasured);
}

// Dimensions are held in millimetres; they are shown as the channel that makes them counts.
LengthUnit PartsPage::unitOf(const QJsonObject& dimension) const {
    return context_.live.unit(static_cast<unsigned>(dimension.value("channel").toInt(1)));
}

QString PartsPage::columnTitle(int column) const {
    return column >= 0 && column < static_cast<int>(table_->columns.size())
               ? table_->columns[static_cast<std::size_t>(column)].title
               : QString();
}

const QJsonObject* PartsPage::chosen() const {
    const int row = table_->row();
    return row >= 0 && row < static_cast<int>(all_.size()) ? &all_[static_cast<std::size_t>(row)]
                                                           : nullptr;
}

void PartsPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), right = px(330), pad = px(346);
    const Parted all = parted(*this, rect().adjusted(edge, 0, -edge, -edge), right, px(400), edge);
    const Padded beside = padded(*this, all.side, px(346), pad, edge);
    table_->setGeometry(all.main);
    curve_->setGeometry(beside.rest);
    pad_->setGeometry(beside.pad);
}

void PartsPage::look() {
    lookAt_ = QDateTime::currentMSecsSinceEpoch() + 2'000;
    context_.requests.store(
        {{"do", "parts.list"}},
        [this](const Answer& answer) {
            all_.clear();
            for (const auto& one : answer.object.value("dimensions").toArray())
                all_.push_back(one.toObject());
            for (std::size_t i = 0; wanted_ && i < all_.size(); ++i)
                if (all_[i].value("dimension").toInt() == wanted_) {
                    table_->choose(static_cast<int>(i), table_->column());
                    wanted_ = 0;
                }
            if (context_.keysChanged) context_.keysChanged();
        },
        true);
}

void PartsPage::refresh() {
    if (context_.live.connected() && QDateTime::currentMSecsSinceEpoch() > lookAt_) look();
    if (!context_.live.connected()) all_.clear();
    table_->nothing = word("There are no dimensions yet: «New dimension».");
    for (Sheet* one : sheets()) one->refresh();
}

void PartsPage::ask(QJsonObject operation, const QString& good) {
    const LengthUnit unit = chosen() ? unitOf(*chosen()) : LengthUnit{};
    const bool fresh = operation.value("do") == "parts.add";
    context_.requests.store(std::move(operation), [this, good, unit, fresh](const Answer& answer) {
        if (!answer.ok) return;
        QString text = good;
        if (answer.object.contains("what"))
            text = QString::fromUtf8("%1: %2 → %3")
                       .arg(cellTitle(answer.object.value("what").toString()),
                            unit.text(answer.object.value("old").toDouble(), 3),
                            unit.text(answer.object.value("new").toDouble(), 3));
        if (fresh) wanted_ = answer.object.value("dimension").toInt();
        context_.tell(text, Told::Good);
        look();
    });
}

void PartsPage::set(const QString& field, const QString& value) {
    if (const QJsonObject* one = chosen())
        ask({{"do", "parts.set"},
             {"dimension", one->value("dimension")},
             {"fields", QJsonObject{{field, value}}}},
            word("Written"));
}

void PartsPage::entered(double value) {
    const QJsonObject* one = chosen();
    if (!one) return;
    const QString number = QString::number(value, 'g', 12);
    switch (table_->column()) {
        case kTool:
            return set("tool", number);
        case kNominal:
            return set("nominal", number);
        case kUpper:
            return set("upper", number);
        case kLower:
            return set("lower", number);
        case kMeasured:
            return ask({{"do", "parts.measure"},
                        {"dimension", one->value("dimension")},
                        {"value", number}},
                       word("Measured: %1").arg(unitOf(*one).text(value, 3)));
        case kProposal:
            return ask(
                {{"do", "parts.accept"}, {"dimension", one->value("dimension")}, {"value", number}},
                word("Written"));
        default:
            break;
    }
}

// The store adds: it is asked for its list every two seconds only, and another panel or a measuring
// cycle may have been faster.
void PartsPage::added(double delta) {
    const QJsonObject* one = chosen();
    if (!one) return;
    const QJsonObject entry{{"delta", std::round(delta * 1e9) / 1e9}};
    const auto add = [&](const char* field) {
        ask({{"do", "parts.set"},
             {"dimension", one->value("dimension")},
             {"fields", QJsonObject{{field, entry}}}},
            word("Written"));
    };
    switch (table_->column()) {
        case kNominal:
            return add("nominal");
        case kUpper:
            return add("upper");
        case kLower:
            return add("lower");
        case kProposal:
            return ask({{"do", "parts.accept"},
                        {"dimension", one->value("dimension")},
                        {"delta", entry.value("delta")}},
                       word("Written"));
        default:
            break;
    }
}

// A second touch or Enter: the axis goes on to the next, a name is typed.
void PartsPage::changeText() {
    const QJsonObject* one = chosen();
    if (!one) return;
    if (table_->column() == kAxis) {
        const QString axis = one->value("axis").toString();
        return set("axis", axis == "X" ? "Z" : axis == "Z" ? "Y" : "X");
    }
    if (table_->column() == kName)
        context_.ask(
            {word("Dimension"), one->value("name").toString(), {}, [this](const QString& text) {
                 set("name", text);
             }});
}

// The deviations since the last correction between the limits of the tolerance, and the straight
// line through them.
void PartsPage::composeCurve(Writer& w) {
    const Theme& t = theme();
    const double wide = curve_->width(), high = curve_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const QJsonObject* one = chosen();
    if (!one) return;
    w.field(QRectF(px(8), px(6), wide - px(16), px(36)), one->value("name").toString(),
            word("Name of the dimension"), false, kNameHit);
    const Verdict verdict = verdictOf(*one);
    w.sign(QRectF(px(12), px(48), px(18), px(18)), verdict.sign, verdict.colour);
    w.text(QRectF(px(36), px(45), wide * 0.4, px(24)), verdict.text, lettering(14.5, true),
           verdict.colour);
    const int cell = one->value("cell").toInt(), edge = one->value("edge").toInt();
    const LengthUnit unit = unitOf(*one);
    const QString corrects =
        edge ? word("wear of L%1 T%2 D%3")
                   .arg(one->value("channel").toInt())
                   .arg(one->value("tool").toInt())
                   .arg(edge)
        : cell ? word("wear of L%1 offset %2").arg(one->value("channel").toInt()).arg(cell)
               : word("no offset, no tool");
    w.text(QRectF(wide * 0.4, px(45), wide * 0.6 - px(12), px(24)), corrects,
           lettering(13, false, Face::Condensed), cell || edge ? t.dim : t.warn, kRight);
    const QJsonArray deviations = one->value("deviations").toArray();
    const double upper = one->value("upper").toDouble(), lower = one->value("lower").toDouble();
    double most = std::max(upper, 0.0), least = std::min(lower, 0.0);
    for (const auto& value : deviations) {
        most = std::max(most, value.toDouble());
        least = std::min(least, value.toDouble());
    }
    const double margin = std::max(1e-4, (most - least) * 0.12), left = px(58),
                 right = wide - px(14), top = px(78), bottom = high - px(50);
    most += margin;
    least -= margin;
    const auto y = [&](double value) {
        return bottom - (value - least) / (most - least) * (bottom - top);
    };
    w.fill(QRectF(left, y(upper), right - left, y(lower) - y(upper)), t.window, px(3));
    const auto level = [&](double value, const QColor& colour, double width) {
        w.line({left, y(value)}, {right, y(value)}, colour, width);
        w.text(QRectF(px(4), y(value) - px(9), left - px(10), px(18)), signedText(unit, value),
               lettering(12), t.dim, kRight);
    };
    level(upper, t.bad, 1.5);
    level(lower, t.bad, 1.5);
    if (y(lower) - y(0) > px(16) && y(0) - y(upper) > px(16)) level(0, t.edge, 1);
    const int count = static_cast<int>(deviations.size());
    const double step = count > 1 ? (right - left - px(12)) / (count - 1) : 0;
    const auto point = [&](double index, double value) {
        return QPointF(left + px(6) + step * index, std::clamp(y(value), top, bottom));
    };
    for (int i = 1; i < count; ++i)
        w.line(point(i - 1, deviations[i - 1].toDouble()), point(i, deviations[i].toDouble()),
               t.accent, px(2));
    for (int i = 0; i < count; ++i) {
        const QPointF at = point(i, deviations[i].toDouble());
        w.fill(
            QRectF(at.x() - px(3), at.y() - px(3), px(6), px(6)),
            deviations[i].toDouble() > upper || deviations[i].toDouble() < lower ? t.bad : t.accent,
            px(3));
    }
    // least squares: through the mean, with the slope that the store has computed
    if (count >= 3) {
        double mean = 0;
        for (const auto& value : deviations) mean += value.toDouble() / count;
        const double slope = one->value("trend").toDouble(), half = (count - 1) / 2.0;
        w.line(point(0, mean - slope * half), point(count - 1, mean + slope * half), t.warn, px(1));
    }
    QString trend;
    if (count >= 2)
        trend = word("%1 a part").arg(signedWithUnit(unit, one->value("trend").toDouble()));
    if (one->contains("parts_to_limit"))
        trend +=
            "   " +
            word("parts to the limit: %1").arg(one->value("parts_to_limit").toDouble(), 0, 'f', 0);
    w.text(QRectF(px(12), high - px(46), wide - px(24), px(20)), trend, lettering(13.5), t.text);
    if (one->contains("proposal"))
        w.text(QRectF(px(12), high - px(25), wide - px(24), px(20)),
               word("Proposal: %1").arg(signedWithUnit(unit, one->value("proposal").toDouble())) +
                   (one->value("limited").toBool() ? "  " + word("(limited)") : QString()),
               lettering(14, true), t.accent);
}

void PartsPage::addKeys(std::vector<SoftKey>& keys) {
    const bool there = context_.live.connected();
    const QJsonObject* one = chosen();
    const QJsonValue number = one ? one->value("dimension") : QJsonValue();
    keys.push_back({word("Input"), [this] { pad_->enter(false); }, Sign::None,
                    there && one && pad_->entry().has_value()});
    keys.push_back({word("Accept proposal"),
                    [this, number, seen = one ? one->value("proposal") : QJsonValue()] {
                        ask({{"do", "parts.accept"}, {"dimension", number}, {"expected", seen}},
                            word("Written"));
                    },
                    Sign::Good,
                    there && one && one->contains("proposal"),
                    false,
                    false,
                    one ? word("Wear %1: press again")
                              .arg(signedWithUnit(unitOf(*one), one->value("proposal").toDouble()))
                        : QString(),
                    {},
                    QString::number(number.toInt()),
                    QString::number(number.toInt())});
    keys.push_back({});
    keys.push_back({word("New dimension"),
                    [this] {
                        // Which number is free, the store knows best.
                        ask({{"do", "parts.add"},
                             {"fields", QJsonObject{{"nominal", "0"},
                                                    {"upper", "0.02"},
                                                    {"lower", "-0.02"},
                                                    {"channel", QString::number(context_.channel)},
                                                    {"axis", "X"}}}},
                            word("New dimension"));
                    },
                    Sign::None, there});
    keys.push_back({word("Delete"),
                    [this, number] {
                        ask({{"do", "parts.delete"}, {"dimension", number}}, word("Deleted"));
                    },
                    Sign::Bin,
                    there && one,
                    false,
                    true,
                    word("It is gone for good: press again"),
                    {},
                    QString::number(number.toInt()),
                    QString::number(number.toInt())});
}

}  // namespace polyturn::hmi
