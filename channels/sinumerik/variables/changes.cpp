// Changes of values that can be put back.
#include "channels/sinumerik/variables/changes.hpp"

#include "channels/sinumerik/execution.hpp"

namespace polyturn::channels::sinumerik {

void undo(Execution& x, std::function<void()> back) {
    if (x.pass.reads) x.changes.of_block.push_back(back);
    if (x.run.keeps_states) x.changes.of_run.emplace_back(x.run.serial, std::move(back));
}
}  // namespace polyturn::channels::sinumerik
