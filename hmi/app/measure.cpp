#include "hmi/app/measure.hpp"

#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <algorithm>
#include <cstdio>
#include <functional>

#include "hmi/app/help_view.hpp"

namespace polyturn::hmi {
namespace {

constexpr double kMostCpu_percent = 15, kMostBlock_ms = 50, kMostFirst_ms = 1000;
constexpr double kLeastFrames = 55;  // a second: sixty, less the grain of letRun()
constexpr double kMostWait_s = 60;   // for what a page makes first: a dry run

double cpuSeconds() {
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

// Since the operating system has started this process.
double sinceStart_ms() {
    QFile file("/proc/self/stat");
    if (!file.open(QIODevice::ReadOnly)) return 0;
    const QByteArray text = file.readAll();
    const auto fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    return (static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 -
            fields.value(19).toDouble() / static_cast<double>(::sysconf(_SC_CLK_TCK))) *
           1e3;
}

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

// Everything that is due is done at a stretch: for so long a touch waits. The thread's own time
// beside it tells a busy screen from a busy computer.
struct Longest {
    double block_ms = 0, computing_ms = 0;
    void add(const Longest& other) {
        block_ms = std::max(block_ms, other.block_ms);
        computing_ms = std::max(computing_ms, other.computing_ms);
    }
};

Longest letRun(double seconds) {
    Longest out;
    QElapsedTimer time, one;
    time.start();
    while (static_cast<double>(time.elapsed()) < seconds * 1e3) {
        const double before = threadSeconds();
        one.start();
        QApplication::processEvents(QEventLoop::AllEvents);
        out.block_ms = std::max(out.block_ms, static_cast<double>(one.nsecsElapsed()) * 1e-6);
        out.computing_ms = std::max(out.computing_ms, (threadSeconds() - before) * 1e3);
        ::usleep(2'000);
    }
    return out;
}

// How long a touch waits while the page comes, and what it costs when it stands there. False: more
// than is allowed.
bool measurePage(MainWindow& window, const char* name, int page, double seconds,
                 const std::function<void()>& show) {
    const double before = threadSeconds();
    show();
    window.frame();
    const double opening_ms = (threadSeconds() - before) * 1e3;
    Longest longest = letRun(0.3);
    QElapsedTimer time;
    time.start();
    // a long page is laid out piece by piece
    const auto made = [&] {
        return !window.screen()->busy() && (!window.help().isVisible() || window.help().complete());
    };
    while (!made() && static_cast<double>(time.elapsed()) < kMostWait_s * 1e3)
        longest.add(letRun(0.1));
    const double cpu = cpuSeconds();
    const std::uint64_t frames = window.frames();
    time.start();
    longest.add(letRun(seconds));
    const double wall = static_cast<double>(time.nsecsElapsed()) * 1e-9,
                 percent = 100 * (cpuSeconds() - cpu) / wall,
                 rate = static_cast<double>(window.frames() - frames) / wall;
    const bool good = percent <= kMostCpu_percent && rate >= kLeastFrames &&
                      longest.computing_ms <= kMostBlock_ms && opening_ms <= kMostBlock_ms;
    std::printf(
        "{\"screen\":\"%s\",\"page\":%d,\"frames_per_s\":%.1f,\"cpu_percent\":%.1f,"
        "\"opening_ms\":%.1f,\"longest_block_ms\":%.1f,\"longest_computing_ms\":%.1f,"
        "\"good\":%s}\n",
        name, page + 1, rate, percent, opening_ms, longest.block_ms, longest.computing_ms,
        good ? "true" : "false");
    std::fflush(stdout);
    return good;
}

}  // namespace

int measureScreens(const Choices& choices, QSize size, double seconds) {
    MainWindow window(choices);
    window.resize(size);
    window.show();
    QApplication::processEvents();
    window.grab();  // painted
    const double first_ms = sinceStart_ms();
    bool good = first_ms <= kMostFirst_ms;
    std::printf("{\"first_screen_ms\":%.0f}\n", first_ms);
    letRun(0.5);
    for (std::size_t i = 0; i < window.screens().size(); ++i) {
        window.showScreen(static_cast<int>(i));
        letRun(0.3);
        const int pages = window.screen()->pages();
        for (int page = 0; page < pages; ++page)
            good &= measurePage(window, window.screen()->name(), page, seconds,
                                [&] { window.screen()->turnTo(page); });
        window.screen()->turnTo(0);
    }
    window.showScreen(0);
    for (const auto& [over, name] : MainWindow::kOvers)
        if (window.showOver(over))
            good &=
                measurePage(window, name, 0, seconds, [&, over = over] { window.showOver(over); });
    window.showOver(MainWindow::Over::Screen);
    HelpView help(&window);
    help.resize(window.size());
    help.show();
    for (const QString& page : QDir(HelpView::folder()).entryList({"*.md"}, QDir::Files)) {
        HelpTopic topic;
        topic.page = page;
        topic.find = "G1";
        const double before = threadSeconds();
        help.open(topic);
        help.grab();
        const double computing_ms = (threadSeconds() - before) * 1e3;
        std::printf("{\"help\":\"%s\",\"computing_ms\":%.1f}\n", qPrintable(page), computing_ms);
        good &= computing_ms <= kMostBlock_ms;
    }
    return good ? 0 : 1;
}

}  // namespace polyturn::hmi
