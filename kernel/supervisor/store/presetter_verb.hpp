// `polyturn presetter`: asks polyturn-presetter what a picture shows, and proposes it as an offset
// of a running controller.
#pragma once
#include <string>

#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {

int presetter_verb(const StoreOptions& options, const std::string& instance, bool json);

}  // namespace polyturn::supervisor
