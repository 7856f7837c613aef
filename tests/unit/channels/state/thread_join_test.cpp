// Threads in a row are one unless a stop is asked for between them; the strokes of a cycle's pass
// always are.
#include <gtest/gtest.h>

#include "channels/cycles/simple_cycles.hpp"
#include "core_rig.hpp"

namespace polyturn::channels::testing {
namespace {

struct Threader : CoreRig {
    Threader() {
        core->path.spindle.spindle = 1;
        core->path.spindle.rpm = 300;
        core->path.spindle.turn = SpindleTurn::Cw;
        core->start_at_machine(to(20, 5));
    }
    // Of the threads among the moves: does it go on from the one before, does it end with an exact
    // stop.
    std::vector<std::pair<bool, bool>> threads() const {
        std::vector<std::pair<bool, bool>> out;
        for (const Kept& kept : sink.moves())
            if (kept.move.kind == MoveKind::Thread)
                out.emplace_back(kept.move.thread_chained, kept.move.exact_stop);
        return out;
    }
};

using Joins = std::vector<std::pair<bool, bool>>;

TEST(ThreadJoin, AnExactStopBetweenTwoThreadsPartsThem) {
    for (const bool exact : {false, true}) {
        SCOPED_TRACE(exact);
        Threader rig;
        rig.core->path.exact_stop_mode = exact;
        ThreadCall call;
        call.lead = 2;
        ASSERT_TRUE(rig.core->thread(rig.to(20, -20), call));
        ASSERT_TRUE(rig.core->thread(rig.to(30, -40), call));
        EXPECT_EQ(rig.threads(), exact ? (Joins{{false, true}, {false, true}})
                                       : (Joins{{false, false}, {true, false}}));
    }
}

TEST(ThreadJoin, TheRunOutOfAPassIsJoinedUnderG61) {
    Threader rig;
    rig.core->path.exact_stop_mode = true;
    cycles::SimpleCycle cycle;
    cycle.end = rig.to(9, -20);
    cycle.thread.lead = 2;
    cycle.chamfer = 2;
    cycle.chamfer_angle = 45;
    ASSERT_TRUE(cycles::thread(*rig.core, cycle));
    EXPECT_EQ(rig.threads(), (Joins{{false, false}, {true, false}}));
    EXPECT_TRUE(rig.core->path.exact_stop_mode);
    EXPECT_TRUE(rig.sink.moves().back().move.exact_stop);
}

}  // namespace
}  // namespace polyturn::channels::testing
