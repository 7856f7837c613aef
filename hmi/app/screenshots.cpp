#include "hmi/app/screenshots.hpp"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <cstdio>

namespace polyturn::hmi {
namespace {

constexpr int kMostWaitMs = 60'000;  // for a dry run

void letRun(int ms) {
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < ms) QApplication::processEvents(QEventLoop::AllEvents, 20);
}

}  // namespace

int saveScreenshots(Choices choices, QSize size, const QString& folder, const QString& only) {
    if (!QDir().mkpath(folder)) {
        std::fprintf(stderr, "polyturn-hmi: cannot make the folder %s\n", qPrintable(folder));
        return 1;
    }
    const auto language = display_language_of(choices.language);
    const std::string dressed = choices.theme;
    MainWindow window(choices);
    window.resize(size);
    window.show();
    letRun(900);  // alarms have come, pictures have been read
    QString dress;
    const auto save = [&](const QString& name) {
        const QString file = QString("%1/%2-%3-%4.png").arg(folder, name, codeOf(spoken()), dress);
        if (window.grab().save(file)) return true;
        std::fprintf(stderr, "polyturn-hmi: cannot write %s\n", qPrintable(file));
        return false;
    };
    for (const DisplayLanguage display_language : kDisplayLanguages) {
        if (!choices.language.empty() && language != display_language) continue;
        window.setDisplayLanguage(display_language);
        for (const bool dark : {true, false}) {
            if (!dressed.empty() && (dressed == "dark") != dark) continue;
            window.setDark(dark);
            dress = dark ? "dark" : "light";
            for (std::size_t i = 0; i < window.screens().size(); ++i) {
                window.showScreen(static_cast<int>(i));
                const QString screen = window.screen()->name();
                if (!screen.startsWith(only.section('-', 0, 0))) continue;
                letRun(60);
                const int pages = window.screen()->pages();
                for (int page = 0; page < pages; ++page) {
                    const QString name = page ? QString("%1-%2").arg(screen).arg(page + 1) : screen;
                    if (only.contains('-') && name != only) continue;
                    window.screen()->turnTo(page);
                    letRun(60);
                    for (int waited = 0; window.screen()->busy() && waited < kMostWaitMs;
                         waited += 100)
                        letRun(100);
                    letRun(40);
                    if (!save(name)) return 1;
                }
                window.screen()->turnTo(0);
            }
            window.showScreen(0);
            for (const auto& [over, name] : MainWindow::kOvers) {
                if (!QString(name).startsWith(only) || !window.showOver(over)) continue;
                letRun(300);  // a page of the manual is laid out piece by piece
                if (!save(name)) return 1;
            }
            window.showOver(MainWindow::Over::Screen);
        }
    }
    return 0;
}

}  // namespace polyturn::hmi
