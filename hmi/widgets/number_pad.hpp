// Where numbers are entered: what is typed, what it comes to, and keys for a finger. Everything that a number field can calculate
// (text/calculate.hpp): 50/2, (3+1)*2, +0.05.
#pragma once
#include <optional>

#include "hmi/text/calculate.hpp"
#include "hmi/widgets/sheet.hpp"

class QKeyEvent;

namespace polyturn::hmi {

class NumberPad : public Sheet {
public:
    explicit NumberPad(QWidget* parent) : Sheet(parent) {}

    struct Field {
        QString title, unit;
        double present = 0;       // NaN: nothing stands there
        unsigned decimals = 3;
    };
    // What the number is for; empty: nothing is chosen.
    std::function<std::optional<Field>()> field;
    std::function<void(double)> onInput;      // the new value

    const QString& text() const { return text_; }
    void clear();
    bool key(QKeyEvent* event);               // characters of numbers, Enter, Backspace, Escape
    void type(const QString& text);           // as if typed
    void enter(bool added);                   // takes over; added: to what stands there, however it was typed
    std::optional<Entry> entry() const { return calculate(text_.toStdString()); }

protected:
    void compose(Writer& w) override;
    void touched(int number) override;

private:
    QString text_;
};

}  // namespace polyturn::hmi
