#include "hmi/app/cleaning_lock.hpp"

#include <QMouseEvent>
#include <algorithm>
#include <chrono>

#include "hmi/widgets/portrait.hpp"
#include "hmi/widgets/set_words.hpp"
#include "hmi/widgets/soft_keys.hpp"
#include "ipc/model/machine/machine_step.hpp"

namespace polyturn::hmi {
namespace {

qint64 nowMs() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

CleaningLock::CleaningLock(Context& context, QWidget* parent) : Sheet(parent), context_(context) {
    hide();
}

void CleaningLock::begin() {
    since_.start();
    begun_ms_ = nowMs();
    stoppedBefore_ = stopped();
    down_ = -1;
    show();
    raise();
    refresh();
}

bool CleaningLock::stopped() const {
    const auto step = static_cast<MachineStep>(context_.live.status().step);
    return context_.live.connected() &&
           (step == MachineStep::EmergencyStop || step == MachineStep::Stopped);
}

// One that stood before the cleaning was begun is known; of a key that was refused nothing has
// come.
bool CleaningLock::alarmHasCome() const {
    if (!context_.live.connected()) return false;
    const auto& all = context_.alarms.all();
    return (stopped() && !stoppedBefore_) ||
           std::any_of(all.begin(), all.end(), [&](const AlarmEntry& one) {
               return one.standing && one.severity == Severity::Error && !one.refusal &&
                      one.heard_ms >= begun_ms_;
           });
}

void CleaningLock::follow() {
    if (!stopped()) stoppedBefore_ = false;
    if (down_ >= 0 && downSince_.elapsed() >= kRestMs) {
        switch (std::exchange(down_, -1)) {
            case kHoldAll:
                context_.requests.press("feed_hold");
                break;
            case kEmergencyStop:
                context_.requests.press("emergency_stop");
                break;
            default:
                return onEnd(End::Unlocked);
        }
    }
    if (alarmHasCome()) return onEnd(End::Alarm);
    if (since_.elapsed() > kLockMs) return onEnd(End::Unlocked);
    refresh();
}

void CleaningLock::press(int key) {
    down_ = key;
    downSince_.start();
    refresh();
}

void CleaningLock::keyPressed(const QKeyEvent& event) {
    const int key = event.key() - Qt::Key_F1;
    if (!event.isAutoRepeat() && (key == kHoldAll || key == kUnlock || key == kEmergencyStop))
        press(key);
}

void CleaningLock::keyReleased(const QKeyEvent& event) {
    if (!event.isAutoRepeat() && event.key() - Qt::Key_F1 == down_) released(down_);
}

// A cloth that is drawn over a key does not rest there.
void CleaningLock::mouseMoveEvent(QMouseEvent* event) {
    if (down_ >= 0 && !boxOf(down_).contains(event->position())) {
        forgetTouch();
        refresh();
    }
}

void CleaningLock::compose(Writer& w) {
    const Theme& t = theme();
    const double middle = foot_.top() / 2, wide = width(), margin = px(24);
    w.fill(QRectF(0, 0, wide, height()), t.window);
    w.sign(QRectF(wide / 2 - px(40), middle - px(150), px(80), px(80)), Sign::Lock, t.accent);
    w.text(QRectF(0, middle - px(50), wide, px(50)), word("Locked for cleaning"),
           lettering(30, true), t.text, Qt::AlignCenter);
    const auto seconds =
        std::max<qint64>(0, kLockMs - (since_.isValid() ? since_.elapsed() : 0)) / 1000 + 1;
    for (const auto& [text, top] :
         {std::pair{
              word("Touches and keys do nothing. Unlocks by itself in %1 s, at once when an alarm "
                   "comes.")
                  .arg(seconds),
              px(8)},
          {word("The keys below act when they are kept pressed."), px(64)}}) {
        Item& line = w.text(QRectF(margin, middle + top, wide - 2 * margin, px(52)), text,
                            lettering(18), t.dim, Qt::AlignCenter);
        line.wraps = true;
    }
    const bool there = context_.live.connected();
    struct Offered {
        int key;
        QString text;
        Sign sign;
        bool enabled;
    };
    for (const Offered& one : {Offered{kHoldAll, word("Hold all"), Sign::Hold, there},
                               {kUnlock, word("Unlock"), Sign::Lock, true},
                               {kEmergencyStop, word("Emergency stop"), Sign::Off, there}}) {
        const QRectF box =
            SoftKeyBar::place(one.key, foot_.size(), upright(*this)).translated(foot_.topLeft());
        const bool down = down_ == one.key;
        const QColor ink = !one.enabled ? t.faint : down ? t.onAccent : t.text;
        w.fill(box, down ? t.accent : t.card, px(7));
        w.frame(box, t.edge, px(7), 1);
        w.text(QRectF(box.right() - px(30), box.top() + px(3), px(25), px(15)),
               QString("F%1").arg(one.key + 1), lettering(11), down ? ink : t.dim,
               Qt::AlignRight | Qt::AlignVCenter);
        w.sign(QRectF(box.left() + px(6), box.top() + px(5), px(16), px(16)), one.sign,
               down                        ? ink
               : one.key == kEmergencyStop ? t.bad
                                           : t.accent);
        const QRectF room(box.left() + px(6), box.top() + px(19), box.width() - px(12),
                          box.height() - px(24));
        w.text(room, one.text,
               letteringThatFits(one.text, room.size(), 14.5, 11.5, Face::Condensed), ink,
               Qt::AlignCenter)
            .wraps = true;
        if (one.enabled) w.hit(box, one.key);
    }
}

}  // namespace polyturn::hmi
