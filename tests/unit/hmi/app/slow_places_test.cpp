// A network place that hangs, played by a pipe that nobody writes into and by a device that waits
// before each piece: the screens go on, say what is being waited for, and can stop it.
#include <fcntl.h>
#include <sys/stat.h>
#include <time.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTextTable>
#include <QThread>
#include <QTimer>
#include <condition_variable>
#include <mutex>

#include "hmi/app/help_view.hpp"
#include "hmi/machine/programs/setup_sheet.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "tests/unit/hmi/controller.hpp"
#include "tests/unit/hmi/screen_checks.hpp"

namespace polyturn::hmi {
namespace {

// This build is not optimised and shares its computer, which may count time that others had. What
// is read or laid out at a stretch took many seconds of the processor; the bound of 50 ms is shown
// by tests/bench/hmi_cost.py.
constexpr double kTurn_ms = 1'500;

// Hangs at each piece until it is let go.
class Device {
public:
    Device() {
        hangAtPieces([this] {
            std::unique_lock<std::mutex> lock(mutex_);
            ++waiting_;
            free_.wait(lock, [this] { return open_; });
            --waiting_;
        });
    }
    ~Device() {
        letGo();
        EXPECT_TRUE(waitFor([this] { return waiting() == 0; }));
        hangAtPieces({});
    }
    void letGo() {
        const std::lock_guard<std::mutex> lock(mutex_);
        open_ = true;
        free_.notify_all();
    }
    int waiting() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return waiting_;
    }

private:
    std::mutex mutex_;
    std::condition_variable free_;
    bool open_ = false;
    int waiting_ = 0;
};

// The screens go on: their timers come, while what is slow still is.
struct Beats {
    int count = 0;
    QTimer timer;
    Beats() {
        timer.setInterval(5);
        QObject::connect(&timer, &QTimer::timeout, [this] { ++count; });
        timer.start();
    }
};

// The longest turn of this thread: time of the processor between two looks, so that a computer that
// is busy with others does not count.
struct LongestTurn {
    QTimer timer;
    double last = now(), longest = 0;
    LongestTurn() {
        timer.setInterval(4);
        QObject::connect(&timer, &QTimer::timeout, [this] { look(); });
        timer.start();
    }
    void look() {
        longest = std::max(longest, now() - last);
        last = now();
    }
    static double now() {
        timespec time{};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
    }
};

struct SlowPlaces : testing::Test {
    void SetUp() override {
        Choices choices;
        choices.instance = "hmi-test-nobody";
        choices.language = "en";
        choices.theme = "dark";
        write("a.nc", "O1\nN10 G0 X1.\nM30\n");
        window = std::make_unique<MainWindow>(choices);
        window->resize(1280, 800);
        window->show();
        window->showScreen(2);
        programs().filesPage().readFolder(folder.path(), "a.nc");
        ASSERT_TRUE(waitFor([&] {
            return programs().filesPage().chosen() &&
                   programs().filesPage().chosen()->name == "a.nc";
        }));
        hand = std::make_unique<Operator>(*window);
    }
    void write(const QString& name, const QByteArray& bytes) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    QByteArray read(const QString& name) {
        QFile file(folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("no such file");
    }
    Programs& programs() { return dynamic_cast<Programs&>(*window->screen()); }
    EditorPage& editor() { return programs().editor(); }
    bool offered(const QString& name) {
        for (const SoftKey& key : window->softKeys().keys())
            if (key.enabled && key.text == name) return true;
        return false;
    }
    QTemporaryDir folder;
    std::unique_ptr<MainWindow> window;
    std::unique_ptr<Operator> hand;
};

TEST_F(SlowPlaces, AProgramThatDoesNotComeStopsNoScreen) {
    hand->soft("Edit");
    ASSERT_TRUE(waitFor([&] { return !editor().opening() && !editor().file().isEmpty(); }));
    Device device;
    // would not come back, if it waited
    EXPECT_TRUE(editor().open(folder.filePath("a.nc"), "fanuc"));
    EXPECT_TRUE(editor().opening());
    Beats beats;
    EXPECT_TRUE(waitFor([&] { return beats.count > 20; })) << "the screens go on";
    EXPECT_TRUE(editor().opening());
    EXPECT_TRUE(offered("Stop")) << "and it can be stopped";
    hand->soft("Stop");
    EXPECT_FALSE(editor().opening());
    frames(*window, 60);
    EXPECT_TRUE(offered("Edit")) << "back at the files";
}

// It would hold its reader until somebody writes into it: it does not come in at all
// (ipc/model/files/regular_file.hpp).
TEST_F(SlowPlaces, APipeIsNoProgram) {
    const QByteArray pipe = QFile::encodeName(folder.filePath("hangs.nc"));
    ASSERT_EQ(::mkfifo(pipe.constData(), 0600), 0);
    hand->soft("Edit");
    ASSERT_TRUE(waitFor([&] { return !editor().opening() && !editor().file().isEmpty(); }));
    editor().open(QFile::decodeName(pipe), "fanuc");
    EXPECT_TRUE(waitFor([&] { return !editor().opening(); })) << "nobody waits for it";
    EXPECT_TRUE(editor().file().isEmpty());
}

TEST_F(SlowPlaces, AProgramThatComesLateIsEditedThen) {
    Device device;
    EXPECT_TRUE(editor().open(folder.filePath("a.nc"), "fanuc"));
    frames(*window, 100);
    EXPECT_TRUE(editor().opening());
    EXPECT_TRUE(editor().edit().isReadOnly()) << "nothing can be typed into what is not there";
    device.letGo();
    ASSERT_TRUE(waitFor([&] { return !editor().opening(); }));
    EXPECT_EQ(editor().edit().toPlainText(), "O1\nN10 G0 X1.\nM30\n");
    EXPECT_FALSE(editor().edit().isReadOnly());
}

TEST_F(SlowPlaces, SavingGoesOnBesideAndLeavesTheOldFileWhenItIsStopped) {
    hand->soft("Edit");
    ASSERT_TRUE(waitFor(
        [&] { return !editor().opening() && !editor().file().isEmpty() && !editor().checking(); }));
    editor().edit().insertPlainText("(NEW)\n");
    {
        Device device;
        editor().save();
        EXPECT_TRUE(editor().saving());
        Beats beats;
        EXPECT_TRUE(waitFor([&] { return beats.count > 15; }));
        EXPECT_TRUE(waitFor([&] { return offered("Stop"); }));
        hand->soft("Stop");
        EXPECT_FALSE(editor().saving());
    }
    EXPECT_EQ(read("a.nc"), "O1\nN10 G0 X1.\nM30\n");
    EXPECT_TRUE(editor().changed());
    {
        Device device;
        editor().save();
        editor().edit().insertPlainText("(LATER)\n");
        device.letGo();
        ASSERT_TRUE(waitFor([&] { return !editor().saving(); }));
    }
    EXPECT_EQ(read("a.nc"), "(NEW)\nO1\nN10 G0 X1.\nM30\n");
    EXPECT_TRUE(editor().changed()) << "what was typed meanwhile is not saved";
    editor().save();
    ASSERT_TRUE(waitFor([&] { return !editor().saving(); }));
    EXPECT_FALSE(editor().changed());
    EXPECT_TRUE(waitFor([&] { return !editor().checking(); }));
    EXPECT_TRUE(waitFor([&] {
        return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden) == QStringList{"a.nc"};
    })) << QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).join(' ').toStdString();
}

TEST_F(SlowPlaces, TheSetupSheetIsWrittenBesideAndCanBeStopped) {
    write("part.job.toml",
          "name = \"part\"\n[programs]\n1 = { file = \"a.nc\", language = \"fanuc\" }\n");
    programs().filesPage().readFolder(folder.path(), "part.job.toml");
    ASSERT_TRUE(waitFor(
        [&] { return programs().filesPage().sheet() != nullptr && offered("Print setup sheet"); }));
    {
        Device device;
        hand->soft("Print setup sheet");
        ASSERT_TRUE(waitFor([&] { return device.waiting() == 1; }));
        Beats beats;
        EXPECT_TRUE(waitFor([&] { return beats.count > 15; }));
        hand->soft("Stop");
    }
    EXPECT_FALSE(QFile::exists(folder.filePath("part-setup.pdf")));
    hand->soft("Print setup sheet");
    ASSERT_TRUE(waitFor([&] { return QFile::exists(folder.filePath("part-setup.pdf")); }));
    EXPECT_EQ(read("part-setup.pdf").left(5), "%PDF-");
}

// The programs of the printer are others: here one that takes a sheet, one that refuses it, none at
// all.
TEST_F(SlowPlaces, WhatThePrinterSaysIsTold) {
    write("part.job.toml",
          "name = \"part\"\n[programs]\n1 = { file = \"a.nc\", language = \"fanuc\" }\n");
    programs().filesPage().readFolder(folder.path(), "part.job.toml");
    ASSERT_TRUE(waitFor(
        [&] { return programs().filesPage().sheet() != nullptr && offered("Print setup sheet"); }));
    const QByteArray path = qgetenv("PATH");
    ASSERT_TRUE(QDir(folder.path()).mkdir("bin"));
    qputenv("PATH", folder.filePath("bin").toUtf8());
    const auto printed = [&](const QByteArray& lp, const QString& told) {
        if (!lp.isEmpty()) {
            write("bin/lp", "#!/bin/sh\n" + lp);
            ASSERT_TRUE(QFile::setPermissions(
                folder.filePath("bin/lp"), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        }
        QFile::remove(folder.filePath("part-setup.pdf"));
        hand->soft("Print setup sheet");
        EXPECT_TRUE(waitFor([&] { return standsOn(window->ownSheets(), told); }))
            << told.toStdString();
    };
    printed({}, "Saved: part-setup.pdf");
    printed("case $1 in */part-setup.pdf) exit 0;; esac\nexit 9\n", "Printed: part-setup.pdf");
    printed("echo 'lp: Error - No default destination.' >&2\nexit 1\n",
            "The printer refused it: lp: Error - No default destination.");
    qputenv("PATH", path);
}

// Four megabytes at once: put in piece by piece, coloured where it is seen.
TEST_F(SlowPlaces, ALongProgramStopsNoScreen) {
    QByteArray text;
    for (int line = 0; text.size() < 3'900'000; ++line)
        text += QString("N%1 G1 X%2 Z-%3 F0.25 (pass)\n")
                    .arg(line)
                    .arg(line % 500 / 7.0, 0, 'f', 3)
                    .arg(line % 311 / 3.0, 0, 'f', 3)
                    .toUtf8();
    write("long.nc", text);
    hand->soft("Edit");
    ASSERT_TRUE(waitFor([&] { return !editor().opening() && !editor().checking(); }));
    LongestTurn turn;
    ASSERT_TRUE(editor().open(folder.filePath("long.nc"), "fanuc"));
    ASSERT_TRUE(waitFor([&] { return !editor().opening(); }));
    frames(*window, 100);
    turn.look();
    EXPECT_LT(turn.longest, kTurn_ms);
    EXPECT_EQ(editor().edit().document()->characterCount(), text.size() + 1);
    EXPECT_EQ(editor().edit().textCursor().position(), 0);
    EXPECT_FALSE(editor().changed());
    EXPECT_FALSE(editor().edit().document()->isUndoAvailable());
    const auto coloured = [&](const QTextBlock& block) {
        return !block.layout()->formats().isEmpty();
    };
    EXPECT_TRUE(coloured(editor().edit().document()->firstBlock()));
    turn.longest = 0;
    editor().edit().moveCursor(QTextCursor::End);
    frames(*window, 200);
    EXPECT_TRUE(coloured(editor().edit().document()->lastBlock().previous()));
    QTest::keyClicks(&editor().edit(), "M30");
    QTest::qWait(1'500);  // it is kept, and copied to be checked
    turn.look();
    EXPECT_LT(turn.longest, kTurn_ms);
    EXPECT_TRUE(editor().changed());
    EXPECT_EQ(editor().edit().toPlainText().toUtf8(), text + "M30");
}

// A program of a die from CAM: a part of it is edited at a time and goes back to its place.
TEST_F(SlowPlaces, OfTwoHundredMegabytesAPartIsEdited) {
    constexpr qint64 kLine = 32, kAll = 200'000'000 / kLine * kLine;
    {
        QFile file(folder.filePath("die.nc"));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        QByteArray piece;
        for (qint64 line = 0; line * kLine < kAll; ++line) {
            char one[48];
            std::snprintf(one, sizeof one, "N%08lld G1 X%09.4f Z-8.125\n",
                          static_cast<long long>(line), static_cast<double>(line % 9999) / 7);
            piece.append(one, kLine);
            if (piece.size() >= 1 << 20) {
                file.write(piece);
                piece.clear();
            }
        }
        file.write(piece);
    }
    ASSERT_EQ(QFileInfo(folder.filePath("die.nc")).size(), kAll);
    hand->soft("Edit");
    ASSERT_TRUE(waitFor([&] { return !editor().opening() && !editor().checking(); }));
    LongestTurn turn;
    ASSERT_TRUE(editor().open(folder.filePath("die.nc"), "fanuc"));
    ASSERT_TRUE(waitFor([&] { return !editor().opening(); }));
    EXPECT_FALSE(editor().part().whole());
    frames(*window, 60);
    EXPECT_TRUE(offered("Next part"));
    EXPECT_FALSE(offered("Part before"));
    const auto firstLine = [&] { return editor().edit().document()->firstBlock().text(); };
    EXPECT_TRUE(firstLine().startsWith("N00000000 "));
    const qint64 ends = editor().part().to;
    EXPECT_EQ(ends % kLine, 0);
    // In the middle of it, as after a restart.
    ASSERT_TRUE(editor().open(folder.filePath("die.nc"), "fanuc", 100'000'007, 0));
    ASSERT_TRUE(waitFor([&] { return !editor().opening(); }));
    EXPECT_EQ(editor().part().line, 100'000'007 / kLine);
    EXPECT_TRUE(firstLine().startsWith(QString("N%1 ").arg(100'000'007 / kLine, 8, 10, QChar('0'))))
        << firstLine().toStdString();
    const FilePart before = editor().part();
    editor().edit().moveCursor(QTextCursor::Start);
    editor().edit().insertPlainText("(HERE)\n");
    frames(*window, 60);
    EXPECT_FALSE(offered("Next part")) << "what has been typed would be lost";
    editor().save();
    ASSERT_TRUE(waitFor([&] { return !editor().saving(); }));
    EXPECT_FALSE(editor().changed());
    turn.look();
    EXPECT_LT(turn.longest, kTurn_ms);
    QFile file(folder.filePath("die.nc"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.size(), kAll + 7);
    const auto at = [&](qint64 place) {
        file.seek(place);
        return file.read(10);
    };
    const auto name = [&](qint64 line) {
        return QString("N%1 ").arg(line, 8, 10, QChar('0')).toUtf8();
    };
    EXPECT_EQ(at(before.from - kLine), name(before.line - 1));
    EXPECT_EQ(at(before.from).left(7), "(HERE)\n");
    EXPECT_EQ(at(before.from + 7), name(before.line));
    EXPECT_EQ(at(before.to + 7), name(before.to / kLine));
    EXPECT_EQ(at(kAll + 7 - kLine), name(kAll / kLine - 1));
    // Somebody else has written it meanwhile: then its parts are no longer where they were.
    editor().edit().insertPlainText("(TWO)\n");
    write("die.nc", "O1\nM30\n");
    editor().save();
    ASSERT_TRUE(waitFor([&] { return !editor().saving(); }));
    EXPECT_TRUE(editor().changed());
    EXPECT_EQ(read("die.nc"), "O1\nM30\n");
}

TEST_F(SlowPlaces, LinesOfAnotherSystemKeepTheirEnds) {
    write("dos.nc", "O1\r\nN10 G0 X1.\r\nM30\r\n");
    ASSERT_TRUE(editor().open(folder.filePath("dos.nc"), "fanuc"));
    ASSERT_TRUE(waitFor([&] { return !editor().opening(); }));
    editor().edit().insertPlainText("(NEW)\n");
    editor().save();
    ASSERT_TRUE(waitFor([&] { return !editor().saving(); }));
    EXPECT_EQ(read("dos.nc"), "(NEW)\r\nO1\r\nN10 G0 X1.\r\nM30\r\n");
    EXPECT_TRUE(waitFor([&] { return !editor().checking(); }));
}

// Another language, another theme, a crash, another program: what has been typed and not saved is
// still there.
TEST_F(SlowPlaces, WhatIsTypedIsNotLost) {
    Choices choices;
    choices.instance = "hmi-test-nobody";
    choices.keptIn = folder.filePath("kept.ini");
    write("b.nc", "O2\nM30\n");
    const auto programsOf = [](MainWindow& one) -> Programs& {
        for (Screen* screen : one.screens())
            if (auto* found = dynamic_cast<Programs*>(screen)) return *found;
        throw std::runtime_error("no such screen");
    };
    const auto open = [](MainWindow& one, EditorPage& page) {
        return waitFor([&] {
            one.frame();
            return !page.opening() && !page.file().isEmpty() && !page.checking();
        });
    };
    MainWindow killed(choices);
    killed.resize(1280, 800);
    killed.show();
    killed.showScreen(2);
    programsOf(killed).filesPage().readFolder(folder.path(), "a.nc");
    ASSERT_TRUE(waitFor([&] {
        return programsOf(killed).filesPage().chosen() &&
               programsOf(killed).filesPage().chosen()->name == "a.nc";
    }));
    Operator other(killed);
    other.soft("Edit");
    ASSERT_TRUE(open(killed, programsOf(killed).editor()));
    programsOf(killed).editor().edit().insertPlainText("(TYPED)\n");
    other.key(Qt::Key_F11);  // Russian
    other.key(Qt::Key_F12);
    ASSERT_TRUE(open(killed, programsOf(killed).editor()));
    EXPECT_TRUE(programsOf(killed).editor().isVisible()) << "the editor is still what is shown";
    EXPECT_EQ(programsOf(killed).editor().edit().toPlainText(), "(TYPED)\nO1\nN10 G0 X1.\nM30\n");
    EXPECT_TRUE(programsOf(killed).editor().changed());
    killed.setDisplayLanguage(DisplayLanguage::English);
    ASSERT_TRUE(open(killed, programsOf(killed).editor()));
    frames(killed, 2'500);
    {
        MainWindow again(choices);
        again.resize(1280, 800);
        again.show();
        EditorPage& page = programsOf(again).editor();
        ASSERT_TRUE(open(again, page));
        EXPECT_TRUE(page.isVisible());
        EXPECT_EQ(page.edit().toPlainText(), "(TYPED)\nO1\nN10 G0 X1.\nM30\n");
        EXPECT_TRUE(page.changed());
        // Another program is opened only when it is said twice.
        Operator third(again);
        third.soft("Files");
        programsOf(again).filesPage().readFolder(folder.path(), "b.nc");
        ASSERT_TRUE(waitFor([&] {
            return programsOf(again).filesPage().chosen() &&
                   programsOf(again).filesPage().chosen()->name == "b.nc";
        }));
        third.soft("Edit");
        frames(again, 100);
        EXPECT_TRUE(page.changed());
        EXPECT_TRUE(page.file().endsWith("a.nc"));
        page.save();
        ASSERT_TRUE(waitFor([&] { return !page.saving() && !page.changed(); }));
        EXPECT_EQ(read("a.nc"), "(TYPED)\nO1\nN10 G0 X1.\nM30\n");
        frames(*window, 300);
    }
    EXPECT_FALSE(QFile::exists(choices.keptIn + ".draft"))
        << "saved: there is nothing to come back";
}

// Tables of all codes of a language are the longest: laid out row by row they took a minute of the
// processor.
TEST(HelpPages, OpenAtOnce) {
    HelpView help(nullptr);
    help.resize(1280, 800);
    help.show();
    const QStringList pages = QDir(HelpView::folder()).entryList({"*.md"}, QDir::Files);
    ASSERT_GE(pages.size(), 8);
    for (const QString& page : pages) {
        HelpTopic topic;
        topic.page = page;
        const double before = LongestTurn::now();
        help.open(topic);
        help.grab();
        EXPECT_LT(LongestTurn::now() - before, 5'000) << page.toStdString();
        EXPECT_GT(help.text().document()->characterCount(), 200) << page.toStdString();
    }
}

// What one turn of the event loop has to lay out is bounded, however long the page is; and nothing
// of the page is lost on the way.
TEST(HelpPages, AreLaidOutAFewLinesInATurn) {
    // in a turn: six rows of a table, or some paragraphs; two of them at once at first
    constexpr int kMostBlocks = 130;
    HelpView help(nullptr);
    help.resize(1280, 800);
    help.show();
    for (const QString& page : QDir(HelpView::folder()).entryList({"*.md"}, QDir::Files)) {
        QFile file(HelpView::folder() + "/" + page);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
        int rows = 0;
        for (const QString& line : lines) rows += line.startsWith('|') && !line.startsWith("| ---");
        // laid out by the same slices: from the middle once is enough
        const bool translated = page.count('.') > 1;
        if (translated && page.startsWith("reference_") && !page.contains(".ru.")) continue;
        // from the top, from the middle
        for (const char* find : translated ? std::vector<const char*>{"TRANS"}
                                           : std::vector<const char*>{"", "G54", "TRANS"}) {
            HelpTopic topic;
            topic.page = page;
            topic.find = find;
            topic.code = true;
            help.open(topic);
            const QTextDocument& document = *help.text().document();
            EXPECT_LT(document.blockCount(), kMostBlocks) << page.toStdString();
            const QString chosen = help.text().textCursor().selectedText();
            int turns = 0;
            for (; !help.complete() && turns < 50'000; ++turns) {
                const int before = document.blockCount();
                QCoreApplication::processEvents();
                EXPECT_LT(document.blockCount() - before, kMostBlocks) << page.toStdString();
                QThread::usleep(200);  // a picture is read aside
            }
            ASSERT_TRUE(help.complete()) << page.toStdString();
            EXPECT_EQ(help.text().textCursor().selectedText(), chosen) << "the place stays";
            EXPECT_TRUE(chosen.isEmpty() || help.text().rect().contains(help.text().cursorRect()))
                << page.toStdString() << ": and is in view";
            int shown = 0;
            for (QTextFrame* frame : document.rootFrame()->childFrames())
                if (auto* table = qobject_cast<QTextTable*>(frame)) shown += table->rows();
            EXPECT_EQ(shown, rows) << page.toStdString();
            const QString text = document.toPlainText();
            int last = 0;
            for (const QString& line : lines) {  // its chapters, in their order
                if (!line.startsWith("## ")) continue;
                const auto at =
                    text.indexOf(QString(line.mid(3)).remove('`').remove('*').trimmed(), last);
                EXPECT_GE(at, last) << page.toStdString() << ": " << line.toStdString();
                last = static_cast<int>(std::max<qsizetype>(at, 0));
            }
        }
    }
}

TEST(WholeFiles, AreReplacedWholeAndKeepWhatMayBeDoneWithThem) {
    QTemporaryDir folder;
    const QString name = folder.filePath("a.nc");
    {
        QFile file(name);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("old");
    }
    ASSERT_EQ(::chmod(QFile::encodeName(name).constData(), 0660), 0);
    FileProgress progress;
    const std::atomic<bool> go{false}, stopped{true};
    EXPECT_EQ(writeWhole(name, "new", progress, stopped).kind, FileOutcome::Kind::Stopped);
    EXPECT_EQ(readText(name, 100, progress, go).text, "old");
    EXPECT_TRUE(writeWhole(name, "new", progress, go).ok());
    EXPECT_EQ(readText(name, 100, progress, go).text, "new");
    struct stat about {};
    ASSERT_EQ(::stat(QFile::encodeName(name).constData(), &about), 0);
    EXPECT_EQ(about.st_mode & 07777, 0660u);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    EXPECT_EQ(readText(name, 2, progress, go).kind, FileText::Kind::TooLarge);
    EXPECT_EQ(readText(folder.filePath("none"), 2, progress, go).kind, FileText::Kind::Unreadable);
    EXPECT_EQ(writeWhole(folder.filePath("no/such/place"), "x", progress, go).kind,
              FileOutcome::Kind::Failed);
}

}  // namespace
}  // namespace polyturn::hmi
