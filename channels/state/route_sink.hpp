// Between Core and its sink while an address of the channel has the drive of another axis (composite control, nct part 2
// 22.4): positions of Core are those of the address, positions behind this sink are those of the drive.
//
//   address m  --mirrored (MCO): 2 z - m-->  true side  --opposite directions (MMI): negated-->  drive        z: workpiece zero
//
// Programmed numbers and the kind of an arc stay as the program has them; the sense in which the drives go round is theirs.
#pragma once
#include "channels/machine_view.hpp"
#include "channels/sink.hpp"

namespace polyturn::channels {

class RouteSink final : public Sink {
public:
    RouteSink(Sink& next, const MachineView& view) : next_(&next), view_(&view) {}

    void move(const Move& m, const BlockContext& at) override;
    void spindle(const Spindle& s, const BlockContext& at) override;
    void dwell(const Dwell& d, const BlockContext& at) override { next_->dwell(d, at); }
    void aux(const Aux& a, const BlockContext& at) override { next_->aux(a, at); }
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
    Sink* next_;
    const MachineView* view_;
    Move routed_;
};

}  // namespace polyturn::channels
