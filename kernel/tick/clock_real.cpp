#include "kernel/tick/clock_real.hpp"

#include <sched.h>
#include <sys/mman.h>
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace polyturn::kernel {
namespace {
// above everything of the shop, below the kernel's own interrupt threads
constexpr int kPriority = 80;

std::int64_t now_ns() {
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

// Bucket i counts ticks that computed for up to 2^(i/4) microseconds.
std::size_t bucket(std::int64_t ns, std::size_t buckets) {
    const double us = static_cast<double>(ns) * 1e-3;
    if (us <= 1.0) return 0;
    return std::min(buckets - 1, static_cast<std::size_t>(std::ceil(4.0 * std::log2(us))));
}
}  // namespace

std::string RealClock::claim_real_time() {
    std::string refused;
    sched_param parameter{};
    parameter.sched_priority = kPriority;
    if (sched_setscheduler(0, SCHED_FIFO, &parameter) != 0)
        refused = std::string("SCHED_FIFO: ") + std::strerror(errno);
    if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
        refused += (refused.empty() ? "" : "; ") + std::string("mlockall: ") + std::strerror(errno);
    return refused;
}

void RealClock::supervise() {
    // P3: a flag, announces nothing
    if (alone_.load(std::memory_order_relaxed)) return machine_.left_alone();
    Core& core = machine_.core();
    // P3: a counter, announces nothing (the order is stronger than needed)
    const auto beat = core.supervisor.heartbeat.load(std::memory_order_acquire);
    if (beat != beat_) {
        beat_ = beat;
        beat_tick_ = core.tick;
        silent_ = false;
    }
    const double silent_s = static_cast<double>(core.tick - beat_tick_) * core.config.tick_s;
    if (!silent_ && silent_s > core.config.supervisor_timeout_s) {
        silent_ = true;
        machine_.stop_all(Alarm::SupervisorSilent);
    }
}

void RealClock::run() {
    Core& core = machine_.core();
    std::int64_t due = now_ns();
    while (!machine_.ended()) {
        due += core.config.tick_ns;
        const timespec at{due / 1'000'000'000, static_cast<long>(due % 1'000'000'000)};
        while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) == EINTR) {}
        const std::int64_t began = now_ns();
        if (began - due > core.config.tick_ns) {
            due = began;
            if (++late_in_a_row_ == core.config.late_max_ticks)
                machine_.stop_all(Alarm::TickLate, static_cast<double>(late_in_a_row_));
        } else {
            late_in_a_row_ = 0;
        }
        supervise();
        machine_.tick();
        // P3: a counter, announces nothing
        core.image.tick_cost[bucket(now_ns() - began, core.image.tick_cost.size())].fetch_add(
            1, std::memory_order_relaxed);
        if (SegmentDrives* drives = machine_.segment_drives()) drives->wake();
        if (core.store.rang()) core.image.store_bell.ring();
        if (core.log.newest() != rung_ || core.supervisor.options.trace_every != 0) {
            rung_ = core.log.newest();
            core.image.supervisor_bell.ring();
        }
    }
    core.image.supervisor_bell.ring();
}

}  // namespace polyturn::kernel
