// The active G command of each group, by its number (MD20150, $P_GG).
#pragma once
#include <cstdint>

#include "channels/sinumerik/execution.hpp"

namespace polyturn::channels::sinumerik {

inline unsigned active(const Execution& x, unsigned group) { return x.modal.active[group]; }
inline void activate(Execution& x, unsigned group, unsigned number) {
    x.modal.active[group] = static_cast<std::uint8_t>(number);
}

}  // namespace polyturn::channels::sinumerik
