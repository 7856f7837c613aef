// Limits of spindle speeds that end with the program (REDEF ... PRLOC).
#pragma once
#include <vector>

#include "ipc/params/registry.hpp"

namespace polyturn::channels::sinumerik {

struct SpeedLimitState {
    std::vector<const params::Row*> program_local;
};

}  // namespace polyturn::channels::sinumerik
