// A box of machine coordinates that the tool may not enter, or may not leave. Axes without a limit
// are not bounded.
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels {

struct WorkZone {
    enum class Guard : std::uint8_t { Off, NoEntry, NoExit } guard = Guard::Off;
    AxisValues low{}, high{};  // X as a radius
    AxisSet has_low = 0, has_high = 0;

    bool limited() const { return (has_low | has_high) != 0; }
    // slack > 0: the box is larger by so much
    bool contains(const AxisValues& point, double slack) const;
    // the straight line passes its inside
    bool crossed_by(const AxisValues& from, const AxisValues& to) const;
};

// Does this move, whose points are those of the tool's tip, do what the zone forbids?
bool violates(const WorkZone& zone, const Move& move);

}  // namespace polyturn::channels
