#include "hmi/screens/machine/scope_page.hpp"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QKeyEvent>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>

#include "hmi/machine/tools/tool_words.hpp"
#include "hmi/text/search.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/painted.hpp"
#include "hmi/widgets/portrait.hpp"
#include "ipc/image/signal_translations.hpp"

namespace polyturn::hmi {
namespace {

constexpr std::array<double, 9> kSeconds{0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50};
constexpr qint64 kValuesMs = 100;  // digits that change faster cannot be read
constexpr qint64 kRoundMs = 1000;  // a circle is not driven in less

// Units as the other screens have them: feeds mm/min or inch/min, torque % of the rated one. The
// kernel records mm, mm/s and thousandths.
double shownAs(const Live& live, ScopeKind kind, unsigned object) {
    const bool ofPath = kind == ScopeKind::PathSpeed || kind == ScopeKind::PathLeft,
               ofAxis = kind >= ScopeKind::AxisCommanded && kind <= ScopeKind::AxisVelocity;
    const bool compensation = kind == ScopeKind::AxisCompensation,
               axisKnown = object >= 1 && object <= kMaxAxes;
    const double size = ofPath ? live.unit(object).size()
                        : (ofAxis || compensation) && axisKnown
                            ? live.unit(live.config().axis(object)).size()
                            : 1.0;
    return (kind == ScopeKind::AxisVelocity || kind == ScopeKind::PathSpeed ? 60.0
            : kind == ScopeKind::AxisTorque                                 ? 0.1
                                                                            : 1.0) /
           size;
}

QString ofAxis(const QString& title, const AxisConfig& axis, const LengthUnit& unit) {
    if (title == "torque") return "%";
    if (title == "velocity") return unit.perMinuteKey();
    // the slide's own travel, whatever it shows elsewhere
    return axis.rotary     ? QString::fromUtf8("°")
           : axis.diameter ? QString(unit.inch() ? WORD("inch, radius") : WORD("mm, radius"))
                           : QString(unit.nameKey());
}

}  // namespace

ScopePage::ScopePage(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      traces_(new Table(this)),
      chooser_(new Table(this)),
      pad_(new NumberPad(this)),
      note_(new FreeSheet(this)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    traces_->columns = {{"", 0.35},
                        {word("Signal"), 3},
                        {word("Now"), 1.3, kRight},
                        {word("Min"), 1.1, kRight},
                        {word("Max"), 1.1, kRight},
                        {word("Per division"), 1.1, kRight},
                        {word("Unit"), 0.9}};
    traces_->rowUnits = 26;
    traces_->textUnits = 13.5;
    traces_->rows = [] { return static_cast<int>(kScopeTraces); };
    traces_->cell = [this](int row, int column) -> Table::Cell {
        const auto trace = static_cast<std::size_t>(row);
        const QColor colour = colourOfTrace(trace);
        QString unit;
        const QString title = titleOf(trace, &unit);
        const bool on = choice_.kind[trace] != 0;
        const bool triggers =
            record_.trigger.trace == trace && record_.mode() != ScopeRecord::Mode::Runs;
        if (column == 0)
            return {QString::number(row + 1), on ? colour : theme().faint, Sign::None, true};
        if (column == 1)
            return {on ? title : word("off"), on ? colour : theme().faint,
                    triggers ? (record_.trigger.rising ? Sign::Up : Sign::Down) : Sign::None, on};
        if (!on) return {};
        if (column == 6) return {unitWord(unit.toStdString()), theme().dim};
        const Values& values = values_[trace];
        if (column == 2) return {values.now, theme().text};
        return {column == 3   ? values.least
                : column == 4 ? values.most
                              : values.division,
                theme().dim};
    };
    traces_->onChosen = [this] {
        update(room_);
        if (context_.keysChanged) context_.keysChanged();
    };
    traces_->onActivated = [this] { showChooser(true); };
    chooser_->columns = {{word("Signal"), 3}, {word("Unit"), 0.8}};
    chooser_->rowUnits = 34;
    chooser_->nothing = word("No signal has this in its name or meaning.");
    chooser_->rows = [this] { return static_cast<int>(found_.size()); };
    chooser_->cell = [this](int row, int column) -> Table::Cell {
        return column == 0
                   ? Table::Cell{found_[static_cast<std::size_t>(row)].title}
                   : Table::Cell{unitWord(found_[static_cast<std::size_t>(row)].unit.toStdString()),
                                 theme().dim};
    };
    chooser_->onActivated = [this] {
        if (chooser_->row() < static_cast<int>(found_.size()))
            choose(found_[static_cast<std::size_t>(chooser_->row())].words);
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        QString unit;
        const QString title = titleOf(record_.trigger.trace, &unit);
        return NumberPad::Field{word("Trigger level") + "  " + title,
                                unitWord(unit.toStdString()),
                                record_.trigger.level,
                                unit.startsWith("inch") ? 4u : 3u,
                                false,
                                1,
                                false};
    };
    pad_->onInput = [this](double value) {
        record_.trigger.level = value;
        level_ = false;
        record_.arm();
        layOut();
    };
    note_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, note_->width(), note_->height()), t.window);
        const auto mode = record_.mode();
        const QString state = mode == ScopeRecord::Mode::Runs        ? word("Records")
                              : mode == ScopeRecord::Mode::Armed     ? word("Waits for the trigger")
                              : mode == ScopeRecord::Mode::Triggered ? word("Triggered")
                                                                     : word("Stands");
        w.sign(QRectF(px(8), px(7), px(22), px(22)),
               mode == ScopeRecord::Mode::Stopped ? Sign::Hold
               : mode == ScopeRecord::Mode::Armed ? Sign::Wait
                                                  : Sign::Run,
               mode == ScopeRecord::Mode::Armed ? t.wait : t.good);
        if (choosing_)
            w.field(QRectF(px(38), px(2), note_->width() * 0.4, note_->height() - px(4)), search_,
                    word("Choose a signal; type a part of its name"), !search_.isEmpty(), 1);
        else
            w.data(QRectF(px(38), 0, note_->width() * 0.4, note_->height()), state,
                   lettering(16, true), t.text);
        const double window = kSeconds[static_cast<std::size_t>(base_)];
        w.text(QRectF(note_->width() * 0.44 + px(choosing_ ? 38 : 0), 0, note_->width() * 0.18,
                      note_->height()),
               word("Window %1 s").arg(window), lettering(15), t.dim);
        w.data(QRectF(note_->width() * 0.62, 0, note_->width() * 0.38 - px(10), note_->height()),
               missed_ ? word("Some ticks were missed") : exported_, lettering(14),
               missed_ ? t.warn : t.dim, kRight);
    };
    note_->onTouched = [this](int) {
        context_.ask({word("Signal"),
                      search_,
                      [this](const QString& text) {
                          search_ = text;
                          fillChoices();
                      },
                      {}});
    };
    layOut();
}

void ScopePage::rebuilt() {
    next_ = 0;
    record_.clear();
    forgetCircle();
    fillChoices();
}

double ScopePage::windowTicks() const {
    return kSeconds[static_cast<std::size_t>(base_)] / std::max(1e-6, context_.live.seconds(1));
}

QString ScopePage::titleOf(std::size_t trace, QString* unit) const {
    const auto kind = static_cast<ScopeKind>(choice_.kind[trace]);
    const unsigned object = choice_.object[trace];
    const MachineConfig& machine = context_.live.config();
    const auto axis = [&](const char* what) {
        if (unit && object >= 1 && object <= kMaxAxes)
            *unit = ofAxis(what, machine.axis(object), context_.live.unit(machine.axis(object)));
        return QString("A%1 %2 %3")
            .arg(object)
            .arg(object >= 1 && object <= kMaxAxes ? fromView(machine.axis(object).name_text())
                                                   : QString(),
                 word(what));
    };
    const auto spindle = [&](const char* what, const char* of) {
        if (unit) *unit = QString::fromUtf8(of);
        return QString("S%1 %2").arg(object).arg(word(what));
    };
    switch (kind) {
        case ScopeKind::AxisCommanded:
            return axis(WORD("commanded"));
        case ScopeKind::AxisMeasured:
            return axis(WORD("measured"));
        case ScopeKind::AxisError:
            return axis(WORD("following error"));
        case ScopeKind::AxisVelocity:
            return axis(WORD("velocity"));
        case ScopeKind::AxisTorque:
            return axis(WORD("torque"));
        case ScopeKind::AxisCompensation:
            return axis(WORD("compensation"));
        case ScopeKind::SpindleCommanded:
            return spindle(WORD("commanded speed"), "1/min");
        case ScopeKind::SpindleSpeed:
            return spindle(WORD("speed"), "1/min");
        case ScopeKind::SpindleAngle:
            return spindle(WORD("angle"), "°");
        case ScopeKind::SpindleDeviation:
            return spindle(WORD("deviation"), "°");
        case ScopeKind::PathSpeed:
            return unit ? *unit = context_.live.unit(object).perMinuteKey(),
                          QString("L%1 %2").arg(object).arg(word("path speed"))
                        : QString("L%1 %2").arg(object).arg(word("path speed"));
        case ScopeKind::PathLeft:
            return unit ? *unit = context_.live.unit(object).nameKey(),
                          QString("L%1 %2").arg(object).arg(word("path left"))
                        : QString("L%1 %2").arg(object).arg(word("path left"));
        case ScopeKind::Input:
            return word("input %1").arg(object);
        case ScopeKind::NcSignal:
        case ScopeKind::PlcSignal: {
            const bool plc = kind == ScopeKind::PlcSignal;
            const SignalRow* best = nullptr;  // the row with the highest slot that is not above
            for (const SignalRow& row : signal_rows())
                if ((row.writer == SignalWriter::Plc) == plc && row.slot <= object &&
                    (!best || row.slot > best->slot))
                    best = &row;
            return best ? fromView(best->name) + QString(" %1").arg(object - best->slot + 1)
                        : QString();
        }
        case ScopeKind::Off:
            break;
    }
    return {};
}

void ScopePage::fillChoices() {
    all_.clear();
    const MachineConfig& machine = context_.live.config();
    if (context_.live.connected()) {
        all_.push_back({"off", word("off"), {}});
        const std::pair<const char*, const char*> kAxis[] = {
            {"command", WORD("commanded")},     {"measured", WORD("measured")},
            {"error", WORD("following error")}, {"velocity", WORD("velocity")},
            {"torque", WORD("torque")},         {"compensation", WORD("compensation")}};
        for (std::uint32_t a = 1; a <= machine.last_axis; ++a)
            if (machine.axis(a).exists())
                for (const auto& [words, title] : kAxis)
                    all_.push_back(
                        {QString("%1 A%2").arg(words).arg(a),
                         QString("A%1 %2 %3")
                             .arg(a)
                             .arg(fromView(machine.axis(a).name_text()), word(title)),
                         ofAxis(title, machine.axis(a), context_.live.unit(machine.axis(a)))});
        const std::pair<const char*, const char*> kSpindle[] = {
            {"speed", WORD("speed")},
            {"speed_command", WORD("commanded speed")},
            {"angle", WORD("angle")},
            {"deviation", WORD("deviation")}};
        for (std::uint32_t s = 1; s <= machine.last_spindle; ++s)
            if (machine.spindle(s).exists())
                for (const auto& [words, title] : kSpindle)
                    all_.push_back({QString("%1 S%2").arg(words).arg(s),
                                    QString("S%1 %2").arg(s).arg(word(title)),
                                    QString(words).startsWith("speed") ? QString("1/min")
                                                                       : QString::fromUtf8("°")});
        for (const unsigned l : context_.live.channels()) {
            all_.push_back({QString("path L%1").arg(l),
                            QString("L%1 %2").arg(l).arg(word("path speed")),
                            context_.live.unit(l).perMinuteKey()});
            all_.push_back({QString("left L%1").arg(l),
                            QString("L%1 %2").arg(l).arg(word("path left")),
                            context_.live.unit(l).nameKey()});
        }
        for (const SignalRow& row : signal_rows()) {
            if (row.kind == SignalKind::Double || row.elements > 0) continue;
            const auto add = [&](const QString& scope) {
                all_.push_back(
                    {"signal " + fromView(row.name) + scope,
                     fromView(row.name) + scope + "  " + fromView(meaning_of(row, spoken())),
                     {},
                     fromView(row.meaning)});
            };
            if (row.scope == SignalScope::Axis)
                for (std::uint32_t a = 1; a <= machine.last_axis; ++a) {
                    if (machine.axis(a).exists()) add(QString(" A%1").arg(a));
                }
            else if (row.scope == SignalScope::Channel)
                for (const unsigned l : context_.live.channels()) add(QString(" L%1").arg(l));
            else if (row.scope == SignalScope::Spindle)
                for (std::uint32_t s = 1; s <= machine.last_spindle; ++s) {
                    if (machine.spindle(s).exists()) add(QString(" S%1").arg(s));
                }
            else
                add({});
        }
    }
    found_.clear();
    for (const Choice& one : all_)
        if (search_.isEmpty() || holds(one.title, search_) || holds(one.english, search_))
            found_.push_back(one);
    chooser_->choose(0);
}

void ScopePage::choose(const QString& words) {
    context_.requests.press(QString("scope %1 %2").arg(traces_->row() + 1).arg(words));
    choosing_ = false;
    record_.clear();
    record_.run();
    layOut();
    if (context_.keysChanged) context_.keysChanged();
}

bool ScopePage::choseCircle() const {
    const auto is = [&](std::size_t trace, ScopeKind kind) {
        return static_cast<ScopeKind>(choice_.kind[trace]) == kind;
    };
    return is(0, ScopeKind::AxisCommanded) && is(1, ScopeKind::AxisCommanded) &&
           is(2, ScopeKind::AxisMeasured) && is(3, ScopeKind::AxisMeasured) &&
           choice_.object[0] == choice_.object[2] && choice_.object[1] == choice_.object[3] &&
           choice_.object[0] != choice_.object[1];
}

void ScopePage::setCircle() {
    const Live& live = context_.live;
    const AxisConfig *x = find_axis(live.config(), context_.channel, PlaneRole::BasicX),
                     *z = find_axis(live.config(), context_.channel, PlaneRole::BasicZ);
    if (!x || !z) return;
    const QString words[] = {
        QString("command A%1").arg(x->number), QString("command A%1").arg(z->number),
        QString("measured A%1").arg(x->number), QString("measured A%1").arg(z->number)};
    for (int i = 0; i < 4; ++i)
        context_.requests.press(QString("scope %1 %2").arg(i + 1).arg(words[i]));
    record_.clear();
    record_.run();
    forgetCircle();
}

void ScopePage::showCircle(bool on) {
    circle_ = on;
    choosing_ = level_ = judged_ = false;
    layOut();
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

void ScopePage::follow() {
    ScopeChoice now{};
    const bool first = next_ == 0;  // what was before this look is not missed
    if (context_.live.scopeChoice(now) &&
        (now.kind != choice_.kind || now.object != choice_.object)) {
        // half of it would be of another signal
        if (!first && record_.mode() == ScopeRecord::Mode::Triggered)
            record_.arm();
        else if (!first && record_.mode() != ScopeRecord::Mode::Stopped)
            record_.clear();
        choice_ = now;
        next_ = std::max(next_, now.first);
    }
    static thread_local std::vector<ScopeSample> fresh;
    if (first) next_ = choice_.first;
    if (!context_.live.scopeSamples(next_, fresh) && !first) missed_ = true;
    if (fresh.empty()) return;
    for (std::size_t trace = 0; trace < kScopeTraces; ++trace)
        if (const double scale = shownAs(context_.live, static_cast<ScopeKind>(choice_.kind[trace]),
                                         choice_.object[trace]);
            scale != 1.0)
            for (ScopeSample& sample : fresh) sample.value[trace] *= scale;
    record_.add(fresh, windowTicks());
    if (!isVisible()) return;
    const qint64 time = QDateTime::currentMSecsSinceEpoch();
    if (!circle_) return update(room_);
    if (auto judged = judging_.take()) {
        judged_ = true;
        if (*judged) {
            round_ = std::move(*judged);
            update(room_);
        }
    }
    // of other signals roundness has no meaning
    if (!choseCircle()) return void(judged_ = true);
    if (judging_.busy() || time < roundMs_ + kRoundMs) return;
    roundMs_ = time;
    // a minute of ticks is too long for a frame
    judging_.start(
        [samples = record_.samples()](const std::atomic<bool>&) { return roundnessOf(samples); },
        0);
}

void ScopePage::takeValues() {
    const qint64 time = QDateTime::currentMSecsSinceEpoch();
    if (time < valuesMs_ + kValuesMs) return;
    if (plot_.drawn()) valuesMs_ = time;  // else at once, when it is
    for (std::size_t trace = 0; trace < kScopeTraces; ++trace) {
        values_[trace] = {};
        ScopeSpan span = plot_.span(trace);
        if (record_.samples().empty() || !span.any()) continue;
        span.add(record_.samples().back().value[trace]);  // newer than what has been painted
        const double division = plot_.scale(trace).division;
        QString unit;
        titleOf(trace, &unit);
        const int decimals = unit.startsWith("inch") ? 4 : 3;
        values_[trace] = {numberText(record_.samples().back().value[trace], decimals),
                          numberText(span.least, decimals), numberText(span.most, decimals),
                          division > 0 ? ScopePlot::valueText(division, division) : QString()};
    }
}

void ScopePage::save() {
    const QString folder = context_.folder.isEmpty()
                               ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                               : context_.folder;
    const QString name = QDir(folder).filePath(
        "scope-" + QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss") + ".csv");
    std::array<std::string, kScopeTraces> names;
    // with the unit that the values have: inches where the axis shows them
    for (std::size_t i = 0; i < kScopeTraces; ++i) {
        QString unit;
        const QString title = choice_.kind[i] ? titleOf(i, &unit) : QString();
        names[i] = QString(unit.isEmpty() || title.isEmpty()
                               ? title
                               : QString("%1 [%2]").arg(title, unitWord(unit.toStdString())))
                       .replace(',', ' ')
                       .toStdString();
    }
    // The place may be slow, and a minute of ticks makes megabytes of text: a worker does both.
    exporting_ = name;
    writing_.start([name, names, samples = record_.samples(),
                    tick_s = context_.live.seconds(1)](const std::atomic<bool>& stop) {
        const QByteArray text = QByteArray::fromStdString(ScopeRecord::csv(samples, names, tick_s));
        FileProgress progress;
        return writeWhole(name, text, progress, stop);
    });
    if (writing_.busy())
        context_.tell(
            word("%1 is being written: the place answers slowly").arg(QFileInfo(name).fileName()),
            Told::Note);
    takeExport();
}

void ScopePage::takeExport() {
    const auto done = writing_.take();
    if (!done) return;
    if (!done->ok())
        return context_.tell(word("Cannot be written: %1").arg(done->told()), Told::Refused);
    exported_ = exporting_;
    context_.tell(word("Saved: %1").arg(exporting_), Told::Good);
}

void ScopePage::resizeEvent(QResizeEvent*) { layOut(); }

void ScopePage::layOut() {
    const int edge = px(8), head = px(36),
              table = px(30) + static_cast<int>(kScopeTraces) * px(26) + px(2);
    note_->setGeometry(edge, 0, width() - 2 * edge, head);
    const bool stands = upright(*this);  // the pad stands beside the graph alone there
    traces_->setGeometry(edge, height() - table - edge,
                         width() - 2 * edge - (level_ && !stands ? px(346) : 0), table);
    room_ = QRect(edge, head, width() - 2 * edge - (level_ ? px(346) : 0),
                  height() - head - table - 2 * edge);
    chooser_->setGeometry(edge, head, width() - 2 * edge, height() - head - edge);
    pad_->setGeometry(width() - px(340) - edge, head, px(340),
                      height() - head - edge - (stands ? table + edge : 0));
    chooser_->setVisible(choosing_);
    traces_->setVisible(!choosing_ && !circle_);
    pad_->setVisible(level_ && !choosing_);
    if (circle_) room_ = QRect(edge, head, width() - 2 * edge, height() - head - edge);
    update();
}

std::vector<Sheet*> ScopePage::sheets() {
    if (choosing_) return {note_, chooser_};
    std::vector<Sheet*> out{note_};
    if (!circle_) out.push_back(traces_);
    if (level_) out.push_back(pad_);
    return out;
}

void ScopePage::refresh() {
    takeExport();
    if (!choosing_ && !circle_) takeValues();
    for (Sheet* one : sheets()) one->refresh();
}

void ScopePage::paintEvent(QPaintEvent* event) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const Theme& t = theme();
    if (choosing_ || circle_ || event->region() != QRegion(room_)) p.fillRect(rect(), t.window);
    if (choosing_) return;
    if (circle_) {
        p.setPen(Qt::NoPen);
        p.setBrush(t.card);
        p.drawRoundedRect(room_, px(8), px(8));
        return paintCircle(p);
    }
    ScopeLook look;
    for (std::size_t trace = 0; trace < kScopeTraces; ++trace)
        look.on[trace] = choice_.kind[trace] != 0;
    look.chosen = static_cast<std::size_t>(traces_->row());
    look.title = titleOf(look.chosen, &look.unit);
    look.seconds = kSeconds[static_cast<std::size_t>(base_)];
    look.tick_s = std::max(1e-6, context_.live.seconds(1));
    plot_.take(record_, look, room_.size());
    plot_.paint(p, room_);
}

void ScopePage::showChooser(bool on) {
    choosing_ = on;
    search_.clear();
    fillChoices();
    layOut();
}

void ScopePage::showLevel(bool on) {
    level_ = on;
    layOut();
}

// The commanded circle as a line, the measured one with its deviation enlarged so that the greatest
// is a sixth of the radius.
void ScopePage::paintCircle(QPainter& p) {
    const Theme& t = theme();
    const QRectF box = QRectF(room_).adjusted(px(12), px(12), -px(12), -px(12));
    if (!round_ || !choseCircle()) {
        p.setPen(t.dim);
        p.setFont(lettering(16));
        paintWords(
            p, box, Qt::AlignCenter | Qt::TextWordWrap,
            !choseCircle()
                ? word(
                      "The scope records other signals: «Axes of L%1» chooses the axes of a circle")
                      .arg(context_.channel)
                : word("No circle has been driven since the record began: drive at least three "
                       "quarters of one in L%1")
                      .arg(context_.channel));
        return;
    }
    const double radius = std::min(box.width() * 0.6, box.height()) * 0.40,
                 greatest = std::max({std::abs(round_->most), std::abs(round_->least), 1e-7}),
                 enlarged = radius / 6 / greatest;
    const QPointF middle(box.left() + box.width() * 0.34, box.center().y());
    p.setPen(QPen(t.dim, 1, Qt::DotLine));
    p.setBrush(Qt::NoBrush);  // a larger ring would cover the smaller ones
    for (const double ring : {-1.0, -0.5, 0.5, 1.0})
        p.drawEllipse(middle, radius + ring * radius / 6, radius + ring * radius / 6);
    p.drawLine(middle - QPointF(radius * 1.2, 0), middle + QPointF(radius * 1.2, 0));
    p.drawLine(middle - QPointF(0, radius * 1.2), middle + QPointF(0, radius * 1.2));
    p.setPen(QPen(t.dim, px(1.5)));
    p.drawEllipse(middle, radius, radius);
    QPolygonF line;
    const std::size_t step = std::max<std::size_t>(1, round_->points.size() / 4000);
    for (std::size_t i = 0; i < round_->points.size(); i += step) {
        const auto& [angle, deviation] = round_->points[i];
        const double r = radius + deviation * enlarged;
        line << middle + QPointF(std::cos(angle) * r, -std::sin(angle) * r);
    }
    p.setPen(QPen(t.accent, px(2)));
    p.drawPolyline(line);
    const auto axisOf = [&](std::size_t trace) {
        return QString("A%1 %2")
            .arg(choice_.object[trace])
            .arg(fromView(context_.live.config().axis(choice_.object[trace]).name_text()));
    };
    p.setPen(t.dim);
    p.setFont(lettering(13.5, true));
    paintWords(p, QRectF(middle.x() + radius * 1.2 + px(4), middle.y() - px(11), px(70), px(22)),
               Qt::AlignLeft | Qt::AlignVCenter, axisOf(1));
    paintWords(p, QRectF(middle.x() + px(6), middle.y() - radius * 1.2 - px(4), px(70), px(22)),
               Qt::AlignLeft | Qt::AlignVCenter, axisOf(0));
    double y = box.top() + px(30);
    const auto row = [&](const QString& title, const QString& value, const QColor& colour) {
        p.setPen(t.dim);
        p.setFont(lettering(15));
        paintWords(p, QRectF(box.left() + box.width() * 0.68, y, box.width() * 0.32, px(24)),
                   Qt::AlignLeft | Qt::AlignVCenter, title);
        p.setPen(colour);
        p.setFont(lettering(21, true));
        paintWords(p,
                   QRectF(box.left() + box.width() * 0.68, y + px(24), box.width() * 0.32, px(32)),
                   Qt::AlignLeft | Qt::AlignVCenter, value);
        y += px(66);
    };
    // of the record
    const LengthUnit unit =
        context_.live.unit(choice_.object[0] >= 1 && choice_.object[0] <= kMaxAxes
                               ? context_.live.config().axis(choice_.object[0])
                               : AxisConfig{});
    const auto micrometres = [&](double shown) {
        return QString("%1 %2").arg(unit.held(shown) * 1000, 0, 'f', 1).arg(unitWord("µm"));
    };
    row(word("Circularity error"), micrometres(round_->error()), t.text);
    row(word("Greatest, least deviation"),
        micrometres(round_->most) + QString::fromUtf8("  /  ") + micrometres(round_->least),
        t.text);
    row(word("Radius, commanded"), QString("%1 %2").arg(round_->radius, 0, 'f', 4).arg(unit.name()),
        t.text);
    row(word("One ring"), micrometres(greatest / 2), t.dim);
}

bool ScopePage::key(QKeyEvent* event) {
    if (choosing_) {
        const QString text = event->text();
        if (event->key() == Qt::Key_Escape) {
            choosing_ = false;
            layOut();
            return true;
        }
        if (event->key() == Qt::Key_Backspace) {
            search_.chop(1);
            fillChoices();
            return true;
        }
        if (text.size() == 1 && text[0].isPrint() &&
            !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
            search_ += text;
            fillChoices();
            return true;
        }
        return chooser_->key(event);
    }
    if (level_) {
        if (event->key() == Qt::Key_Escape && pad_->text().isEmpty()) {
            level_ = false;
            layOut();
            return true;
        }
        if (pad_->key(event)) return true;
    }
    if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Right) {
        base_ = std::min<int>(base_ + 1, kSeconds.size() - 1);
        update();
        return true;
    }
    if (event->key() == Qt::Key_Minus || event->key() == Qt::Key_Left) {
        base_ = std::max(base_ - 1, 0);
        update();
        return true;
    }
    return circle_ ? false : traces_->key(event);
}

std::vector<SoftKey> ScopePage::keys(std::function<void()> back) {
    const bool there = context_.live.connected(), any = !record_.samples().empty(),
               runs = record_.mode() != ScopeRecord::Mode::Stopped;
    std::vector<SoftKey> keys{{word("Back"), std::move(back), Sign::Left}};
    keys.push_back(
        {word("Circularity"), [this] { showCircle(!circle_); }, Sign::Spindle, true, circle_});
    if (circle_) {
        keys.push_back({word("Axes of L%1").arg(context_.channel), [this] { setCircle(); },
                        Sign::None, there});
        keys.resize(8);
    } else {
        keys.push_back(
            {word("Choose signal"), [this] { showChooser(true); }, Sign::None, there, choosing_});
        keys.push_back({word("Trace off"), [this] { choose("off"); }, Sign::Off,
                        there && choice_.kind[static_cast<std::size_t>(traces_->row())] != 0});
        keys.push_back({word("Longer"),
                        [this] {
                            base_ = std::min<int>(base_ + 1, kSeconds.size() - 1);
                            update();
                        },
                        Sign::None, base_ + 1 < static_cast<int>(kSeconds.size())});
        keys.push_back({word("Shorter"),
                        [this] {
                            base_ = std::max(base_ - 1, 0);
                            update();
                        },
                        Sign::None, base_ > 0});
        keys.push_back(
            {record_.trigger.rising ? word("Trigger upwards") : word("Trigger downwards"),
             [this] {
                 const auto trace = static_cast<std::size_t>(traces_->row());
                 if (record_.trigger.trace == trace && record_.mode() == ScopeRecord::Mode::Armed)
                     record_.trigger.rising = !record_.trigger.rising;
                 record_.trigger.trace = trace;
                 record_.arm();
             },
             record_.trigger.rising ? Sign::Up : Sign::Down,
             there && choice_.kind[static_cast<std::size_t>(traces_->row())] != 0,
             record_.mode() == ScopeRecord::Mode::Armed});
        keys.push_back({word("Trigger level"),
                        [this] {
                            level_ = !level_;
                            record_.trigger.trace = static_cast<std::size_t>(traces_->row());
                            layOut();
                        },
                        Sign::None, there, level_});
    }
    keys.push_back({runs ? word("Stop record") : word("Record"),
                    [this, runs] {
                        if (runs)
                            record_.stop();
                        else
                            (record_.clear(), record_.run());
                        missed_ = false;
                    },
                    runs ? Sign::Hold : Sign::Run, any || !runs, false});
    keys.push_back({word("Export"), [this] { save(); }, Sign::Programs, any});
    return keys;
}

}  // namespace polyturn::hmi
