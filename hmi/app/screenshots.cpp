#include "hmi/app/screenshots.hpp"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <cstdio>

namespace polyturn::hmi {
namespace {

constexpr int kMostWaitMs = 60'000;   // for a dry run

void letRun(int ms) {
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < ms) QApplication::processEvents(QEventLoop::AllEvents, 20);
}

}  // namespace

int saveScreenshots(Choices choices, QSize size, const QString& folder) {
    if (!QDir().mkpath(folder)) {
        std::fprintf(stderr, "polyturn-hmi: cannot make the folder %s\n", qPrintable(folder));
        return 1;
    }
    const auto language = tongue_of(choices.language);
    const std::string dressed = choices.theme;
    MainWindow window(choices);
    window.resize(size);
    window.show();
    letRun(900);   // alarms have come, pictures have been read
    for (const Tongue tongue : kTongues) {
        if (!choices.language.empty() && language != tongue) continue;
        window.setTongue(tongue);
        for (const bool dark : {true, false}) {
            if (!dressed.empty() && (dressed == "dark") != dark) continue;
            window.setDark(dark);
            for (std::size_t i = 0; i < window.screens().size(); ++i) {
                window.showScreen(static_cast<int>(i));
                const int pages = window.screen()->pages();
                for (int page = 0; page < pages; ++page) {
                    window.screen()->turnTo(page);
                    letRun(60);
                    for (int waited = 0; window.screen()->busy() && waited < kMostWaitMs; waited += 100) letRun(100);
                    letRun(40);
                    const QString number = page ? QString("-%1").arg(page + 1) : QString();
                    const QString file = QString("%1/%2%3-%4-%5.png").arg(folder, window.screen()->name(), number, codeOf(tongue), dark ? "dark" : "light");
                    if (window.grab().save(file)) continue;
                    std::fprintf(stderr, "polyturn-hmi: cannot write %s\n", qPrintable(file));
                    return 1;
                }
                window.screen()->turnTo(0);
            }
        }
    }
    return 0;
}

}  // namespace polyturn::hmi
