// Keys in a window that has not the keyboard's focus (a kiosk's panel without a window manager): a
// page hands them on to its fields, and they arrive there once.
#include <QFile>
#include <QTemporaryDir>

#include "hmi/screens/programs/editor_page.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class PassedKeys : public ::testing::Test {
protected:
    PassedKeys() : window({"hmi-test-nobody", "en", "dark", {}, {}}) {
        window.resize(1280, 800);
        window.show();
        other.show();
        other.activateWindow();
        (void)waitFor([&] { return !window.isActiveWindow(); }, 5);
    }
    void walk(const std::function<void()>& look) {
        for (std::size_t i = 0; i < window.screens().size(); ++i) {
            window.showScreen(static_cast<int>(i));
            // some of its pages start processes
            const bool starts = QString(window.screen()->name()) == "programs";
            for (int page = 0; page < (starts ? 1 : window.screen()->pages()); ++page) {
                if (!starts) window.screen()->turnTo(page);
                frames(window, 10);
                look();
            }
        }
    }
    MainWindow window;
    QWidget other;
};

TEST_F(PassedKeys, ReachTheTextOfTheEditorOnce) {
    ASSERT_FALSE(window.isActiveWindow());
    for (std::size_t i = 0; i < window.screens().size(); ++i)
        if (QString(window.screens()[i]->name()) == "programs")
            window.showScreen(static_cast<int>(i));
    auto& programs = dynamic_cast<Programs&>(*window.screen());
    QTemporaryDir folder;
    QFile file(folder.filePath("O1.nc"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("O1\nN10 G0 X50.\nN20 G1 Z-5. F0.2\nN30 G0 X60.\nN40 M30\n");
    file.close();
    programs.restore("0|" + file.fileName());
    QPlainTextEdit& edit = programs.editor().edit();
    ASSERT_TRUE(waitFor([&] { return standsOn(window.ownSheets(), "Edit"); }));
    frames(window, 100);
    QTest::keyClick(&window, Qt::Key_F9);
    ASSERT_TRUE(waitFor([&] { return edit.isVisible() && edit.document()->blockCount() > 3; }));
    edit.moveCursor(QTextCursor::Start);
    QTest::keyClick(&window, Qt::Key_X);
    EXPECT_TRUE(edit.toPlainText().startsWith("x")) << edit.toPlainText().left(20).toStdString();
    EXPECT_FALSE(edit.toPlainText().startsWith("xx"));
    QTest::keyClick(&window, Qt::Key_Backspace);
    QTest::keyClick(&window, Qt::Key_Down);
    EXPECT_EQ(edit.textCursor().blockNumber(), 1);
    QTest::keyClick(&window, Qt::Key_Space);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Delete, Qt::Key_End, Qt::Key_PageDown,
                              Qt::Key_Escape, Qt::Key_Tab, Qt::Key_Shift})
        QTest::keyClick(&window, key);
    edit.undo();
    edit.undo();
    edit.undo();
}

// Numbers, fields of letters, help, lists: each page gets letters, digits and the keys of lists.
TEST_F(PassedKeys, AreTakenByEveryPage) {
    int pads = 0;
    walk([&] {
        for (QWidget* one : window.screen()->findChildren<QWidget*>())
            if (auto* pad = dynamic_cast<NumberPad*>(one);
                pad && pad->isVisibleTo(&window) && pad->field && pad->field()) {
                QTest::keyClick(&window, Qt::Key_5);
                EXPECT_EQ(pad->text(), "5") << window.screen()->name();
                pad->clear();
                ++pads;
            }
        for (const Qt::Key key : {Qt::Key_5, Qt::Key_A, Qt::Key_Backspace, Qt::Key_Down, Qt::Key_Up,
                                  Qt::Key_Tab, Qt::Key_Escape})
            QTest::keyClick(&window, key);
        // a field of letters, where there is one
        QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier);
        if (window.entry().isVisible()) {
            QTest::keyClick(&window, Qt::Key_B);
            EXPECT_TRUE(window.entry().isVisible());
            QTest::keyClick(&window, Qt::Key_Escape);
        }
        QTest::keyClick(&window, Qt::Key_H, Qt::ControlModifier);  // help
        QTest::keyClick(&window, Qt::Key_PageDown);
        QTest::keyClick(&window, Qt::Key_H, Qt::ControlModifier);
    });
    EXPECT_FALSE(window.isActiveWindow());
    (void)pads;  // without a controller most fields have nothing to enter
}

}  // namespace
}  // namespace polyturn::hmi
