// `polyturn params`: the parameters of a machine file, or of a running controller (--instance).
#pragma once
#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {
int params_verb(const ParamsOptions& options);
}
