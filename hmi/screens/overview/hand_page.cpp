#include "hmi/screens/overview/hand_page.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <cmath>

#include "hmi/machine/tools/tool_words.hpp"
#include "hmi/screens/overview/operation_keys.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/portrait.hpp"
#include "ipc/model/machine/active_tool.hpp"

namespace polyturn::hmi {
namespace {

constexpr double kClicksATurn = 100, kTurn = 6.283185307179586;
constexpr std::array<int, 3> kFactors{1, 10, 100};
constexpr long kHandSpeed = 300;    // 1/min, where no program has said another
constexpr double kStandsBelow = 1;  // 1/min

}  // namespace

HandPage::HandPage(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      handwheel_(new FreeSheet(this)),
      state_(new FreeSheet(this)),
      tools_(new Table(this)),
      steps_(new Table(this)) {
    handwheel_->onCompose = [this](Writer& w) { composeWheel(w); };
    handwheel_->onTouched = [this](int number) {
        focus_ = 0;
        if (number >= kFactorHits && number < kFactorHits + 3)
            factor_ = kFactors[static_cast<std::size_t>(number - kFactorHits)];
        else if (number >= kAxisHits && number < kFactorHits)
            place_ = static_cast<unsigned>(number - kAxisHits);
        else if (number == kMinusHit || number == kPlusHit)
            turn(number == kPlusHit ? 1 : -1);
        refresh();
    };
    handwheel_->installEventFilter(this);
    state_->onCompose = [this](Writer& w) { composeState(w); };
    tools_->columns = {{word("Station"), 0.8, kRight}, {word("Tool"), 2.4}, {"", 0.5}};
    tools_->rowUnits = 38;
    tools_->nothing = word("This channel has no turret.");
    tools_->rows = [this] { return static_cast<int>(stations_.size()); };
    tools_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        const Station& one = stations_[static_cast<std::size_t>(row)];
        const ToolRow* tool = toolOf(context_.live, one.tool);
        const ChannelView& view = context_.live.view(context_.channel);
        const std::int32_t stands =
            active_tool(context_.live.table(), context_.live.outputs(), context_.channel);
        const bool works =
            stands > 0 ? stands == one.number : view.known && view.picture.tool == one.number;
        if (column == 0)
            return {QString::number(one.number), works ? t.good : t.dim,
                    works ? Sign::Run : Sign::None, true};
        if (column == 1)
            return {tool ? toolName(*tool, one.tool) : QString::fromUtf8("–"),
                    tool ? t.text : t.dim};
        return tool ? Table::Cell{{}, colourOf(toolWords(*tool).tone), toolWords(*tool).sign}
                    : Table::Cell{};
    };
    tools_->onChosen = [this] {
        focus_ = 1;
        if (context_.keysChanged) context_.keysChanged();
    };
    steps_->columns = {{"", 0.6, kRight}, {word("Part transfer, step by step"), 4}, {"", 1.2}};
    steps_->rowUnits = 34;
    steps_->textUnits = 14.5;
    steps_->nothing =
        word("No part transfer is set up on this machine: its channels choose no counter spindle.");
    steps_->rows = [this] { return static_cast<int>(transfer_.size()); };
    steps_->cell = [this](int row, int column) -> Table::Cell {
        const TransferStep& one = transfer_[static_cast<std::size_t>(row)];
        if (column == 0) return {QString::number(row + 1), theme().dim};
        if (column == 1) return {word(one.title)};
        const bool jogged = one.code < 0;
        return {jogged ? QString("L%1").arg(one.channel)
                       : QString("L%1 M%2").arg(one.channel).arg(one.code),
                theme().accent, jogged ? Sign::Manual : Sign::None, true, Face::Program};
    };
    steps_->onChosen = [this] {
        focus_ = 2;
        if (context_.keysChanged) context_.keysChanged();
    };
}

unsigned HandPage::axis() const {
    const ChannelConfig& config = context_.live.config().channel(context_.channel);
    return context_.live.connected() && place_ < config.axis_count ? config.axes[place_] : 0;
}

const TransferStep* HandPage::chosenStep() const {
    const auto row = static_cast<std::size_t>(steps_->row());
    return row < transfer_.size() ? &transfer_[row] : nullptr;
}

bool HandPage::idle(unsigned channel) const {
    const auto state = static_cast<ChannelState>(context_.live.channel(channel).state);
    return state != ChannelState::Running && state != ChannelState::Waiting;
}

void HandPage::turn(int clicks) {
    if (!axis() || clicks == 0) return;
    turned_ += clicks;
    context_.requests.press(QString("handwheel 1 A%1 %2%3")
                                .arg(axis())
                                .arg(clicks > 0 ? "+" : "")
                                .arg(clicks * factor_));
    handwheel_->refresh();
}

// A hundred clicks a turn; what is left of a click waits.
bool HandPage::eventFilter(QObject* object, QEvent* event) {
    if (object != handwheel_) return false;
    const auto type = event->type();
    if (type == QEvent::Wheel) {
        turn(static_cast<QWheelEvent*>(event)->angleDelta().y() > 0 ? 1 : -1);
        return true;
    }
    if (type != QEvent::MouseButtonPress && type != QEvent::MouseMove &&
        type != QEvent::MouseButtonRelease)
        return false;
    const QPointF at = static_cast<QMouseEvent*>(event)->position();
    const QRectF dial = handwheel_->boxOf(kDialHit);
    const double angle = std::atan2(at.y() - dial.center().y(), at.x() - dial.center().x());
    if (type == QEvent::MouseButtonPress) {
        dialing_ = dial.contains(at);
        lastAngle_ = angle;
        angleLeft_ = 0;
        return false;
    }
    if (!dialing_) return false;
    if (type == QEvent::MouseMove) {
        angleLeft_ += std::remainder(angle - lastAngle_, kTurn);
        lastAngle_ = angle;
        const int clicks = static_cast<int>(angleLeft_ / kTurn * kClicksATurn);
        if (clicks) {
            angleLeft_ -= clicks * kTurn / kClicksATurn;
            turn(clicks);
        }
    } else {
        dialing_ = false;
    }
    return false;
}

void HandPage::composeWheel(Writer& w) {
    const Theme& t = theme();
    const double wide = handwheel_->width(), high = handwheel_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    if (focus_ == 0) w.frame(QRectF(0, 0, wide, high), t.accent, px(8), px(2));
    w.text(QRectF(px(14), px(8), wide - px(28), px(28)), word("Handwheel"), lettering(17, true),
           t.text);
    if (!context_.live.connected()) return;
    w.data(QRectF(wide / 2, px(8), wide / 2 - px(16), px(28)),
           channelTitle(context_.live, context_.channel), lettering(17, true), t.dim, kRight);
    const ChannelConfig& config = context_.live.config().channel(context_.channel);
    const double each =
        std::min<double>(px(84), (wide - px(24)) / std::max<std::size_t>(1, config.axis_count));
    for (unsigned place = 0; place < config.axis_count; ++place) {
        const QRectF box(px(12) + place * each, px(44), each - px(6), px(48));
        const bool here = place == place_;
        w.fill(box, here ? t.mark : t.raised, px(6));
        w.frame(box, here ? t.accent : t.edge, px(6), here ? px(2) : 1);
        w.text(box, fromView(context_.live.config().axis(config.axes[place]).name_text()),
               lettering(20, true), t.text, Qt::AlignCenter);
        w.hit(box, kAxisHits + static_cast<int>(place));
    }
    for (std::size_t i = 0; i < kFactors.size(); ++i) {
        const double unit = (wide - px(24)) / 3;
        const QRectF box(px(12) + static_cast<double>(i) * unit, px(100), unit - px(6), px(46));
        const bool here = factor_ == kFactors[i];
        w.fill(box, here ? t.mark : t.raised, px(6));
        w.frame(box, here ? t.accent : t.edge, px(6), here ? px(2) : 1);
        w.text(box, QString::fromUtf8("× %1").arg(kFactors[i]), lettering(17, here), t.text,
               Qt::AlignCenter);
        w.hit(box, kFactorHits + static_cast<int>(i));
    }
    if (const unsigned number = axis()) {
        const AxisConfig& axis = context_.live.config().axis(number);
        const AxisStatus& now = context_.live.status().axes[number - 1];
        // As on the jog page: what the workpiece counts is the large one.
        double workpiece = 0;
        const bool known = context_.live.workpiece(context_.channel, place_, now.act, workpiece);
        const LengthUnit shownIn = context_.live.unit(axis);
        const QString unit = (axis.diameter ? QString::fromUtf8("⌀ ") : QString()) + shownIn.name();
        const double middle = wide * 0.62;
        w.text(QRectF(px(14), px(150), px(110), px(18)), unit, lettering(13), t.dim);
        w.text(QRectF(px(14), px(150), middle - px(14), px(18)), word("Workpiece"),
               lettering(12.5, false, Face::Condensed), t.dim, kRight);
        w.text(QRectF(middle, px(150), wide - middle - px(14), px(18)), word("Machine"),
               lettering(12.5, false, Face::Condensed), t.dim, kRight);
        w.text(QRectF(px(14), px(166), px(60), px(42)), fromView(axis.name_text()),
               lettering(28, true), t.text);
        if (now.flags & kMoving) w.sign(QRectF(px(58), px(178), px(16), px(16)), Sign::Run, t.good);
        w.text(QRectF(px(74), px(166), middle - px(74), px(42)),
               known ? shownIn.text(shownPlace(axis, workpiece)) : QString::fromUtf8("–"),
               lettering(30, true), t.text, kRight);
        w.text(QRectF(middle, px(166), wide - middle - px(14), px(42)),
               shownIn.text(shownPlace(axis, now.act)), lettering(18), t.dim, kRight);
    }
    // the dial: a finger turns it
    const double top = px(210), side = std::min(wide - px(150), high - top - px(12)), r = side / 2;
    const QPointF middle(wide / 2, top + r);
    w.fill(QRectF(middle.x() - r, middle.y() - r, side, side), t.raised, r);
    w.frame(QRectF(middle.x() - r, middle.y() - r, side, side), t.edge, r, px(3));
    for (int i = 0; i < 20; ++i) {
        const double a = kTurn * (i / 20.0 + turned_ / kClicksATurn) - kTurn / 4;
        const QPointF way(std::cos(a), std::sin(a));
        w.line(middle + way * (r * 0.86), middle + way * (r * 0.95), i == 0 ? t.accent : t.dim,
               i == 0 ? px(5) : px(2));
    }
    const QPointF knob = middle + QPointF(std::cos(kTurn * turned_ / kClicksATurn - kTurn / 4),
                                          std::sin(kTurn * turned_ / kClicksATurn - kTurn / 4)) *
                                      (r * 0.62);
    w.fill(QRectF(knob.x() - r * 0.16, knob.y() - r * 0.16, r * 0.32, r * 0.32), t.accent,
           r * 0.16);
    w.hit(QRectF(middle.x() - r, middle.y() - r, side, side), kDialHit);
    for (const bool plus : {false, true}) {
        const QRectF box(plus ? wide - px(64) : px(12), middle.y() - px(34), px(52), px(68));
        w.fill(box, t.raised, px(8));
        w.frame(box, t.edge, px(8), 1);
        w.text(box, plus ? QString("+") : QString::fromUtf8("−"), lettering(26, true), t.text,
               Qt::AlignCenter);
        w.hit(box, plus ? kPlusHit : kMinusHit);
    }
}

// Which chucks hold, and whether the counter spindle follows.
void HandPage::composeState(Writer& w) {
    const Theme& t = theme();
    w.fill(QRectF(0, 0, state_->width(), state_->height()), t.window);
    w.fill(QRectF(0, 0, state_->width(), state_->height()), t.card, px(8));
    if (!context_.live.connected()) return;
    double y = px(6);
    for (std::uint32_t s = 1; s <= std::min<std::uint32_t>(2, context_.live.config().last_spindle);
         ++s) {
        if (!context_.live.config().spindle(s).exists()) continue;
        const bool open = context_.live.plc(signals::sp_unclamped(s)) != 0;
        const SpindleStatus& now = context_.live.status().spindles[s - 1];
        w.sign(QRectF(px(12), y + px(4), px(20), px(20)), open ? Sign::Warning : Sign::Lock,
               open ? t.warn : t.good);
        w.text(QRectF(px(42), y, px(40), px(28)), QString("S%1").arg(s), lettering(16, true),
               t.text);
        w.text(QRectF(px(86), y, px(160), px(28)), open ? word("chuck open") : word("chuck holds"),
               lettering(15), open ? t.warn : t.good);
        w.text(QRectF(px(246), y, state_->width() - px(258), px(28)),
               now.master ? word("follows S%1").arg(now.master)
                          : QString("%1 %2").arg(now.speed, 0, 'f', 0).arg(unitWord("1/min")),
               lettering(15), now.master ? t.accent : t.dim, kRight);
        y += px(30);
    }
}

void HandPage::fillTools() {
    stations_.clear();
    if (!context_.live.connected()) return;
    const auto magazine = static_cast<std::int32_t>(
        params::get(context_.live.table(), params::pt_turret_magazine, context_.channel));
    const ToolPlaceTable& places = context_.live.places();
    for (std::size_t i = 0; magazine && i < places.count; ++i)
        if (places.places[i].magazine == magazine)
            stations_.push_back({places.places[i].pot, places.places[i].tool});
    if (stations_.empty())
        for (int n = 1;
             n <= static_cast<int>(params::get(context_.live.table(), params::pt_turret_stations,
                                               context_.channel));
             ++n)
            stations_.push_back({n, 0});
}

QString HandPage::toolBlock() const {
    const auto row = static_cast<std::size_t>(tools_->row());
    if (row >= stations_.size()) return {};
    const Station& one = stations_[row];
    const std::string language(
        params::get_text(context_.live.table(), params::pt_language, context_.channel));
    const ToolRow* tool = toolOf(context_.live, one.tool);
    const bool managed = params::bit(context_.live.table(), params::n2900_tool_m_config, 0);
    if (language == "sinumerik")
        return managed && tool && tool->name[0]
                   ? QString("T=\"%1\" D1").arg(toolName(*tool, one.tool))
                   : QString("T%1 D1").arg(one.number);
    if (language == "fagor")
        return QString("T%1 D1").arg(managed && tool && tool->type_number ? tool->type_number
                                                                          : one.number);
    if (managed && tool && tool->type_number)
        return QString("T%1%2")
            .arg(tool->type_number, 2, 10, QChar('0'))
            .arg(tool->h_cell % 100, 2, 10, QChar('0'));
    return QString("T%1%1").arg(one.number, 2, 10, QChar('0'));
}

// A key that is a start by its label: one block, at once, refused as a start is; in automatic
// operation the program is what starts.
void HandPage::start(unsigned channel, const QString& block) {
    const ChannelStatus& status = context_.live.channel(channel);
    if (static_cast<ChannelMode>(status.mode) == ChannelMode::Auto &&
        static_cast<ChannelState>(status.state) != ChannelState::Held)
        return context_.tell(word("L%1 is in automatic mode: choose Jog or MDI").arg(channel),
                             Told::Refused);
    context_.requests.press(QString("hand_key L%1 %2").arg(channel).arg(block));
}

void HandPage::callTool() {
    if (const QString block = toolBlock(); !block.isEmpty()) start(context_.channel, block);
}

// As fast as the last executed block had it, else slowly: every language has these words.
QString HandPage::spindleBlock() const {
    const unsigned spindle = context_.live.connected() ? spindleOf(context_.channel) : 0;
    if (!spindle) return {};
    if (std::abs(context_.live.status().spindles[spindle - 1].speed) > kStandsBelow) return "M5";
    const ChannelView& view = context_.live.view(context_.channel);
    const bool told =
        view.known && view.picture.spindle == spindle &&
        static_cast<SpindleModeCode>(view.picture.spindle_mode) == SpindleModeCode::Rpm &&
        view.picture.speed > 0;
    return QString("G97 S%1 M3").arg(told ? std::lround(view.picture.speed) : kHandSpeed);
}

// A chuck is that of the spindle which the channel has chosen: with another one chosen, M11 would
// let the wrong part go.
void HandPage::doStep() {
    const TransferStep* step = chosenStep();
    if (!step || step->code < 0) return;
    const auto named = static_cast<unsigned>(context_.live.nc(signals::cn_ssel(step->channel)));
    // as the machine takes it before a program has named one
    const unsigned chosen =
        named ? named : context_.live.config().channel(step->channel).default_spindle;
    if (step->spindle && chosen != step->spindle)
        return context_.tell(word("Plain S of L%1 means S%2 now: M%3 would act on its chuck.")
                                 .arg(step->channel)
                                 .arg(chosen)
                                 .arg(step->code),
                             Told::Refused);
    start(step->channel, QString("M%1").arg(step->code));
}

void HandPage::refresh() {
    fillTools();
    if (context_.live.connected() && generation_ != context_.live.generation()) {
        generation_ = context_.live.generation();
        transfer_ =
            transferSteps(context_.live.config(), context_.live.table(), context_.live.channels());
    }
    tools_->focused = focus_ == 1;
    steps_->focused = focus_ == 2;
    for (Sheet* one : sheets()) one->refresh();
}

void HandPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), left = static_cast<int>(width() * 0.38), right = px(400),
              state = px(72);
    if (upright(*this)) {
        const int below = height() / 2;
        handwheel_->setGeometry(edge, edge, width() / 2 - edge, below - 2 * edge);
        tools_->setGeometry(width() / 2 + edge, edge, width() / 2 - 2 * edge, below - 2 * edge);
        state_->setGeometry(edge, below, width() - 2 * edge, state);
        steps_->setGeometry(edge, below + state + edge, width() - 2 * edge,
                            height() - below - state - 2 * edge);
        return;
    }
    handwheel_->setGeometry(edge, edge, left, height() - 2 * edge);
    tools_->setGeometry(left + 2 * edge, edge, width() - left - right - 4 * edge,
                        height() - 2 * edge);
    state_->setGeometry(width() - right - edge, edge, right, state);
    steps_->setGeometry(width() - right - edge, state + 2 * edge, right,
                        height() - state - 3 * edge);
}

bool HandPage::key(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Tab:
            focus_ = (focus_ + 1) % 3;
            refresh();
            return true;
        case Qt::Key_Backtab:
            focus_ = (focus_ + 2) % 3;
            refresh();
            return true;
        case Qt::Key_Plus:
            turn(1);
            return true;
        case Qt::Key_Minus:
            turn(-1);
            return true;
        default:
            break;
    }
    if (focus_ == 1) return tools_->key(event);
    if (focus_ == 2) return steps_->key(event);
    const ChannelConfig& config = context_.live.config().channel(context_.channel);
    switch (event->key()) {
        case Qt::Key_Right:
            turn(1);
            return true;
        case Qt::Key_Left:
            turn(-1);
            return true;
        case Qt::Key_Up:
            place_ = place_ ? place_ - 1 : 0;
            refresh();
            return true;
        case Qt::Key_Down:
            place_ = std::min<unsigned>(
                place_ + 1, config.axis_count ? static_cast<unsigned>(config.axis_count) - 1 : 0);
            refresh();
            return true;
        default:
            return false;
    }
}

std::vector<SoftKey> HandPage::keys(std::function<void()> back) {
    const bool there = context_.live.connected();
    const ChannelStatus& status = context_.live.channel(context_.channel);
    const QString name = QString("L%1").arg(context_.channel);
    const auto press = [this](const QString& words) {
        return [this, words] { context_.requests.press(words); };
    };
    const bool superposes = (status.keys & kKeySuperpose) != 0;
    const QString block = there ? toolBlock() : QString(), turns = spindleBlock();
    const TransferStep* chosen = chosenStep();
    const bool step = there && chosen && chosen->code >= 0 && idle(chosen->channel);
    const QString what =
        chosen ? QString("L%1 M%2").arg(chosen->channel).arg(chosen->code) : QString();
    return {{word("Jog keys"), std::move(back), Sign::Left},
            holdKey(context_),
            {word("Handwheel"), press(QString("mode %1=handwheel").arg(name)), Sign::Manual, there,
             static_cast<ChannelMode>(status.mode) == ChannelMode::Handwheel},
            {word("Factor"),
             [this] {
                 factor_ = factor_ >= 100 ? 1 : factor_ * 10;
                 refresh();
             },
             Sign::None, there},
            {word("Handwheel offset"),
             press(QString("superpose %1=%2").arg(name, superposes ? "off" : "on")), Sign::None,
             there, superposes},
            {word("Reference"), press(QString("mode %1=reference").arg(name)), Sign::Offsets, there,
             static_cast<ChannelMode>(status.mode) == ChannelMode::Reference},
            {word("Call %1").arg(block),
             [this] { callTool(); },
             Sign::Tools,
             !block.isEmpty() && idle(context_.channel),
             false,
             false,
             word("The turret turns: press again"),
             {},
             name,
             name},
            {word("Do this step"),
             [this] { doStep(); },
             Sign::Run,
             there && step,
             false,
             false,
             word("It acts at once: press again"),
             {},
             what,
             what},
            {turns == "M5" ? word("Spindle stop") : word("Spindle %1").arg(turns.mid(4)),
             [this, channel = context_.channel, turns] { start(channel, turns); },
             Sign::Spindle,
             !turns.isEmpty() && idle(context_.channel),
             false,
             false,
             turns == "M5" ? QString() : word("The spindle turns: press again"),
             {},
             name,
             name},
            {word("Emergency stop"), press("emergency_stop"), Sign::Off, there, false, true}};
}

}  // namespace polyturn::hmi
