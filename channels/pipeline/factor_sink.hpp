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
// Factors that change while compensation or a corner still holds moves (G72 X.. behind G42): what
// was programmed before keeps the factors it had. From then on the axis stands at another number,
// and the path of what holds the moves must not jump: it gets every position shifted by the
// difference (`bias`), and here the difference is taken away again.
//
// Invariant: axes() is where the axes with a factor are behind the last move; a move begins
// there.
#pragma once
#include <vector>

#include "channels/forwarding_sink.hpp"
#include "channels/machine_view.hpp"

namespace polyturn::channels {

struct PathState;

class FactorSink final : public ForwardingSink {
public:
    FactorSink(const MachineView& view, const PathState& path)
        : ForwardingSink(nullptr), view_(&view), path_(&path) {}
    void next(Sink& next) { next_ = &next; }
    // real coordinates; nothing is held
    void start(const AxisValues& machine) {
        axes_ = machine;
        stages_.clear();
    }
    // From the block `serial` on; `was`: until then.
    void change(std::uint64_t serial, const AxisValues& was, const AxisValues& factor,
                const AxisValues& bias);
    bool changed() const { return !stages_.empty(); }
    AxisValues bias() const { return changed() ? stages_.back().bias : AxisValues{}; }
    void move(const Move& m, const BlockContext& at) override;

private:
    struct Stage {
        std::uint64_t serial = 0;  // of the first block that it holds for
        AxisValues factor{}, bias{};
    };
    void multiply(const Move& m, const BlockContext& at);
    void chords(const Move& m, const BlockContext& at);
    void deliver(const Move& m, double way, const BlockContext& at);

    const MachineView* view_;
    const PathState* path_;
    AxisValues axes_{};
    std::vector<Stage> stages_;           // empty: those of the path
    const AxisValues* factor_ = nullptr;  // of the move that is reported
    Move unbiased_, out_;
};

}  // namespace polyturn::channels
