// What a program tells operator, PLC and other channels: messages, alarms, markers, waits.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;
struct Value;

void tell_single_block(Execution& x);
bool p_single_block(Execution& x, Call&);
bool p_msg(Execution& x, Call& c);
bool p_wrtpr(Execution& x, Call& c);
bool p_setal(Execution& x, Call& c);
bool p_stopre(Execution& x, Call&);
bool p_master_holder(Execution& x, Call& c);
bool channel_of(Execution& x, const Value& value, unsigned& channel);
bool p_wait_marker(Execution& x, Call& c);
bool p_wait_end(Execution& x, Call& c);
bool p_set_marker(Execution& x, Call& c);
bool p_wait_axis(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
