// Waiting for whichever of several doorbells rings first: the supervisor's, the kernel's, and that
// of the disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "ipc/memory/doorbell.hpp"

namespace polyturn::toolmgmt {

struct Watched {
    const Doorbell* bell;
    std::uint32_t seen;  // read before the work was looked for, so that no ring is lost
};

// Returns when one of them differs from what was seen, after `timeout_us`, or spuriously. Systems
// without futex_waitv (before Linux 5.16, some sandboxes) look at all of them every 2 ms instead.
void wait_any(std::span<const Watched> bells, std::int64_t timeout_us);

}  // namespace polyturn::toolmgmt
