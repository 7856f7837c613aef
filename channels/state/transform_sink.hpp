// Between Core (or compensation) and the machine while a transformation is on: tells each move with the coordinates of the axes
// beside its own, and decides what the polar plane leaves open.
//
//        .---.          A line through the pole is driven with the rotary axis at rest where the linear axis may go on to the
//   A --(--o--)-- B     other side; where it may not, in three moves: to the pole, the rotary axis by itself, on from the pole.
//        '---'          A line that begins in the pole has its rotary axis turned first, by the shorter way of what is possible.
//
// Invariant: axes() is where the axes are behind the move told last; a move begins there.
#pragma once
#include "channels/machine_view.hpp"
#include "channels/state/transformation.hpp"
#include "ipc/kinematics/polar.hpp"

namespace polyturn::channels {

class TransformSink final : public Sink {
public:
    TransformSink(const MachineView& view, const Transformation& transformation) : view_(&view), transformation_(&transformation) {}
    void next(Sink& next) { next_ = &next; }

    AxisValues& axes() { return axes_; }                 // address coordinates of the axes, real ones
    bool failed() const { return failed_; }
    double failed_at() const { return failed_at_; }      // mm from the pole
    void forget_failure() { failed_ = false; }

    void move(const Move& m, const BlockContext& at) override;
    void dwell(const Dwell& d, const BlockContext& at) override { next_->dwell(d, at); }
    void aux(const Aux& a, const BlockContext& at) override { next_->aux(a, at); }
    void spindle(const Spindle& s, const BlockContext& at) override;
    void wait(const Wait& w, const BlockContext& at) override { next_->wait(w, at); }
    void variable(const Variable& v, const BlockContext& at) override { next_->variable(v, at); }
    void offset(const OffsetWrite& o, const BlockContext& at) override { next_->offset(o, at); }
    void message(std::string_view text, const BlockContext& at) override { next_->message(text, at); }
    void stop(const Stop& s, const BlockContext& at) override { next_->stop(s, at); }
    void part(double count, const BlockContext& at) override { next_->part(count, at); }
    void alarm(const Diagnosis& d, const BlockContext& at) override { next_->alarm(d, at); }
    void interrupts(const Interrupts& i, const BlockContext& at) override { next_->interrupts(i, at); }
    void print(std::string_view text, const BlockContext& at) override { next_->print(text, at); }
    void signal(std::string_view name, double value, const BlockContext& at) override { next_->signal(name, value, at); }
    void barrier(const BlockContext& at) override { next_->barrier(at); }
    void block_end(const BlockContext& at) override { next_->block_end(at); }

private:
    void polar(const BlockContext& at);
    void through_pole(const BlockContext& at, PlanePoint a, PlanePoint b, double pole_at);
    void turn_in_pole(const BlockContext& at, double degrees);
    void deliver(const BlockContext& at);
    bool may_stand(double from_pole) const;
    bool fail(double distance);
    void show_degrees();

    Sink* next_ = nullptr;
    const MachineView* view_;
    const Transformation* transformation_;
    AxisValues axes_{};
    Move out_;
    bool failed_ = false;
    double failed_at_ = 0;
};

}  // namespace polyturn::channels
