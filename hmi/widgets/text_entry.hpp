// One field of text with keys for a finger, over the foot of any screen: what a screen asks for
// (Desk::ask) is typed here, by touch or on a keyboard. Escape or «Close» leaves what was there.
#pragma once
#include <functional>

#include "hmi/widgets/text_pad.hpp"

class QKeyEvent;

namespace polyturn::hmi {

struct TextQuestion {
    QString title, text;
    std::function<void(const QString&)> changed = {};  // at each letter: a search
    std::function<void(const QString&)> done = {};     // Enter
    bool capitals = false;
    int most = 60;
};

class TextEntry : public QWidget {
public:
    explicit TextEntry(QWidget* parent);
    void open(TextQuestion question);
    void shut(bool take);
    bool key(QKeyEvent* event);
    void refresh() {
        line_->refresh();
        pad_->refresh();
    }
    const QString& text() const { return question_.text; }
    TextPad& pad() { return *pad_; }
    FreeSheet& line() { return *line_; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void changed();
    void write(const QString& text);  // where the caret stands
    void erase(qsizetype from);       // the letter there
    void move(qsizetype to);
    FreeSheet* line_;
    TextPad* pad_;
    TextQuestion question_;
    qsizetype caret_ = 0;  // letters before it
};

}  // namespace polyturn::hmi
