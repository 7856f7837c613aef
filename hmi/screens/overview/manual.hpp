// Moving by hand: jog keys that move as long as they are held, steps, reference points, leaving a
// hold and coming back, blocks by hand (MDI), overrides, machine on.
#pragma once
#include <QElapsedTimer>

#include "hmi/widgets/screen.hpp"
#include "hmi/screens/overview/hand_page.hpp"
#include "hmi/widgets/text_pad.hpp"

namespace polyturn::hmi {

class Manual : public Screen {
public:
    explicit Manual(Context& context);
    ~Manual() override { letGo(); }
    QString title() const override { return word("Manual"); }
    Sign sign() const override { return Sign::Manual; }
    const char* name() const override { return "manual"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void follow() override;
    bool key(QKeyEvent* event) override;
    bool keyReleased(QKeyEvent* event) override;
    void letGo() override;
    bool typing() const override { return typing_; }
    // the typed block too: it moves nothing
    QString state() const override {
        return QString("%1 %2 ").arg(step_).arg(handShown_ ? 1 : 0) + mdi_;
    }
    void restore(const QString& state) override;
    std::vector<Sheet*> sheets() override;
    int pages() const override { return 3; }  // the handwheel and the tool, a block that is typed
    HelpTopic help() const override {
        return handShown_ ? HelpTopic{"builder.md", "A part from one spindle to the other", {}}
                          : HelpTopic{"operator.md", "Manual:", {}};
    }
    void turnTo(int page) override;
    void showHand(bool on);
    HandPage& hand() { return *hand_; }
    TextPad& pad() { return *pad_; }
    FreeSheet& axes() { return *axes_; }
    FreeSheet& side() { return *side_; }
    // Numbers of touches: axis (from 1) * 10, + 1 for the positive, + 2 for the negative key, + 3
    // for its reference point.
    static int jogHit(unsigned axis, bool positive) {
        return static_cast<int>(axis) * 10 + (positive ? 1 : 2);
    }
    static constexpr int kStepHits = 2000, kMdiHit = 2100, kMdiClearHit = 2101,
                         kOverrideHits = 2200, kChannelHits = 2300;
    void typeMdi(const QString& text) {
        mdi_ = text;
        refresh();
    }
    void enterMdi();  // into the list; nothing moves before a start

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void layOut();
    void composeAxes(Writer& w);
    void composePlaces(Writer& w, const QRectF& box);
    void composeSide(Writer& w);
    void press(int number);
    void tellHeld();
    const char* stepText(std::size_t step) const;  // in the unit of the channel
    bool stops() const;                            // what the last soft key does
    void stopsSince();
    void mode(const char* wanted);
    QString whyNotMoved() const;
    unsigned chosenAxis() const;  // 0: none

    FreeSheet *axes_, *side_;
    HandPage* hand_;
    TextPad* pad_;  // for a finger, while a block is entered
    bool handShown_ = false;
    QTimer held_;  // reports to the kernel that the key is still held
    QString heldWords_;
    int step_ = 0;  // 0: jog as long as the key is held; otherwise into kSteps
    bool typing_ = false;
    unsigned place_ = 0;  // of the axis that keys move
    int override_ = 0;    // feed, rapid, spindle: the one that keys change
    // the card of blocks by hand; where it ends
    double composeMdi(Writer& w, double top, double most);
    QString mdi_;               // that is being typed
    QElapsedTimer stopsSince_;  // since the machine was seen on, or its stop was pressed
};

}  // namespace polyturn::hmi
