#include "kernel/supervisor/status/latency.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <sys/mman.h>
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <thread>

namespace polyturn::supervisor {
namespace {

constexpr int kPriority = 80;  // as the kernel's cyclic thread has
constexpr double kUsualSeconds = 10.0;

long long now_ns() {
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<long long>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

double at_share(const std::vector<double>& sorted, double share) {
    return sorted.empty()
               ? 0.0
               : sorted[std::min(
                     sorted.size() - 1,
                     static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

}  // namespace

Latency measure_latency(double seconds, double tick_us) {
    Latency out;
    out.tick_us = tick_us;
    const auto ticks = static_cast<std::size_t>(seconds * 1e6 / tick_us);
    out.late_us.assign(ticks, 0.0);
    std::thread cyclic([&] {
        sched_param parameter{};
        parameter.sched_priority = kPriority;
        if (sched_setscheduler(0, SCHED_FIFO, &parameter) != 0)
            out.refused = std::string("SCHED_FIFO: ") + std::strerror(errno);
        if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
            out.refused += (out.refused.empty() ? "" : "; ") + std::string("mlockall: ") +
                           std::strerror(errno);
        const auto step = static_cast<long long>(tick_us * 1e3);
        long long due = now_ns();
        for (double& late : out.late_us) {
            due += step;
            const timespec at{due / 1'000'000'000, static_cast<long>(due % 1'000'000'000)};
            while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) == EINTR) {}
            const long long woke = now_ns();
            late = static_cast<double>(woke - due) * 1e-3;
            if (woke - due > step) due = woke;  // a late tick never becomes two
        }
        munlockall();
    });
    cyclic.join();
    std::sort(out.late_us.begin(), out.late_us.end());
    return out;
}

int run_latency(const std::vector<std::string>& arguments) {
    double seconds = kUsualSeconds;
    for (const std::string& word : arguments) {
        const auto end = std::from_chars(word.data(), word.data() + word.size(), seconds);
        if (end.ec != std::errc() || end.ptr != word.data() + word.size() || !(seconds > 0) ||
            seconds > 86'400) {
            fmt::print(stderr, "polyturn: bench latency [SECONDS], not '{}'\n", word);
            return 2;
        }
    }
    const Latency measured = measure_latency(seconds, 1000.0);
    const auto& late = measured.late_us;
    const auto missed = static_cast<std::size_t>(
        late.end() - std::upper_bound(late.begin(), late.end(), measured.tick_us));
    fmt::print("real time: {}\n",
               measured.refused.empty()
                   ? "SCHED_FIFO and locked memory"
                   : "not permitted (" + measured.refused + "): an ordinary thread was measured");
    fmt::print(
        "wake-ups of a 1 ms tick over {:.0f} s, microseconds late: median {:.1f}, 99 % {:.1f}, "
        "99.9 % {:.1f}, worst {:.1f}\n",
        seconds, at_share(late, 0.5), at_share(late, 0.99), at_share(late, 0.999),
        late.empty() ? 0.0 : late.back());
    fmt::print("{} of {} ticks were missed (later than a whole tick)\n", missed, late.size());
    return 0;
}

}  // namespace polyturn::supervisor
