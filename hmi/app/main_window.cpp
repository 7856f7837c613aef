#include "hmi/app/main_window.hpp"

#include <QApplication>
#include <QDateTime>
#include <QFile>
#include <algorithm>
#include <filesystem>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/live/lengths.hpp"
#include "hmi/text/retold.hpp"
#include "hmi/widgets/portrait.hpp"
#include "hmi/widgets/set_words.hpp"
#include "hmi/widgets/table.hpp"
#include "ipc/model/machine/machine_step.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kFrameMs = 16;
// kClothMs: how long a cloth is still on a panel that an alarm has unlocked
constexpr qint64 kToldMs = 8'000, kKeepMs = 1'000, kClothMs = 1'000;
enum TopHit { kHitAlarm, kHitLanguage, kHitTheme, kHitLock, kHitHelp, kHitDialogue };

Sign signOf(MachineStep step) {
    switch (step) {
        case MachineStep::EmergencyStop:
            return Sign::Alarm;
        case MachineStep::Off:
            return Sign::Off;
        case MachineStep::NotReferenced:
            return Sign::Warning;
        case MachineStep::Referencing:
            return Sign::Wait;
        case MachineStep::Ready:
            return Sign::Good;
        case MachineStep::Stopped:
            return Sign::Alarm;
    }
    return Sign::None;
}

QColor colourOf(MachineStep step) {
    const Theme& t = theme();
    if (step == MachineStep::Ready) return t.good;
    return step == MachineStep::EmergencyStop || step == MachineStep::Stopped ? t.bad
           : step == MachineStep::Off                                         ? t.dim
                                                                              : t.warn;
}

bool writeKept(const QString& file, const std::map<QString, QString>& values) {
    QSettings settings(file, QSettings::IniFormat);
    for (const auto& [name, value] : values) settings.setValue(name, value);
    settings.sync();
    return settings.status() == QSettings::NoError;
}

}  // namespace

void Context::choose(unsigned wanted) {
    if (wanted == channel ||
        std::find(live.channels().begin(), live.channels().end(), wanted) == live.channels().end())
        return;
    channel = wanted;
    if (keysChanged) keysChanged();
}

void startGroup(Context& context, unsigned group) {
    const StartPlan plan = startPlan(context.live, group);
    context.requests.press(group ? QString("cycle_start T%1").arg(group) : QString("cycle_start"));
    if (!plan.passed.empty())
        context.tell(word("%1: no program is selected").arg(channelList(plan.passed)),
                     plan.begin.empty() && plan.goOn.empty() ? Told::Refused : Told::Note);
}

MainWindow::MainWindow(Choices choices)
    : choices_(std::move(choices)),
      kept_(choices_.keptIn.isEmpty()
                ? nullptr
                : std::make_unique<QSettings>(choices_.keptIn, QSettings::IniFormat)),
      live_(choices_.instance),
      requests_(choices_.instance),
      alarms_(live_, requests_),
      context_{live_, requests_, alarms_} {
    const auto kept = [&](const char* key, const QString& otherwise) {
        return kept_ ? kept_->value(key, otherwise).toString() : otherwise;
    };
    dark_ = (choices_.theme.empty() ? kept("theme", "dark")
                                    : QString::fromStdString(choices_.theme)) != "light";
    dress(dark_);
    paintBehind();
    live_.poll();
    std::string language =
        choices_.language.empty() ? kept("language", "").toStdString() : choices_.language;
    if (language.empty() && live_.connected())
        language = std::string(params::get_text(live_.table(), params::pt_display_language));
    speak(display_language_of(language).value_or(display_language_of_environment()));
    context_.channel = kept_ ? kept_->value("channel", 1).toUInt() : 1;
    context_.folder = kept("folder", "");
    if (kept_) {
        context_.draftFile = choices_.keptIn + ".draft";
        context_.kept.in(choices_.keptIn,
                         choices_.passingIn.isEmpty() ? choices_.keptIn : choices_.passingIn);
        if (QFile file(context_.draftFile); file.open(QIODevice::ReadOnly))
            context_.draft = Draft::read(file.readAll());
    }
    context_.tell = [this](const QString& text, Told how) { tell(text, how); };
    context_.keysChanged = [this] {
        if (ready_) {
            showKeys();
            rail_->refresh();
        }
    };
    context_.show = [this](int number) { showScreen(number); };
    requests_.onRefused = [this](const Answer& answer) {
        tell(retoldLengths(answer.text, live_.commonUnit()) +
                 (answer.remedy.isEmpty() ? QString() : "  " + answer.remedy),
             Told::Refused);
    };

    setWindowTitle("Polyturn");
    setMinimumSize(600, 480);
    top_ = new FreeSheet(this);
    rail_ = new FreeSheet(this);
    line_ = new FreeSheet(this);
    bar_ = new SoftKeyBar(this);
    stack_ = new QStackedWidget(this);
    help_ = new HelpView(this);
    dialogue_ = new DialogueView(context_, this);
    entry_ = new TextEntry(this);
    context_.ask = [this](TextQuestion question) { entry_->open(std::move(question)); };
    cover_ = new CleaningLock(context_, this);
    cover_->onEnd = [this](CleaningLock::End how) {
        lock(false);
        if (how != CleaningLock::End::Alarm) return;
        unlocked_.start();
        tell(word("An alarm has ended the lock for cleaning."), Told::Refused);
    };
    top_->onCompose = [this](Writer& w) { composeTop(w); };
    top_->onTouched = [this](int number) { topTouched(number); };
    rail_->onCompose = [this](Writer& w) { composeRail(w); };
    rail_->onTouched = [this](int number) { showScreen(number); };
    line_->onCompose = [this](Writer& w) { composeLine(w); };
    build();
    const QString wanted = kept("screen", "overview");
    for (std::size_t i = 0; i < screens_.size(); ++i)
        if (wanted == screens_[i]->name()) shown_ = static_cast<int>(i);
    if (kept_)
        for (Screen* one : screens_)
            one->restore(kept_->value(QString("screens/") + one->name()).toString());
    ready_ = true;
    showScreen(shown_);
    qApp->installEventFilter(this);
    QObject::connect(&timer_, &QTimer::timeout, this, [this] { frame(); });
    timer_.start(kFrameMs);
}

MainWindow::~MainWindow() {
    for (Screen* one : screens_) one->leave();
    if (kept_ && ready_) {
        keeping_.forget();
        writeKept(choices_.keptIn, keepsake());
    }
    qApp->removeEventFilter(this);
}

void MainWindow::sayWhyEmpty() const {
    Table::noMachine = live_.connected() ? QString() : word("No controller answers");
}

void MainWindow::build() {
    entry_->shut(false);
    requests_.forgetScreens();
    sayWhyEmpty();
    while (stack_->count()) {
        QWidget* old = stack_->widget(0);
        stack_->removeWidget(old);
        delete old;
    }
    screens_ = makeScreens(context_);
    for (Screen* one : screens_) {
        stack_->addWidget(one);
        one->rebuilt();
    }
    shown_ = std::min(shown_, static_cast<int>(screens_.size()) - 1);
}

void MainWindow::showScreen(int number) {
    if (number < 0 || number >= static_cast<int>(screens_.size())) return;
    shown_ = number;
    help_->hide();
    dialogue_->hide();
    entry_->shut(false);
    field_ = 0;
    stack_->setCurrentIndex(number);
    screen()->setFocus();
    screen()->refresh();
    showKeys();
    top_->refresh();
    rail_->refresh();
    line_->refresh();
}

std::map<QString, QString> MainWindow::keepsake() const {
    std::map<QString, QString> out{{"screen", screen()->name()},
                                   {"theme", dark_ ? "dark" : "light"},
                                   {"language", codeOf(spoken())},
                                   {"channel", QString::number(context_.channel)},
                                   {"folder", context_.folder}};
    for (const Screen* one : screens_) out[QString("screens/") + one->name()] = one->state();
    return out;
}

// What is on the screen now is there again after a restart, and after a crash, which says nothing
// before. Aside, for the disk may be slow.
void MainWindow::keep() {
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (!kept_ || !ready_ || now < keepAt_) return;
    keepAt_ = now + kKeepMs;
    context_.kept.tend();
    if (keeping_.busy() && !keeping_.take()) return;
    std::map<QString, QString> values = keepsake();
    if (values == keptLast_) return;
    keptLast_ = values;
    keeping_.start([file = choices_.keptIn, values = std::move(values)](
                       const std::atomic<bool>& stop) { return !stop && writeKept(file, values); },
                   0);
}

void MainWindow::setDisplayLanguage(DisplayLanguage display_language) {
    std::vector<QString> states;
    for (Screen* one : screens_) {
        states.push_back(one->state());
        one->leave();
    }
    speak(display_language);
    alarms_.retold();
    ready_ = false;
    build();
    for (std::size_t i = 0; i < states.size(); ++i) screens_[i]->restore(states[i]);
    ready_ = true;
    layOut();
    showScreen(shown_);
}

void MainWindow::setDark(bool dark) {
    dark_ = dark;
    dress(dark);
    paintBehind();
    setDisplayLanguage(spoken());  // style sheets and pictures are made anew
    for (Sheet* one : ownSheets()) one->update();
}

// What lies between the sheets.
void MainWindow::paintBehind() {
    QPalette colours = palette();
    colours.setColor(QPalette::Window, theme().window);
    setPalette(colours);
    setAutoFillBackground(true);
}

void MainWindow::frame() {
    ++frames_;
    live_.poll();
    sayWhyEmpty();
    alarms_.poll();
    if (live_.generation() != generation_) {
        generation_ = live_.generation();
        if (live_.connected() &&
            std::find(live_.channels().begin(), live_.channels().end(), context_.channel) ==
                live_.channels().end() &&
            !live_.channels().empty())
            context_.channel = live_.channels().front();
        readBuilderMessages();
        for (Screen* one : screens_) one->rebuilt();
    }
    if (auto read = builders_.take()) {
        knowBuilderMessages(std::move(*read));
        alarms_.retold();
    }
    for (Screen* one : screens_) one->follow();
    screen()->refresh();
    followDialogue();
    if (dialogue_->isVisible()) dialogue_->refresh();
    showKeys();
    top_->refresh();
    line_->refresh();
    if (locked_) cover_->follow();
    keep();
}

// A page that has come over what somebody types would take the rest of it for an answer.
bool MainWindow::typed() const {
    if (entry_->isVisible() || help_->isVisible() || screen()->typing()) return true;
    // of a class without Q_OBJECT findChildren() finds every widget
    const auto all = screen()->findChildren<QWidget*>();
    return std::any_of(all.begin(), all.end(), [](const QWidget* one) {
        const auto* pad = dynamic_cast<const NumberPad*>(one);
        return pad && !pad->text().isEmpty();
    });
}

void MainWindow::followDialogue() {
    const unsigned before = dialogue_->isVisible() ? dialogue_->channel() : 0;
    const bool fresh = dialogue_->follow();
    const unsigned now = dialogue_->channel();
    // another one is no answer to what was read
    if (!now || (before && now != before)) dialogue_->hide();
    if (!fresh || now == before || now != context_.channel || typed()) return;
    dialogue_->show();
    dialogue_->raise();
    if (locked_) cover_->raise();
    cameUp_.start();
    bar_->rest(kComesUpMs);
}

// Logs and dry runs tell them in English.
void MainWindow::readBuilderMessages() {
    const std::string base = live_.machineFolder();
    if (base.empty()) return knowBuilderMessages({});
    builders_.start(
        [file = (std::filesystem::path(base).parent_path() / "messages.csv").string()](
            const std::atomic<bool>&) {
            text::BuilderMessages out;
            (void)out.add_file(file);  // the controller reports what is wrong in it
            return out;
        },
        0);
}

void MainWindow::resizeEvent(QResizeEvent*) { layOut(); }

void MainWindow::layOut() {
    const bool stands = upright(*this);
    setPanelScale(stands ? std::min(width() / 960.0, height() / 1280.0)
                         : std::min(width() / 1280.0, height() / 800.0));
    const int top = px(stands ? 92 : 46), foot = px(stands ? 164 : 82), line = px(30),
              rail = px(94);
    top_->setGeometry(0, 0, width(), top);
    rail_->setGeometry(0, top, rail, height() - top - foot);
    stack_->setGeometry(rail, top, width() - rail, height() - top - foot - line);
    line_->setGeometry(rail, height() - foot - line, width() - rail, line);
    bar_->setGeometry(0, height() - foot, width(), foot);
    entry_->setGeometry(rail, height() - foot - px(360), width() - rail, px(360));
    help_->setGeometry(rail, top, width() - rail, height() - top - foot);
    dialogue_->setGeometry(rail, top, width() - rail, height() - top - foot - line);
    cover_->setGeometry(0, top, width(), height() - top);  // the bar above goes on telling
    cover_->keysAt(QRectF(0, height() - foot - top, width(), foot));
    for (Sheet* one : ownSheets()) one->refresh();
}

void MainWindow::showKeys() {
    bar_->show(dialogue_->isVisible() ? dialogue_->keys() : screen()->keys());
}

void MainWindow::composeTop(Writer& w) {
    const Theme& t = theme();
    const bool stands = upright(*this);  // there the message has a line of its own
    const double h = stands ? top_->height() / 2.0 : top_->height(), wide = top_->width();
    w.fill(QRectF(0, 0, wide, top_->height()), t.bar);
    const auto step = static_cast<MachineStep>(live_.status().step);
    // Ready is a machine that nothing is missing to and that does nothing: what its channels do
    // goes before it.
    std::vector<unsigned> run, wait, stand, broken;
    for (const unsigned channel : live_.channels()) {
        const auto does = static_cast<ChannelState>(live_.channel(channel).state);
        if (does == ChannelState::Running)
            run.push_back(channel);
        else if (does == ChannelState::Waiting)
            wait.push_back(channel);
        else if (works(live_.channel(channel)))
            stand.push_back(channel);
        else if (does == ChannelState::Interrupted || does == ChannelState::Dead)
            broken.push_back(channel);
    }
    // a channel that waits for a stopped one is stopped too
    const bool worked = live_.connected() && step == MachineStep::Ready &&
                        !(run.empty() && wait.empty() && stand.empty() && broken.empty()),
               runs = !run.empty() || (!wait.empty() && stand.empty() && broken.empty());
    const QColor colour = !live_.connected()          ? t.bad
                          : worked && !broken.empty() ? t.bad
                          : worked && !runs           ? t.warn
                                                      : colourOf(step);
    w.sign(QRectF(px(14), px(11), px(24), px(24)),
           !live_.connected() ? Sign::Alarm
           : !worked          ? signOf(step)
           : !broken.empty()  ? Sign::Alarm
           : runs             ? Sign::Run
                              : Sign::Hold,
           colour);
    const QString state = !live_.connected() ? word("No controller answers")
                          : !worked          ? word(machine_step_text(live_.status().step).text)
                          : runs             ? word("programs run")
                          : broken.empty()   ? word("programs stand")
                                             : word("a program is interrupted");
    w.text(QRectF(px(46), 0, px(330), h), state.left(1).toUpper() + state.mid(1),
           lettering(16, true), colour);
    double right = wide - px(8);
    const auto button = [&](int hit, const QString& text, Sign sign, double units) {
        const QRectF box(right - px(units), px(6), px(units), h - px(12));
        w.fill(box, t.card, px(6));
        w.sign(QRectF(box.left() + px(8), box.center().y() - px(9), px(18), px(18)), sign, t.dim);
        w.text(QRectF(box.left() + px(31), box.top(), box.width() - px(36), box.height()), text,
               lettering(14), t.text);
        w.hit(box, hit);
        right = box.left() - px(6);
    };
    button(kHitHelp, word("Help"), Sign::Help, 116);
    button(kHitLock, word("Lock"), Sign::Lock, 108);
    button(kHitTheme, dark_ ? word("Light") : word("Dark"), dark_ ? Sign::Sun : Sign::Moon, 100);
    button(kHitLanguage, nameOf(spoken()), Sign::DisplayLanguage, 104);
    w.text(QRectF(right - px(84), 0, px(78), h), QDateTime::currentDateTime().toString("HH:mm:ss"),
           lettering(15), t.dim, Qt::AlignRight | Qt::AlignVCenter);
    right -= px(90);
    const double left = px(stands ? 8 : 384), down = stands ? h : 0;
    if (stands) right = wide - px(8);
    if (dialogue_->channel() && !dialogue_->isVisible()) {  // put away: it comes back by a touch
        const QRectF box(left, down + px(6), right - left, h - px(12));
        w.fill(box, t.mark, px(6));
        w.sign(QRectF(left + px(8), down + px(14), px(18), px(18)), Sign::Note, t.accent);
        w.data(QRectF(left + px(34), down, right - left - px(42), h),
               word("L%1 asks: %2").arg(dialogue_->channel()).arg(dialogue_->title()),
               lettering(14, true), t.text);
        w.hit(box, kHitDialogue);
    } else if (const AlarmEntry* alarm = live_.connected() ? alarms_.standing() : nullptr) {
        const QRectF box(left, down + px(6), right - left, h - px(12));
        w.fill(box, t.card, px(6));
        w.frame(box, t.bad, px(6), 1);
        w.sign(QRectF(left + px(8), down + px(14), px(18), px(18)), Sign::Alarm, t.bad);
        const std::size_t more = alarms_.standingCount() - 1;
        // a touch opens it
        w.sign(QRectF(right - px(26), down + px(14), px(18), px(18)), Sign::Right, t.dim);
        if (more)
            w.text(QRectF(right - px(70), down, px(42), h), QString("+%1").arg(more),
                   lettering(14, true), t.bad, Qt::AlignRight | Qt::AlignVCenter);
        const QString text = (alarm->channel ? QString("L%1  ").arg(alarm->channel) : QString()) +
                             alarm->number + "  " + alarm->text;
        const QRectF room(left + px(34), down + px(4), right - left - px(more ? 108 : 64),
                          h - px(8));
        if (wordsWidth(text, lettering(14)) <= room.width()) {
            w.data(room, text, lettering(14), t.text);
        } else {  // on two lines
            const QFont small = lettering(12, false, Face::Condensed);
            Item& item = w.text(room, wordsCutTo(text, small, room.size()), small, t.text);
            item.wraps = true;
            item.data = true;
        }
        w.hit(box, kHitAlarm);
    } else if (const AlarmEntry* note =
                   live_.connected() &&
                           static_cast<MachineStep>(live_.status().step) == MachineStep::Ready
                       ? alarms_.told(0)
                       : nullptr) {
        // of the machine's builder: it belongs to no channel's card; what is to do next goes before
        // it
        const QRectF box(left, down + px(6), right - left, h - px(12));
        w.fill(box, t.card, px(6));
        w.sign(QRectF(left + px(8), down + px(14), px(18), px(18)), Sign::Note, t.accent);
        w.data(QRectF(left + px(34), down, right - left - px(42), h),
               note->number + "  " + note->text, lettering(14), t.accent);
        w.hit(box, kHitAlarm);
    } else {
        QStringList parts;
        if (!run.empty()) parts << word("%1 run").arg(channelList(run));
        if (!wait.empty()) parts << word("%1 wait").arg(channelList(wait));
        if (!stand.empty()) parts << word("%1 stand").arg(channelList(stand));
        if (!broken.empty()) parts << word("%1 interrupted").arg(channelList(broken));
        const QString does = parts.join("   ");
        w.data(QRectF(left, down, right - left, h),
               worked              ? does
               : live_.connected() ? word(machine_step_text(live_.status().step).next)
                                   : QString::fromStdString(live_.whyNot()),
               lettering(14), t.dim);
    }
}

void MainWindow::composeRail(Writer& w) {
    const Theme& t = theme();
    w.fill(QRectF(0, 0, rail_->width(), rail_->height()), t.bar);
    const double gap = px(4),
                 each = std::min<double>(
                     px(84), (rail_->height() - gap) / static_cast<double>(std::max<std::size_t>(
                                                           1, screens_.size())) -
                                 gap);
    for (std::size_t i = 0; i < screens_.size(); ++i) {
        const QRectF box(px(6), gap + static_cast<double>(i) * (each + gap),
                         rail_->width() - px(12), each);
        const bool here = static_cast<int>(i) == shown_;
        w.fill(box, here ? t.mark : t.bar, px(8));
        if (here)
            w.fill(QRectF(box.left(), box.top() + px(8), px(4), box.height() - px(16)), t.accent,
                   px(2));
        w.sign(QRectF(box.center().x() - px(13), box.top() + px(9), px(26), px(26)),
               screens_[i]->sign(), here ? t.accent : t.dim);
        w.text(QRectF(box.left() + px(5), box.bottom() - px(31), box.width() - px(6), px(22)),
               screens_[i]->title(), lettering(here ? 12.5 : 13, here, Face::Condensed),
               here ? t.text : t.dim, Qt::AlignCenter);
        w.text(QRectF(box.right() - px(17), box.top() + px(3), px(13), px(14)),
               QString::number((i + 1) % 10), lettering(11), t.faint,
               Qt::AlignRight | Qt::AlignVCenter);
        w.hit(box, static_cast<int>(i));
    }
}

void MainWindow::composeLine(Writer& w) {
    const Theme& t = theme();
    const bool fresh = QDateTime::currentMSecsSinceEpoch() < toldUntil_;
    w.fill(QRectF(0, 0, line_->width(), line_->height()), t.window);
    const QColor colour = how_ == Told::Refused   ? t.bad
                          : how_ == Told::Warning ? t.warn
                          : how_ == Told::Good    ? t.good
                                                  : t.accent;
    w.sign(QRectF(px(10), px(6), px(18), px(18)),
           !fresh                                           ? Sign::None
           : how_ == Told::Refused || how_ == Told::Warning ? Sign::Warning
           : how_ == Told::Good                             ? Sign::Good
                                                            : Sign::Note,
           colour);
    w.data(QRectF(px(36), 0, line_->width() - px(46), line_->height()), fresh ? told_ : QString(),
           lettering(14.5), how_ == Told::Refused ? t.bad : t.text);
}

void MainWindow::lock(bool on) {
    if (on && !locked_) {  // what a finger holds now must not go on beneath the cover
        for (int key = 0; key < 10; ++key) bar_->letGo(key);
        for (Screen* one : screens_) one->letGo();
        for (QWidget* one : findChildren<QWidget*>())
            if (auto* sheet = dynamic_cast<Sheet*>(one)) sheet->forgetTouch();
    }
    locked_ = on;
    if (on)
        cover_->begin();
    else
        cover_->hide();
    // what was asked before is not answered behind it
    bar_->show({});
    showKeys();
}

void MainWindow::topTouched(int number) {
    switch (number) {
        case kHitAlarm:
            for (std::size_t i = 0; i < screens_.size(); ++i)
                if (QString(screens_[i]->name()) == "alarms") {
                    showScreen(static_cast<int>(i));
                    screens_[i]->turnTo(0);  // the one that was touched is the first of its list
                }
            break;
        case kHitLanguage:
            setDisplayLanguage(kDisplayLanguages[(static_cast<std::size_t>(spoken()) + 1) %
                                                 std::size(kDisplayLanguages)]);
            break;
        case kHitTheme:
            setDark(!dark_);
            break;
        case kHitLock:
            lock(true);
            break;
        case kHitHelp:
            showHelp();
            break;
        case kHitDialogue:
            dialogue_->show();
            dialogue_->raise();
            dialogue_->refresh();
            showKeys();
            break;
        default:
            break;
    }
}

void MainWindow::tell(const QString& text, Told how) {
    told_ = text;
    told_.replace('\n', "  ");
    how_ = how;
    toldUntil_ = QDateTime::currentMSecsSinceEpoch() + kToldMs;
    if (ready_) line_->refresh();
}

void MainWindow::showHelp() {
    if (help_->isVisible()) return help_->hide();
    help_->open(screen()->help());
}

bool MainWindow::showOver(Over over) {
    if (locked_) lock(false);
    help_->hide();
    entry_->shut(false);
    dialogue_->hide();
    switch (over) {
        case Over::Screen:
            break;
        case Over::Help:
            showHelp();
            break;
        case Over::Lock:
            lock(true);
            break;
        case Over::Letters:
            entry_->open({word("Search"), "N0106"});
            break;
        case Over::Dialogue:
            if (!dialogue_->channel()) return false;
            topTouched(kHitDialogue);
    }
    return true;
}

std::vector<Sheet*> MainWindow::overSheets() const {
    std::vector<Sheet*> out;
    if (locked_) return {cover_};
    if (help_->isVisible()) out.push_back(help_->head());
    if (entry_->isVisible()) out.insert(out.end(), {&entry_->line(), &entry_->pad()});
    if (dialogue_->isVisible())
        for (Sheet* one : dialogue_->sheets()) out.push_back(one);
    return out;
}

// By keys alone to what a finger would touch.
void MainWindow::nextField() {
    entry_->shut(false);
    screen()->refresh();
    std::vector<std::pair<Sheet*, int>> all;
    for (Sheet* sheet : screen()->sheets())
        for (const TextField& field : sheet->fields()) all.emplace_back(sheet, field.hit);
    if (all.empty()) return tell(word("There is no field of text here"), Told::Note);
    const auto& [sheet, hit] = all[field_++ % all.size()];
    sheet->touch(hit);
}

void MainWindow::nextChannel(int step) {
    const auto& all = context_.live.channels();
    const auto here = std::find(all.begin(), all.end(), context_.channel) - all.begin() + step;
    if (here < 0 || here >= static_cast<std::ptrdiff_t>(all.size())) return;
    context_.choose(all[static_cast<std::size_t>(here)]);
    screen()->refresh();
}

bool MainWindow::keyPressed(QKeyEvent* event) {
    const int key = event->key();
    if (key == Qt::Key_Help || (key == Qt::Key_H && event->modifiers() & Qt::ControlModifier)) {
        showHelp();
        return true;
    }
    if (help_->isVisible() && help_->key(event)) return true;
    if (key == Qt::Key_F && event->modifiers() & Qt::ControlModifier) {
        nextField();
        return true;
    }
    if (entry_->isVisible() && entry_->key(event)) return true;
    const bool plain = !(event->modifiers() & (Qt::AltModifier | Qt::ControlModifier)) &&
                       !(key >= Qt::Key_F1 && key <= Qt::Key_F12);
    if (dialogue_->isVisible() && cameUp_.isValid() && cameUp_.elapsed() < kComesUpMs &&
        !(event->modifiers() & (Qt::AltModifier | Qt::ControlModifier)) &&
        !(key == Qt::Key_F11 || key == Qt::Key_F12))
        return true;
    if (dialogue_->isVisible() && plain && dialogue_->key(event)) return true;
    if (key >= Qt::Key_F1 && key <= Qt::Key_F10) {
        entry_->shut(false);
        // of what is chosen now
        if (!event->isAutoRepeat()) {
            showKeys();
            bar_->press(key - Qt::Key_F1);
        }
        return true;
    }
    if (key == Qt::Key_F11) {
        topTouched(kHitLanguage);
        return true;
    }
    if (key == Qt::Key_F12) {
        topTouched(kHitTheme);
        return true;
    }
    if (event->modifiers() & Qt::AltModifier && key >= Qt::Key_0 && key <= Qt::Key_9) {
        showScreen(key == Qt::Key_0 ? 9 : key - Qt::Key_1);
        return true;
    }
    if (event->modifiers() & Qt::ControlModifier) {
        if (key >= Qt::Key_1 && key <= Qt::Key_9) {
            context_.choose(static_cast<unsigned>(key - Qt::Key_0));
            screen()->refresh();
            return true;
        }
        // more than nine
        if (key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
            nextChannel(key == Qt::Key_PageDown ? 1 : -1);
            return true;
        }
        if (key == Qt::Key_L) {
            lock(true);
            return true;
        }
        if (key == Qt::Key_D && dialogue_->channel()) {
            topTouched(kHitDialogue);
            return true;
        }
    }
    const bool done = screen()->key(event);
    if (done) showKeys();
    return done;
}

bool MainWindow::keyReleased(QKeyEvent* event) {
    if (event->isAutoRepeat()) return false;
    if (event->key() < Qt::Key_F1 || event->key() > Qt::Key_F10)
        return screen()->keyReleased(event);
    bar_->letGo(event->key() - Qt::Key_F1);
    return true;
}

bool MainWindow::eventFilter(QObject* object, QEvent* event) {
    auto* widget = qobject_cast<QWidget*>(object);
    if (!widget || widget->window() != this) return false;
    const auto type = event->type();
    if (locked_ || (unlocked_.isValid() && unlocked_.elapsed() < kClothMs)) {
        switch (type) {
            case QEvent::KeyPress:
                if (locked_) cover_->keyPressed(*static_cast<QKeyEvent*>(event));
                return true;
            case QEvent::MouseButtonPress:
            case QEvent::MouseButtonDblClick:
            case QEvent::MouseMove:
                return !locked_ || widget != cover_;
            case QEvent::Wheel:
            case QEvent::TouchBegin:
            case QEvent::TouchUpdate:
                return true;
            // releases come through, so that nothing stays held; lock() has made the sheets forget
            // what a release would do
            case QEvent::KeyRelease:
                cover_->keyReleased(*static_cast<QKeyEvent*>(event));
                return keyReleased(static_cast<QKeyEvent*>(event));
            default:
                return false;
        }
    }
    if (type == QEvent::KeyPress) {
        // a page has handed it on to its field: in a window without the keyboard's focus no field
        // ever has it
        if (passing_ == event) return false;
        passing_ = event;
        const bool done = keyPressed(static_cast<QKeyEvent*>(event));
        passing_ = nullptr;
        return done;
    }
    if (type == QEvent::KeyRelease) return keyReleased(static_cast<QKeyEvent*>(event));
    return false;
}

}  // namespace polyturn::hmi
