#include "hmi/screens/alarms.hpp"

#include <cmath>

#include "hmi/machine/channel_words.hpp"

namespace polyturn::hmi {
namespace {

Sign signOf(Severity severity) { return severity == Severity::Error ? Sign::Alarm : severity == Severity::Warning ? Sign::Warning : Sign::Note; }
QColor colourOf(Severity severity) {
    const Theme& t = theme();
    return severity == Severity::Error ? t.bad : severity == Severity::Warning ? t.warn : t.accent;
}

}  // namespace

Alarms::Alarms(Desk& desk) : Screen(desk), head_(new FreeSheet(this)), table_(new Table(this)), detail_(new FreeSheet(this)) {
    setFocusPolicy(Qt::StrongFocus);
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        static constexpr const char* kTitles[] = {WORD("What stands"), WORD("History"), WORD("Signals of NC and PLC"), WORD("Axes and drives"), WORD("Couplings and exchanges"), WORD("Processes and ticks")};
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        w.text(QRectF(px(14), 0, head_->width() * 0.6, head_->height()), word(kTitles[static_cast<std::size_t>(page_)]), lettering(20, true), t.text);
        if (page_ == Page::Signals)
            w.data(QRectF(head_->width() * 0.5, 0, head_->width() * 0.5 - px(14), head_->height()), search_.isEmpty() ? word("Type a part of the name") : search_ + QString::fromUtf8("▏"), lettering(16),
                   search_.isEmpty() ? t.dim : t.accent, Qt::AlignRight | Qt::AlignVCenter);
    };
    detail_->onCompose = [this](Writer& w) { page_ == Page::Processes ? composeTicks(w) : composeDetail(w); };
    table_->onChosen = [this] { detail_->refresh(); };
    showPage(Page::Standing);
}

void Alarms::restore(const QString& state) {
    const int page = state.toInt();
    if (page >= 0 && page <= static_cast<int>(Page::Processes)) showPage(static_cast<Page>(page));
}

void Alarms::showPage(Page page) {
    page_ = page;
    version_ = 0;
    table_->nothing.clear();
    switch (page) {
        case Page::Standing:
        case Page::History: fillAlarms(); break;
        case Page::Signals: fillSignals(); break;
        case Page::Axes: fillAxes(); break;
        case Page::Couplings: fillCouplings(); break;
        case Page::Processes: fillProcesses(); break;
    }
    table_->choose(0);
    layOut();
    refresh();
}

void Alarms::resizeEvent(QResizeEvent*) { layOut(); }

void Alarms::layOut() {
    const bool below = page_ == Page::Standing || page_ == Page::History, beside = page_ == Page::Processes;
    const int top = px(46), edge = px(8), foot = below ? px(196) : 0, side = beside ? width() / 2 : 0;
    head_->setGeometry(0, 0, width(), top);
    table_->setGeometry(edge, top, width() - 2 * edge - side, height() - top - foot - edge);
    detail_->setVisible(below || beside);
    if (below) detail_->setGeometry(edge, height() - foot, width() - 2 * edge, foot - edge);
    if (beside) detail_->setGeometry(width() - side, top, side - edge, height() - top - edge);
}

void Alarms::fillAlarms() {
    const bool all = page_ == Page::History;
    table_->columns = {{word("Time"), 1.5}, {"", 0.55}, {word("Number"), 1.1}, {word("Text"), 8}};
    table_->rowUnits = 38;
    table_->nothing = all ? word("Nothing has been told since the controller started.") : word("No alarm stands.");
    rows_.clear();
    for (auto entry = desk_.alarms.all().rbegin(); entry != desk_.alarms.all().rend(); ++entry)
        if (all || entry->standing) rows_.push_back(*entry);
    table_->rows = [this] { return static_cast<int>(rows_.size()); };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const AlarmEntry& entry = rows_[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        switch (column) {
            case 0: return {entry.when.isValid() ? entry.when.toLocalTime().toString("dd.MM. HH:mm:ss") : QString(), t.dim};
            case 1: return {entry.channel ? QString("L%1").arg(entry.channel) : QString(), t.text, Sign::None, true};
            case 2: return {entry.number.isEmpty() ? word("Message") : entry.number, colourOf(entry.severity), signOf(entry.severity), entry.standing};
            default: return {entry.text, entry.standing || page_ == Page::Standing ? t.text : t.dim};
        }
    };
    version_ = desk_.alarms.version();
}

void Alarms::fillSignals() {
    table_->columns = {{word("Signal"), 2.4}, {word("Value"), 1}, {word("From"), 0.7}, {word("Meaning"), 6}};
    table_->rowUnits = 32;
    signals_.clear();
    const MachineConfig& machine = desk_.live.config();
    for (const SignalRow& row : signal_rows()) {
        if (row.kind == SignalKind::Double) continue;
        const bool plc = row.writer == SignalWriter::Plc;
        const auto add = [&](const QString& scope, std::uint32_t instance) {
            signals_.push_back({fromView(row.name) + scope, fromView(row.meaning), row.slot + instance - 1, plc, row.is_register});
        };
        switch (row.scope) {
            case SignalScope::Axis:
                for (std::uint32_t a = 1; a <= machine.last_axis; ++a)
                    if (machine.axis(a).exists()) add(QString(" A%1").arg(a), a);
                break;
            case SignalScope::Channel:
                for (const unsigned l : desk_.live.channels()) add(QString(" L%1").arg(l), l);
                break;
            case SignalScope::Spindle:
                for (std::uint32_t s = 1; s <= machine.last_spindle; ++s)
                    if (machine.spindle(s).exists()) add(QString(" S%1").arg(s), s);
                break;
            default:
                if (row.elements == 0) add({}, 1);
                else
                    for (std::uint32_t i = 0; i < row.elements; ++i) add(QString("[%1]").arg(row.first + i), i + 1);
        }
    }
    found_.clear();
    for (const SignalLine& one : signals_)
        if (search_.isEmpty() || one.name.contains(search_, Qt::CaseInsensitive) || one.meaning.contains(search_, Qt::CaseInsensitive)) found_.push_back(one);
    table_->nothing = word("No signal has this in its name or meaning.");
    table_->rows = [this] { return static_cast<int>(found_.size()); };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const SignalLine& one = found_[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        const std::int32_t value = one.plc ? desk_.live.plc(one.slot) : desk_.live.nc(one.slot);
        switch (column) {
            case 0: return {one.name, t.text, Sign::None, true};
            case 1: return {QString::number(value), value ? t.good : t.dim, value && !one.isRegister ? Sign::Good : Sign::None, value != 0};
            case 2: return {one.plc ? "PLC" : "NC", t.dim};
            default: return {one.meaning, t.dim};
        }
    };
}

void Alarms::fillAxes() {
    table_->columns = {{word("Axis"), 1}, {word("Channel"), 0.9}, {word("Commanded"), 1.5, Qt::AlignRight | Qt::AlignVCenter}, {word("Measured"), 1.5, Qt::AlignRight | Qt::AlignVCenter},
                       {word("Follow. error"), 1.2, Qt::AlignRight | Qt::AlignVCenter}, {word("Compensation"), 1.4, Qt::AlignRight | Qt::AlignVCenter},
                       {word("Torque"), 1.0, Qt::AlignRight | Qt::AlignVCenter}, {word("State"), 2.4}};
    table_->rowUnits = 34;
    auto axes = std::make_shared<std::vector<std::uint32_t>>();
    for (std::uint32_t a = 1; a <= desk_.live.config().last_axis; ++a)
        if (desk_.live.config().axis(a).exists()) axes->push_back(a);
    table_->rows = [axes] { return static_cast<int>(axes->size()); };
    table_->cell = [this, axes](int row, int column) -> Table::Cell {
        const std::uint32_t number = (*axes)[static_cast<std::size_t>(row)];
        const AxisConfig& axis = desk_.live.config().axis(number);
        const AxisStatus& now = desk_.live.status().axes[number - 1];
        const unsigned decimals = decimalsOf(desk_.live.config(), axis);
        const Theme& t = theme();
        switch (column) {
            case 0: return {QString("A%1  %2").arg(number).arg(fromView(axis.name_text())), t.text, Sign::None, true};
            case 1: return {axis.channel ? QString("L%1").arg(axis.channel) : QString(), t.dim};
            case 2: return {lengthText(shown(axis, now.cmd), decimals)};
            case 3: return {lengthText(shown(axis, now.act), decimals)};
            case 4: return {lengthText(now.error, decimals), t.dim};
            case 5: return {lengthText(now.compensation, decimals), t.dim};
            case 6: return {QString("%1 %").arg(now.torque / 10, 0, 'f', 1), t.dim};
            default:
                if (now.flags & kDriveFault) return {word("Drive fault"), t.bad, Sign::Alarm, true};
                if (!(now.flags & kReferenced) && !axis.on_spindle) return {word("not referenced"), t.warn, Sign::Warning};
                if (now.flags & kMoving) return {word("Moves"), t.good, Sign::Run};
                return {now.flags & kInPos ? word("In position") : word("Not in position"), t.dim};
        }
    };
}

void Alarms::fillCouplings() {
    table_->columns = {{word("What"), 2}, {word("Depends on"), 2}, {word("How"), 5}};
    table_->rowUnits = 36;
    table_->nothing = word("Every axis and spindle is on its own: nothing is coupled, exchanged or followed.");
    auto lines = std::make_shared<std::vector<std::array<QString, 3>>>();
    const MachineConfig& machine = desk_.live.config();
    const auto axisName = [&](std::uint32_t number) { return QString("A%1 %2").arg(number).arg(number <= kMaxAxes ? fromView(machine.axis(number).name_text()) : QString()); };
    for (std::uint32_t a = 1; a <= machine.last_axis; ++a) {
        if (!machine.axis(a).exists()) continue;
        const AxisStatus& now = desk_.live.status().axes[a - 1];
        if (now.master) lines->push_back({axisName(a), axisName(now.master), word("follows it synchronously")});
        if (now.added_master) lines->push_back({axisName(a), axisName(now.added_master), word("its way is added to the own one")});
        if (const unsigned route = desk_.live.status().route[a - 1]; route && route != a) lines->push_back({axisName(a), axisName(route), word("moves its drive: the axes are exchanged")});
    }
    for (std::uint32_t s = 1; s <= machine.last_spindle; ++s) {
        if (!machine.spindle(s).exists()) continue;
        const SpindleStatus& now = desk_.live.status().spindles[s - 1];
        if (now.master) lines->push_back({QString("S%1").arg(s), QString("S%1").arg(now.master), word("turns with it, deviation %1°").arg(now.deviation, 0, 'f', 3)});
    }
    table_->rows = [lines] { return static_cast<int>(lines->size()); };
    table_->cell = [lines](int row, int column) -> Table::Cell { return {(*lines)[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)], {}, Sign::None, column == 0}; };
}

void Alarms::fillProcesses() {
    table_->columns = {{word("Process"), 2}, {word("Number"), 1.2}, {word("State"), 2}};
    table_->rowUnits = 36;
    auto processes = std::make_shared<std::vector<Live::Process>>(desk_.live.processes());
    table_->rows = [processes] { return static_cast<int>(processes->size()); };
    table_->cell = [processes](int row, int column) -> Table::Cell {
        const Live::Process& one = (*processes)[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        if (column == 0) return {QString::fromStdString(one.name), t.text, Sign::None, true};
        if (column == 1) return {one.pid > 0 ? QString::number(one.pid) : QString(), t.dim};
        switch (one.state) {
            case ProcessState::Running: return {word("Runs"), t.good, Sign::Run};
            case ProcessState::Starting: return {word("Starts"), t.warn, Sign::Wait};
            case ProcessState::Stopped: return {word("Stopped"), t.warn, Sign::Hold};
            default: return {word("Process dead"), t.bad, Sign::Alarm};
        }
    };
}

void Alarms::composeDetail(Writer& w) {
    const Theme& t = theme();
    const double wide = detail_->width(), high = detail_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, px(6), wide, high - px(6)), t.card, px(8));
    if (rows_.empty() || table_->row() >= static_cast<int>(rows_.size())) return;
    const AlarmEntry& entry = rows_[static_cast<std::size_t>(table_->row())];
    w.fill(QRectF(0, px(6), px(5), high - px(6)), colourOf(entry.severity), px(2));
    w.sign(QRectF(px(16), px(18), px(26), px(26)), signOf(entry.severity), colourOf(entry.severity));
    w.text(QRectF(px(52), px(14), px(110), px(34)), entry.number, lettering(18, true), colourOf(entry.severity));
    Item& text = w.text(QRectF(px(164), px(14), wide - px(180), px(58)), entry.text, lettering(17, true), t.text, Qt::AlignLeft | Qt::AlignTop);
    text.wraps = true, text.data = true;
    w.text(QRectF(px(52), px(78), px(106), px(24)), word("Remedy"), lettering(14), t.dim);
    Item& remedy = w.text(QRectF(px(164), px(78), wide - px(180), px(56)), entry.remedy.isEmpty() ? word("None is known.") : entry.remedy, lettering(16), entry.remedy.isEmpty() ? t.dim : t.text,
                          Qt::AlignLeft | Qt::AlignTop);
    remedy.wraps = true, remedy.data = true;
    w.text(QRectF(px(52), px(140), px(106), px(24)), word("Place"), lettering(14), t.dim);
    const QString channel = entry.channel ? QString("L%1").arg(entry.channel) : word("the machine");
    w.data(QRectF(px(164), px(140), wide - px(180), px(24)),
           QString("%1   %2   %3").arg(channel, entry.place, word("%1 s after the start of the controller").arg(entry.seconds, 0, 'f', 3)), lettering(15), t.dim);
}

// How long ticks have computed: the histogram of the kernel, from 1 us, four bars for each doubling.
void Alarms::composeTicks(Writer& w) {
    const Theme& t = theme();
    const double wide = detail_->width(), high = detail_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(px(8), 0, wide - px(8), high), t.card, px(8));
    w.text(QRectF(px(24), px(10), wide - px(40), px(30)), word("Computing time of ticks"), lettering(16, true), t.text);
    const auto& cost = desk_.live.tickCost();
    std::uint64_t all = 0, most = 1;
    std::size_t first = cost.size(), last = 0;
    for (std::size_t i = 0; i < cost.size(); ++i) {
        all += cost[i], most = std::max(most, cost[i]);
        if (cost[i]) first = std::min(first, i), last = i;
    }
    if (!all) return;
    const double left = px(28), right = wide - px(24), top = px(60), bottom = high - px(64);
    const double each = (right - left) / static_cast<double>(last - first + 1);
    for (std::size_t i = first; i <= last; ++i) {
        if (!cost[i]) continue;
        const double part = std::log1p(static_cast<double>(cost[i])) / std::log1p(static_cast<double>(most));   // rare long ticks must be seen
        const double x = left + each * static_cast<double>(i - first);
        w.fill(QRectF(x + 1, bottom - (bottom - top) * part, std::max(1.0, each - 2), (bottom - top) * part), t.accent, px(2));
    }
    w.line({left, bottom}, {right, bottom}, t.edge, 1);
    const auto microseconds = [](std::size_t i) { return QString::fromUtf8("%1 µs").arg(std::exp2(static_cast<double>(i) / 4), 0, 'f', 0); };
    w.text(QRectF(left, bottom + px(4), px(120), px(20)), microseconds(first), lettering(13), t.dim);
    w.text(QRectF(right - px(140), bottom + px(4), px(140), px(20)), microseconds(last), lettering(13), t.dim, Qt::AlignRight | Qt::AlignVCenter);
    w.text(QRectF(left, bottom + px(28), right - left, px(22)), word("longest %1 of a tick of %2 µs").arg(microseconds(last)).arg(desk_.live.config().tick_us), lettering(14), t.text);
}

void Alarms::refresh() {
    if ((page_ == Page::Standing || page_ == Page::History) && version_ != desk_.alarms.version()) fillAlarms();
    if (page_ == Page::Couplings) fillCouplings();
    if (page_ == Page::Processes) fillProcesses();
    head_->refresh(), table_->refresh();
    if (detail_->isVisible()) detail_->refresh();
}

std::vector<SoftKey> Alarms::keys() {
    const auto page = [this](Page wanted, const QString& text) { return SoftKey{text, [this, wanted] { showPage(wanted); }, Sign::None, true, page_ == wanted}; };
    std::vector<SoftKey> keys{page(Page::Standing, word("What stands")), page(Page::History, word("History")), page(Page::Signals, word("Signals")), page(Page::Axes, word("Axes")),
                              page(Page::Couplings, word("Couplings")), page(Page::Processes, word("Processes"))};
    keys.resize(9);
    const ChannelStatus& status = desk_.live.channel(desk_.channel);
    const auto state = static_cast<ChannelState>(status.state);
    const bool running = state == ChannelState::Running || state == ChannelState::Waiting;
    keys[8] = {word("Reset L%1").arg(desk_.channel), [this] { desk_.requests.press(QString("reset L%1").arg(desk_.channel)); }, Sign::Reset, desk_.live.connected(), false, true,
               running ? word("Ends the program: press again") : QString()};
    keys.push_back({word("Reset all"), [this] { desk_.requests.press("reset"); }, Sign::Reset, desk_.live.connected(), false, true, word("Ends all programs: press again")});
    return keys;
}

bool Alarms::key(QKeyEvent* event) {
    if (page_ == Page::Signals) {
        const QString text = event->text();
        if (event->key() == Qt::Key_Backspace) search_.chop(1);
        else if (event->key() == Qt::Key_Escape) search_.clear();
        else if (!text.isEmpty() && text[0].isPrint()) search_ += text;
        else return table_->key(event);
        fillSignals();
        table_->choose(0);
        refresh();
        return true;
    }
    return table_->key(event);
}

}  // namespace polyturn::hmi
