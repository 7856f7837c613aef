// polyturn-hmi as it is called at a terminal, without a display.
#include <gtest/gtest.h>

#include <QProcess>
#include <QProcessEnvironment>

#include "tests/places.hpp"

namespace polyturn::hmi {
namespace {

struct Said {
    int status = -1;
    bool died = false;
    QString out, err;
};
Said call(const QStringList& arguments) {
    QProcess program;
    QProcessEnvironment around = QProcessEnvironment::systemEnvironment();
    for (const char* display : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        around.remove(display);
    around.insert("DISPLAY", ":987");  // where nobody is
    program.setProcessEnvironment(around);
    program.start(QString(kProgramFolder) + "/polyturn-hmi", arguments);
    EXPECT_TRUE(program.waitForFinished(60'000));
    return {program.exitCode(), program.exitStatus() != QProcess::NormalExit,
            QString::fromUtf8(program.readAllStandardOutput()),
            QString::fromUtf8(program.readAllStandardError())};
}

TEST(HmiProgram, PrintsItsHelpWithoutADisplay) {
    for (const char* asked : {"--help", "-h"}) {
        const Said said = call({asked});
        EXPECT_FALSE(said.died);
        EXPECT_EQ(said.status, 0) << said.err.toStdString();
        EXPECT_TRUE(said.out.contains("--instance") && said.out.contains("--full-screen"))
            << said.out.toStdString();
    }
}

TEST(HmiProgram, SaysInOneSentenceThatThereIsNoDisplay) {
    const Said said = call({});
    EXPECT_FALSE(said.died) << said.err.toStdString();
    EXPECT_EQ(said.status, 2);
    EXPECT_EQ(said.err.trimmed().count('\n'), 0) << said.err.toStdString();
    EXPECT_TRUE(said.err.contains("display")) << said.err.toStdString();
    EXPECT_TRUE(said.out.isEmpty());
}

}  // namespace
}  // namespace polyturn::hmi
