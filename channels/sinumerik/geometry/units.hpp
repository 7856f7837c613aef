// What lengths and feeds count in, and whether words are absolute.
#pragma once
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/grammar/groups.hpp"

namespace polyturn::channels::sinumerik {

inline bool metric_lengths(const Execution& x) { return active(x, 13) == 2 || active(x, 13) == 4; }
// mm in a programmed length
inline double unit(const Execution& x) { return metric_lengths(x) ? 1.0 : 25.4; }
// G700 and G710 say what feeds and other technology count in; under G70 and G71 that is the basic
// system (sinumerik_part1 9.3.5).
inline bool metric_technology(const Execution& x) {
    return active(x, 13) == 4 || (active(x, 13) != 3 && x.settings.metric_base);
}
inline double feed_unit(const Execution& x) { return metric_technology(x) ? 1.0 : 25.4; }
inline bool absolute(const Execution& x) { return active(x, 14) == 1; }

}  // namespace polyturn::channels::sinumerik
