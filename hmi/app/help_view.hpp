// The manual's page for what is shown or chosen: opened by the help key over the screen, closed by
// it again or by Escape. The page scrolls to the place that is meant; the explanation of the very
// field, code or alarm comes before it. What is seen first is laid out at once, the rest of the
// page in the turns that follow: below it, then above it, while the place stays where it is.
#pragma once
#include <QImage>
#include <QTextBrowser>
#include <QTimer>
#include <set>

#include "hmi/app/help_slices.hpp"
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/aside.hpp"

namespace polyturn::hmi {

class HelpView : public QWidget {
public:
    explicit HelpView(QWidget* parent);
    void open(const HelpTopic& topic);
    bool key(QKeyEvent* event);
    const QTextBrowser& text() const { return *text_; }
    Sheet* head() { return head_; }
    // that the keys have chosen
    QString link() const {
        return linked_ ? text_->textCursor().charFormat().anchorHref() : QString();
    }
    const QString& page() const { return page_; }
    // all of the page is there
    bool complete() const { return begin_ == 0 && end_ == slices_.size(); }
    static QString folder();  // of the manual; empty: it is not installed

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void load(const QString& file, const QString& find, bool code = false);
    // into the document, at its end or at its beginning
    void lay(std::size_t slice, bool above);
    void layNext();
    bool pictureReady(std::size_t slice);  // or there is none in it
    void begin(std::size_t slice);         // the page anew, from there on
    void nextLink(int step);
    void follow(const QString& link);
    void back();
    struct Been {  // where a link was followed from
        QString page, intro;
        int scrolled = 0;
    };
    std::vector<Been> been_;
    // the cursor's selection is a link that the keys have chosen
    bool linked_ = false;
    // as soon as all of the page is there; -1: nowhere
    int scrollTo_ = -1;
    FreeSheet* head_;
    QTextBrowser* text_;
    QTextDocument* document_ = nullptr;  // what text_ shows
    QString page_, intro_;
    std::vector<HelpSlice> slices_;
    std::size_t begin_ = 0, end_ = 0;  // of the slices that are laid out
    // the end of the page has been asked for, and is still to come
    bool toEnd_ = false;
    QTimer turn_;
    Aside<QImage> painting_;      // a picture that is read from its file
    std::set<QString> pictures_;  // that the document has
};

}  // namespace polyturn::hmi
