// Synchronized actions: programmed, kept, looked at between blocks, done.
#pragma once
#include <string_view>

namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool st_synchronized(Execution& x);
bool synchronized_actions(Execution& x);
bool p_cancel(Execution& x, Call& c);
bool p_lock(Execution& x, Call& c);
bool p_unlock(Execution& x, Call& c);
bool p_action_reset(Execution& x, Call& c);
bool p_delete_travel(Execution& x, Call&);
bool p_read_disable(Execution& x, Call& c);
bool p_cycle_steps(Execution& x, Call& c);
bool p_stop_reading_of(Execution& x, Call&);
bool only_in_action(Execution& x, std::string_view name);

}  // namespace polyturn::channels::sinumerik
