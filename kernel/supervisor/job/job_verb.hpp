// `polyturn job`: what a job brings beside its programs, for a running controller. `diff` tells
// what is entered otherwise, `load` selects the job and enters its zeros and the offsets of its
// setup: what a setup technician does from the sheet, in one command.
#pragma once
#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {
int job_verb(const JobVerbOptions& options);
}  // namespace polyturn::supervisor
