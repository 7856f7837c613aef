// Every word that stands on a screen while the machine works: cells of tables, what is told, what
// pictures paint beside the sheets. On a Russian screen none is Latin, on a Czech or Hungarian one
// none is English; all of them fit, on every panel. And the help key finds the place in the manual
// that a screen names, in every language.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <set>

#include "hmi/app/help_view.hpp"
#include "hmi/text/retold.hpp"
#include "hmi/widgets/painted.hpp"
#include "tests/places.hpp"
#include "tests/unit/hmi/source_lines.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

using Tokens = std::set<QString>;

// Words of four letters and more, without those in names: O1001.nc, ROUGH_80, polyturn-kernel.
QStringList tokensOf(const QString& text, int least) {
    static const QRegularExpression kBlank("[\\s/]+"),
        kFrame("^[^\\p{L}\\p{N}]+|[^\\p{L}\\p{N}]+$"), kWord("^[A-Z]?[a-z]+$");
    QStringList out;
    for (QString one : text.split(kBlank, Qt::SkipEmptyParts)) {
        one.remove(kFrame);
        if (one.size() >= least && kWord.match(one).hasMatch()) out << one.toLower();
    }
    return out;
}

QString contentOf(const QString& name) {
    QFile file(QString(kSourceFolder) + "/" + name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return QString::fromUtf8(file.readAll());
}

// The words of a language: everything that has been translated into it.
Tokens vocabulary(DisplayLanguage display_language) {
    Tokens out;
    const QString code = codeOf(display_language);
    static const QRegularExpression kSource("<source>([^<]*)</source>"),
        kTranslation("<translation>([^<]*)</translation>");
    const QString words =
        contentOf(QString("hmi/translations/polyturn_%1.ts")
                      .arg(display_language == DisplayLanguage::English ? QString("ru") : code));
    for (auto found = (display_language == DisplayLanguage::English ? kSource : kTranslation)
                          .globalMatch(words);
         found.hasNext();)
        for (const QString& one : tokensOf(found.next().captured(1), 4)) out.insert(one);
    for (const char* table :
         {"ipc/diagnosis/alarms", "ipc/image/signals", "ipc/params/parameters"}) {
        // names of parameters are their maker's
        if (display_language == DisplayLanguage::English) continue;
        for (const QString& one : tokensOf(contentOf(QString("%1.%2.csv").arg(table, code))
                                               .replace(',', ' ')
                                               .replace('"', ' '),
                                           4))
            out.insert(one);
    }
    return out;
}

// What is left in English of a text that a reader of another language sees.
class LeftWords {
public:
    LeftWords(DisplayLanguage display_language, Tokens names)
        : display_language_(display_language),
          own_(vocabulary(display_language)),
          names_(std::move(names)) {
        EXPECT_GT(english_.size(), 500u);
        if (display_language != DisplayLanguage::Russian) { EXPECT_GT(own_.size(), 500u); }
        // Keys, makers, and what the builder of this machine calls its channels; names of
        // processes.
        names_.insert({"shift", "space", "enter", "polyturn", "english", "magyar", "fanuc", "root",
                       "kernel", "toolmgmt", "plc", "pid", "upper", "lower", "utc", "etc"});
    }
    // Russian: a text without any letter of its own, or a word of the English screens. Czech,
    // Hungarian: such a word that is none of theirs.
    QStringList in(const QString& text) const {
        static const QRegularExpression kCyrillic("[\u0400-\u04FF]");
        QStringList out;
        static const QRegularExpression kZone("^[A-Z]\\w+(?:/[A-Z][\\w+-]*)+$");
        // a path; a time zone by the name that all computers know
        if (text.startsWith('/') || kZone.match(text).hasMatch()) return out;
        const bool russian = display_language_ == DisplayLanguage::Russian;
        for (const QString& one : tokensOf(text, russian ? 3 : 4))
            if (!names_.count(one) && !own_.count(one) &&
                ((russian && !kCyrillic.match(text).hasMatch()) || english_.count(one)))
                out << one;
        return out;
    }

private:
    DisplayLanguage display_language_;
    Tokens english_ = vocabulary(DisplayLanguage::English), own_, names_;
};

class Words : public Tasks {
protected:
    void SetUp() override {
        Tasks::SetUp();
        g_controller->run({"tools", "add", "1", "name=ROUGH_80", "type=1", "h=1", "kind=500",
                           "life_kind=minutes", "life=60", "counter=58", "warning=5", "--instance",
                           g_controller->name});
        g_controller->run({"tools", "load", "1", "1", "1", "--instance", g_controller->name});
        // An alarm for the book. What the test before has left may still be coming to its end:
        // pressed until it is taken.
        ASSERT_TRUE(waitFor([&] {
            return window->context().alarms.standing() ||
                   (g_controller->press("select L1=/nowhere/at/all.nc"),
                    g_controller->press("cycle_start L1"), QTest::qWait(300),
                    window->context().alarms.standing());
        }));
        g_controller->press("reset");
        frames(*window, 200);
        startJob();
        ASSERT_TRUE(waitFor([&] {
            return state(2) == ChannelState::Waiting || state(1) == ChannelState::Waiting;
        }));
    }
    void TearDown() override { hearPaintedWords({}); }

    // Each page of each screen, with what stands on it now: what is asked of the store has `ms` to
    // come. Dry runs only where they are asked for.
    void walk(int ms, bool dryRuns,
              const std::function<void(const std::string& where,
                                       const std::vector<QString>& texts)>& look) {
        for (std::size_t i = 0; i < window->screens().size(); ++i) {
            std::vector<QString> painted;
            hearPaintedWords([&](const QString& text, bool) { painted.push_back(text); });
            window->showScreen(static_cast<int>(i));
            const QString name = window->screen()->name();
            if (name == "programs") window->screen()->restore("0|" + shaft);
            const int pages = name == "graphics" ? 2 : window->screen()->pages();
            for (int page = 0; page < pages; ++page) {
                if (name == "programs" && (page == 1 || page == 2) && !dryRuns) continue;
                painted.clear();
                window->screen()->turnTo(page);
                QTest::qWait(ms);
                if (name == "programs" && ms) {
                    EXPECT_TRUE(waitFor([&] { return !window->screen()->busy(); })) << page;
                }
                window->frame();
                if (ms) window->grab();
                std::vector<QString> texts = std::move(painted);
                std::vector<Sheet*> sheets = window->ownSheets();
                for (Sheet* one : window->screen()->sheets()) sheets.push_back(one);
                const QString program = lettering(15, false, Face::Program).family();
                for (const Sheet* sheet : sheets)
                    for (const Item& item : sheet->items())
                        if (item.kind == Item::Kind::Text && !item.text.isEmpty() &&
                            item.font.family() != program)
                            texts.push_back(item.text);
                look(std::string(window->screen()->name()) + " " + std::to_string(page + 1), texts);
            }
            window->screen()->turnTo(0);
            hearPaintedWords({});
        }
        for (const auto& [over, name] : MainWindow::kOvers) {
            if (!window->showOver(over)) continue;
            QTest::qWait(ms);
            std::vector<QString> texts;
            for (Sheet* sheet : window->overSheets()) {
                sheet->refresh();
                for (const Item& item : sheet->items())
                    if (item.kind == Item::Kind::Text && !item.text.isEmpty())
                        texts.push_back(item.text);
            }
            look(name, texts);
        }
        window->showOver(MainWindow::Over::Screen);
    }
    const QString shaft = QString(kSourceFolder) + "/examples/jobs/shaft/shaft.job.toml";
};

TEST_F(Words, NoneIsLeftInEnglish) {
    // Folders that are listed, and what stands in them.
    Tokens names;
    for (const QString& folder : {window->context().folder, QFileInfo(shaft).path(),
                                  QDir::currentPath(), QDir::rootPath(), QDir::homePath()})
        for (const QString& name :
             QDir(folder).entryList(QDir::Dirs | QDir::Files | QDir::NoDotAndDotDot))
            if (!name.contains(' ')) names.insert(name.toLower());
    // what its author calls tools
    for (const QString& one : tokensOf(contentOf("examples/jobs/shaft/shaft.job.toml"), 3))
        names.insert(one);
    for (const DisplayLanguage display_language :
         {DisplayLanguage::Russian, DisplayLanguage::Czech, DisplayLanguage::Hungarian}) {
        window->setDisplayLanguage(display_language);
        const LeftWords left(display_language, names);
        int looked = 0;
        walk(40, display_language == DisplayLanguage::Russian,
             [&](const std::string& where, const std::vector<QString>& texts) {
                 for (const QString& text : texts) {
                     ++looked;
                     EXPECT_TRUE(left.in(text).isEmpty())
                         << codeOf(display_language) << ", " << where << ": " << text.toStdString()
                         << " (" << left.in(text).join(' ').toStdString() << ")";
                 }
             });
        EXPECT_GT(looked, 1500);
    }
    window->setDisplayLanguage(DisplayLanguage::English);
}

TEST_F(Words, AllFitOnEveryPanelWhileTheMachineWorks) {
    for (const QSize size :
         {QSize(1024, 768), QSize(1920, 1080), QSize(768, 1024), QSize(1080, 1920)}) {
        window->resize(size);
        frames(*window, 100);
        noWordIsShortened(*window, ProgramPages::All);
        for (const DisplayLanguage display_language : kDisplayLanguages) {
            window->setDisplayLanguage(display_language);
            hearPaintedWords([&](const QString& text, bool fits) {
                EXPECT_TRUE(fits) << size.width() << " " << codeOf(display_language) << ": "
                                  << text.toStdString();
            });
            for (std::size_t i = 0; i < window->screens().size(); ++i) {
                window->showScreen(static_cast<int>(i));
                const QString name = window->screen()->name();
                // with pictures
                if (name != "graphics" && name != "diagnosis" && name != "tools") continue;
                for (int page = 0; page < (name == "graphics" ? 2 : window->screen()->pages());
                     ++page) {
                    window->screen()->turnTo(page);
                    frames(*window, 20);
                    window->grab();
                }
            }
            hearPaintedWords({});
        }
        window->setDisplayLanguage(DisplayLanguage::English);
    }
}

// What the store or the controller refuses, in the language of the screens, whichever language its
// processes speak.
TEST_F(Words, ARefusalIsReadInTheLanguageOfTheScreens) {
    static const QRegularExpression kCyrillic("[\u0400-\u04FF]{4}");
    window->setDisplayLanguage(DisplayLanguage::Russian);
    for (const QJsonObject& wrong :
         {QJsonObject{
              {"do", "zeros.set"}, {"channel", 1}, {"zero", "G60"}, {"field", "Z"}, {"value", 1}},
          QJsonObject{{"do", "offsets.touch"}, {"channel", 1}, {"number", 3}},
          QJsonObject{{"do", "tools.load"}, {"tool", 1}, {"magazine", 9}, {"pot", 1}}}) {
        Answer answer;
        bool come = false;
        window->context().requests.store(
            wrong,
            [&](const Answer& one) {
                answer = one;
                come = true;
            },
            true);
        ASSERT_TRUE(waitFor([&] { return come; }));
        EXPECT_FALSE(answer.ok);
        EXPECT_TRUE(kCyrillic.match(answer.text).hasMatch()) << answer.text.toStdString();
        EXPECT_TRUE(kCyrillic.match(answer.remedy).hasMatch()) << answer.remedy.toStdString();
    }
    window->setDisplayLanguage(DisplayLanguage::English);
}

TEST_F(Words, TheHelpKeyFindsThePlaceThatEachPageNames) {
    for (const DisplayLanguage display_language :
         {DisplayLanguage::English, DisplayLanguage::Russian}) {
        window->setDisplayLanguage(display_language);
        walk(0, false, [&](const std::string& where, const std::vector<QString>&) {
            const HelpTopic topic = window->screen()->help();
            EXPECT_TRUE(QFile::exists(HelpView::folder() + "/" + topic.page))
                << where << ": " << topic.page.toStdString();
            if (topic.find.isEmpty()) return;
            window->help().open({topic.page, topic.find, {}, topic.code});
            EXPECT_TRUE(window->help().text().textCursor().hasSelection())
                << where << ": " << topic.page.toStdString() << " has no "
                << topic.find.toStdString();
            window->help().hide();
        });
    }
    window->setDisplayLanguage(DisplayLanguage::English);
}

// That the test above can find one: in a sentence, alone, and in a message that quotes a name.
TEST(WordSources, WhatIsLeftInEnglishIsFound) {
    for (const DisplayLanguage display_language :
         {DisplayLanguage::Russian, DisplayLanguage::Czech, DisplayLanguage::Hungarian}) {
        const LeftWords left(display_language, {"shaft"});
        for (const char* text : {"No faults found", "Select job", "Waiting",
                                 "Cannot be written: O1001.nc", "Number of the tool"})
            EXPECT_FALSE(left.in(text).isEmpty()) << codeOf(display_language) << ": " << text;
        for (const char* text : {"G54", "O1001.nc", "polyturn-kernel", "shaft", "ROUGH_80",
                                 "1.234 mm", "/media/stick/programs"})
            EXPECT_TRUE(left.in(text).isEmpty()) << codeOf(display_language) << ": " << text;
    }
    EXPECT_TRUE(
        LeftWords(DisplayLanguage::Russian, {}).in(QString::fromUtf8("Нет ошибок")).isEmpty());
    EXPECT_FALSE(LeftWords(DisplayLanguage::Russian, {})
                     .in(QString::fromUtf8("Файл: No such file or directory"))
                     .isEmpty());
}

// A sentence of the sources that screens show stands in word(): no test sees every message.
TEST(WordSources, NoSentenceStandsOutsideTheWords) {
    // What the controller is told or tells, choices that are translated where they are shown.
    const QStringList kNotShown{"reference all",
                                "loading station",
                                "working area",
                                "too large",
                                "too small",
                                R"(auto repeat delay:\\s*(\\d+)\\s+repeat rate:\\s*(\\d+))",
                                "not been booted with systemd",
                                "yyyy-MM-ddTHH:mm:ss",
                                " (beyond the edge)"};
    static const QRegularExpression kLiteral(R"re("((?:[^"\\]|\\.)*)")re"),
        kSentence("[A-Za-z]{3,}[ ,:]+[a-z]{2,}"), kWords(R"((?:word|WORD)\(\s*$)");
    int seen = 0;
    for (QDirIterator files(QString(kSourceFolder) + "/hmi", {"*.cpp", "*.hpp"}, QDir::Files,
                            QDirIterator::Subdirectories);
         files.hasNext();) {
        QFile file(files.next());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        // of the command line
        if (file.fileName().endsWith("/main.cpp") || file.fileName().endsWith("/screenshots.cpp"))
            continue;
        if (file.fileName().endsWith("/finger_bars.cpp")) continue;  // a style sheet
        for (const QString& line : statementsOf(QString::fromUtf8(file.readAll()))) {
            // titles of the manual, which is English
            if (line.contains("HelpTopic") || line.contains(".md\"") || line.contains("kFind[]"))
                continue;
            qsizetype first = 0, end = -1;  // of the pieces that make one text
            for (auto found = kLiteral.globalMatch(line); found.hasNext();) {
                const auto one = found.next();
                const QString text = one.captured(1);
                const QString between = line.mid(end, one.capturedStart() - end);
                if (end < 0 || !between.trimmed().isEmpty()) first = one.capturedStart();
                end = one.capturedEnd();
                if (!kSentence.match(text).hasMatch() || text.startsWith('<')) continue;
                ++seen;
                EXPECT_TRUE(kWords.match(line.left(first)).hasMatch() || kNotShown.contains(text))
                    << file.fileName().toStdString() << ": " << text.toStdString();
            }
        }
    }
    EXPECT_GT(seen, 300);
}

// Words beside the sheets go through paintWords(), where this file hears them.
TEST(WordSources, NoWordIsPaintedByHand) {
    for (QDirIterator files(QString(kSourceFolder) + "/hmi", {"*.cpp"}, QDir::Files,
                            QDirIterator::Subdirectories);
         files.hasNext();) {
        QFile file(files.next());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const bool widget =
            file.fileName().endsWith("/set_words.cpp") || file.fileName().endsWith("/painted.cpp");
        EXPECT_EQ(file.readAll().contains("drawText("), widget)
            << file.fileName().toStdString() << ": use paintWords()";
    }
}

// Logs of stops and dry runs tell the machine builder's words in English; the screens have them in
// every language.
TEST(Retold, TheBuildersMessageIsReadInTheLanguageOfTheScreens) {
    text::BuilderMessages messages;
    ASSERT_TRUE(
        messages
            .add("101,oil is hot,масло горячее,olej je horký,az olaj forró,the cooler,Clean it.,"
                 "холодильник,chladič,hűtő,Очистите.,Vyčistěte.,Tisztítsa.\n",
                 "messages.csv")
            .empty());
    const QString logged =
        "message 101 of the machine builder: oil is hot; cause: the cooler. Clean it.";
    knowBuilderMessages(messages);
    speak(DisplayLanguage::Russian);
    EXPECT_EQ(retold("PT0539", logged).text,
              "сообщение 101 изготовителя станка: масло горячее; причина: холодильник. Очистите.");
    EXPECT_EQ(
        retold(
            "PT0811",
            "note 7 of the machine builder: the door is open; cause: the input PT_IN_DOOR is off. "
            "Close the door.")
            .text,
        "указание 7 изготовителя станка: дверь открыта; причина: вход PT_IN_DOOR выключен. "
        "Закройте дверь.");
    speak(DisplayLanguage::Hungarian);
    EXPECT_EQ(retold("PT0539", logged).text,
              "a gépgyártó 101 üzenete: az olaj forró; ok: hűtő. Tisztítsa.");
    speak(DisplayLanguage::English);
    EXPECT_EQ(
        retold("PT0539",
               "сообщение 101 изготовителя станка: масло горячее; причина: холодильник. Очистите.")
            .text,
        logged);
    knowBuilderMessages({});
    EXPECT_EQ(retold("PT0539", logged).text, logged);
}

}  // namespace
}  // namespace polyturn::hmi
