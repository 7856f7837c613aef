// The handbook in the languages of the screens: page for page, heading for heading, table for table
// and command for command the English one, and every place that the help key asks for is found in
// each of them. Reads files only.
#include <gtest/gtest.h>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <set>

#include "hmi/app/help_language.hpp"
#include "hmi/app/help_slices.hpp"
#include "tests/places.hpp"
#include "tests/unit/hmi/source_lines.hpp"

namespace polyturn::hmi {
namespace {

constexpr const char* kHandbookLanguages[] = {"ru", "cs", "hu"};
constexpr const char* kHandbookPages[] = {"README.md",     "operator.md", "setup.md",
                                          "programmer.md", "builder.md",  "shop.md"};

QString handbookFolder() { return QString(kSourceFolder) + "/docs"; }

QString handbookText(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return QString::fromUtf8(file.readAll());
}

QString pageIn(const QString& english, const char* language) {
    return english.chopped(3) + '.' + language + ".md";
}

// What a page consists of, in order: headings by level, items, pictures, rows of tables with their
// columns, lines of code. Commands are themselves; what is said beside them (behind # or ;) is the
// reader's language, and so are lines of code that are shown indented.
QStringList skeleton(const QString& markdown) {
    static const QRegularExpression kHeading("^(#{1,6}) "),
        kPicture("^!\\[[^\\]]*\\]\\(([^)]+)\\)"), kSaid("\\s+[#;]\\s.*$"),
        kFolded("^(?:G\\d|P1|T0|M5|M8|[GM]\\d+)\\S*");
    QStringList out;
    QString fence;
    for (const QString& line : markdown.split('\n')) {
        if (line.startsWith("```")) {
            fence = fence.isEmpty() ? line : QString();
            out << line;
        } else if (!fence.isEmpty()) {
            out << (fence == "```sh" ? QString(line).remove(kSaid)
                                     : kFolded.match(line).captured());
        } else if (const auto heading = kHeading.match(line); heading.hasMatch()) {
            out << heading.captured(1);
        } else if (const auto picture = kPicture.match(line); picture.hasMatch()) {
            out << picture.captured(1);
        } else if (line.startsWith('|')) {
            out << QString("row of %1").arg(QString(line).remove("\\|").count('|'));
        } else if (line.startsWith("- ")) {
            out << "item";
        } else if (line.startsWith("    ")) {
            out << "code";
        }
    }
    return out;
}

// Parameters, signals and codes stay as they are.
std::set<QString> namesIn(const QString& markdown) {
    static const QRegularExpression kName(
        "(?<![\\w#])(?:[A-Z]{2}_[A-Z_]*[A-Z]|[NF][0-9]{4,5}|"
        "[GM][0-9]+(?:\\.[0-9])?|#[0-9]{3,5})\\b");
    std::set<QString> out;
    for (auto found = kName.globalMatch(markdown); found.hasNext();)
        out.insert(found.next().captured());
    return out;
}

// {page, what is looked for there} of every HelpTopic that the sources of the screens name.
std::set<std::pair<QString, QString>> placesAskedFor() {
    static const QRegularExpression kLiteral("\"((?:[^\"\\\\]|\\\\.)*)\""), kPage("^[a-z_]+\\.md$");
    std::set<std::pair<QString, QString>> out;
    for (QDirIterator all(QString(kSourceFolder) + "/hmi", {"*.cpp", "*.hpp"}, QDir::Files,
                          QDirIterator::Subdirectories);
         all.hasNext();) {
        QStringList before;  // a list of places stands above its page
        for (QString line : statementsOf(handbookText(all.next()))) {
            const bool list = line.contains("kFind[]");
            if (!list && !line.contains(".md\"")) continue;
            line = line.section("QString(\"#", 0, 0);  // what is told before the page
            QString page;
            for (auto found = kLiteral.globalMatch(line); found.hasNext();) {
                const QString text = found.next().captured(1);
                if (list)
                    before << text;
                else if (kPage.match(text).hasMatch())
                    page = text;
                else if (!page.isEmpty() && text.size() > 2)
                    out.insert({page, text});
            }
            if (list) continue;
            for (const QString& text : before) out.insert({page, text});
            before.clear();
        }
    }
    return out;
}

// The first line where it stands is the heading or the item itself: so the view comes to rest
// there, and not where it is only spoken of.
::testing::AssertionResult standsFirstAtItsPlace(const QString& markdown, const QString& find) {
    const std::vector<HelpSlice> slices = sliceHelp(markdown);
    if (sliceWith(slices, find, false) < 0)
        return ::testing::AssertionFailure() << "nowhere: " << find.toStdString();
    for (const QString& line : markdown.split('\n')) {
        const QString shown = QString(line).remove('*').remove('`');
        if (!shown.contains(find, Qt::CaseInsensitive)) continue;
        if (line.startsWith('#') || line.startsWith("- **")) return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure()
               << find.toStdString() << " stands first in: " << line.toStdString();
    }
    return ::testing::AssertionFailure() << "over the end of a line: " << find.toStdString();
}

TEST(Handbook, EveryTranslatedPageIsTheEnglishOneInAnotherLanguage) {
    for (const char* language : kHandbookLanguages)
        for (const char* page : kHandbookPages) {
            SCOPED_TRACE(std::string(page) + " " + language);
            const QString english = handbookText(handbookFolder() + "/" + page),
                          other = handbookText(handbookFolder() + "/" + pageIn(page, language));
            const QStringList wanted = skeleton(english), got = skeleton(other);
            for (qsizetype i = 0; i < std::min(wanted.size(), got.size()); ++i)
                ASSERT_EQ(got[i], wanted[i]) << "part " << i;
            EXPECT_EQ(got.size(), wanted.size());
            EXPECT_EQ(placesOfPage(other).size(), placesOfPage(english).size());
            EXPECT_EQ(namesIn(other), namesIn(english));
        }
}

// A key named in the text is the key on the panel.
TEST(Handbook, EveryKeyThatAPageNamesIsOnTheScreens) {
    static const QRegularExpression kNamed("«([^»]+)»"), kPlace(" ?%\\d");
    for (const char* language : {"en", "ru", "cs", "hu"}) {
        const bool english = QString(language) == "en";
        // a controller's name; a sign in the contour's picture
        std::set<QString> words = {"polyturn", "?"};
        const QString texts = handbookText(QString(kSourceFolder) + "/hmi/translations/polyturn_" +
                                           (english ? "ru" : language) + ".ts");
        const QRegularExpression entry(english ? "<source>([^<]*)</source>"
                                               : "<translation>([^<]*)</translation>");
        for (auto found = entry.globalMatch(texts); found.hasNext();)
            words.insert(found.next().captured(1).remove(kPlace).simplified());
        for (const char* page : kHandbookPages) {
            const QString text = handbookText(handbookFolder() + "/" +
                                              (english ? QString(page) : pageIn(page, language)));
            for (auto found = kNamed.globalMatch(text); found.hasNext();) {
                const QString name = found.next().captured(1).simplified();
                EXPECT_TRUE(words.contains(name))
                    << page << " " << language << ": " << name.toStdString();
            }
        }
    }
}

TEST(Handbook, EveryPlaceThatTheScreensAskForIsFoundInEveryLanguage) {
    std::size_t seen = 0;
    for (const auto& [page, find] : placesAskedFor()) {
        const QString english = handbookText(handbookFolder() + "/" + page);
        for (const char* language : kHandbookLanguages)
            ASSERT_TRUE(QFile::exists(handbookFolder() + "/" + pageIn(page, language)))
                << page.toStdString() << " " << language;
        ++seen;
        EXPECT_TRUE(standsFirstAtItsPlace(english, find)) << page.toStdString();
        for (const char* language : kHandbookLanguages) {
            SCOPED_TRACE(page.toStdString() + " " + language + ": " + find.toStdString());
            const HelpPlace place = placeInLanguage(handbookFolder(), {page, find}, language);
            EXPECT_EQ(place.page, pageIn(page, language));
            EXPECT_NE(place.find, find);
            EXPECT_TRUE(standsFirstAtItsPlace(handbookText(handbookFolder() + "/" + place.page),
                                              place.find));
        }
    }
    EXPECT_GE(seen, 15u);
}

TEST(Handbook, APlaceIsTheHeadingOfTheSameNumberAndACodeStaysItself) {
    QTemporaryDir folder;
    const auto write = [&](const char* name, const char* text) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    write("one.md",
          "# First\n## Second place\n- **Item**: text\n```\n# no heading\n```\n## Last\nM30\n");
    write(
        "one.cs.md",
        "# První\n## Druhé místo\n- **Položka**: text\n```\n# no heading\n```\n## Poslední\nM30\n");
    write("one.hu.md", "# Első\n");
    write("two.md", "# First\n");
    const auto found = [&](const char* page, const char* find, const char* language) {
        const HelpPlace place = placeInLanguage(folder.path(), {page, find}, language);
        return place.page.toStdString() + ": " + place.find.toStdString();
    };
    EXPECT_EQ(found("one.md", "Second", "cs"), "one.cs.md: Druhé místo");
    EXPECT_EQ(found("one.md", "Item:", "cs"), "one.cs.md: Položka:");
    EXPECT_EQ(found("one.md", "last", "cs"), "one.cs.md: Poslední");
    EXPECT_EQ(found("one.md", "M30", "cs"), "one.cs.md: M30");
    EXPECT_EQ(found("one.md", "", "cs"), "one.cs.md: ");
    EXPECT_EQ(found("one.md", "Second", "en"), "one.md: Second");
    EXPECT_EQ(found("one.md", "Second", "hu"), "one.hu.md: Second")
        << "not the same headings: nothing is guessed";
    EXPECT_EQ(found("two.md", "First", "cs"), "two.md: First") << "there is no such page in Czech";
}

}  // namespace
}  // namespace polyturn::hmi
