// A thread in progress, or the retract from one.
//
//         all of it is known            the spindle turns          its end, or out of it and back
//   Empty ------------------> Committed ------------------> Moving -----------------------> Empty
//     '------------------ the way back to where its pass begins --^
#pragma once
#include <cstdint>
#include <memory>

#include "kernel/channel/thread_retract.hpp"
#include "kernel/motion/thread_follower.hpp"

namespace polyturn::kernel {

struct ThreadExecutor {
    enum class Stage : std::uint8_t { Empty, Committed, Moving };

    std::unique_ptr<ThreadFollower> follower;
    std::uint64_t end = 0;  // its last record
    ThreadRetract retract;
    Stage stage = Stage::Empty;

    bool moving() const noexcept { return stage == Stage::Moving; }
    bool committed() const noexcept { return stage != Stage::Empty; }
    void moves(bool now) noexcept { stage = now ? Stage::Moving : Stage::Empty; }
    void empty() noexcept { stage = Stage::Empty; }
};

}  // namespace polyturn::kernel
