// Behind compensation and corner elements: the plane of a frame that lies in none of the machine's
// planes (sinumerik ROT X, CUT2DF: part 2, 11.6, 13.5).
//
//   Core  outside -- plane^-1 -->  corners, compensation: inside, p q of the plane  -->  this sink:
//   plane(inside)  -> machine
//
// Inside, the plane's axes run where the program's do, in true millimetres; the tool and the zeros
// stay what they are, for only pos is turned: the rest of a machine coordinate is added as it was.
// An arc of the plane is none of the machine's and goes through its points, one move to whoever
// reads events.
//
// Invariant: axes_ is where the geometry axes are behind the last move; a move begins there.
#pragma once
#include "channels/forwarding_sink.hpp"
#include "channels/machine_view.hpp"
#include "channels/state/frame.hpp"

namespace polyturn::channels {

class InclinedSink final : public ForwardingSink {
public:
    InclinedSink(const MachineView& view, const std::array<int, 3>& geometry)
        : ForwardingSink(nullptr), view_(&view), geometry_(geometry) {}
    void open(Sink& next, const Frame& plane, const AxisValues& machine) {
        next_ = &next;
        plane_ = plane;
        inverse_ = plane.inverse();
        axes_ = machine;
    }
    void move(const Move& m, const BlockContext& at) override;

    // A point in the system of the zeros, and what is added to it on the way to the machine.
    AxisValues outside(const AxisValues& inside) const { return mapped(plane_, inside); }
    AxisValues inside(const AxisValues& outside) const { return mapped(inverse_, outside); }
    Point3 direction(const Point3& inside) const { return plane_.direction(inside); }
    const std::array<int, 3>& geometry() const { return geometry_; }

private:
    AxisValues mapped(const Frame& by, const AxisValues& values) const;
    void draw_arc(const Move& m, const AxisValues& added);

    const MachineView* view_;
    std::array<int, 3> geometry_;  // indices of X, Y, Z; none is missing
    Frame plane_, inverse_;        // rotation and shift only
    AxisValues axes_{};
    Move out_;
};

}  // namespace polyturn::channels
