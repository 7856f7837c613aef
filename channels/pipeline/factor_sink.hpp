// Behind compensation: the computed motion of some axes times a factor (fagor G72 X.., 8037 T part
// 1, 7.6).
//
//   Core, corners, compensation:  what is programmed      |  this sink:  pos * factor, feed along
//                                                         with it  -> machine
//
// The multiples count from the part's zero: pos of a move has them, and the rest of its machine
// coordinate (zero, tool) is not multiplied. A circle whose plane has two factors is no circle any
// more: it is driven in chords.
//
// Invariant: axes() is where the axes with a factor are behind the last move; a move begins
// there.
#pragma once
#include "channels/forwarding_sink.hpp"
#include "channels/machine_view.hpp"

namespace polyturn::channels {

struct PathState;

class FactorSink final : public ForwardingSink {
public:
    FactorSink(const MachineView& view, const PathState& path)
        : ForwardingSink(nullptr), view_(&view), path_(&path) {}
    void next(Sink& next) { next_ = &next; }
    void start(const AxisValues& machine) { axes_ = machine; }  // real coordinates
    void move(const Move& m, const BlockContext& at) override;

private:
    void chords(const Move& m, const BlockContext& at);
    void deliver(const Move& m, double way, const BlockContext& at);

    const MachineView* view_;
    const PathState* path_;
    AxisValues axes_{};
    Move out_;
};

}  // namespace polyturn::channels
