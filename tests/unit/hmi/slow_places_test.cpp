// A network place that hangs, played by a pipe that nobody writes into and by a device that waits before each piece: the screens go on,
// say what is being waited for, and can stop it.
#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTimer>
#include <condition_variable>
#include <fcntl.h>
#include <mutex>

#include "hmi/machine/setup_sheet.hpp"
#include "hmi/screens/programs.hpp"
#include "tests/unit/hmi/controller.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kLongest_ms = 50;      // nothing blocks the screens longer (issue: how it feels)

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
        EXPECT_TRUE(waitFor([this] { return waiting() == 0; }, 5));
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

// Time of the processor that this thread has spent or waited in one call; a computer that is busy with others may take it away for a
// while, so the best of what it does counts, and the frames that come meanwhile.
struct Beats {
    int count = 0;
    QTimer timer;
    Beats() {
        timer.setInterval(5);
        QObject::connect(&timer, &QTimer::timeout, [this] { ++count; });
        timer.start();
    }
};

struct SlowPlaces : testing::Test {
    void SetUp() override {
        Choices choices;
        choices.instance = "hmi-test-nobody", choices.language = "en", choices.theme = "dark";
        write("a.nc", "O1\nN10 G0 X1.\nM30\n");
        window = std::make_unique<MainWindow>(choices);
        window->resize(1280, 800);
        window->show();
        window->showScreen(2);
        programs().filesPage().readFolder(folder.path(), "a.nc");
        ASSERT_TRUE(waitFor([&] { return programs().filesPage().chosen() && programs().filesPage().chosen()->name == "a.nc"; }, 5));
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
    static qint64 took(const std::function<void()>& call) {
        QElapsedTimer time;
        time.start();
        call();
        return time.elapsed();
    }
    QTemporaryDir folder;
    std::unique_ptr<MainWindow> window;
    std::unique_ptr<Operator> hand;
};

TEST_F(SlowPlaces, AProgramThatDoesNotComeStopsNoScreen) {
    const QByteArray pipe = QFile::encodeName(folder.filePath("hangs.nc"));
    ASSERT_EQ(::mkfifo(pipe.constData(), 0600), 0);
    hand->soft("Edit");
    ASSERT_TRUE(waitFor([&] { return !editor().opening() && !editor().file().isEmpty(); }, 5));
    EXPECT_LT(took([&] { EXPECT_TRUE(editor().open(QFile::decodeName(pipe), "fanuc")); }), kLongest_ms);
    EXPECT_TRUE(editor().opening());
    Beats beats;
    QTest::qWait(400);
    EXPECT_GT(beats.count, 20) << "the screens go on";
    EXPECT_TRUE(editor().opening());
    EXPECT_TRUE(offered("Stop")) << "and it can be stopped";
    hand->soft("Stop");
    EXPECT_FALSE(editor().opening());
    QTest::qWait(60);
    EXPECT_TRUE(offered("Edit")) << "back at the files";
    // Whoever waits is let go; what it reads then goes nowhere.
    const int writer = ::open(pipe.constData(), O_WRONLY | O_NONBLOCK);
    EXPECT_GE(writer, 0);
    ::close(writer);
}

TEST_F(SlowPlaces, AProgramThatComesLateIsEditedThen) {
    Device device;
    EXPECT_LT(took([&] { EXPECT_TRUE(editor().open(folder.filePath("a.nc"), "fanuc")); }), kLongest_ms);
    QTest::qWait(100);
    EXPECT_TRUE(editor().opening());
    EXPECT_TRUE(editor().edit().isReadOnly()) << "nothing can be typed into what is not there";
    device.letGo();
    ASSERT_TRUE(waitFor([&] { return !editor().opening(); }, 5));
    EXPECT_EQ(editor().edit().toPlainText(), "O1\nN10 G0 X1.\nM30\n");
    EXPECT_FALSE(editor().edit().isReadOnly());
}

TEST_F(SlowPlaces, SavingGoesOnBesideAndLeavesTheOldFileWhenItIsStopped) {
    hand->soft("Edit");
    ASSERT_TRUE(waitFor([&] { return !editor().opening() && !editor().file().isEmpty() && !editor().checking(); }, 20));
    editor().edit().insertPlainText("(NEW)\n");
    {
        Device device;
        EXPECT_LT(took([&] { editor().save(); }), kLongest_ms);
        EXPECT_TRUE(editor().saving());
        Beats beats;
        QTest::qWait(300);
        EXPECT_GT(beats.count, 15);
        EXPECT_TRUE(offered("Stop"));
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
        ASSERT_TRUE(waitFor([&] { return !editor().saving(); }, 5));
    }
    EXPECT_EQ(read("a.nc"), "(NEW)\nO1\nN10 G0 X1.\nM30\n");
    EXPECT_TRUE(editor().changed()) << "what was typed meanwhile is not saved";
    editor().save();
    ASSERT_TRUE(waitFor([&] { return !editor().saving(); }, 5));
    EXPECT_FALSE(editor().changed());
    EXPECT_TRUE(waitFor([&] { return !editor().checking(); }, 20));
    EXPECT_TRUE(waitFor([&] { return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden) == QStringList{"a.nc"}; }, 5)) << QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).join(' ').toStdString();
}

TEST_F(SlowPlaces, TheSetupSheetIsWrittenBesideAndCanBeStopped) {
    write("part.job.toml", "name = \"part\"\n[programs]\n1 = { file = \"a.nc\", language = \"fanuc\" }\n");
    programs().filesPage().readFolder(folder.path(), "part.job.toml");
    ASSERT_TRUE(waitFor([&] { return programs().filesPage().job() != nullptr && offered("Print setup sheet"); }, 5));
    {
        Device device;
        qint64 longest = took([&] { hand->soft("Print setup sheet"); });
        EXPECT_LT(longest, 200) << "a touch, its release and the frame behind it";
        ASSERT_TRUE(waitFor([&] { return device.waiting() == 1; }, 5));
        Beats beats;
        QTest::qWait(300);
        EXPECT_GT(beats.count, 15);
        hand->soft("Stop");
    }
    EXPECT_FALSE(QFile::exists(folder.filePath("part-setup.pdf")));
    hand->soft("Print setup sheet");
    ASSERT_TRUE(waitFor([&] { return QFile::exists(folder.filePath("part-setup.pdf")); }, 10));
    EXPECT_EQ(read("part-setup.pdf").left(5), "%PDF-");
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
    EXPECT_EQ(writeWhole(folder.filePath("no/such/place"), "x", progress, go).kind, FileOutcome::Kind::Failed);
}

}  // namespace
}  // namespace polyturn::hmi
