// Cutting speeds: SVC, SCC, GWPSON.
#pragma once
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/grammar/groups.hpp"

namespace polyturn::channels::sinumerik {

bool a_cutting_speed(Execution& x, const Word& word);
bool refresh_cutting_speeds(Execution& x);
bool p_wheel_speed(Execution& x, Call& c);
bool a_surface_axis(Execution& x, const Word& word);

// G96 G961 G962
inline bool surface_speed_active(const Execution& x) {
    return active(x, 15) == 4 || active(x, 15) == 7 || active(x, 15) == 11;
}

}  // namespace polyturn::channels::sinumerik
