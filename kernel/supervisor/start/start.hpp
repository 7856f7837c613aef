// `polyturn start`: a controller in the foreground until SIGTERM or SIGINT. Watches its processes,
// restarts what dies, answers requests of short-lived programs.
#pragma once
#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {
int start_controller(const StartOptions& options);
}
