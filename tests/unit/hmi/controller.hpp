// A real controller for the HMI's tests, and an operator who counts what he does. Real time, on a
// computer that may be busy: the PLC gets time, and what takes a while is waited for.
#pragma once
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <algorithm>
#include <csignal>
#include <functional>

#include "hmi/app/main_window.hpp"
#include "hmi/widgets/table.hpp"
#include "tests/places.hpp"

namespace polyturn::hmi {

// How long only says when something is taken for lost: a computer that is taken away for seconds is
// no fault of the product.
inline bool waitFor(const std::function<bool()>& condition, int seconds = 90) {
    QElapsedTimer time;
    time.start();
    while (!condition()) {
        if (time.elapsed() > seconds * 1000) return false;
        QTest::qWait(20);
    }
    return true;
}

// Time for something to come, and a frame that shows it, whatever else the computer has to do.
inline void frames(MainWindow& window, int ms = 60) {
    QTest::qWait(ms);
    window.frame();
    QCoreApplication::processEvents();
}

class Controller {
public:
    explicit Controller(QString machine = {}, QStringList parameters = {})
        : name(QString("hmi-test-%1").arg(::getpid())),
          machine_(std::move(machine)),
          parameters_(std::move(parameters)) {
        process_.setProcessChannelMode(QProcess::MergedChannels);
        process_.setStandardOutputFile(folder.filePath("log"));
        start();
    }
    ~Controller() {
        stop();
        run({"clean"});
    }
    void start() {
        const QStringList machine = machine_.isEmpty() ? QStringList() : QStringList{machine_};
        QStringList own;
        for (const QString& one : parameters_) own << "--set" << one;
        // A test that crashes leaves no controller behind.
        process_.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGTERM); });
        process_.start(program(),
                       QStringList{"start"}
                           << machine << own
                           << QStringList{"--instance", name, "--store", folder.filePath("store"),
                                          "--no-hmi", "--set", "PT_PLC_CYCLE=100", "--set",
                                          "PT_LATE_MAX=1000"});
        EXPECT_TRUE(waitFor([&] { return run({"status", "--instance", name}); }));
    }
    void stop() {
        process_.terminate();
        if (!process_.waitForFinished(20'000)) {
            process_.kill();
            process_.waitForFinished();
        }
    }
    bool run(const QStringList& arguments) { return QProcess::execute(program(), arguments) == 0; }
    bool press(const QString& words) {
        return run(QStringList{"press", "--instance", name} << words.split(' '));
    }
    bool set(const QString& words) { return run({"set", "--instance", name, words}); }

    QTemporaryDir folder;
    QString name;

private:
    static QString program() { return QString(kProgramFolder) + "/polyturn"; }
    QString machine_;         // of the examples; empty: the default one
    QStringList parameters_;  // of its own, «N0104=00000001»
    QProcess process_;
};

// Touches and keys only; each is an action, and so is typing one value.
class Operator {
public:
    explicit Operator(MainWindow& window) : window_(window) {}
    int actions = 0;

    void touch(Sheet* sheet, int number) {
        ++actions;
        const QRectF box = sheet->boxOf(number);
        ASSERT_FALSE(box.isEmpty()) << "there is nothing to touch: " << number;
        QTest::mouseClick(sheet, Qt::LeftButton, {}, box.center().toPoint());
    }
    void touchCell(Table& table, int row, int column) {
        ++actions;
        const QRectF box = table.cellBox(row, column);
        ASSERT_FALSE(box.isEmpty()) << "row " << row << " is not on the screen";
        QTest::mouseClick(&table, Qt::LeftButton, {}, box.center().toPoint());
    }
    void key(Qt::Key key, Qt::KeyboardModifiers with = {}) {
        ++actions;
        QTest::keyClick(&window_, key, with);
    }
    void type(const QString& text) {
        ++actions;
        QTest::keyClicks(&window_, text);
    }
    // Screens by their name, soft keys by their text.
    void screen(const char* name) {
        for (std::size_t i = 0; i < window_.screens().size(); ++i)
            if (QString(window_.screens()[i]->name()) == name)
                return key(static_cast<Qt::Key>(Qt::Key_0 + static_cast<int>((i + 1) % 10)),
                           Qt::AltModifier);
        FAIL() << "there is no screen " << name;
    }
    void soft(const QString& text) {
        SoftKeyBar& bar = window_.softKeys();
        const auto& keys = bar.keys();
        frames(window_);  // keys are shown anew with the next one
        // An operator waits until the key is there and lit; on a late computer that takes a while.
        waitFor([&] {
            return std::any_of(keys.begin(), keys.end(),
                               [&](const auto& one) { return one.text == text && one.enabled; });
        });
        for (int i = 0; i < static_cast<int>(keys.size()); ++i)
            if (keys[static_cast<std::size_t>(i)].text == text) {
                ASSERT_TRUE(keys[static_cast<std::size_t>(i)].enabled) << text.toStdString();
                // it asked before: a question is read before it is answered, and asked again when
                // it has lapsed meanwhile
                if (asking_ == text) {
                    while (!keys[static_cast<std::size_t>(i)].confirm.isEmpty() &&
                           (bar.asked() != i || bar.waits() > 0)) {
                        if (bar.asked() != i) {
                            touch(&bar, i);
                            --actions;
                        }
                        QTest::qWait(bar.waits() + 10);
                    }
                }
                touch(&bar, i);
                asking_ = bar.asked() == i ? text : QString();
                return;
            }
        FAIL() << "there is no key " << text.toStdString();
    }

private:
    MainWindow& window_;
    QString asking_;  // the soft key that wants its second press
};

}  // namespace polyturn::hmi
