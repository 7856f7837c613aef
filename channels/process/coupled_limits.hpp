// Limits of an axis while others are coupled to it (nct part 2 22.2, 22.5): a master goes no
// faster than its synchronous slaves can; an axis and what is superimposed on it share the slave's
// limits, half each, whichever of them moves. Taken at barriers, like all limits; the M codes that
// switch couplings are between waits of both channels (22.1).
#pragma once
#include <array>
#include <compare>
#include <cstdint>

#include "channels/path/path_limits.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::channels {

// By machine axis (from 0): its master (from 1), 0 none.
struct Couplings {
    std::array<std::uint8_t, kMaxAxes> synchronous{}, superimposed{};
    friend bool operator==(const Couplings&, const Couplings&) = default;
};

Couplings couplings_of(const MachineStatus& status);
void lower_for_couplings(PathLimits& limits, const Couplings& couplings);

}  // namespace polyturn::channels
