// The moves of a cycle in the plane Z X, given to Core: compensation shifts them as a whole
// (fanuc_lathe 3.20).
#pragma once
#include <utility>

#include "channels/cycles/contour.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

// A stroke of a pass. The strokes of one are joined under G61 too: behind an exact stop a thread
// begins anew.
inline bool thread_stroke(Core& core, const AxisValues& to, const ThreadCall& call) {
    const bool exact = std::exchange(core.path.exact_stop_mode, false);
    const bool good = core.thread(to, call);
    core.path.exact_stop_mode = exact;
    return good;
}

class CycleMoves {
public:
    explicit CycleMoves(Core& core) : core_(&core) {
        int z = core.view().axis_by_role(PlaneRole::BasicZ),
            x = core.view().axis_by_role(PlaneRole::BasicX);
        // a plane of any two axes: abscissa and ordinate take their parts
        if (core.path.plane_p >= 0) core.plane_axes(z, x);
        if (z < 0 || x < 0) return;
        z_ = static_cast<unsigned>(z);
        x_ = static_cast<unsigned>(x);
        ready_ = true;
        core.begin_cycle(Core::CycleMoves::Shifted);
    }
    ~CycleMoves() {
        if (ready_) core_->end_cycle();
    }
    CycleMoves(const CycleMoves&) = delete;
    CycleMoves& operator=(const CycleMoves&) = delete;

    bool ready() { return ready_ || core_->fail(Alarm::PlaneAxisMissing, 'G'); }
    Core& core() { return *core_; }
    unsigned z() const { return z_; }
    unsigned x() const { return x_; }
    Point here() const { return {core_->path.programmed[z_], core_->path.programmed[x_]}; }
    bool rapid(Point to) { return core_->rapid(target(to)); }
    bool linear(Point to) { return core_->linear(target(to)); }
    bool thread(Point to, const ThreadCall& call) {
        return thread_stroke(*core_, target(to), call);
    }
    bool arc(Point to, Point centre, bool clockwise, double tolerance) {
        ArcCall call;
        call.clockwise = clockwise;
        call.centre_p = centre.z;
        call.centre_q = centre.x;
        call.tolerance = tolerance;
        return core_->arc(target(to), call);
    }

private:
    AxisValues target(Point to) const {
        AxisValues values = core_->path.programmed;
        values[z_] = to.z;
        values[x_] = to.x;
        return values;
    }
    Core* core_;
    unsigned z_ = 0, x_ = 0;
    bool ready_ = false;
};

}  // namespace polyturn::channels::cycles
