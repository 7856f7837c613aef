#include "hmi/app/help_view.hpp"

#include <QDir>
#include <QFile>
#include <QKeyEvent>
#include <QScrollBar>
#include <QScroller>
#include <QTextBlock>
#include <QTextDocumentFragment>
#include <QTextList>
#include <QTextTable>
#include <utility>

#include "hmi/app/help_language.hpp"
#include "hmi/widgets/finger_bars.hpp"
#include "ipc/model/files/machine_path.hpp"

namespace polyturn::hmi {
namespace {
constexpr int kCloseHit = 1, kBackHit = 2;
constexpr int kFirstSlices = 2;  // laid out at once: what is seen first
// What Qt leaves free between two tables whose borders collapse, and the line that both draw: so
// far up goes the next piece of a table that was cut, so that one line stands between them, as
// between all rows. The test measures it.
constexpr double kBetweenTables = 4;

// Commands and programs: in the face of programs, set off from the text. Links: in the colour of
// the theme.
void setForms(QTextDocument& document) {
    const Theme& t = theme();
    const auto isCode = [](const QTextBlock& block) {
        return block.isValid() &&
               (block.blockFormat().hasProperty(QTextFormat::BlockCodeLanguage) ||
                block.blockFormat().hasProperty(QTextFormat::BlockCodeFence) ||
                block.blockFormat().nonBreakableLines());
    };
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const bool code = isCode(block);
        QTextCursor at(block);
        if (code) {
            QTextBlockFormat form = block.blockFormat();
            // a long command is broken, not cut
            form.setBackground(t.raised);
            form.setLeftMargin(px(16));
            form.setNonBreakableLines(false);
            form.setTopMargin(px(isCode(block.previous()) ? 0 : 4));
            form.setBottomMargin(px(isCode(block.next()) ? 0 : 10));
            at.setBlockFormat(form);
        }
        // what is found first, for setting it changes the pieces
        std::vector<std::pair<int, int>> runs, links;
        for (auto piece = block.begin(); !piece.atEnd(); ++piece)
            if (code || piece.fragment().charFormat().fontFixedPitch())
                runs.emplace_back(piece.fragment().position(), piece.fragment().length());
        for (auto piece = block.begin(); !piece.atEnd(); ++piece)
            if (piece.fragment().charFormat().isAnchor())
                links.emplace_back(piece.fragment().position(), piece.fragment().length());
        // Qt takes the colour of its own palette, dark on dark
        for (const auto& [from, length] : links) {
            at.setPosition(from);
            at.setPosition(from + length, QTextCursor::KeepAnchor);
            QTextCharFormat colour;
            colour.setForeground(t.accent);
            at.mergeCharFormat(colour);
        }
        for (const auto& [from, length] : runs) {
            at.setPosition(from);
            at.setPosition(from + length, QTextCursor::KeepAnchor);
            QTextCharFormat face;
            face.setFont(lettering(14.5, false, Face::Program),
                         QTextCharFormat::FontPropertiesSpecifiedOnly);
            face.setFontFamilies({lettering(14.5, false, Face::Program).family()});
            face.setFontFixedPitch(true);
            at.mergeCharFormat(face);
        }
    }
}

bool hasEmptyHead(QTextTable& table) {
    for (int column = 0; column < table.columns(); ++column) {
        const QTextTableCell cell = table.cellAt(0, column);
        QTextCursor at = cell.firstCursorPosition();
        at.setPosition(cell.lastPosition(), QTextCursor::KeepAnchor);
        if (!at.selectedText().simplified().remove(QChar::Nbsp).trimmed().isEmpty()) return false;
    }
    return true;
}
}  // namespace

// Beside the machines in a build tree, below /usr/share/doc where it is installed.
QString HelpView::folder() {
    const QString share = QString::fromStdString(text::share_folder());
    for (const QString& one : {share + "/docs", QString("/usr/share/doc/polyturn")})
        if (QFile::exists(one + "/operator.md")) return one;
    return {};
}

HelpView::HelpView(QWidget* parent)
    : QWidget(parent), head_(new FreeSheet(this)), text_(new QTextBrowser(this)) {
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.bar);
        w.sign(QRectF(px(12), px(10), px(24), px(24)), Sign::Help, t.accent);
        w.text(QRectF(px(46), 0, head_->width() * 0.5, head_->height()), word("Handbook"),
               lettering(19, true), t.text);
        w.data(QRectF(head_->width() * 0.5, 0, head_->width() * 0.5 - px(been_.empty() ? 140 : 270),
                      head_->height()),
               page_, lettering(14), t.dim, Qt::AlignRight | Qt::AlignVCenter);
        const QRectF box(head_->width() - px(126), px(6), px(118), head_->height() - px(12));
        w.fill(box, t.raised, px(6));
        w.text(box, word("Close"), lettering(15, true), t.text, Qt::AlignCenter);
        w.hit(box, kCloseHit);
        if (been_.empty()) return;
        const QRectF from(box.left() - px(126), px(6), px(118), head_->height() - px(12));
        w.fill(from, t.raised, px(6));
        w.sign(QRectF(from.left() + px(8), from.center().y() - px(9), px(18), px(18)), Sign::Left,
               t.accent);
        w.text(from.adjusted(px(28), 0, -px(4), 0), word("Back"), lettering(15, true), t.text,
               Qt::AlignCenter);
        w.hit(from, kBackHit);
    };
    head_->onTouched = [this](int number) {
        if (number == kBackHit)
            back();
        else
            hide();
    };
    text_->setFrameShape(QFrame::NoFrame);
    text_->setFocusPolicy(Qt::NoFocus);  // keys come through the window
    text_->setOpenLinks(false);
    // A table with long words is some pixels wider than the page: less than its margin hides
    // nothing, and needs no bar over the text.
    QObject::connect(
        text_->horizontalScrollBar(), &QScrollBar::rangeChanged, text_, [this](int, int most) {
            text_->setHorizontalScrollBarPolicy(most > px(18) ? Qt::ScrollBarAsNeeded
                                                              : Qt::ScrollBarAlwaysOff);
        });
    QObject::connect(text_, &QTextBrowser::anchorClicked, this,
                     [this](const QUrl& url) { follow(url.toString()); });
    QObject::connect(&turn_, &QTimer::timeout, this, [this] { layNext(); });
    QScroller::grabGesture(text_->viewport(), QScroller::LeftMouseButtonGesture);
    hide();
}

void HelpView::load(const QString& file, const QString& find, bool code) {
    page_ = file;
    const QString where = folder();
    QFile source(where + "/" + file);
    QString markdown;
    if (!where.isEmpty() && source.open(QIODevice::ReadOnly))
        markdown += QString::fromUtf8(source.readAll());
    else
        markdown += word("The manual is not installed here.");
    const Theme& t = theme();
    QPalette colours = text_->palette();
    colours.setColor(QPalette::Base, t.card);
    colours.setColor(QPalette::Text, t.text);
    colours.setColor(QPalette::Link, t.accent);
    colours.setColor(QPalette::Highlight, t.accent);
    colours.setColor(QPalette::HighlightedText, t.onAccent);
    text_->setPalette(colours);
    text_->setFont(lettering(16));
    setFingerBars(*text_);
    text_->setSearchPaths({where});
    slices_ = sliceHelp(markdown);
    int found = sliceWith(slices_, find, code);
    if (!intro_.isEmpty()) {  // what it is about, then the place in the manual
        found = splitAt(slices_, found, find);
        const auto lead = sliceHelp(intro_ + "\n\n---\n");
        slices_.insert(slices_.begin() + std::max(0, found), lead.begin(), lead.end());
    }
    begin(static_cast<std::size_t>(std::max(0, found)));
    if (found >= 0 && intro_.isEmpty() &&
        text_->find(find, code ? QTextDocument::FindWholeWords | QTextDocument::FindCaseSensitively
                               : QTextDocument::FindFlags())) {
        // The place on top, with the heading right above it: half a heading would be seen else.
        const QTextCursor at = text_->textCursor();
        const QTextTable* table = at.currentTable();
        const QTextBlock above = !table ? at.block().previous()
                                 : table->cellAt(at).row() <= 1
                                     ? text_->document()->findBlock(table->firstPosition() - 1)
                                     : QTextBlock();
        const bool headed = above.isValid() && above.blockFormat().headingLevel() > 0;
        const int top = text_->cursorRect(headed ? QTextCursor(above) : at).top();
        text_->verticalScrollBar()->setValue(text_->verticalScrollBar()->value() + top - px(12));
    }
    head_->refresh();
}

void HelpView::begin(std::size_t slice) {
    linked_ = false;
    scrollTo_ = -1;
    turn_.stop();
    painting_.forget();
    pictures_.clear();
    toEnd_ = false;
    auto* document = new QTextDocument(text_);
    document->setUndoRedoEnabled(false);
    document->setDefaultFont(lettering(16));
    document->setBaseUrl(QUrl::fromLocalFile(folder() + "/"));
    document->setDocumentMargin(px(18));
    text_->setDocument(document);
    delete std::exchange(document_, document);
    begin_ = end_ = std::min(slice, slices_.size());
    for (int i = 0; i < kFirstSlices && end_ < slices_.size() && pictureReady(end_); ++i)
        lay(end_, false);
    text_->moveCursor(QTextCursor::Start);
    if (!complete()) turn_.start(0);
}

// What is seen is filled first, then what is above it, then the rest.
void HelpView::layNext() {
    QScrollBar* bar = text_->verticalScrollBar();
    const bool filled = bar->maximum() - bar->value() > text_->height();
    const bool above = begin_ > 0 && (filled || end_ == slices_.size());
    const std::size_t next = above ? begin_ - 1 : end_;
    if (next < slices_.size() && !pictureReady(next)) return;
    if (next < slices_.size()) lay(next, above);
    if (!complete()) return;
    turn_.stop();
    if (toEnd_)
        bar->setValue(bar->maximum());
    else if (scrollTo_ >= 0 && bar->value() == 0)
        bar->setValue(scrollTo_);
    toEnd_ = false;
    scrollTo_ = -1;
}

// Reading one takes longer than a turn may: aside. Without a file there is nothing to wait for.
bool HelpView::pictureReady(std::size_t slice) {
    const QString& file = slices_[slice].picture;
    // under which the document looks; asked for it, it would read the file itself, at once and as
    // it is
    const QUrl url = document_->baseUrl().resolved(QUrl(file));
    if (file.isEmpty() || pictures_.count(file)) return true;
    if (auto image = painting_.take()) {
        document_->addResource(QTextDocument::ImageResource, url,
                               image->isNull() ? QImage(1, 1, QImage::Format_RGB32) : *image);
        pictures_.insert(file);
        return true;
    }
    if (!painting_.busy())
        painting_.start(
            [path = folder() + "/" + file,
             room = std::max(px(200), text_->width() - px(kFingerBar) - 2 * px(18) - px(8))](
                const std::atomic<bool>&) {
                const QImage image(path);
                return image.width() > room ? image.scaledToWidth(room, Qt::SmoothTransformation)
                                            : image;
            },
            0);
    return false;
}

void HelpView::lay(std::size_t slice, bool above) {
    const HelpSlice& own = slices_[slice];
    QTextDocument made;
    made.setUndoRedoEnabled(false);
    made.setDefaultFont(lettering(16));
    // «M98 <PROFILE>» is no tag that swallows what follows
    made.setMarkdown(own.markdown,
                     QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub) |
                         QTextDocument::MarkdownNoHTML);
    setForms(made);
    for (QTextFrame* frame : made.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table) continue;
        const bool headless = !own.goesOn && hasEmptyHead(*table);
        if ((own.goesOn || headless) && table->rows() > 1) table->removeRows(0, 1);
        QTextTableFormat format = table->format();
        format.setBorder(1);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(theme().edge);
        format.setBorderCollapse(true);
        format.setCellPadding(px(5));
        format.setTopMargin(own.goesOn ? -kBetweenTables : px(6));
        format.setBottomMargin(px(own.last ? 12 : 0));
        if (own.goesOn || headless) format.setHeaderRowCount(0);
        table->setFormat(format);
        if (own.shares.empty()) continue;
        QList<QTextLength> widths;
        for (int c = 0; c < table->columns(); ++c)
            widths << QTextLength(QTextLength::PercentageLength,
                                  c < static_cast<int>(own.shares.size())
                                      ? own.shares[static_cast<std::size_t>(c)]
                                      : 5);
        format.setColumnWidthConstraints(widths);
        format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
        table->setFormat(format);
    }
    QScrollBar* bar = text_->verticalScrollBar();
    const double before = document_->size().height();
    const int stood = bar->value();
    QTextCursor at(document_);
    at.beginEditBlock();
    // A paragraph of its own at the border of two slices; where a table is cut, the next piece
    // is right below.
    const bool cut = above ? slice + 1 < slices_.size() && slices_[slice + 1].goesOn : own.goesOn;
    if (!above) {
        at.movePosition(QTextCursor::End);
        if (!document_->isEmpty() && !cut) at.insertBlock(QTextBlockFormat(), QTextCharFormat());
    } else if (!document_->isEmpty() && !cut) {
        const QTextBlock first = document_->begin();
        // what stood first keeps its form, behind an empty paragraph
        at.insertBlock(first.blockFormat(), first.charFormat());
        at.movePosition(QTextCursor::Start);
        at.setBlockFormat(QTextBlockFormat());
    }
    const int begins = at.position();
    const QTextBlockFormat form = made.begin().blockFormat();
    at.insertFragment(QTextDocumentFragment(&made));
    // The first paragraph of what is inserted takes the form of where it goes to.
    const QTextBlock first = document_->findBlock(begins);
    if (const QTextList* list = made.begin().textList()) {
        if (QTextList* rest = first.next().textList(); !first.textList() && rest)
            rest->add(first);
        else if (!first.textList())
            QTextCursor(first).createList(list->format());
    } else if (made.begin().length() > 1) {
        QTextCursor(first).setBlockFormat(form);
    }
    at.endEditBlock();
    if (above) {
        --begin_;
        bar->setValue(stood + static_cast<int>(document_->size().height() - before));
    } else {
        ++end_;
    }
}

// The next link from the chosen one on; where none is chosen, or it has been scrolled out of sight,
// from the top of what is seen (or from its foot, backwards).
void HelpView::nextLink(int step) {
    struct Link {
        int from, to;
        QString href;
    };
    std::vector<Link> links;
    for (QTextBlock block = document_->begin(); block.isValid(); block = block.next())
        for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
            const QTextFragment one = piece.fragment();
            const QString href = one.charFormat().anchorHref();
            // what lies outside the handbook cannot be shown
            if (!QUrl(href).path().endsWith(".md")) continue;
            if (!links.empty() && links.back().href == href && links.back().to == one.position())
                links.back().to += one.length();
            else
                links.push_back({one.position(), one.position() + one.length(), href});
        }
    if (links.empty()) return;
    const QRect seen = text_->viewport()->rect();
    QTextCursor at(document_);
    at.setPosition(text_->textCursor().selectionStart());
    const bool chosen = linked_ && seen.intersects(text_->cursorRect(at));
    const int from =
        chosen
            ? at.position()
            : text_
                  ->cursorForPosition(step > 0 ? QPoint(0, 0) : QPoint(seen.right(), seen.bottom()))
                  .position();
    const Link* next = nullptr;
    for (const Link& one : links)
        if (step > 0 ? one.from > from || (!chosen && one.from == from) : one.from < from) {
            next = &one;
            if (step > 0) break;
        }
    if (!next) next = step > 0 ? &links.front() : &links.back();
    linked_ = true;
    at.setPosition(next->from);
    at.setPosition(next->to, QTextCursor::KeepAnchor);
    text_->setTextCursor(at);
    text_->ensureCursorVisible();
}

// Of the handbook only. Where it came from is kept, and what is below is not asked for again.
void HelpView::follow(const QString& link) {
    const QString file = QFileInfo(QUrl(link).path()).fileName();
    if (!file.endsWith(".md")) return;
    std::vector<Been> been = been_;  // another topic forgets them
    been.push_back({page_, intro_, text_->verticalScrollBar()->value()});
    open({file, {}, {}});
    been_ = std::move(been);
    head_->refresh();
}

// Where a link was followed from; else the list of the books.
void HelpView::back() {
    if (been_.empty()) return open({"README.md", {}, {}});
    const Been last = been_.back();
    been_.pop_back();
    intro_ = last.intro;
    load(last.page, {});
    if (complete())
        text_->verticalScrollBar()->setValue(last.scrolled);
    else
        scrollTo_ = last.scrolled;
}

void HelpView::open(const HelpTopic& topic) {
    been_.clear();
    intro_ = topic.intro;
    const HelpPlace place = placeInLanguage(
        folder(), {topic.page.isEmpty() ? QString("operator.md") : topic.page, topic.find},
        codeOf(spoken()));
    load(place.page, topic.code ? topic.find : place.find, topic.code);
    show();
    raise();
}

bool HelpView::key(QKeyEvent* event) {
    QScrollBar* bar = text_->verticalScrollBar();
    switch (event->key()) {
        case Qt::Key_Escape:
            hide();
            return true;
        case Qt::Key_Up:
            bar->setValue(bar->value() - px(40));
            return true;
        case Qt::Key_Down:
            bar->setValue(bar->value() + px(40));
            return true;
        case Qt::Key_PageUp:
            bar->setValue(bar->value() - bar->pageStep());
            return true;
        case Qt::Key_PageDown:
            bar->setValue(bar->value() + bar->pageStep());
            return true;
        case Qt::Key_Home:
            if (begin_ > 0) begin(0);
            bar->setValue(0);
            return true;
        case Qt::Key_End:
            bar->setValue(bar->maximum());
            toEnd_ = !complete();
            return true;
        case Qt::Key_Tab:
            nextLink(1);
            return true;
        case Qt::Key_Backtab:
            nextLink(-1);
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (!link().isEmpty()) follow(link());
            return true;
        case Qt::Key_Backspace:
            back();
            return true;
        default:
            return false;
    }
}

void HelpView::resizeEvent(QResizeEvent*) {
    head_->setGeometry(0, 0, width(), px(44));
    text_->setGeometry(0, px(44), width(), height() - px(44));
}

}  // namespace polyturn::hmi
