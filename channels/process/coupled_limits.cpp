#include "channels/process/coupled_limits.hpp"

#include <algorithm>

namespace polyturn::channels {
namespace {

void lower(double& value, double limit) { value = std::min(value, limit); }
// A limit that is switched off (0) does not count.
void lower_ceiling(double& value, double limit) {
    if (limit > 0) value = value > 0 ? std::min(value, limit) : limit;
}

void lower(PathAxis& master, const PathAxis& slave) {
    lower(master.rapid, slave.rapid);
    lower(master.feed, slave.feed);
    lower(master.accel, slave.accel);
    lower(master.normal, slave.normal);
    lower(master.jerk, slave.jerk);
    lower_ceiling(master.speed_step, slave.speed_step);
    lower_ceiling(master.accel_step, slave.accel_step);
    lower_ceiling(master.accel_step_arc, slave.accel_step_arc);
}

void halve(PathAxis& axis) {
    for (double* value : {&axis.rapid, &axis.feed, &axis.accel, &axis.normal, &axis.jerk,
                          &axis.speed_step, &axis.accel_step, &axis.accel_step_arc})
        *value *= 0.5;
}

}  // namespace

Couplings couplings_of(const MachineStatus& status) {
    Couplings found;
    for (std::size_t a = 0; a < kMaxAxes; ++a) {
        found.synchronous[a] = static_cast<std::uint8_t>(status.axes[a].master);
        found.superimposed[a] = static_cast<std::uint8_t>(status.axes[a].added_master);
    }
    return found;
}

void lower_for_couplings(PathLimits& limits, const Couplings& couplings) {
    // First what may reach each drive in all: a superimposed slave leaves its master half of that.
    // The last slave's limit reaches the first master after as many passes as the chain has links.
    bool changed = true;
    for (std::size_t pass = 0; changed && pass < kMaxAxes; ++pass) {
        changed = false;
        for (std::size_t a = 0; a < kMaxAxes; ++a)
            for (const bool adds : {false, true}) {
                const std::uint8_t m = adds ? couplings.superimposed[a] : couplings.synchronous[a];
                if (!m || m > kMaxAxes) continue;
                PathAxis& master = limits.axis[m - 1u];
                PathAxis slave = limits.axis[a];
                if (adds) halve(slave);
                const double before = master.rapid + master.feed + master.accel + master.normal;
                lower(master, slave);
                changed =
                    changed || master.rapid + master.feed + master.accel + master.normal != before;
            }
    }
    // Then what its own program may take of it.
    for (std::size_t a = 0; a < kMaxAxes; ++a)
        if (couplings.superimposed[a]) halve(limits.axis[a]);
}

}  // namespace polyturn::channels
