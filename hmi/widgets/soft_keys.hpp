// The row of keys at the foot of each screen: F1 to F10, or a touch. A key that can cost something
// wants a second press.
#pragma once
#include <QElapsedTimer>
#include <QTimer>

#include "hmi/widgets/screen.hpp"

namespace polyturn::hmi {

class SoftKeyBar : public Sheet {
public:
    static constexpr int kKeys = 10;
    static constexpr int kReadMs = 500;  // the least time between a question and its answer
    explicit SoftKeyBar(QWidget* parent);
    // where a key stands in a bar of that size; portrait: two rows
    static QRectF place(int key, const QSizeF& bar, bool upright);
    void show(std::vector<SoftKey> keys);
    void press(int key);  // from 0
    void letGo(int key);
    // other keys have come by themselves: a finger that was on its way meant those before
    void rest(int ms) {
        restMs_ = ms;
        resting_.start();
    }
    const std::vector<SoftKey>& keys() const { return keys_; }
    int asked() const { return asked_; }  // the key that asks; -1 none
    int waits() const;                    // ms until the second press of the key that asks counts

protected:
    void compose(Writer& w) override;
    void touched(int number) override { press(number); }
    void released(int number) override { letGo(number); }

private:
    std::vector<SoftKey> keys_;
    int asked_ = -1;  // waits for its second press
    QElapsedTimer askedSince_;
    int down_ = -1;
    QElapsedTimer resting_;
    int restMs_ = 0;
    QTimer forget_;
};

}  // namespace polyturn::hmi
