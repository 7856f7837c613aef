// Control structures: IF, WHILE, FOR, LOOP, REPEAT, and what ends a program.
#pragma once
namespace polyturn::channels::sinumerik {

struct Execution;
struct Structure;

const Structure* structure_needed(Execution& x);
bool condition(Execution& x, bool& holds);
bool st_if(Execution& x);
bool st_else(Execution& x);
bool st_end_marker(Execution& x);
bool st_while(Execution& x);
bool st_end_while(Execution& x);
bool st_execstring(Execution& x);
bool st_loop(Execution& x);
bool st_end_loop(Execution& x);
bool st_until(Execution& x);
bool st_for(Execution& x);
bool st_end_for(Execution& x);
bool st_return(Execution& x);

}  // namespace polyturn::channels::sinumerik
