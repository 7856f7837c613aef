// The path driven back and forth by the operator: retrace in a hold, and the handwheel that is the
// time base of the programs of a machine group (path/retrace_drive.hpp).
//
//        retrace on           start               wall, retrace off        start, its end
//   None -----------> Back -----------> (driven) -------------------> Forth ---------------> None
#pragma once
#include <cstdint>

#include "kernel/channel/trail.hpp"

namespace polyturn::kernel {

// A handwheel that is the time of the programs. blocked: it cannot go further back; reported: that
// has been said, and is not said again before the wheel has turned forwards.
struct ProgramWheel {
    bool on = false, blocked = false, reported = false;
    double rate = 0;  // -1 .. 1

    bool holds() const noexcept { return on && rate <= 0; }
    double share() const noexcept { return on ? rate : 1.0; }
};

struct Retrace {
    // What the next start does, as the operator has chosen.
    enum class Way : std::int8_t { Back = -1, None = 0, Forth = 1 };

    Trail trail;
    Way way = Way::None;
    bool on_trail = false;  // it moves there
    // from a wait at which it waited: it arrives there once more
    bool came_back = false;
    std::uint64_t meeting = 0;  // that released the wait which ends now
    ProgramWheel wheel;

    bool chosen() const noexcept { return trail.active() || way == Way::Back; }
    // What was driven until now is not driven back; what is being driven back is.
    void forget_driven() noexcept {
        if (!trail.active()) trail.clear();
    }
    void forget() noexcept {
        trail.clear();
        way = Way::None;
        on_trail = came_back = false;
        meeting = 0;
    }
    void set_wheel(bool turns, double rate) noexcept {
        wheel.on = turns;
        wheel.rate = turns ? rate : 0.0;
        if (!turns) wheel.blocked = false;
        if (wheel.on) way = Way::None;
    }
};

}  // namespace polyturn::kernel
