// Words while the machine works: all of them fit, on every panel, in tables and in what pictures paint beside the sheets; refusals are read in
// the language of the screens; the help key finds the place in the manual that a page names.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

#include "hmi/app/help_view.hpp"
#include "hmi/widgets/painted.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class Words : public Tasks {
protected:
    void SetUp() override {
        Tasks::SetUp();
        g_controller->run({"tools", "add", "1", "name=ROUGH_80", "type=1", "h=1", "kind=500", "life_kind=minutes", "life=60", "counter=52", "warning=5", "--instance", g_controller->name});
        g_controller->run({"tools", "load", "1", "1", "1", "--instance", g_controller->name});
        g_controller->press("select L1=/nowhere/at/all.nc");
        g_controller->press("cycle_start L1");   // an alarm for the book
        ASSERT_TRUE(waitFor([&] { return window->desk().alarms.standing() != nullptr; }, 10));
        g_controller->press("reset");
        QTest::qWait(200);
        startJob();
        ASSERT_TRUE(waitFor([&] { return state(2) == ChannelState::Waiting || state(1) == ChannelState::Waiting; }));
    }
    void TearDown() override { hearPaintedWords({}); }

    // Each page of each screen, with what stands on it now.
    void walk(const std::function<void(const std::string& where, const std::vector<QString>& texts)>& look) {
        for (std::size_t i = 0; i < window->screens().size(); ++i) {
            std::vector<QString> painted;
            hearPaintedWords([&](const QString& text, bool) { painted.push_back(text); });
            window->showScreen(static_cast<int>(i));
            const bool starts = QString(window->screen()->name()) == "programs";
            const int pages = starts ? 1 : QString(window->screen()->name()) == "graphics" ? 2 : window->screen()->pages();
            for (int page = 0; page < pages; ++page) {
                painted.clear();
                if (!starts) window->screen()->turnTo(page);
                QTest::qWait(120);                 // what is asked of the store has come
                window->frame();
                window->grab();
                std::vector<QString> texts = std::move(painted);
                std::vector<Sheet*> sheets = window->ownSheets();
                for (Sheet* one : window->screen()->sheets()) sheets.push_back(one);
                const QString program = lettering(15, false, Face::Program).family();
                for (const Sheet* sheet : sheets)
                    for (const Item& item : sheet->items())
                        if (item.kind == Item::Kind::Text && !item.text.isEmpty() && item.font.family() != program) texts.push_back(item.text);
                look(std::string(window->screen()->name()) + " " + std::to_string(page + 1), texts);
            }
            if (!starts) window->screen()->turnTo(0);
            hearPaintedWords({});
        }
    }
};

TEST_F(Words, AllFitOnEveryPanelWhileTheMachineWorks) {
    for (const QSize size : {QSize(1024, 768), QSize(1920, 1080)}) {
        window->resize(size);
        QTest::qWait(100);
        noWordIsShortened(*window);
        for (const Tongue tongue : kTongues) {
            window->setTongue(tongue);
            hearPaintedWords([&](const QString& text, bool fits) { EXPECT_TRUE(fits) << size.width() << " " << codeOf(tongue) << ": " << text.toStdString(); });
            for (std::size_t i = 0; i < window->screens().size(); ++i) {
                window->showScreen(static_cast<int>(i));
                const QString name = window->screen()->name();
                if (name != "graphics" && name != "diagnosis" && name != "tools") continue;   // with pictures
                for (int page = 0; page < (name == "graphics" ? 2 : window->screen()->pages()); ++page) {
                    window->screen()->turnTo(page);
                    QTest::qWait(60);
                    window->grab();
                }
            }
            hearPaintedWords({});
        }
        window->setTongue(Tongue::English);
    }
}

// What the store or the controller refuses, in the language of the screens, whichever language its processes speak.
TEST_F(Words, ARefusalIsReadInTheLanguageOfTheScreens) {
    static const QRegularExpression kCyrillic("[\u0400-\u04FF]{4}");
    window->setTongue(Tongue::Russian);
    for (const QJsonObject& wrong : {QJsonObject{{"do", "zeros.set"}, {"channel", 1}, {"zero", "G60"}, {"field", "Z"}, {"value", 1}}, QJsonObject{{"do", "offsets.touch"}, {"channel", 1}, {"number", 3}}, QJsonObject{{"do", "tools.load"}, {"tool", 1}, {"magazine", 9}, {"pot", 1}}}) {
        Answer answer;
        bool come = false;
        window->desk().requests.store(wrong, [&](const Answer& one) { answer = one, come = true; }, true);
        ASSERT_TRUE(waitFor([&] { return come; }, 10));
        EXPECT_FALSE(answer.ok);
        EXPECT_TRUE(kCyrillic.match(answer.text).hasMatch()) << answer.text.toStdString();
        EXPECT_TRUE(kCyrillic.match(answer.remedy).hasMatch()) << answer.remedy.toStdString();
    }
    window->setTongue(Tongue::English);
}

TEST_F(Words, TheHelpKeyFindsThePlaceThatEachPageNames) {
    walk([&](const std::string& where, const std::vector<QString>&) {
        const HelpTopic topic = window->screen()->help();
        EXPECT_TRUE(QFile::exists(HelpView::folder() + "/" + topic.page)) << where << ": " << topic.page.toStdString();
        if (topic.find.isEmpty()) return;
        window->help().open({topic.page, topic.find, {}, topic.code});
        EXPECT_TRUE(window->help().text().textCursor().hasSelection()) << where << ": " << topic.page.toStdString() << " has no " << topic.find.toStdString();
        window->help().hide();
    });
}

// Words beside the sheets go through paintWords(), where this file hears them.
TEST(WordSources, NoWordIsPaintedByHand) {
    for (QDirIterator files(QString(POLYTURN_SOURCE_DIR) + "/hmi", {"*.cpp"}, QDir::Files, QDirIterator::Subdirectories); files.hasNext();) {
        QFile file(files.next());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const bool widget = file.fileName().endsWith("/sheet.cpp") || file.fileName().endsWith("/painted.cpp");
        EXPECT_EQ(file.readAll().contains("drawText("), widget) << file.fileName().toStdString() << ": use paintWords()";
    }
}

}  // namespace
}  // namespace polyturn::hmi
