// Screens without a controller: they come up at once, in four languages and two themes, remember
// where they were, and can be locked.
#include <QElapsedTimer>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest/QTest>

#include "hmi/app/screenshots.hpp"
#include "hmi/widgets/table.hpp"
#include "tests/unit/hmi/screen_checks.hpp"

namespace polyturn::hmi {
namespace {

Choices nobody() {
    Choices choices;
    choices.instance = "hmi-test-nobody";
    choices.language = "en";
    choices.theme = "dark";
    return choices;
}

TEST(Screens, WaitForAControllerAndSaySo) {
    QElapsedTimer time;
    time.start();
    MainWindow window(nobody());
    window.resize(1280, 800);
    window.show();
    frames(window, 50);
    EXPECT_FALSE(window.context().live.connected());
    speak(DisplayLanguage::Hungarian);
    // in words and by the controller's name, not by that of a segment
    const std::string why = window.context().live.whyNot();
    EXPECT_NE(
        why.find(std::string(
            alarm_text(Alarm::SegmentMissing, DisplayLanguage::Hungarian).text.substr(0, 10))),
        std::string::npos)
        << why;
    EXPECT_EQ(why.find(".supervisor"), std::string::npos) << why;
    speak(DisplayLanguage::English);
    for (std::size_t i = 0; i < window.screens().size(); ++i) {
        window.showScreen(static_cast<int>(i));
        // nothing that asks the machine may be offered
        for (const SoftKey& key : window.screen()->keys())
            EXPECT_FALSE(key.sign == Sign::Run && key.enabled)
                << window.screen()->name() << ": " << key.text.toStdString();
        // its pages start processes
        const bool starts = QString(window.screen()->name()) == "programs";
        for (int page = 0; page < (starts ? 1 : window.screen()->pages()); ++page) {
            if (!starts) window.screen()->turnTo(page);
            frames(window, 40);
            for (Sheet* sheet : window.screen()->sheets())
                if (const auto* table = dynamic_cast<Table*>(sheet); table && table->isEmpty()) {
                    EXPECT_FALSE(table->whyEmpty().isEmpty())
                        << window.screen()->name() << " " << page + 1;
                }
        }
    }
}

TEST(Screens, NoWordIsShortenedOnAnyPanel) {
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080), QSize(1024, 768), QSize(800, 600),
                             QSize(768, 1024), QSize(1080, 1920)}) {
        MainWindow window(nobody());
        window.resize(size);
        window.show();
        EXPECT_GE(window.screens().size(), 5u);
        noWordIsShortened(window, ProgramPages::All);
    }
}

// A word with three Latin letters and no Cyrillic one on a Russian screen has been forgotten,
// unless it is a code or a name everywhere.
TEST(Screens, NoWordIsLeftInEnglish) {
    MainWindow window(nobody());
    window.resize(1280, 800);
    window.show();
    window.setDisplayLanguage(DisplayLanguage::Russian);
    static const QRegularExpression kLatin("[A-Za-z]{3,}"), kCyrillic("[\u0400-\u04FF]");
    const QStringList kEverywhere{"Polyturn", "Shift", "Space", "Enter", "DHCP", "USB", "PID"};
    std::size_t looked = 0;
    eachPage(window, ProgramPages::All,
             [&](const std::string& where, const std::vector<Sheet*>& sheets) {
                 for (Sheet* sheet : sheets)
                     for (const QString& text : sheet->fixedWords()) {
                         ++looked;
                         EXPECT_TRUE(!kLatin.match(text).hasMatch() ||
                                     kCyrillic.match(text).hasMatch() || kEverywhere.contains(text))
                             << where << ": " << text.toStdString();
                     }
             });
    EXPECT_GT(looked, 300u);
    window.setDisplayLanguage(DisplayLanguage::English);
}

// That the test of shortened words can see one: a panel far too small for the words.
TEST(Screens, ShortenedWordsAreFound) {
    MainWindow window(nobody());
    window.setMinimumSize(1, 1);
    window.resize(260, 200);
    window.show();
    int looked = 0;
    EXPECT_FALSE(shortenedWords(window, looked).empty());
}

TEST(Screens, ShowTheSameAfterARestart) {
    QTemporaryDir folder;
    Choices choices = nobody();
    choices.language.clear();
    choices.theme.clear();
    choices.keptIn = folder.filePath("hmi.ini");
    {
        MainWindow window(choices);
        window.show();
        window.setDisplayLanguage(DisplayLanguage::Czech);
        window.setDark(false);
        window.showScreen(2);
    }
    MainWindow window(choices);
    EXPECT_EQ(window.shown(), 2);
    EXPECT_EQ(spoken(), DisplayLanguage::Czech);
    EXPECT_FALSE(theme().dark);
    window.setDisplayLanguage(DisplayLanguage::English);
    window.setDark(true);
}

// Killed: nobody says goodbye. What a restart finds is what was kept while it ran.
TEST(Screens, ShowTheSameAfterACrash) {
    QTemporaryDir folder;
    Choices choices = nobody();
    choices.language.clear();
    choices.theme.clear();
    choices.keptIn = folder.filePath("hmi.ini");
    MainWindow killed(choices);
    killed.show();
    killed.setDisplayLanguage(DisplayLanguage::Hungarian);
    const auto show = [](MainWindow& window, const char* name) {
        for (std::size_t i = 0; i < window.screens().size(); ++i)
            if (QString(window.screens()[i]->name()) == name)
                window.showScreen(static_cast<int>(i));
    };
    frames(killed, 1'500);
    show(killed, "diagnosis");
    // within the screen: no other screen is shown behind it
    killed.screen()->turnTo(1);
    show(killed, "manual");
    killed.screen()->turnTo(1);
    const QString page = killed.screen()->state();
    frames(killed, 2'500);
    {
        MainWindow again(choices);
        EXPECT_STREQ(again.screen()->name(), "manual");
        EXPECT_EQ(again.screen()->state(), page);
        EXPECT_EQ(spoken(), DisplayLanguage::Hungarian);
        show(again, "diagnosis");
        EXPECT_TRUE(again.screen()->state().startsWith("1 "))
            << again.screen()->state().toStdString();
    }
    killed.setDisplayLanguage(DisplayLanguage::English);
}

// A list of a million rows asks for those that are seen.
TEST(Tables, OfAMillionRowsAreScrolledWithinAFrame) {
    Table table(nullptr);
    table.resize(800, 600);
    table.columns = {{"No.", 1}, {"Text", 4}};
    int asked = 0;
    table.rows = [] { return 1'000'000; };
    table.cell = [&](int row, int) -> Table::Cell {
        ++asked;
        return Table::Cell{QString::number(row)};
    };
    for (const Qt::Key key : {Qt::Key_End, Qt::Key_PageUp, Qt::Key_Home, Qt::Key_PageDown}) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
        table.key(&event);
    }
    EXPECT_EQ(table.row(), table.visibleRows());
    EXPECT_LE(asked, 4 * 2 * (table.visibleRows() + 1));
}

// A second press confirms the key that was pressed first, not another one that has come to its
// place.
TEST(SoftKeys, AreAskedForOneByOne) {
    SoftKeyBar bar(nullptr);
    bar.resize(1280, 80);
    int first = 0, second = 0;
    const auto key = [](const char* text, int& count) {
        return SoftKey{text, [&count] { ++count; }, Sign::Reset, true, false, true, "press again"};
    };
    bar.show({key("Reset L1", first)});
    bar.press(0);
    bar.show({key("Reset L2", second)});
    bar.press(0);
    EXPECT_EQ(second, 0);
    bar.show({key("Reset L2", second)});
    bar.press(0);
    EXPECT_EQ(second, 0) << "a double tap has not read the question";
    QTest::qWait(SoftKeyBar::kReadMs + 20);
    bar.press(0);
    EXPECT_EQ(second, 1);
    EXPECT_EQ(first, 0);
}

// The same key for another file, tool or value has not been asked for; what it acts on stands in
// the question.
TEST(SoftKeys, AreAskedAnewForAnotherSubject) {
    SoftKeyBar bar(nullptr);
    bar.resize(1280, 80);
    int first = 0, second = 0;
    const auto key = [](const char* file, int& count) {
        return SoftKey{
            "Delete", [&count] { ++count; },      Sign::Off, true, false, true, "press again",
            {},       QString("/folder/") + file, file};
    };
    const auto says = [&](const QString& text) {
        bar.refresh();
        return std::any_of(bar.items().begin(), bar.items().end(),
                           [&](const Item& one) { return one.text == text; });
    };
    bar.show({key("a.nc", first)});
    EXPECT_FALSE(says("a.nc"));
    bar.press(0);
    EXPECT_TRUE(says("a.nc"));
    QTest::qWait(SoftKeyBar::kReadMs + 20);
    bar.show({key("b.nc", second)});
    bar.press(0);
    EXPECT_EQ(second, 0) << "asked for a.nc";
    EXPECT_TRUE(says("b.nc"));
    QTest::qWait(SoftKeyBar::kReadMs + 20);
    bar.show({key("b.nc", second)});
    bar.press(0);
    EXPECT_EQ(second, 1);
    EXPECT_EQ(first, 0);
}

TEST(Screens, AreReachedByKeysAlone) {
    MainWindow window(nobody());
    window.show();
    for (std::size_t i = 0; i < window.screens().size(); ++i) {
        QTest::keyClick(&window, static_cast<Qt::Key>(Qt::Key_0 + static_cast<int>((i + 1) % 10)),
                        Qt::AltModifier);
        EXPECT_EQ(window.shown(), static_cast<int>(i));
    }
}

TEST(Screens, ALockedPanelTakesNoTouchAndNoKey) {
    MainWindow window(nobody());
    window.show();
    window.showScreen(0);
    QTest::keyClick(&window, Qt::Key_L, Qt::ControlModifier);
    EXPECT_TRUE(window.locked());
    QTest::keyClick(&window, Qt::Key_2, Qt::AltModifier);
    EXPECT_EQ(window.shown(), 0);
}

// A finger that is down when the panel is locked is forgotten: its release, or a tool that it
// drags, does nothing beneath the cover.
TEST(Screens, ALockForgetsTheFingerThatIsDown) {
    MainWindow window(nobody());
    window.resize(1280, 800);
    window.show();
    Table table(&window);
    table.columns = {{"No.", 1}};
    table.rows = [] { return 5; };
    table.cell = [](int row, int) -> Table::Cell { return {QString::number(row)}; };
    int activated = 0;
    table.onActivated = [&] { ++activated; };
    FreeSheet held(&window);
    int released = 0;
    held.onCompose = [&](Writer& w) { w.hit(QRectF(0, 0, 100, 100), 1); };
    held.onReleased = [&](int) { ++released; };
    table.setGeometry(300, 200, 400, 300);
    held.setGeometry(750, 200, 100, 100);
    table.show();
    held.show();
    table.refresh();
    held.refresh();
    const QPoint row = table.cellBox(0, 0).center().toPoint();
    QTest::mouseClick(&table, Qt::LeftButton, {}, row);
    ASSERT_EQ(activated, 1) << "the chosen row, touched again";
    QTest::mousePress(&table, Qt::LeftButton, {}, row);
    QTest::keyClick(&window, Qt::Key_L, Qt::ControlModifier);
    ASSERT_TRUE(window.locked());
    QTest::mouseRelease(&table, Qt::LeftButton, {}, row);
    EXPECT_EQ(activated, 1);

    MainWindow other(nobody());
    other.show();
    held.setParent(&other);
    held.setGeometry(300, 200, 100, 100);
    held.show();
    held.refresh();
    QTest::mousePress(&held, Qt::LeftButton, {}, {50, 50});
    QTest::keyClick(&other, Qt::Key_L, Qt::ControlModifier);
    EXPECT_EQ(released, 1) << "what acts while it is held ends with the lock";
    QTest::mouseRelease(&held, Qt::LeftButton, {}, {50, 50});
    EXPECT_EQ(released, 1);
    held.setParent(nullptr);  // it goes before that window does
}

TEST(Screens, SavePicturesOfThemselves) {
    QTemporaryDir folder;
    ASSERT_EQ(saveScreenshots(nobody(), QSize(1280, 800), folder.path()), 0);
    EXPECT_GE(QDir(folder.path()).entryList({"*-en-dark.png"}).size(), 5);
    EXPECT_NE(saveScreenshots(nobody(), QSize(1280, 800), "/proc/nowhere"), 0);
}

}  // namespace
}  // namespace polyturn::hmi
