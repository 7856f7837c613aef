// How late this computer wakes a cyclic thread: what a machine on it has to live with.
#pragma once
#include <string>
#include <vector>

namespace polyturn::supervisor {

struct Latency {
    double tick_us = 1000;
    std::vector<double> late_us;  // sorted; of each wake-up after its time
    // what the system did not permit of SCHED_FIFO and locked memory; empty: all of it
    std::string refused;
};

// A thread as the kernel's (SCHED_FIFO, locked memory, absolute timer) sleeps tick after tick.
Latency measure_latency(double seconds, double tick_us);
// `polyturn bench latency [SECONDS]`; exit status.
int run_latency(const std::vector<std::string>& arguments);

}  // namespace polyturn::supervisor
