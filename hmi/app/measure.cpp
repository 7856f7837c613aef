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

#include "hmi/app/help_view.hpp"

namespace polyturn::hmi {
namespace {

constexpr double kMostCpu_percent = 15, kMostBlock_ms = 50, kMostFirst_ms = 1000;

double cpuSeconds() {
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6; };
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
    return (static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 - fields.value(19).toDouble() / static_cast<double>(::sysconf(_SC_CLK_TCK))) * 1e3;
}

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

// Everything that is due is done at a stretch: for so long a touch waits. The thread's own time beside it tells a busy screen from a busy
// computer.
struct Longest {
    double block_ms = 0, computing_ms = 0;
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

}  // namespace

int measureScreens(const Choices& choices, QSize size, double seconds) {
    MainWindow window(choices);
    window.resize(size);
    window.show();
    QApplication::processEvents();
    window.grab();   // painted
    const double first_ms = sinceStart_ms();
    bool good = first_ms <= kMostFirst_ms;
    std::printf("{\"first_screen_ms\":%.0f}\n", first_ms);
    letRun(0.5);
    for (std::size_t i = 0; i < window.screens().size(); ++i) {
        window.showScreen(static_cast<int>(i));
        letRun(0.3);
        const double cpu = cpuSeconds();
        const std::uint64_t frames = window.frames();
        QElapsedTimer time;
        time.start();
        const Longest longest = letRun(seconds);
        const double wall = static_cast<double>(time.nsecsElapsed()) * 1e-9, percent = 100 * (cpuSeconds() - cpu) / wall;
        std::printf("{\"screen\":\"%s\",\"frames_per_s\":%.1f,\"cpu_percent\":%.1f,\"longest_block_ms\":%.1f,\"longest_computing_ms\":%.1f}\n", window.screen()->name(), static_cast<double>(window.frames() - frames) / wall, percent,
                    longest.block_ms, longest.computing_ms);
        std::fflush(stdout);
        good &= percent <= kMostCpu_percent && longest.computing_ms <= kMostBlock_ms;
    }
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
