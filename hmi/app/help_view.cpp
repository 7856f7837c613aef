#include "hmi/app/help_view.hpp"

#include <QDir>
#include <QFile>
#include <QKeyEvent>
#include <QScrollBar>
#include <QScroller>
#include <QTextBlock>
#include <utility>

#include "ipc/text/machine_path.hpp"

namespace polyturn::hmi {

// Beside the machines in a build tree, below /usr/share/doc where it is installed.
QString HelpView::folder() {
    const QString share = QString::fromStdString(text::share_folder());
    for (const QString& one : {share + "/docs", QString("/usr/share/doc/polyturn")})
        if (QFile::exists(one + "/operator.md")) return one;
    return {};
}

HelpView::HelpView(QWidget* parent) : QWidget(parent), head_(new FreeSheet(this)), text_(new QTextBrowser(this)) {
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.bar);
        w.sign(QRectF(px(12), px(10), px(24), px(24)), Sign::Help, t.accent);
        w.text(QRectF(px(46), 0, head_->width() * 0.5, head_->height()), word("Handbook"), lettering(19, true), t.text);
        w.data(QRectF(head_->width() * 0.5, 0, head_->width() * 0.34, head_->height()), page_, lettering(14), t.dim, Qt::AlignRight | Qt::AlignVCenter);
        const QRectF box(head_->width() - px(126), px(6), px(118), head_->height() - px(12));
        w.fill(box, t.raised, px(6));
        w.text(box, word("Close"), lettering(15, true), t.text, Qt::AlignCenter);
        w.hit(box, 1);
    };
    head_->onTouched = [this](int) { hide(); };
    text_->setFrameShape(QFrame::NoFrame);
    text_->setFocusPolicy(Qt::NoFocus);            // keys come through the window
    text_->setOpenLinks(false);
    QObject::connect(text_, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
        const QString file = QFileInfo(url.path()).fileName();
        if (file.endsWith(".md")) intro_.clear(), load(file, {});
    });
    QScroller::grabGesture(text_->viewport(), QScroller::LeftMouseButtonGesture);
    hide();
}

void HelpView::load(const QString& file, const QString& find, bool code) {
    page_ = file;
    const QString where = folder();
    QFile source(where + "/" + file);
    QString markdown = intro_;
    if (!intro_.isEmpty()) markdown += "\n\n---\n\n";
    const auto lead = static_cast<int>(markdown.size());
    if (!where.isEmpty() && source.open(QIODevice::ReadOnly)) markdown += QString::fromUtf8(source.readAll());
    else markdown += word("The manual is not installed here.");
    const Theme& t = theme();
    QPalette colours = text_->palette();
    colours.setColor(QPalette::Base, t.card), colours.setColor(QPalette::Text, t.text), colours.setColor(QPalette::Link, t.accent);
    text_->setPalette(colours);
    text_->setFont(lettering(16));
    text_->setSearchPaths({where});
    // A document that is shown already lays a table out again for each of its rows: the list of codes would take a minute.
    auto* document = new QTextDocument(text_);
    document->setUndoRedoEnabled(false);
    document->setDefaultFont(lettering(16));
    document->setBaseUrl(QUrl::fromLocalFile(where + "/"));
    document->setDocumentMargin(px(18));
    document->setMarkdown(markdown);
    text_->setDocument(document);
    delete std::exchange(document_, document);
    text_->moveCursor(QTextCursor::Start);
    if (!find.isEmpty() && lead == 0 && text_->find(find, code ? QTextDocument::FindWholeWords | QTextDocument::FindCaseSensitively : QTextDocument::FindFlags())) {
        const QRect at = text_->cursorRect();      // the place on top
        text_->verticalScrollBar()->setValue(text_->verticalScrollBar()->value() + at.top() - px(12));
    }
    head_->refresh();
}

void HelpView::open(const HelpTopic& topic) {
    intro_ = topic.intro;
    load(topic.page.isEmpty() ? QString("operator.md") : topic.page, topic.find, topic.code);
    show();
    raise();
}

bool HelpView::key(QKeyEvent* event) {
    QScrollBar* bar = text_->verticalScrollBar();
    switch (event->key()) {
        case Qt::Key_Escape: hide(); return true;
        case Qt::Key_Up: bar->setValue(bar->value() - px(40)); return true;
        case Qt::Key_Down: bar->setValue(bar->value() + px(40)); return true;
        case Qt::Key_PageUp: bar->setValue(bar->value() - bar->pageStep()); return true;
        case Qt::Key_PageDown: bar->setValue(bar->value() + bar->pageStep()); return true;
        case Qt::Key_Home: bar->setValue(0); return true;
        case Qt::Key_End: bar->setValue(bar->maximum()); return true;
        case Qt::Key_Backspace: intro_.clear(), load("README.md", {}); return true;
        default: return false;
    }
}

void HelpView::resizeEvent(QResizeEvent*) {
    head_->setGeometry(0, 0, width(), px(44));
    text_->setGeometry(0, px(44), width(), height() - px(44));
}

}  // namespace polyturn::hmi
