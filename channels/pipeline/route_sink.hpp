// Between Core and its sink while an address of the channel has the drive of another axis
// (composite control, nct part 2 22.4): positions of Core are those of the address, positions
// behind this sink are those of the drive.
//
//   address m --mirrored (MCO): 2 z - m--> true side --opposite directions (MMI): negated--> drive
//
// z is the workpiece zero.
// Programmed numbers and the kind of an arc stay as the program has them; the sense in which the
// drives go round is theirs.
#pragma once
#include "channels/forwarding_sink.hpp"
#include "channels/machine_view.hpp"

namespace polyturn::channels {

class RouteSink final : public ForwardingSink {
public:
    RouteSink(Sink& next, const MachineView& view) : ForwardingSink(&next), view_(&view) {}

    void move(const Move& m, const BlockContext& at) override;
    void spindle(const Spindle& s, const BlockContext& at) override;

private:
    const MachineView* view_;
    Move routed_;
};

}  // namespace polyturn::channels
