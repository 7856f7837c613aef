// The order in which the words of a block act: that of GGroup.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;

// What the words say is done; false: a fault is noted. classify() and check_words() come before.
bool act_in_order(Execution& x);

}  // namespace polyturn::channels::fagor
