// Between Core (or compensation) and the machine while a transformation is on: gives each move the
// coordinates of the axes in addition to its own, and decides what the polar plane leaves open.
//
//        .---.          A line through the pole is driven with the rotary axis at rest where the
//   A --(--o--)-- B     linear axis may continue to the other side; where it may not, in three
//        '---'          moves: to the pole, the rotary axis by itself, on from the pole.
//
// Before a line that begins in the pole the rotary axis is turned, in the shorter of the possible
// directions.
//
// Invariant: axes() is where the axes are behind the last move; a move begins there.
#pragma once
#include "channels/forwarding_sink.hpp"
#include "channels/machine_view.hpp"
#include "channels/state/transformation.hpp"
#include "ipc/kinematics/polar.hpp"

namespace polyturn::channels {

class TransformSink final : public ForwardingSink {
public:
    TransformSink(const MachineView& view, const Transformation& transformation)
        : ForwardingSink(nullptr), view_(&view), transformation_(&transformation) {}
    void next(Sink& next) { next_ = &next; }

    // address coordinates of the axes, real ones
    AxisValues& axes() { return axes_; }
    bool failed() const { return failed_; }
    double failed_at() const { return failed_at_; }  // mm from the pole
    void forget_failure() { failed_ = false; }

    void move(const Move& m, const BlockContext& at) override;
    void spindle(const Spindle& s, const BlockContext& at) override;

private:
    void polar(const BlockContext& at);
    void through_pole(const BlockContext& at, PlanePoint a, PlanePoint b, double pole_at);
    void turn_in_pole(const BlockContext& at, double degrees);
    void deliver(const BlockContext& at);
    bool may_stand(double from_pole) const;
    bool fail(double distance);
    void show_degrees();

    const MachineView* view_;
    const Transformation* transformation_;
    AxisValues axes_{};
    Move out_;
    bool failed_ = false;
    double failed_at_ = 0;
};

}  // namespace polyturn::channels
