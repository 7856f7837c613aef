// How the run goes on behind this block: barriers, another place of the text, the end.
#include "channels/sinumerik/flow/run.hpp"

#include "channels/sinumerik/execution.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::sinumerik {

void keep_resume_states(Execution& x, bool on) {
    x.run.keeps_states = on;
    x.run.state_changed = true;
}
void finish(Execution& x, StopReason reason) {
    x.core.mark_emitted();
    x.core.sink().stop({reason}, x.core.at);
    x.run.ended = true;
}
// A live value may be read now? If not, the block stops here and is read again behind the barrier.
bool need_fresh(Execution& x) {
    if (x.run.fresh) return true;
    x.pass.needs_barrier = true;
    return false;
}
void seek(Execution& x, TextPosition to) {
    if (to.offset <= x.line.here.offset)
        x.run.fresh = false;  // a loop asks the machine anew each time
    x.calls.source->seek(to);
    x.run.jumped = true;
}
}  // namespace polyturn::channels::sinumerik
