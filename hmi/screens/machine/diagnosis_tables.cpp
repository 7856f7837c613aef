// The tables of diagnosis: where each line comes from.
#include <cmath>

#include "hmi/machine/tools/tool_words.hpp"
#include "hmi/screens/machine/diagnosis.hpp"
#include "hmi/text/search.hpp"
#include "ipc/image/signal_translations.hpp"
#include "ipc/requests/counters.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/unit.hpp"
#include "ipc/params/variable_text.hpp"

namespace polyturn::hmi {

void Diagnosis::fillSignals() {
    table_->columns = {
        {word("Signal"), 2.4}, {word("Value"), 1}, {word("From"), 0.7}, {word("Meaning"), 6}};
    table_->rowUnits = 32;
    signals_.clear();
    const MachineConfig& machine = context_.live.config();
    for (const SignalRow& row : signal_rows()) {
        if (row.kind == SignalKind::Double) continue;
        const bool plc = row.writer == SignalWriter::Plc;
        const auto add = [&](const QString& scope, std::uint32_t instance) {
            signals_.push_back({fromView(row.name) + scope, fromView(meaning_of(row, spoken())),
                                fromView(row.meaning), row.slot + instance - 1, plc,
                                row.is_register});
        };
        switch (row.scope) {
            case SignalScope::Axis:
                for (std::uint32_t a = 1; a <= machine.last_axis; ++a)
                    if (machine.axis(a).exists()) add(QString(" A%1").arg(a), a);
                break;
            case SignalScope::Channel:
                for (const unsigned l : context_.live.channels()) add(QString(" L%1").arg(l), l);
                break;
            case SignalScope::Spindle:
                for (std::uint32_t s = 1; s <= machine.last_spindle; ++s)
                    if (machine.spindle(s).exists()) add(QString(" S%1").arg(s), s);
                break;
            default:
                if (row.elements == 0)
                    add({}, 1);
                else
                    for (std::uint32_t i = 0; i < row.elements; ++i)
                        add(QString("[%1]").arg(row.first + i), i + 1);
        }
    }
    found_.clear();
    for (const SignalLine& one : signals_)
        if (search_.isEmpty() || holds(one.name, search_) || holds(one.meaning, search_) ||
            holds(one.english, search_))
            found_.push_back(one);
    table_->nothing = word("No signal has this in its name or meaning.");
    table_->rows = [this] { return static_cast<int>(found_.size()); };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const SignalLine& one = found_[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        const std::int32_t value =
            one.plc ? context_.live.plc(one.slot) : context_.live.nc(one.slot);
        switch (column) {
            case 0:
                return {one.name, t.text, Sign::None, true};
            case 1:
                return {QString::number(value), value ? t.good : t.dim,
                        value && !one.isRegister ? Sign::Good : Sign::None, value != 0};
            case 2:
                return {one.plc ? word("PLC") : word("NC"), t.dim};
            default:
                return {one.meaning, t.dim};
        }
    };
}

void Diagnosis::fillAxes() {
    table_->columns = {{word("Axis"), 0.95},
                       {word("Channel"), 1.05},
                       {word("Commanded"), 1.4, Qt::AlignRight | Qt::AlignVCenter},
                       {word("Measured"), 1.4, Qt::AlignRight | Qt::AlignVCenter},
                       {word("Unit"), 1.1},
                       {word("Follow. error"), 1.35, Qt::AlignRight | Qt::AlignVCenter},
                       {word("Compensation"), 1.4, Qt::AlignRight | Qt::AlignVCenter},
                       {word("Torque"), 1.15, Qt::AlignRight | Qt::AlignVCenter},
                       {word("State"), 2.3}};
    table_->rowUnits = 34;
    auto axes = std::make_shared<std::vector<std::uint32_t>>();
    for (std::uint32_t a = 1; a <= context_.live.config().last_axis; ++a)
        if (context_.live.config().axis(a).exists()) axes->push_back(a);
    auto spindles = std::make_shared<std::vector<std::uint32_t>>();
    for (std::uint32_t s = 1; s <= context_.live.config().last_spindle; ++s)
        if (context_.live.config().spindle(s).exists()) spindles->push_back(s);
    table_->rows = [axes, spindles] { return static_cast<int>(axes->size() + spindles->size()); };
    table_->cell = [this, axes, spindles](int row, int column) -> Table::Cell {
        if (static_cast<std::size_t>(row) >= axes->size())
            return spindleCell((*spindles)[static_cast<std::size_t>(row) - axes->size()], column);
        const std::uint32_t number = (*axes)[static_cast<std::size_t>(row)];
        const AxisConfig& axis = context_.live.config().axis(number);
        const AxisStatus& now = context_.live.status().axes[number - 1];
        const LengthUnit unit = context_.live.unit(axis);
        const Theme& t = theme();
        // Its drive belongs to the spindle just now: the axis is nowhere.
        const bool turns =
            axis.on_spindle && context_.live.nc(signals::sn_axis(axis.on_spindle)) == 0;
        if (turns && column >= 2 && column <= 6) return {QString::fromUtf8("–"), t.faint};
        if (turns && column > 7 && !(now.flags & kDriveFault))
            return {word("turns as spindle S%1").arg(axis.on_spindle), t.dim};
        switch (column) {
            case 0:
                return {QString("A%1  %2").arg(number).arg(fromView(axis.name_text())), t.text,
                        Sign::None, true};
            case 1:
                return {axis.channel ? QString("L%1").arg(axis.channel) : QString(), t.dim};
            // Of the same tick as the measured place: now.cmd is where the axis will be sent, a
            // cable's way ahead of it.
            case 2:
                return {unit.text(shownPlace(axis, now.act + now.error))};
            case 3:
                return {unit.text(shownPlace(axis, now.act))};
            // of the places and of the ways behind them
            case 4:
                return {unit.name() +
                            (axis.diameter && !axis.rotary ? QString::fromUtf8(" ⌀") : QString()),
                        t.dim};
            case 5:
                return {unit.text(shown(axis, now.error)), t.dim};
            case 6:
                return {unit.text(shown(axis, now.compensation)), t.dim};
            case 7:
                return {QString("%1 %").arg(now.torque / 10, 0, 'f', 1), t.dim};
            default:
                if (now.flags & kDriveFault) return {word("Drive fault"), t.bad, Sign::Alarm, true};
                if (!(now.flags & kReferenced) && !axis.on_spindle)
                    return {word("not referenced"), t.warn, Sign::Warning};
                if (now.flags & kMoving) return {word("Moves"), t.good, Sign::Run};
                return {now.flags & kInPos ? word("In position") : word("Not in position"), t.dim};
        }
    };
}

// Speeds, below the axes: as their drives are commanded and turn.
Table::Cell Diagnosis::spindleCell(std::uint32_t number, int column) const {
    constexpr std::uint32_t kReached = 1, kStands = 2;  // SpindleStatus::flags
    const SpindleStatus& now = context_.live.status().spindles[number - 1];
    const Theme& t = theme();
    // + 0.0: no -0
    const auto speed = [](double value) {
        return QString::number(std::round(value) + 0.0, 'f', 0);
    };
    switch (column) {
        case 0:
            return {QString("S%1").arg(number), t.text, Sign::None, true};
        case 1:
            return {now.owner ? QString("L%1").arg(now.owner) : QString(), t.dim};
        case 2:
            return {speed(now.command)};
        case 3:
            return {speed(now.speed)};
        case 4:
            return {unitWord("1/min"), t.dim};
        case 5:
        case 6:
        case 7:
            return {QString::fromUtf8("–"), t.faint};
        default:
            if (now.master) return {word("follows S%1").arg(now.master), t.accent};
            if (now.flags & kStands && now.command == 0) return {word("Stands"), t.dim};
            return now.flags & kReached
                       ? Table::Cell{word("Speed reached"), t.good, Sign::Run}
                       : Table::Cell{word("Speed not reached"), t.warn, Sign::Wait};
    }
}

void Diagnosis::fillCouplings() {
    table_->columns = {
        {word("What"), 1.6}, {word("Depends on"), 1.6}, {word("How"), 4}, {word("Since"), 2.4}};
    table_->rowUnits = 36;
    table_->nothing =
        word("Every axis and spindle is on its own: nothing is coupled, exchanged or followed.");
    auto lines = std::make_shared<std::vector<std::array<QString, 4>>>();
    const MachineConfig& machine = context_.live.config();
    const auto axisName = [&](std::uint32_t number) {
        return QString("A%1 %2").arg(number).arg(
            number <= kMaxAxes ? fromView(machine.axis(number).name_text()) : QString());
    };
    const auto since = [&](std::int64_t tick, std::int32_t code, std::uint32_t channel) {
        if (tick <= 0) return word("since the start");
        const QString time = timeText(context_.live.seconds(context_.live.status().tick - tick));
        const QString ago = word("%1 ago").arg(time);
        return code >= 0 ? QString("M%1 L%2, %3").arg(code).arg(channel).arg(ago) : ago;
    };
    for (std::uint32_t a = 1; a <= machine.last_axis; ++a) {
        if (!machine.axis(a).exists()) continue;
        const AxisStatus& now = context_.live.status().axes[a - 1];
        const QString when = since(now.since, now.since_code, now.since_channel);
        if (now.master)
            lines->push_back(
                {axisName(a), axisName(now.master), word("follows it synchronously"), when});
        if (now.added_master)
            lines->push_back({axisName(a), axisName(now.added_master),
                              word("its travel is added to the axis' own"), when});
        if (const unsigned route = context_.live.status().route[a - 1]; route && route != a)
            lines->push_back({axisName(a), axisName(route),
                              word("moves its drive: the axes are exchanged"), when});
    }
    for (std::uint32_t s = 1; s <= machine.last_spindle; ++s) {
        if (!machine.spindle(s).exists()) continue;
        const SpindleStatus& now = context_.live.status().spindles[s - 1];
        if (now.master)
            lines->push_back({QString("S%1").arg(s), QString("S%1").arg(now.master),
                              word("turns with it, deviation %1°").arg(now.deviation, 0, 'f', 3),
                              since(now.since, now.since_code, now.since_channel)});
    }
    table_->rows = [lines] { return static_cast<int>(lines->size()); };
    table_->cell = [lines](int row, int column) -> Table::Cell {
        return {(*lines)[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)],
                {},
                Sign::None,
                column == 0};
    };
}

// What the program has written so far, as far as the channel has read: reading is ahead of the
// machine.
void Diagnosis::fillVariables() {
    table_->columns = {{word("Variable"), 2},
                       {word("Value"), 2, Qt::AlignRight | Qt::AlignVCenter},
                       {word("Name"), 5}};
    table_->rowUnits = 32;
    table_->nothing = search_.isEmpty() ? word("No variable of this channel has a value.")
                                        : word("No variable has this in its name.");
    auto lines = std::make_shared<std::vector<std::pair<QString, QString>>>();
    const auto add = [&](const QString& name, double value) {
        lines->emplace_back(name, QString::fromStdString(params::variable_text(
                                      value, context_.live.table(), context_.channel,
                                      context_.live.language(context_.channel))));
    };
    const VariableList& list = context_.live.variables(context_.channel);
    for (std::size_t i = 0; i < std::min<std::size_t>(list.count, list.rows.size()); ++i) {
        const NamedValue& row = list.rows[i];
        const QString name = QString::fromUtf8(
            row.name.data(), static_cast<int>(::strnlen(row.name.data(), row.name.size())));
        if (search_.isEmpty() || holds(name, search_)) add(name, row.value);
    }
    if (list.count == 0)  // nothing has run yet: what is kept over power-off
        for (std::size_t n = 0; context_.live.connected() && n < 500; ++n)
            if (const double value = context_.live.store(context_.channel).variables[n];
                !std::isnan(value)) {
                const QString name = QString("#%1").arg(500 + n);
                if (search_.isEmpty() || holds(name, search_)) add(name, value);
            }
    const std::uint32_t more = list.more;
    table_->rows = [lines, more] { return static_cast<int>(lines->size()) + (more ? 1 : 0); };
    table_->cell = [lines, more](int row, int column) -> Table::Cell {
        if (row == static_cast<int>(lines->size()))
            return column == 0 ? Table::Cell{word("more: %1").arg(more), theme().dim}
                               : Table::Cell{};
        const auto& [name, value] = (*lines)[static_cast<std::size_t>(row)];
        // that the program has given it
        if (column == 2)
            return {name.section(' ', 1), theme().accent, Sign::None, false, Face::Program};
        return column == 0 ? Table::Cell{name.section(' ', 0, 0), theme().text, Sign::None, true,
                                         Face::Program}
                           : Table::Cell{value, theme().text};
    };
}

// The machine's own counters are parameters N2300 to N2308 (N2305 only says which M code counts a
// part), at the same moment as what belongs to the cycle that runs beside them.
void Diagnosis::fillCounters() {
    struct Line {
        QString title, scope;
        std::function<QString()> value;
    };
    table_->columns = {{word("What"), 4},
                       {word("Channel"), 1},
                       {word("Value"), 2, Qt::AlignRight | Qt::AlignVCenter}};
    table_->rowUnits = 34;
    auto lines = std::make_shared<std::vector<Line>>();
    if (context_.live.connected()) {
        const auto parameter = [&](const char* number, const QString& title, unsigned instance,
                                   const QString& scope) {
            const params::Row* row = params::find(number);
            if (!row) return;
            if (row->unit == "ms")
                lines->push_back({title, scope, [this, slot = row->first_slot + instance - 1] {
                                      return hoursText(std::max(0.0, totals_.ms(slot)) / 1000);
                                  }});
            else
                lines->push_back({title, scope, [this, row, instance] {
                                      return QString::fromStdString(params::value_text(
                                          *row, context_.live.table(), instance, 0));
                                  }});
        };
        parameter("N2300", word("Power on"), 1, {});
        for (const unsigned l : context_.live.channels()) {
            const QString scope = QString("L%1").arg(l);
            const auto status = [&](const QString& title,
                                    std::function<QString(const ChannelStatus&)> text) {
                lines->push_back({title, scope, [this, l, text = std::move(text)] {
                                      return text(context_.live.channel(l));
                                  }});
            };
            status(word("Cycle now"), [](const ChannelStatus& s) { return timeText(s.cycle_s); });
            status(word("  of it cutting"),
                   [](const ChannelStatus& s) { return timeText(s.cutting_s); });
            status(word("  of it rapid"),
                   [](const ChannelStatus& s) { return timeText(s.rapid_s); });
            status(word("  of it waiting"),
                   [](const ChannelStatus& s) { return timeText(s.waiting_s); });
            status(word("Cycle last, mean"), [](const ChannelStatus& s) {
                return s.cycles ? timeText(s.last_cycle_s) + "  /  " + timeText(s.mean_cycle_s)
                                : QString::fromUtf8("–");
            });
            status(word("Parts since the start"),
                   [](const ChannelStatus& s) { return QString::number(s.parts); });
            parameter("N2301", word("Operation time"), l, scope);
            parameter("N2302", word("Cutting time"), l, scope);
            parameter("N2303", word("Interval meter"), l, scope);
            parameter("N2304", word("Part time"), l, scope);
            parameter("N2308", word("Parts wanted"), l, scope);
            parameter("N2306", word("Parts in all"), l, scope);
            parameter("N2307", word("Parts of this job"), l, scope);
        }
    }
    table_->rows = [lines] { return static_cast<int>(lines->size()); };
    table_->cell = [lines](int row, int column) -> Table::Cell {
        const Line& line = (*lines)[static_cast<std::size_t>(row)];
        if (column == 0) return {line.title, theme().text, Sign::None, line.scope.isEmpty()};
        return column == 1 ? Table::Cell{line.scope, theme().dim}
                           : Table::Cell{line.value(), theme().text, Sign::None, true};
    };
}

void Diagnosis::fillProcesses() {
    table_->columns = {{word("Process"), 2}, {word("PID"), 1.2}, {word("State"), 2}};
    table_->rowUnits = 36;
    auto processes = std::make_shared<std::vector<Live::Process>>(context_.live.processes());
    table_->rows = [processes] { return static_cast<int>(processes->size()); };
    table_->cell = [processes](int row, int column) -> Table::Cell {
        const Live::Process& one = (*processes)[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        // of its program; of a channel's, which channel it is
        const QString name = QString::fromStdString(one.name);
        if (column == 0)
            return {name.startsWith("channel ") ? word("Channel") + name.mid(7) : name, t.text,
                    Sign::None, true};
        if (column == 1) return {one.pid > 0 ? QString::number(one.pid) : QString(), t.dim};
        switch (one.state) {
            case ProcessState::Running:
                return {word("Runs"), t.good, Sign::Run};
            case ProcessState::Starting:
                return {word("Starts"), t.warn, Sign::Wait};
            case ProcessState::Stopped:
                return {word("Stopped"), t.warn, Sign::Hold};
            default:
                return {word("Process dead"), t.bad, Sign::Alarm};
        }
    };
}

// How long ticks have computed: the histogram of the kernel, from 1 us, four bars for each
// doubling.
void Diagnosis::composeTicks(Writer& w) {
    const Theme& t = theme();
    const double wide = detail_->width(), high = detail_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(px(8), 0, wide - px(8), high), t.card, px(8));
    w.text(QRectF(px(24), px(10), wide - px(40), px(30)), word("Computing time of ticks"),
           lettering(16, true), t.text);
    const auto& cost = context_.live.tickCost();
    std::uint64_t all = 0, most = 1;
    std::size_t first = cost.size(), last = 0;
    for (std::size_t i = 0; i < cost.size(); ++i) {
        all += cost[i];
        most = std::max(most, cost[i]);
        if (cost[i]) {
            first = std::min(first, i);
            last = i;
        }
    }
    if (!all) return;
    // The time that a tick has: a line that no bar may pass. Far from it, the scale still reaches
    // to it, for the distance is what one looks for.
    // in bars
    const double limit = 4 * std::log2(static_cast<double>(context_.live.config().tick_us));
    const std::size_t longest = last;
    last = std::max(last, std::min(cost.size() - 1, static_cast<std::size_t>(limit)));
    const double left = px(28), right = wide - px(24), top = px(60), bottom = high - px(64);
    const double each = (right - left) / static_cast<double>(last - first + 1);
    for (std::size_t i = first; i <= last; ++i) {
        if (!cost[i]) continue;
        // rare long ticks must be seen
        const double part =
            std::log1p(static_cast<double>(cost[i])) / std::log1p(static_cast<double>(most));
        const double x = left + each * static_cast<double>(i - first);
        w.fill(QRectF(x + 1, bottom - (bottom - top) * part, std::max(1.0, each - 2),
                      (bottom - top) * part),
               t.accent);
    }
    w.line({left, bottom}, {right, bottom}, t.edge, 1);
    const double at = left + each * (limit - static_cast<double>(first));
    if (at - px(166) > left && at <= right) {
        w.line({at, top}, {at, bottom}, t.warn, px(2));
        w.text(QRectF(at - px(166), top, px(160), px(20)), word("the time of a tick"),
               lettering(13), t.warn, Qt::AlignRight | Qt::AlignVCenter);
    }
    const auto microseconds = [](std::size_t i) {
        return QString("%1 %2")
            .arg(std::exp2(static_cast<double>(i) / 4), 0, 'f', 0)
            .arg(unitWord("us"));
    };
    w.text(QRectF(left, bottom + px(4), px(120), px(20)), microseconds(first), lettering(13),
           t.dim);
    w.text(QRectF(right - px(140), bottom + px(4), px(140), px(20)), microseconds(last + 1),
           lettering(13), t.dim, Qt::AlignRight | Qt::AlignVCenter);
    if (last - first >= 8)
        w.text(QRectF(left + (right - left) / 2 - px(70), bottom + px(4), px(140), px(20)),
               microseconds((first + last + 1) / 2), lettering(13), t.dim, Qt::AlignCenter);
    w.text(QRectF(left, top - px(22), right - left, px(20)),
           word("Highest bar: %1 of %2 ticks; both scales are logarithmic").arg(most).arg(all),
           lettering(13), t.dim);
    std::uint64_t late = 0;
    for (auto i = static_cast<std::size_t>(std::max(0.0, std::ceil(limit))); i < cost.size(); ++i)
        late += cost[i];
    if (late) {
        w.sign(QRectF(right - px(160), bottom + px(29), px(18), px(18)), Sign::Warning, t.warn);
        w.text(QRectF(right - px(138), bottom + px(28), px(138), px(22)),
               word("%1 too long").arg(late), lettering(14, true), t.warn);
    }
    w.text(QRectF(left, bottom + px(28), right - left - (late ? px(170) : 0), px(22)),
           word("longest below %1 of a tick of %2")
               .arg(microseconds(longest + 1),
                    QString("%1 %2").arg(context_.live.config().tick_us).arg(unitWord("us"))),
           lettering(14), t.text);
}

}  // namespace polyturn::hmi
