// Where numbers are entered: what is typed, what it comes to, and keys for a finger. Everything
// that a number field can calculate (text/calculate.hpp): 50/2, (3+1)*2, +0.05.
#pragma once
#include <optional>

#include "hmi/text/calculate.hpp"
#include "hmi/widgets/sheet.hpp"

class QKeyEvent;

namespace polyturn::hmi {

QString bitDigits(unsigned bits);  // #7 to #0, as parameter files and the command line have them

class NumberPad : public Sheet {
public:
    explicit NumberPad(QWidget* parent) : Sheet(parent) {}

    struct Field {
        QString title, unit;
        double present = 0;     // NaN: nothing stands there
        unsigned decimals = 3;  // 0: a whole number, and nothing else is taken
        // of a parameter: shown as the digits #7 to #0, and eight digits of 0 and 1 are read so
        bool bits = false;
        // of one `unit`, as it is held (25.4 of an inch): `present` and what comes out are held,
        // what is typed is not
        double size = 1;
        // false: a number by which something is called, a measured value, a pattern of bits:
        // nothing is added to it, and +5 is 5
        bool adds = true;
    };
    // What the number is for; empty: nothing is chosen.
    std::function<std::optional<Field>()> field;
    std::function<void(double)> onInput;  // the new value
    // What is to be added, where whoever keeps the value adds: what a program has written since it
    // was shown stays. Empty: onInput gets the sum.
    std::function<void(double)> onAdded;

    const QString& text() const { return text_; }
    void clear();
    bool key(QKeyEvent* event);      // characters of numbers, Enter, Backspace, Escape
    void type(const QString& text);  // as if typed
    // takes over; added: to what stands there, however it was typed
    void enter(bool added);
    std::optional<Entry> entry() const;  // what is typed, as the field reads it
    std::optional<double> held() const;  // its value as it is held, whatever stood there
    bool ready() const;                  // it can be taken over

protected:
    void compose(Writer& w) override;
    void touched(int number) override;

private:
    std::optional<double> result(const Field& now, bool added) const;  // nothing: it is not taken
    QString text_;
};

}  // namespace polyturn::hmi
