// The panel while it is wiped: touches and keys do nothing for a while. The bar above goes on
// telling what the machine does, an alarm that comes ends it, and three keys act when a finger
// rests on them: hold of all programs, emergency stop, unlock. A cloth passes over them.
#pragma once
#include <QElapsedTimer>
#include <QKeyEvent>

#include "hmi/widgets/screen.hpp"

namespace polyturn::hmi {

class CleaningLock : public Sheet {
public:
    static constexpr int kLockMs = 30'000;
    static constexpr int kRestMs = 400;  // how long a finger must rest on a key
    // places in the row of soft keys, from 0: hold has its own one
    enum Key : int { kHoldAll = 1, kUnlock = 5, kEmergencyStop = 9 };
    enum class End : std::uint8_t { Unlocked, Alarm };
    CleaningLock(Context& context, QWidget* parent);
    std::function<void(End)> onEnd;
    void begin();
    void follow();  // each frame: time, the finger that rests, the machine
    void keyPressed(const QKeyEvent& event);
    void keyReleased(const QKeyEvent& event);
    void forgetTouch() override {
        down_ = -1;
        Sheet::forgetTouch();
    }
    // where the soft keys are, in coordinates of this sheet
    void keysAt(const QRectF& foot) {
        foot_ = foot;
        refresh();
    }

protected:
    void compose(Writer& w) override;
    void touched(int key) override { press(key); }
    void released(int) override {
        down_ = -1;
        refresh();
    }
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    void press(int key);
    bool alarmHasCome() const;
    bool stopped() const;  // the machine, by an emergency stop or its own
    Context& context_;
    QRectF foot_;
    QElapsedTimer since_, downSince_;
    qint64 begun_ms_ = 0;  // by the clock of AlarmEntry::heard_ms
    bool stoppedBefore_ = false;
    int down_ = -1;  // the key on which a finger rests
};

}  // namespace polyturn::hmi
