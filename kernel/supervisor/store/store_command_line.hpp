// The verbs that ask the store, as the command line reads them.
#pragma once
#include "kernel/supervisor/base/options.hpp"

namespace CLI {
class App;
}

namespace polyturn::supervisor {
void add_store_verbs(CLI::App& app, CommandLine& line);
}  // namespace polyturn::supervisor
