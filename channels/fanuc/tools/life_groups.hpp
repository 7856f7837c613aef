// G10 L3: tool life groups.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;

bool begin_life_groups(Execution& x);
bool life_group_block(Execution& x);

}  // namespace polyturn::channels::fanuc
