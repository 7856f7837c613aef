// A machine on which one axis is inclined to another one: a sink behind compensation that turns moves of the cartesian axes
// into moves of the real ones (fagor G46).
//
//   X' = (X - o) / cos a + o        X  cartesian, X' along the inclined axis, o origin of the transformation
//   Z' = Z - (X - o) tan a          a  angle between X and X'
//
// A straight way stays straight. An arc becomes a piece of an ellipse: it is driven in chords that deviate by `tolerance`.
#pragma once
#include "channels/machine_view.hpp"

namespace polyturn::channels {

class InclinedAxis final : public Sink {
public:
    InclinedAxis(Sink& next, const MachineView& view) : next_(&next), view_(&view) {}

    void configure(unsigned inclined, unsigned orthogonal, double degrees, double origin);
    void activate(bool on) { active_ = on; }
    bool active() const { return active_; }
    void to_real(AxisValues& values) const;         // cartesian -> real machine coordinates
    void to_cartesian(AxisValues& values) const;
    double tangent() const { return tangent_; }
    bool failed() const { return failed_; }         // a real axis would leave its stroke; that move was not passed on
    unsigned failed_axis() const { return failed_axis_; }
    double failed_at() const { return failed_at_; }
    void reset() { failed_ = false; }

    void move(const Move&, const BlockContext&) override;
    void dwell(const Dwell& d, const BlockContext& at) override { next_->dwell(d, at); }
    void aux(const Aux& a, const BlockContext& at) override { next_->aux(a, at); }
    void spindle(const Spindle& s, const BlockContext& at) override { next_->spindle(s, at); }
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
    void pass(Move m, const BlockContext& at);

    Sink* next_;
    const MachineView* view_;
    bool active_ = false, failed_ = false;
    unsigned x_ = 0, z_ = 1, failed_axis_ = 0;
    double failed_at_ = 0.0;
    double cosine_ = 1.0, tangent_ = 0.0, origin_ = 0.0;
};

}  // namespace polyturn::channels
