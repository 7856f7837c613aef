// Keys for a finger where a text is entered: letters, digits, signs. What is typed goes to whoever
// owns the text, as if from a keyboard.
#pragma once
#include <array>

#include "hmi/widgets/sheet.hpp"

namespace polyturn::hmi {

class TextPad : public Sheet {
public:
    explicit TextPad(QWidget* parent) : Sheet(parent) {}
    std::function<void(const QString&)> onText;
    std::function<void()> onBackspace, onEnter;
    QString enterText;                // of the Enter key; empty: «Enter»
    std::function<void(int)> onMove;  // by so many letters; empty: one writes at the end
    bool capitals = false;            // only capital letters: programs
    // has the letters of the language of the screens, and a key that changes to Latin ones
    bool national = false;
    bool latin = true;  // those are there now
    // numbers for a touch
    static constexpr int kShift = 1000, kLetters = 1004, kLeft = 1005, kRight = 1006;
    int hitOf(QChar key) const;  // for tests; -1: no such key now

protected:
    void compose(Writer& w) override;
    void touched(int number) override;

private:
    static QChar shifted(QChar key);
    const std::array<QString, 4>& rows() const;
    bool shift_ = false;
};

}  // namespace polyturn::hmi
