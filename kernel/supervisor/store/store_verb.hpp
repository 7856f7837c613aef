// Verbs that ask the store of a running controller (toolmgmt/operations): their words become one
// JSON object, its answer tables for people or, with --json, itself.
#pragma once
#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {
int store_verb(const StoreOptions& options, bool json);
}  // namespace polyturn::supervisor
