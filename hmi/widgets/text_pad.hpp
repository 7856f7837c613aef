// Keys for a finger where a text is entered: letters, digits, signs. What is typed goes to whoever owns the text, as if from a keyboard.
#pragma once
#include "hmi/widgets/sheet.hpp"

namespace polyturn::hmi {

class TextPad : public Sheet {
public:
    explicit TextPad(QWidget* parent) : Sheet(parent) {}
    std::function<void(const QString&)> onText;
    std::function<void()> onBackspace, onEnter;
    QString enterText;             // of the Enter key; empty: «Enter»
    bool capitals = false;         // only capital letters: programs
    static constexpr int kShift = 1000;   // its number for a touch
    int hitOf(QChar key) const;    // for tests; -1: no such key now

protected:
    void compose(Writer& w) override;
    void touched(int number) override;

private:
    static QChar shifted(QChar key);
    bool shift_ = false;
};

}  // namespace polyturn::hmi
