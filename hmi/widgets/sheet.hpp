// A widget that is written anew at each frame and painted only where something has changed. A
// screen composes items (texts, areas, signs, bars) in the same order each time; an item that
// differs from the one before at its place is painted again, nothing else.
//
// A text that does not fit its box is shortened with an ellipsis and remembered: fixed words that
// do not fit are a fault of ours, which tests/unit/hmi finds in every language; data (names of
// files, programs) may be longer than any box.
#pragma once
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "hmi/widgets/theme.hpp"

namespace polyturn::hmi {

inline const QFont kPlainFont;  // copied: making one asks the application for its own each time

struct Item {
    enum class Kind : std::uint8_t { Text, Fill, Frame, Sign, Bar, Line, Hatch } kind = Kind::Text;
    QRectF box;
    QString text;
    QFont font = kPlainFont;
    QColor colour, second;
    int align = Qt::AlignLeft | Qt::AlignVCenter;
    // Bar: part that is full; Fill, Frame: radius of the corners; Line: width
    double value = 0.0;
    Sign sign = Sign::None;
    bool data = false;   // Text: may be shortened
    bool wraps = false;  // Text: on several lines
    bool operator==(const Item& other) const;
};

class Sheet;

// Where somebody enters a text: each can be touched, and Ctrl+F goes from one to the next
// (tests/unit/hmi/app/entry_test.cpp walks them all).
struct TextField {
    QRectF box;
    int hit = 0;   // touch it and letters go there
    QString text;  // what stands in it
};

// What a screen writes with.
class Writer {
public:
    Writer(std::vector<Item>& items, std::vector<std::pair<QRectF, int>>& hits,
           std::vector<TextField>& fields)
        : items_(&items), hits_(&hits), fields_(&fields) {}
    Item& text(const QRectF& box, const QString& text, const QFont& font, const QColor& colour,
               int align = Qt::AlignLeft | Qt::AlignVCenter);
    // A name from outside: may be shortened.
    Item& data(const QRectF& box, const QString& text, const QFont& font, const QColor& colour,
               int align = Qt::AlignLeft | Qt::AlignVCenter);
    void fill(const QRectF& box, const QColor& colour, double radius = 0);
    void frame(const QRectF& box, const QColor& colour, double radius = 0, double width = 1);
    void hatch(const QRectF& box, const QColor& colour);  // slanting lines in a frame
    void line(const QPointF& from, const QPointF& to, const QColor& colour, double width = 1);
    void sign(const QRectF& box, Sign sign, const QColor& colour);
    void bar(const QRectF& box, double part, const QColor& colour, const QColor& behind);
    // A field of text: what is in it, or else what it is for; `here`: letters go there now. hit 0:
    // it cannot be touched.
    // caret: letters before it; -1: at the end
    void field(const QRectF& box, const QString& text, const QString& purpose, bool here, int hit,
               Face face = Face::Text, qsizetype caret = -1);
    // A touch in this box is reported with this number; what is written later lies on top.
    void hit(const QRectF& box, int number) { hits_->emplace_back(box, number); }

private:
    Item& add(Item::Kind kind, const QRectF& box);
    std::vector<Item>* items_;
    std::vector<std::pair<QRectF, int>>* hits_;
    std::vector<TextField>* fields_;
};

class Sheet : public QWidget {
public:
    explicit Sheet(QWidget* parent = nullptr);
    void refresh();  // composes, and repaints what has changed
    const std::vector<Item>& items() const { return items_; }  // for tests: what is written
    std::vector<QString> shortened() const;                    // fixed words that do not fit
    // names, numbers, cells of tables that do not fit: among them may be words of ours
    std::vector<QString> shortenedData() const;
    // that are no data: they stand in the language of the screens
    std::vector<QString> fixedWords() const;
    // words that are written over others, or beyond the sheet
    std::vector<QString> overlapping() const;
    // Where a number of hit() lies, for tests; empty: nowhere.
    QRectF boxOf(int number) const;
    const std::vector<TextField>& fields() const { return fields_; }
    void touch(int number) { touched(number); }  // as if by a finger
    // the finger that is down is forgotten: what it holds ends, what its release would do is not
    // done
    virtual void forgetTouch();

protected:
    virtual void compose(Writer& w) = 0;
    virtual void touched(int /*number*/) {}
    virtual void released(int /*number*/) {}
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;

private:
    std::vector<Item> items_, next_;
    std::vector<std::pair<QRectF, int>> hits_;
    std::vector<TextField> fields_;
    int pressed_ = -1;
};

// The Sheet of a function: for parts of a screen that are no class of their own.
class FreeSheet : public Sheet {
public:
    using Sheet::Sheet;
    std::function<void(Writer&)> onCompose;
    std::function<void(int)> onTouched, onReleased;
    // by so many pixels towards the end: a finger that drags, the wheel
    std::function<void(double)> onScroll;
    void forgetTouch() override;

protected:
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void compose(Writer& w) override {
        if (onCompose) onCompose(w);
    }
    void touched(int number) override {
        if (onTouched) onTouched(number);
    }
    void released(int number) override {
        if (onReleased) onReleased(number);
    }

private:
    std::optional<double> finger_;  // where it was last, while it is down
};

}  // namespace polyturn::hmi
