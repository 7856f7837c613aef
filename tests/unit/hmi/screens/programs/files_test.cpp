// Files: transfer with a checksum, protection, places, comparison; and the page of files by touches
// and keys.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QtTest/QTest>
#include <random>

#include "hmi/machine/programs/file_work.hpp"
#include "hmi/machine/programs/job_of_program.hpp"
#include "hmi/machine/programs/text_difference.hpp"
#include "hmi/screens/programs/compare_page.hpp"
#include "hmi/screens/programs/program_colours.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "tests/seeds.hpp"
#include "tests/unit/hmi/controller.hpp"
#include "tests/unit/hmi/screen_checks.hpp"

namespace polyturn::hmi {
namespace {

const std::atomic<bool> kGo{false};

void write(const QString& name, const QByteArray& bytes) {
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly)) << name.toStdString();
    file.write(bytes);
}
QByteArray read(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("no such file");
}

// What the system keeps there is no program, and the key that deletes is at hand.
TEST(Folders, OfTheSystemAreNotOffered) {
    const FolderList root = listFolder("/");
    EXPECT_TRUE(root.readable);
    EXPECT_GT(root.entries.size(), 3u);
    for (const FileEntry& one : root.entries)
        EXPECT_FALSE(one.name == "proc" || one.name == "sys" || one.name == "dev")
            << one.name.toStdString();
    QTemporaryDir folder;
    ASSERT_TRUE(QDir(folder.path()).mkdir("dev"));
    EXPECT_EQ(listFolder(folder.path()).entries.back().name, "dev")
        << "elsewhere it is a name like others";
}

// With the cursor on «Up» another language, another theme or a restart leave the folder where it
// is.
TEST(Folders, StayWhereTheyAreWithTheCursorOnUp) {
    QTemporaryDir folder;
    ASSERT_TRUE(QDir(folder.path()).mkpath("jobs/shaft"));
    const QString here = QFileInfo(folder.filePath("jobs/shaft")).canonicalFilePath();
    write(here + "/O1.nc", "O1\nM30\n");
    MainWindow window({"hmi-test-nobody", "en", "dark", {}, {}});
    window.resize(1280, 800);
    window.show();
    for (std::size_t i = 0; i < window.screens().size(); ++i)
        if (QString(window.screens()[i]->name()) == "programs")
            window.showScreen(static_cast<int>(i));
    window.screen()->restore("0|" + here + "/.");
    ASSERT_TRUE(waitFor([&] {
        return window.context().folder == here && standsOn(window.screen()->sheets(), "O1.nc");
    }));
    QTest::keyClick(&window, Qt::Key_Home);
    QTest::keyClick(&window, Qt::Key_PageUp);
    for (const bool dark : {false, true, false}) {
        window.setDark(dark);
        frames(window, 300);
        EXPECT_EQ(window.context().folder.toStdString(), here.toStdString());
    }
}

TEST(Transfer, BringsTheSameBytesAndLeavesNothingBeside) {
    QTemporaryDir folder;
    const QByteArray bytes = QByteArray("N10 G1 X40.\n").repeated(100'000);
    write(folder.filePath("a.nc"), bytes);
    FileProgress progress;
    const FileOutcome done =
        transfer(folder.filePath("a.nc"), folder.filePath("b.nc"), progress, kGo);
    EXPECT_TRUE(done.ok()) << done.what.toStdString();
    EXPECT_EQ(read(folder.filePath("b.nc")), bytes);
    EXPECT_EQ(progress.done, 2 * bytes.size()) << "written, then read back";
    EXPECT_EQ(progress.all, progress.done);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
}

TEST(Transfer, ThatArrivedOtherwiseLeavesTheOldFile) {
    QTemporaryDir folder;
    write(folder.filePath("a.nc"), "new text\n");
    write(folder.filePath("b.nc"), "old text\n");
    FileProgress progress;
    const FileOutcome done = transfer(folder.filePath("a.nc"), folder.filePath("b.nc"), progress,
                                      kGo, [](const QString& part) {
                                          QFile file(part);  // a medium that turns a bit over
                                          ASSERT_TRUE(file.open(QIODevice::ReadWrite));
                                          file.write("N");
                                      });
    EXPECT_EQ(done.kind, FileOutcome::Kind::Differs);
    EXPECT_EQ(read(folder.filePath("b.nc")), "old text\n");
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2)
        << "nothing is left of the transfer";
}

TEST(Transfer, ThatIsStoppedOrBreaksOffLeavesTheOldFile) {
    QTemporaryDir folder;
    write(folder.filePath("a.nc"), QByteArray(3 << 20, 'x'));
    write(folder.filePath("b.nc"), "old text\n");
    FileProgress progress;
    std::atomic<bool> stop{false};
    const FileOutcome stopped = transfer(folder.filePath("a.nc"), folder.filePath("b.nc"), progress,
                                         stop, [&](const QString&) { stop = true; });
    EXPECT_EQ(stopped.kind, FileOutcome::Kind::Stopped);
    EXPECT_EQ(read(folder.filePath("b.nc")), "old text\n");
    // the stick is pulled
    const FileOutcome gone = transfer(folder.filePath("a.nc"), folder.filePath("b.nc"), progress,
                                      kGo, [](const QString& part) { QFile::remove(part); });
    EXPECT_EQ(gone.kind, FileOutcome::Kind::Failed);
    EXPECT_EQ(read(folder.filePath("b.nc")), "old text\n");
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
    EXPECT_EQ(transfer("/nowhere/at/all.nc", folder.filePath("c.nc"), progress, kGo).kind,
              FileOutcome::Kind::Failed);
    EXPECT_EQ(transfer(folder.filePath("a.nc"), "/proc/nowhere/a.nc", progress, kGo).kind,
              FileOutcome::Kind::Failed);
}

TEST(Transfer, TakesAFolderWithAllThatIsInItButNotIntoItself) {
    QTemporaryDir folder;
    QDir(folder.path()).mkpath("job/sub");
    write(folder.filePath("job/a.nc"), "A\n");
    write(folder.filePath("job/sub/b.nc"), "B\n");
    FileProgress progress;
    EXPECT_EQ(transfer(folder.filePath("job"), folder.filePath("copy"), progress, kGo).files, 2);
    EXPECT_EQ(read(folder.filePath("copy/sub/b.nc")), "B\n");
    EXPECT_FALSE(
        transfer(folder.filePath("job"), folder.filePath("job/sub/job"), progress, kGo).ok());
    EXPECT_TRUE(removeAll(folder.filePath("copy"), 3, kGo).ok());
    EXPECT_FALSE(QFileInfo::exists(folder.filePath("copy")));
}

// What the operating system refuses is told in the language of the screens.
TEST(Transfer, IsRefusedInTheReadersLanguage) {
    QTemporaryDir folder;
    QDir(folder.path()).mkpath("sub");
    write(folder.filePath("a.nc"), "A\n");
    FileProgress progress;
    const std::pair<FileOutcome, QString> kRefused[] = {
        {transfer("/nowhere/at/all.nc", folder.filePath("c.nc"), progress, kGo),
         "all.nc: такого файла или папки нет"},
        {transfer(folder.filePath("sub"), folder.filePath("sub/in"), progress, kGo),
         "in: так нельзя"},
        {rename(folder.filePath("a.nc"), "sub"), "sub: такой файл уже есть"},
        {makeFolder(folder.filePath("a.nc/b")), "b: это не папка"},
    };
    for (const auto& [outcome, told] : kRefused) {
        speak(DisplayLanguage::Russian);
        EXPECT_EQ(outcome.told(), told);
        speak(DisplayLanguage::Hungarian);
        EXPECT_FALSE(outcome.told().contains(QRegularExpression("[\u0400-\u04FF]")) ||
                     outcome.told() == outcome.what)
            << outcome.told().toStdString();
    }
    speak(DisplayLanguage::English);
    EXPECT_EQ(kRefused[0].first.told(), "all.nc: No such file or directory");
}

TEST(Protection, HoldsAgainstDeletingAndNamesWhoMay) {
    QTemporaryDir folder;
    QDir(folder.path()).mkpath("job");
    write(folder.filePath("job/a.nc"), "A\n");
    ASSERT_TRUE(protect(folder.filePath("job/a.nc"), true, 2).ok());
    FolderList list = listFolder(folder.filePath("job"));
    ASSERT_EQ(list.entries.size(), 2u) << "the list of levels is not shown";
    EXPECT_TRUE(list.entries[1].readOnly);
    EXPECT_EQ(list.entries[1].level, 2);
    EXPECT_FALSE(removeAll(folder.filePath("job"), 3, kGo).ok()) << "read-only is so for everybody";
    EXPECT_EQ(read(folder.filePath("job/a.nc")), "A\n");
    ASSERT_TRUE(protect(folder.filePath("job/a.nc"), false, 2).ok());
    EXPECT_FALSE(removeAll(folder.filePath("job/a.nc"), 1, kGo).ok());
    ASSERT_TRUE(rename(folder.filePath("job/a.nc"), "b.nc").ok());
    EXPECT_EQ(levelOf(folder.filePath("job/b.nc")), 2) << "it goes along";
    EXPECT_TRUE(removeAll(folder.filePath("job/b.nc"), 2, kGo).ok());
    EXPECT_EQ(QDir(folder.filePath("job")).entryList(QDir::Files | QDir::Hidden).size(), 0)
        << "and so does its level";
    EXPECT_FALSE(rename(folder.filePath("job"), "a/b").ok());
}

TEST(Places, AreMountedSticksNetworksAndWhatIsConfigured) {
    QTemporaryDir folder;
    write(folder.filePath("places"), "; of the shop\nServer=/srv/nc\nbroken line\n");
    const auto all = places(
        "/dev/sda1 / ext4 rw 0 0\n/dev/sdb1 /media/op/STICK\\0401 vfat rw 0 0\n"
        "server:/nc /mnt/nc nfs4 rw 0 0\nproc /proc proc rw 0 0\n"
        "//pc/share /srv/pc cifs rw 0 0\n",
        {folder.filePath("places"), "/nowhere"});
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].name, "Server");
    EXPECT_EQ(all[1].path, "/media/op/STICK 1");
    EXPECT_EQ(all[1].kind, Place::Kind::Removable);
    EXPECT_EQ(all[2].kind, Place::Kind::Network);
    EXPECT_EQ(all[3].path, "/srv/pc");
    const auto looked = places(
        "systemd-1 /run/media/system/STICK autofs rw 0 0\n"
        "/dev/sdb1 /run/media/system/STICK vfat rw 0 0\n",
        {});
    ASSERT_EQ(looked.size(), 1u) << "mounted at a look into it: one stick, two lines";
    EXPECT_EQ(looked[0].name, "STICK");
    ASSERT_TRUE(keepPlace(folder.filePath("places"), "More", "/tmp"));
    EXPECT_EQ(places({}, {folder.filePath("places")}).size(), 2u);
    ASSERT_TRUE(keepPlace(folder.filePath("places"), "More", {}));
    EXPECT_EQ(places({}, {folder.filePath("places")}).size(), 1u);
}

TEST(Comparison, MarksTheLineThatIsNotTheSame) {
    const QStringList left{"O1", "N10 G0", "N20 G1", "N30 M30"};
    QStringList right = left;
    right[2] = "N20 G1 F.1";
    right.insert(1, "N5 T1");
    const Difference found = differenceOf(left, right, kGo);
    EXPECT_EQ(found.places, 2);
    ASSERT_EQ(found.lines.size(), 5u);
    EXPECT_EQ(found.lines[1].left, -1);
    EXPECT_EQ(found.lines[1].right, 1);
    EXPECT_FALSE(found.lines[3].same);
    EXPECT_EQ(found.lines[3].left, 2) << "what came in its place stands beside it";
    EXPECT_EQ(found.lines[3].right, 3);
}

// Against the truth: the pairs are in order, equal where they say so, nothing is lost, and no
// longer common text exists (a plain table).
TEST(Comparison, FindsTheLongestCommonText) {
    std::mt19937 random(test_seed(7));
    for (int round = 0; round < 300; ++round) {
        QStringList a, b;
        for (auto* list : {&a, &b})
            for (unsigned i = 0, n = random() % 14; i < n; ++i)
                *list << QString(QChar('a' + static_cast<int>(random() % 4)));
        const Difference found = differenceOf(a, b, kGo);
        int left = 0, right = 0, same = 0;
        for (const PairedLine& one : found.lines) {
            if (one.left >= 0) { ASSERT_EQ(one.left, left++); }
            if (one.right >= 0) { ASSERT_EQ(one.right, right++); }
            if (!one.same) continue;
            ASSERT_EQ(a[one.left], b[one.right]);
            ++same;
        }
        ASSERT_EQ(left, a.size());
        ASSERT_EQ(right, b.size());
        std::vector<std::vector<int>> table(
            static_cast<std::size_t>(a.size()) + 1,
            std::vector<int>(static_cast<std::size_t>(b.size()) + 1, 0));
        for (std::size_t i = 1; i < table.size(); ++i)
            for (std::size_t j = 1; j < table[0].size(); ++j)
                table[i][j] = a[static_cast<int>(i) - 1] == b[static_cast<int>(j) - 1]
                                  ? table[i - 1][j - 1] + 1
                                  : std::max(table[i - 1][j], table[i][j - 1]);
        ASSERT_EQ(same, table.back().back())
            << a.join("").toStdString() << " " << b.join("").toStdString();
    }
}

TEST(Comparison, OfTwoLongProgramsIsDoneWhileOneWaits) {
    QStringList left, right;
    for (int i = 0; i < 100'000; ++i) left << QString("N%1 X%2").arg(i).arg(i % 977);
    right = left;
    for (int i = 500; i < 100'000; i += 1000) right[i] += " F.2";
    EXPECT_EQ(differenceOf(left, right, kGo).places, 100);
    for (QString& line : right) line += " ;";
    EXPECT_TRUE(differenceOf(left, right, kGo).rough) << "bounded, and told";
}

// By touches and keys, without a controller.
// A check of the editor comes with every pause: the jobs beside the program are read when one of
// them has changed.
TEST(JobBesideAProgram, IsReadWhenItHasChanged) {
    QTemporaryDir folder;
    const auto put = [&](const QString& name, const QByteArray& text) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    put("a.nc", "O1\nM30\n");
    put("b.nc", "O2\nM30\n");
    put("one.job.toml",
        "name = \"one\"\n[programs]\n1 = { file = \"a.nc\", language = \"fanuc\" }\n");
    const QString a = folder.filePath("a.nc"), b = folder.filePath("b.nc");
    JobOfProgram known = jobOfProgram(a, {});
    EXPECT_EQ(known.job, folder.filePath("one.job.toml"));
    EXPECT_EQ(known.read, 1);
    for (int i = 0; i < 5; ++i) known = jobOfProgram(a, known);
    EXPECT_EQ(known.read, 1);
    EXPECT_EQ(known.job, folder.filePath("one.job.toml"));
    known = jobOfProgram(b, known);
    EXPECT_EQ(known.job, QString()) << "another program";
    put("two.job.toml",
        "name = \"two\"\n[programs]\n1 = { file = \"b.nc\", language = \"fanuc\" }\n");
    known = jobOfProgram(b, known);
    EXPECT_EQ(known.job, folder.filePath("two.job.toml"));
    put("two.job.toml",
        "name = \"two\"\n[programs]\n2 = { file = \"other.nc\", language = \"fanuc\" }\n");
    EXPECT_EQ(jobOfProgram(b, known).job, QString());
}

// A line too long for its half goes on below itself, at a blank where there is one: nothing of it
// is cut.
TEST(ComparePage, LongLinesGoOnBelowThemselves) {
    EXPECT_EQ(ComparePage::pieces("N10 G0 X1", 20), QStringList{"N10 G0 X1"});
    EXPECT_EQ(ComparePage::pieces("", 20), QStringList{""});
    const QString text =
        "N10 CYCLE95(\"CONTOUR\",2.5,0.1,0.2,0,0.25,0.1,0.15,9,0,0,1) ; roughing of the outer "
        "contour, twice";
    for (const int letters : {10, 23, 40}) {
        const QStringList pieces = ComparePage::pieces(text, letters);
        EXPECT_EQ(pieces.join(""), text);
        for (const QString& one : pieces) EXPECT_LE(one.size(), letters);
    }
}

TEST(ProgramColours, WordsOfSinumerikAndToolsByName) {
    dress(true);
    QTextDocument text;
    ProgramColours colours(&text, "sinumerik");
    text.setPlainText(
        "GOTOF END ; T=\"NOTHING\"\nIF R1>2 GOTOB AGAIN\nT=\"ROUGH_80\" D1\nMSG(\"a;b\") G0");
    colours.see(0, 3);
    const auto at = [&](int line, int column) {
        for (const QTextLayout::FormatRange& one : text.findBlockByNumber(line).layout()->formats())
            if (column >= one.start && column < one.start + one.length)
                return one.format.foreground().color();
        return QColor();
    };
    const Theme& t = theme();
    EXPECT_EQ(at(0, 0), t.wait);
    EXPECT_EQ(at(0, 4), t.wait);
    EXPECT_EQ(at(0, 12), t.faint) << "a comment";
    EXPECT_EQ(at(1, 12), t.wait);
    EXPECT_EQ(at(2, 0), t.warn);
    EXPECT_EQ(at(2, 5), t.warn) << "a tool by its name";
    EXPECT_EQ(at(3, 6), t.faint);
    EXPECT_EQ(at(3, 11), t.accent) << "a semicolon in a text begins no comment";
}

class FilesByHand : public ::testing::Test {
protected:
    void SetUp() override {
        write(folder.filePath("a.nc"), "O1\nN10 G0\nM30\n");
        write(folder.filePath("b.nc"), "O1\nN10 G1\nM30\n");
        QDir(folder.path()).mkpath("server");
        Choices choices;
        choices.instance = "hmi-test-nobody";
        choices.language = "en";
        choices.theme = "dark";
        window = std::make_unique<MainWindow>(choices);
        window->resize(1280, 800);
        window->show();
        window->showScreen(2);
        page().readFolder(folder.path(), "a.nc");
        ASSERT_TRUE(waitFor([&] { return page().chosen() && page().chosen()->name == "a.nc"; }));
        hand = std::make_unique<Operator>(*window);
    }
    FilesPage& page() { return dynamic_cast<Programs&>(*window->screen()).filesPage(); }
    void choose(const QString& name) {
        for (int row = 0; row < page().files().rows(); ++row)
            if (page().entries()[static_cast<std::size_t>(row)].name == name)
                return hand->touchCell(page().files(), row, 0);
        FAIL() << name.toStdString();
    }
    QTemporaryDir folder;
    std::unique_ptr<MainWindow> window;
    std::unique_ptr<Operator> hand;
};

TEST_F(FilesByHand, CopyIntoAnotherFolderAndReplaceOnlyAfterASecondPress) {
    hand->soft("Copy, delete ...");
    hand->soft("Mark");
    choose("server");
    hand->key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return page().where().endsWith("server"); }));
    hand->soft("Copy to here");
    ASSERT_TRUE(waitFor(
        [&] { return QFileInfo::exists(folder.filePath("server/a.nc")) && !page().working(); }));
    write(folder.filePath("server/a.nc"), "another\n");
    frames(*window, 100);
    hand->soft("Copy to here");
    frames(*window, 200);
    EXPECT_EQ(read(folder.filePath("server/a.nc")), "another\n") << "one press replaces nothing";
    hand->soft("Copy to here");
    EXPECT_TRUE(
        waitFor([&] { return read(folder.filePath("server/a.nc")) == "O1\nN10 G0\nM30\n"; }));
}

// Name, folder that is shown, language of the channel; then the editor.
TEST_F(FilesByHand, ANewProgramOpensInTheEditorAndReplacesNothing) {
    hand->soft("New program");
    ASSERT_TRUE(page().naming());
    // it is there
    hand->type("a.nc");
    hand->key(Qt::Key_Return);
    frames(*window, 100);
    EXPECT_TRUE(page().naming()) << "the name stays, to be mended";
    EXPECT_TRUE(standsOn(window->ownSheets(), "a.nc is there already"));
    EXPECT_EQ(read(folder.filePath("a.nc")), "O1\nN10 G0\nM30\n");
    for (int i = 0; i < 4; ++i) hand->key(Qt::Key_Backspace);
    hand->type("../x");
    hand->key(Qt::Key_Return);
    frames(*window, 100);
    EXPECT_TRUE(page().naming());
    for (int i = 0; i < 4; ++i) hand->key(Qt::Key_Backspace);
    hand->type("O1234");
    hand->key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return QFileInfo::exists(folder.filePath("O1234.nc")); }));
    EditorPage& editor = dynamic_cast<Programs&>(*window->screen()).editor();
    ASSERT_TRUE(waitFor([&] {
        return editor.file().endsWith("O1234.nc") && !editor.opening() && editor.isVisible();
    }));
    EXPECT_EQ(read(folder.filePath("O1234.nc")), "O1234\n\nM30\n");
    EXPECT_EQ(editor.language(), "fanuc");
}

TEST(NewProgram, RefusesNamesThatNobodyCouldSeeOrType) {
    for (const char* good : {"O1234.nc", "shaft 2.nc", "ВАЛ.MPF", "flange-left_2.nc"})
        EXPECT_TRUE(mayBeName(good)) << good;
    for (const QString& bad : {QString(), QString(" a.nc"), QString(".nc"), QString("a/b.nc"),
                               QString("a\tb.nc"), QString("a|b.nc"), QString("a\u200b.nc"),
                               QString("a="), QString("a."), QString(101, 'a')})
        EXPECT_FALSE(mayBeName(bad)) << bad.toStdString();
    EXPECT_EQ(emptyProgram("O12.nc", "fanuc"), "O12\n\nM30\n");
    EXPECT_EQ(emptyProgram("12.nc", "nct"), "O12\n\nM30\n");
    EXPECT_EQ(emptyProgram("shaft.MPF", "sinumerik"), "\nM30\n");
    QTemporaryDir folder;
    write(folder.filePath("a.nc"), "old\n");
    EXPECT_FALSE(makeProgram(folder.filePath("a.nc"), "new\n").ok());
    EXPECT_EQ(read(folder.filePath("a.nc")), "old\n");
}

TEST_F(FilesByHand, CompareProtectRenameDelete) {
    hand->soft("Copy, delete ...");
    hand->soft("Mark");
    choose("b.nc");
    hand->soft("Compare");
    ComparePage& compare = dynamic_cast<Programs&>(*window->screen()).comparePage();
    ASSERT_TRUE(waitFor([&] { return !compare.busy() && compare.difference().places == 1; }));
    hand->key(Qt::Key_Escape);
    hand->soft("Protect");
    ASSERT_TRUE(waitFor([&] { return page().chosen() && page().chosen()->readOnly; }));
    frames(*window, 60);
    for (const SoftKey& key : window->softKeys().keys())
        EXPECT_FALSE(key.enabled && (key.text == "Delete" || key.text == "Rename"))
            << key.text.toStdString();
    for (int step = 0; step < 3; ++step) {  // setters, makers, free
        hand->soft("Protect");
        ASSERT_TRUE(waitFor([&] { return !page().working(); }));
        frames(*window, 60);
    }
    ASSERT_FALSE(page().chosen()->readOnly);
    hand->soft("Rename");
    hand->soft("Rename");
    ASSERT_TRUE(page().naming());
    for (int i = 0; i < 4; ++i) hand->key(Qt::Key_Backspace);
    hand->touch(&page().pad(), page().pad().hitOf('7'));  // by touch
    hand->type(".nc");
    hand->key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return QFileInfo::exists(folder.filePath("7.nc")); }))
        << QDir(folder.path()).entryList().join(' ').toStdString();
    frames(*window, 100);
    choose("7.nc");
    hand->soft("Delete");
    frames(*window, 100);
    EXPECT_TRUE(QFileInfo::exists(folder.filePath("7.nc"))) << "one press deletes nothing";
    hand->soft("Delete");
    EXPECT_TRUE(waitFor([&] { return !QFileInfo::exists(folder.filePath("7.nc")); }));
}

// A place that does not answer must not stop the screens: what reads it is left behind.
TEST(Aside, WaitsForNobody) {
    Aside<int> slow;
    slow.start([](const std::atomic<bool>& stop) {  // who waited for it would wait for ever
        while (!stop) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return 1;
    });
    EXPECT_TRUE(slow.busy());
    EXPECT_FALSE(slow.take().has_value());
    // what was asked before is forgotten
    slow.start([](const std::atomic<bool>&) { return 2; });
    EXPECT_EQ(slow.take(), 2);
    EXPECT_FALSE(slow.busy());
}

}  // namespace
}  // namespace polyturn::hmi
