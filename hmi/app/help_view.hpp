// The manual's page for what is shown or chosen: opened by the help key over the screen, closed by it again or by Escape. The page scrolls to
// the place that is meant; what can be told of the very field, code or alarm stands before it.
#pragma once
#include <QTextBrowser>

#include "hmi/app/screen.hpp"

namespace polyturn::hmi {

class HelpView : public QWidget {
public:
    explicit HelpView(QWidget* parent);
    void open(const HelpTopic& topic);
    bool key(QKeyEvent* event);
    const QTextBrowser& text() const { return *text_; }
    Sheet* head() { return head_; }
    static QString folder();                       // of the manual; empty: it is not installed

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void load(const QString& file, const QString& find, bool code = false);
    FreeSheet* head_;
    QTextBrowser* text_;
    QTextDocument* document_ = nullptr;            // what text_ shows
    QString page_, intro_;
};

}  // namespace polyturn::hmi
