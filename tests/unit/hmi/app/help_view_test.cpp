// The handbook on the panel: paragraphs, commands and tables stand as the page has them, wherever
// it is opened.
#include "hmi/app/help_view.hpp"

#include <gtest/gtest.h>

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QFileInfo>
#include <QKeyEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextTable>
#include <set>

#include "tests/unit/hmi/controller.hpp"

namespace polyturn::hmi {
namespace {

// Lines between fences, and headings, of a page.
struct PageParts {
    std::multiset<QString> code, headings;
};
PageParts partsOf(const QString& page) {
    PageParts out;
    QFile file(HelpView::folder() + "/" + page);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << page.toStdString();
    bool fenced = false;
    for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) {
        if (line.startsWith("```"))
            fenced = !fenced;
        else if (fenced && !line.trimmed().isEmpty())
            out.code.insert(line.simplified());
        else if (!fenced && QRegularExpression("^#{1,6} ").match(line).hasMatch())
            out.headings.insert(QString(line)
                                    .remove(QRegularExpression("^#+ "))
                                    .remove('`')
                                    .remove('*')
                                    .simplified());
    }
    return out;
}

struct OpenPage {
    HelpView view{nullptr};
    explicit OpenPage(const HelpTopic& topic) {
        view.resize(1100, 700);
        view.show();
        view.open(topic);
        EXPECT_TRUE(waitFor([&] { return view.complete(); }));
    }
    QTextDocument& document() const { return *view.text().document(); }
};

// From the beginning, and from a place in the middle: what stands above is then laid before what is
// there.
TEST(HelpView, CommandsAndHeadingsStandByThemselves) {
    for (const HelpTopic& topic :
         {HelpTopic{"setup.md", {}, {}}, HelpTopic{"setup.md", "Panel computer", {}},
          HelpTopic{"setup.ru.md", "Компьютер", {}},
          HelpTopic{"builder.md", "Part transfer", {}}}) {
        SCOPED_TRACE((topic.page + " " + topic.find).toStdString());
        PageParts wanted = partsOf(topic.page);
        ASSERT_GT(wanted.code.size(), 20u);
        const OpenPage page(topic);
        for (QTextBlock block = page.document().begin(); block.isValid(); block = block.next()) {
            const QString text = block.text().simplified();
            if (const auto found = wanted.code.find(text); found != wanted.code.end()) {
                // the same words in the text
                if (block.begin().atEnd() ||
                    !block.begin().fragment().charFormat().fontFixedPitch())
                    continue;
                EXPECT_GT(block.blockFormat().leftMargin(), 0) << text.toStdString();
                wanted.code.erase(found);
            }
            if (const auto found = wanted.headings.find(text);
                found != wanted.headings.end() && block.blockFormat().headingLevel() > 0)
                wanted.headings.erase(found);
        }
        for (const QString& missing : wanted.code)
            ADD_FAILURE() << "not by itself: " << missing.toStdString();
        for (const QString& missing : wanted.headings)
            ADD_FAILURE() << "no heading: " << missing.toStdString();
    }
}

TEST(HelpView, TablesHaveNoEmptyHead) {
    const OpenPage page(
        {"operator.md", {}, "| | |\n| --- | --- |\n| Level | setter |\n| Unit | mm |\n"});
    int tables = 0;
    for (const QTextFrame* frame : page.document().rootFrame()->childFrames()) {
        const auto* table = qobject_cast<const QTextTable*>(frame);
        if (!table) continue;
        ++tables;
        QString head;
        for (int column = 0; column < table->columns(); ++column)
            head += table->cellAt(0, column).firstCursorPosition().block().text();
        EXPECT_FALSE(head.remove(QChar::Nbsp).trimmed().isEmpty());
    }
    EXPECT_GE(tables, 1);
}

// A long table is laid out in pieces: between them stands one line, as between all rows, opened at
// once or from the middle.
TEST(HelpView, PiecesOfATableStandAsCloseAsItsRows) {
    for (const HelpTopic& topic : {HelpTopic{"reference_fanuc.md", {}, {}},
                                   HelpTopic{"reference_fanuc.md", "G54", {}, true}}) {
        SCOPED_TRACE(topic.find.toStdString());
        const OpenPage page(topic);
        const auto* layout = page.document().documentLayout();
        const QTextTable* before = nullptr;
        int joints = 0;
        const auto rowTop = [&](const QTextTable& table, int row) {
            return layout->blockBoundingRect(table.cellAt(row, 0).firstCursorPosition().block())
                .top();
        };
        const auto lowest = [&](const QTextTable& table, int row) {
            double out = 0;
            for (int column = 0; column < table.columns(); ++column)
                out = std::max(out, layout
                                        ->blockBoundingRect(
                                            table.cellAt(row, column).lastCursorPosition().block())
                                        .bottom());
            return out;
        };
        for (const QTextFrame* frame : page.document().rootFrame()->childFrames()) {
            const auto* table = qobject_cast<const QTextTable*>(frame);
            if (!table) continue;
            if (before && table->format().headerRowCount() == 0 &&
                table->columns() == before->columns() && before->rows() > 1 && table->rows() > 1) {
                const double within = rowTop(*table, 1) - lowest(*table, 0),
                             between = rowTop(*table, 0) - lowest(*before, before->rows() - 1);
                EXPECT_NEAR(between, within, 0.5)
                    << table->cellAt(0, 0).firstCursorPosition().block().text().toStdString();
                ++joints;
            }
            before = table;
        }
        EXPECT_GT(joints, 5);
    }
}

// By keys alone: Tab goes from link to link, Enter opens what it leads to, Backspace goes back to
// where it was.
TEST(HelpView, LinksAreFollowedByKeys) {
    OpenPage page({"README.md", {}, {}});
    HelpView& view = page.view;
    const auto press = [&](int key) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
        EXPECT_TRUE(view.key(&event));
        EXPECT_TRUE(waitFor([&] { return view.complete(); }));
    };
    EXPECT_TRUE(view.link().isEmpty());
    QStringList seen;
    for (int i = 0; i < 4; ++i) {
        press(Qt::Key_Tab);
        seen << view.link();
    }
    EXPECT_EQ(QSet<QString>(seen.begin(), seen.end()).size(), 4) << seen.join(' ').toStdString();
    press(Qt::Key_Backtab);
    EXPECT_EQ(view.link(), seen[2]);
    for (const QString& one : seen) EXPECT_TRUE(one.endsWith(".md")) << one.toStdString();
    EXPECT_TRUE(view.text().viewport()->rect().contains(view.text().cursorRect()));
    const QString from = view.page(), to = QFileInfo(seen[2]).fileName();
    press(Qt::Key_Return);
    EXPECT_EQ(view.page(), to);
    EXPECT_TRUE(view.link().isEmpty());
    press(Qt::Key_Down);
    press(Qt::Key_Backspace);
    EXPECT_EQ(view.page(), from);
    view.open({"operator.md", {}, {}});
    press(Qt::Key_Backspace);
    EXPECT_EQ(view.page(), from) << "the list of the books";
}

TEST(HelpView, LinksAreReadInBothThemes) {
    for (const bool dark : {true, false}) {
        dress(dark);
        const OpenPage page({"programmer.md", {}, {}});
        int links = 0;
        for (QTextBlock block = page.document().begin(); block.isValid(); block = block.next())
            for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
                if (!piece.fragment().charFormat().isAnchor()) continue;
                ++links;
                EXPECT_EQ(piece.fragment().charFormat().foreground().color(), theme().accent)
                    << piece.fragment().text().toStdString();
            }
        EXPECT_GE(links, 3);
    }
    dress(true);
}

TEST(HelpView, IsScrolledByAFinger) {
    const OpenPage page({"setup.md", {}, {}});
    EXPECT_GE(page.view.text().verticalScrollBar()->width(), px(28));
    const OpenPage pictures({"operator.md", {}, {}});
    std::string wide;
    for (QTextBlock block = pictures.document().begin(); block.isValid(); block = block.next())
        for (int line = 0; line < block.layout()->lineCount(); ++line)
            if (const double width = block.layout()->lineAt(line).naturalTextWidth();
                width > pictures.view.text().viewport()->width())
                wide += std::to_string(width) + " of " +
                        std::to_string(pictures.view.text().viewport()->width()) + ": " +
                        block.text().left(60).toStdString() + "\n";
    EXPECT_EQ(pictures.view.text().horizontalScrollBar()->maximum(), 0)
        << "nothing is wider than the page beside the bar\n"
        << wide;
}

// Columns share the page so that no word of theirs is broken.
TEST(HelpView, TablesGiveEveryColumnItsLongestWord) {
    for (const char* name : {"reference_fanuc.md", "reference_fanuc.ru.md", "reference_fagor.cs.md",
                             "reference_sinumerik.hu.md"}) {
        SCOPED_TRACE(name);
        QFile file(HelpView::folder() + "/" + name);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const QFontMetricsF letters(lettering(16));
        const double page = px(1060) - 2 * px(18);
        for (const HelpSlice& slice : sliceHelp(QString::fromUtf8(file.readAll())))
            for (const QString& row :
                 slice.shares.empty() ? QStringList() : slice.markdown.split('\n')) {
                const QStringList cells = row.mid(1).split('|');
                for (qsizetype c = 0;
                     c < cells.size() && c < static_cast<qsizetype>(slice.shares.size()); ++c)
                    for (const QString& word :
                         QString(cells[c]).remove('*').remove('\\').split(' ', Qt::SkipEmptyParts))
                        EXPECT_TRUE(word.contains("---") ||
                                    letters.horizontalAdvance(word) + 2 * px(5) <=
                                        page * slice.shares[static_cast<std::size_t>(c)] / 100)
                            << word.toStdString();
            }
    }
}

}  // namespace
}  // namespace polyturn::hmi
