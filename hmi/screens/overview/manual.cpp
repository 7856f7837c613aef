#include "hmi/screens/overview/manual.hpp"

#include <array>
#include <cmath>
#include <cstring>

#include "hmi/machine/live/axis_places.hpp"
#include "hmi/machine/live/channel_words.hpp"
#include "hmi/screens/overview/operation_keys.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/set_words.hpp"
#include "hmi/widgets/portrait.hpp"
#include "ipc/requests/start_words.hpp"

namespace polyturn::hmi {
namespace {

constexpr std::array<const char*, 6> kSteps{"", "0.001", "0.01", "0.1", "1", "10"};
// of linear axes; of turning ones it is the same figure in degrees
constexpr std::array<const char*, 6> kInchSteps{"", "0.0001", "0.001", "0.01", "0.1", "1"};
constexpr int kTellMs = 120;
// when no more reports come, the axis stops after this
constexpr const char* kHeldFor = "0.35s";

// feed of all channels in focus, rapid, spindle: less and more
enum Override { kFeedLess, kFeedMore, kRapidLess, kRapidMore, kSpindleLess, kSpindleMore };

}  // namespace

Manual::Manual(Context& context)
    : Screen(context),
      axes_(new FreeSheet(this)),
      side_(new FreeSheet(this)),
      hand_(new HandPage(context, this)),
      pad_(new TextPad(this)) {
    pad_->capitals = true;
    pad_->onText = [this](const QString& text) {
        if (mdi_.size() < 150) {
            mdi_ += text;
            refresh();
        }
    };
    pad_->onBackspace = [this] {
        mdi_.chop(1);
        refresh();
    };
    pad_->onEnter = [this] { enterMdi(); };
    setFocusPolicy(Qt::StrongFocus);
    axes_->onCompose = [this](Writer& w) { composeAxes(w); };
    side_->onCompose = [this](Writer& w) { composeSide(w); };
    axes_->onTouched = [this](int number) { press(number); };
    axes_->onReleased = [this](int) { letGo(); };
    side_->onTouched = [this](int number) { press(number); };
    held_.setInterval(kTellMs);
    QObject::connect(&held_, &QTimer::timeout, [this] { tellHeld(); });
}

void Manual::restore(const QString& state) {
    const int step = state.section(' ', 0, 0).toInt();
    if (step >= 0 && step < static_cast<int>(kSteps.size())) step_ = step;
    showHand(state.section(' ', 1, 1) == "1");
    mdi_ = state.section(' ', 2).left(150);
}

const char* Manual::stepText(std::size_t step) const {
    return (context_.live.unit(context_.channel).inch() ? kInchSteps : kSteps)[step];
}

void Manual::tellHeld() {
    if (heldWords_.isEmpty()) return held_.stop();
    // a key that was held must not go on behind another window
    if (!isVisible() || !isActiveWindow()) return letGo();
    context_.requests.press(QString("jog %1 %2").arg(heldWords_, kHeldFor));
}

void Manual::letGo() {
    hand_->letGo();
    held_.stop();
    if (heldWords_.isEmpty()) return;
    context_.requests.press(QString("jog %1 0s").arg(heldWords_));
    heldWords_.clear();
}

void Manual::press(int number) {
    const Live& live = context_.live;
    if (!live.connected()) return;
    if (std::exchange(typing_, number == kMdiHit || (typing_ && number == kMdiClearHit)) != typing_)
        layOut();
    const QString name = QString("L%1").arg(context_.channel);
    if (number >= kChannelHits) {
        context_.choose(static_cast<unsigned>(number - kChannelHits));
    } else if (number >= kOverrideHits) {
        const ChannelStatus& status = live.channel(context_.channel);
        const unsigned spindle = live.config().channel(context_.channel).default_spindle;
        const auto step = [](double now, bool more, double most) {
            return static_cast<int>(
                std::clamp(std::round(now * 10 + (more ? 1 : -1)) * 10, 0.0, most));
        };
        switch (number - kOverrideHits) {
            case kFeedLess:
            case kFeedMore:
                context_.requests.press(
                    QString("feed_override %1=%2")
                        .arg(name)
                        .arg(step(status.feed_override, number - kOverrideHits == kFeedMore, 150)));
                break;
            case kRapidLess:
            case kRapidMore:
                context_.requests.press(QString("rapid_override %1=%2")
                                            .arg(name)
                                            .arg(step(status.rapid_override,
                                                      number - kOverrideHits == kRapidMore, 100)));
                break;
            default:
                if (spindle)
                    context_.requests.press(
                        QString("spindle_override S%1=%2")
                            .arg(spindle)
                            .arg(std::max(50, step(live.status().spindles[spindle - 1].override,
                                                   number - kOverrideHits == kSpindleMore, 150))));
        }
    } else if (number == kMdiClearHit) {
        context_.requests.press("mdi_clear " + name);
    } else if (number == kMdiHit) {
        // typing only: the mode is chosen by its key
    } else if (number >= kStepHits) {
        step_ = number - kStepHits;
    } else {
        const int axis = number / 10, what = number % 10;
        if (what == 3) {
            context_.requests.press(QString("reference A%1").arg(axis));
        } else if (const QString why = what == 1 || what == 2 ? whyNotMoved() : QString();
                   !why.isEmpty()) {
            context_.tell(why, Told::Refused);
        } else if (what == 1 || what == 2) {
            const QString words = QString("A%1%2").arg(axis).arg(what == 1 ? '+' : '-');
            if (step_) {
                const LengthUnit unit =
                    context_.live.unit(context_.live.config().axis(static_cast<unsigned>(axis)));
                const double way = QString(stepText(static_cast<std::size_t>(step_))).toDouble();
                context_.requests.press(
                    QString("step %1 %2").arg(words, QString::number(unit.held(way), 'g', 12)));
            } else {
                heldWords_ = words;
                context_.requests.press(QString("jog %1 %2").arg(words, kHeldFor));
                held_.start();
            }
        }
    }
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

// As the kernel refuses it (Machine::may_be_moved), before a finger is on the key; empty: axes of
// the channel are moved.
QString Manual::whyNotMoved() const {
    const ChannelStatus& status = context_.live.channel(context_.channel);
    if (context_.live.status().machine_state != 2)
        return word("Axes are moved by hand while the machine is on");
    // With N1337 REL the program goes on from where the axes are then: nothing tells that they were
    // left to be moved.
    const bool left =
        static_cast<ChannelState>(status.state) == ChannelState::Held &&
        ((status.start_missing & start_bit("back_on_path")) ||
         params::bit(context_.live.table(), params::n1337_execution_config, context_.channel, 5));
    if (works(status) && !left)
        return word("A program runs: axes are moved by hand in a hold, after «Jog in hold»");
    return {};
}

void Manual::mode(const char* wanted) {
    context_.requests.press(QString("mode L%1=%2").arg(context_.channel).arg(wanted));
}

void Manual::enterMdi() {
    if (mdi_.trimmed().isEmpty()) return;
    const ChannelStatus& status = context_.live.channel(context_.channel);
    // as the kernel refuses it, and the words stay
    if (static_cast<ChannelMode>(status.mode) != ChannelMode::Mdi &&
        static_cast<ChannelState>(status.state) != ChannelState::Held)
        return context_.tell(word("Blocks are entered in MDI, or while a program is held"),
                             Told::Refused);
    context_.requests.press(QString("mdi L%1 %2").arg(context_.channel).arg(mdi_.trimmed()));
    mdi_.clear();
    refresh();
}

void Manual::resizeEvent(QResizeEvent*) { layOut(); }

std::vector<Sheet*> Manual::sheets() {
    if (handShown_) return hand_->sheets();
    if (typing_) return {axes_, side_, pad_};
    return {axes_, side_};
}

void Manual::turnTo(int page) {
    showHand(page == 1);
    typing_ = page == 2;
    layOut();
}

void Manual::showHand(bool on) {
    letGo();
    handShown_ = on;
    typing_ = false;
    layOut();
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

void Manual::layOut() {
    const int side = px(390), edge = px(8);
    const bool stands = upright(*this);
    // beneath the axes, while a block is entered; on a portrait panel right above what is typed
    const int keyboard = typing_ ? px(300) : 0;
    const Parted all = parted(*this, rect().adjusted(edge, edge, -edge, -edge), side,
                              px(typing_ ? 470 : 610), edge);
    axes_->setGeometry(all.main.adjusted(0, 0, 0, -keyboard));
    pad_->setGeometry(all.main.left(),
                      stands ? all.main.bottom() + 1 - keyboard : height() - keyboard,
                      all.main.width(), std::max(0, keyboard - (stands ? 0 : edge)));
    hand_->setGeometry(0, 0, width(), height());
    hand_->setVisible(handShown_);
    axes_->setVisible(!handShown_);
    side_->setVisible(!handShown_);
    pad_->setVisible(typing_ && !handShown_);
    side_->setGeometry(all.side);
    for (Sheet* one : sheets()) one->refresh();
}

void Manual::composeAxes(Writer& w) {
    const Theme& t = theme();
    const double wide = axes_->width(), high = axes_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    const Live& live = context_.live;
    if (!live.connected())
        return void(w.text(QRectF(0, 0, wide, high), word("No controller answers"),
                           lettering(20, true), t.dim, Qt::AlignCenter));
    const ChannelConfig& config = live.config().channel(context_.channel);
    // channels
    double x = 0;
    // sixteen fit, too
    const double strip = wide - px(270),
                 step = std::min<double>(px(102), strip / static_cast<double>(std::max<std::size_t>(
                                                              1, live.channels().size())));
    const bool narrow = step < px(84);
    for (const unsigned channel : live.channels()) {
        const bool here = channel == context_.channel;
        const QRectF box(x, 0, step - px(narrow ? 3 : 6), px(42));
        w.fill(box, here ? t.mark : t.card, px(6));
        w.frame(box, here ? t.accent : t.edge, px(6), here ? px(2) : 1);
        // its sign stays, however narrow the key is
        const StateWords its = stateWords(live.channel(channel));
        if (step < px(48)) {
            w.text(QRectF(box.left(), px(3), box.width(), px(19)), QString::number(channel),
                   lettering(14, here), t.text, Qt::AlignCenter);
            w.sign(QRectF(box.center().x() - px(7), px(24), px(14), px(14)), its.sign,
                   colourOf(its.tone));
        } else {
            w.sign(QRectF(box.left() + px(narrow ? 5 : 10), narrow ? px(13) : px(12),
                          px(narrow ? 16 : 18), px(narrow ? 16 : 18)),
                   its.sign, colourOf(its.tone));
            w.text(box.adjusted(px(narrow ? 24 : 34), 0, -px(2), 0), QString("L%1").arg(channel),
                   lettering(narrow ? 15 : 18, here), t.text);
        }
        w.hit(box, kChannelHits + static_cast<int>(channel));
        x += step;
    }
    const ChannelStatus& status = live.channel(context_.channel);
    const StateWords state = stateWords(status);
    w.text(QRectF(x + px(8), 0, wide - x - px(18), px(42)),
           modeWord(status.mode) + QString::fromUtf8("  ·  ") + state.text, lettering(18, true),
           colourOf(state.tone), kRight);
    // axes, each with its keys
    const bool refused = !whyNotMoved().isEmpty();
    const std::size_t count = std::max<std::size_t>(config.axis_count, 1);
    const double top = px(52), foot = px(64),
                 row = std::min<double>(px(112), (high - top - foot) / static_cast<double>(count));
    if (typing_ && row < px(80)) return composePlaces(w, QRectF(0, top, wide, high - top - px(6)));
    for (std::size_t place = 0; place < config.axis_count; ++place) {
        const unsigned number = config.axes[place];
        const AxisPlaces at(live, context_.channel, place);
        const AxisConfig& axis = at.axis;
        const AxisStatus& now = at.now;
        const LengthUnit& unit = at.unit;
        const QRectF box(0, top + static_cast<double>(place) * row, wide, row - px(8));
        w.fill(box, t.card, px(8));
        const bool here = number == chosenAxis();
        w.frame(box,
                here                  ? t.accent
                : now.flags & kMoving ? t.good
                                      : t.edge,
                px(8), now.flags & kMoving || here ? px(2) : 1);
        if (now.flags & kMoving)
            w.sign(QRectF(box.left() + px(5), box.top() + px(5), px(16), px(16)), Sign::Run,
                   t.good);
        const double keyWide = px(92), keyHigh = std::min<double>(box.height() - px(16), px(80)),
                     keyTop = box.center().y() - keyHigh / 2;
        w.text(QRectF(box.left() + px(14), box.top(), px(60), box.height()),
               fromView(axis.name_text()), lettering(32, true), t.text);
        for (const bool positive : {false, true}) {
            const QRectF key(positive ? box.right() - keyWide - px(10) : box.left() + px(78),
                             keyTop, keyWide, keyHigh);
            const bool down = heldWords_ == QString("A%1%2").arg(number).arg(positive ? '+' : '-');
            w.fill(key, down ? t.accent : refused ? t.card : t.raised, px(8));
            w.frame(key, down ? t.accent : t.edge, px(8), 1);
            w.text(key,
                   fromView(axis.name_text()) + (positive ? QString("+") : QString::fromUtf8("−")),
                   lettering(24, true),
                   down      ? t.onAccent
                   : refused ? t.faint
                             : t.text,
                   Qt::AlignCenter);
            w.hit(key, jogHit(number, positive));
        }
        const double left = box.left() + px(78) + keyWide + px(10),
                     room = box.width() - px(78) - 2 * keyWide - px(30);
        if (at.turns) {
            w.text(QRectF(left, box.top(), room, box.height()), at.spindle(), lettering(17), t.dim,
                   kRight);
            continue;
        }
        const bool referenced = at.referenced;
        // In the order of the overview: what the workpiece counts is the large one.
        const double middle = left + room * 0.6, head = box.height() * 0.24,
                     line = box.height() * 0.46;
        const double begin = referenced ? left : std::min(left + px(130), middle - px(20));
        const QColor colour = referenced ? t.text : t.warn;
        w.text(QRectF(begin, box.top() + px(2), middle - begin, head), word("Workpiece"),
               lettering(12.5, false, Face::Condensed), t.dim, kRight);
        w.text(QRectF(middle + px(8), box.top() + px(2), left + room - middle - px(8), head),
               word("Machine"), lettering(12.5, false, Face::Condensed), t.dim, kRight);
        w.text(QRectF(begin, box.top() + head, middle - begin, line), at.workpiece(),
               lettering(room < px(330)          ? 20
                         : box.height() < px(80) ? 27
                                                 : 33,
                         true),
               colour, kRight);
        w.text(QRectF(middle + px(8), box.top() + head, left + room - middle - px(8), line),
               at.machine(), lettering(room < px(330) ? 14 : 19), referenced ? t.dim : t.warn,
               kRight);
        if (!referenced)
            w.text(QRectF(left + px(152), box.top() + box.height() * 0.68,
                          room - px(152) - (axis.diameter ? px(26) : 0), box.height() * 0.28),
                   word("not referenced"), lettering(14), t.warn, kRight);
        if (axis.diameter)
            w.text(QRectF(left + room - px(20), box.top() + box.height() * 0.68, px(20),
                          box.height() * 0.28),
                   QString::fromUtf8("⌀"), lettering(16), t.dim, kRight);
        if (!referenced) {
            const QRectF key(left, box.top() + px(7),
                             std::min<double>(px(124), begin - left - px(6)), box.height() * 0.5);
            w.fill(key, t.raised, px(8));
            w.frame(key, t.edge, px(8), 1);
            w.text(key, word("Reference"), lettering(15, true), t.text, Qt::AlignCenter);
            w.hit(key, static_cast<int>(number) * 10 + 3);
        }
        w.text(
            QRectF(left, box.top() + box.height() * 0.68, px(150), box.height() * 0.28),
            QString("A%1   %2 %3").arg(number).arg(unit.speed(now.velocity * 60), unit.perMinute()),
            lettering(14), t.dim);
    }
    // steps, true lengths or angles whatever the axis shows
    bool linear = false, rotary = false;
    for (std::size_t place = 0; place < config.axis_count; ++place)
        (live.config().axis(config.axes[place]).rotary ? rotary : linear) = true;
    const QString length = live.unit(context_.channel).name(),
                  unit = rotary && linear ? length + QString::fromUtf8(", °")
                         : rotary         ? QString::fromUtf8("°")
                                          : length;
    const double stepWide = (wide - px(6) * 5) / 6;
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
        const QRectF box(static_cast<double>(i) * (stepWide + px(6)), high - px(54), stepWide,
                         px(52));
        const bool here = step_ == static_cast<int>(i);
        w.fill(box, here ? t.mark : t.card, px(6));
        w.frame(box, here ? t.accent : t.edge, px(6), here ? px(2) : 1);
        const QString label = i == 0 ? word("Continuous") : QString("%1 %2").arg(stepText(i), unit);
        const QFont plain = lettering(17, here);
        w.text(box, label,
               wordsWidth(label, plain) > box.width() - px(8) ? lettering(14, here, Face::Condensed)
                                                              : plain,
               t.text, Qt::AlignCenter);
        w.hit(box, kStepHits + static_cast<int>(i));
    }
}

// Where the keyboard leaves no room for keys of axes: where they are, what is left of the block,
// how far they are behind.
void Manual::composePlaces(Writer& w, const QRectF& box) {
    const Theme& t = theme();
    const Live& live = context_.live;
    const ChannelConfig& config = live.config().channel(context_.channel);
    w.fill(box, t.card, px(8));
    const double name = px(80), column = (box.width() - name - px(28)) / 4, head = px(20);
    const QString heads[] = {word("Workpiece"), word("Machine"), word("To go"),
                             word("Follow. error")};
    const auto cell = [&](int c, double y, double high) {
        return QRectF(box.left() + px(14) + name + c * column, y, column, high);
    };
    for (int c = 0; c < 4; ++c)
        w.text(cell(c, box.top() + px(2), head), heads[c], lettering(12.5, false, Face::Condensed),
               t.dim, kRight);
    const double row = std::min<double>(
        px(40), (box.height() - head - px(6)) / std::max<double>(config.axis_count, 1));
    double y = box.top() + head + px(2);
    for (std::size_t place = 0; place < config.axis_count; ++place, y += row) {
        const AxisPlaces axis(live, context_.channel, place);
        const double size = row < px(24) ? 13 : row < px(32) ? 17 : 21;
        w.text(QRectF(box.left() + px(14), y, name, row), axis.name(), lettering(size, true),
               axis.moves ? t.good : t.text);
        if (axis.turns) {
            w.text(QRectF(cell(0, y, row).left(), y, column * 4, row), axis.spindle(),
                   lettering(std::min(size, 17.0)), t.dim, kRight);
            continue;
        }
        w.text(cell(0, y, row), axis.workpiece(), lettering(size, true), t.text, kRight);
        w.text(cell(1, y, row), axis.machineOrNone(), lettering(size * 0.8),
               axis.referenced ? t.dim : t.warn, kRight);
        w.text(cell(2, y, row), axis.toGo(), lettering(size * 0.8), axis.goes ? t.text : t.faint,
               kRight);
        w.text(cell(3, y, row), axis.lag(), lettering(size * 0.8), t.dim, kRight);
    }
}

void Manual::composeSide(Writer& w) {
    const Theme& t = theme();
    const double wide = side_->width(), high = side_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    const Live& live = context_.live;
    if (!live.connected()) return;
    const ChannelStatus& status = live.channel(context_.channel);
    const unsigned spindle = live.config().channel(context_.channel).default_spindle;
    w.fill(QRectF(0, 0, wide, px(244)), t.card, px(8));
    w.text(QRectF(px(14), px(8), wide - px(28), px(26)), word("Overrides"), lettering(16, true),
           t.text);
    struct Line {
        const char* title;
        double value;
        int less;
        double most;
    };
    const Line lines[] = {
        {WORD("Feed"), status.feed_override, kFeedLess, 1.5},
        {WORD("Rapid"), status.rapid_override, kRapidLess, 1.0},
        {WORD("Spindle"), spindle ? live.status().spindles[spindle - 1].override : 0.0,
         kSpindleLess, 1.5}};
    for (int i = 0; i < 3; ++i) {
        const double top = px(40) + i * px(66);
        w.text(QRectF(px(14), top, px(110), px(24)), word(lines[i].title),
               lettering(15, i == override_), i == override_ ? t.accent : t.dim);
        w.text(QRectF(px(130), top, wide - px(258), px(24)),
               QString("%1 %").arg(std::lround(lines[i].value * 100)), lettering(18, true),
               std::abs(lines[i].value - 1) > 1e-6 ? t.warn : t.text, kRight);
        w.bar(QRectF(px(14), top + px(34), wide - px(142), px(9)), lines[i].value / lines[i].most,
              std::abs(lines[i].value - 1) > 1e-6 ? t.warn : t.accent, t.edge);
        for (int more = 0; more < 2; ++more) {
            const QRectF key(wide - px(118) + more * px(56), top, px(50), px(52));
            w.fill(key, t.raised, px(6));
            w.frame(key, t.edge, px(6), 1);
            w.text(key, more ? QString("+") : QString::fromUtf8("−"), lettering(22, true), t.text,
                   Qt::AlignCenter);
            w.hit(key, kOverrideHits + lines[i].less + more);
        }
    }
    // MDI
    const double hold = composeMdi(w, px(256), high - px(60)) + px(12);
    // the return out of a hold
    w.fill(QRectF(0, hold, wide, high - hold), t.card, px(8));
    const Plight now = plight(live, context_.alarms, context_.channel);
    // A running program lacks nothing and needs no start.
    const auto state = static_cast<ChannelState>(live.channel(context_.channel).state);
    const bool runs = now.kind == Plight::Kind::None &&
                      (state == ChannelState::Running || state == ChannelState::Waiting);
    const QColor colour = now.kind == Plight::Kind::Alarm   ? t.bad
                          : now.kind == Plight::Kind::Waits ? t.wait
                          : runs                            ? t.good
                          : now.kind == Plight::Kind::None  ? t.dim
                          : now.kind == Plight::Kind::Told  ? t.accent
                                                            : t.warn;
    const Sign sign = now.kind == Plight::Kind::Alarm   ? Sign::Alarm
                      : now.kind == Plight::Kind::Waits ? Sign::Wait
                      : runs                            ? Sign::Run
                      : now.kind == Plight::Kind::None  ? Sign::Good
                      : now.kind == Plight::Kind::Told  ? Sign::Note
                                                        : Sign::Warning;
    w.sign(QRectF(px(14), hold + px(12), px(20), px(20)), sign, colour);
    Item& words = w.text(QRectF(px(42), hold + px(10), wide - px(54), high - hold - px(20)),
                         runs                             ? word("The program runs")
                         : now.kind == Plight::Kind::None ? word("Nothing is missing for a start")
                                                          : now.text,
                         lettering(15), t.text, Qt::AlignLeft | Qt::AlignTop);
    words.wraps = true;
    words.data = true;
}

// The newest lines of the list, what has run in grey, then the field that is typed in.
double Manual::composeMdi(Writer& w, double top, double most) {
    const Theme& t = theme();
    const double wide = side_->width(), row = px(24), frame = px(124);
    MdiList list{};
    const std::uint32_t count = context_.live.mdi(context_.channel, list) ? list.count : 0;
    const auto room = static_cast<std::uint32_t>(
                   std::clamp((most - px(12) - top - frame) / row, 1.0, 6.0)),
               shown = std::min(count, room);
    const double end = top + frame + shown * row;
    w.fill(QRectF(0, top, wide, end - top), t.card, px(8));
    const double clear = count ? px(120) : 0;
    w.text(QRectF(px(14), top + px(8), wide - px(28) - clear, px(26)),
           word("A block by hand (MDI)"), lettering(16, true), t.text);
    if (count) {
        const QRectF key(wide - clear - px(12), top + px(5), clear, px(32));
        w.fill(key, t.raised, px(6));
        w.frame(key, t.edge, px(6), 1);
        w.text(key, word("Delete all"), lettering(14), t.text, Qt::AlignCenter);
        w.hit(key, kMdiClearHit);
    }
    double y = top + px(40);
    for (std::uint32_t i = count - shown; i < count; ++i, y += row) {
        const MdiLine& line = list.lines[i];
        const auto state = static_cast<MdiState>(line.state);
        const bool over = state == MdiState::Done || state == MdiState::BrokenOff;
        const Sign sign = state == MdiState::Runs        ? Sign::Run
                          : state == MdiState::Done      ? Sign::Good
                          : state == MdiState::BrokenOff ? Sign::Warning
                                                         : Sign::None;
        w.sign(QRectF(px(14), y + px(4), px(16), px(16)), sign,
               state == MdiState::Runs ? t.good : t.faint);
        w.data(QRectF(px(38), y, wide - px(52), row),
               QString::fromUtf8(line.text.data(),
                                 static_cast<int>(::strnlen(line.text.data(), line.text.size()))),
               lettering(15, false, Face::Program),
               over                      ? t.faint
               : state == MdiState::Runs ? t.good
                                         : t.text);
    }
    w.field(QRectF(px(12), y + px(2), wide - px(24), px(46)), mdi_, QString(), typing_, kMdiHit,
            Face::Program);
    const ChannelStatus& status = context_.live.channel(context_.channel);
    const bool takes = static_cast<ChannelMode>(status.mode) == ChannelMode::Mdi ||
                       static_cast<ChannelState>(status.state) == ChannelState::Held;
    w.text(QRectF(px(14), y + px(54), wide - px(28), px(22)),
           takes ? word("Enter takes the block, Start runs it")
                 : word("MDI mode takes blocks, and a program in hold"),
           lettering(13), takes || !typing_ ? t.dim : t.warn);
    return end;
}

// The key of the emergency stop stays one for a while after the machine was on, and after each
// press: who hits it again and again in fright must not switch the machine on.
bool Manual::stops() const {
    constexpr qint64 kStaysMs = 3000;
    return context_.live.status().machine_state == 2 ||
           (stopsSince_.isValid() && stopsSince_.elapsed() < kStaysMs);
}

void Manual::stopsSince() { stopsSince_.start(); }

void Manual::follow() {
    if (context_.live.connected() && context_.live.status().machine_state == 2) stopsSince();
}

void Manual::refresh() {
    if (handShown_) return hand_->refresh();
    for (Sheet* one : sheets()) one->refresh();
}

std::vector<SoftKey> Manual::keys() {
    if (handShown_) return hand_->keys([this] { showHand(false); });
    const Live& live = context_.live;
    const bool there = live.connected();
    const ChannelStatus& status = live.channel(context_.channel);
    const auto mode_now = static_cast<ChannelMode>(status.mode);
    const QString name = QString("L%1").arg(context_.channel);
    const auto press_words = [this](const QString& words) {
        return [this, words] { context_.requests.press(words); };
    };
    const bool held = static_cast<ChannelState>(status.state) == ChannelState::Held;
    const bool away = (status.start_missing & start_bit("back_on_path")) != 0;
    const bool on = live.status().machine_state == 2;
    const bool rests = static_cast<ChannelState>(status.state) == ChannelState::Reset ||
                       static_cast<ChannelState>(status.state) == ChannelState::Ended;
    // Leaving the path in a hold and the return have one key: only one of them can be gone. What it
    // asks keeps a second press of the first from being the other.
    SoftKey start = startKey(context_);
    if (mode_now == ChannelMode::Mdi && rests && !status.mdi_waiting)
        start.act = [this] {
            context_.tell(mdi_.trimmed().isEmpty() ? word("No block is entered")
                                                   : word("Enter takes the block first"),
                          Told::Refused);
        };
    if (mode_now != ChannelMode::Mdi && rests && typing_ && !mdi_.trimmed().isEmpty()) {
        // it would run the program instead of what is read in the field
        start.confirm.clear();
        start.act = [this] {
            context_.tell(word("The line of MDI is not entered: choose MDI, or delete the line"),
                          Told::Refused);
        };
    }
    std::vector<SoftKey> keys{
        std::move(start),
        holdKey(context_),
        resetKey(context_),
        {word("Automatic"), [this] { mode("auto"); }, Sign::None, there,
         mode_now == ChannelMode::Auto},
        {word("Jog"),
         [this, held, name] {
             // The mode stays until the program ends; a reset for it would cost the part.
             if (held)
                 return context_.tell(word("A program is held: «Jog in hold %1» lets its axes be "
                                           "moved")
                                          .arg(name),
                                      Told::Refused);
             mode("jog");
         },
         Sign::Manual, there, mode_now == ChannelMode::Jog},
        {word("MDI"),
         [this, held] {
             letGo();
             if (!held) mode("mdi");  // in a hold the field takes blocks in any mode
             typing_ = true;
             layOut();
             refresh();
         },
         Sign::None, there, mode_now == ChannelMode::Mdi},
        {word("Wheel, tool, transfer"), [this] { showHand(true); }, Sign::Right, there},
        away ? SoftKey{word("Return %1").arg(name),
                       press_words("return " + name),
                       Sign::Left,
                       there,
                       false,
                       false,
                       word("The axes go back: press again"),
                       {},
                       name}
             : SoftKey{word("Jog in hold %1").arg(name), press_words("jog_in_hold " + name),
                       Sign::Hold, there && held},
        {word("Reference all"), press_words("reference all"), Sign::Offsets, there && on, false,
         false, word("All axes move: press again")},
        {stops() ? word("Emergency stop") : word("Machine on"),
         [this] {
             if (stops()) {
                 stopsSince();
                 return context_.requests.press("emergency_stop");
             }
             if (context_.live.status().machine_state == 0)
                 context_.requests.press("release_emergency_stop");
             context_.requests.press("machine_on");
         },
         Sign::Off, there, false, stops(),
         stops() ? QString() : word("Switches the drives on: press again")},
    };
    return keys;
}

unsigned Manual::chosenAxis() const {
    const ChannelConfig& config = context_.live.config().channel(context_.channel);
    return config.axis_count ? config.axes[std::min<std::size_t>(place_, config.axis_count - 1)]
                             : 0;
}

// Up and down choose the axis, plus and minus move it as long as they are held or by the step, left
// and right choose the step, Home seeks its reference point; Tab chooses an override, page up and
// page down change it.
bool Manual::key(QKeyEvent* event) {
    if (handShown_) return hand_->key(event);
    if (!typing_) {
        const unsigned axis = chosenAxis();
        const std::size_t axes = context_.live.config().channel(context_.channel).axis_count;
        switch (event->key()) {
            case Qt::Key_Up:
                place_ = place_ ? place_ - 1 : 0;
                break;
            case Qt::Key_Down:
                place_ = std::min<unsigned>(place_ + 1, axes ? static_cast<unsigned>(axes) - 1 : 0);
                break;
            case Qt::Key_Left:
                step_ = std::max(step_ - 1, 0);
                break;
            case Qt::Key_Right:
                step_ = std::min<int>(step_ + 1, kSteps.size() - 1);
                break;
            case Qt::Key_Plus:
            case Qt::Key_Minus:
                if (axis && !event->isAutoRepeat())
                    press(jogHit(axis, event->key() == Qt::Key_Plus));
                return true;
            case Qt::Key_Home:
                if (axis) press(static_cast<int>(axis) * 10 + 3);
                return true;
            case Qt::Key_Tab:
                override_ = (override_ + 1) % 3;
                break;
            case Qt::Key_Backtab:
                override_ = (override_ + 2) % 3;
                break;
            case Qt::Key_PageUp:
                press(kOverrideHits + 2 * override_ + 1);
                return true;
            case Qt::Key_PageDown:
                press(kOverrideHits + 2 * override_);
                return true;
            default:
                return false;
        }
        refresh();
        return true;
    }
    if (event->key() == Qt::Key_Escape) {
        typing_ = false;
        layOut();
    } else if (event->key() == Qt::Key_Backspace)
        mdi_.chop(1);
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        enterMdi();
    else if (event->key() == Qt::Key_Delete) {
        if (mdi_.isEmpty())
            press(kMdiClearHit);
        else
            mdi_.clear();
    } else if (!event->text().isEmpty() && event->text()[0].isPrint() && mdi_.size() < 150)
        mdi_ += event->text().toUpper();
    else
        return false;
    refresh();
    return true;
}

// Whatever was held: a shift that is let go first makes another key of a plus.
bool Manual::keyReleased(QKeyEvent*) {
    if (heldWords_.isEmpty()) return false;
    letGo();
    refresh();
    return true;
}

}  // namespace polyturn::hmi
