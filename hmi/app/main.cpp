// polyturn-hmi: the screens of one controller.
#include <unistd.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QFile>
#include <QScreen>
#include <QStandardPaths>
#include <QTextStream>
#include <cstdio>

#include "hmi/app/main_window.hpp"
#include "hmi/app/measure.hpp"
#include "hmi/app/screenshots.hpp"
#include "hmi/machine/tools/computer_settings.hpp"

namespace {

// Qt ends the program by force where it finds no display: a core, and an advice to install things
// again that are there.
void sayThereIsNoDisplay(QtMsgType type, const QMessageLogContext&, const QString&) {
    if (type != QtFatalMsg) return;  // what was tried
    std::fputs(
        "polyturn-hmi: there is no display to open; start it on the panel's desktop, or say "
        "with DISPLAY, WAYLAND_DISPLAY or QT_QPA_PLATFORM which one.\n",
        stderr);
    ::_exit(2);
}

}  // namespace

int main(int argc, char** argv) {
    // A panel without a display server reads its keyboard itself, and xkbcommon takes the layout
    // from the environment.
    if (QFile keyboard("/etc/default/keyboard");
        qEnvironmentVariableIsEmpty("XKB_DEFAULT_LAYOUT") && keyboard.open(QIODevice::ReadOnly))
        if (const QString layout =
                polyturn::hmi::layoutIn(QString::fromUtf8(keyboard.read(1 << 16)));
            !layout.isEmpty())
            qputenv("XKB_DEFAULT_LAYOUT", layout.toUtf8());
    QCommandLineParser parser;
    parser.setApplicationDescription("Polyturn: the screens of one controller.");
    parser.addHelpOption();
    parser.addOptions(
        {{"instance", "the controller to show", "NAME", "polyturn"},
         {"lang", "en, ru, cs or hu", "LANGUAGE"},
         {"theme", "dark or light", "THEME"},
         {"size", "of the window, for example 1280x800", "WxH", "1280x800"},
         {"full-screen", "without a frame, on the whole panel"},
         {"screenshots",
          "save a picture of each screen, in each language and theme, in DIR and end", "DIR"},
         {"only", "of the pictures those whose name begins so, or one page: offsets, diagnosis-7",
          "NAME"},
         {"measure", "show each screen for so long, print what it costs, and end", "SECONDS"}});
    QStringList words;
    for (int i = 0; i < argc; ++i) words << QString::fromLocal8Bit(argv[i]);
    if ((void)parser.parse(words); parser.isSet("help")) {  // without a display too
        const QCoreApplication named(argc, argv);
        QTextStream(stdout) << parser.helpText();
        return 0;
    }
    const auto before = qInstallMessageHandler(sayThereIsNoDisplay);
    QApplication app(argc, argv);
    qInstallMessageHandler(before);
    QApplication::setApplicationName("polyturn-hmi");
    parser.process(app);
    polyturn::hmi::Choices choices;
    choices.instance = parser.value("instance").toStdString();
    choices.language = parser.value("lang").toStdString();
    choices.theme = parser.value("theme").toStdString();
    const auto wrong = [](const QString& what) {
        std::fprintf(stderr, "polyturn-hmi: %s\n", qPrintable(what));
        return 2;
    };
    if (!polyturn::valid_instance(choices.instance))
        return wrong(QString("%1 is no name of a controller").arg(parser.value("instance")));
    if (!choices.language.empty() && !polyturn::display_language_of(choices.language))
        return wrong("--lang is en, ru, cs or hu");
    if (!choices.theme.empty() && choices.theme != "dark" && choices.theme != "light")
        return wrong("--theme is dark or light");
    const QStringList size = parser.value("size").split('x');
    if (size.size() != 2 || size[0].toInt() < 600 || size[1].toInt() < 480 ||
        size[0].toInt() > 7680 || size[1].toInt() > 4320)
        return wrong("--size is at least 600x480");
    const QSize wanted(size[0].toInt(), size[1].toInt());
    if (parser.isSet("screenshots"))
        return polyturn::hmi::saveScreenshots(choices, wanted, parser.value("screenshots"),
                                              parser.value("only"));
    if (parser.isSet("measure")) {
        const double seconds = parser.value("measure").toDouble();
        if (!(seconds >= 0.5 && seconds <= 3600)) return wrong("--measure is 0.5 to 3600 seconds");
        return polyturn::hmi::measureScreens(choices, wanted, seconds);
    }
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + "/polyturn";
    QDir().mkpath(folder);
    choices.keptIn = folder + "/hmi-" + QString::fromStdString(choices.instance) + ".ini";
    // The paths of the running part change all the time: in memory, where the computer has such a
    // folder.
    if (const QString passing = QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation);
        !passing.isEmpty())
        choices.passingIn = passing + "/polyturn-hmi-" + QString::fromStdString(choices.instance);
    polyturn::hmi::MainWindow window(choices);
    window.resize(wanted);
    if (parser.isSet("full-screen")) {
        // without a window manager nothing else makes it so large
        window.setGeometry(QGuiApplication::primaryScreen()->geometry());
        window.showFullScreen();
    } else
        window.show();
    window.activateWindow();  // where no window manager gives the keyboard to it
    return app.exec();
}
