// What a cycle's length hangs on: the chain of stretches, each in one channel, that nobody waits
// in. Whatever becomes shorter there makes the cycle shorter, as far as the next chain behind it;
// whatever becomes shorter elsewhere only waits longer.
//
//   L1  ####M501####|....M505.|###
//   L2  ....M501|####|####M505##....
//       path: L1 to M501, L2 to M505, L1 to the end
//
// From the end backwards: as long as the channel has not waited, it is its own work; where it has
// waited, the channel that came last to the rendezvous is what it waited for.
#pragma once
#include <map>
#include <vector>

#include "hmi/machine/programs/dry_run.hpp"

namespace polyturn::hmi {

struct RunStretch {
    unsigned channel = 0;
    double from = 0, to = 0;
};
// In the order of time, without a gap from 0 to the end of the run.
std::vector<RunStretch> criticalPath(const std::map<unsigned, RunChannel>& channels);

}  // namespace polyturn::hmi
