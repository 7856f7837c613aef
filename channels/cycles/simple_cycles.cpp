#include "channels/cycles/simple_cycles.hpp"

#include <cmath>
#include <numbers>

#include "channels/cycles/cycle_moves.hpp"
#include "channels/cycles/thread_passes.hpp"

namespace polyturn::channels::cycles {
namespace {

struct Places {
    unsigned x = 0, z = 0;
};

bool find_places(Core& core, Places& places) {
    const int x = core.view().axis_by_role(PlaneRole::BasicX),
              z = core.view().axis_by_role(PlaneRole::BasicZ);
    if (x < 0 || z < 0) return core.fail(Alarm::PlaneAxisMissing, 'G');
    places = {static_cast<unsigned>(x), static_cast<unsigned>(z)};
    return true;
}

// What the nose adds to the ends of an oblique cut must leave the ways to and from it their
// directions (fanuc_lathe 3.20; 3.14, first criterion). Not a number: no such place exists, the cut
// runs along the axis on which its ends would move.
bool turns_back(double way, double added) { return !(way * (way + added) >= 0); }

// Each leg is driven so that the imaginary tip runs on it; only an oblique cut is shifted to its
// equidistant.
class CompensatedCycle {
public:
    CompensatedCycle(Core& core, Core::CycleMoves how) : core_(&core) { core.begin_cycle(how); }
    ~CompensatedCycle() { core_->end_cycle(); }
    CompensatedCycle(const CompensatedCycle&) = delete;
    CompensatedCycle& operator=(const CompensatedCycle&) = delete;

private:
    Core* core_;
};

}  // namespace

bool turning(Core& core, const SimpleCycle& cycle) {
    Places at;
    if (!find_places(core, at)) return false;
    const AxisValues start = core.path.programmed;
    AxisValues point = start;
    AxisValues end = cycle.end;
    point[at.x] = end[at.x] + cycle.taper;
    const CompensatedCycle nose(core, Core::CycleMoves::Plain);
    if (cycle.taper != 0) {
        const double shift = core.cut_shift(point, end, at.x, start);
        if (turns_back(point[at.x] - start[at.x], shift) ||
            turns_back(end[at.x] - start[at.x], shift))
            return core.fail(Alarm::CompCycleOvercut, 'R');
        point[at.x] += shift;
        end[at.x] += shift;
    }
    if (!core.rapid(point)) return false;
    if (!core.linear(end)) return false;
    point = end;
    point[at.x] = start[at.x];
    return core.linear(point) && core.rapid(start);
}

bool facing(Core& core, const SimpleCycle& cycle) {
    Places at;
    if (!find_places(core, at)) return false;
    const AxisValues start = core.path.programmed;
    AxisValues point = start;
    AxisValues end = cycle.end;
    point[at.z] = end[at.z] + cycle.taper;
    const CompensatedCycle nose(core, Core::CycleMoves::Plain);
    if (cycle.taper != 0) {
        const double shift = core.cut_shift(point, end, at.z, start);
        if (turns_back(point[at.z] - start[at.z], shift) ||
            turns_back(end[at.z] - start[at.z], shift))
            return core.fail(Alarm::CompCycleOvercut, 'R');
        point[at.z] += shift;
        end[at.z] += shift;
    }
    if (!core.rapid(point)) return false;
    if (!core.linear(end)) return false;
    point = end;
    point[at.z] = start[at.z];
    return core.linear(point) && core.rapid(start);
}

bool thread(Core& core, const SimpleCycle& cycle) {
    Places at;
    if (!find_places(core, at)) return false;
    const AxisValues start = core.path.programmed;
    AxisValues point = start;
    point[at.x] = cycle.end[at.x] + cycle.taper;
    const CompensatedCycle nose(core, Core::CycleMoves::Shifted);
    if (!core.rapid(point)) return false;
    const double dz = cycle.end[at.z] - point[at.z], dx = cycle.end[at.x] - point[at.x];
    const double run_out = std::fmin(cycle.chamfer, std::fabs(dz));
    ThreadCall pass = cycle.thread;
    withdraw_to(pass, at.x, start[at.x], point[at.x], cycle.end[at.x]);
    if (run_out > 0) {
        // The last part of the thread leaves the work towards the start diameter.
        const double share = (std::fabs(dz) - run_out) / std::fabs(dz);
        AxisValues leave = cycle.end;
        leave[at.z] = point[at.z] + dz * share;
        leave[at.x] = point[at.x] + dx * share;
        if (share > 0 && !thread_stroke(core, leave, pass)) return false;
        const double lift = run_out * std::tan(cycle.chamfer_angle * std::numbers::pi / 180.0);
        const double away = start[at.x] - leave[at.x];
        AxisValues out = cycle.end;
        out[at.x] = leave[at.x] + std::copysign(std::fmin(lift, std::fabs(away)), away);
        ThreadCall call = pass;  // the lead still counts along Z
        call.by_axis = true;
        call.axis = static_cast<std::uint8_t>(at.z);
        if (!thread_stroke(core, out, call)) return false;
    } else if (!thread_stroke(core, cycle.end, pass)) {
        return false;
    }
    point = core.path.programmed;
    point[at.x] = start[at.x];
    return core.rapid(point) && core.rapid(start);
}

}  // namespace polyturn::channels::cycles
