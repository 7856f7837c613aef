// The scope: up to eight signals at every tick, for the screens. Nobody consumes the ring: the
// oldest samples are overwritten, so a late screen misses some and the machine never waits for it.
// Nothing is written while no trace is chosen.
#pragma once
#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

class Scope {
public:
    // From the next sample on; an object that does not exist, or an unknown kind, reads 0.
    void choose(KernelSegment& image, std::uint32_t trace, ScopeKind kind,
                std::uint32_t object) noexcept;
    // Behind the status of the tick, which is what is recorded.
    void sample(Core& core, const MachineStatus& status) noexcept;

private:
    ScopeChoice choice_{};
    bool any_ = false;
};

// When a coupling or an exchange last changed, and the M code that was executed then.
struct CoupledSince {
    std::uint32_t master = 0, added = 0, route = 0;
    std::int64_t since = 0;
    std::int32_t code = -1;
    std::uint32_t channel = 0;
};

}  // namespace polyturn::kernel
